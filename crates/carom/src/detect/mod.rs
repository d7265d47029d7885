//! Contact times: when a ball meets another ball or the table. One file per pair:
//! `detect/<a>_<b>.rs`; flying balls are in [`flight`], balls on a rail's top in [`rail_top`].

pub mod ball_ball;
pub mod ball_cushion;
pub mod ball_pocket;
pub mod ball_table;
mod edge;
pub mod flight;
pub mod rail_top;

//! When do a ball and something else meet? One file per pair: `detect/<a>_<b>.rs`; a flying ball has
//! [`flight`], one on a rail's top [`rail_top`].

pub mod ball_ball;
pub mod ball_cushion;
pub mod ball_pocket;
pub mod ball_table;
mod edge;
pub mod flight;
pub mod rail_top;

//! When do a ball and something else meet? One file per pair: `detect/<a>_<b>.rs`.

pub mod ball_ball;
pub mod ball_cushion;
pub mod ball_pocket;
pub mod ball_table;

//! Collisions and strikes: every model compared with its paper, its laws, measurements and
//! pooltool.

mod ball_ball_laws;
mod ball_ball_mathavan_2014;
mod ball_ball_measured;
mod ball_ball_models;
mod ball_ball_network;
mod ball_ball_pooltool;
mod ball_ball_published;
#[cfg(feature = "json")]
mod ball_cushion_pooltool;
mod ball_cushion_properties;
mod ball_cushion_published;
mod ball_edge;
mod ball_slate;
mod cue_strike_frame;
mod cue_strike_published;
mod near;
mod random;

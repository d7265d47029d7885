//! A shot: everything that is decided before it starts. Immutable.

use alloc::string::String;
use alloc::sync::Arc;
use alloc::vec::Vec;

use crate::resolve::cue_ball::Strike;
use crate::{Ball, BallState, Physics, Table};

/// A ball placed on the table.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedBall {
    /// Unique name.
    pub id: String,
    /// Mass and radius.
    pub ball: Ball,
    /// State at time 0, in the file's frame (origin at the bottom left corner).
    pub state: BallState,
}

/// A validated shot.
#[derive(Clone, Debug, PartialEq)]
pub struct Shot {
    /// The table.
    pub table: Arc<Table>,
    /// The physics.
    pub physics: Arc<Physics>,
    /// The balls, in the order of the file.
    pub balls: Vec<PlacedBall>,
    /// The struck ball's index and the strike, if there is one.
    pub strike: Option<(usize, Strike)>,
    /// More events than this are an error.
    pub max_events: u32,
}

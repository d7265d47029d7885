//! A ball's way, cut at its events: one closed-form path after the other.

use alloc::vec::Vec;

use super::Trace;
use crate::BallState;
use crate::motion::Path;

/// What a ball does from one of its events to its next, in the file's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// When it starts, s since the strike.
    pub start: f64,
    /// When it ends, s: at the ball's next event, or when its motion does; infinite if never.
    pub end: f64,
    /// The ball's state at the start.
    pub state: BallState,
    /// The path from there; its times are counted from `start`.
    pub path: Path,
}

impl Trace {
    /// Everything that ball `ball` (an index into the shot's balls) does, in order.
    pub fn pieces(&self, ball: usize) -> Vec<Piece> {
        let placed = &self.shot.balls[ball];
        let physics = &*self.shot.physics;
        let piece = |start, state: BallState| {
            let path = Path::new(&state, &placed.ball, &physics.cloth, physics.gravity);
            Piece { start, end: start + path.duration, state, path }
        };
        let mut pieces: Vec<Piece> = Vec::from([piece(0.0, placed.state)]);
        for event in self.events() {
            let Some(k) = event.balls.iter().position(|&i| usize::from(i) == ball) else {
                continue;
            };
            if let Some(last) = pieces.last_mut() {
                last.end = event.time;
            }
            pieces.push(piece(event.time, event.after[k]));
        }
        pieces
    }
}

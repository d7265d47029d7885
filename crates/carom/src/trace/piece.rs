//! A ball's path, cut at its events into closed-form pieces.

use alloc::vec::Vec;

use super::Trace;
use crate::BallState;
use crate::motion::Path;

/// The motion of a ball from one of its events to the next, in the file's coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Start of the motion, s since the strike.
    pub start: f64,
    /// End, s since the strike: the ball's next event, the end of its motion, or the end of a trace
    /// that is cut off; infinite if it never ends.
    pub end: f64,
    /// The ball's state at the start.
    pub state: BallState,
    /// The path from there; its times are counted from `start`.
    pub path: Path,
}

impl Trace {
    /// The motion of ball `ball` (an index into the shot's balls), in order.
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
        if let Some(last) = pieces.last_mut() {
            last.end = last.end.min(self.horizon());
        }
        pieces
    }
}

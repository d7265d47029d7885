//! What a referee needs to know of a shot, collected while it is simulated.

mod collect;
mod frozen;
mod jump;
mod track;

use alloc::vec::Vec;

pub use collect::{Collector, OutcomeRecorder};

pub use crate::shot::Touched;

use crate::table::{PocketName, Rail};

/// What nobody sees, m: 0.1 mm, a sheet of paper. A frozen ball has not left its rail before it is so
/// far from it, and a ball is not said to have jumped another that it would have passed by less.
const SEEN: f64 = 1e-4;

/// Whether `ball` is one of `balls`. Not `contains`: LLVM 22 stops at what that becomes for WebAssembly
/// with simd128 ("cannot select v16i8 setcc").
#[expect(clippy::manual_contains, reason = "see above; the lists are short")]
fn among(balls: &[u16], ball: u16) -> bool {
    balls.iter().any(|&b| b == ball)
}

/// What happened in a shot, as rules ask for it. Balls are indices into the shot's balls.
///
/// The cue ball is the struck ball; without a strike, the ball with the id `cue`; else there is
/// none, and what speaks of it stays empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcome {
    /// The cue ball.
    pub cue_ball: Option<u16>,
    /// The first ball that the cue ball touched.
    pub first_contact: Option<u16>,
    /// Balls in the order in which they fell, with their pockets.
    pub pocketed: Vec<(u16, PocketName)>,
    /// Balls that left the table, in the order in which they did.
    pub off_table: Vec<u16>,
    /// Balls that hang over the edge of a pocket's hole when the shot is over: at rest on the bed, their
    /// centre nearer to the edge than their radius.
    pub hanging: Vec<(u16, PocketName)>,
    /// Which ball flew over which: in the air, above it, and at least 0.1 mm closer in plan than where
    /// they would touch on the cloth, without touching it from take-off to the end of the flight. In
    /// the order of the flights' ends.
    pub jumped: Vec<(u16, u16)>,
    /// Every touch of a ball with a cushion (nose, point or facing) after the first contact, in order;
    /// after the first collision of any two balls where there is no cue ball.
    pub rails_after_first_contact: Vec<(u16, Rail)>,
    /// Balls driven to a rail at any time in the shot, in the order in which they were (WPA, Rules of
    /// Play, definition of "driven to a rail"): they touched a cushion (nose, point or facing) without
    /// having touched that rail all the time. A ball frozen to a rail at the start, even if it is
    /// pressed into it, is driven to that rail only when it has been 0.1 mm away and comes back. Balls
    /// pocketed or off the table, which the rules count as well, are listed elsewhere.
    pub driven_to_rail: Vec<u16>,
    /// What the cue ball touched, in order. Of the balls in a many-ball contact those that it met itself,
    /// the nearest first.
    pub cue_ball_touched: Vec<Touched>,
    /// Balls that never come to rest, because friction is zero.
    pub never_resting: Vec<u16>,
    /// Number of events.
    pub events: u32,
}

impl Outcome {
    /// Whether the cue ball was pocketed.
    pub fn cue_ball_scratched(&self) -> bool {
        self.cue_ball.is_some_and(|cue| self.pocketed.iter().any(|(ball, _)| *ball == cue))
    }

    /// Cushions that the cue ball touched before its first contact.
    pub fn rails_before_first_contact(&self) -> impl Iterator<Item = Rail> + '_ {
        self.cue_ball_touched.iter().map_while(|t| match t {
            Touched::Rail(rail) => Some(*rail),
            Touched::Ball(_) => None,
        })
    }
}

//! The outcome of a shot: the facts that rules need, collected while it is simulated.

mod collect;
mod frozen;
mod jump;
mod track;

use alloc::vec::Vec;

pub use collect::{Collector, OutcomeMemory, OutcomeRecorder};

pub use crate::shot::Touched;

use crate::table::{PocketName, Rail};

/// Smallest distance that a player can see, m: 0.1 mm, the thickness of a sheet of paper. A frozen
/// ball has left its rail once it is further than this from it. A ball jumps another only if they
/// overlap in plan by more than this.
const VISIBLE_GAP: f64 = 1e-4;

/// Whether `ball` is one of `balls`. `contains` does not compile for WebAssembly with simd128: LLVM
/// 22 fails with "cannot select v16i8 setcc".
#[expect(clippy::manual_contains, reason = "see above; the lists are short")]
fn among(balls: &[u16], ball: u16) -> bool {
    balls.iter().any(|&b| b == ball)
}

/// The facts of a shot that rules need. Balls are indices into the shot's balls.
///
/// The cue ball is the struck ball; without a strike, the ball with the id `cue`. Otherwise there
/// is no cue ball, and the fields about it stay empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcome {
    /// The cue ball.
    pub cue_ball: Option<u16>,
    /// The first ball that the cue ball touched.
    pub first_contact: Option<u16>,
    /// The pocketed balls in the order in which they fell, with their pockets.
    pub pocketed: Vec<(u16, PocketName)>,
    /// Balls that left the table, in the order in which they left it.
    pub off_table: Vec<u16>,
    /// Balls that hang over the edge of a pocket's hole at the end: at rest on the bed, with the
    /// centre nearer to the edge than the radius.
    pub hanging: Vec<(u16, PocketName)>,
    /// Pairs of a ball and another that it jumped, in the order in which the flights end. The ball
    /// was in the air above the other one, at least 0.1 mm closer in plan than balls that touch on
    /// the cloth, and did not touch it from take-off to the end of the flight.
    pub jumped: Vec<(u16, u16)>,
    /// Every contact of a ball with a cushion (nose, point or facing) after the first contact of
    /// the cue ball, in order; without a cue ball, after the first collision of any two balls.
    pub rails_after_first_contact: Vec<(u16, Rail)>,
    /// Balls driven to a rail at any time in the shot, in order (WPA, Rules of Play, definition of
    /// "driven to a rail"): they touched a cushion (nose, point or facing) of a rail to which they
    /// were not frozen. A ball that is frozen to a rail at the start, and even one that is pressed
    /// into it, is driven to that rail only if it moves more than 0.1 mm away and comes back. The
    /// rules also count balls that are pocketed or leave the table; those are listed elsewhere.
    pub driven_to_rail: Vec<u16>,
    /// The balls and rails that the cue ball touched, in order. In a many-ball contact these are
    /// the balls that it touched itself, the nearest first.
    pub cue_ball_touched: Vec<Touched>,
    /// How often the tip met the cue ball: more than once in a double hit; 0 without a strike.
    pub tip_contacts: u8,
    /// Whether the cue ball met a ball that it did not touch before, while the tip was still on it.
    pub pushed: bool,
    /// The balls that the cue ball met during the strike, in the order in which it met them. They
    /// touched it at the start, or lay so near that it met them while the tip was on it or just
    /// after.
    pub met_during_strike: Vec<u16>,
    /// Balls that move at the end and never come to rest, because friction is zero.
    pub never_resting: Vec<u16>,
    /// Number of events.
    pub events: u32,
}

impl Outcome {
    /// Empties the outcome for another shot, whose cue ball is `cue_ball`. The memory of the lists
    /// stays.
    fn restart(&mut self, cue_ball: Option<u16>) {
        // Without `..`, so that a new field is not forgotten here.
        let Self {
            cue_ball: own_cue_ball,
            first_contact,
            pocketed,
            off_table,
            hanging,
            jumped,
            rails_after_first_contact,
            driven_to_rail,
            cue_ball_touched,
            tip_contacts,
            pushed,
            met_during_strike,
            never_resting,
            events,
        } = self;
        (*own_cue_ball, *first_contact) = (cue_ball, None);
        (*tip_contacts, *pushed, *events) = (0, false, 0);
        pocketed.clear();
        off_table.clear();
        hanging.clear();
        jumped.clear();
        rails_after_first_contact.clear();
        driven_to_rail.clear();
        cue_ball_touched.clear();
        met_during_strike.clear();
        never_resting.clear();
    }

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

//! The search for the best plays of a shot, under the errors of the player.
//!
//! A decision may simulate N shots. A share of them ([`crate::SearchSettings`]) states the chances of the best
//! plays; the rounds have the rest, R. Each round finds candidates without errors, and races them with errors.
//!
//! ```text
//! Searcher::search ── what is asked (task), and the places of a cue ball in hand (hand)
//!   │
//!   ▼ FIRST ROUND: S simulations                                                           (rounds)
//!   │   S = 300, × 3 in hand or with push-outs, × 5 for an opening or in carom games; at least R/10, up to 2000
//!   │
//!   ├─ opening shot only: a known break and its variants, or a search of breaks   (openings, break_search)
//!   ├─ explore: 0.6 S
//!   │    pots       0.75 of it: a lattice of strikes on each line to a pocket           (pots, crate::line)
//!   │    safeties   the rest of it, unless a pot is worth 0.97                                   (safeties)
//!   │    caroms     all of it, in carom games                                                      (caroms)
//!   │    push-outs  300 more where they are allowed; any shot at all: 600 more if nothing was found
//!   ├─ select: the best 48, or S/24 if that is more                                                  (select)
//!   ├─ race: the rest of S. All are played with the same errors, the worse half drops out   (race, even_errors)
//!   │    replies    their share of S, by default 0: the shot after the finalists                  (replies)
//!   └─ doubt fouls: 15 % of what was spent, beside R, once a decision, if the best play is often a foul (fouls)
//!   │
//!   ▼ the best 16
//!   │
//!   ▼ FURTHER ROUNDS: 1.6 times as many simulations as the one before, until R or the clock is over
//!   │
//!   ├─ shift: the best 4 are moved uphill by their own samples, without simulations                 (shift)
//!   ├─ explore: 0.6 S. The strikes that pot a ball are moved to the middle of their window          (windows)
//!   │    untried    0.3 of it: lines that had no simulations so far
//!   │    near       0.3 of the rest: neighbours of the best plays                                  (refine)
//!   │    further    0.15 of the rest, 0.45 for a list: any speed and spin on the lines of pots
//!   │    hits       what is left: a ball on is hit anywhere, with any speed and spin
//!   ├─ select: the best of the new ones, S/40 but at least 16
//!   └─ race, replies and doubts as before
//!   │
//!   ▼ END: fresh samples of the stated plays. A list is named before                               (naming)
//!          Plays that promise more than one of the list get fresh samples too                      (listing)
//! ```
//!
//! [`PotList`] lists the pots of a position alone. [`ShotSearch`] has a method for each step. The methods of `Explorer` that find candidates get their budget as an
//! argument. [`Candidate`] is a play with what is known about it. [`Racks`] and [`BreakSearch`] compare breaks over
//! many racks.

mod break_search;
mod candidate;
mod caroms;
mod even_errors;
mod explore;
mod fouls;
mod hand;
mod listing;
mod naming;
mod openings;
mod pot_list;
mod pots;
mod race;
mod racks;
mod refine;
mod replies;
mod rounds;
mod safeties;
mod select;
mod shift;
mod strike_errors;
mod task;
mod windows;

pub use break_search::BreakSearch;
pub use candidate::{Candidate, PlayKind, PlayedLeg, PlayedVariant};
pub(crate) use explore::{CuePlace, Explorer, cue_places, raised};
pub use pot_list::{PotList, PotPlay};
pub use racks::Racks;
pub(crate) use rounds::Found;
pub use rounds::{Rounds, ShotSearch};
pub(crate) use strike_errors::largest_offset;
pub(crate) use task::{SearchTask, ShotTask};

//! The search: candidate plays from lines and lattices, a race between them, and a second look at
//! the finalists. In place of the race there may be a tree.

mod break_search;
mod candidate;
mod caroms;
mod even_errors;
mod explore;
mod fouls;
mod hand;
mod naming;
mod openings;
mod pots;
mod race;
mod racks;
mod refine;
mod replies;
mod rounds;
mod safeties;
mod shift;
mod windows;

pub use break_search::BreakSearch;
pub use candidate::{Candidate, PlayKind, PlayedLeg, PlayedVariant};
pub(crate) use explore::Explorer;
pub use racks::Racks;
pub use rounds::Rounds;
pub(crate) use rounds::{Found, SearchTask};

//! Players: programs that answer the requests of a frame.
//!
//! A [`Player`] gets a [`Situation`] (the frame and the errors of both players) and a [`Budget`]
//! of simulations, and returns a [`Decision`]. A decision depends only on these, on the player's
//! own settings and on the seed: it has the same bits for any number of threads and on every
//! platform. A clock may end the search after any round; the decision tells the number of rounds,
//! and a budget of that many rounds repeats it.

mod aim;
mod analysis;
pub mod breaks;
mod level;
pub mod line;
pub mod literature;
mod player;
pub mod scene;
pub mod search;
mod searcher;
mod settings;
pub mod targets;
pub mod value;
mod workbench;

pub use analysis::{Analysis, Recommendation};
pub use level::{LEVELS, Level};
pub use player::{Answer, Budget, Decision, Player, Situation, Spent};
pub use searcher::Searcher;
pub use settings::{BreakChoice, SearchSettings};

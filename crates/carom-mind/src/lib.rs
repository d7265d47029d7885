//! Players: programs that answer the requests of a frame.
//!
//! A [`Player`] gets a [`Situation`] (the frame and the errors of both players) and a [`Budget`]
//! of simulations, and returns a [`Decision`]. A decision depends only on these, on the player's
//! own settings and on the seed: it has the same bits for any number of threads and on every
//! platform. A clock may end the search after any round; the decision tells the number of rounds,
//! and a budget of that many rounds repeats it.

mod player;

pub use player::{Answer, Budget, Decision, Player, Situation, Spent};

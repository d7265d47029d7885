//! Environments for learners: shots, rules, noise and reward, many at once on all cores.
//!
//! A [`VectorEnv`] is a row of independent environments of one [`Task`]. Every step plays one shot of the
//! agent in each of them (and the opponent's reply, if there is one) and gives observations, rewards and
//! which episodes have ended, as arrays.
//!
//! # The same bits
//!
//! What happens in an environment is a function of its seed, the number of its episode and the actions;
//! not of the other environments, the number of threads, or the machine. Environment `i` of a vector
//! that is seeded with `s` is the same as a single one that is seeded with `s + i`.
//!
//! # Nothing hangs
//!
//! A shot whose simulation reaches its cap on events, or that cannot be played at all, ends its episode as
//! truncated, with [`Rewards::failure`]. A frame in which nobody gets on ends by its rules
//! ([`carom_rules::Options::patience`]).

mod action;
mod config;
mod environment;
mod frame;
mod notes;
mod observe;
mod opponent;
mod place;
mod potting;
mod random;
mod scene;
mod sum_to_three;
mod vector;

pub use action::{ACTIONS, ACTIONS_WITHOUT_HAND, Aim};
pub use config::{Autoreset, Config, Rewards, Target, Task};
pub use observe::{BALL_FEATURES, FEATURES, POSITION_BOUND, SCORE_BOUND};
pub use opponent::Opponent;
pub use sum_to_three::CUSHIONS;
pub use vector::{Transitions, VectorEnv};

//! Environments for learners: shots, rules, noise and reward, many at once on all cores.
//!
//! A [`VectorEnv`] is a row of independent environments of one [`Task`]. Every step plays one shot of the
//! agent in each of them (and the opponent's reply, if there is one) and gives observations, rewards and
//! which episodes have ended, as arrays.
//!
//! ```
//! use carom::Noise;
//! use carom_env::{Aim, Config, Task, VectorEnv};
//!
//! # fn main() -> Result<(), carom::Error> {
//! let task = Task::read("potting")?;
//! let config = Config { noise: Noise::olympiad(1.0), aim: Aim::Relative, ..Config::of(task) };
//! let mut tables = VectorEnv::new(task, 64, 0, config)?; // their seeds are 0 to 63
//! let seen = tables.reset(None, None)?;
//! assert_eq!(seen.len(), 64 * tables.observation_size());
//! let full_on_the_ball = vec![0.0; 64 * tables.action_size()];
//! let step = tables.step(&full_on_the_ball)?;
//! assert!(step.terminated.iter().all(|&ended| ended)); // potting is one shot
//! println!("{} pots", step.rewards.iter().sum::<f64>());
//! # Ok(())
//! # }
//! ```
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

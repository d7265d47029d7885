//! Environments for reinforcement learning: shots, rules, noise and rewards, many at once on all
//! cores.
//!
//! A [`VectorEnv`] is a vector of independent environments of one [`Task`]. Each step plays one
//! shot of the agent in every environment (and the reply of the opponent, if there is one) and
//! returns observations, rewards and the ends of episodes as arrays.
//!
//! ```
//! use carom::Noise;
//! use carom_env::{Aim, Config, Task, VectorEnv};
//!
//! # fn main() -> Result<(), carom::Error> {
//! let task = Task::read("potting")?;
//! let config = Config { noise: Noise::olympiad(1.0), aim: Aim::Relative, ..Config::of(task) };
//! let mut envs = VectorEnv::new(task, 64, 0, config)?; // their seeds are 0 to 63
//! let seen = envs.reset(None, None)?;
//! assert_eq!(seen.len(), 64 * envs.observation_size());
//! let full_on_the_ball = vec![0.0; 64 * envs.action_size()];
//! let step = envs.step(&full_on_the_ball)?;
//! assert!(step.terminated.iter().all(|&ended| ended)); // potting is one shot
//! println!("{} pots", step.rewards.iter().sum::<f64>());
//! # Ok(())
//! # }
//! ```
//!
//! The opponent can be any built-in player of [`carom_arena::BuiltInPlayer`], by its name
//! ([`Opponent::read`]). It decides on the thread that steps its environment. [`ArenaOpponents`] are
//! players with a clock, such as external programs, for [`VectorEnv::step_against`].
//!
//! # The same bits
//!
//! The results in an environment depend only on its seed, the number of its episode and the
//! actions; not on the other environments, the number of threads, or the machine. Environment `i`
//! of a vector with seed `s` is the same as a single environment with seed `s + i`.
//!
//! # Every episode can end
//!
//! A shot whose simulation reaches the limit of events, or that cannot be played at all, ends its
//! episode as truncated, with the reward [`Rewards::failure`]. A frame without progress ends by its
//! rules ([`carom_rules::Options::patience`]).
//!
//! Files import downwards only: random, names, task_recorder ← setup, modes, task ← config ← episode,
//! bare_table, observe, placement ← action ← opponent; frame, potting, sum_to_three, worker ←
//! environment, saved ← vector ← arena_opponents.

mod action;
mod arena_opponents;
mod bare_table;
mod config;
mod environment;
mod episode;
mod frame;
mod modes;
mod names;
mod observe;
mod opponent;
mod placement;
mod potting;
mod random;
mod saved;
mod setup;
mod sum_to_three;
mod task;
mod task_recorder;
mod vector;
mod worker;

pub use action::{ACTIONS, ACTIONS_WITHOUT_HAND};
pub use arena_opponents::{ArenaOpponents, IsStopped, MOST_ARENA_OPPONENTS, MakePlayer};
pub use config::{Config, Rewards};
pub use environment::Reply;
pub use episode::EpisodeStart;
pub use modes::{AgentSeat, Aim, Autoreset, OPPONENT_SIMULATIONS, Opponent, Outside, TargetBall};
pub use observe::{BALL_FEATURES, FEATURES, POSITION_BOUND, SCORE_BOUND};
pub use setup::{Setup, Variable, VariableLaw};
pub use sum_to_three::CUSHIONS;
pub use task::Task;
pub use vector::{Answers, Asked, MAX_ENVIRONMENTS, Transitions, VectorEnv};

//! Matches between players: referee, clocks, execution noise, records and statistics.
//!
//! A [`Match`] has [`MatchSettings`] and two players. Its frames come in pairs: both frames of a
//! pair have the same rack and the same streams of errors, and the players exchange their seats.
//!
//! - [`ArenaFrame`] is one frame as a state machine, without threads, files or clocks of its own:
//!   [`ArenaFrame::next`] gives the next request, [`ArenaFrame::answer`] takes the answer.
//! - [`play_match`] plays the pairs of a [`MatchPlan`] on all cores. A folder holds what was played,
//!   so that an interrupted match goes on where it stopped, to the same bytes.
//! - [`MatchPlayer`] is who answers: a built-in player, or a program of one's own.
//! - [`BuiltInPlayer`] makes a player from its name, such as `carom:2000`.
//! - [`MatchScore`], [`PairScores`] and [`SequentialTest`] are the statistics.
//! - [`RecordedMatch`] reads a record for viewers, frame by frame.
//! - [`replay()`] plays a record, `carom-match/1`, again and compares every bit.
//!
//! ```
//! use std::sync::Arc;
//!
//! use carom::{Error, Noise};
//! use carom_arena::{ArenaFrame, Clock, Match, MatchSettings, NextStep, PlayerEntry, Secret};
//! use carom_mind::{Answer, Decision, Spent};
//! use carom_rules::{FrameSimulator, Game};
//!
//! # fn main() -> Result<(), Error> {
//! let settings = MatchSettings {
//!     noise: [Noise::olympiad(1.0), Noise::olympiad(1.0)],
//!     clock: [Clock::simulations(2000); 2],
//!     ..MatchSettings::new(Game::NineBall)
//! };
//! let players = [PlayerEntry::new("one"), PlayerEntry::new("other")];
//! let of = Arc::new(Match::new(settings, players)?);
//! let (secret, mut simulator) = (Secret::new([7; 32]), FrameSimulator::new());
//! let mut frame = ArenaFrame::begin(of, 0, secret.pair_seeds(0), &mut simulator)?;
//! while let NextStep::Ask(ask) = frame.next() {
//!     println!("player {} may simulate {} shots", ask.player, ask.simulations());
//!     let spent = Spent::default();
//!     let decision = Decision { answer: Answer::Concede, win_chance: None, spent };
//!     frame.answer(&mut simulator, &decision, 0.0)?;
//! }
//! assert_eq!(frame.points(), Some(0.0)); // player 0 has conceded
//! # Ok(())
//! # }
//! ```
//!
//! All seeds derive from the [`Secret`] of the match. Its hash is published before the match, and
//! the secret after it. docs/arena.md describes settings, records and statistics.

mod arena_frame;
mod built_in;
mod check;
mod clock;
mod decisions;
mod error;
mod hold;
mod ledger;
mod luck;
mod match_player;
mod moves;
mod open_match;
mod pair;
#[cfg(all(feature = "programs", target_os = "linux"))]
mod program;
mod protocol;
mod record;
mod recorded_match;
mod replay;
mod score;
mod secret;
mod sequential;
mod settings;
mod sight;
mod thinking_time;
mod tournament;

pub use arena_frame::{
    ArenaFrame, Ask, LastShot, Loss, NextStep, REFUSALS, SeatAccount, check_answer,
};
pub use built_in::{BuiltInPlayer, MOST_PLANNED};
pub use check::{CheckSettings, CheckVerdict, check, check_situations};
pub use clock::{Clock, ClockPeriod, ClockUnit, Cost, expected_shots};
pub use error::ArenaError;
pub use ledger::RECORD;
pub use luck::{LuckSettings, LuckValue, ShotLuck};
pub use match_player::{MatchPlayer, Response, ask_player};
pub use moves::{ArenaMove, Effect, EndReason, Execution, FrameEnd};
pub use open_match::{MatchReport, OpenMatch};
pub use pair::{MatchPlan, PlayedPair, play_frame, play_pair};
#[cfg(all(feature = "programs", target_os = "linux"))]
pub use program::{
    Confinement, ErrorLog, LogKeeper, MOST_PENDING_LINES, ProgramChannel, ProgramCommand,
    ProgramLimits, ProgramOrder, ProgramPlayer, ProgramSite, StopCheck, SupervisorCommand,
    supervise,
};
pub use protocol::{
    ARENA_SCHEMA, ChannelFault, Greeting, LONGEST_LINE, LineChannel, PROTOCOL, ProtocolPlayer,
    ProtocolSettings,
};
pub use record::{MATCH_FORMAT, MatchHeader};
pub use recorded_match::RecordedMatch;
pub use replay::{RecordDifference, Replay, measure_luck, positions, replay};
pub use score::{
    AdjustedPairs, AdjustedShare, FramePoints, MatchScore, PairScores, elo_of_share, share_of_elo,
};
pub use secret::{PairSeeds, Secret};
pub use sequential::{Hypothesis, SequentialTest, TestState, TestUnit};
pub use settings::{Breaker, Disclosure, Match, MatchSettings, PlayerEntry, PlayerIndex};
pub use thinking_time::{ThinkingTime, TimeLimit};
pub use tournament::play_match;

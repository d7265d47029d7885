//! External programs as players: they are started, confined, asked by lines of text, and ended.
//!
//! - [`ProgramCommand`] is a command line, `exec:COMMAND ARGUMENTS`, taken apart as a shell does.
//! - [`ProgramChannel`] runs the program and exchanges lines with it. Every wait has a deadline.
//! - [`ProgramPlayer`] is the program as a player of a match.
//! - [`supervise`] is the main function of the supervisor, a small process beside every program.
//! - [`ProgramLimits`] and [`Confinement`] are what is enforced, and where the system allows it a control
//!   group; docs/arena-security.md says what is not promised.
//!
//! A program may start other programs, and these may leave its session and its process group. Linux
//! knows one thing that they cannot leave: when a process ends, its children pass to the nearest
//! ancestor that is a *child subreaper*. The supervisor is one. So all descendants of the program
//! stay below the supervisor, and it can stop and end all of them. It ends them also when the
//! referee is killed, because its socket to the referee is then closed.
//!
//! The supervisor must be a process of its own: the referee may be a part of any program, whose other
//! children it must not adopt. It runs no code between `fork` and `exec`, so this needs no unsafe
//! code: it sets limits for itself, and the program inherits them.

mod channel;
mod command;
mod confinement;
mod control_group;
mod error_log;
mod limits;
mod order;
mod player;
mod process_tree;
mod supervisor;

pub use channel::{LogKeeper, MOST_PENDING_LINES, ProgramChannel, StopCheck, SupervisorCommand};
pub use command::ProgramCommand;
pub use confinement::Confinement;
pub use error_log::ErrorLog;
pub use limits::ProgramLimits;
pub use order::ProgramOrder;
pub use player::{ProgramPlayer, ProgramSite};
pub use supervisor::supervise;

//! The protocol `carom-arena/1` between a referee and a program: JSON, one object on each line.
//!
//! [`ProtocolPlayer`] is the program as a player of a match, at the other end of a [`LineChannel`]. It
//! writes a request for each [`crate::Ask`] and reads the answer. docs/arena-protocol.md describes the
//! messages for authors of programs.

mod channel;
mod greeting;
mod menu;
mod messages;
mod player;
mod plays;
mod reply;
mod text;

pub use channel::{ChannelFault, LONGEST_LINE, LineChannel};
pub use greeting::{Greeting, PROTOCOL};
#[cfg(all(feature = "programs", target_os = "linux"))]
pub(crate) use menu::MOST_PLAYS;
pub use player::{ProtocolPlayer, ProtocolSettings};
pub(crate) use plays::play_node;

/// The JSON Schema of the messages, `carom-arena/1`.
pub const ARENA_SCHEMA: &str = include_str!("../../schemas/carom-arena-1.json");

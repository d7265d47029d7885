//! The protocol `carom-arena/1` between a referee and a program: JSON, one value on each line.
//!
//! docs/arena-protocol.md describes it for authors of programs.

mod channel;

pub use channel::{ChannelFault, LineChannel};

//! The engine for C: conversions, no logic. The header is `include/carom.h`, which a test writes from
//! this crate; its text is the documentation of the functions here.
//!
//! A function takes references for the pointers of C, so null is `None`, and a `Box` for an object that
//! it takes over. Every body is one call of [`entry::enter`], which turns errors and panics into the
//! value that stands for a failure.

#![expect(non_camel_case_types, reason = "types have their names in C")]
#![expect(clippy::missing_safety_doc, reason = "the head of the header has the rules of pointers")]

pub mod batch;
pub mod entry;
pub mod event;
pub mod frame;
pub mod frame_state;
pub mod kinds;
pub mod play;
pub mod player;
pub mod shot;
pub mod sim;
pub mod state;
pub mod table;
pub mod text;
pub mod trace;
pub mod version;

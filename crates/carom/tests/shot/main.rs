//! Shots as files: what is read and written, what is refused and how; and the racks.
#![cfg(feature = "json")]

mod examples;
mod lossless;
mod obstruction;
mod rack_rules;
mod refusals;
mod schema;

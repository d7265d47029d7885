//! Shots as files: what is read and written, what is refused and how; and the racks.
#![cfg(feature = "json")]

mod defaults;
mod examples;
mod in_the_air;
mod lossless;
mod obstruction;
mod rack_rules;
mod ranges;
mod refusals;
mod schema;

//! Shots as files: reading, writing and errors; and the racks.
#![cfg(feature = "json")]

mod default_elevation;
mod defaults;
mod examples;
mod in_the_air;
mod lossless;
mod obstruction;
mod rack_rules;
mod ranges;
mod reference;
mod refusals;
mod repair;
mod schema;

//! File formats: reading and writing shots, tables, physics, traces and outcomes.
//!
//! A [`Node`] is a tree of plain values, as a JSON text or a Python dictionary holds it. The
//! readers turn trees into validated data and name the place of everything that they refuse;
//! numbers are written so that they read back to the same bits. A [`ShotFile`] also keeps the tree
//! that it was read from, and writes it again unchanged.

mod angle;
mod balls;
mod cling;
mod dated;
mod file_kind;
mod geometry;
#[cfg(feature = "json")]
mod json;
mod key_path;
mod marks;
mod node;
mod outcome;
mod parameters;
mod parts;
mod physics;
mod physics_number;
mod read;
pub mod schema;
mod shot;
mod strike;
mod table;
mod trace;
mod track;

pub use dated::{with_dated_names, with_value_dated};
pub use key_path::KeyPath;
pub use marks::{MOST_MARKS, MarkColor, MarkShape, TableMark};
pub use node::Node;
pub use parameters::{Parameter, coefficient_at, parameters, physics_list};
pub use parts::{check_balls, check_physics, check_table};
pub use physics_number::PhysicsNumber;
pub use read::Reader;
pub use shot::{DefaultElevation, PresetNames, SHOT_FORMAT, ShotFile, repaired};
pub use trace::TRACE_FORMAT;
pub use track::{FilmedBall, MOST_SAMPLES};

//! The judge's own table: figures of rule books and other publications, and the noses, points,
//! facings, holes and liners that it constructs from them. Nothing here uses the engine's geometry
//! or the figures of its presets, so that an error in either of them is found.
//!
//! Figures that are not published (the radii of holes and points, the jaws of some tables)
//! are taken from the shot; [`rule_books`] lists the published ones.

#[cfg(test)]
mod compared;
mod edge;
mod figures;
mod jaw;
mod plan;
mod rule_books;

pub(crate) use edge::{EdgeKind, EdgeLine};
pub(crate) use plan::{Hole, RailPlan, TablePlan};

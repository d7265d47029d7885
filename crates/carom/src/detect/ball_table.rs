//! The first meeting of a ball with a cushion or a pocket.

use carom_roots::Motion;

use crate::table::Table;

/// What a ball meets first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableFeature {
    /// Index into `Table::cushions`.
    Cushion(u16),
    /// Index into `Table::pockets`.
    Pocket(u8),
}

/// First feature of `table` that a ball of radius `radius` (m) on the cloth meets on the path
/// d + v t + h t² (centre, in the table's frame) within [0, `horizon`], and when.
pub fn first_meeting(
    table: &Table,
    radius: f64,
    path: &Motion<2>,
    horizon: f64,
) -> Option<(f64, TableFeature)> {
    let _ = (table, radius, path, horizon);
    None
}

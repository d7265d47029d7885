//! The markings of a table that the rules refer to: spots, head string and D.

use carom::Table;
use carom::math::Vec2;
use carom::rack::snooker_spots;

/// Distance between two places, m.
pub(crate) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    Vec2::new(b[0] - a[0], b[1] - a[1]).length()
}

/// The spot called `name`. On a table without that spot: the point on the long string at `fraction`
/// of the table's length.
pub(crate) fn spot_named(table: &Table, name: &str, fraction: f64) -> [f64; 2] {
    let spots = table.description.as_ref().map_or(&[][..], |d| &d.markings.spots);
    let marked = spots.iter().find(|s| s.name == name).map(|s| s.position);
    marked.unwrap_or([0.5 * table.size.x, fraction * table.size.y])
}

/// y of the head string (in snooker: of the baulk line), m.
pub(crate) fn head_string(table: &Table) -> f64 {
    let marked = table.description.as_ref().and_then(|d| d.markings.head_string);
    marked.unwrap_or(0.25 * table.size.y)
}

/// The D: its centre, which is the brown's spot on the baulk line (file coordinates, m), and its
/// radius, m. On a table without a marked radius it reaches from the brown to the yellow.
pub(crate) fn the_d(table: &Table) -> ([f64; 2], f64) {
    let [[yellow, _], _, brown, ..] = snooker_spots(table);
    let marked = table.description.as_ref().and_then(|d| d.markings.d_radius);
    (brown, marked.unwrap_or(yellow - brown[0]))
}

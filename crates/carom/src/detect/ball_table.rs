//! The first meeting of a ball with a cushion or a pocket.
//!
//! Inside the playing area shrunk by the ball's reach there is nothing to meet, and the shrunk
//! rectangle is convex. So the time at which the path first leaves it, four scalar quadratics, is
//! either the contact with a straight nose, or, in a pocket's mouth, the time from which on the parts of
//! that mouth matter.

use carom_roots::{Motion, first_crossing};

use super::ball_cushion::{self, JOIN_OVERLAP};
use super::ball_pocket;
use crate::math::Vec2;
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
///
/// A cushion is met when the ball touches it and approaches, a pocket when it captures the ball
/// ([`ball_cushion`], [`ball_pocket`]). `horizon` may be infinite.
pub fn first_meeting(
    table: &Table,
    radius: f64,
    path: &Motion<2>,
    horizon: f64,
) -> Option<(f64, TableFeature)> {
    let layout = &table.layout;
    let reach = table.reach(radius);
    let inner = Vec2::new(layout.half.x - reach, layout.half.y - reach);
    if stays_inside(inner.x, path.d[0], path.v[0], path.h[0], horizon)
        && stays_inside(inner.y, path.d[1], path.v[1], path.h[1], horizon)
        && !(reach < layout.clear_reach)
    {
        return None;
    }
    let start = Vec2::new(path.d[0], path.d[1]);
    let starts_in_mouth = !layout.mouths.is_empty()
        && ((start.x.abs() > inner.x && !on_long_nose(table, start.y))
            || (start.y.abs() > inner.y && !on_short_nose(table, start.x)));
    if starts_in_mouth || reach < layout.clear_reach {
        return among_all(table, reach, path, horizon);
    }
    let across = exit(inner.x, path.d[0], path.v[0], path.h[0], horizon);
    let up_to = across.map_or(horizon, |(t, _)| t);
    let (t, rail) = match exit(inner.y, path.d[1], path.v[1], path.h[1], up_to) {
        // A tie, in the corner of a plain rectangle, goes to the long rail.
        Some((t, positive)) if across.is_none_or(|(x, _)| t < x) => {
            let x = path.d[0] + t * (path.v[0] + t * path.h[0]);
            (t, on_short_nose(table, x).then_some(usize::from(positive)))
        }
        _ => {
            let (t, positive) = across?;
            let y = path.d[1] + t * (path.v[1] + t * path.h[1]);
            let place = 2 + 2 * usize::from(positive) + usize::from(y > 0.0);
            (t, on_long_nose(table, y).then_some(place))
        }
    };
    match rail {
        Some(place) => Some((t, TableFeature::Cushion(layout.noses[place]))),
        None => among_all(table, reach, path, horizon),
    }
}

/// Whether one coordinate provably keeps within ±`limit` over [0, `horizon`].
#[inline(always)]
fn stays_inside(limit: f64, d: f64, v: f64, h: f64, horizon: f64) -> bool {
    // Compares false when 0·∞ makes a NaN: then nothing is proved.
    d.abs() + horizon * (v.abs() + horizon * h.abs()) < limit
}

/// When a coordinate first leaves ±`limit` outwards, and whether on the positive side.
#[inline(always)]
fn exit(limit: f64, d: f64, v: f64, h: f64, horizon: f64) -> Option<(f64, bool)> {
    let positive = first_crossing(limit - d, -v, -h, horizon);
    let negative = first_crossing(limit + d, v, h, positive.unwrap_or(horizon));
    match negative {
        Some(t) => Some((t, false)),
        None => positive.map(|t| (t, true)),
    }
}

/// Whether the nose of a short rail is at abscissa `x`.
#[inline(always)]
fn on_short_nose(table: &Table, x: f64) -> bool {
    x.abs() <= table.layout.nose_x + JOIN_OVERLAP
}

/// Whether the nose of a long rail is at ordinate `y`.
#[inline(always)]
fn on_long_nose(table: &Table, y: f64) -> bool {
    let [from, to] = table.layout.nose_y;
    let y = y.abs();
    y >= from - JOIN_OVERLAP && y <= to + JOIN_OVERLAP
}

/// The first meeting among all parts and pockets.
fn among_all(
    table: &Table,
    reach: f64,
    path: &Motion<2>,
    horizon: f64,
) -> Option<(f64, TableFeature)> {
    let mut first: Option<(f64, TableFeature)> = None;
    let mut until = horizon;
    for (i, cushion) in table.cushions.iter().enumerate() {
        if let Some(t) = ball_cushion::first_touch(&cushion.shape, reach, path, until)
            && first.is_none_or(|(earliest, _)| t < earliest)
        {
            first = Some((t, TableFeature::Cushion(i as u16)));
            until = t;
        }
    }
    for (i, (pocket, mouth)) in table.pockets.iter().zip(&table.layout.mouths).enumerate() {
        if let Some(t) = ball_pocket::first_capture(pocket, &mouth.gate, reach, path, until)
            && first.is_none_or(|(earliest, _)| t < earliest)
        {
            first = Some((t, TableFeature::Pocket(i as u8)));
            until = t;
        }
    }
    first
}

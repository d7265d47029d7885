//! First contact of a ball on the cloth with the table: cushions and pockets.
//!
//! Within the playing area, shrunk by the ball's reach on all sides, a ball meets nothing, and this
//! rectangle is convex. The time at which the path first leaves it follows from four scalar
//! quadratics. It is either the contact with a straight nose or the time at which the ball enters a
//! pocket's mouth; from then on the parts of that mouth are searched.

use carom_roots::{Motion, first_crossing};

use super::ball_cushion;
use super::ball_pocket;
use crate::math::Vec2;
use crate::table::{
    Capture, CushionPart, Gate, JOIN_OVERLAP, Pocket, Shape, TableFeature, TableGeometry,
};

/// First feature of `table` that a ball on the cloth meets, and when. Its radius is `radius` (m);
/// its centre moves on d + v t + h t² (in the table's coordinates) within [0, `horizon`] (s, may be
/// infinite).
///
/// A ball meets a cushion when it touches it and approaches, and a pocket when the pocket captures
/// it ([`ball_cushion`], [`ball_pocket`]).
#[inline(always)]
pub fn first_meeting(
    table: &TableGeometry,
    radius: f64,
    path: &Motion<2>,
    horizon: f64,
) -> Option<(f64, TableFeature)> {
    let [d, v, h] = [path.d, path.v, path.h].map(|[x, y]| Vec2::new(x, y));
    meeting(table, radius, d, v, h, horizon)
}

/// The path is passed by value: a vector load of scalars stored just before would stall on
/// store-to-load forwarding.
fn meeting(
    table: &TableGeometry,
    radius: f64,
    d: Vec2,
    v: Vec2,
    h: Vec2,
    horizon: f64,
) -> Option<(f64, TableFeature)> {
    let path = &Motion { d: [d.x, d.y], v: [v.x, v.y], h: [h.x, h.y] };
    let geometry = &table.index;
    let reach = table.reach(radius);
    let inner = Vec2::new(geometry.half.x - reach, geometry.half.y - reach);
    if reach < geometry.clear_reach {
        let clear = keeps_clear(table, geometry.clear_reach, path, horizon);
        return if clear { None } else { before_gates(table, reach, inner, path, horizon) };
    }
    if keeps_clear(table, reach, path, horizon) {
        return None;
    }
    if starts_in_mouth(table, inner, path) {
        return in_mouth(table, reach, path, 0.0, horizon);
    }
    match exit_from(table, inner, path, horizon)? {
        (t, Some(nose)) => Some((t, TableFeature::Cushion(nose))),
        (t, None) => in_mouth(table, reach, path, t, horizon),
    }
}

/// The first meeting on a table where gates or holes lie in the playing area shrunk by the reach:
/// lines from tip to tip, whose corner pockets cut off the corners of this area.
///
/// A path that provably stays before all gates until it leaves the area meets nothing but the nose
/// that it comes to there. All other paths are searched among all parts.
fn before_gates(
    table: &TableGeometry,
    reach: f64,
    inner: Vec2,
    path: &Motion<2>,
    horizon: f64,
) -> Option<(f64, TableFeature)> {
    let all = || among_all(table, reach, path, horizon);
    let has_gates_only =
        table.pockets.iter().all(|p| matches!(p.capture, Capture::MouthLine { .. }));
    if !has_gates_only || starts_in_mouth(table, inner, path) {
        return all();
    }
    let exit = exit_from(table, inner, path, horizon);
    let window = Window::new(path, 0.0, exit.map_or(horizon, |(t, _)| t));
    let stays_before = table
        .pockets
        .iter()
        .zip(&table.index.mouths)
        .all(|(pocket, mouth)| window.is_clear_of_gate(pocket, &mouth.gate, reach));
    match exit {
        _ if !stays_before => all(),
        None => None,
        // Near the end of a nose another part may be met first.
        Some((t, Some(nose))) if is_well_within(&table.cushions[usize::from(nose)], path.at(t)) => {
            // The time of the search among all parts, to the bit.
            let shape = &table.cushions[usize::from(nose)].shape;
            let touch = ball_cushion::first_touch(shape, reach, path, horizon);
            touch.map_or_else(all, |t| Some((t, TableFeature::Cushion(nose))))
        }
        Some(_) => all(),
    }
}

/// Whether a path begins outside the playing area shrunk by the reach (`inner`, half its size) and
/// not before a nose.
#[inline(always)]
fn starts_in_mouth(table: &TableGeometry, inner: Vec2, path: &Motion<2>) -> bool {
    let start = Vec2::new(path.d[0], path.d[1]);
    !table.index.mouths.is_empty()
        && ((start.x.abs() > inner.x && !on_long_nose(table, start.y))
            || (start.y.abs() > inner.y && !on_short_nose(table, start.x)))
}

/// When a path leaves the playing area shrunk by the reach (`inner`, half its size), and the index
/// of the nose there; `None` for a mouth.
#[inline(always)]
fn exit_from(
    table: &TableGeometry,
    inner: Vec2,
    path: &Motion<2>,
    horizon: f64,
) -> Option<(f64, Option<u16>)> {
    let across = exit(inner.x, path.d[0], path.v[0], path.h[0], horizon);
    let up_to = across.map_or(horizon, |(t, _)| t);
    let (t, place) = match exit(inner.y, path.d[1], path.v[1], path.h[1], up_to) {
        // Both at once, in the corner of a plain rectangle: the long rail comes first.
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
    Some((t, place.map(|place| table.index.noses[place])))
}

/// Whether `p` (m) is beside a straight part, at least [`WELL_WITHIN`] from both ends.
fn is_well_within(part: &CushionPart, p: [f64; 2]) -> bool {
    let Shape::Segment { start, end, normal } = part.shape else { return false };
    let tangent = normal.perp();
    let [a, b, s] = [start, end, Vec2::new(p[0], p[1])].map(|q| tangent.dot(q));
    s > a.min(b) + WELL_WITHIN && s < a.max(b) - WELL_WITHIN
}

/// Whether a path provably stays in the playing area shrunk by `reach` (m) over [0, `horizon`],
/// where a ball meets nothing.
#[inline(always)]
pub fn keeps_clear(table: &TableGeometry, reach: f64, path: &Motion<2>, horizon: f64) -> bool {
    let half = table.index.half;
    stays_inside(half.x - reach, path.d[0], path.v[0], path.h[0], horizon)
        && stays_inside(half.y - reach, path.d[1], path.v[1], path.h[1], horizon)
}

/// Whether a coordinate provably stays within ±`limit` over [0, `horizon`].
#[inline(always)]
fn stays_inside(limit: f64, d: f64, v: f64, h: f64, horizon: f64) -> bool {
    // If 0·∞ makes a NaN, the comparison is false and nothing is proved.
    d.abs() + horizon * (v.abs() + horizon * h.abs()) < limit
}

/// A coordinate counts as moving in one direction only if its speed backwards, at the horizon, is
/// at most this fraction of its initial speed. Rounding causes such a speed when a ball rolls until
/// it is at rest. The ball moves back by less than the rounding error of a position.
const NO_TURN: f64 = 1e-12;

/// Distance of a contact from the ends of a nose, and of a path from a gate, m, within which all
/// parts are searched: far more than the rounding errors, and than [`JOIN_OVERLAP`].
const WELL_WITHIN: f64 = 1e-6;

/// A coordinate that ends at least this far inside its limit has not reached it, m: ten thousand
/// rounding errors.
const SHORT_OF_LIMIT: f64 = 1e-12;

/// The first time at which a coordinate leaves ±`limit`, and whether it does so on the positive
/// side.
#[inline(always)]
fn exit(limit: f64, d: f64, v: f64, h: f64, horizon: f64) -> Option<(f64, bool)> {
    // Most coordinates move in one direction only and can leave on that side only.
    let speed = v.abs();
    let side = if v > 0.0 { 1.0 } else { -1.0 };
    let change = side * h * horizon;
    if speed + 2.0 * change >= -NO_TURN * speed && speed > 0.0 {
        if side * d + (speed + change) * horizon < limit - SHORT_OF_LIMIT {
            return None;
        }
        let t = first_crossing(limit - side * d, -speed, -(side * h), horizon);
        return t.map(|t| (t, v > 0.0));
    }
    let positive = first_crossing(limit - d, -v, -h, horizon);
    let negative = first_crossing(limit + d, v, h, positive.unwrap_or(horizon));
    match negative {
        Some(t) => Some((t, false)),
        None => positive.map(|t| (t, true)),
    }
}

/// Whether the nose of a short rail is at abscissa `x`, or no pocket is beside it.
#[inline(always)]
fn on_short_nose(table: &TableGeometry, x: f64) -> bool {
    x.abs() <= table.index.nose_x + JOIN_OVERLAP || table.index.mouths.is_empty()
}

/// Whether the nose of a long rail is at ordinate `y`, or no pocket is beside it.
#[inline(always)]
fn on_long_nose(table: &TableGeometry, y: f64) -> bool {
    let [from, to] = table.index.nose_y;
    let beside = y.abs();
    (beside >= from - JOIN_OVERLAP && beside <= to + JOIN_OVERLAP) || table.index.mouths.is_empty()
}

/// First contact of a ball that is in a pocket's mouth at `from`, s, and has met nothing before.
///
/// While the ball stays in that pocket's quarter (or, for a side pocket, middle) of the table, it
/// can meet only that pocket's parts. A path that leaves this region is searched among all parts.
fn in_mouth(
    table: &TableGeometry,
    reach: f64,
    path: &Motion<2>,
    from: f64,
    horizon: f64,
) -> Option<(f64, TableFeature)> {
    let geometry = &table.index;
    let [x, y] = path.at(from);
    let at_side = y.abs() < geometry.nose_y[0];
    let right = usize::from(x > 0.0);
    let index = if at_side { 2 + right } else { right + if y > 0.0 { 4 } else { 0 } };
    let (pocket, mouth) = (&table.pockets[index], &geometry.mouths[index]);

    // The gate comes first: it is cheap and ends the window in which the other parts matter. The
    // hole comes last: a contact with a jaw before it often rules it out. All use the same horizon,
    // so that a mirrored path, which meets the jaws in the opposite order, has the same bits.
    let through = ball_pocket::through_gate(pocket, &mouth.gate, reach, path, horizon);
    let last = through.unwrap_or(horizon);
    let mut window = Window::new(path, from, last);
    let mut first = through.map(|t| (t, TableFeature::Pocket(index as u8)));
    for &part in &mouth.parts {
        let shape = &table.cushions[usize::from(part)].shape;
        if window.is_clear_of(shape, reach) {
            continue;
        }
        if let Some(t) = ball_cushion::first_touch(shape, reach, path, last)
            && first.is_none_or(|(earliest, _)| t < earliest)
        {
            first = Some((t, TableFeature::Cushion(part)));
            window = Window::new(path, from, t);
        }
    }
    if !window.is_clear_of_disc(pocket.center, pocket.radius)
        && let Some(t) = ball_pocket::over_hole(pocket, path, last)
        && first.is_none_or(|(earliest, _)| t < earliest)
    {
        first = Some((t, TableFeature::Pocket(index as u8)));
        window = Window::new(path, from, t);
    }
    // The far ends of the two neighbouring noses bound the region in which this pocket is the only
    // one.
    let (outwards, upwards) = (if x > 0.0 { 1.0 } else { -1.0 }, if y > 0.0 { 1.0 } else { -1.0 });
    let alone = if at_side {
        window.least(Vec2::new(outwards, 0.0)) > 0.0
            && window.least(Vec2::new(0.0, 1.0)) > -geometry.nose_y[1]
            && window.least(Vec2::new(0.0, -1.0)) > -geometry.nose_y[1]
    } else {
        window.least(Vec2::new(outwards, 0.0)) > -geometry.nose_x
            && window.least(Vec2::new(0.0, upwards)) > geometry.nose_y[0]
    };
    if alone { first } else { among_all(table, reach, path, horizon) }
}

/// A section of a path with bounds: it stays within `sag` of the chord between its ends.
struct Window {
    from: Vec2,
    to: Vec2,
    /// ¼Δt² of the half acceleration: the largest distance of the parabola from its chord, m.
    sag: Vec2,
}

impl Window {
    fn new(path: &Motion<2>, from: f64, until: f64) -> Self {
        let vec = |[x, y]: [f64; 2]| Vec2::new(x, y);
        let dt = until - from;
        Self {
            from: vec(path.at(from)),
            to: vec(path.at(until)),
            sag: vec(path.h) * (0.25 * dt * dt),
        }
    }

    /// A lower bound of the coordinate along the unit vector `axis`, m. NaN for an infinite path,
    /// so that every comparison with it is false.
    fn least(&self, axis: Vec2) -> f64 {
        let (a, b) = (axis.dot(self.from), axis.dot(self.to));
        (if a < b { a } else { b }) - axis.dot(self.sag).abs()
    }

    /// Whether a ball with this `reach` (m) provably does not touch `shape`.
    fn is_clear_of(&self, shape: &Shape, reach: f64) -> bool {
        match *shape {
            Shape::Segment { start, normal, .. } => self.least(normal) - normal.dot(start) > reach,
            Shape::Arc { center, radius, .. } => self.is_clear_of_disc(center, radius + reach),
            Shape::Hollow { .. } | Shape::Plane { .. } => true,
        }
    }

    /// Whether the centre of a ball with this `reach` (m) provably stays before a gate.
    fn is_clear_of_gate(&self, pocket: &Pocket, gate: &Gate, reach: f64) -> bool {
        self.least(-pocket.axis) > WELL_WITHIN - (gate.offset + gate.lean * reach)
    }

    /// Whether the path provably stays further than `distance` (m) from `center`: it passes at one
    /// side, or stays apart along the line from `center` to the path's end.
    fn is_clear_of_disc(&self, center: Vec2, distance: f64) -> bool {
        let distance = distance + self.sag.x.abs() + self.sag.y.abs();
        let squared = distance * distance;
        let chord = self.to - self.from;
        let beside = chord.cross(center - self.from);
        if beside * beside > squared * chord.length_squared() {
            return true;
        }
        let to = self.to - center;
        let (end, begin) = (to.length_squared(), to.dot(self.from - center));
        end > squared && begin > 0.0 && begin * begin > squared * end
    }
}

/// The first contact among all parts and pockets.
fn among_all(
    table: &TableGeometry,
    reach: f64,
    path: &Motion<2>,
    horizon: f64,
) -> Option<(f64, TableFeature)> {
    let mut first: Option<(f64, TableFeature)> = None;
    let mut window = Window::new(path, 0.0, horizon);
    for (i, cushion) in table.parts_on_cloth().iter().enumerate() {
        if window.is_clear_of(&cushion.shape, reach) {
            continue;
        }
        if let Some(t) = ball_cushion::first_touch(&cushion.shape, reach, path, horizon)
            && first.is_none_or(|(earliest, _)| t < earliest)
        {
            first = Some((t, TableFeature::Cushion(i as u16)));
            window = Window::new(path, 0.0, t);
        }
    }
    for (i, (pocket, mouth)) in table.pockets.iter().zip(&table.index.mouths).enumerate() {
        if window.is_clear_of_gate(pocket, &mouth.gate, reach)
            && window.is_clear_of_disc(pocket.center, pocket.radius)
        {
            continue;
        }
        if let Some(t) = ball_pocket::first_capture(pocket, &mouth.gate, reach, path, horizon)
            && first.is_none_or(|(earliest, _)| t < earliest)
        {
            first = Some((t, TableFeature::Pocket(i as u8)));
        }
    }
    first
}

#[cfg(test)]
mod tests {
    use carom_roots::Motion;
    use chacha20::ChaCha8Rng;
    use chacha20::rand_core::{Rng, SeedableRng};

    use super::{among_all, first_meeting};
    use crate::table::Table;

    #[test]
    fn a_path_before_the_gates_meets_what_the_search_among_all_parts_finds() {
        let table = Table::preset("poolfiz").expect("a preset");
        let (radius, half) = (0.028575, table.index.half);
        let mut random = ChaCha8Rng::seed_from_u64(1);
        let mut noses = 0;
        for _ in 0..50_000 {
            let mut between =
                |limit: f64| limit * (f64::from(random.next_u32()) / 2147483648.0 - 1.0);
            let d = [between(half.x - radius), between(half.y - radius)];
            let v = [between(3.0), between(3.0)];
            let h = [between(1.0), between(1.0)];
            let (path, horizon) = (Motion { d, v, h }, 1.0 + between(1.0));
            let found = first_meeting(&table, radius, &path, horizon);
            assert_eq!(found, among_all(&table, table.reach(radius), &path, horizon), "{path:?}");
            noses += usize::from(found.is_some());
        }
        assert!(noses > 20_000, "{noses}");
    }
}

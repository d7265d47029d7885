//! Capture of a ball on the cloth by a pocket.

use carom_roots::{Motion, first_contact, first_crossing};

use crate::math::Vec2;
use crate::table::{Capture, Gate, Pocket};

/// First time in [0, `horizon`] (s) at which `pocket` captures a ball of `reach` δ (m) on `path`.
///
/// Drop circle: the centre comes over the hole, or passes between the deep ends of the facings into
/// the space behind, which all belongs to the pocket. Mouth line: the centre crosses the line from
/// tip to tip outwards (Leckie & Greenspan 2006, section 2.2).
pub(crate) fn first_capture(
    pocket: &Pocket,
    gate: &Gate,
    reach: f64,
    path: &Motion<2>,
    horizon: f64,
) -> Option<f64> {
    let through = through_gate(pocket, gate, reach, path, horizon);
    over_hole(pocket, path, through.unwrap_or(horizon)).or(through)
}

/// First time in [0, `horizon`] at which the centre comes over the hole of a drop-circle pocket.
pub(crate) fn over_hole(pocket: &Pocket, path: &Motion<2>, horizon: f64) -> Option<f64> {
    match pocket.capture {
        Capture::DropCircle => {
            let mut from_center = *path;
            from_center.d = [path.d[0] - pocket.center.x, path.d[1] - pocket.center.y];
            first_contact(&from_center, pocket.radius, horizon)
        }
        Capture::MouthLine { .. } => None,
    }
}

/// First time in [0, `horizon`] at which the centre passes the gate outwards.
pub(crate) fn through_gate(
    pocket: &Pocket,
    gate: &Gate,
    reach: f64,
    path: &Motion<2>,
    horizon: f64,
) -> Option<f64> {
    let axis = pocket.axis;
    let along = |p: [f64; 2]| axis.dot(Vec2::new(p[0], p[1]));
    let before = gate.offset + gate.lean * reach - along(path.d);
    let t = first_crossing(before, -along(path.v), -along(path.h), horizon)?;
    let [x, y] = path.at(t);
    let beside = axis.cross(Vec2::new(x, y) - pocket.center).abs();
    (beside <= gate.half_width).then_some(t)
}

//! A ball on the cloth against a pocket.

use carom_roots::{Motion, first_contact, first_crossing};

use crate::math::Vec2;
use crate::table::{Capture, Gate, Pocket};

/// First time in [0, `horizon`] (s) at which `pocket` captures a ball of `reach` δ (m) on `path`.
///
/// Drop circle: the centre comes over the hole, or passes between the deep ends of the facings, behind
/// which there is only pocket. Mouth line: the centre crosses the line from tip to tip outwards (Leckie
/// & Greenspan 2006, section 2.2).
pub(crate) fn first_capture(
    pocket: &Pocket,
    gate: &Gate,
    reach: f64,
    path: &Motion<2>,
    horizon: f64,
) -> Option<f64> {
    let over_hole = match pocket.capture {
        Capture::DropCircle => {
            let mut from_center = *path;
            from_center.d = [path.d[0] - pocket.center.x, path.d[1] - pocket.center.y];
            first_contact(&from_center, pocket.radius, horizon)
        }
        Capture::MouthLine { .. } => None,
    };
    let through_gate = gate_crossing(pocket, gate, reach, path, over_hole.unwrap_or(horizon));
    through_gate.or(over_hole)
}

fn gate_crossing(
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

//! One jaw of a pocket, constructed in plan from the directions of its two lines.
//!
//! The nose line leaves the tip T along **u**, away from the pocket, and the facing leaves it along
//! **f** into the pocket; the rubber lies between them, and the angle is the cut angle γ. The point
//! is the circle of radius r in this angle that touches both lines: its centre lies on the
//! bisector, r/sin(γ/2) from T, and it touches the lines r/tan(γ/2) from T.

use carom::math::{Vec2, radians, sin_cos, sqrt};

use super::edge::{EdgeKind, EdgeLine, RailEnd};
use super::figures::PocketFigures;

/// The edges of a jaw.
#[derive(Clone, Debug)]
pub(super) struct JawPlan {
    /// The tip, where nose line and facing would meet, m.
    pub(super) tip: Vec2,
    /// Where the straight nose begins, m.
    pub(super) nose_end: Vec2,
    /// From the nose to the deep end.
    pub(super) edges: Vec<(EdgeKind, EdgeLine)>,
    /// The deep end and the line through it.
    pub(super) end: RailEnd,
}

/// The place of a jaw on its rail.
#[derive(Clone, Copy, Debug)]
pub(super) struct JawPlace {
    /// The corner, or the middle of a long rail, on the nose line, m.
    pub(super) middle: Vec2,
    /// Unit vector along the nose line, away from the pocket.
    pub(super) along: Vec2,
    /// Unit vector into the rubber.
    pub(super) behind: Vec2,
    /// Whether the pocket is at a corner.
    pub(super) at_corner: bool,
    /// Number of the pocket.
    pub(super) pocket: usize,
}

fn unit(v: Vec2) -> Vec2 {
    v * (1.0 / v.length())
}

/// The jaw of a pocket with these figures, in a cushion of this width, m.
pub(super) fn jaw(figures: &PocketFigures, cushion_width: f64, place: &JawPlace) -> JawPlan {
    let JawPlace { middle, along, behind, at_corner, pocket } = *place;
    // The tips of a corner pocket span a right-angled triangle with the corner.
    let to_tip = if at_corner { figures.mouth / sqrt(2.0) } else { figures.mouth / 2.0 };
    let tip = middle + along * to_tip;
    let cut = radians(figures.cut_angle_deg);
    let (sin, cos) = sin_cos(cut);
    let (half_sin, half_cos) = sin_cos(0.5 * cut);
    let by_angle = along * cos + behind * sin;
    let radius = figures.point_radius;
    let touching = radius * half_cos / half_sin;
    let center = tip + (along * half_cos + behind * half_sin) * (radius / half_sin);
    let nose_end = tip + along * touching;
    let round = |end: Vec2| EdgeLine::Round { center, radius, from: -behind, to: end };

    if touching * sin >= cushion_width {
        // The cushion ends before the circle meets the facing.
        let rise = radius - cushion_width;
        let deep = center - along * sqrt(radius * radius - rise * rise) - behind * rise;
        let normal = (deep - center) * (1.0 / radius);
        let down = if normal.perp().dot(behind) > 0.0 { normal.perp() } else { -normal.perp() };
        let end = RailEnd { deep, along: down, normal, pocket };
        return JawPlan { tip, nose_end, edges: vec![(EdgeKind::Point, round(normal))], end };
    }
    let start = tip + by_angle * touching;
    let deep = match figures.throat {
        None => tip + by_angle * (cushion_width / sin),
        // The deep ends of a corner pocket are (a, −w) and (−w, a) along the two rails.
        Some(throat) if at_corner => {
            middle + along * (throat / sqrt(2.0) - cushion_width) + behind * cushion_width
        }
        Some(throat) => middle + along * (throat / 2.0) + behind * cushion_width,
    };
    let down = if figures.throat.is_some() { unit(deep - start) } else { by_angle };
    let towards_pocket = |line: Vec2| {
        let side = line.perp();
        if side.dot(along) < 0.0 { side } else { -side }
    };
    // The outward direction at the end of the circle is perpendicular to the line that it touches.
    let tangent = towards_pocket(by_angle);
    let normal = towards_pocket(down);
    let mut edges = vec![(EdgeKind::Point, round(tangent))];
    // Whether the facing turns farther than the circle, towards the rubber.
    let turned = by_angle.cross(down) * (-along).cross(behind);
    if figures.throat.is_some() && turned > 0.0 {
        let corner = EdgeLine::Round { center: start, radius: 0.0, from: tangent, to: normal };
        edges.push((EdgeKind::Point, corner));
    }
    edges.push((EdgeKind::Facing, EdgeLine::Straight { start, end: deep, normal }));
    JawPlan { tip, nose_end, edges, end: RailEnd { deep, along: down, normal, pocket } }
}

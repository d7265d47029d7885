//! What lies behind the jaws of a pocket, up to the outer edge of the rails.
//!
//! The liner closes a pocket. The line of each facing continues straight from its deep end to the
//! back of the hole's circle, and the far arc of that circle joins the two lines. So the edges of a
//! pocket enclose its opening. Everything else between the edge lines and the border is the flat
//! top of the rails:
//!
//! ```text
//!   ───────────╮            ╭───────────   noses and points
//!   rail top    ╲          ╱    rail top
//!                ╲ opening╱                facings, to the deep ends
//!                 ┊ ╭──╮ ┊                 then straight on
//!                  ┊    ┊   hole
//!                   ╰──╯                   the liner's wall, halved at the pocket's axis
//! ```
//!
//! With the mouth-line model there is no liner: the opening ends between the deep ends.

use super::jaw::{Jaw, RailFrame};
use super::{PocketDescription, Shape, TableError, check};
use crate::math::{Vec2, sqrt};

/// The liner behind one jaw of the quadrant x ≤ 0, y ≤ 0.
pub(super) struct Liner {
    /// The straight run from the deep end to the hole's circle: an edge like the facing's.
    pub(super) run: Shape,
    /// The round wall from there to the pocket's axis.
    pub(super) wall: Shape,
    /// A point on the jaw's line over the hole, at or behind the deep end, m. The straight line
    /// from it to its mirror image lies over the hole.
    pub(super) over_hole: Vec2,
    /// Whether a ball on the cloth can touch the run before its centre is over the hole.
    pub(super) exposed: bool,
}

impl Liner {
    /// Cosine of the angle between `axis` and the start of the round wall.
    pub(super) fn start_cosine(&self, axis: Vec2) -> f64 {
        match self.wall {
            Shape::Hollow { start, .. } => axis.dot(start),
            _ => 0.0,
        }
    }
}

/// The liner behind `jaw`, for a hole about `center` (m).
///
/// # Errors
/// [`TableError`] if the hole does not reach from facing to facing behind both deep ends, so that
/// the pocket would not be closed.
pub(super) fn liner(
    jaw: &Jaw,
    shape: &PocketDescription,
    center: Vec2,
    axis: Vec2,
) -> Result<Liner, TableError> {
    let radius = shape.hole_radius;
    let normal = jaw.facing_normal;
    let down = jaw.down;
    let from_deep = center - jaw.deep;
    // Foot of the perpendicular from the hole's centre to the jaw's line, and half the chord on
    // that line.
    let (across, foot) = (normal.dot(from_deep), down.dot(from_deep));
    let half_chord = sqrt((radius * radius - across * across).max(0.0));
    let length = foot + half_chord;
    let exit = jaw.deep + down * length;
    let from_center = exit - center;
    // The exit must lie on the same side of the axis as the jaw.
    let beside = axis.cross(jaw.deep - center) * axis.cross(from_center) > 0.0;
    check::liner(jaw.kind, across.abs() < radius, length > 0.0, across > 0.0 && beside)?;

    let at_axis = jaw.deep + normal * (axis.cross(from_deep) / axis.cross(normal));
    let covered = |p: Vec2| (p - center).length() < radius;
    let exposed = !(covered(jaw.deep) && covered(at_axis));
    Ok(Liner {
        run: Shape::Segment { start: jaw.deep, end: exit, normal },
        wall: Shape::Hollow {
            center,
            radius,
            start: from_center * (1.0 / from_center.length()),
            end: axis,
        },
        over_hole: if exposed && foot > 0.0 { jaw.deep + down * foot } else { jaw.deep },
        exposed,
    })
}

/// The openings of the quadrant x ≤ 0, y ≤ 0; the others are its mirror images.
#[derive(Clone, Debug, PartialEq)]
#[repr(C)]
pub(crate) struct Openings {
    /// Of the corner pocket: the jaws of the short and the long rail.
    corner: [JawLine; 2],
    corner_back: Back,
    /// Of the side pocket: its other jaw is the mirror image.
    side: [JawLine; 1],
    side_back: Back,
}

impl Openings {
    pub(super) fn new(
        [bottom, left, side]: [&Jaw; 3],
        [corner_back, side_back]: [Back; 2],
    ) -> Self {
        Self {
            corner: [JawLine::new(bottom), JawLine::new(left)],
            corner_back,
            side: [JawLine::new(side)],
            side_back,
        }
    }

    /// Whether `p`, in the quadrant and behind a nose line, is in the opening of the corner pocket,
    /// and whether it is in that of the side pocket, which begins behind the long rail.
    pub(super) fn contain(&self, p: Vec2) -> [bool; 2] {
        let within = |jaws: &[JawLine], back: &Back| {
            jaws.iter().all(|jaw| jaw.is_behind(p)) && back.is_behind(p)
        };
        let Self { corner, corner_back, side, side_back } = self;
        let behind_long_rail = side[0].depth(p) > 0.0;
        [within(corner, corner_back), behind_long_rail && within(side, side_back)]
    }
}

/// The back of an opening.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub(super) struct Back {
    /// Unit vector along the pocket's axis, away from the table.
    pub(super) axis: Vec2,
    /// Distance from the table's centre along the axis, m. The opening contains everything between
    /// the jaws up to here.
    pub(super) straight: f64,
    /// Centre of the disc that the opening contains too, m.
    pub(super) center: Vec2,
    /// Radius of that disc, m; 0 with the mouth-line model.
    pub(super) radius: f64,
}

impl Back {
    /// Whether the back lies behind `p`.
    fn is_behind(&self, p: Vec2) -> bool {
        self.axis.dot(p) < self.straight
            || (p - self.center).length_squared() < self.radius * self.radius
    }
}

/// The edge line of a jaw; its facing continues without end.
#[derive(Clone, Debug, PartialEq)]
#[repr(C)]
struct JawLine {
    rail: RailFrame,
    /// Where the nose begins along the rail, m.
    nose_start: f64,
    /// Radius of the point, m.
    point_radius: f64,
    /// Depth behind the nose line at which the point ends, m.
    point_end: f64,
    /// The deep end of the facing, m.
    deep: Vec2,
    /// Unit normal of the facing, towards the pocket's axis.
    normal: Vec2,
}

impl JawLine {
    fn new(jaw: &Jaw) -> Self {
        Self {
            rail: jaw.rail,
            nose_start: jaw.nose_start,
            point_radius: jaw.point_radius,
            point_end: jaw.point_end,
            deep: jaw.deep,
            normal: jaw.facing_normal,
        }
    }

    /// Depth of `p` behind the nose line, m.
    fn depth(&self, p: Vec2) -> f64 {
        self.rail.behind.dot(p - self.rail.origin)
    }

    /// Whether `p` is on the pocket's side of the jaw. The depth behind the nose line grows along
    /// the edge, so there is one edge point for each depth.
    fn is_behind(&self, p: Vec2) -> bool {
        let behind = self.depth(p);
        if behind <= 0.0 {
            return true;
        }
        if behind >= self.point_end {
            return self.normal.dot(p - self.deep) > 0.0;
        }
        let rise = self.point_radius - behind;
        let half_chord = sqrt(self.point_radius * self.point_radius - rise * rise);
        self.rail.along.dot(p - self.rail.origin) < self.nose_start - half_chord
    }
}

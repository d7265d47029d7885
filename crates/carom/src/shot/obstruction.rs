//! Balls and rails that obstruct the cue, and the elevation that clears them.
//!
//! The cue is a straight cone from the contact point backwards. Raising it rotates it about the
//! struck ball's centre, in the vertical plane through its axis, because the tip offset is measured
//! perpendicular to the cue. In that plane, an obstacle has the polar angle φ above the horizontal
//! and the distance ρ from that centre. With the cue at the elevation θ, the obstacle is ρ·sin(φ −
//! θ) above the line through the centre, and the axis is `height` ball radii above it. So the
//! interval of elevations that an obstacle blocks has a closed form. The thickness of the cue at
//! the obstacle is taken at the distance ρ from the ball's centre, which is right to 0.1 mm.
//!
//! * A ball blocks the cue if its distance from the axis is less than the sum of the two radii.
//! * The rails' tops are flat at the height of the nose. Over an edge of a top the cue's axis must
//!   be higher by its radius r in the plane. If the edge is oblique, at an angle ψ to the plane's
//!   normal, the side of the cue touches it first, and the axis must be higher by r√(cos²θ +
//!   sin²θ/cos²ψ). Over a pocket the top begins at the back of the hole.

use alloc::vec::Vec;

use crate::math::{Vec2, Vec3, asin, atan2, radians, sin_cos, sqrt};
use crate::resolve::cue_ball::Strike;
use crate::table::{Part, Rail, Shape, TOUCH_TOLERANCE, Table, arc_sides};

/// Length of a cue, m: 58 in, the usual length.
pub(super) const LENGTH: f64 = 1.47;
/// Radius at the tip, m: a diameter of 13 mm; the WPA allows 14 mm.
const TIP: f64 = 0.0065;
/// Radius at the butt, m: a diameter of 29 mm, the usual one.
const BUTT: f64 = 0.0145;

/// Elevation of the cue in a usual stance, rad (5°): a level cue would pass through the rail behind
/// it in nearly every shot. A cue at a lower elevation may be raised to this one.
const STANCE: f64 = 0.087_266_462_599_716_48;

/// Largest default elevation, rad (80°): a player hardly strikes from higher.
const STEEPEST_DEFAULT: f64 = radians(80.0);

/// Least step of the search for the least elevation, rad: less than 2 µm at the butt. The search
/// needs more than one step only for oblique edges, and then a few steps.
const RESOLUTION: f64 = 1e-6;

const UPRIGHT: f64 = core::f64::consts::FRAC_PI_2;

/// A ball or a rail that a cue ball, or a cue, touches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Touched {
    /// Another ball, by index.
    Ball(u16),
    /// A cushion of this rail.
    Rail(Rail),
}

/// A ball as an obstacle.
#[derive(Clone, Copy, Debug)]
pub struct BallInSpace {
    /// Its centre in the file's coordinates, m.
    pub center: Vec3,
    /// Its radius, m.
    pub radius: f64,
}

/// A possible obstacle, in the vertical plane of the cue, relative to the struck ball's centre.
#[derive(Clone, Copy, Debug)]
struct Obstacle {
    what: Touched,
    /// Distance, m.
    distance: f64,
    /// Polar angle above the horizontal, rad.
    polar: f64,
    shape: Section,
}

/// The distance that the cue's axis must keep from an obstacle.
#[derive(Clone, Copy, Debug)]
enum Section {
    /// `apart` to either side, m.
    Ball { apart: f64 },
    /// `above` it, m, for a level cue; `slant` is 1/cos²ψ.
    Edge { above: f64, slant: f64 },
}

impl Obstacle {
    /// Heights of the axis above the obstacle at `elevation`, m: the height that clears the
    /// obstacle, and the actual height.
    fn required_and_actual(&self, height: f64, elevation: f64) -> (f64, f64) {
        let (sin, _) = sin_cos(self.polar - elevation);
        let required = match self.shape {
            Section::Ball { apart } => apart,
            Section::Edge { above, slant } => {
                let (sin, cos) = sin_cos(elevation);
                above * sqrt(cos * cos + sin * sin * slant)
            }
        };
        (required, height - self.distance * sin)
    }

    /// Whether a cue whose axis passes `height` (m) above the ball's centre passes through the
    /// obstacle.
    fn blocks(&self, height: f64, elevation: f64) -> bool {
        let (required, actual) = self.required_and_actual(height, elevation);
        let behind = (self.polar - elevation).abs() < UPRIGHT;
        let passes_below =
            matches!(self.shape, Section::Ball { .. }) && actual <= -required + TOUCH_TOLERANCE;
        behind && actual < required - TOUCH_TOLERANCE && !passes_below
    }

    /// A lower bound of the elevations that clear the obstacle, which blocks the cue at
    /// `elevation`; `None` if no elevation clears it.
    fn cleared_from(&self, height: f64, elevation: f64) -> Option<f64> {
        let (required, _) = self.required_and_actual(height, elevation);
        let sin = (height - required) / self.distance;
        (sin >= -1.0).then(|| self.polar - asin(sin))
    }
}

/// The line of the cue to the struck ball, and all possible obstacles.
pub(super) struct CueLine {
    /// Height of the axis above the ball's centre, perpendicular to it, m.
    height: f64,
    /// Distance of the tip behind the ball's centre, m.
    tip: f64,
    obstacles: Vec<Obstacle>,
}

impl CueLine {
    /// The cue of `strike` on the ball `struck`, with the `others` by their indices. The elevation
    /// of `strike` is not used.
    pub(super) fn new(
        table: &Table,
        struck: BallInSpace,
        others: impl Iterator<Item = (u16, BallInSpace)>,
        strike: &Strike,
    ) -> Self {
        let radius = struck.radius;
        let (side, height) = (strike.side * radius, strike.height * radius);
        let tip = sqrt((radius * radius - side * side - height * height).max(0.0));
        let mut line = Self { height, tip, obstacles: Vec::new() };
        let origin = table.center();
        let in_engine_frame = |Vec3 { x, y, z }| Vec3::new(x - origin.x, y - origin.y, z);
        let center = in_engine_frame(struck.center);
        let (sin, cos) = sin_cos(strike.azimuth);
        let (back, right) = (Vec2::new(-cos, -sin), Vec2::new(sin, -cos));
        for (i, other) in others {
            let to = in_engine_frame(other.center) - center;
            let aside = right.dot(to.xy()) - side;
            line.add(Touched::Ball(i), back.dot(to.xy()), to.z, |thickness| {
                let apart = other.radius + thickness;
                let squared = apart * apart - aside * aside;
                (squared > 0.0).then(|| Section::Ball { apart: sqrt(squared) })
            });
        }
        let from = center.xy() + right * side;
        for edge in edges(table, from, back) {
            let slant = 1.0 / (edge.cos * edge.cos);
            let rise = table.cushion_height - center.z;
            line.add(Touched::Rail(edge.rail), edge.distance, rise, |thickness| {
                Some(Section::Edge { above: thickness, slant })
            });
        }
        line
    }

    /// Adds an obstacle `behind` the ball's centre and `above` it (m) if the cue is that long;
    /// `section` takes the cue's radius there, m.
    fn add(
        &mut self,
        what: Touched,
        behind: f64,
        above: f64,
        section: impl Fn(f64) -> Option<Section>,
    ) {
        let distance = sqrt(behind * behind + above * above);
        let along = ((distance - self.tip) / LENGTH).max(0.0);
        if along <= 1.0
            && let Some(shape) = section(TIP + (BUTT - TIP) * along)
        {
            let polar = atan2(above, behind);
            self.obstacles.push(Obstacle { what, distance, polar, shape });
        }
    }

    /// The least elevation, rad, not below `elevation`, at which nothing blocks the cue.
    fn least_from(&self, mut elevation: f64) -> Option<f64> {
        loop {
            let blocking = self.obstacles.iter().filter(|o| o.blocks(self.height, elevation));
            let mut cleared = elevation;
            for obstacle in blocking {
                let least = obstacle.cleared_from(self.height, elevation)?;
                cleared = cleared.max(least).max(elevation + RESOLUTION);
            }
            if cleared == elevation {
                return Some(elevation);
            }
            if cleared >= UPRIGHT {
                return None;
            }
            elevation = cleared;
        }
    }

    /// The least elevation, rad, at which nothing blocks the cue; `None` if every elevation is
    /// blocked.
    pub(super) fn least_elevation(&self) -> Option<f64> {
        self.least_from(0.0)
    }

    /// The default elevation, rad: the least elevation from `stroke` on at which nothing blocks the
    /// cue. If there is none up to 80°, it is `stroke`.
    pub(super) fn default_elevation(&self, stroke: f64) -> f64 {
        self.least_from(stroke).filter(|least| *least <= STEEPEST_DEFAULT).unwrap_or(stroke)
    }

    /// How far (m) a cue at `elevation` is from the obstacle that it comes nearest to, across its
    /// axis in its vertical plane; negative if it passes through.
    pub(super) fn clearance(&self, elevation: f64) -> Option<(f64, Touched)> {
        let behind = self.obstacles.iter().filter(|o| (o.polar - elevation).abs() < UPRIGHT);
        let distances = behind.map(|obstacle| {
            let (required, actual) = obstacle.required_and_actual(self.height, elevation);
            // A cue passes above a rail, but above or below a ball in the air.
            let is_ball = matches!(obstacle.shape, Section::Ball { .. });
            let away = if is_ball { actual.abs() } else { actual };
            (away - required, obstacle.what)
        });
        distances.min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// The ball or rail nearest to the tip that blocks a cue at `elevation`, even if it is raised
    /// to [`STANCE`].
    pub(super) fn obstruction(&self, elevation: f64) -> Option<Touched> {
        let raised = elevation.max(STANCE);
        if self.least_from(elevation).is_some_and(|least| least <= raised) {
            return None;
        }
        let blocking = self.obstacles.iter().filter(|o| o.blocks(self.height, raised));
        blocking.min_by(|a, b| a.distance.total_cmp(&b.distance)).map(|o| o.what)
    }
}

/// The point where a ray crosses an edge of the rails' tops.
struct Crossing {
    rail: Rail,
    /// Distance from the ray's start, m.
    distance: f64,
    /// Cosine of the angle between the ray and the edge's normal.
    cos: f64,
}

/// The edges of the rails' tops that the ray from `from` along the unit vector `way` crosses, in
/// the engine's coordinates.
fn edges(table: &Table, from: Vec2, way: Vec2) -> Vec<Crossing> {
    let mut found = Vec::new();
    let Some(description) = &table.description else { return found };
    let crossing = |rail, distance: f64, normal: Vec2| {
        let cos = normal.dot(way).abs();
        (distance > 0.0 && cos > 0.0).then_some(Crossing { rail, distance, cos })
    };
    for cushion in &table.cushions {
        if let Shape::Segment { start, end, normal } = cushion.shape {
            let (along, to_start) = (end - start, start - from);
            let across = way.cross(along);
            let part = to_start.cross(way) / across;
            if (0.0..=1.0).contains(&part) {
                found.extend(crossing(cushion.rail, to_start.cross(along) / across, normal));
            }
        } else if let Shape::Arc { center, radius, start, end } = cushion.shape {
            let sides = arc_sides(start, end);
            for (distance, normal) in circle(from, way, center, radius) {
                if sides.iter().all(|side| side.dot(normal) >= 0.0) {
                    found.extend(crossing(cushion.rail, distance, normal));
                }
            }
        }
    }
    let border = table.size * 0.5 + Vec2::new(description.rail_width, description.rail_width);
    let along_x = ((if way.x < 0.0 { -border.x } else { border.x }) - from.x) / way.x;
    let along_y = ((if way.y < 0.0 { -border.y } else { border.y }) - from.y) / way.y;
    let (distance, normal) = if along_x < along_y {
        (along_x, Vec2::new(way.x.signum(), 0.0))
    } else {
        (along_y, Vec2::new(0.0, way.y.signum()))
    };
    let rail = rail_at(table, normal, from + way * distance);
    found.extend(crossing(rail, distance, normal));
    for pocket in &table.pockets {
        for (distance, normal) in circle(from, way, pocket.center, pocket.radius) {
            if pocket.axis.dot(normal) > 0.0 {
                found.extend(crossing(rail, distance, normal));
            }
        }
    }
    found
}

/// The points where the line from `from` along `way` crosses a circle: the distance, m, and the
/// unit normal.
fn circle(from: Vec2, way: Vec2, center: Vec2, radius: f64) -> impl Iterator<Item = (f64, Vec2)> {
    let to_center = center - from;
    let (ahead, aside) = (way.dot(to_center), way.cross(to_center));
    let squared = radius * radius - aside * aside;
    let half_chord = sqrt(squared.max(0.0));
    let distances =
        if squared > 0.0 { [ahead - half_chord, ahead + half_chord] } else { [-1.0; 2] };
    let normal = move |s: f64| (from + way * s - center) * (1.0 / radius);
    distances.into_iter().filter(|s| *s > 0.0).map(move |s| (s, normal(s)))
}

/// The rail whose nose faces away from `outwards` and is nearest to `point`.
fn rail_at(table: &Table, outwards: Vec2, point: Vec2) -> Rail {
    let mut nearest = (f64::INFINITY, Rail::Bottom);
    for cushion in table.cushions.iter().filter(|c| c.part == Part::Nose) {
        if let Shape::Segment { start, end, normal } = cushion.shape
            && normal.dot(outwards) < 0.0
        {
            let distance = ((start + end) * 0.5 - point).length();
            if distance < nearest.0 {
                nearest = (distance, cushion.rail);
            }
        }
    }
    nearest.1
}

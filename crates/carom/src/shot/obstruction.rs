//! What the cue would pass through on its way to the ball.
//!
//! The cue is a straight cone from the contact point backwards along its axis. A ball obstructs it
//! that is nearer to the axis than the two radii; a rail, if its nose line crosses below the cue
//! with less than the cue's radius to spare. Over a pocket's mouth there is no nose.

use super::PlacedBall;
use crate::math::{Vec2, Vec3, sin_cos};
use crate::outcome::Touched;
use crate::resolve::cue_ball::Strike;
use crate::table::{Part, Shape, TOUCH_TOLERANCE, Table};

/// Length of a cue, m: 58 in, the usual one-piece or jointed cue.
const LENGTH: f64 = 1.47;
/// Radius at the tip, m: 13 mm across, the WPA allows 14.
const TIP: f64 = 0.0065;
/// Radius at the butt, m: 29 mm across, as usual.
const BUTT: f64 = 0.0145;

/// Elevation that a player gives the cue anyway, rad (5°): a level cue would pass through the
/// rail behind it at nearly every shot. Up to this, a strike is judged as if raised so far.
const STANCE: f64 = 0.087_266_462_599_716_48;

/// The cue's axis, from the contact point backwards.
struct Axis {
    tip: Vec3,
    /// Unit vector towards the butt.
    back: Vec3,
}

impl Axis {
    fn new(strike: &Strike, center: Vec3, radius: f64) -> Self {
        let (sin_azimuth, cos_azimuth) = sin_cos(strike.azimuth);
        let (sin, cos) = sin_cos(strike.elevation.max(STANCE));
        let ahead = Vec3::new(cos * cos_azimuth, cos * sin_azimuth, -sin);
        let right = Vec3::new(sin_azimuth, -cos_azimuth, 0.0);
        let up = right.cross(ahead);
        let (x, y) = (strike.side, strike.height);
        let inward = crate::math::sqrt((1.0 - x * x - y * y).max(0.0));
        let contact = right * x + up * y - ahead * inward;
        Self { tip: center + contact * radius, back: -ahead }
    }

    /// Radius of the cue `s` m behind its tip.
    fn radius(s: f64) -> f64 {
        TIP + (BUTT - TIP) * (s / LENGTH)
    }

    /// How far behind the tip the cue meets `ball`, m.
    fn meets_ball(&self, ball: &PlacedBall) -> Option<f64> {
        let to_ball = ball.state.position - self.tip;
        let s = to_ball.dot(self.back).clamp(0.0, LENGTH);
        let distance = (to_ball - self.back * s).length();
        (distance < ball.ball.radius + Self::radius(s) - TOUCH_TOLERANCE).then_some(s)
    }

    /// How far behind the tip the cue meets the nose from `start` to `end` (in the file's frame)
    /// at `height`, m.
    fn meets_nose(&self, start: Vec2, end: Vec2, height: f64) -> Option<f64> {
        let (along, way) = (end - start, self.back.xy());
        let across = way.cross(along);
        if across == 0.0 {
            return None;
        }
        let to_start = start - self.tip.xy();
        let (s, part) = (to_start.cross(along) / across, to_start.cross(way) / across);
        let crosses = (0.0..=LENGTH).contains(&s) && (0.0..=1.0).contains(&part);
        let below = self.tip.z + self.back.z * s - Self::radius(s);
        (crosses && below < height - TOUCH_TOLERANCE).then_some(s)
    }
}

/// The ball or rail nearest to the tip that the cue would pass through when it strikes `ball`.
pub(super) fn find(
    table: &Table,
    balls: &[PlacedBall],
    ball: usize,
    strike: &Strike,
) -> Option<Touched> {
    let struck = &balls[ball];
    let axis = Axis::new(strike, struck.state.position, struck.ball.radius);
    let others = (0u16..).zip(balls).filter(|(i, _)| usize::from(*i) != ball);
    let by_balls = others.filter_map(|(i, b)| Some((axis.meets_ball(b)?, Touched::Ball(i))));
    let center = table.center();
    let noses = table.cushions.iter().filter(|part| part.part == Part::Nose);
    let by_rails = noses.filter_map(|nose| match nose.shape {
        Shape::Segment { start, end, .. } => {
            let s = axis.meets_nose(start + center, end + center, table.cushion_height)?;
            Some((s, Touched::Rail(nose.rail)))
        }
        Shape::Arc { .. } => None,
    });
    by_balls.chain(by_rails).min_by(|(a, _), (b, _)| a.total_cmp(b)).map(|(_, touched)| touched)
}

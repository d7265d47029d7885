//! The strength and the place of the impacts of a trace, derived from the states just before and
//! just after: impulse J = mΔv for each ball, and the points of contact.

use alloc::vec;
use alloc::vec::Vec;

use super::{Trace, TraceEvent, TraceEventKind};
use crate::BallState;
use crate::math::{Vec2, Vec3};
use crate::resolve::cue_ball;
use crate::shot::{PlacedBall, Shot};
use crate::simulate::CLOSING_TIME;
use crate::table::TableFeature;
use crate::table::{Capture, Part, Rail, Shape, TOUCH_TOLERANCE, Table, arc_sides};

impl TraceEvent<'_> {
    /// Whether bodies meet in the event: tip, balls, cushions or slate.
    pub const fn is_impact(&self) -> bool {
        matches!(
            self.kind,
            TraceEventKind::CueStrike { .. }
                | TraceEventKind::BallCollision
                | TraceEventKind::RailCollision { .. }
                | TraceEventKind::SlateCollision
        )
    }
}

impl Trace {
    /// The change of each ball's momentum in `event`, N s, in the order of the event's balls; empty
    /// if it is not an impact. On the slate it has what the slate gives to the ball in the same
    /// instant. In a collision of several balls it is the sum over the ball's contacts.
    pub fn impulses(&self, event: &TraceEvent<'_>) -> Vec<Vec3> {
        if !event.is_impact() {
            return Vec::new();
        }
        let states = event.before.iter().zip(event.after);
        let change = |(&ball, (before, after)): (&u16, (&BallState, &BallState))| {
            (after.velocity - before.velocity) * self.shot.balls[usize::from(ball)].ball.mass
        };
        event.balls.iter().zip(states).map(change).collect()
    }

    /// The points of contact in `event`, m, in the file's coordinates; empty if it is not an
    /// impact. In a strike the tip's comes first. Of several balls every two that touch have one.
    pub fn contact_points(&self, event: &TraceEvent<'_>) -> Vec<Vec3> {
        match event.kind {
            TraceEventKind::CueStrike { .. } => {
                let tip = self.shot.strike.map(|(ball, strike)| {
                    let radius = self.shot.balls[ball].ball.radius;
                    event.before[0].position + cue_ball::contact_arm(&strike) * radius
                });
                let tip_time = self.shot.physics.contact_times.tip;
                tip.into_iter().chain(points_of_balls(&self.shot, event, tip_time)).collect()
            }
            TraceEventKind::BallCollision => points_of_balls(&self.shot, event, CLOSING_TIME),
            TraceEventKind::RailCollision { rail, part } => {
                let point = |table: &Table, state: &BallState, radius| {
                    on_cushion(table, rail, part, state.position, radius)
                };
                vec![on_table(&self.shot, event, point)]
            }
            TraceEventKind::SlateCollision => {
                let point = |table: &Table, state: &BallState, radius| {
                    on_slate(table, state.position, radius)
                };
                vec![on_table(&self.shot, event, point)]
            }
            TraceEventKind::PocketCollision(_)
            | TraceEventKind::OffTable
            | TraceEventKind::MotionTransition { .. } => Vec::new(),
        }
    }
}

/// The points at which two balls of `event` touch, or come to touch within `time` (s).
fn points_of_balls(shot: &Shot, event: &TraceEvent<'_>, time: f64) -> Vec<Vec3> {
    let radius = |k: usize| shot.balls[usize::from(event.balls[k])].ball.radius;
    let mut points = Vec::new();
    for j in 1..event.balls.len() {
        for i in 0..j {
            let apart = event.before[j].position - event.before[i].position;
            let (distance, radii) = (apart.length(), radius(i) + radius(j));
            let speeds = [event.before, event.after]
                .map(|states| (states[j].velocity - states[i].velocity).length());
            let closing = time * speeds[0].max(speeds[1]);
            let is_pair = event.balls.len() == 2;
            if is_pair || distance - radii <= TOUCH_TOLERANCE + closing {
                points.push(event.before[i].position + apart * (radius(i) / distance));
            }
        }
    }
    points
}

/// The point of the event's one ball on the table, which `find` gives in the engine's coordinates.
fn on_table(
    shot: &Shot,
    event: &TraceEvent<'_>,
    find: impl Fn(&Table, &BallState, f64) -> Vec3,
) -> Vec3 {
    let PlacedBall { ball, .. } = &shot.balls[usize::from(event.balls[0])];
    let state = shot.table.to_engine_coordinates(&event.before[0]);
    let point = find(&shot.table, &state, ball.radius);
    point + shot.table.center().with_z(0.0)
}

/// The point on the part of the cushions with these names that a ball touches with its centre at
/// `position`. A rail has several facings, points and liners.
fn on_cushion(table: &Table, rail: Rail, part: Part, position: Vec3, radius: f64) -> Vec3 {
    let gap = |shape: &Shape| (distance(table, shape, position, radius) - radius).abs();
    let parts = (0u16..).zip(&table.cushions);
    let parts = parts.filter(|(_, cushion)| (cushion.rail, cushion.part) == (rail, part));
    let nearest = parts.min_by(|(_, a), (_, b)| gap(&a.shape).total_cmp(&gap(&b.shape)));
    let Some((part, _)) = nearest else { return position };
    let normal = table.contact_normal(TableFeature::Cushion(part), position, radius);
    position + normal * radius
}

/// Distance of the centre `position` of a ball of `radius` (m) from a part of the cushions, m. A
/// part that is further above the ball is a wall to it, and the distance is that in plan view.
fn distance(table: &Table, shape: &Shape, position: Vec3, radius: f64) -> f64 {
    let (place, rise) = (position.xy(), table.cushion_height - position.z);
    let across = match *shape {
        Shape::Plane { .. } => 0.0,
        Shape::Segment { start, end, .. } => {
            let along = end - start;
            let share = (place - start).dot(along) / along.length_squared();
            (start + along * share.clamp(0.0, 1.0) - place).length()
        }
        Shape::Arc { center, radius: ring, start, end }
        | Shape::Hollow { center, radius: ring, start, end } => {
            let from_center = place - center;
            if arc_sides(start, end).iter().all(|side| side.dot(from_center) >= 0.0) {
                (ring - from_center.length()).abs()
            } else {
                let to = |end: Vec2| (from_center - end * ring).length();
                to(start).min(to(end))
            }
        }
    };
    if rise > radius { across } else { Vec2::new(across, rise).length() }
}

/// The point of the slate that a ball touches with its centre at `position`: below it, or on the
/// lip of the nearest hole.
fn on_slate(table: &Table, position: Vec3, radius: f64) -> Vec3 {
    if (position.z - radius).abs() <= TOUCH_TOLERANCE {
        return position.xy().with_z(0.0);
    }
    let lips = (0u8..).zip(&table.pockets).filter(|(_, p)| p.capture == Capture::DropCircle);
    let touched = lips.map(|(k, pocket)| {
        let normal = table.contact_normal(TableFeature::Lip(k), position, radius);
        let point = position + normal * radius;
        (((point.xy() - pocket.center).length() - pocket.radius).abs(), point)
    });
    let nearest = touched.min_by(|(a, _), (b, _)| a.total_cmp(b));
    nearest.map_or(position.xy().with_z(0.0), |(_, point)| point)
}

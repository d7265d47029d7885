//! Off the cloth: bounces on slate, lips and rails' tops, falls over edges, and the ways out of play.

use super::support::{Support, on_plane};
use super::{Simulation, impact};
use crate::detect::ball_ball::ContactFinder;
use crate::detect::ball_table::TableFeature;
use crate::event::{Event, EventKind, Recorder};
use crate::math::{Vec2, Vec3};
use crate::resolve::ball_edge::{self, Edge};
use crate::resolve::ball_slate;
use crate::table::{BRINK, Capture, Shape};
use crate::{BallState, MotionState, Physics, Table};

/// A ball that rolls over the lip of a hole slower than this, m/s, stops and hangs there, whatever the
/// cloth: below it the fall would take seconds, and thousands of the small bounces that it is made
/// of.
const SLOWEST_FALL: f64 = 1e-3;

impl<const N: usize, F: ContactFinder> Simulation<N, F> {
    /// Ball `i` meets something of the table that is no cushion. Returns the number of events.
    pub(super) fn leave<R: Recorder>(
        &mut self,
        i: usize,
        feature: TableFeature,
        time: f64,
        table: &Table,
        physics: &Physics,
        recorder: &mut R,
    ) -> u32 {
        match feature {
            TableFeature::Pocket(k) => match table.pockets[usize::from(k)].capture {
                Capture::MouthLine { .. } => self.sink(i, k, time, table, physics, recorder),
                Capture::DropCircle => self.lose_support(i, time, table, physics, recorder),
            },
            TableFeature::Brink => self.lose_support(i, time, table, physics, recorder),
            TableFeature::Slate => self.land(i, time, table, physics, recorder),
            TableFeature::Lip(_) => self.tip(i, feature, time, table, physics, recorder),
            TableFeature::Depth(k) => self.sound(i, k, time, table, physics, recorder),
            TableFeature::Edge => {
                let state = self.state(i, time);
                self.retire(i, &state, time, table, physics, recorder)
            }
            // A cushion is met in `rebound`.
            TableFeature::Cushion(_) => 0,
        }
    }

    /// Records an event of ball `i` alone, and finds what it does next.
    #[expect(clippy::too_many_arguments, reason = "one event, in full")]
    #[inline(always)]
    pub(super) fn happen<R: Recorder>(
        &mut self,
        i: usize,
        kind: EventKind,
        [before, after]: [BallState; 2],
        time: f64,
        table: &Table,
        physics: &Physics,
        recorder: &mut R,
    ) -> u32 {
        recorder.record(&Event {
            time,
            kind,
            balls: &[i as u16],
            before: &[before],
            after: &[after],
        });
        self.begin(i, &after, time, physics);
        self.find(&[i as u16], time, table);
        1
    }

    /// The centre of a ball on the slate comes over a hole, or that of one on a rail's top over its
    /// edge: it flies from here on, or gravity tips it over the edge. Rolling resistance holds it where
    /// it is slower than μ_r√(gR): until it is μ_r R over the edge it is still braked.
    fn lose_support<R: Recorder>(
        &mut self,
        i: usize,
        time: f64,
        table: &Table,
        physics: &Physics,
        recorder: &mut R,
    ) -> u32 {
        let before = self.state(i, time);
        let hangs = self.is_too_slow_to_fall(i, &before, physics);
        let after = if hangs {
            self.hanging(i, &before, before.position.z)
        } else {
            BallState { motion: MotionState::Airborne, ..before }
        };
        let kind = EventKind::MotionTransition { from: before.motion, to: after.motion };
        let events = self.happen(i, kind, [before, after], time, table, physics, recorder);
        if hangs && self.aloft[i] {
            return events + self.retire(i, &after, time, table, physics, recorder);
        }
        events
    }

    /// Whether rolling resistance holds a ball on the brink of an edge.
    fn is_too_slow_to_fall(&self, i: usize, state: &BallState, physics: &Physics) -> bool {
        let radius = self.ball[i].radius;
        let friction = physics.cloth.rolling_friction;
        let least =
            (friction * friction * physics.gravity * radius).max(SLOWEST_FALL * SLOWEST_FALL);
        let surface = radius * radius * state.angular_velocity.xy().length_squared();
        state.velocity.length_squared().max(surface) < least
    }

    /// The state of ball `i` where rolling resistance has stopped it on a brink, its centre at `height`, m:
    /// it may still spin.
    fn hanging(&self, i: usize, state: &BallState, height: f64) -> BallState {
        let spin = Vec3::new(0.0, 0.0, state.angular_velocity.z);
        on_plane(state.position.xy().with_z(height), Vec3::ZERO, spin, self.ball[i].radius)
    }

    /// A ball comes down on the slate.
    fn land<R: Recorder>(
        &mut self,
        i: usize,
        time: f64,
        table: &Table,
        physics: &Physics,
        recorder: &mut R,
    ) -> u32 {
        let before = self.state(i, time);
        let after = self.bounced(i, &before, self.ball[i].radius, physics);
        self.happen(i, EventKind::SlateCollision, [before, after], time, table, physics, recorder)
    }

    /// The state after a bounce on the plane that touches the ball whose centre is at `height`, m.
    fn bounced(&self, i: usize, before: &BallState, height: f64, physics: &Physics) -> BallState {
        let mut body = impact::body(before, &self.ball[i]);
        ball_slate::bounce(&physics.slate, &mut body);
        let position = before.position.xy().with_z(height);
        let here = BallState { position, ..*before };
        let (v, spin) = (body.velocity, body.angular_velocity);
        Support::Plane.settled(&here, v, spin, &self.ball[i], physics)
    }

    /// A ball comes down on a rail's top, `part` of the cushions; at rest there it is out of play.
    #[expect(clippy::too_many_arguments, reason = "one event, in full")]
    pub(super) fn land_on_top<R: Recorder>(
        &mut self,
        i: usize,
        part: u16,
        before: &BallState,
        time: f64,
        table: &Table,
        physics: &Physics,
        recorder: &mut R,
    ) -> u32 {
        let height = table.cushion_height + self.ball[i].radius;
        let after = self.bounced(i, before, height, physics);
        let kind = EventKind::RailCollision(part);
        let events = self.happen(i, kind, [*before, after], time, table, physics, recorder);
        if after.motion != MotionState::Stationary {
            return events;
        }
        events + self.retire(i, &after, time, table, physics, recorder)
    }

    /// A ball in the air touches the edge of a hole.
    fn tip<R: Recorder>(
        &mut self,
        i: usize,
        feature: TableFeature,
        time: f64,
        table: &Table,
        physics: &Physics,
        recorder: &mut R,
    ) -> u32 {
        let before = self.state(i, time);
        let mut body = impact::body(&before, &self.ball[i]);
        let edge = edge_at(table, feature, before.position, self.ball[i].radius);
        ball_edge::resolve(&physics.slate, physics.gravity, &edge, &mut body);
        let (velocity, angular_velocity) = (body.velocity, body.angular_velocity);
        let mut after = BallState { velocity, angular_velocity, ..before };
        if edge.normal.xy().length_squared() < BRINK * BRINK
            && self.is_too_slow_to_fall(i, &after, physics)
        {
            after = self.hanging(i, &after, self.ball[i].radius);
        }
        let kind = EventKind::SlateCollision;
        let events = self.happen(i, kind, [before, after], time, table, physics, recorder);
        events + self.catch(i, &after, time, table, physics, recorder)
    }

    /// The centre of a ball in the hole of `pocket` comes down to the slate's surface, or to a radius
    /// below it, from where it is lost in any case.
    fn sound<R: Recorder>(
        &mut self,
        i: usize,
        pocket: u8,
        time: f64,
        table: &Table,
        physics: &Physics,
        recorder: &mut R,
    ) -> u32 {
        let mut state = self.state(i, time);
        if state.position.z < -0.5 * self.ball[i].radius {
            return self.sink(i, pocket, time, table, physics, recorder);
        }
        // The path goes on; but from here on the ball is below the slate's surface.
        state.position.z = 0.0;
        self.begin(i, &state, time, physics);
        self.find(&[i as u16], time, table);
        self.catch(i, &state, time, table, physics, recorder)
    }

    /// A ball below the slate's surface is lost if its energy cannot lift it back. Returns the number
    /// of events.
    pub(super) fn catch<R: Recorder>(
        &mut self,
        i: usize,
        state: &BallState,
        time: f64,
        table: &Table,
        physics: &Physics,
        recorder: &mut R,
    ) -> u32 {
        let ball = &self.ball[i];
        let climb = ball.mass * physics.gravity * (ball.radius - state.position.z);
        if state.position.z > 0.0 || ball.kinetic_energy(state) >= climb {
            return 0;
        }
        match table.hole_at(state.position.xy()) {
            Some(pocket) => self.sink(i, pocket, time, table, physics, recorder),
            None => 0,
        }
    }

    /// A ball falls into a pocket: it comes to rest below the slate, under the hole's centre.
    fn sink<R: Recorder>(
        &mut self,
        i: usize,
        pocket: u8,
        time: f64,
        table: &Table,
        physics: &Physics,
        recorder: &mut R,
    ) -> u32 {
        let before = self.state(i, time);
        let after = BallState {
            position: table.pockets[usize::from(pocket)].center.with_z(-self.ball[i].radius),
            motion: MotionState::Pocketed,
            ..BallState::default()
        };
        let kind = EventKind::PocketCollision(pocket);
        self.happen(i, kind, [before, after], time, table, physics, recorder)
    }

    /// A ball in `state` leaves the table, or rests where no ball may: it is out of play, and stays there.
    pub(super) fn retire<R: Recorder>(
        &mut self,
        i: usize,
        state: &BallState,
        time: f64,
        table: &Table,
        physics: &Physics,
        recorder: &mut R,
    ) -> u32 {
        let after = BallState {
            position: state.position,
            motion: MotionState::OffTable,
            ..BallState::default()
        };
        let states = [*state, after];
        self.happen(i, EventKind::OffTable, states, time, table, physics, recorder)
    }
}

/// The edge or wall of `feature` where a ball with its centre at `position` (m) touches it.
pub(super) fn edge_at(table: &Table, feature: TableFeature, position: Vec3, radius: f64) -> Edge {
    let normal = table.contact_normal(feature, position, radius);
    let turn = if normal.z == 0.0 { 0.0 } else { 1.0 / radius };
    let straight = |along: Vec2| Edge { normal, along, bend: 0.0, turn };
    let round = |center: Vec2| {
        let from_center = position.xy() - center;
        let distance = from_center.length();
        if distance == 0.0 {
            return straight(Vec2::ZERO);
        }
        let outwards = from_center * (1.0 / distance);
        let bend = normal.xy().dot(outwards) / distance;
        Edge { normal, along: outwards.perp(), bend, turn }
    };
    match feature {
        TableFeature::Lip(k) => round(table.pockets[usize::from(k)].center),
        TableFeature::Cushion(part) => match table.cushions[usize::from(part)].shape {
            Shape::Segment { normal, .. } => straight(normal.perp()),
            Shape::Arc { center, .. } | Shape::Hollow { center, .. } => round(center),
            Shape::Plane { .. } => straight(Vec2::ZERO),
        },
        _ => straight(Vec2::ZERO),
    }
}

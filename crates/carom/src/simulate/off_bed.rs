//! Balls off the bed: bounces on the slate, on lips and on rails' tops; falls over edges; and the
//! events that take a ball out of play.

use super::Simulation;
use super::edge::lip_edge;
use super::jam::Touched;
use super::step::StepContext;
use super::support::{Support, on_plane};
use crate::event::{EventKind, Recorder};
use crate::math::{Vec3, sqrt};
use crate::resolve::{Body, ball_edge, ball_slate};
use crate::table::{Capture, LIP_OVERHANG};
use crate::{BallState, MotionState, Physics};

/// A ball that rolls over the lip of a hole slower than this, m/s, stops and hangs there, whatever
/// the cloth. Purpose: at lower speeds the fall would take seconds and consist of thousands of
/// small bounces.
const SLOWEST_FALL: f64 = 1e-3;

impl<const N: usize> Simulation<N> {
    /// A ball's centre comes over a hole, or crosses the mouth line of a pocket.
    pub(super) fn on_hole<R: Recorder>(
        &mut self,
        i: usize,
        pocket: u8,
        step: &mut StepContext<'_, R>,
    ) {
        match step.table.pockets[usize::from(pocket)].capture {
            Capture::MouthLine { .. } => self.on_pocketed(i, pocket, step),
            Capture::DropCircle => self.on_lost_support(i, step),
        }
    }

    /// The centre of a ball on the slate comes over a hole, or the centre of a ball on a rail's top
    /// comes over its edge. The ball then flies, or gravity turns it about the edge. Rolling
    /// resistance stops a ball slower than μ_r√(gR), because it brakes the ball until the centre is
    /// μ_r R beyond the edge.
    pub(super) fn on_lost_support<R: Recorder>(&mut self, i: usize, step: &mut StepContext<'_, R>) {
        let before = self.state(i, step.time);
        let hangs = self.is_too_slow_to_fall(i, &before, step.physics);
        let after = if hangs {
            self.hanging(i, &before, before.position.z)
        } else {
            BallState { motion: MotionState::Airborne, ..before }
        };
        let kind = EventKind::MotionTransition { from: before.motion, to: after.motion };
        self.emit(i, kind, [before, after], step);
        if hangs && self.off_bed[i] {
            self.on_off_table(i, &after, step);
        }
    }

    /// Whether rolling resistance stops a ball at an edge.
    fn is_too_slow_to_fall(&self, i: usize, state: &BallState, physics: &Physics) -> bool {
        let radius = self.ball[i].radius;
        let surface = radius * radius * state.angular_velocity.xy().length_squared();
        let squared_speed = state.velocity.length_squared().max(surface);
        let friction = physics.cloth.rolling_friction.at(sqrt(squared_speed));
        let least =
            (friction * friction * physics.gravity * radius).max(SLOWEST_FALL * SLOWEST_FALL);
        squared_speed < least
    }

    /// The state of ball `i` where rolling resistance has stopped it at an edge, its centre at
    /// `height`, m. It may still spin.
    fn hanging(&self, i: usize, state: &BallState, height: f64) -> BallState {
        let spin = Vec3::new(0.0, 0.0, state.angular_velocity.z);
        on_plane(state.position.xy().with_z(height), Vec3::ZERO, spin, self.ball[i].radius)
    }

    /// A ball comes down on the slate.
    pub(super) fn on_slate_contact<R: Recorder>(
        &mut self,
        i: usize,
        step: &mut StepContext<'_, R>,
    ) {
        let before = self.state(i, step.time);
        let after = self.bounced(i, &before, self.ball[i].radius, step.physics);
        self.emit(i, EventKind::SlateCollision, [before, after], step);
    }

    /// The state after a bounce on a horizontal plane that touches the ball when its centre is at
    /// `height`, m.
    fn bounced(&self, i: usize, before: &BallState, height: f64, physics: &Physics) -> BallState {
        let mut body = Body::new(&self.ball[i], before);
        ball_slate::bounce(&physics.slate, &mut body);
        let position = before.position.xy().with_z(height);
        let here = BallState { position, ..*before };
        let (v, spin) = (body.velocity, body.angular_velocity);
        Support::Plane.settled(&here, v, spin, &self.ball[i], physics)
    }

    /// A ball comes down on a rail's top, `part` of the cushions. A ball that rests there is out of
    /// play.
    pub(super) fn on_rail_top_contact<R: Recorder>(
        &mut self,
        i: usize,
        part: u16,
        before: &BallState,
        step: &mut StepContext<'_, R>,
    ) {
        let height = step.table.cushion_height + self.ball[i].radius;
        let after = self.bounced(i, before, height, step.physics);
        self.emit(i, EventKind::RailCollision(part), [*before, after], step);
        if after.motion == MotionState::Stationary {
            self.on_off_table(i, &after, step);
        }
    }

    /// A ball off the bed touches the lip of a hole.
    pub(super) fn on_lip_contact<R: Recorder>(
        &mut self,
        i: usize,
        pocket: u8,
        step: &mut StepContext<'_, R>,
    ) {
        let before = self.state(i, step.time);
        let mut body = Body::new(&self.ball[i], &before);
        let edge = lip_edge(step.table, pocket, before.position, self.ball[i].radius);
        ball_edge::resolve(&step.physics.slate, step.physics.gravity, &edge, &mut body);
        let (velocity, angular_velocity) = (body.velocity, body.angular_velocity);
        let mut after = BallState { velocity, angular_velocity, ..before };
        if edge.normal.xy().length_squared() < LIP_OVERHANG * LIP_OVERHANG
            && self.is_too_slow_to_fall(i, &after, step.physics)
        {
            after = self.hanging(i, &after, self.ball[i].radius);
        }
        self.emit(i, EventKind::SlateCollision, [before, after], step);
        self.pocket_if_trapped(i, &after, step);
        self.stop_if_jammed(i, Touched::Lip(pocket), &after, step);
    }

    /// The centre of a ball in the hole of `pocket` comes down to the slate's surface, or to one
    /// radius below it. At the second depth the ball is pocketed in any case.
    pub(super) fn on_pocket_depth<R: Recorder>(
        &mut self,
        i: usize,
        pocket: u8,
        step: &mut StepContext<'_, R>,
    ) {
        let mut state = self.state(i, step.time);
        if state.position.z < -0.5 * self.ball[i].radius {
            return self.on_pocketed(i, pocket, step);
        }
        // No event: the same path goes on, but the next depth to search for is the lower one.
        state.position.z = 0.0;
        self.begin_path(i, &state, step);
        self.find_candidates(&[i as u16], step.time, step.table);
        self.pocket_if_trapped(i, &state, step);
    }

    /// Takes ball `i`, in `state` after a contact off the bed with `touched`, out of play if it is
    /// jammed.
    #[inline(always)]
    pub(super) fn stop_if_jammed<R: Recorder>(
        &mut self,
        i: usize,
        touched: Touched,
        state: &BallState,
        step: &mut StepContext<'_, R>,
    ) {
        if !self.jam[i].count_early() {
            self.stop_if_still_there(i, touched, state, step);
        }
    }

    #[cold]
    fn stop_if_still_there<R: Recorder>(
        &mut self,
        i: usize,
        touched: Touched,
        state: &BallState,
        step: &mut StepContext<'_, R>,
    ) {
        let is_loose = self.path[i].motion == MotionState::Airborne;
        if is_loose && self.jam[i].touch(touched, state.position, step.time) {
            self.on_off_table(i, state, step);
        }
    }

    /// Pockets a ball whose centre is below the slate's surface and whose energy cannot lift it
    /// back on to the slate.
    pub(super) fn pocket_if_trapped<R: Recorder>(
        &mut self,
        i: usize,
        state: &BallState,
        step: &mut StepContext<'_, R>,
    ) {
        let ball = &self.ball[i];
        let climb = ball.mass * step.physics.gravity * (ball.radius - state.position.z);
        if state.position.z > 0.0 || ball.kinetic_energy(state) >= climb {
            return;
        }
        if let Some(pocket) = step.table.hole_at(state.position.xy()) {
            self.on_pocketed(i, pocket, step);
        }
    }

    /// A ball falls into a pocket. It comes to rest below the slate, under the hole's centre.
    fn on_pocketed<R: Recorder>(&mut self, i: usize, pocket: u8, step: &mut StepContext<'_, R>) {
        let before = self.state(i, step.time);
        let center = step.table.pockets[usize::from(pocket)].center;
        let after = BallState {
            position: center.with_z(-self.ball[i].radius),
            motion: MotionState::Pocketed,
            ..BallState::default()
        };
        self.emit(i, EventKind::PocketCollision(pocket), [before, after], step);
    }

    /// A ball in `state` leaves the table, or rests on a rail's top. It is out of play and stays
    /// where it is.
    pub(super) fn on_off_table<R: Recorder>(
        &mut self,
        i: usize,
        state: &BallState,
        step: &mut StepContext<'_, R>,
    ) {
        let after = BallState {
            position: state.position,
            motion: MotionState::OffTable,
            ..BallState::default()
        };
        self.emit(i, EventKind::OffTable, [*state, after], step);
    }
}

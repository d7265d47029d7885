//! The path of every ball through the events of a shot, in the file's coordinates.

use alloc::vec::Vec;

use crate::error::Error;
use crate::event::{Event, Recorder};
use crate::math::{Vec2, Vec3};
use crate::motion::Path;
use crate::simulator::Simulator;
use crate::{BallState, Shot};

/// The motion of a ball since its last event, as [`Trace::at`](crate::Trace::at) computes it.
pub(super) struct Leg<'a> {
    /// Time of the event, s.
    since: f64,
    /// State just after it.
    state: &'a BallState,
    path: Path,
}

impl Leg<'_> {
    /// The state at `time`, s, not before the leg's start.
    pub(super) fn state_at(&self, time: f64) -> BallState {
        if time == self.since { *self.state } else { self.path.at(self.age(time)) }
    }

    /// The centre at `time`, s, not before the leg's start.
    #[inline(always)]
    pub(super) fn position_at(&self, time: f64) -> Vec3 {
        if time == self.since { self.state.position } else { self.path.position_at(self.age(time)) }
    }

    #[inline(always)]
    fn age(&self, time: f64) -> f64 {
        let age = time - self.since;
        if age < self.path.duration { age } else { self.path.duration }
    }

    /// Whether the ball still takes part in the shot.
    pub(super) fn in_play(&self) -> bool {
        self.path.motion.in_play()
    }

    /// The leg seen from above.
    pub(super) fn in_plan(&self) -> PlanLeg {
        let Path { position, velocity, half_acceleration, duration, .. } = self.path;
        PlanLeg {
            since: self.since,
            duration,
            position: position.xy(),
            velocity: velocity.xy(),
            half_acceleration: half_acceleration.xy(),
        }
    }
}

/// A leg seen from above.
#[derive(Clone, Copy)]
pub(super) struct PlanLeg {
    since: f64,
    duration: f64,
    position: Vec2,
    velocity: Vec2,
    half_acceleration: Vec2,
}

impl PlanLeg {
    /// A ball that stays at `position`, m.
    pub(super) fn at_rest(position: Vec2) -> Self {
        let (velocity, half_acceleration) = (Vec2::ZERO, Vec2::ZERO);
        Self { since: 0.0, duration: f64::INFINITY, position, velocity, half_acceleration }
    }

    /// The centre at `time`, s, not before the leg's start, m.
    #[inline(always)]
    pub(super) fn position_at(&self, time: f64) -> Vec2 {
        let age = time - self.since;
        let t = if age < self.duration { age } else { self.duration };
        self.position + (self.velocity + self.half_acceleration * t) * t
    }
}

/// What wants to know where balls are at certain times.
pub(super) trait Observer {
    /// Whether a time before `end` (s), in the order of time, is still wanted of ball `ball`.
    fn wants_before(&self, ball: usize, end: f64) -> bool;

    /// Takes all wanted times of ball `ball` before `end` (s). No event of the ball is between the
    /// leg's start and `end`.
    fn observe(&mut self, ball: usize, leg: &Leg<'_>, end: f64);

    /// Takes all wanted times of ball `ball` that are left: the shot has ended, and `state` stays.
    fn observe_end(&mut self, ball: usize, state: &BallState);
}

/// The latest event of a ball.
#[derive(Clone, Copy, Debug)]
struct Since {
    time: f64,
    state: BallState,
}

/// What a thread needs to follow balls, used again for each shot.
#[derive(Debug, Default)]
pub(super) struct Follower {
    simulator: Simulator,
    since: Vec<Since>,
}

impl Follower {
    /// Plays `shot` up to the time `end`, s, and passes every ball's path to `observer`.
    ///
    /// # Errors
    /// As [`Simulator::play`].
    pub(super) fn play<O: Observer>(
        &mut self,
        shot: &Shot,
        end: f64,
        observer: &mut O,
    ) -> Result<(), Error> {
        let Self { simulator, since } = self;
        since.clear();
        since.extend(shot.balls().iter().map(|placed| Since { time: 0.0, state: placed.state }));
        let mut recorder = FollowRecorder { shot, since, observer };
        let summary = simulator.play_until(shot, shot.strike(), end, &mut recorder)?;
        // As in a trace: at its end time a shot with moving balls stops.
        let frozen = shot.until().filter(|&until| until <= end && summary.duration == until);
        let frozen =
            frozen.filter(|_| simulator.states(summary.duration).any(|s| !s.motion.is_at_rest()));
        for ball in 0..shot.balls().len() {
            flush(shot, &self.since[ball], ball, frozen.unwrap_or(f64::INFINITY), observer);
            if let Some(until) = frozen {
                observer.observe_end(ball, &simulator.file_state(ball, shot, until));
            }
        }
        Ok(())
    }
}

/// Passes each leg to the observer when the ball's next event ends it.
struct FollowRecorder<'a, O> {
    shot: &'a Shot,
    since: &'a mut Vec<Since>,
    observer: &'a mut O,
}

impl<O: Observer> Recorder for FollowRecorder<'_, O> {
    #[inline]
    fn record(&mut self, event: &Event<'_>) {
        for (&ball, after) in event.balls.iter().zip(event.after) {
            let ball = usize::from(ball);
            flush(self.shot, &self.since[ball], ball, event.time, self.observer);
            let state = self.shot.to_file_coordinates(ball, after);
            self.since[ball] = Since { time: event.time, state };
        }
    }
}

/// Passes the leg of ball `ball` up to `end` (s) to the observer, if it wants a time of it.
fn flush<O: Observer>(shot: &Shot, since: &Since, ball: usize, end: f64, observer: &mut O) {
    if !observer.wants_before(ball, end) {
        return;
    }
    let (physics, placed) = (&*shot.physics, &shot.balls()[ball]);
    let path = Path::new(&since.state, &placed.ball, &physics.cloth, physics.gravity);
    let leg = Leg { since: since.time, state: &since.state, path };
    observer.observe(ball, &leg, end);
}

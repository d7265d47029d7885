//! Collecting an [`Outcome`] from the events of a shot.

use alloc::vec::Vec;

use super::frozen::Frozen;
use super::jump::Jumps;
use super::track::{Origin, Tracks};
use super::{Outcome, Touched, among};
use crate::event::{Event, Recorder};
use crate::math::Vec2;
use crate::motion::never_rests;
use crate::shot::Shot;
use crate::simulate::CLOSING_TIME;
use crate::table::{Capture, Part, PocketName, Rail, TOUCH_TOLERANCE};
use crate::trace_event::{TraceEvent, TraceEventKind};
use crate::{BallState, MotionState};

/// The facts of a shot that have been collected so far, in memory that serves one shot after the
/// other. It has no reference to the shot. For a single shot: [`OutcomeRecorder`].
#[derive(Clone, Debug, Default)]
pub struct OutcomeMemory {
    outcome: Outcome,
    /// Whether the cue ball has touched a ball; without a cue ball, whether any two balls have
    /// collided.
    contact: bool,
    tracks: Tracks,
    frozen: Vec<Frozen>,
    jumps: Jumps,
    /// Room for an event's states before and after it in the file's coordinates.
    states: [Vec<BallState>; 2],
    /// Room for the balls met during the strike: the distance to each, m, and its index in the
    /// event.
    met: Vec<(f64, usize)>,
}

/// Collects an [`Outcome`] event by event.
#[derive(Clone, Debug)]
pub struct Collector<'a> {
    shot: &'a Shot,
    memory: OutcomeMemory,
}

impl<'a> Collector<'a> {
    /// A collector for one simulation of `shot`.
    pub fn new(shot: &'a Shot) -> Self {
        let mut memory = OutcomeMemory::default();
        memory.restart_in(shot, Origin::File);
        Self { shot, memory }
    }

    /// Adds the next event.
    pub fn add(&mut self, event: &TraceEvent<'_>) {
        self.memory.add(self.shot, event);
    }

    /// The outcome, once `last` are the balls' final states in the file's coordinates.
    pub fn finish(mut self, last: &[BallState]) -> Outcome {
        self.memory.finish(self.shot, last);
        self.memory.outcome
    }
}

impl OutcomeMemory {
    /// The outcome of the last shot, or of its events so far.
    pub const fn outcome(&self) -> &Outcome {
        &self.outcome
    }

    /// The outcome of the last shot, for changes such as other indices of the balls.
    pub const fn outcome_mut(&mut self) -> &mut Outcome {
        &mut self.outcome
    }

    /// Begins again, for one simulation of `shot`.
    pub fn restart(&mut self, shot: &Shot) {
        self.restart_in(shot, Origin::Engine);
    }

    /// Adds the next event of `shot`.
    #[inline]
    pub fn record(&mut self, shot: &Shot, event: &Event<'_>) {
        self.add(
            shot,
            &TraceEvent {
                time: event.time,
                kind: TraceEventKind::of(event.kind, shot.table()),
                balls: event.balls,
                before: event.before,
                after: event.after,
            },
        );
    }

    /// Completes the outcome; `last` are the final states of the balls of `shot` in the file's
    /// coordinates ([`Shot::to_file_coordinates`]).
    pub fn finish(&mut self, shot: &Shot, last: &[BallState]) {
        let states = (0u16..).zip(shot.balls()).zip(last);
        let restless = states.filter(|((_, placed), state)| {
            let physics = shot.physics();
            never_rests(state, &placed.ball, &physics.cloth, physics.gravity)
        });
        self.outcome.never_resting.extend(restless.map(|((i, _), _)| i));
        find_hanging(shot, last, &mut self.outcome.hanging);
    }

    /// Begins again with `shot`. The states of events will be given in the frame `origin`.
    fn restart_in(&mut self, shot: &Shot, origin: Origin) {
        self.outcome.restart(shot.cue_ball().and_then(|i| u16::try_from(i).ok()));
        self.contact = false;
        self.tracks.restart(shot.balls().len(), origin);
        Frozen::find(shot, &mut self.frozen);
        self.jumps.restart(shot);
        for (i, placed) in (0u16..).zip(shot.balls()) {
            self.jumps.begin(i, placed.state.motion, &[]);
        }
    }

    /// Adds the next event of `shot`.
    fn add(&mut self, shot: &Shot, event: &TraceEvent<'_>) {
        self.outcome.events += 1;
        if !self.frozen.is_empty() {
            self.follow_frozen(shot, event);
        }
        if !self.jumps.is_empty() {
            self.jumps.end(shot, event, &self.tracks, &mut self.outcome.jumped);
        }
        match event.kind {
            TraceEventKind::BallCollision => self.balls_collide(shot, event),
            TraceEventKind::RailCollision {
                rail,
                part: Part::Nose | Part::Facing | Part::Point,
            } => {
                event.balls.iter().for_each(|&ball| self.ball_meets_rail(ball, rail));
            }
            TraceEventKind::PocketCollision(pocket) => {
                self.outcome.pocketed.extend(event.balls.iter().map(|&ball| (ball, pocket)));
            }
            TraceEventKind::OffTable => self.outcome.off_table.extend(event.balls),
            TraceEventKind::CueStrike { tip_contacts, pushed } => {
                self.outcome.tip_contacts = tip_contacts;
                self.outcome.pushed = pushed;
                self.cue_strikes(shot, event);
            }
            TraceEventKind::SlateCollision
            | TraceEventKind::RailCollision { part: Part::Top | Part::Liner, .. }
            | TraceEventKind::MotionTransition { .. } => {}
        }
        for (&ball, after) in event.balls.iter().zip(event.after) {
            self.tracks.set(ball, event.time, after);
            self.jumps.begin(ball, after.motion, event.balls);
        }
    }

    /// Follows the frozen balls of `event` along their paths up to the event.
    fn follow_frozen(&mut self, shot: &Shot, event: &TraceEvent<'_>) {
        for &ball in event.balls {
            for frozen in self.frozen.iter_mut().filter(|f| f.waits_for(ball)) {
                let track = self.tracks.of(shot, ball);
                frozen.follow(&track.path, (event.time - track.since).max(0.0));
            }
        }
    }

    fn balls_collide(&mut self, shot: &Shot, event: &TraceEvent<'_>) {
        let Some(cue) = self.outcome.cue_ball else {
            self.contact = true;
            return;
        };
        let Some(own) = event.balls.iter().position(|&ball| ball == cue) else { return };
        self.contact = true;
        if let [a, b] = *event.balls {
            self.touch(if own == 0 { b } else { a });
            return;
        }
        self.convert(shot, event);
        let mut last = None;
        while let Some((gap, k)) = next_touched(shot, event.balls, &self.states[0], own, last) {
            self.touch(event.balls[k]);
            last = Some((gap, k));
        }
    }

    /// The cue ball touches ball `other`.
    fn touch(&mut self, other: u16) {
        self.outcome.first_contact = self.outcome.first_contact.or(Some(other));
        self.outcome.cue_ball_touched.push(Touched::Ball(other));
    }

    /// The cue strikes the cue ball, which may meet balls at the same instant.
    fn cue_strikes(&mut self, shot: &Shot, event: &TraceEvent<'_>) {
        let Some(cue) = self.outcome.cue_ball else { return };
        let Some(own) = event.balls.iter().position(|&ball| ball == cue) else { return };
        if event.balls.len() == 1 {
            return;
        }
        self.convert(shot, event);
        let mut met = core::mem::take(&mut self.met);
        met.clear();
        let [before, after] = &self.states;
        met.extend(met_during_strike(shot, &TraceEvent { before, after, ..*event }, own));
        // The index decides between equal distances, as in a stable sort, which would allocate.
        met.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        for &(_, k) in &met {
            self.contact = true;
            self.touch(event.balls[k]);
            self.outcome.met_during_strike.push(event.balls[k]);
        }
        self.met = met;
    }

    /// Writes the states of `event` into `states`, in the file's coordinates.
    fn convert(&mut self, shot: &Shot, event: &TraceEvent<'_>) {
        let origin = self.tracks.origin;
        for (list, states) in self.states.iter_mut().zip([event.before, event.after]) {
            list.clear();
            let states = event.balls.iter().zip(states);
            list.extend(states.map(|(&ball, state)| origin.in_file(shot, ball, state)));
        }
    }

    fn ball_meets_rail(&mut self, ball: u16, rail: Rail) {
        let outcome = &mut self.outcome;
        if self.contact {
            outcome.rails_after_first_contact.push((ball, rail));
        }
        let still_frozen = self.frozen.iter().any(|f| f.is_at(ball, rail));
        if !still_frozen && !among(&outcome.driven_to_rail, ball) {
            outcome.driven_to_rail.push(ball);
        }
        if outcome.cue_ball == Some(ball) {
            outcome.cue_ball_touched.push(Touched::Rail(rail));
        }
    }
}

/// The balls that ball `own` of a strike met itself, by their indices in the event, each with the
/// distance (m) that `own` had to move. A strike can also move balls through others.
fn met_during_strike<'e>(
    shot: &'e Shot,
    event: &'e TraceEvent<'_>,
    own: usize,
) -> impl Iterator<Item = (f64, usize)> + 'e {
    let ball = |k: usize| &shot.balls()[usize::from(event.balls[k])].ball;
    // Contacts of balls keep their momentum, so its sum has the direction of the strike.
    let momentum = (0..event.balls.len()).fold(Vec2::ZERO, |sum, k| {
        sum + (event.after[k].velocity - event.before[k].velocity).xy() * ball(k).mass
    });
    let impulse = momentum.length();
    let way = if impulse > 0.0 { momentum * (1.0 / impulse) } else { Vec2::ZERO };
    // An upper bound: while the tip is on the ball, the ball moves about half as far.
    let farthest = shot.physics().contact_times.tip * impulse / ball(own).mass;
    (0..event.balls.len()).filter(move |&k| k != own).filter_map(move |k| {
        let between = event.before[k].position - event.before[own].position;
        let radii = ball(k).radius + ball(own).radius;
        let gap = between.length() - radii;
        let ahead = way.dot(between.xy());
        let radicand = ahead * ahead - gap * (gap + 2.0 * radii);
        let meets = ahead > 0.0 && radicand >= 0.0 && gap <= TOUCH_TOLERANCE + farthest;
        meets.then(|| (ahead - crate::math::sqrt(radicand), k))
    })
}

/// The next ball after `last` that ball `own` of a contact of `balls` touches directly, in the
/// order of the gap between them (m), then of the index among `balls`. Most balls of a many-ball
/// contact do not touch each other directly. `before` are the balls' states, in the file's
/// coordinates.
fn next_touched(
    shot: &Shot,
    balls: &[u16],
    before: &[BallState],
    own: usize,
    last: Option<(f64, usize)>,
) -> Option<(f64, usize)> {
    let radius = |k: usize| shot.balls()[usize::from(balls[k])].ball.radius;
    let own_state = &before[own];
    let mut next: Option<(f64, usize)> = None;
    for (k, other) in before.iter().enumerate().filter(|(k, _)| *k != own) {
        let gap = (other.position - own_state.position).length() - radius(own) - radius(k);
        let speed = (other.velocity - own_state.velocity).length();
        // Every ball of a contact touches at least the nearest one.
        let touches = last.is_none() || gap <= TOUCH_TOLERANCE + CLOSING_TIME * speed;
        let is_after = last.is_none_or(|last| last < (gap, k));
        if touches && is_after && next.is_none_or(|next| (gap, k) < next) {
            next = Some((gap, k));
        }
    }
    next
}

/// Adds the balls of `shot` that hang over the edge of a hole to `hanging`; `last` are the final
/// states in the file's coordinates.
fn find_hanging(shot: &Shot, last: &[BallState], hanging: &mut Vec<(u16, PocketName)>) {
    let table = shot.table();
    let center = table.center();
    for ((i, state), placed) in (0u16..).zip(last).zip(shot.balls()) {
        let radius = placed.ball.radius;
        let on_bed = (state.position.z - radius).abs() <= TOUCH_TOLERANCE;
        if state.motion != MotionState::Stationary || !on_bed {
            continue;
        }
        let place = state.position.xy() - center;
        for pocket in &table.pockets {
            let (from_hole, reach) = (place - pocket.center, pocket.radius + radius);
            // The first two conditions follow from the last one, and cost less than its root.
            if from_hole.x.abs() < reach
                && from_hole.y.abs() < reach
                && from_hole.length() < reach
                && pocket.capture == Capture::DropCircle
            {
                hanging.push((i, pocket.name));
            }
        }
    }
}

/// Records the [`Outcome`] of a shot.
#[derive(Clone, Debug)]
pub struct OutcomeRecorder<'a> {
    shot: &'a Shot,
    memory: OutcomeMemory,
}

impl<'a> OutcomeRecorder<'a> {
    /// A recorder for one simulation of `shot`.
    pub fn new(shot: &'a Shot) -> Self {
        let mut memory = OutcomeMemory::default();
        memory.restart(shot);
        Self { shot, memory }
    }

    /// The outcome of the events so far.
    pub const fn so_far(&self) -> &Outcome {
        &self.memory.outcome
    }

    /// The outcome, once `last` are the balls' final states in the engine's coordinates.
    pub fn finish(mut self, last: &[BallState]) -> Outcome {
        let in_file = |(i, state)| self.shot.to_file_coordinates(i, state);
        let last: Vec<_> = last.iter().enumerate().map(in_file).collect();
        self.memory.finish(self.shot, &last);
        self.memory.outcome
    }
}

impl Recorder for OutcomeRecorder<'_> {
    fn record(&mut self, event: &Event<'_>) {
        self.memory.record(self.shot, event);
    }
}

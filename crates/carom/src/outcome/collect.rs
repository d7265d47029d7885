//! Collecting an [`Outcome`] from the events of a shot.

use alloc::vec::Vec;

use super::frozen::Frozen;
use super::jump::Jumps;
use super::track::Track;
use super::{Outcome, Touched, among};
use crate::event::{Event, Recorder};
use crate::math::Vec2;
use crate::motion::Path;
use crate::shot::Shot;
use crate::simulate::CLOSING_TIME;
use crate::table::{Capture, Part, PocketName, Rail, TOUCH_TOLERANCE};
use crate::trace_event::{TraceEvent, TraceEventKind};
use crate::{BallState, MotionState};

/// Collects an [`Outcome`] event by event.
#[derive(Clone, Debug)]
pub struct Collector<'a> {
    shot: &'a Shot,
    outcome: Outcome,
    /// Whether the cue ball has touched a ball; without a cue ball, whether any two balls have
    /// collided.
    contact: bool,
    tracks: Vec<Track>,
    frozen: Vec<Frozen>,
    jumps: Jumps,
}

impl<'a> Collector<'a> {
    /// A collector for one simulation of `shot`.
    pub fn new(shot: &'a Shot) -> Self {
        let cue_ball = shot.cue_ball().and_then(|i| u16::try_from(i).ok());
        let mut collector = Self {
            shot,
            outcome: Outcome { cue_ball, ..Outcome::default() },
            contact: false,
            tracks: Vec::with_capacity(shot.balls().len()),
            frozen: Frozen::find(shot),
            jumps: Jumps::default(),
        };
        for (i, placed) in (0u16..).zip(shot.balls()) {
            let track = collector.track(i, 0.0, &placed.state);
            collector.jumps.begin(i, track.path.motion, &[]);
            collector.tracks.push(track);
        }
        collector
    }

    /// Adds the next event.
    pub fn add(&mut self, event: &TraceEvent<'_>) {
        self.outcome.events += 1;
        for &ball in event.balls {
            let track = &self.tracks[usize::from(ball)];
            for frozen in self.frozen.iter_mut().filter(|f| f.ball == ball) {
                frozen.follow(&track.path, (event.time - track.since).max(0.0));
            }
        }
        self.jumps.end(event, &self.tracks, &mut self.outcome.jumped);
        match event.kind {
            TraceEventKind::BallCollision => self.balls_collide(event),
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
                self.cue_strikes(event);
            }
            TraceEventKind::SlateCollision
            | TraceEventKind::RailCollision { part: Part::Top | Part::Liner, .. }
            | TraceEventKind::MotionTransition { .. } => {}
        }
        for (&ball, after) in event.balls.iter().zip(event.after) {
            self.tracks[usize::from(ball)] = self.track(ball, event.time, after);
            self.jumps.begin(ball, after.motion, event.balls);
        }
    }

    /// The outcome, once `last` are the balls' final states in the file's frame.
    pub fn finish(mut self, last: &[BallState]) -> Outcome {
        let at_rest = |s: &BallState| s.motion == MotionState::Stationary || !s.motion.in_play();
        let restless = (0u16..).zip(last).filter(|(_, s)| !at_rest(s)).map(|(i, _)| i);
        self.outcome.never_resting.extend(restless);
        self.outcome.hanging = self.hanging(last);
        self.outcome
    }

    fn track(&self, ball: u16, since: f64, state: &BallState) -> Track {
        let ball = &self.shot.balls()[usize::from(ball)].ball;
        let physics = self.shot.physics();
        Track { since, path: Path::new(state, ball, &physics.cloth, physics.gravity) }
    }

    fn balls_collide(&mut self, event: &TraceEvent<'_>) {
        let Some(cue) = self.outcome.cue_ball else {
            self.contact = true;
            return;
        };
        let Some(own) = event.balls.iter().position(|&ball| ball == cue) else { return };
        self.contact = true;
        let mut last = None;
        while let Some((gap, k)) = self.next_touched(event, own, last) {
            let other = event.balls[k];
            self.outcome.first_contact = self.outcome.first_contact.or(Some(other));
            self.outcome.cue_ball_touched.push(Touched::Ball(other));
            last = Some((gap, k));
        }
    }

    /// The cue strikes the cue ball, which may meet balls at the same instant.
    fn cue_strikes(&mut self, event: &TraceEvent<'_>) {
        let Some(cue) = self.outcome.cue_ball else { return };
        let Some(own) = event.balls.iter().position(|&ball| ball == cue) else { return };
        let mut met: Vec<(f64, u16)> = self.met_during_strike(event, own).collect();
        met.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (_, other) in met {
            self.contact = true;
            self.outcome.first_contact = self.outcome.first_contact.or(Some(other));
            self.outcome.cue_ball_touched.push(Touched::Ball(other));
            self.outcome.met_during_strike.push(other);
        }
    }

    /// The balls that ball `own` of a strike met itself, each with the distance (m) that `own` had
    /// to move. A strike can also move balls through others.
    fn met_during_strike<'e>(
        &'e self,
        event: &'e TraceEvent<'_>,
        own: usize,
    ) -> impl Iterator<Item = (f64, u16)> + 'e {
        let ball = |k: usize| &self.shot.balls()[usize::from(event.balls[k])].ball;
        // Contacts of balls keep their momentum, so its sum has the direction of the strike.
        let momentum = (0..event.balls.len()).fold(Vec2::ZERO, |sum, k| {
            sum + (event.after[k].velocity - event.before[k].velocity).xy() * ball(k).mass
        });
        let impulse = momentum.length();
        let way = if impulse > 0.0 { momentum * (1.0 / impulse) } else { Vec2::ZERO };
        // An upper bound: while the tip is on the ball, the ball moves about half as far.
        let farthest = self.shot.physics().contact_times.tip * impulse / ball(own).mass;
        (0..event.balls.len()).filter(move |&k| k != own).filter_map(move |k| {
            let between = event.before[k].position - event.before[own].position;
            let radii = ball(k).radius + ball(own).radius;
            let gap = between.length() - radii;
            let ahead = way.dot(between.xy());
            let radicand = ahead * ahead - gap * (gap + 2.0 * radii);
            let meets = ahead > 0.0 && radicand >= 0.0 && gap <= TOUCH_TOLERANCE + farthest;
            meets.then(|| (ahead - crate::math::sqrt(radicand), event.balls[k]))
        })
    }

    /// The next ball after `last` that ball `own` of a contact touches directly, in the order of
    /// the gap between them (m), then of the index in the event. Most balls of a many-ball contact
    /// do not touch each other directly.
    fn next_touched(
        &self,
        event: &TraceEvent<'_>,
        own: usize,
        last: Option<(f64, usize)>,
    ) -> Option<(f64, usize)> {
        let radius = |k: usize| self.shot.balls()[usize::from(event.balls[k])].ball.radius;
        let own_state = &event.before[own];
        let mut next: Option<(f64, usize)> = None;
        for (k, other) in event.before.iter().enumerate().filter(|(k, _)| *k != own) {
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

    fn hanging(&self, last: &[BallState]) -> Vec<(u16, PocketName)> {
        let table = self.shot.table();
        let center = table.center();
        let mut hanging = Vec::new();
        for ((i, state), placed) in (0u16..).zip(last).zip(self.shot.balls()) {
            let radius = placed.ball.radius;
            let on_bed = (state.position.z - radius).abs() <= TOUCH_TOLERANCE;
            if state.motion != MotionState::Stationary || !on_bed {
                continue;
            }
            let distance = |hole: Vec2| (state.position.xy() - center - hole).length();
            let holes = table.pockets.iter().filter(|p| p.capture == Capture::DropCircle);
            hanging.extend(
                holes
                    .filter(|hole| distance(hole.center) < hole.radius + radius)
                    .map(|hole| (i, hole.name)),
            );
        }
        hanging
    }
}

/// Records the [`Outcome`] of a shot.
#[derive(Clone, Debug)]
pub struct OutcomeRecorder<'a> {
    collector: Collector<'a>,
    before: Vec<BallState>,
    after: Vec<BallState>,
}

impl<'a> OutcomeRecorder<'a> {
    /// A recorder for one simulation of `shot`.
    pub fn new(shot: &'a Shot) -> Self {
        Self { collector: Collector::new(shot), before: Vec::new(), after: Vec::new() }
    }

    /// The outcome of the events so far.
    pub const fn so_far(&self) -> &Outcome {
        &self.collector.outcome
    }

    /// The outcome, once `last` are the balls' final states in the engine's frame.
    pub fn finish(self, last: &[BallState]) -> Outcome {
        let shot = self.collector.shot;
        let last: Vec<_> = last.iter().enumerate().map(|(i, s)| shot.to_file_frame(i, s)).collect();
        self.collector.finish(&last)
    }
}

impl Recorder for OutcomeRecorder<'_> {
    fn record(&mut self, event: &Event<'_>) {
        let Self { collector, before, after } = self;
        let shot = collector.shot;
        for (list, states) in [(&mut *before, event.before), (&mut *after, event.after)] {
            list.clear();
            let balls = event.balls.iter().map(|&i| usize::from(i));
            list.extend(balls.zip(states).map(|(i, state)| shot.to_file_frame(i, state)));
        }
        collector.add(&TraceEvent {
            time: event.time,
            kind: TraceEventKind::of(event.kind, shot.table()),
            balls: event.balls,
            before,
            after,
        });
    }
}

//! The events of a trace as arrays.

use carom::Trace;
use carom::math::Vec3;
use carom::trace::{TraceEvent, TraceEventKind};

use crate::kinds::{self, CAROM_NONE};
use crate::state::carom_motion;

/// An event of a trace. Its balls and points stand in the arrays of carom_events.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_event {
    /// Time since the strike, s.
    pub time: f64,
    /// The largest impulse that a ball gets, N s: the strength of its sound. 0 if nothing meets.
    pub strength: f64,
    /// CAROM_CUE_STRIKE to CAROM_MOTION_TRANSITION.
    pub kind: i32,
    /// Index of its first ball in carom_events.balls.
    pub first_ball: i32,
    /// Number of its balls.
    pub ball_count: i32,
    /// Index of its first point of contact in carom_events.points.
    pub first_point: i32,
    /// Number of its points of contact; in a strike that of the tip comes first.
    pub point_count: i32,
    /// CAROM_BOTTOM to CAROM_RIGHT_UPPER of a rail collision, or CAROM_NONE.
    pub rail: i32,
    /// CAROM_NOSE to CAROM_LINER of a rail collision, or CAROM_NONE.
    pub part: i32,
    /// Index of the pocket on the table that the ball falls into, or CAROM_NONE.
    pub pocket: i32,
    /// The motion that ends in a motion transition, or CAROM_NONE.
    pub from: i32,
    /// The motion that follows, or CAROM_NONE.
    pub to: i32,
    /// How often the tip met the cue ball in a strike; more than one contact is a double hit.
    pub tip_contacts: i32,
    /// 1 if the cue ball met another ball in the strike while the tip was on it.
    pub pushed: i32,
}

/// A ball of an event.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_event_ball {
    /// What the ball gets in the impact, N s; zero if nothing meets.
    pub impulse: [f64; 3],
    /// The ball just before.
    pub before: carom_motion,
    /// The ball just after.
    pub after: carom_motion,
    /// Its index in the shot.
    pub ball: i32,
}

/// The events of a trace. The arrays belong to the trace, and live as long.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_events {
    /// The events in order; null if there are none.
    pub events: *const carom_event,
    /// The balls of all events; null if there are none.
    pub balls: *const carom_event_ball,
    /// The points of contact, m: x, y, z of each; null if there are none.
    pub points: *const f64,
    /// Number of events.
    pub event_count: i32,
    /// Number of entries in balls.
    pub ball_count: i32,
    /// Number of points; the array has three numbers for each.
    pub point_count: i32,
}

/// The arrays behind a [`carom_events`].
#[derive(Debug, Default)]
pub(crate) struct EventArrays {
    events: Vec<carom_event>,
    balls: Vec<carom_event_ball>,
    points: Vec<[f64; 3]>,
}

impl EventArrays {
    pub(crate) fn new(trace: &Trace) -> Self {
        let mut arrays = Self::default();
        for event in trace.events() {
            arrays.push(trace, &event);
        }
        arrays
    }

    fn push(&mut self, trace: &Trace, event: &TraceEvent<'_>) {
        let impulses = trace.impulses(event);
        let points = trace.contact_points(event);
        let strongest = impulses.iter().map(|impulse| impulse.length()).fold(0.0, f64::max);
        let mut written = carom_event {
            time: event.time,
            strength: strongest,
            kind: kinds::event_kind(event.kind),
            first_ball: self.balls.len() as i32,
            ball_count: event.balls.len() as i32,
            first_point: self.points.len() as i32,
            point_count: points.len() as i32,
            rail: CAROM_NONE,
            part: CAROM_NONE,
            pocket: CAROM_NONE,
            from: CAROM_NONE,
            to: CAROM_NONE,
            tip_contacts: 0,
            pushed: 0,
        };
        match event.kind {
            TraceEventKind::CueStrike { tip_contacts, pushed } => {
                (written.tip_contacts, written.pushed) = (tip_contacts.into(), pushed.into());
            }
            TraceEventKind::RailCollision { rail, part } => {
                (written.rail, written.part) = (kinds::rail(rail), kinds::part(part));
            }
            TraceEventKind::PocketCollision(pocket) => {
                written.pocket = kinds::pocket(trace.shot().table(), pocket);
            }
            TraceEventKind::MotionTransition { from, to } => {
                (written.from, written.to) = (from as i32, to as i32);
            }
            _ => {}
        }
        self.events.push(written);
        self.points.extend(points.iter().map(|point| point.to_array()));
        for (k, &ball) in event.balls.iter().enumerate() {
            self.balls.push(carom_event_ball {
                impulse: impulses.get(k).copied().unwrap_or(Vec3::ZERO).to_array(),
                before: (&event.before[k]).into(),
                after: (&event.after[k]).into(),
                ball: ball.into(),
            });
        }
    }

    pub(crate) const fn to_c(&self) -> carom_events {
        carom_events {
            events: pointer(self.events.as_slice()),
            balls: pointer(self.balls.as_slice()),
            points: pointer(self.points.as_slice()).cast(),
            event_count: self.events.len() as i32,
            ball_count: self.balls.len() as i32,
            point_count: self.points.len() as i32,
        }
    }
}

const fn pointer<T>(values: &[T]) -> *const T {
    if values.is_empty() { std::ptr::null() } else { values.as_ptr() }
}

//! The first difference of two traces.

use alloc::format;
use alloc::string::String;

use super::{Trace, TraceEvent};
use crate::BallState;

impl Trace {
    /// The first place where `self` and `again` differ in any bit, in one sentence; `None` if all
    /// events, the duration, the end and all final states are equal.
    pub fn first_difference(&self, again: &Self) -> Option<String> {
        for (i, (a, b)) in self.events().zip(again.events()).enumerate() {
            if let Some(difference) = in_event(&a, &b) {
                return Some(format!("events[{i}].{difference}"));
            }
        }
        let (n, m) = (self.events().len(), again.events().len());
        if n != m {
            return Some(format!("events: {n} against {m}"));
        }
        if self.duration.to_bits() != again.duration.to_bits() {
            return Some(format!("duration: {:?} against {:?}", self.duration, again.duration));
        }
        if self.end != again.end {
            let (ours, theirs) = (self.end.name(), again.end.name());
            return Some(format!("end: {ours} against {theirs}"));
        }
        in_states("final", &self.last, &again.last)
    }
}

fn in_event(a: &TraceEvent<'_>, b: &TraceEvent<'_>) -> Option<String> {
    if a.time.to_bits() != b.time.to_bits() {
        return Some(format!("time: {:?} against {:?}", a.time, b.time));
    }
    if a.kind != b.kind {
        return Some(format!("type: {:?} against {:?}", a.kind, b.kind));
    }
    if a.balls != b.balls {
        return Some(format!("balls: numbers {:?} against {:?}", a.balls, b.balls));
    }
    in_states("before", a.before, b.before).or_else(|| in_states("after", a.after, b.after))
}

fn in_states(key: &str, a: &[BallState], b: &[BallState]) -> Option<String> {
    a.iter()
        .zip(b)
        .enumerate()
        .find_map(|(i, (a, b))| Some(format!("{key}[{i}].{}", in_state(a, b)?)))
}

fn in_state(a: &BallState, b: &BallState) -> Option<String> {
    let vectors = |s: &BallState| {
        [
            ("position", s.position),
            ("velocity", s.velocity),
            ("angular_velocity", s.angular_velocity),
        ]
        .map(|(key, v)| (key, v.to_array()))
    };
    for ((key, u), (_, v)) in vectors(a).into_iter().zip(vectors(b)) {
        if u.map(f64::to_bits) != v.map(f64::to_bits) {
            return Some(format!("{key}: {u:?} against {v:?}"));
        }
    }
    let (a, b) = (a.motion, b.motion);
    (a != b).then(|| format!("motion: {} against {}", a.name(), b.name()))
}

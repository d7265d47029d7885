//! Jumps: balls that fly over other balls.

use alloc::vec::Vec;

use carom_roots::Motion;

use super::track::{Track, Tracks};
use super::{VISIBLE_GAP, among};
use crate::MotionState;
use crate::math::sqrt;
use crate::shot::Shot;
use crate::trace_event::TraceEvent;

/// The flights in progress. A flight is a ball's path in the air from one of its events to the
/// next.
#[derive(Clone, Debug, Default)]
pub(super) struct Jumps {
    /// Balls in the air.
    airborne: Vec<u16>,
    /// Pairs of an airborne ball and a ball that it touched at take-off.
    touched: Vec<(u16, u16)>,
    /// Pairs of an airborne ball and a ball that it has been above.
    over: Vec<(u16, u16)>,
}

impl Jumps {
    /// Begins again, without flights.
    pub(super) fn restart(&mut self) {
        self.airborne.clear();
        self.touched.clear();
        self.over.clear();
    }

    /// Begins a path of `ball` at an event of `balls`.
    #[inline]
    pub(super) fn begin(&mut self, ball: u16, motion: MotionState, balls: &[u16]) {
        if motion == MotionState::Airborne {
            self.airborne.push(ball);
            self.touched.extend(balls.iter().filter(|&&b| b != ball).map(|&b| (ball, b)));
        }
    }

    /// Whether no ball is in the air.
    #[inline]
    pub(super) fn is_empty(&self) -> bool {
        self.airborne.is_empty()
    }

    /// Ends the paths of the balls of `event` of `shot`. Adds the jumps that are then certain to
    /// `jumped`.
    pub(super) fn end(
        &mut self,
        shot: &Shot,
        event: &TraceEvent<'_>,
        tracks: &Tracks,
        jumped: &mut Vec<(u16, u16)>,
    ) {
        for &flyer in &self.airborne {
            let ends = among(event.balls, flyer);
            let flight = tracks.of(shot, flyer);
            for under in 0..shot.balls().len() as u16 {
                if (ends || among(event.balls, under))
                    && under != flyer
                    && !self.over.contains(&(flyer, under))
                    && passes_over(&flight, &tracks.of(shot, under), event.time)
                {
                    self.over.push((flyer, under));
                }
            }
        }
        for &(flyer, under) in &self.over {
            let pair = (flyer, under);
            if among(event.balls, flyer)
                && !among(event.balls, under)
                && !self.touched.contains(&pair)
                && !jumped.contains(&pair)
            {
                jumped.push(pair);
            }
        }
        let stays = |ball: &u16| !among(event.balls, *ball);
        self.airborne.retain(stays);
        self.touched.retain(|(flyer, _)| stays(flyer));
        self.over.retain(|(flyer, _)| stays(flyer));
    }
}

/// Whether `flyer` is above `under`, and [`VISIBLE_GAP`] closer in plan than balls that touch on
/// the cloth, at any time from the start of both paths to `until` (s).
fn passes_over(flyer: &Track, under: &Track, until: f64) -> bool {
    let from = flyer.since.max(under.since);
    if !under.path.motion.in_play() || until <= from {
        return false;
    }
    let touching = flyer.path.radius + under.path.radius;
    let distance = touching - VISIBLE_GAP;
    // The balls do not overlap in space, so the flyer must be at least this much higher.
    let height = sqrt(touching * touching - distance * distance);
    let lowest = [from, until].map(|t| under.path.position_at(t - under.since).z);
    if flyer.apex() - lowest[0].min(lowest[1]) < height {
        return false;
    }
    let separation = |t: f64| {
        let [p, q] = [flyer, under].map(|track| track.path.position_at(t - track.since));
        p - q
    };
    let [v, w] = [flyer, under].map(|track| track.path.velocity_at(from - track.since));
    let h = flyer.path.half_acceleration - under.path.half_acceleration;
    let d = separation(from);
    let plan = Motion { d: [d.x, d.y], v: [v.x - w.x, v.y - w.y], h: [h.x, h.y] };
    let entry = if d.xy().length() < distance {
        Some(0.0)
    } else {
        carom_roots::first_contact(&plan, distance, until - from)
    };
    entry.is_some_and(|t| separation(from + t).z > 0.0)
}

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
    /// Radius of the smallest ball, m. The centre of a ball that is not in the air is at least as
    /// high, except for the last nanometre.
    smallest: f64,
}

impl Jumps {
    /// Begins again with the balls of `shot`, without flights.
    pub(super) fn restart(&mut self, shot: &Shot) {
        let radii = shot.balls().iter().map(|placed| placed.ball.radius);
        self.smallest = radii.fold(f64::INFINITY, |a, b| if b < a { b } else { a });
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

    /// Adds the pair of `flyer` and `under` to `over`, if `event` ends a path of one of them and the
    /// one has flown over the other on these paths.
    fn compare(
        &mut self,
        shot: &Shot,
        event: &TraceEvent<'_>,
        tracks: &Tracks,
        [flyer, under]: [u16; 2],
    ) {
        if (among(event.balls, flyer) || among(event.balls, under))
            && under != flyer
            && !self.over.contains(&(flyer, under))
            && passes_over(&tracks.of(shot, flyer), &tracks.of(shot, under), event.time)
        {
            self.over.push((flyer, under));
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
        for k in 0..self.airborne.len() {
            let flyer = self.airborne[k];
            let (apex, radius) = tracks.apex(shot, flyer);
            if !is_low(apex - self.smallest, radius + self.smallest) {
                let all = 0..shot.balls().len() as u16;
                all.for_each(|under| self.compare(shot, event, tracks, [flyer, under]));
            } else if self.airborne.len() > 1 {
                // A hop: only a ball that bounces or falls too could be low enough.
                let others = 0..self.airborne.len();
                others.for_each(|k| self.compare(shot, event, tracks, [flyer, self.airborne[k]]));
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

/// The square of the least difference in height, m², between balls whose centres have the distance
/// `touching` (m) in contact and that overlap in plan by [`VISIBLE_GAP`]: they do not overlap in
/// space.
fn least_rise_squared(touching: f64) -> f64 {
    let distance = touching - VISIBLE_GAP;
    touching * touching - distance * distance
}

/// Whether a flight that rises by `rise` (m) above the height of another ball is too low for a jump
/// over it, as most hops are. Conservative, by tens of micrometres: [`passes_over`] decides.
fn is_low(rise: f64, touching: f64) -> bool {
    rise <= 0.0 || rise * rise < 0.98 * least_rise_squared(touching)
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
    let height = sqrt(least_rise_squared(touching));
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

//! From a line to the azimuth that pots its ball, by simulation.
//!
//! A [`LineRecorder`] measures how far the object ball's path passes the pocket. The secant method
//! finds the azimuth at which it does not: usually two or three simulations, one if the azimuth of
//! a similar strike is known.

use carom::Error;
use carom::MotionState;
use carom::event::{Event, EventKind, Recorder};
use carom::math::Vec2;
use carom::resolve::cue_ball::Strike;
use carom_rules::BallIndex;

use crate::line::Line;
use carom_plan::{Prepared, Sampler};

/// Most simulations for one strike.
const MOST_PLAYS: u32 = 5;
/// Share of the line's tolerance within which an azimuth is good enough. The error that remains is
/// small beside the player's.
const CLOSE: f64 = 0.15;
/// Largest change of an azimuth in one step, rad: six degrees. Throw and squirt are smaller.
const LARGEST_STEP: f64 = 0.1;

/// Paths count as at least this long, m: the turn to a target beside the ball has no limit.
const SHORTEST: f64 = 0.1;

/// Where the ball of a line's leg moved after the last event that the line expects.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LineMiss {
    /// Number of the leg.
    pub(crate) leg: usize,
    /// Distance by which the target lies to the left of the ball's path, m.
    pub(crate) miss: f64,
}

/// Follows the balls of a line.
pub(crate) struct LineRecorder<'a> {
    line: &'a Line,
    /// Index in the shot of each leg's ball.
    balls: [u16; 3],
    pocket: u8,
    leg: usize,
    cushions: u8,
    /// Whether the balls have left the line.
    is_off: bool,
    measured: Option<LineMiss>,
    /// Whether the object ball fell into the line's pocket.
    is_potted: bool,
}

impl<'a> LineRecorder<'a> {
    /// None if a ball of the line is not in the shot.
    pub(crate) fn new(line: &'a Line, prepared: &Prepared<'_>) -> Option<Self> {
        let mut balls = [0; 3];
        for (slot, leg) in balls.iter_mut().zip(line.legs()) {
            *slot = index_in_shot(prepared, leg.ball)?;
        }
        let pocket = line.pocket as u8;
        let (leg, cushions, is_off) = (0, 0, false);
        Some(Self { line, balls, pocket, leg, cushions, is_off, measured: None, is_potted: false })
    }

    /// Where the balls went; none if no ball moved as the line expects.
    pub(crate) const fn line_miss(&self) -> Option<LineMiss> {
        self.measured
    }

    pub(crate) const fn is_potted(&self) -> bool {
        self.is_potted
    }

    /// Measures the path of the present leg's ball if it has met all cushions of the leg.
    fn measure(&mut self, event: &Event<'_>) {
        let leg = &self.line.legs()[self.leg];
        let Some(k) = event.balls.iter().position(|ball| *ball == self.balls[self.leg]) else {
            return;
        };
        let (place, velocity) = (event.after[k].position.xy(), event.after[k].velocity.xy());
        let speed = velocity.length();
        if self.cushions == leg.cushions && speed > 0.0 {
            let to_target: Vec2 = leg.target - place;
            let miss = velocity.cross(to_target) * (1.0 / speed);
            self.measured = Some(LineMiss { leg: self.leg, miss });
        }
    }
}

impl Recorder for LineRecorder<'_> {
    fn record(&mut self, event: &Event<'_>) {
        let ball = self.balls[self.leg];
        if self.is_off && !matches!(event.kind, EventKind::PocketCollision(_)) {
            return;
        }
        let legs = self.line.legs();
        match event.kind {
            EventKind::CueStrike { .. } | EventKind::BallCollision
                if event.balls.contains(&ball) || event.balls.len() > 2 =>
            {
                if !event.balls.contains(&ball) {
                    return;
                }
                let next = self.leg + 1;
                let starts = matches!(event.kind, EventKind::CueStrike { .. });
                if next < legs.len()
                    && self.cushions == legs[self.leg].cushions
                    && event.balls.contains(&self.balls[next])
                {
                    self.leg = next;
                    self.cushions = 0;
                    self.measure(event);
                } else if starts {
                    self.measure(event);
                } else {
                    self.is_off = true;
                }
            }
            EventKind::RailCollision(_) if event.balls[0] == ball => {
                self.cushions += 1;
                if self.cushions > legs[self.leg].cushions {
                    self.is_off = true;
                } else {
                    self.measure(event);
                }
            }
            // A ball that leaves a cushion slides, and its way bends until it rolls.
            EventKind::MotionTransition { to: MotionState::Rolling, .. }
                if event.balls[0] == ball && legs[self.leg].cushions > 0 =>
            {
                self.measure(event);
            }
            EventKind::PocketCollision(pocket) => {
                let object = self.balls[legs.len() - 1];
                self.is_potted |= pocket == self.pocket && event.balls[0] == object;
            }
            _ => {}
        }
    }
}

/// The index in the shot of the frame's ball `ball`.
pub(crate) fn index_in_shot(prepared: &Prepared<'_>, ball: BallIndex) -> Option<u16> {
    u16::try_from(prepared.balls().iter().position(|index| *index == ball)?).ok()
}

/// A strike that sends the balls along a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Aimed {
    /// The strike.
    pub strike: Strike,
    /// Distance by which the pocket lies to the left of the object ball's path, m.
    pub miss: f64,
    /// Whether the ball fell.
    pub is_potted: bool,
    /// Change of the miss per azimuth, m per rad.
    pub slope: f64,
}

/// A strike with which the aiming along a line starts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AimStart {
    pub strike: Strike,
    /// Change of the miss per azimuth, m per rad, as far as is known.
    pub slope: f64,
}

/// The azimuth at which `start` sends the object ball of `line` into its pocket: changes the
/// azimuth until it does, or until no more simulations are allowed. Returns the best strike and
/// counts the simulations in `plays`. The last simulation in `sampler` is that of the returned
/// strike. None if the balls do not follow the line.
///
/// # Errors
/// As [`Sampler::simulate`], except that a strike that cannot be played gives none.
pub(crate) fn aim(
    sampler: &mut Sampler,
    prepared: &Prepared<'_>,
    line: &Line,
    start: AimStart,
    plays: &mut u64,
) -> Result<Option<Aimed>, Error> {
    let AimStart { mut strike, mut slope } = start;
    let close = CLOSE * line.tolerance * line.slope.abs();
    let mut before: Option<(f64, f64)> = None;
    for round in 1..=MOST_PLAYS {
        let Some(mut recorder) = LineRecorder::new(line, prepared) else { return Ok(None) };
        match sampler.simulate_recorded(prepared, &strike, &mut recorder) {
            Ok(()) => *plays += 1,
            Err(Error::Input(_)) => return Ok(None),
            Err(error) => return Err(error),
        }
        let Some(LineMiss { leg, miss }) = recorder.line_miss() else { return Ok(None) };
        let is_last = leg + 1 == line.legs().len();
        let is_potted = recorder.is_potted();
        if is_last && (miss.abs() <= close || (is_potted && round == MOST_PLAYS)) {
            return Ok(Some(Aimed { strike, miss, is_potted, slope }));
        }
        let step = if is_last {
            if let Some((azimuth, then)) = before {
                let measured = (miss - then) / (strike.azimuth - azimuth);
                // Keep the sign of geometry: the other one would run away from the pocket.
                if measured.is_finite() && measured * line.slope > 0.0 {
                    slope = measured;
                }
            }
            before = Some((strike.azimuth, miss));
            -miss / slope
        } else {
            towards_target(line, leg, miss, slope)
        };
        strike.azimuth += step.clamp(-LARGEST_STEP, LARGEST_STEP);
        // The elevation hardly depends on so small a turn.
    }
    Ok(None)
}

/// The change of the azimuth (rad) that turns the ball of a leg before the last to its target, which
/// it passes at a distance of `miss` (m).
fn towards_target(line: &Line, leg: usize, miss: f64, slope: f64) -> f64 {
    let length = line.lengths[usize::from(leg > 0)].max(SHORTEST);
    match (leg, line.legs()[leg].cushions) {
        (0, 0) => miss / length,
        // The cushion mirrors the turn.
        (0, _) => -miss / length,
        // A ball that is cut turns the other way.
        _ => -miss / slope.abs().max(length),
    }
}

//! Candidates that pot a ball: a lattice of speed × height × side on every line.

use core::f64::consts::TAU;

use carom::Error;
use carom::math::{exp, log, sin_cos, sqrt};
use carom::resolve::cue_ball::Strike;
use carom_rules::Call;

use super::candidate::PlayKind;
use super::explore::{CuePlace, Explorer, FoundPlay, raised};
use super::strike_errors::largest_offset;
use super::windows::MeantPot;
use crate::aim::{AimStart, aim};
use crate::line::{self, Line, LineKind};
use crate::scene::Scene;
use crate::targets::call_of;
use carom_plan::Prepared;

/// Cue speeds, m/s, from a ball that hangs in the pocket to a stroke along the table and back.
const SPEEDS: [f64; 9] = [0.35, 0.5, 0.7, 1.0, 1.4, 2.0, 2.8, 4.0, 5.6];
/// Heights and sides of the tip, as shares of the largest offset that is used. Draw and follow
/// change most of the cue ball's way; side changes it after a cushion.
const HEIGHTS: [f64; 5] = [0.0, -0.85, 0.85, -0.45, 0.45];
const SIDES: [f64; 3] = [0.0, -0.7, 0.7];
/// Number of the heights in the coarse lattice, the first ones.
const COARSE_HEIGHTS: usize = 3;
/// Number of strikes of the coarse lattice.
const COARSE: usize = COARSE_HEIGHTS * (SPEEDS.len() / 2);
/// Lines that are less probable than this are not tried. For a decision neither are those that are less probable
/// than this share of the most probable one; a list has them.
const LEAST_CHANCE: f64 = 0.02;
const LEAST_SHARE: f64 = 0.5;
/// A ball that is on its way into the pocket but does not fall was too slow, if the cue was slower than this
/// multiple of the least speed by geometry. A faster ball has bounced off a jaw.
const SLOW: f64 = 2.5;
/// Number of lines that are tried, the most probable.
const MOST_LINES: usize = 14;
/// Share of the tolerance by which a missed shot is turned to value what it leaves.
const MISS: f64 = 1.6;
/// Least and greatest speed of further strikes, m/s.
const LIMITS: [f64; 2] = [0.35, 7.0];
/// Difference of the priors by which a line gets a third of the further strikes of another: for a decision, and
/// for a list, which wants the best play of every line.
const SPREAD: [f64; 2] = [0.1, 0.4];
/// The additive recurrence of Roberts (2018) in four dimensions: powers of 1/φ₄, where φ₄ is the
/// real root of x⁵ = x + 1.
const STEPS: [f64; 4] = [
    0.856_674_883_854_502_9,
    0.733_891_856_627_126,
    0.628_706_721_037_808_6,
    0.538_597_257_223_612_5,
];

/// A line of a prepared position, and what the exploration has learned about it.
#[derive(Clone, Debug)]
pub(crate) struct KnownLine {
    pub(crate) line: Line,
    /// Number of the prepared position.
    pub(crate) place: usize,
    /// The estimated chance of the pot.
    chance: f64,
    /// The turn of the azimuth from geometry's, and the slope of the miss, of the last strike that
    /// potted the ball.
    turned: Option<(f64, f64)>,
    /// The least speed of the cue ball by geometry, m/s.
    least_speed: f64,
    /// The highest speed of the cue at which the ball does not reach the pocket, as far as is known, m/s.
    too_slow: f64,
    /// The value of a missed shot by its speed, of those that were tried.
    missed: [Option<f64>; SPEEDS.len()],
    /// The highest prior of a play on this line.
    best: f64,
    /// Number of strikes of the coarse lattice that were tried.
    tried: usize,
}

impl KnownLine {
    /// Whether a strike on this line has potted its ball.
    pub(crate) const fn is_made(&self) -> bool {
        self.best > 0.0
    }
}

impl Explorer<'_> {
    /// The lines of a prepared position that a search tries, the most probable first.
    pub(crate) fn lines(&self, at: CuePlace<'_>) -> Vec<KnownLine> {
        let mut lines = self.all_lines(at);
        lines.truncate(MOST_LINES);
        lines
    }

    /// All lines of a prepared position that are probable enough, the most probable first.
    pub(crate) fn all_lines(&self, at: CuePlace<'_>) -> Vec<KnownLine> {
        let CuePlace { number: place, prepared } = at;
        let scene = Scene::of(prepared);
        let mut lines = Vec::new();
        line::direct(&scene, &self.targets, &mut lines);
        line::combinations(&scene, &self.targets, &mut lines);
        line::banks(&scene, &self.targets, &mut lines);
        line::kicks(&scene, &self.targets, &mut lines);
        let noise = self.task.noise();
        let radius = scene.ball(self.task.turn.cue).map_or(0.03, |ball| ball.radius);
        let physics = prepared.shot().physics();
        let rolling = physics.gravity * physics.cloth.rolling_friction.at(SPEEDS[0]);
        let known = |line: Line| {
            let (chance, least_speed) = (line.chance(noise, radius), line.least_speed(rolling));
            let (missed, too_slow) = ([None; SPEEDS.len()], least_speed);
            let (turned, best, tried) = (None, 0.0, 0);
            KnownLine { line, place, chance, turned, least_speed, too_slow, missed, best, tried }
        };
        let mut rated: Vec<KnownLine> = lines.into_iter().map(known).collect();
        let best = rated.iter().map(|known| known.chance).fold(0.0, f64::max);
        let share = if self.is_list { 0.0 } else { LEAST_SHARE };
        rated.retain(|known| known.chance > LEAST_CHANCE.max(share * best));
        rated.sort_by(|a, b| b.chance.total_cmp(&a.chance));
        rated
    }

    /// Adds the strikes that pot a ball from one prepared position: first those of the coarse lattice on every
    /// line, then the rest of it while simulations are left.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn pots(
        &mut self,
        prepared: &Prepared<'_>,
        lines: &mut [KnownLine],
        until: u64,
    ) -> Result<(), Error> {
        for upto in self.coarse_steps() {
            for known in lines.iter_mut() {
                self.coarse_pots(prepared, known, upto, until)?;
            }
        }
        for known in lines.iter_mut().filter(|known| known.is_made()) {
            for speed in 0..SPEEDS.len() {
                for height in 0..HEIGHTS.len() {
                    for side in 0..SIDES.len() {
                        let is_coarse = speed % 2 == 1 && height < COARSE_HEIGHTS && side == 0;
                        if !is_coarse && self.bench.plays < until {
                            self.lattice_pot(prepared, known, [speed, height, side])?;
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// Adds the strikes of the coarse lattice that pot a ball, on every line.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn coarse_lattices(
        &mut self,
        prepared: &Prepared<'_>,
        lines: &mut [KnownLine],
    ) -> Result<(), Error> {
        lines.iter_mut().try_for_each(|known| self.coarse_pots(prepared, known, COARSE, u64::MAX))
    }

    /// Goes on with the coarse lattices for which earlier rounds had no simulations left.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn untried_pots(
        &mut self,
        prepared: &[Prepared<'_>],
        lines: &mut [KnownLine],
        until: u64,
    ) -> Result<(), Error> {
        for upto in self.coarse_steps() {
            for known in lines.iter_mut() {
                self.coarse_pots(&prepared[known.place], known, upto, until)?;
            }
        }
        Ok(())
    }

    /// The numbers of strikes of the coarse lattice up to which every line is tried before the next one: a
    /// list wants every line at least once, a decision all strikes of the most probable ones.
    fn coarse_steps(&self) -> core::ops::RangeInclusive<usize> {
        let least = if self.is_list { 1 } else { COARSE };
        least..=COARSE
    }

    /// Goes on with the coarse lattice of a line, up to strike number `upto` of it: every second speed, heights
    /// of the ends and the middle, no side.
    fn coarse_pots(
        &mut self,
        prepared: &Prepared<'_>,
        known: &mut KnownLine,
        upto: usize,
        until: u64,
    ) -> Result<(), Error> {
        while known.tried < upto && self.bench.plays < until {
            let (speed, height) = (known.tried / COARSE_HEIGHTS, known.tried % COARSE_HEIGHTS);
            known.tried += 1;
            self.lattice_pot(prepared, known, [2 * speed + 1, height, 0])?;
        }
        Ok(())
    }

    /// The strike of the lattice with these numbers of the speed, height and side.
    fn lattice_pot(
        &mut self,
        prepared: &Prepared<'_>,
        known: &mut KnownLine,
        [speed, height, side]: [usize; 3],
    ) -> Result<(), Error> {
        let most = self.largest_offset(prepared);
        let (height, side) = (HEIGHTS[height], SIDES[side]);
        let out = sqrt(height * height + side * side).max(1.0);
        self.pot(prepared, known, SPEEDS[speed], [most * side / out, most * height / out])
    }

    /// Adds strikes with any speed and spin on the lines on which something was found, those with the
    /// best plays more often. `first` is the number of the first strike; returns that of the next.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn more_pots(
        &mut self,
        prepared: &[Prepared<'_>],
        lines: &mut [KnownLine],
        first: u64,
        until: u64,
    ) -> Result<u64, Error> {
        let best = lines.iter().map(|known| known.best).fold(0.0, f64::max);
        let spread = SPREAD[usize::from(self.is_list)];
        let weights: Vec<f64> = lines
            .iter()
            .map(|known| if known.is_made() { exp((known.best - best) / spread) } else { 0.0 })
            .collect();
        let all: f64 = weights.iter().sum();
        let mut index = first;
        while self.bench.plays < until && all > 0.0 {
            index += 1;
            let [pick, pace, angle, out] = sequence_point(index);
            let mut left = pick * all;
            let chosen = weights.iter().position(|weight| {
                left -= weight;
                left < 0.0
            });
            let Some(known) = chosen.and_then(|k| lines.get_mut(k)) else { continue };
            let position = &prepared[known.place];
            let offset = self.largest_offset(position) * sqrt(out);
            let (sin, cos) = sin_cos(TAU * angle);
            let speed = LIMITS[0] * exp(pace * log(LIMITS[1] / LIMITS[0]));
            // A strike that cannot be played costs nothing, but the loop has to end.
            let before = self.bench.plays;
            self.pot(position, known, speed, [offset * cos, offset * sin])?;
            self.bench.plays = self.bench.plays.max(before + 1);
        }
        Ok(index)
    }

    pub(crate) fn largest_offset(&self, prepared: &Prepared<'_>) -> f64 {
        largest_offset(prepared.shot(), self.task.noise(), self.task.cue_radius())
    }

    /// Aims one strike along a line and keeps it if it pots the ball legally. `offsets` are the side
    /// and the height.
    pub(crate) fn pot(
        &mut self,
        prepared: &Prepared<'_>,
        known: &mut KnownLine,
        speed: f64,
        offsets: [f64; 2],
    ) -> Result<(), Error> {
        if speed <= known.too_slow {
            return Ok(());
        }
        let start = start(prepared, known, speed, offsets);
        let line = known.line;
        let mut plays = 0;
        let aimed = aim(&mut self.bench.sampler, prepared, &line, start, &mut plays);
        self.bench.plays += plays;
        let Some(aimed) = aimed? else { return Ok(()) };
        if !aimed.is_potted {
            if speed < SLOW * known.least_speed {
                known.too_slow = speed;
            }
            return Ok(());
        }
        let turned = aimed.strike.azimuth - geometric_azimuth(prepared, &line, offsets[0]);
        known.turned = Some((turned, aimed.slope));
        let pot = line.pot(prepared.shot().table());
        let call = call_of(self.task.turn, line.first, Some(pot));
        let (value, is_legal) = self.ruled(prepared, call)?;
        if !is_legal {
            return Ok(());
        }
        let (kind, at) = (PlayKind::Pot(line.kind), CuePlace { number: known.place, prepared });
        if self.measures_windows {
            let meant = MeantPot { pot, call, kind, line: Some(line) };
            let error = self.line_error(prepared, &line, &aimed)?;
            let prior = self.center(at, aimed.strike, meant, error)?;
            known.best = known.best.max(prior.unwrap_or_default());
            return Ok(());
        }
        let missed = match known.missed[nearest_speed(speed)] {
            Some(missed) => missed,
            None => {
                let missed = self.missed(prepared, &line, &aimed.strike, call)?;
                *known.missed[nearest_speed(speed)].insert(missed)
            }
        };
        let prior = known.chance * value + (1.0 - known.chance) * missed.min(value);
        known.best = known.best.max(prior);
        let strike = aimed.strike;
        self.keep(at, FoundPlay { strike, call, kind, line: Some(line), prior });
        Ok(())
    }

    /// The mean value of the shots that miss a pot to the left and to the right. The last ruled
    /// simulation stays what it was.
    fn missed(
        &mut self,
        prepared: &Prepared<'_>,
        line: &Line,
        strike: &Strike,
        call: Call,
    ) -> Result<f64, Error> {
        let end = self.bench.successor.clone();
        let mut sum = 0.0;
        for side in [-1.0, 1.0] {
            let azimuth = strike.azimuth + side * MISS * line.tolerance;
            self.bench.sampler.simulate(prepared, &Strike { azimuth, ..*strike })?;
            self.bench.plays += 1;
            sum += self.ruled(prepared, call)?.0;
        }
        self.bench.successor = end;
        Ok(0.5 * sum)
    }
}

/// Point `index` of the recurrence with [`STEPS`], in the unit cube.
pub(crate) fn sequence_point(index: u64) -> [f64; 4] {
    STEPS.map(|step| (0.5 + step * index as f64) % 1.0)
}

/// The number of the lattice's speed that is most like `speed`.
fn nearest_speed(speed: f64) -> usize {
    let ratio = |other: f64| (speed / other).max(other / speed);
    let order = |a: &usize, b: &usize| ratio(SPEEDS[*a]).total_cmp(&ratio(SPEEDS[*b]));
    (0..SPEEDS.len()).min_by(order).unwrap_or(0)
}

/// The strike with which the aiming along a line starts.
fn start(
    prepared: &Prepared<'_>,
    known: &KnownLine,
    speed: f64,
    [side, height]: [f64; 2],
) -> AimStart {
    let line = &known.line;
    // The throw and the bend of a similar strike are a better start than none.
    let (turned, slope) = known.turned.unwrap_or((0.0, line.slope));
    let turned = if line.kind == LineKind::Direct { turned } else { 0.0 };
    let azimuth = geometric_azimuth(prepared, line, side) + turned.clamp(-0.03, 0.03);
    let strike = Strike { speed, azimuth, elevation: 0.0, side, height };
    AimStart { strike: raised(prepared, strike), slope }
}

/// The azimuth along a line by geometry and squirt alone. `side` is that of the tip, ball radii.
fn geometric_azimuth(prepared: &Prepared<'_>, line: &Line, side: f64) -> f64 {
    let shot = prepared.shot();
    let ball = shot.strike().map_or(0, |(ball, _)| ball);
    let cue = &shot.physics().cue;
    line.azimuth - carom::resolve::cue_ball::squirt(cue, &shot.balls()[ball].ball, side)
}

//! Moving a play uphill by its own samples.
//!
//! What happens depends only on the executed strike. So a sample of one intention also tells about
//! a neighbouring one, with the ratio of the two error densities as its weight. The weighted mean
//! estimates the value of the neighbour without a simulation, as long as the effective sample size
//! (Kish 1965) is large enough.
//!
//! The ratio is that of independent normal errors with the noise's own mean and standard deviations. For
//! correlated or measured errors it is an approximation. It only proposes where to look: the moved play
//! is then judged by samples of its own, under the noise itself.

use carom::math::exp;
use carom::resolve::cue_ball::Strike;
use carom_plan::Prepared;
use carom_rules::Play;

use super::candidate::{Candidate, PlayedVariant};
use super::strike_errors::{ErrorScale, largest_offset, moved};
use super::task::ShotTask;

/// Finalists that are moved.
const SHIFTED: usize = 4;
/// Fewest samples for a shift. With fewer the hill is noise.
const LEAST_SAMPLES: usize = 48;
/// Smallest effective sample size, as a share of the samples.
const LEAST_EFFECTIVE: f64 = 0.25;
/// First and last step, in standard deviations of the errors.
const FIRST_STEP: f64 = 0.5;
const LAST_STEP: f64 = 0.1;

/// Adds the best [`SHIFTED`] of the candidates moved uphill, within `speeds` (the least and the greatest, m/s).
pub(crate) fn shift(
    candidates: &mut Vec<Candidate>,
    task: &ShotTask<'_>,
    prepared: &[Prepared<'_>],
    speeds: [f64; 2],
) {
    let (noise, radius) = (task.noise(), task.cue_radius());
    let moved: Vec<Candidate> = candidates
        .iter()
        .take(SHIFTED)
        .filter_map(|candidate| {
            let strike = &candidate.play.strike;
            let most = largest_offset(prepared[candidate.place].shot(), noise, radius);
            let scale = ErrorScale::of(noise, strike.speed, radius);
            let strike = uphill(candidate, &scale, speeds, most.max(strike.offset()))?;
            let play = Play { strike, ..candidate.play };
            let (samples, prior) = (Vec::new(), candidate.mean());
            Some(Candidate { play, samples, prior, correction: 0.0, ..candidate.clone() })
        })
        .collect();
    candidates.extend(moved);
}

/// The intended strike near that of `candidate` with the highest estimated value; none if there
/// are too few samples, or no better one. An intention has one of `speeds` (the least and the greatest,
/// m/s), and a tip offset of at most `most` ball radii.
fn uphill(
    candidate: &Candidate,
    scale: &ErrorScale,
    [slowest, fastest]: [f64; 2],
    most: f64,
) -> Option<Strike> {
    let deviations = &scale.deviation;
    let samples = &candidate.samples;
    if samples.len() < LEAST_SAMPLES {
        return None;
    }
    let meant = &candidate.play.strike;
    let errors: Vec<([f64; 4], f64)> =
        samples.iter().map(|sample| (error(sample, meant, scale), sample.value)).collect();
    let mut best = [0.0; 4];
    let mut value = estimate(&errors, &best)?;
    let start = value;
    let mut step = FIRST_STEP;
    while step >= LAST_STEP {
        let mut better = false;
        for k in (0..4).filter(|k| deviations[*k] > 0.0) {
            for sign in [1.0, -1.0] {
                let mut next = best;
                next[k] += sign * step;
                let strike = moved(meant, deviations, &next);
                let is_in_range = (slowest..=fastest).contains(&strike.speed);
                if !is_in_range || strike.offset() > most {
                    continue;
                }
                if let Some(higher) = estimate(&errors, &next).filter(|e| *e > value) {
                    (best, value, better) = (next, higher, true);
                }
            }
        }
        if !better {
            step *= 0.5;
        }
    }
    (value > start).then(|| moved(meant, deviations, &best))
}

/// The error of a sample beside the mean, in standard deviations; 0 where there is none.
fn error(sample: &PlayedVariant, meant: &Strike, scale: &ErrorScale) -> [f64; 4] {
    let ErrorScale { mean, deviation } = scale;
    let executed = &sample.executed;
    let differences = [
        executed.azimuth - meant.azimuth,
        executed.speed - meant.speed,
        executed.side - meant.side,
        executed.height - meant.height,
    ];
    core::array::from_fn(|k| {
        if deviation[k] > 0.0 { (differences[k] - mean[k]) / deviation[k] } else { 0.0 }
    })
}

/// The weighted mean value of the intention that is `shift` standard deviations away; none if the
/// effective sample size is too small.
fn estimate(errors: &[([f64; 4], f64)], shift: &[f64; 4]) -> Option<f64> {
    let (mut sum, mut squares, mut values) = (0.0, 0.0, 0.0);
    for (error, value) in errors {
        // log φ(e − s) − log φ(e) = e·s − s²/2.
        let exponent: f64 = (0..4).map(|k| shift[k] * (error[k] - 0.5 * shift[k])).sum();
        let weight = exp(exponent);
        sum += weight;
        squares += weight * weight;
        values += weight * value;
    }
    let effective = sum * sum / squares;
    (effective >= LEAST_EFFECTIVE * errors.len() as f64).then(|| values / sum)
}

#[cfg(test)]
mod tests {
    use carom::noise::StruckBall;
    use carom::resolve::cue_ball::Strike;
    use carom::{Noise, math};
    use carom_rules::Play;

    use super::{ErrorScale, uphill};
    use crate::search::{Candidate, PlayKind, PlayedVariant};

    const MEANT: Strike =
        Strike { speed: 2.0, azimuth: 1.0, elevation: 0.05, side: 0.1, height: 0.0 };

    /// Speeds that restrict nothing.
    const SPEEDS: [f64; 2] = [0.0, 100.0];

    /// A candidate whose samples have the value of `hill` at the executed strike.
    fn candidate(noise: &Noise, count: u64, hill: impl Fn(&Strike) -> f64) -> Candidate {
        let struck = StruckBall { radius: 0.028575, largest_offset: 0.5 };
        let samples = (0..count).map(|index| {
            let executed = noise.draw(&MEANT, &struck, 3, index);
            PlayedVariant {
                index,
                executed,
                value: hill(&executed),
                kept: true,
                foul: false,
                end: None,
            }
        });
        Candidate {
            play: Play::new(MEANT),
            kind: PlayKind::Safety,
            line: None,
            legs: Vec::new(),
            pattern: None,
            route: None,
            pot: None,
            place: 0,
            prior: 0.5,
            end: None,
            samples: samples.collect(),
            fresh: Vec::new(),
            correction: 0.0,
        }
    }

    #[test]
    fn an_intention_moves_towards_the_top_of_a_hill() {
        let noise = Noise::olympiad(1.0);
        let scale = ErrorScale::of(&noise, MEANT.speed, 0.028575);
        let top = MEANT.azimuth + 0.8 * noise.azimuth;
        let hill = |strike: &Strike| {
            let off = (strike.azimuth - top) / noise.azimuth;
            math::exp(-off * off)
        };
        let moved = uphill(&candidate(&noise, 400, hill), &scale, SPEEDS, 0.5).unwrap();
        let share = (moved.azimuth - MEANT.azimuth) / noise.azimuth;
        assert!((0.4..1.2).contains(&share), "{share}");
    }

    #[test]
    fn a_bias_is_not_taken_for_a_hill() {
        let noise = Noise { bias: [0.0, 0.002, 0.0, 0.0, 0.0], ..Noise::olympiad(1.0) };
        let scale = ErrorScale::of(&noise, MEANT.speed, 0.028575);
        // The best execution is the intended strike without its error.
        let hill = |strike: &Strike| {
            let off = (strike.azimuth - MEANT.azimuth) / noise.azimuth;
            math::exp(-off * off)
        };
        let candidate = candidate(&noise, 400, hill);
        let moved = uphill(&candidate, &scale, SPEEDS, 0.5).unwrap();
        let share = (moved.azimuth - MEANT.azimuth) / 0.002;
        assert!((-1.4..-0.4).contains(&share), "{share}");
    }

    #[test]
    fn few_samples_and_level_ground_move_nothing() {
        let noise = Noise::olympiad(1.0);
        let scale = ErrorScale::of(&noise, MEANT.speed, 0.028575);
        assert_eq!(uphill(&candidate(&noise, 20, |s| s.azimuth), &scale, SPEEDS, 0.5), None);
        assert_eq!(uphill(&candidate(&noise, 200, |_| 0.5), &scale, SPEEDS, 0.5), None);
    }

    #[test]
    fn an_intention_stays_within_the_speeds() {
        let noise = Noise::olympiad(1.0);
        let scale = ErrorScale::of(&noise, MEANT.speed, 0.028575);
        let candidate = candidate(&noise, 400, |strike| strike.speed);
        let speed = |speeds| uphill(&candidate, &scale, speeds, 0.5).unwrap().speed;
        assert!(speed(SPEEDS) > MEANT.speed + 0.4 * noise.speed);
        let fastest = MEANT.speed + 0.2 * noise.speed;
        assert!((MEANT.speed..=fastest).contains(&speed([0.0, fastest])));
    }

    #[test]
    fn an_intention_stays_within_the_largest_tip_offset() {
        let noise = Noise::olympiad(1.0);
        let scale = ErrorScale::of(&noise, MEANT.speed, 0.028575);
        let moved = uphill(&candidate(&noise, 400, |s| s.side), &scale, SPEEDS, 0.11);
        assert!(moved.is_none_or(|strike| strike.offset() <= 0.11), "{moved:?}");
    }
}

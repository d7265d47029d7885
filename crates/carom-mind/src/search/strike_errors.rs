//! The errors of a strike, in the parameters that a search changes.

use carom::resolve::cue_ball::Strike;
use carom::{Noise, Shot};

/// Largest offset of the tip as a share of the miscue limit, without errors. Near the limit a small
/// error of the tip would slip off.
const OFFSET_USED: f64 = 0.75;
/// Number of standard deviations of the tip's errors by which a play keeps away from the miscue
/// limit. Drawn strikes beyond it are moved back, so they must not look attractive.
const AWAY: f64 = 2.5;

/// The errors of the parameters of a strike: azimuth, speed, side, height.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ErrorScale {
    pub(crate) mean: [f64; 4],
    pub(crate) deviation: [f64; 4],
}

impl ErrorScale {
    /// Of a strike with this `speed` (m/s). `radius` is the cue ball's, m.
    pub(crate) fn of(noise: &Noise, speed: f64, radius: f64) -> Self {
        let of_strike = |[speed, azimuth, _, side, height]: [f64; 5]| {
            [azimuth, speed, side / radius, height / radius]
        };
        Self { mean: of_strike(noise.mean()), deviation: of_strike(noise.deviations(speed)) }
    }
}

/// `strike` moved by `steps` standard deviations.
pub(crate) fn moved(strike: &Strike, deviations: &[f64; 4], steps: &[f64; 4]) -> Strike {
    let by = |k: usize| deviations[k] * steps[k];
    Strike {
        azimuth: strike.azimuth + by(0),
        speed: strike.speed + by(1),
        side: strike.side + by(2),
        height: strike.height + by(3),
        ..*strike
    }
}

/// The largest tip offset of intended strikes, ball radii. `radius` is the cue ball's, m.
pub(crate) fn largest_offset(shot: &Shot, noise: &Noise, radius: f64) -> f64 {
    let limit = shot.miscue_limit().min(1.0);
    let [.., side, height] = noise.deviations(0.0);
    let error = side.max(height) / radius;
    (limit - AWAY * error).clamp(0.0, OFFSET_USED * limit)
}

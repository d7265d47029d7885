//! From an action, numbers in [−1, 1], to a strike.

use core::f64::consts::PI;

use carom::math::{asin, atan2, sqrt};
use carom::noise::StruckBall;
use carom::resolve::cue_ball::Strike;
use carom_rules::Turn;

use crate::config::Config;
use crate::episode::{Episode, NoisyStrike};
use crate::modes::Aim;
use crate::placement;

/// The meaning of the numbers of an action, in order.
pub const ACTIONS: [&str; 7] =
    ["azimuth", "speed", "side", "height", "elevation", "cue_ball_x", "cue_ball_y"];

/// Length of an action where the cue ball is never in hand.
pub const ACTIONS_WITHOUT_HAND: usize = 5;

/// Largest intended tip offset, as a fraction of the miscue limit: players keep away from the
/// limit.
const OFFSET_USED: f64 = 0.9;

/// Clamps a number of an action to [−1, 1]; NaN becomes 0.
fn bounded(action: f32) -> f64 {
    if action.is_nan() { 0.0 } else { f64::from(action).clamp(-1.0, 1.0) }
}

/// The draw of the errors of a strike.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StrikeDraw {
    pub(crate) seed: u64,
    /// Number of the variant of this seed.
    pub(crate) index: u64,
    /// Whether the agent strikes, or its opponent.
    pub(crate) is_agent: bool,
}

/// The strike of `action`, with the errors of `draw`. None if the cue
/// ball is in hand and there is no free place for it.
pub(crate) fn strike(
    config: &Config,
    episode: &dyn Episode,
    turn: &Turn,
    action: &[f32],
    draw: StrikeDraw,
) -> Option<NoisyStrike> {
    let number = |k: usize| bounded(action.get(k).copied().unwrap_or(0.0));
    let [direction, pace, side, height, raise, x, y] = core::array::from_fn(number);
    let cue_ball = match turn.hand {
        Some(region) => Some(placement::nearest(episode, turn.cue, region, [x, y])?),
        None => None,
    };
    let from = cue_ball.or_else(|| episode.place(turn.cue))?;
    let azimuth = match config.aim {
        Aim::Absolute => PI * direction,
        Aim::Relative => relative(episode, turn, from, direction),
    };
    let [slow, fast] = config.speed;
    let most = OFFSET_USED * episode.base().miscue_limit().min(1.0);
    // Most shots are slow and breaks are fast; the square resolves slow shots more finely.
    let pace = 0.5 * (pace + 1.0);
    // Maps the square of side and height to the disc of possible offsets.
    let out = sqrt(side * side + height * height).max(1.0);
    let mut intended = Strike {
        azimuth,
        speed: slow + pace * pace * (fast - slow),
        side: most * side / out,
        height: most * height / out,
        elevation: config.max_elevation * raise.max(0.0),
    };
    // The default elevation is the least: a player does not strike through the rail.
    let least = episode.default_elevation(turn.cue, from, &intended);
    intended.elevation = intended.elevation.max(least);
    Some(with_noise(config, episode, turn, cue_ball, intended, draw))
}

/// The azimuth (rad) that hits the target ball at `across`: from its right edge (−1) to its left
/// (1).
fn relative(episode: &dyn Episode, turn: &Turn, from: [f64; 2], across: f64) -> f64 {
    let radius = episode.radius(turn.cue);
    let way = |to: [f64; 2]| [to[0] - from[0], to[1] - from[1]];
    let length = |[x, y]: [f64; 2]| sqrt(x * x + y * y);
    let targets = episode.targets(turn).map(|(_, to, other)| (way(to), radius + other));
    let nearest = targets.min_by(|(a, _), (b, _)| length(*a).total_cmp(&length(*b)));
    let Some((way, reach)) = nearest else { return PI * across };
    atan2(way[1], way[0]) + asin((across * reach / length(way)).clamp(-1.0, 1.0))
}

/// `intended`, and the place of a cue ball in hand, with the noise of the shooter
/// ([`carom::Noise::draw`]).
pub(crate) fn with_noise(
    config: &Config,
    episode: &dyn Episode,
    turn: &Turn,
    cue_ball: Option<[f64; 2]>,
    intended: Strike,
    draw: StrikeDraw,
) -> NoisyStrike {
    let noise = config.noise_of(draw.is_agent);
    let ball = &episode.balls()[usize::from(turn.cue)].ball;
    let struck = StruckBall::of(episode.base(), ball);
    let actual = noise.draw(&intended, &struck, draw.seed, draw.index);
    let cling = noise.draw_cling(draw.seed, draw.index);
    NoisyStrike { intended, actual, cling, cue_ball, call: None }
}

//! From numbers in [−1, 1] to a strike.

use core::f64::consts::PI;

use carom::Error;
use carom::math::{asin, atan2, sqrt};
use carom::resolve::cue_ball::Strike;
use carom_rules::Turn;

use crate::config::{Config, STEEPEST, named};
use crate::place;
use crate::scene::{Scene, Stroke};

/// What the numbers of an action mean, in order.
pub const ACTIONS: [&str; 7] =
    ["azimuth", "speed", "side", "height", "elevation", "cue_ball_x", "cue_ball_y"];

/// How many of them there are where the cue ball is never in hand.
pub const ACTIONS_WITHOUT_HAND: usize = 5;

/// The largest tip offset that is meant, as part of the miscue limit: players keep away from it.
const OFFSET_USED: f64 = 0.9;

/// The largest tip offset that an error can make of it, as part of the miscue limit: no error is a miscue.
const OFFSET_KEPT: f64 = 0.999;

/// No error makes a cue slower than this, m/s: it would not reach the ball.
const SLOWEST: f64 = 0.01;

/// What the first action means.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Aim {
    /// The direction of the cue: −1 to 1 is −π to π, 0 along the table's width.
    #[default]
    Absolute,
    /// Where the target is hit: the directions from its right edge (−1) through its middle (0) to its left
    /// edge (1). The target is the nearest of the balls of which one must be hit first, or of all.
    Relative,
}

impl Aim {
    const ALL: [Self; 2] = [Self::Absolute, Self::Relative];

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Absolute => "absolute",
            Self::Relative => "relative",
        }
    }

    /// The aim of that name.
    ///
    /// # Errors
    /// [`Error::Input`] if there is none.
    pub fn read(name: &str) -> Result<Self, Error> {
        named(&Self::ALL, Self::name, "aim", name)
    }
}

/// Numbers beyond the bounds are brought to them; what is no number is 0.
fn bounded(action: f32) -> f64 {
    if action.is_nan() { 0.0 } else { f64::from(action).clamp(-1.0, 1.0) }
}

/// The stroke that `action` means. None if the cue ball is in hand and has no place left.
pub(crate) fn stroke(
    config: &Config,
    scene: &dyn Scene,
    turn: &Turn,
    action: &[f32],
    errors: (u64, u64),
) -> Option<Stroke> {
    let a = |k: usize| bounded(action.get(k).copied().unwrap_or(0.0));
    let cue_ball = match turn.hand {
        Some(region) => Some(place::nearest(scene, turn.cue, region, [a(5), a(6)])?),
        None => None,
    };
    let from = cue_ball.or_else(|| scene.place(turn.cue))?;
    let azimuth = match config.aim {
        Aim::Absolute => PI * a(0),
        Aim::Relative => relative(scene, turn, from, a(0)),
    };
    let [slow, fast] = config.speed;
    let most = OFFSET_USED * scene.base().miscue_limit().min(1.0);
    // Most shots are slow, and breaks are fast: the square gives both their room.
    let pace = 0.5 * (a(1) + 1.0);
    // The square of side and height is laid on the disc that can be struck.
    let out = sqrt(a(2) * a(2) + a(3) * a(3)).max(1.0);
    let meant = Strike {
        azimuth,
        speed: slow + pace * pace * (fast - slow),
        side: most * a(2) / out,
        height: most * a(3) / out,
        elevation: config.elevation * a(4).max(0.0),
    };
    Some(Stroke { meant, struck: struck(config, scene, turn, &meant, errors), cue_ball })
}

/// The direction, rad, in which the target is hit `across` from its right edge (−1) to its left (1).
fn relative(scene: &dyn Scene, turn: &Turn, from: [f64; 2], across: f64) -> f64 {
    let radius = scene.pieces()[usize::from(turn.cue)].ball.radius;
    let way = |to: [f64; 2]| [to[0] - from[0], to[1] - from[1]];
    let length = |[x, y]: [f64; 2]| sqrt(x * x + y * y);
    let targets = scene.targets(turn).map(|(_, to, other)| (way(to), radius + other));
    let nearest = targets.min_by(|(a, _), (b, _)| length(*a).total_cmp(&length(*b)));
    let Some((way, reach)) = nearest else { return PI * across };
    atan2(way[1], way[0]) + asin((across * reach / length(way)).clamp(-1.0, 1.0))
}

/// What comes of `meant`: error number `errors.1` of the seed `errors.0`, kept to what can be played.
pub(crate) fn struck(
    config: &Config,
    scene: &dyn Scene,
    turn: &Turn,
    meant: &Strike,
    errors: (u64, u64),
) -> Strike {
    if config.noise == carom::Noise::default() {
        return *meant;
    }
    let radius = scene.pieces()[usize::from(turn.cue)].ball.radius;
    let drawn = config.noise.draw(meant, radius, errors.0, errors.1);
    let most = OFFSET_KEPT * scene.base().miscue_limit().min(1.0);
    let back = (most / drawn.offset().max(most)).min(1.0);
    Strike {
        speed: drawn.speed.max(SLOWEST),
        elevation: drawn.elevation.min(STEEPEST),
        side: drawn.side * back,
        height: drawn.height * back,
        ..drawn
    }
}

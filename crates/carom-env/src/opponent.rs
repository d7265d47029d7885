//! Built-in players.

use carom::Error;
use carom::math::{Vec2, atan2};
use carom::resolve::cue_ball::Strike;
use carom_rules::{BallIndex, Turn};

use crate::action::{self, ACTIONS};
use crate::config::{Config, named};
use crate::place;
use crate::random::Dice;
use crate::scene::{Scene, Stroke};

/// Who plays player 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Opponent {
    /// The agent itself: it shoots for both, sees the table with the shooter's eyes, and is rewarded for
    /// what the shooter did.
    #[default]
    None,
    /// Actions at random.
    Random,
    /// Somebody who aims by the ghost ball at what looks easiest, and errs as the agent does.
    Potter,
}

impl Opponent {
    const ALL: [Self; 3] = [Self::None, Self::Random, Self::Potter];

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Random => "random",
            Self::Potter => "potter",
        }
    }

    /// The opponent of that name.
    ///
    /// # Errors
    /// [`Error::Input`] if there is none.
    pub fn read(name: &str) -> Result<Self, Error> {
        named(&Self::ALL, Self::name, "opponent", name)
    }

    /// What it does. None if the cue ball is in hand and has no place left.
    pub(crate) fn stroke(
        self,
        config: &Config,
        scene: &dyn Scene,
        turn: &Turn,
        dice: &mut Dice,
        errors: (u64, u64),
    ) -> Option<Stroke> {
        let (cue_ball, meant) = match self {
            Self::None | Self::Random => {
                let action = ACTIONS.map(|_| dice.between(-1.0, 1.0) as f32);
                return action::stroke(config, scene, turn, &action, errors);
            }
            Self::Potter => potter(config, scene, turn, dice)?,
        };
        let struck = action::struck(config, scene, turn, &meant, errors);
        Some(Stroke { meant, struck, cue_ball })
    }
}

/// Places that the potter looks at with the cue ball in hand.
const PLACES: usize = 8;

/// Cuts thinner than this are not tried: cosine of 75°.
const THINNEST: f64 = 0.26;

/// A pocket is not played at a flatter angle than this to its axis: cosine of 65°.
const FLATTEST: f64 = 0.42;

/// The potter's cue speed: so much, m/s, and so much more for each metre that the balls have to go, 1/s.
const PACE: [f64; 2] = [1.2, 0.8];

/// At nothing that can be potted it is played with this speed, m/s.
const SAFE: f64 = 2.0;

/// Distances shorter than this are as easy as this, m.
const CLOSE: f64 = 0.3;

/// A pot that the potter sees.
#[derive(Clone, Copy, Debug)]
struct Pot {
    ease: f64,
    azimuth: f64,
    speed: f64,
}

fn potter(
    config: &Config,
    scene: &dyn Scene,
    turn: &Turn,
    dice: &mut Dice,
) -> Option<(Option<[f64; 2]>, Strike)> {
    let [slow, fast] = config.speed;
    let level = |azimuth, speed: f64| Strike {
        speed: speed.clamp(slow, fast),
        azimuth,
        elevation: 0.0,
        side: 0.0,
        height: 0.0,
    };
    let mut best: Option<(Pot, Option<[f64; 2]>)> = None;
    let mut place = None;
    for _ in 0..if turn.hand.is_some() { PLACES } else { 1 } {
        if let Some(region) = turn.hand {
            let wanted = [dice.between(-1.0, 1.0), dice.between(-1.0, 1.0)];
            place = Some(place::nearest(scene, turn.cue, region, wanted)?);
        }
        let from = place.or_else(|| scene.place(turn.cue))?;
        let pot = easiest(scene, turn, from);
        if let Some(pot) = pot.filter(|pot| best.is_none_or(|(most, _)| pot.ease > most.ease)) {
            best = Some((pot, place));
        }
    }
    if let Some((pot, place)) = best {
        return Some((place, level(pot.azimuth, pot.speed)));
    }
    // Full at the nearest ball; at the opening as hard as it goes.
    let from = vector(place.or_else(|| scene.place(turn.cue))?);
    let ways = scene.targets(turn).map(|(_, to, _)| vector(to) - from);
    let way = ways.min_by(|a, b| a.length_squared().total_cmp(&b.length_squared()))?;
    let speed = if scene.standing().opening { fast } else { SAFE };
    Some((place, level(atan2(way.y, way.x), speed)))
}

/// The easiest pot from `from`: full, near, with nothing in the way.
fn easiest(scene: &dyn Scene, turn: &Turn, from: [f64; 2]) -> Option<Pot> {
    let (table, from) = (scene.base().table(), vector(from));
    let radius = scene.pieces()[usize::from(turn.cue)].ball.radius;
    let mut best: Option<Pot> = None;
    for (ball, at, other) in scene.targets(turn) {
        let at = vector(at);
        for pocket in &table.pockets {
            let to_pocket = pocket.center + table.center() - at;
            let far = to_pocket.length();
            let line = to_pocket * (1.0 / far);
            let ghost = at - line * (radius + other);
            let to_ghost = ghost - from;
            let near = to_ghost.length();
            let fullness = to_ghost.dot(line) / near;
            let ease = fullness / ((near + CLOSE) * (far + CLOSE));
            let playable = fullness > THINNEST && pocket.axis.dot(line) > FLATTEST;
            if !playable
                || best.is_some_and(|pot| pot.ease >= ease)
                || !is_clear(scene, [turn.cue, ball], from, ghost, radius)
                || !is_clear(scene, [turn.cue, ball], at, at + to_pocket, other)
            {
                continue;
            }
            let azimuth = atan2(to_ghost.y, to_ghost.x);
            let speed = PACE[0] + PACE[1] * (near + far / fullness);
            best = Some(Pot { ease, azimuth, speed });
        }
    }
    best
}

/// Whether a ball of `radius` (m) can go straight from `a` to `b` (m) past all balls but those `in_play`.
fn is_clear(scene: &dyn Scene, in_play: [BallIndex; 2], a: Vec2, b: Vec2, radius: f64) -> bool {
    let way = b - a;
    scene.others(in_play[0]).filter(|(ball, ..)| *ball != in_play[1]).all(|(_, there, other)| {
        let to = vector(there) - a;
        let along = (to.dot(way) / way.length_squared()).clamp(0.0, 1.0);
        (to - way * along).length() > radius + other
    })
}

const fn vector([x, y]: [f64; 2]) -> Vec2 {
    Vec2::new(x, y)
}

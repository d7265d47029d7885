//! The strikes of opponents: random actions, the potter, and the plays of built-in players.

use carom::math::{Vec2, atan2};
use carom::resolve::cue_ball::Strike;
use carom_rules::{BallIndex, Play, Turn};

use crate::action::{self, ACTIONS, StrikeDraw};
use crate::config::Config;
use crate::episode::{Episode, NoisyStrike};
use crate::modes::Opponent;
use crate::placement;
use crate::random::Dice;

/// Random places that the potter tries with the cue ball in hand.
const PLACES: usize = 8;

/// Cosine of the largest cut angle that the potter tries: 75°.
const THINNEST: f64 = 0.26;

/// Cosine of the largest angle between the object ball's path and the pocket's axis: 65°.
const FLATTEST: f64 = 0.42;

/// The potter's cue speed: a constant, m/s, and an increase per metre of the balls' paths, 1/s.
const PACE: [f64; 2] = [1.2, 0.8];

/// Cue speed when the potter finds no pot, m/s.
const SAFE: f64 = 2.0;

/// Distance added to the length of each path when pots are compared, m: below it, distance hardly
/// matters.
const CLOSE: f64 = 0.3;

/// The strike of the opponent of `config`, with the errors of `draw`. None if the cue ball is in hand and there is no free place for it.
pub(crate) fn strike(
    config: &Config,
    episode: &dyn Episode,
    turn: &Turn,
    draw: StrikeDraw,
) -> Option<NoisyStrike> {
    let mut dice = Dice::of_opponent(draw.seed, draw.index);
    if config.opponent == Opponent::Potter {
        let (cue_ball, intended) = potter(config, episode, turn, &mut dice)?;
        return Some(action::with_noise(config, episode, turn, cue_ball, intended, draw));
    }
    let action = ACTIONS.map(|_| dice.between(-1.0, 1.0) as f32);
    action::strike(config, episode, turn, &action, draw)
}

/// The strike of a player's `play`, with the errors of `draw`, as [`strike`]. None if the episode does not ask for
/// a shot.
pub(crate) fn strike_of_play(
    config: &Config,
    episode: &dyn Episode,
    play: &Play,
    draw: StrikeDraw,
) -> Option<NoisyStrike> {
    let turn = episode.turn()?;
    let noisy = action::with_noise(config, episode, turn, play.cue_ball, play.strike, draw);
    Some(NoisyStrike { call: Some(play.call), ..noisy })
}

/// A pot that the potter could play.
#[derive(Clone, Copy, Debug)]
struct Pot {
    /// The larger, the easier: cosine of the cut angle, divided by the lengths of both paths, 1/m².
    ease: f64,
    azimuth: f64,
    speed: f64,
}

/// The potter's place for a cue ball in hand, and its strike.
fn potter(
    config: &Config,
    episode: &dyn Episode,
    turn: &Turn,
    dice: &mut Dice,
) -> Option<(Option<[f64; 2]>, Strike)> {
    let [slow, fast] = config.speed;
    let struck = |azimuth, speed: f64, from: Vec2| {
        let speed = speed.clamp(slow, fast);
        let level = Strike { speed, azimuth, elevation: 0.0, side: 0.0, height: 0.0 };
        let elevation = episode.default_elevation(turn.cue, [from.x, from.y], &level);
        Strike { elevation, ..level }
    };
    let mut best: Option<(Pot, Option<[f64; 2]>)> = None;
    let mut place = None;
    for _ in 0..if turn.hand.is_some() { PLACES } else { 1 } {
        if let Some(region) = turn.hand {
            let wanted = [dice.between(-1.0, 1.0), dice.between(-1.0, 1.0)];
            place = Some(placement::nearest(episode, turn.cue, region, wanted)?);
        }
        let from = place.or_else(|| episode.place(turn.cue))?;
        let pot = easiest(episode, turn, from);
        if let Some(pot) = pot.filter(|pot| best.is_none_or(|(most, _)| pot.ease > most.ease)) {
            best = Some((pot, place));
        }
    }
    if let Some((pot, place)) = best {
        let from = vector(place.or_else(|| episode.place(turn.cue))?);
        return Some((place, struck(pot.azimuth, pot.speed, from)));
    }
    // No pot: a full hit on the nearest ball, at full speed for the break.
    let from = vector(place.or_else(|| episode.place(turn.cue))?);
    let ways = episode.targets(turn).map(|(_, to, _)| vector(to) - from);
    let way = ways.min_by(|a, b| a.length_squared().total_cmp(&b.length_squared()))?;
    let speed = if episode.standing().opening { fast } else { SAFE };
    Some((place, struck(atan2(way.y, way.x), speed, from)))
}

/// The easiest pot with the cue ball at `from`, if there is one.
fn easiest(episode: &dyn Episode, turn: &Turn, from: [f64; 2]) -> Option<Pot> {
    let (table, from) = (episode.base().table(), vector(from));
    let radius = episode.radius(turn.cue);
    let mut best: Option<Pot> = None;
    for (ball, at, other) in episode.targets(turn) {
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
                || !is_clear(episode, [turn.cue, ball], from, ghost, radius)
                || !is_clear(episode, [turn.cue, ball], at, at + to_pocket, other)
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

/// Whether a ball of `radius` (m) can move straight from `a` to `b` (m) without touching a ball
/// other than the two `in_play`.
fn is_clear(episode: &dyn Episode, in_play: [BallIndex; 2], a: Vec2, b: Vec2, radius: f64) -> bool {
    let way = b - a;
    episode.others(in_play[0]).filter(|(ball, ..)| *ball != in_play[1]).all(|(_, there, other)| {
        let to = vector(there) - a;
        let along = (to.dot(way) / way.length_squared()).clamp(0.0, 1.0);
        (to - way * along).length() > radius + other
    })
}

const fn vector([x, y]: [f64; 2]) -> Vec2 {
    Vec2::new(x, y)
}

//! What the logistic regression sees of a position.

use carom::math::log;
use carom_rules::games::GameState;
use carom_rules::games::eight_ball::Group;
use carom_rules::{BallIndex, Frame, Rules, Seat, Turn};

use super::lanes::KEPT;
use super::{Lanes, Markov, Position, Reference};
use crate::scene::Scene;
use crate::targets::balls_left;

/// Number of features.
pub const COUNT: usize = 15;

/// Their names, in order.
pub const NAMES: [&str; COUNT] = [
    "one",
    "markov",
    "best pot",
    "second pot",
    "third pot",
    "in hand",
    "usual pot",
    "open balls",
    "other's open balls",
    "fouls",
    "other's fouls",
    "lead",
    "slow markov",
    "balls",
    "other's balls",
];

/// Odds are kept within this probability of 0 and 1.
const LEAST: f64 = 0.005;

/// The features of a shot, for its player.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Features(pub [f64; COUNT]);

impl Features {
    /// The features of the position, whose frame asks for `turn`.
    pub fn of(position: &Position<'_>, turn: &Turn) -> Self {
        let frame = position.frame;
        let (own, other) = (turn.player, 1 - turn.player);
        let noise = &position.noise[own];
        let in_hand = turn.hand.is_some();
        let lanes = Lanes::of(frame, turn, noise);
        let [first, second, third]: [f64; KEPT] = lanes.chances;
        let [fouls, other_fouls] = [own, other].map(|seat| f64::from(frame.fouls_in_a_row()[seat]));
        Self([
            1.0,
            odds(Markov::default().shooter(position, turn, first)),
            first,
            second,
            third,
            f64::from(u8::from(in_hand)),
            Reference::of(frame, noise).chance,
            open_balls(frame, turn, own),
            open_balls(frame, turn, other),
            fouls,
            other_fouls,
            lead(frame, own),
            odds(Markov::slow().shooter(position, turn, first)),
            balls_left(frame, own) as f64 / 8.0,
            balls_left(frame, other) as f64 / 8.0,
        ])
    }
}

/// The logarithm of the odds of a probability.
fn odds(probability: f64) -> f64 {
    let kept = probability.clamp(LEAST, 1.0 - LEAST);
    log(kept / (1.0 - kept))
}

/// The share of a seat's balls that can go straight into some pocket. 1 where the balls are shared
/// and none is left.
fn open_balls(frame: &Frame, turn: &Turn, seat: Seat) -> f64 {
    let scene = Scene::new(frame);
    let is_wanted = |ball: BallIndex| match frame.game_state() {
        GameState::EightBall(game) => game.group(seat).is_none_or(|g| Group::of(ball) == Some(g)),
        _ => true,
    };
    let balls = scene.balls().iter().filter(|ball| ball.index != turn.cue && is_wanted(ball.index));
    let (mut open, mut all) = (0_u32, 0_u32);
    for ball in balls {
        all += 1;
        let is_open = (0..scene.table.pockets.len()).any(|pocket| {
            scene.window(ball.center, ball.radius, pocket).is_some_and(|window| {
                let target = ball.center + window.way * window.distance;
                scene.is_clear(ball.center, target, ball.radius, &[ball.index, turn.cue])
            })
        });
        open += u32::from(is_open);
    }
    if all == 0 { 1.0 } else { f64::from(open) / f64::from(all) }
}

/// The lead of a seat: in balls, or in points as a share of what is at stake.
fn lead(frame: &Frame, own: Seat) -> f64 {
    let [ours, theirs] = [own, 1 - own].map(|seat| f64::from(frame.scores()[seat]));
    match frame.rules() {
        Rules::EightBall => {
            balls_left(frame, 1 - own) as f64 / 7.0 - balls_left(frame, own) as f64 / 7.0
        }
        Rules::Snooker => (ours - theirs) / 147.0,
        Rules::StraightPool | Rules::ThreeCushion => {
            (ours - theirs) / f64::from(frame.options().points)
        }
        _ => 0.0,
    }
}

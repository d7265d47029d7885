//! What the logistic regression sees of a position.

use carom::math::{exp, log};
use carom_rules::{Frame, MOST_BALLS, Objective, Scoring, Seat, Turn};

use super::needs::{Needs, set_of};
use super::ways::{Ease, Ways, log_in_run};
use super::{Markov, Position, Reference};
use crate::targets::{Targets, balls_left};

/// Number of features.
pub const COUNT: usize = 18;

/// Their names, in order.
pub const NAMES: [&str; COUNT] = [
    "one",
    "slow markov",
    "best pot",
    "next pot",
    "mean next pot",
    "usual pot",
    "chain by eases",
    "chain by next pot",
    "other's run-out",
    "ease",
    "least ease",
    "other's least ease",
    "last ball's ease",
    "lead",
    "other's balls",
    "open table",
    "fouls",
    "hand",
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
        let (ways, needs) = (Ways::of(frame, turn), Needs::of(frame, turn));
        let chances = ways.chances(noise);
        let others = if position.noise[other] == *noise {
            chances
        } else {
            ways.chances(&position.noise[other])
        };
        let [ours, theirs] = eases(&needs, own, &chances, &others);
        let on = set_of(Targets::of(frame, turn).first.iter().copied());
        let promise = ways.promise(turn, on, |ball| needs.after(ball), noise);
        // The first pot from where the cue ball lies, and all other balls from usual places.
        let first_ball = promise.ball.map_or(0.0, |ball| log_in_run(chances[usize::from(ball)]));
        let rest = ours.log_run - first_ball;
        let by_eases = exp(log_in_run(promise.first) + rest);
        // The same with the first two pots, and the further balls as easy as those.
        let left = ours.count.saturating_sub(1) as f64;
        let further = if left > 1.0 { rest * (left - 1.0) / left } else { 0.0 };
        let by_next = promise.mean_next * exp(further);
        let run_of_other = exp(theirs.log_run);
        let usual = Reference::chances(position);
        let fouls = [own, other].map(|seat| f64::from(frame.fouls_in_a_row()[seat]));
        Self([
            1.0,
            odds(Markov::slow().shooter(position, turn, usual, promise.first)),
            promise.first,
            promise.next,
            promise.mean_next,
            usual[own],
            odds(chain(by_eases, run_of_other)),
            odds(chain(by_next, run_of_other)),
            theirs.log_run,
            ours.mean,
            ours.least,
            theirs.least,
            Ease::of(needs.last(), &chances).mean,
            lead(frame, own),
            balls_left(frame, other) as f64 / 8.0,
            f64::from(u8::from(needs.is_open())),
            fouls[1] - fouls[0],
            f64::from(u8::from(turn.hand.is_some())),
        ])
    }
}

/// The chance of winning of a player who runs out with the chance `own`, or else the other player does with the chance
/// `other`, or else both are equal.
fn chain(own: f64, other: f64) -> f64 {
    own + (1.0 - own) * (1.0 - other) * 0.5
}

/// How easily the balls of the player at the table go in, and those of the other player. On an open table of
/// eight-ball the player at the table takes the easier group.
fn eases(
    needs: &Needs,
    own: Seat,
    chances: &[f64; MOST_BALLS],
    others: &[f64; MOST_BALLS],
) -> [Ease; 2] {
    let (balls, balls_of_other) = (needs.balls(own), needs.balls(1 - own));
    let ours = Ease::of(balls, chances);
    if needs.is_open() {
        let swapped = Ease::of(balls_of_other, chances);
        if swapped.log_run > ours.log_run {
            return [swapped, Ease::of(balls, others)];
        }
    }
    [ours, Ease::of(balls_of_other, others)]
}

/// The logarithm of the odds of a probability.
fn odds(probability: f64) -> f64 {
    let kept = probability.clamp(LEAST, 1.0 - LEAST);
    log(kept / (1.0 - kept))
}

/// The lead of a seat: in balls, or in points as a share of what is at stake.
fn lead(frame: &Frame, own: Seat) -> f64 {
    let [ours, theirs] = [own, 1 - own].map(|seat| f64::from(frame.scores()[seat]));
    let facts = frame.facts();
    match facts.scoring {
        Scoring::LastBall if facts.objective == Objective::Groups => {
            balls_left(frame, 1 - own) as f64 / 7.0 - balls_left(frame, own) as f64 / 7.0
        }
        Scoring::LastBall => 0.0,
        Scoring::Points { maximum } => (ours - theirs) / f64::from(maximum),
        Scoring::Target { .. } => (ours - theirs) / f64::from(frame.options().points),
    }
}

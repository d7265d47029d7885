//! Observations.

use carom_rules::{BallIndex, Region, Seat};

use crate::episode::Episode;

/// The numbers for each ball, in order: its place (0 in the middle of the table, −1 and 1 at the
/// nose lines), whether it is on the table, and whether it is on. All four are 0 for a ball that is
/// not on the table.
pub const BALL_FEATURES: [&str; 4] = ["x", "y", "on_table", "on"];

/// The numbers after those of the balls, in order.
pub const FEATURES: [&str; 11] = [
    // The cue ball is in hand, and may be placed there.
    "hand_anywhere",
    "hand_behind_head_string",
    "hand_in_the_d",
    // The rules name no ball that must be hit first.
    "any_ball",
    // One of the balls on must be nominated.
    "nominate",
    // The next shot is the first after a rack.
    "opening",
    // Points, divided by the points that win; in snooker by 147.
    "own_score",
    "other_score",
    // Consecutive fouls, divided by three.
    "own_fouls",
    "other_fouls",
    // The viewer shoots next.
    "own_turn",
];

/// Bound of |x| and |y| of a ball. It is more than 1 because a ball in the jaws of a pocket is
/// beyond the nose lines.
pub const POSITION_BOUND: f32 = 1.25;

/// Bound of |score|. Scores can be negative only in straight pool.
pub const SCORE_BOUND: f32 = 1.25;

/// Length of the observation of `balls` balls.
pub(crate) const fn size(balls: usize) -> usize {
    BALL_FEATURES.len() * balls + FEATURES.len()
}

/// Lower bound of each number.
pub(crate) fn low(balls: usize, least_score: f32) -> Vec<f32> {
    let ball = [-POSITION_BOUND, -POSITION_BOUND, 0.0, 0.0];
    let rest = FEATURES.map(|name| match name {
        "own_score" | "other_score" => least_score,
        _ => 0.0,
    });
    core::iter::repeat_n(ball, balls).flatten().chain(rest).collect()
}

/// Upper bound of each number.
pub(crate) fn high(balls: usize) -> Vec<f32> {
    let ball = [POSITION_BOUND, POSITION_BOUND, 1.0, 1.0];
    let rest = FEATURES.map(|name| match name {
        "own_score" | "other_score" => SCORE_BOUND,
        _ => 1.0,
    });
    core::iter::repeat_n(ball, balls).flatten().chain(rest).collect()
}

/// Writes the observation of `viewer` to `out`.
pub(crate) fn write(episode: &dyn Episode, viewer: Seat, out: &mut [f32]) {
    let count = episode.balls().len();
    let (balls, rest) = out.split_at_mut(BALL_FEATURES.len() * count);
    let turn = episode.turn();
    let size = episode.base().table().size;
    let normal =
        |x: f64, size: f64| ((2.0 * x / size - 1.0) as f32).clamp(-POSITION_BOUND, POSITION_BOUND);
    let is_on = |ball: BallIndex| {
        turn.is_some_and(|turn| {
            if turn.on.is_empty() { ball != turn.cue } else { turn.on.contains(&ball) }
        })
    };
    for (k, out) in (0..).zip(balls.as_chunks_mut().0) {
        let ball = episode.ball_seen(viewer, k);
        *out = match episode.place(ball) {
            Some([x, y]) => {
                [normal(x, size.x), normal(y, size.y), 1.0, f32::from(u8::from(is_on(ball)))]
            }
            None => [0.0; BALL_FEATURES.len()],
        };
    }
    let standing = episode.standing();
    let flag = |is: bool| f32::from(u8::from(is));
    let hand = |region| flag(turn.is_some_and(|turn| turn.hand == Some(region)));
    let score = |x: f64| (x as f32).clamp(-SCORE_BOUND, SCORE_BOUND);
    let fouls = |x: f64| (x as f32).min(1.0);
    rest.copy_from_slice(&[
        hand(Region::Anywhere),
        hand(Region::BehindHeadString),
        hand(Region::TheD),
        flag(turn.is_some_and(|turn| turn.on.is_empty())),
        flag(turn.is_some_and(|turn| turn.calls.nominate)),
        flag(standing.opening),
        score(standing.scores[viewer]),
        score(standing.scores[1 - viewer]),
        fouls(standing.fouls[viewer]),
        fouls(standing.fouls[1 - viewer]),
        flag(turn.is_some_and(|turn| turn.player == viewer)),
    ]);
}

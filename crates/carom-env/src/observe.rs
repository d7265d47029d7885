//! What an agent sees.

use carom::limits::SMALL_CAPACITY;
use carom_rules::{Player, Region};

use crate::scene::Scene;

/// What is seen of every ball, in order: its place (the middle of the table 0, its noses −1 and 1), whether it
/// is on the table (else all four are 0), and whether it may be hit first.
pub const BALL_FEATURES: [&str; 4] = ["x", "y", "on_table", "on"];

/// What is seen besides, after the balls, in order.
pub const FEATURES: [&str; 11] = [
    // The cue ball is in hand: where it may be put.
    "hand_anywhere",
    "hand_behind_head_string",
    "hand_in_the_d",
    // Any ball may be hit first.
    "any_ball",
    // One of the balls on is nominated.
    "nominate",
    // The first shot of a frame that begins with a rack.
    "opening",
    // Points: by the target, in snooker by 147.
    "own_score",
    "other_score",
    // Fouls in a row, by three.
    "own_fouls",
    "other_fouls",
    // Whether the viewer shoots next.
    "own_turn",
];

/// No number seen is larger: a ball in a pocket's jaws lies beyond the noses.
pub const POSITION_BOUND: f32 = 1.25;

/// No score seen is larger; in straight pool, where fouls cost points, none is less than its negative.
pub const SCORE_BOUND: f32 = 1.25;

/// How many numbers are seen of `balls` balls.
pub(crate) const fn size(balls: usize) -> usize {
    BALL_FEATURES.len() * balls + FEATURES.len()
}

/// The least of each number.
pub(crate) fn low(balls: usize, least_score: f32) -> Vec<f32> {
    let ball = [-POSITION_BOUND, -POSITION_BOUND, 0.0, 0.0];
    let rest = FEATURES.map(|name| match name {
        "own_score" | "other_score" => least_score,
        _ => 0.0,
    });
    core::iter::repeat_n(ball, balls).flatten().chain(rest).collect()
}

/// The largest of each number.
pub(crate) fn high(balls: usize) -> Vec<f32> {
    let ball = [POSITION_BOUND, POSITION_BOUND, 1.0, 1.0];
    let rest = FEATURES.map(|name| match name {
        "own_score" | "other_score" => SCORE_BOUND,
        _ => 1.0,
    });
    core::iter::repeat_n(ball, balls).flatten().chain(rest).collect()
}

/// Writes what `viewer` sees.
pub(crate) fn write(scene: &dyn Scene, viewer: Player, out: &mut [f32]) {
    let count = scene.pieces().len();
    let (balls, rest) = out.split_at_mut(BALL_FEATURES.len() * count);
    let turn = scene.turn();
    let size = scene.base().table().size;
    let normal =
        |x: f64, size: f64| ((2.0 * x / size - 1.0) as f32).clamp(-POSITION_BOUND, POSITION_BOUND);
    let mut on = [false; SMALL_CAPACITY];
    if let Some(turn) = turn {
        let any = turn.on.is_empty();
        for (ball, on) in on.iter_mut().enumerate().take(count) {
            *on = any && ball != usize::from(turn.cue);
        }
        turn.on.iter().for_each(|ball| on[usize::from(*ball)] = true);
    }
    for (ball, out) in scene.order(viewer).into_iter().zip(balls.as_chunks_mut().0) {
        *out = match scene.place(ball) {
            Some([x, y]) => {
                let on = f32::from(u8::from(on[usize::from(ball)]));
                [normal(x, size.x), normal(y, size.y), 1.0, on]
            }
            None => [0.0; BALL_FEATURES.len()],
        };
    }
    let standing = scene.standing();
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

//! Straight lines between balls at rest, seen from above.

use carom::math::{Vec2, cos, radians, sqrt};
use carom::{Shot, Table};

use crate::played::Played;

/// Aims at a ball that are tested for a free line: from one edge to the other.
const AIMS: u32 = 41;

/// The largest cut of an easy pot, and the largest angle between a ball's line and the axis of its pocket,
/// rad: 50° and 55°. Players call a ball beyond these no shot.
const MOST_CUT: f64 = radians(50.0);
const MOST_TURN: f64 = radians(55.0);

const fn vector([x, y]: [f64; 2]) -> Vec2 {
    Vec2 { x, y }
}

/// Distance of a point from a segment, m.
pub(crate) fn distance_to_segment(point: Vec2, from: Vec2, to: Vec2) -> f64 {
    let line = to - from;
    let square = line.dot(line);
    let share = if square == 0.0 { 0.0 } else { (point - from).dot(line) / square };
    (point - from - line * share.clamp(0.0, 1.0)).length()
}

fn is_free(others: &[Vec2], from: Vec2, to: Vec2, reach: f64) -> bool {
    others.iter().all(|other| distance_to_segment(*other, from, to) >= reach)
}

/// Whether no straight line leads the cue ball to the ball, past the other balls on the table. False if
/// the ball is gone.
pub fn is_hidden(shot: &Shot, played: &Played, cue: usize, ball: usize) -> bool {
    if ball == cue || played.is_gone(ball) {
        return false;
    }
    let (from, to) = (vector(played.places[cue]), vector(played.places[ball]));
    // Between the centres of the cue ball and another ball that touch.
    let reach_of = |ball: usize| shot.balls()[cue].ball.radius + shot.balls()[ball].ball.radius;
    let others: Vec<(Vec2, f64)> = (0..played.places.len())
        .filter(|one| *one != cue && *one != ball && !played.is_gone(*one))
        .map(|one| (vector(played.places[one]), reach_of(one)))
        .collect();
    let reach = reach_of(ball);
    let along = (to - from) * (1.0 / (to - from).length());
    let across = Vec2 { x: -along.y, y: along.x };
    (0..AIMS).all(|k| {
        // The ghost ball of this aim, `aside` from the line through both centres.
        let aside = reach * (2.0 * (f64::from(k) + 0.5) / f64::from(AIMS) - 1.0);
        let ghost = to - along * sqrt(reach * reach - aside * aside) + across * aside;
        others.iter().any(|(other, near)| distance_to_segment(*other, from, ghost) < *near)
    })
}

/// Whether the cue ball can pot the ball directly: into a pocket whose axis is at most 55° from the ball's
/// line, with a cut of at most 50°, and no other ball in the way. False if the ball is gone.
pub fn can_pot(shot: &Shot, played: &Played, cue: usize, ball: usize) -> bool {
    let lies = |one: &usize| *one == cue || *one == ball || !played.is_gone(*one);
    let rest = (0..played.places.len()).filter(|one| *one != cue && *one != ball);
    let places: Vec<_> =
        [cue, ball].into_iter().chain(rest).filter(lies).map(|one| played.places[one]).collect();
    !played.is_gone(ball) && can_pot_from(shot.table(), shot.balls()[cue].ball.radius, &places)
}

/// The same for balls of one radius (m) at these places: the cue ball, the ball, and the others.
pub(crate) fn can_pot_from(table: &Table, radius: f64, places: &[[f64; 2]]) -> bool {
    let [from, to, others @ ..] = places else { return false };
    let (from, to, reach) = (vector(*from), vector(*to), 2.0 * radius);
    let others: Vec<Vec2> = others.iter().map(|other| vector(*other)).collect();
    table.pockets.iter().any(|pocket| {
        let hole = pocket.center + table.center();
        let line = (hole - to) * (1.0 / (hole - to).length());
        let ghost = to - line * reach;
        let way = ghost - from;
        line.dot(pocket.axis) >= cos(MOST_TURN)
            && way.dot(line) >= cos(MOST_CUT) * way.length()
            && is_free(&others, to, hole, reach)
            && is_free(&others, from, ghost, reach)
    })
}

/// Whether two balls lie at least `distance` (m) apart, or one is gone.
pub fn are_apart(played: &Played, [a, b]: [usize; 2], distance: f64) -> bool {
    let gone = played.is_gone(a) || played.is_gone(b);
    gone || (vector(played.places[a]) - vector(played.places[b])).length() >= distance
}

/// Whether all balls on the table lie within `distance` (m) of the cue ball.
pub fn are_gathered(played: &Played, cue: usize, distance: f64) -> bool {
    let from = vector(played.places[cue]);
    let near = |ball: usize| (vector(played.places[ball]) - from).length() <= distance;
    (0..played.places.len()).all(|ball| played.is_gone(ball) || near(ball))
}

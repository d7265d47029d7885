//! Three-cushion carom (UMB, World rules of carom billiard).

use carom::shot::Node;

use crate::facts::{Facts, Touch};
use crate::frame::State;
use crate::games::{Game, Played};
use crate::layout::{distance, spot_named};
use crate::request::{Calls, Choice, Request, Turn};
use crate::ruling::Foul;
use crate::{BallIndex, Player};

/// The white, the yellow and the red: players 0 and 1 play with the first two.
const RED: BallIndex = 2;

/// Cushions that the cue ball must have touched before it touches the second object ball (UMB, article
/// on the three-cushion game).
const CUSHIONS: usize = 3;

/// Balls nearer than this touch, m: what eye and lamp cannot tell apart.
const FROZEN: f64 = 1e-9;

/// A match of three-cushion.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ThreeCushion {
    is_opening: bool,
    /// Player 0 has reached the target: player 1 has one more inning.
    last_inning: bool,
    innings: [u32; 2],
}

impl ThreeCushion {
    /// Innings that each player has begun.
    pub const fn innings(&self) -> [u32; 2] {
        self.innings
    }

    /// Both players have the same number of innings: player 1 may answer.
    fn end(&mut self, state: &State, player: Player, total: i32) -> Option<Request> {
        let target = state.options.target;
        if player == 0 {
            self.last_inning |= total >= target;
            return None;
        }
        if total < target && !self.last_inning {
            return None;
        }
        let (zero, one) = (state.scores[0], total);
        let winner = match zero.cmp(&one) {
            core::cmp::Ordering::Greater => Some(0),
            core::cmp::Ordering::Less => Some(1),
            core::cmp::Ordering::Equal => None,
        };
        Some(Request::Over { winner, why: "the target was reached in equal innings" })
    }

    fn next(&self, state: &State, player: Player) -> Request {
        let cue = player as BallIndex;
        if Self::frozen(state, cue).is_empty() {
            return self.turn(player);
        }
        let choices = [Choice::PlayOn, Choice::SpotFrozen];
        Request::choice(player, &choices, "the cue ball touches another ball")
    }

    fn turn(&self, player: Player) -> Request {
        Request::Shot(Turn {
            player,
            cue: player as BallIndex,
            hand: None,
            on: Vec::new(),
            calls: Calls::NONE,
        })
    }

    /// The balls that touch the cue ball.
    fn frozen(state: &State, cue: BallIndex) -> Vec<BallIndex> {
        let layout = &state.layout;
        let Some(there) = layout.place(cue) else { return Vec::new() };
        let radius = |ball: BallIndex| layout.pieces()[usize::from(ball)].ball.radius;
        let touches = |ball: &BallIndex| {
            layout
                .place(*ball)
                .is_some_and(|place| distance(place, there) <= radius(cue) + radius(*ball) + FROZEN)
        };
        layout.on_table().filter(|ball| *ball != cue).filter(touches).collect()
    }

    /// The red goes to the top spot, the shooter's ball to the bottom spot, the other to the middle one;
    /// if that is occupied, to the spot of the ball that occupies it.
    fn spot(&self, state: &mut State, ball: BallIndex, cue: BallIndex) {
        let table = state.base.table();
        let own = |ball: BallIndex| match ball {
            RED => spot_named(table, "foot", 0.75),
            _ if ball == cue => spot_named(table, "head", 0.25),
            _ => spot_named(table, "center", 0.5),
        };
        let mut place = own(ball);
        // Three balls have three spots: one of them is free.
        for other in [ball, RED, cue, 1 - cue.min(1)] {
            if state.layout.is_free(ball, own(other)) {
                place = own(other);
                break;
            }
        }
        state.layout.put(ball, Some(place));
        state.ruling.spotted.push(ball);
    }
}

impl Game for ThreeCushion {
    fn open(&mut self, _: &mut State, breaker: Player) -> Request {
        *self = Self { is_opening: true, ..Self::default() };
        self.innings[breaker] = 1;
        Request::Shot(Turn {
            player: breaker,
            cue: breaker as BallIndex,
            hand: None,
            on: vec![RED],
            calls: Calls::NONE,
        })
    }

    fn middle(&mut self, _: &State, player: Player) -> Request {
        *self = Self::default();
        self.innings[player] = 1;
        self.turn(player)
    }

    fn judge(&mut self, state: &mut State, shot: &Played<'_>) -> Request {
        let (facts, player) = (shot.facts, shot.player());
        let fouls = &mut state.ruling.fouls;
        let was_opening = core::mem::take(&mut self.is_opening);
        fouls.add_if(facts.off_table.contains(&facts.cue), Foul::CueBallOffTable);
        fouls.add_if(facts.thrown_off().next().is_some(), Foul::BallOffTable);
        let first = facts.first_contact();
        let wrong = was_opening && first.is_some_and(|ball| ball != RED);
        fouls.add_if(wrong, Foul::WrongBallFirst);
        for &ball in &facts.off_table {
            self.spot(state, ball, facts.cue);
        }
        let scored = state.ruling.is_legal() && is_carom(facts);
        state.ruling.points[player] = scored.into();
        let total = state.scores[player] + state.ruling.points[player];
        if scored && total < state.options.target {
            return self.next(state, player);
        }
        if let Some(over) = self.end(state, player, total) {
            return over;
        }
        let other = shot.other();
        self.innings[other] += 1;
        self.next(state, other)
    }

    fn choose(&mut self, state: &mut State, player: Player, choice: Choice) -> Request {
        let cue = player as BallIndex;
        if choice == Choice::SpotFrozen {
            let mut balls = Self::frozen(state, cue);
            balls.push(cue);
            for ball in &balls {
                state.layout.put(*ball, None);
            }
            for ball in balls {
                self.spot(state, ball, cue);
            }
        }
        self.turn(player)
    }
    fn to_node(&self) -> Node {
        Node::object([("innings", Node::list(self.innings.map(i64::from)))])
    }
}
/// Whether the cue ball touched three cushions or more before it first touched its second object ball.
fn is_carom(facts: &Facts) -> bool {
    let mut cushions = 0;
    let mut first = None;
    for touch in &facts.touched {
        match (*touch, first) {
            (Touch::Rail(_), _) => cushions += 1,
            (Touch::Ball(ball), None) => first = Some(ball),
            (Touch::Ball(ball), Some(one)) if ball != one => return cushions >= CUSHIONS,
            (Touch::Ball(_), Some(_)) => {}
        }
    }
    false
}

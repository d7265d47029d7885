//! Three-cushion carom (UMB, World rules of carom billiard).

use carom::Table;
use carom::format::Node;
use carom::table::{Rail, TOUCH_TOLERANCE};

use crate::facts::{Facts, Touch};
use crate::frame::State;
use crate::games::{Game, Played};
use crate::layout::{Layout, spot_named};
use crate::request::{Calls, Choice, Request, Turn};
use crate::ruling::Foul;
use crate::{BallIndex, Player};

/// The white, the yellow and the red: players 0 and 1 play with the first two.
const RED: BallIndex = 2;

/// Cushions that the cue ball must have touched before it touches the second object ball (article 83).
const CUSHIONS: usize = 3;

/// Balls nearer than this touch, m: what eye and lamp cannot tell apart.
const FROZEN: f64 = 1e-9;

/// The article of the UMB's World rules of carom billiard (1 January 1989).
pub(crate) const fn rule(foul: Foul) -> &'static str {
    match foul {
        Foul::WrongBallFirst | Foul::IndirectStart => "UMB 23",
        Foul::Push => "UMB 27",
        Foul::CueBallOffTable | Foul::BallOffTable => "UMB 28",
        _ => "",
    }
}

/// A match of three-cushion.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ThreeCushion {
    is_opening: bool,
    innings: [u32; 2],
}

impl ThreeCushion {
    /// Innings that each player has begun.
    pub const fn innings(&self) -> [u32; 2] {
        self.innings
    }

    /// An inning that begins from the starting position, with the red to be attacked directly (article 23).
    fn starting_shot(&mut self, player: Player) -> Request {
        self.is_opening = true;
        self.innings[player] += 1;
        Self::turn(player, vec![RED])
    }

    /// What follows on the end of the inning of `player`, with these scores then. Both players have the same
    /// number of innings (article 29): who has had one less may answer, from the starting position.
    fn end_inning(&mut self, state: &mut State, player: Player, scores: [i32; 2]) -> Request {
        let other = 1 - player;
        if scores.iter().all(|score| *score < state.options.target) {
            self.innings[other] += 1;
            return Self::next(state, other);
        }
        if self.innings[other] < self.innings[player] {
            Self::starting_position(state, other);
            return self.starting_shot(other);
        }
        let winner = (scores[0] != scores[1]).then_some(usize::from(scores[1] > scores[0]));
        Request::Over { winner, why: "the target was reached in equal innings" }
    }

    /// The red on the foot spot, the ball of `player` on a starting spot, the other's on the head spot.
    fn starting_position(state: &mut State, player: Player) {
        state.rack();
        let [start, head] = [0, 1].map(|ball| state.layout.place(ball));
        let own = player as BallIndex;
        state.layout.put(own, start);
        state.layout.put(1 - own, head);
    }

    fn next(state: &State, player: Player) -> Request {
        if state.layout.touching(player as BallIndex, FROZEN).is_empty() {
            return Self::turn(player, Vec::new());
        }
        let choices = [Choice::PlayOn, Choice::SpotFrozen];
        Request::choice(player, &choices, "the cue ball touches another ball")
    }

    fn turn(player: Player, on: Vec<BallIndex>) -> Request {
        let cue = player as BallIndex;
        Request::Shot(Turn { player, cue, hand: None, on, calls: Calls::NONE })
    }

    /// Spots `balls` for `player`, who shoots next: the red on the foot spot, the own ball on the head spot,
    /// the other in the middle; where a ball lies in the way, on the spot of that ball.
    fn spot(state: &mut State, balls: &[BallIndex], player: Player) {
        let table = state.base.table();
        let own = |ball: BallIndex| match ball {
            RED => spot_named(table, "foot", 0.75),
            _ if usize::from(ball) == player => spot_named(table, "head", 0.25),
            _ => spot_named(table, "center", 0.5),
        };
        let State { layout, ruling, .. } = state;
        for &ball in balls {
            layout.put(ball, None);
        }
        for &ball in balls {
            let mut place = own(ball);
            // Of three balls two can lie in the way.
            for _ in 0..2 {
                place = layout.in_the_way(ball, place).map_or(place, own);
            }
            layout.put(ball, Some(place));
            ruling.spotted.push(ball);
        }
    }
}

impl Game for ThreeCushion {
    fn open(&mut self, _: &mut State, breaker: Player) -> Request {
        *self = Self::default();
        self.starting_shot(breaker)
    }

    fn middle(&mut self, _: &State, player: Player) -> Request {
        *self = Self::default();
        self.innings[player] = 1;
        Self::turn(player, Vec::new())
    }

    fn judge(&mut self, state: &mut State, shot: &Played<'_>) -> Request {
        let (facts, player) = (shot.facts, shot.player());
        let frozen = shot.before.touching(facts.cue, FROZEN);
        let pushed = |touch: &Touch| matches!(touch, Touch::Ball(ball) if frozen.contains(ball));
        let was_opening = core::mem::take(&mut self.is_opening);
        let first = facts.first_contact().filter(|_| was_opening);
        let indirect = first == Some(RED) && facts.touched.first() != Some(&Touch::Ball(RED));
        let fouls = &mut state.ruling.fouls;
        fouls.add_if(facts.off_table.contains(&facts.cue), Foul::CueBallOffTable);
        fouls.add_if(facts.thrown_off().next().is_some(), Foul::BallOffTable);
        fouls.add_if(first.is_some_and(|ball| ball != RED), Foul::WrongBallFirst);
        fouls.add_if(indirect, Foul::IndirectStart);
        fouls.add_if(facts.touched.first().is_some_and(pushed), Foul::Push);
        Self::spot(state, &facts.off_table, shot.other());

        let frozen_to = frozen_to(state.base.table(), shot.before, facts.cue);
        let scored = state.ruling.is_legal() && is_carom(facts, &frozen_to);
        state.ruling.points[player] = scored.into();
        let scores = state.scores_after();
        if scored && scores[player] < state.options.target {
            return Self::next(state, player);
        }
        self.end_inning(state, player, scores)
    }

    fn choose(&mut self, state: &mut State, player: Player, choice: Choice) -> Request {
        if choice == Choice::SpotFrozen {
            let cue = player as BallIndex;
            let mut balls = state.layout.touching(cue, FROZEN);
            balls.push(cue);
            Self::spot(state, &balls, player);
        }
        Self::turn(player, Vec::new())
    }

    fn to_node(&self, _: &State) -> Node {
        Node::object([("innings", Node::list(self.innings.map(i64::from)))])
    }
}

/// The rails to which `ball` is frozen.
fn frozen_to(table: &Table, layout: &Layout, ball: BallIndex) -> Vec<Rail> {
    let Some([x, y]) = layout.place(ball) else { return Vec::new() };
    let reach = table.reach(layout.pieces()[usize::from(ball)].ball.radius) + TOUCH_TOLERANCE;
    let near = [
        (x, Rail::Left),
        (table.size.x - x, Rail::Right),
        (y, Rail::Bottom),
        (table.size.y - y, Rail::Top),
    ];
    near.into_iter().filter(|(distance, _)| *distance <= reach).map(|(_, rail)| rail).collect()
}

/// Whether the cue ball touched three cushions or more before it first touched its second object ball. To
/// be pressed against a cushion that it is `frozen_to` does not count.
fn is_carom(facts: &Facts, frozen_to: &[Rail]) -> bool {
    let mut cushions = 0;
    let mut first = None;
    let pressed = |touch: &Touch| matches!(touch, Touch::Rail(rail) if frozen_to.contains(rail));
    let skipped = usize::from(facts.touched.first().is_some_and(pressed));
    for touch in &facts.touched[skipped..] {
        match (*touch, first) {
            (Touch::Rail(_), _) => cushions += 1,
            (Touch::Ball(ball), None) => first = Some(ball),
            (Touch::Ball(ball), Some(one)) if ball != one => return cushions >= CUSHIONS,
            (Touch::Ball(_), Some(_)) => {}
        }
    }
    false
}

//! Three-cushion carom (UMB, World rules of carom billiard).

use carom::Table;
use carom::format::Node;
use carom::outcome::{Outcome, Touched};
use carom::rack::Game;
use carom::table::Rail;

use super::GameState;
use super::facts::{GameFacts, Objective, Opening, OpeningKind, RandomStart, Scoring, Stalemate};
use super::game::{GameRules, PlayedShot};
use crate::layout::{BallIndex, BallList, FROZEN, FrameLayout};
use crate::markings::spot_named;
use crate::referee::NearHit;
use crate::request::{Calls, Choice, Request, Turn};
use crate::ruling::Foul;
use crate::seat::{self, Seat};
use crate::state::FrameState;
use crate::state_bytes::state_bytes;

/// The red. Ball 0, the white, is the cue ball of seat 0; ball 1, the yellow, is that of seat 1.
const RED: BallIndex = 2;

/// Cushions that the cue ball must touch before it touches the second object ball (article 83).
const CUSHIONS: usize = 3;

/// The article of the UMB's World rules of carom billiard (1 January 1989).
const fn rule(foul: Foul) -> &'static str {
    match foul {
        Foul::WrongBallFirst | Foul::IndirectStart => "UMB 23",
        Foul::Push => "UMB 27",
        Foul::CueBallOffTable | Foul::BallOffTable => "UMB 28",
        Foul::DoubleHit | Foul::PushShot => "UMB 41",
        _ => "",
    }
}

pub(crate) const FACTS: GameFacts = GameFacts {
    game: Game::ThreeCushion,
    players: 2,
    balls: 3,
    own_cue_balls: true,
    objective: Objective::Caroms,
    deciding_ball: None,
    scoring: Scoring::Target { usual: 40, negative: false, equal_innings: true },
    opening: Opening { kind: OpeningKind::Carom, speeds: [1.6, 7.0] },
    stalemate: Stalemate::End,
    random_start: Some(RandomStart {
        count: [2, 2],
        always: &[0, 1, RED],
        drawn: None,
        racked: None,
    }),
    lag: false,
    miss: false,
    conceded: false,
    rule,
    state: || GameState::ThreeCushion(ThreeCushion::default()),
};

/// A match of three-cushion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ThreeCushion {
    is_opening: bool,
    innings: [u32; 2],
}

state_bytes!(struct ThreeCushion { is_opening, innings });

impl ThreeCushion {
    /// Number of innings that each seat has begun.
    pub const fn innings(&self) -> [u32; 2] {
        self.innings
    }

    /// Begins an inning of `seat` from the starting position: the red must be hit first and
    /// directly (article 23).
    fn starting_shot(&mut self, seat: Seat) -> Request {
        self.is_opening = true;
        self.innings[seat] += 1;
        Self::turn(seat, BallList::from(&[RED][..]))
    }

    /// The request after an inning of `seat` that ended with these scores. Both players have the
    /// same number of innings (article 29): if the opponent has had one fewer, it plays a last
    /// inning from the starting position.
    fn end_inning(&mut self, state: &mut FrameState, seat: Seat, scores: [i32; 2]) -> Request {
        let opponent = seat::opponent(seat);
        if scores.iter().all(|score| *score < state.options.points) {
            self.innings[opponent] += 1;
            return Self::next(state, opponent);
        }
        if self.innings[opponent] < self.innings[seat] {
            Self::starting_position(state, opponent);
            return self.starting_shot(opponent);
        }
        let winner = (scores[0] != scores[1]).then_some(usize::from(scores[1] > scores[0]));
        Request::Over { winner, why: "the target was reached in equal innings" }
    }

    /// The starting position of `seat`: the red on the foot spot, the cue ball of `seat` on a
    /// starting spot, the other cue ball on the head spot.
    fn starting_position(state: &mut FrameState, seat: Seat) {
        state.rack();
        let [start, head] = [0, 1].map(|ball| state.layout.place(ball));
        let own = seat as BallIndex;
        state.layout.put(own, start);
        state.layout.put(1 - own, head);
    }

    fn next(state: &FrameState, seat: Seat) -> Request {
        if state.layout.touching(seat as BallIndex, FROZEN).is_empty() {
            return Self::turn(seat, BallList::new());
        }
        let choices = [Choice::PlayOn, Choice::SpotFrozen];
        Request::choice(seat, &choices, "the cue ball touches another ball")
    }

    fn turn(player: Seat, on: BallList) -> Request {
        let cue = player as BallIndex;
        Request::Shot(Turn { player, cue, hand: None, on, calls: Calls::NONE })
    }

    /// Spots `balls` for `seat`, who shoots next: the red on the foot spot, the own cue ball on the
    /// head spot, the other cue ball on the centre spot. If a ball occupies that spot, the spotted
    /// ball goes to the spot of the ball in the way (article 27).
    fn spot(state: &mut FrameState, balls: &[BallIndex], seat: Seat) {
        let table = state.base.table();
        let own = |ball: BallIndex| match ball {
            RED => spot_named(table, "foot", 0.75),
            _ if usize::from(ball) == seat => spot_named(table, "head", 0.25),
            _ => spot_named(table, "center", 0.5),
        };
        let FrameState { layout, ruling, .. } = state;
        for &ball in balls {
            layout.put(ball, None);
        }
        for &ball in balls {
            let mut place = own(ball);
            // There are three balls, so at most two are in the way.
            for _ in 0..2 {
                place = layout.in_the_way(ball, place).map_or(place, own);
            }
            layout.put(ball, Some(place));
            ruling.spotted.push(ball);
        }
    }
}

impl GameRules for ThreeCushion {
    fn is_opening(&self) -> bool {
        self.is_opening
    }

    fn start(&mut self, _: &mut FrameState, breaker: Seat) -> Request {
        *self = Self::default();
        self.starting_shot(breaker)
    }

    fn resume(&mut self, state: &FrameState, seat: Seat) -> Request {
        *self = Self::default();
        self.innings[seat] = 1;
        Self::next(state, seat)
    }

    fn missing(&self, places: &[Option<[f64; 2]>]) -> Option<String> {
        places.contains(&None).then(|| "a ball is not on the table".to_owned())
    }

    fn judge(&mut self, state: &mut FrameState, shot: &PlayedShot<'_>) -> Request {
        let seat = shot.seat();
        let touched = &shot.outcome.cue_ball_touched;
        let frozen = shot.before.touching(shot.turn.cue, FROZEN);
        let pushed = |t: &Touched| matches!(t, Touched::Ball(ball) if frozen.contains(ball));
        let was_opening = core::mem::take(&mut self.is_opening);
        let first = shot.first_contact().filter(|_| was_opening);
        let indirect = first == Some(RED) && touched.first() != Some(&Touched::Ball(RED));
        let fouls = &mut state.ruling.fouls;
        fouls.add_if(shot.is_cue_ball_off_table(), Foul::CueBallOffTable);
        fouls.add_if(shot.thrown_off().next().is_some(), Foul::BallOffTable);
        fouls.add_if(first.is_some_and(|ball| ball != RED), Foul::WrongBallFirst);
        fouls.add_if(indirect, Foul::IndirectStart);
        fouls.add_if(touched.first().is_some_and(pushed), Foul::Push);
        // Article 41 makes no exception for a graze.
        fouls.add_if(shot.is_double_hit(NearHit::Grazed), Foul::DoubleHit);
        fouls.add_if(shot.is_push_shot(NearHit::Grazed), Foul::PushShot);
        Self::spot(state, &shot.outcome.off_table, shot.opponent());

        let frozen_to = frozen_to(state.base.table(), shot.before, shot.turn.cue);
        let scored = state.ruling.is_legal() && is_carom(shot.outcome, &frozen_to);
        state.ruling.points[seat] = scored.into();
        let scores = state.scores_after();
        if scored && scores[seat] < state.options.points {
            return Self::next(state, seat);
        }
        self.end_inning(state, seat, scores)
    }

    fn choose(&mut self, state: &mut FrameState, seat: Seat, choice: Choice) -> Request {
        if choice == Choice::SpotFrozen {
            let cue = seat as BallIndex;
            let mut balls = state.layout.touching(cue, FROZEN);
            balls.push(cue);
            Self::spot(state, &balls, seat);
        }
        Self::turn(seat, BallList::new())
    }

    fn describe(&self, _: &FrameLayout) -> Option<String> {
        let [one, other] = self.innings;
        Some(format!("Innings: player 0 {one}, player 1 {other}."))
    }

    fn to_node(&self, _: &FrameState) -> Node {
        Node::object([("innings", Node::list(self.innings.map(i64::from)))])
    }
}

/// Some of the four rails of a table without pockets.
type RailSet = [Option<Rail>; 4];

/// The rails to which `ball` is frozen.
fn frozen_to(table: &Table, layout: &FrameLayout, ball: BallIndex) -> RailSet {
    let Some([x, y]) = layout.place(ball) else { return RailSet::default() };
    let reach = table.reach(layout.radius(ball)) + FROZEN;
    let near = [
        (x, Rail::Left),
        (table.size.x - x, Rail::Right),
        (y, Rail::Bottom),
        (table.size.y - y, Rail::Top),
    ];
    near.map(|(distance, rail)| (distance <= reach).then_some(rail))
}

/// Whether the cue ball touched at least three cushions before its first contact with the second
/// object ball. A first touch of a cushion to which it is `frozen_to` does not count.
fn is_carom(outcome: &Outcome, frozen_to: &RailSet) -> bool {
    let touched = &outcome.cue_ball_touched;
    let mut cushions = 0;
    let mut first = None;
    let pressed =
        |t: &Touched| matches!(t, Touched::Rail(rail) if frozen_to.contains(&Some(*rail)));
    let skipped = usize::from(touched.first().is_some_and(pressed));
    for touched in &touched[skipped..] {
        match (*touched, first) {
            (Touched::Rail(_), _) => cushions += 1,
            (Touched::Ball(ball), None) => first = Some(ball),
            (Touched::Ball(ball), Some(one)) if ball != one => return cushions >= CUSHIONS,
            (Touched::Ball(_), Some(_)) => {}
        }
    }
    false
}

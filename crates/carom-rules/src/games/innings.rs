//! What the games on tables without pockets share: two cue balls, innings, the starting position and the count of
//! cushions.

use carom::outcome::Touched;

use super::game::PlayedShot;
use crate::carom_way::{CaromCount, CaromWay};
use crate::layout::{BallIndex, BallList, FROZEN};
use crate::referee::NearHit;
use crate::request::{Calls, Choice, Request, Turn};
use crate::ruling::{Foul, Fouls};
use crate::seat::{self, Seat};
use crate::state::FrameState;
use crate::state_bytes::state_bytes;

/// The red of the games with three balls. Ball 0, the white, is the cue ball of seat 0; ball 1, the yellow, is that of
/// seat 1.
pub(crate) const RED: BallIndex = 2;

/// The article of the UMB's World rules of carom billiard (1 January 1989).
pub(crate) const fn rule(foul: Foul) -> &'static str {
    match foul {
        Foul::WrongBallFirst | Foul::IndirectStart => "UMB 23",
        Foul::Push => "UMB 27",
        Foul::CueBallOffTable | Foul::BallOffTable => "UMB 28",
        Foul::DoubleHit | Foul::PushShot => "UMB 41",
        _ => "",
    }
}

/// The innings of a match.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Innings {
    /// Whether the next shot is played from the starting position.
    pub(crate) is_opening: bool,
    /// Number of innings that each seat has begun.
    pub(crate) begun: [u32; 2],
}

state_bytes!(struct Innings { is_opening, begun });

impl Innings {
    /// Those of a match in which only the places of the balls are known.
    pub(crate) fn resumed(seat: Seat) -> Self {
        let mut begun = [0; 2];
        begun[seat] = 1;
        Self { is_opening: false, begun }
    }

    /// Begins an inning of `seat` in the starting position, in which `red` must be hit first.
    pub(crate) fn start(&mut self, seat: Seat, red: BallIndex) -> Request {
        self.begun[seat] += 1;
        self.begin_again(seat, red)
    }

    /// The shot from the starting position: `red` must be hit first and directly (article 23).
    pub(crate) fn begin_again(&mut self, seat: Seat, red: BallIndex) -> Request {
        self.is_opening = true;
        turn(seat, BallList::from(&[red][..]))
    }

    /// Ends an inning of `seat` with these scores. Both players have the same number of innings (article 29): if the
    /// opponent has had one fewer, it plays a last inning from the starting position. None if the opponent goes on.
    pub(crate) fn end(
        &mut self,
        state: &mut FrameState,
        seat: Seat,
        scores: [i32; 2],
    ) -> Option<Request> {
        let opponent = seat::opponent(seat);
        if scores.iter().all(|score| *score < state.options.points) {
            self.begun[opponent] += 1;
            return None;
        }
        if self.begun[opponent] < self.begun[seat] {
            starting_position(state, opponent);
            return Some(self.start(opponent, RED));
        }
        let winner = (scores[0] != scores[1]).then_some(usize::from(scores[1] > scores[0]));
        Some(Request::Over { winner, why: "the target was reached in equal innings" })
    }

    /// The innings as a sentence.
    pub(crate) fn describe(&self) -> String {
        let [one, other] = self.begun;
        format!("Innings: player 0 {one}, player 1 {other}.")
    }
}

/// The starting position of `seat`: the red on the foot spot, the cue ball of `seat` on a starting spot, the other cue
/// ball on the head spot.
pub(crate) fn starting_position(state: &mut FrameState, seat: Seat) {
    state.rack();
    let [start, head] = [0, 1].map(|ball| state.layout.place(ball));
    let own = seat as BallIndex;
    state.layout.put(own, start);
    state.layout.put(1 - own, head);
}

/// The request to `seat`, who may have the balls spotted if the own cue ball touches another one.
pub(crate) fn next(state: &FrameState, seat: Seat) -> Request {
    if state.layout.touching(seat as BallIndex, FROZEN).is_empty() {
        return turn(seat, BallList::new());
    }
    let choices = [Choice::PlayOn, Choice::SpotFrozen];
    Request::choice(seat, &choices, "the cue ball touches another ball")
}

/// The request for a shot with the cue ball of `player`.
pub(crate) fn turn(player: Seat, on: BallList) -> Request {
    let cue = player as BallIndex;
    Request::Shot(Turn { player, cue, hand: None, on, calls: Calls::NONE })
}

/// The fouls of a shot; `red` must be hit first and directly if it was played from the starting position.
pub(crate) fn fouls(shot: &PlayedShot<'_>, was_opening: bool, red: BallIndex) -> Fouls {
    let touched = &shot.outcome.cue_ball_touched;
    let frozen = shot.before.touching(shot.turn.cue, FROZEN);
    let pushed = |t: &Touched| matches!(t, Touched::Ball(ball) if frozen.contains(ball));
    let first = shot.first_contact().filter(|_| was_opening);
    let indirect = first == Some(red) && touched.first() != Some(&Touched::Ball(red));
    let mut fouls = Fouls::NONE;
    fouls.add_if(shot.is_cue_ball_off_table(), Foul::CueBallOffTable);
    fouls.add_if(shot.thrown_off().next().is_some(), Foul::BallOffTable);
    fouls.add_if(first.is_some_and(|ball| ball != red), Foul::WrongBallFirst);
    fouls.add_if(indirect, Foul::IndirectStart);
    fouls.add_if(touched.first().is_some_and(pushed), Foul::Push);
    // Article 41 makes no exception for a graze.
    fouls.add_if(shot.is_double_hit(NearHit::Grazed), Foul::DoubleHit);
    fouls.add_if(shot.is_push_shot(NearHit::Grazed), Foul::PushShot);
    fouls
}

/// What the cue ball touched, in a shot that needs `cushions` cushions before the second object ball.
pub(crate) fn counted(state: &FrameState, shot: &PlayedShot<'_>, cushions: usize) -> CaromCount {
    let (layout, cue) = (shot.before, shot.turn.cue);
    // A cue ball that is struck lies on the table.
    let place = layout.place(cue).unwrap_or_default();
    CaromWay::new(shot.outcome, state.base.table(), place, layout.radius(cue)).count(cushions)
}

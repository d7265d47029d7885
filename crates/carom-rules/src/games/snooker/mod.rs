//! Snooker (WPBSA, Official Rules, section 3).

mod balls;
mod hidden;
mod spots;
mod stroke;

use carom::format::Node;
use carom::rack::Game;

use super::GameState;
use super::facts::{GameFacts, Objective, Opening, OpeningKind, RandomStart, Scoring, Stalemate};
use super::game::{GameRules, PlayedShot};
use crate::layout::{BallIndex, BallList, BallPlaces, FrameLayout};
use crate::region::Region;
use crate::request::{Calls, Choice, Request, Turn};
use crate::ruling::Foul;
use crate::seat::{self, Seat};
use crate::state::FrameState;
use crate::state_bytes::state_bytes;

use balls::{BLACK_VALUE, Balls};
use stroke::Stroke;

pub(crate) use balls::CUE;
pub use balls::On;
pub(super) use stroke::KeptClear;

/// Consecutive misses that lose the frame, if a ball on could be hit full each time (section 3,
/// rule 14d).
const MISSES: u32 = 3;

/// The number of the rule that sets the penalty (WPBSA, rules of snooker, section 3).
pub(super) const fn rule(foul: Foul) -> &'static str {
    match foul {
        Foul::DoubleHit => "WPBSA 3.10(a)(ii)",
        Foul::NoContact => "WPBSA 3.10(a)(vi)",
        Foul::Scratch => "WPBSA 3.10(a)(vii)",
        Foul::SnookeredByFreeBall => "WPBSA 3.10(a)(viii)",
        Foul::Jump => "WPBSA 3.10(a)(ix)",
        Foul::WrongBallPocketed => "WPBSA 3.10(b)(iii)",
        Foul::WrongBallFirst => "WPBSA 3.10(b)(iv)",
        Foul::Push | Foul::PushShot => "WPBSA 3.10(b)(v)",
        Foul::CueBallOffTable | Foul::BallOffTable => "WPBSA 3.10(b)(vii)",
        _ => "",
    }
}

/// The opening shot.
pub(super) const OPENING: Opening = Opening { kind: OpeningKind::Safety, speeds: [2.0, 7.0] };

pub(crate) const FACTS: GameFacts = GameFacts {
    game: Game::Snooker,
    players: 2,
    balls: 22,
    own_cue_balls: false,
    objective: Objective::RedsAndColors,
    deciding_ball: None,
    scoring: Scoring::Points { maximum: 147 },
    opening: OPENING,
    stalemate: Stalemate::Restart, // WPBSA, section 3, rule 16
    random_start: Some(RandomStart {
        count: [0, 15],
        always: &[CUE],
        drawn: Some([1, 15]),
        racked: Some([16, 21]),
    }),
    lag: false,
    miss: true,
    conceded: true,
    rule,
    state: || GameState::Snooker(Snooker::default()),
};

/// A frame of snooker.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Snooker {
    on: On,
    /// Whether the next shot is the first of the frame.
    is_opening: bool,
    /// Whether the player to shoot has a free ball.
    free_ball: bool,
    /// Points of the current break.
    break_points: i32,
    /// Consecutive misses from the same position with a full ball in sight.
    misses: u32,
    /// The table before the last foul, for the choice to have the balls replaced.
    before: Option<TableBefore>,
}

/// The table before a shot.
#[derive(Clone, Copy, Debug, PartialEq)]
struct TableBefore {
    places: BallPlaces,
    turn: Turn,
    on: On,
    free_ball: bool,
}

state_bytes!(struct Snooker { on, is_opening, free_ball, break_points, misses, before });
state_bytes!(struct TableBefore { places, turn, on, free_ball });

impl Snooker {
    /// Whether the player to shoot has a free ball.
    pub const fn has_free_ball(&self) -> bool {
        self.free_ball
    }

    /// Points of the current break.
    pub const fn break_points(&self) -> i32 {
        self.break_points
    }

    fn turn(&self, state: &FrameState, player: Seat, hand: Option<Region>) -> Request {
        let lost = state.layout.is_down(CUE).then_some(Region::TheD);
        let nominate = self.free_ball || self.on == On::Color;
        let on = if self.free_ball {
            state.layout.left(1..=Balls::of(&state.layout).black())
        } else {
            self.on.balls(&state.layout)
        };
        let calls = Calls { nominate, ..Calls::NONE };
        Request::Shot(Turn { player, cue: CUE, hand: hand.or(lost), on, calls })
    }

    /// The most points that the balls on the table can score without fouls: a black with every red,
    /// then the colours. A player who trails by more needs penalty points.
    pub(crate) fn points_left(&self, layout: &FrameLayout) -> i32 {
        let balls = Balls::of(layout);
        let reds = layout.left(balls.reds()).len() as i32;
        let left = layout.left(balls.colors());
        let colors: i32 = left.iter().map(|color| balls.value(*color)).sum();
        let black = if self.on == On::Color { BLACK_VALUE } else { 0 };
        reds * (1 + BLACK_VALUE) + black + colors
    }

    /// Whether, after this shot, the player who trails can still win without penalty points.
    pub(super) fn is_open(&self, state: &FrameState) -> bool {
        lead(state.scores_after()) < self.points_left(&state.layout)
    }

    /// The request to `seat`, who has the cue ball in hand in `region` and no free ball.
    pub(super) fn play_from(&mut self, state: &FrameState, seat: Seat, region: Region) -> Request {
        self.free_ball = false;
        self.misses = 0;
        self.before = None;
        self.turn(state, seat, Some(region))
    }

    /// Points of a legal shot: one for each red, or the value of the ball on. A free ball counts as
    /// the ball on.
    fn score(&self, shot: &PlayedShot<'_>, stroke: &Stroke) -> i32 {
        let potted = shot.potted().count() as i32;
        match self.on {
            On::Red => potted,
            // The ball on and a free ball pocketed in one stroke count once (rule 12e).
            _ if potted == 0 => 0,
            _ => stroke.value,
        }
    }

    /// Updates what is on after a shot: a colour after a red, else a red; the colours in order once
    /// the reds are gone.
    fn advance(&mut self, state: &FrameState, after_red: bool) {
        self.free_ball = false;
        self.on = match self.on {
            On::Red if after_red => On::Color,
            _ if state.layout.left(Balls::of(&state.layout).reds()).is_empty() => On::Sequence,
            _ => On::Red,
        };
    }

    fn after_foul(
        &mut self,
        state: &mut FrameState,
        shot: &PlayedShot<'_>,
        stroke: &Stroke,
    ) -> Request {
        let opponent = shot.opponent();
        self.before = Some(TableBefore {
            places: *shot.before.places(),
            turn: *shot.turn,
            on: self.on,
            free_ball: self.free_ball,
        });
        self.break_points = 0;
        let worth_before = self.points_left(shot.before);
        self.advance(state, false);
        if let Some(end) = self.end(state, shot) {
            return end;
        }
        let is_open = lead(state.scores) < worth_before && self.is_open(state);
        // After a miss with a full ball in sight, another miss from the same position is called at
        // any score (rule 14d).
        let misses = state.options.miss && stroke.missed && (is_open || self.misses > 0);
        self.misses = if misses && stroke.full_ball { self.misses + 1 } else { 0 };
        if self.misses >= MISSES {
            return Request::won(opponent, "three misses in a row with a ball in sight");
        }
        let on = self.on.balls(&state.layout);
        self.free_ball = hidden::is_snookered(state.base.table(), &state.layout, &on);
        let why = match (misses, self.free_ball) {
            (true, true) => "a foul and a miss, and a free ball",
            (true, false) => "a foul and a miss",
            (false, true) => "a foul, and a free ball",
            (false, false) => "a foul",
        };
        let choices = [Choice::PlayOn, Choice::PassBack, Choice::Replace];
        Request::choice(opponent, if misses { &choices } else { &choices[..2] }, why)
    }

    /// Rules on a shot, as [`GameRules::judge`].
    pub(super) fn judge_with(
        &mut self,
        state: &mut FrameState,
        shot: &PlayedShot<'_>,
        kept_clear: KeptClear,
    ) -> Request {
        self.is_opening = false;
        let (seat, opponent) = (shot.seat(), shot.opponent());
        let stroke = Stroke::of(self.on, self.free_ball, shot);
        let (fouls, penalty) = stroke.fouls(state, shot, kept_clear);
        state.ruling.fouls = fouls;
        let legal = fouls.is_empty();
        let scored = if legal { self.score(shot, &stroke) } else { 0 };

        // When the colours are on in order, the ball on stays down.
        let in_sequence = legal && self.on == On::Sequence;
        let stays = if in_sequence { self.on.balls(shot.before) } else { BallList::new() };
        let gone = |ball: &BallIndex| !shot.before.is_down(*ball) && state.layout.is_down(*ball);
        let colors = Balls::of(shot.before).colors();
        let back: BallList = colors.filter(gone).filter(|ball| !stays.contains(ball)).collect();
        spots::put_back(state, &back);

        if !legal {
            state.ruling.points[opponent] = penalty;
            state.fouls[seat] += 1;
            return self.after_foul(state, shot, &stroke);
        }
        state.ruling.points[seat] = scored;
        state.fouls[seat] = 0;
        self.misses = 0;
        self.advance(state, scored > 0);
        self.break_points = if scored > 0 { self.break_points + scored } else { 0 };
        if let Some(end) = self.end(state, shot) {
            return end;
        }
        self.turn(state, if scored > 0 { seat } else { opponent }, None)
    }

    /// The end of the frame, if this shot ended it. With only the black left, the first score or
    /// foul ends the frame. If the scores are then equal, the black is spotted, a random player
    /// chooses who plays, and the next score or foul decides (rule 4).
    fn end(&self, state: &mut FrameState, shot: &PlayedShot<'_>) -> Option<Request> {
        let black = Balls::of(shot.before).black();
        let decided = shot.before.left(1..=black) == [black] && state.ruling.points != [0, 0];
        if !decided {
            return None;
        }
        let scores = state.scores_after();
        if scores[0] != scores[1] {
            let winner = usize::from(scores[1] > scores[0]);
            return Some(Request::won(winner, "the black decided"));
        }
        state.layout.put(CUE, None);
        spots::put_back(state, &[black]);
        let lot = (state.next_seed() >> 32) as usize & 1;
        let choices = [Choice::PlayOn, Choice::PassBack];
        Some(Request::choice(lot, &choices, "the scores are equal: the black is played for"))
    }
}

/// Difference of the scores.
const fn lead(scores: [i32; 2]) -> i32 {
    (scores[0] - scores[1]).abs()
}

impl GameRules for Snooker {
    fn is_opening(&self) -> bool {
        self.is_opening
    }

    fn start(&mut self, state: &mut FrameState, breaker: Seat) -> Request {
        *self = Self { is_opening: true, ..Self::default() };
        self.turn(state, breaker, Some(Region::TheD))
    }

    fn resume(&mut self, state: &FrameState, seat: Seat) -> Request {
        let on = On::Color.after_a_miss(&state.layout);
        *self = Self { on, ..Self::default() };
        self.turn(state, seat, None)
    }

    fn missing(&self, places: &[Option<[f64; 2]>]) -> Option<String> {
        let is_down = |ball: BallIndex| places[usize::from(ball)].is_none();
        let (balls, black) = (Balls::of_count(places.len()), Balls::of_count(places.len()).black());
        let red_left = balls.reds().any(|red| !is_down(red));
        let next = balls.colors().find(|color| red_left || !is_down(*color)).unwrap_or(black);
        let gone = (next..=black).find(|color| is_down(*color))?;
        Some(format!("the colour of {} points is down", balls.value(gone)))
    }

    fn judge(&mut self, state: &mut FrameState, shot: &PlayedShot<'_>) -> Request {
        self.judge_with(state, shot, KeptClear::FreeBall)
    }

    fn choose(&mut self, state: &mut FrameState, seat: Seat, choice: Choice) -> Request {
        match (choice, self.before.take()) {
            (Choice::Replace, Some(before)) => {
                state.layout.put_all(&before.places);
                self.on = before.on;
                self.free_ball = before.free_ball;
                Request::Shot(Turn { hand: None, ..before.turn })
            }
            (Choice::PassBack, _) => {
                // The offender who is asked to play again has no free ball (rule 12f).
                self.free_ball = false;
                self.misses = 0;
                self.turn(state, seat::opponent(seat), None)
            }
            _ => {
                self.misses = 0;
                self.turn(state, seat, None)
            }
        }
    }

    fn kind_on(&self) -> Option<On> {
        Some(self.on)
    }

    fn value(&self, layout: &FrameLayout, ball: BallIndex) -> i32 {
        Balls::of(layout).value(ball)
    }

    fn describe(&self, layout: &FrameLayout) -> Option<String> {
        let on = match self.on {
            _ if self.free_ball => "a free ball",
            On::Red => "a red",
            On::Color => "a colour",
            On::Sequence => "the colours in order",
        };
        let (made, left) = (self.break_points, self.points_left(layout));
        Some(format!("On: {on}. Break: {made} points. Left on the table: {left} points."))
    }

    fn to_node(&self, state: &FrameState) -> Node {
        let on = match self.on {
            On::Red => "red",
            On::Color => "color",
            On::Sequence => "sequence",
        };
        Node::object([
            ("on", on.into()),
            ("free_ball", self.free_ball.into()),
            ("break", i64::from(self.break_points).into()),
            ("points_left", i64::from(self.points_left(&state.layout)).into()),
        ])
    }
}

//! Snooker (WPBSA, Official Rules, section 3).

mod hidden;
mod spots;
mod stroke;

use carom::format::Node;

use crate::frame::State;
use crate::games::{Game, Played};
use crate::layout::Layout;
use crate::request::{Calls, Choice, Region, Request, Turn};
use crate::ruling::Foul;
use crate::{BallIndex, Player};

use stroke::Stroke;

const CUE: BallIndex = 0;
pub(crate) const REDS: core::ops::RangeInclusive<BallIndex> = 1..=15;
const YELLOW: BallIndex = 16;
pub(crate) const BLACK: BallIndex = 21;
pub(crate) const COLORS: core::ops::RangeInclusive<BallIndex> = YELLOW..=BLACK;

/// Misses in a row with a full ball in sight that lose the frame (section 3, rule 14d).
const MISSES: u32 = 3;

/// Points for `ball`.
pub const fn value(ball: BallIndex) -> i32 {
    if ball >= YELLOW { ball as i32 - 14 } else { 1 }
}

/// The place in the WPBSA's rules of snooker, section 3, that sets the penalty.
pub(crate) const fn rule(foul: Foul) -> &'static str {
    match foul {
        Foul::NoContact => "WPBSA 3.10(a)(vi)",
        Foul::Scratch => "WPBSA 3.10(a)(vii)",
        Foul::SnookeredByFreeBall => "WPBSA 3.10(a)(viii)",
        Foul::Jump => "WPBSA 3.10(a)(ix)",
        Foul::WrongBallPocketed => "WPBSA 3.10(b)(iii)",
        Foul::WrongBallFirst => "WPBSA 3.10(b)(iv)",
        Foul::Push => "WPBSA 3.10(b)(v)",
        Foul::CueBallOffTable | Foul::BallOffTable => "WPBSA 3.10(b)(vii)",
        _ => "",
    }
}

/// What is on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum On {
    /// Any red.
    #[default]
    Red,
    /// A colour of the player's choice, after a red.
    Color,
    /// The colours in ascending order.
    Sequence,
}

/// A frame of snooker.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Snooker {
    on: On,
    /// The player has a free ball.
    free_ball: bool,
    /// Points of the present break.
    run: i32,
    /// Misses in a row from the same position with a full ball in sight.
    misses: u32,
    /// Before the last foul: to put the balls back.
    before: Option<Before>,
}

/// The table before a shot.
#[derive(Clone, Debug, PartialEq)]
struct Before {
    layout: Layout,
    turn: Turn,
    on: On,
    free_ball: bool,
}

impl Snooker {
    /// What is on.
    pub const fn on(&self) -> On {
        self.on
    }

    /// Whether the player to shoot has a free ball.
    pub const fn has_free_ball(&self) -> bool {
        self.free_ball
    }

    /// Points of the present break.
    pub const fn run(&self) -> i32 {
        self.run
    }

    fn turn(&self, state: &State, player: Player, hand: Option<Region>) -> Request {
        let lost = state.layout.is_down(CUE).then_some(Region::TheD);
        let nominate = self.free_ball || self.on == On::Color;
        let on = if self.free_ball {
            state.layout.left(1..=BLACK)
        } else {
            self.balls_on(&state.layout)
        };
        let calls = Calls { nominate, ..Calls::NONE };
        Request::Shot(Turn { player, cue: CUE, hand: hand.or(lost), on, calls })
    }

    /// The balls on, but for a free ball.
    fn balls_on(&self, layout: &Layout) -> Vec<BallIndex> {
        match self.on {
            On::Red => layout.left(REDS),
            On::Color => layout.left(COLORS),
            On::Sequence => layout.left(COLORS).into_iter().take(1).collect(),
        }
    }

    /// The most points that the balls are worth: a black with every red, then the colours. Who is behind by
    /// more needs penalty points.
    fn worth(&self, layout: &Layout) -> i32 {
        let reds = layout.left(REDS).len() as i32;
        let colors: i32 = layout.left(COLORS).into_iter().map(value).sum();
        let black = if self.on == On::Color { value(BLACK) } else { 0 };
        reds * (1 + value(BLACK)) + black + colors
    }

    /// Points of a legal shot: every red, or the ball on; a free ball counts as the ball on.
    fn score(&self, shot: &Played<'_>, stroke: &Stroke) -> i32 {
        let potted = shot.facts.potted().count() as i32;
        match self.on {
            On::Red => potted,
            // The ball on and a free ball that fall together count once (rule 12e).
            _ if potted == 0 => 0,
            _ => stroke.value,
        }
    }

    /// What is on after a shot: a colour after a red, else a red, or the sequence once the reds are gone.
    fn advance(&mut self, state: &State, after_red: bool) {
        self.free_ball = false;
        self.on = match self.on {
            On::Red if after_red => On::Color,
            _ if state.layout.left(REDS).is_empty() => On::Sequence,
            _ => On::Red,
        };
    }

    fn after_foul(&mut self, state: &mut State, shot: &Played<'_>, stroke: &Stroke) -> Request {
        let other = shot.other();
        self.before = Some(Before {
            layout: shot.before.clone(),
            turn: shot.turn.clone(),
            on: self.on,
            free_ball: self.free_ball,
        });
        self.run = 0;
        let worth_before = self.worth(shot.before);
        self.advance(state, false);
        if let Some(end) = self.end(state, shot) {
            return end;
        }
        let is_open = lead(state.scores) < worth_before
            && lead(state.scores_after()) < self.worth(&state.layout);
        // After one with a full ball in sight another from there is a miss at any score (rule 14d).
        let misses = state.options.miss && stroke.missed && (is_open || self.misses > 0);
        self.misses = if misses && stroke.full_ball { self.misses + 1 } else { 0 };
        if self.misses >= MISSES {
            return Request::won(other, "three misses in a row with a ball in sight");
        }
        let on = self.balls_on(&state.layout);
        self.free_ball = hidden::is_snookered(state.base.table(), &state.layout, &on);
        let why = match (misses, self.free_ball) {
            (true, true) => "a foul and a miss, and a free ball",
            (true, false) => "a foul and a miss",
            (false, true) => "a foul, and a free ball",
            (false, false) => "a foul",
        };
        let choices = [Choice::PlayOn, Choice::PassBack, Choice::Replace];
        Request::choice(other, if misses { &choices } else { &choices[..2] }, why)
    }

    /// With only the black left, the first score or foul ends the frame; if the scores are equal then, the
    /// black is spotted, the lot says who chooses, and the next score or foul decides (rule 4).
    fn end(&self, state: &mut State, shot: &Played<'_>) -> Option<Request> {
        let decided = shot.before.left(1..=BLACK) == [BLACK] && state.ruling.points != [0, 0];
        if !decided {
            return None;
        }
        let scores = state.scores_after();
        if scores[0] != scores[1] {
            let winner = usize::from(scores[1] > scores[0]);
            return Some(Request::won(winner, "the black decided"));
        }
        state.layout.put(CUE, None);
        spots::put_back(state, [BLACK]);
        let lot = (state.next_seed() >> 32) as usize & 1;
        let choices = [Choice::PlayOn, Choice::PassBack];
        Some(Request::choice(lot, &choices, "the scores are equal: the black is played for"))
    }
}

/// By how much one player leads.
const fn lead(scores: [i32; 2]) -> i32 {
    (scores[0] - scores[1]).abs()
}

impl Game for Snooker {
    fn open(&mut self, state: &mut State, breaker: Player) -> Request {
        *self = Self::default();
        self.turn(state, breaker, Some(Region::TheD))
    }

    fn middle(&mut self, state: &State, player: Player) -> Request {
        let on = if state.layout.left(REDS).is_empty() { On::Sequence } else { On::Red };
        *self = Self { on, ..Self::default() };
        self.turn(state, player, None)
    }

    fn judge(&mut self, state: &mut State, shot: &Played<'_>) -> Request {
        let (player, other) = (shot.player(), shot.other());
        let stroke = Stroke::of(self, shot);
        let (fouls, penalty) = stroke.fouls(self, state, shot);
        state.ruling.fouls = fouls;
        let legal = fouls.is_empty();
        let scored = if legal { self.score(shot, &stroke) } else { 0 };

        // In the sequence the ball on stays down.
        let stays =
            if legal && self.on == On::Sequence { self.balls_on(shot.before) } else { vec![] };
        let gone = |ball: &BallIndex| !shot.before.is_down(*ball) && state.layout.is_down(*ball);
        let back: Vec<_> = COLORS.filter(gone).filter(|ball| !stays.contains(ball)).collect();
        spots::put_back(state, back);

        if !legal {
            state.ruling.points[other] = penalty;
            state.fouls[player] += 1;
            return self.after_foul(state, shot, &stroke);
        }
        state.ruling.points[player] = scored;
        state.fouls[player] = 0;
        self.misses = 0;
        self.advance(state, scored > 0);
        self.run = if scored > 0 { self.run + scored } else { 0 };
        if let Some(end) = self.end(state, shot) {
            return end;
        }
        self.turn(state, if scored > 0 { player } else { other }, None)
    }

    fn choose(&mut self, state: &mut State, player: Player, choice: Choice) -> Request {
        match (choice, self.before.take()) {
            (Choice::Replace, Some(before)) => {
                state.layout = before.layout;
                self.on = before.on;
                self.free_ball = before.free_ball;
                Request::Shot(Turn { hand: None, ..before.turn })
            }
            (Choice::PassBack, _) => {
                // A free ball is for who takes the table (rule 12f).
                self.free_ball = false;
                self.misses = 0;
                self.turn(state, 1 - player, None)
            }
            _ => {
                self.misses = 0;
                self.turn(state, player, None)
            }
        }
    }

    fn to_node(&self, state: &State) -> Node {
        let on = match self.on {
            On::Red => "red",
            On::Color => "color",
            On::Sequence => "sequence",
        };
        Node::object([
            ("on", on.into()),
            ("free_ball", self.free_ball.into()),
            ("break", i64::from(self.run).into()),
            ("points_left", i64::from(self.worth(&state.layout)).into()),
        ])
    }
}

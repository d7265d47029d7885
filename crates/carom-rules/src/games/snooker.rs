//! Snooker (WPBSA, Official Rules, section 3).

use carom::shot::Node;

use crate::facts::Touch;
use crate::frame::State;
use crate::games::{Game, Played};
use crate::layout::{Layout, distance, spot_named};
use crate::play::Call;
use crate::request::{Calls, Choice, Region, Request, Turn};
use crate::ruling::{Foul, Fouls};
use crate::{BallIndex, Player};

mod hidden;

const CUE: BallIndex = 0;
pub(crate) const REDS: core::ops::RangeInclusive<BallIndex> = 1..=15;
const YELLOW: BallIndex = 16;
pub(crate) const BLACK: BallIndex = 21;
pub(crate) const COLORS: core::ops::RangeInclusive<BallIndex> = YELLOW..=BLACK;

/// The least penalty for a foul.
const LEAST_PENALTY: i32 = 4;

/// Failures in a row to hit a ball that could be seen that lose the frame, after a warning (section 3,
/// rule 14).
const MISSES: u32 = 3;

/// Balls nearer than this touch, m: the same that the shot file calls touching.
const TOUCHING: f64 = carom::table::TOUCH_TOLERANCE;

/// Points for `ball`.
pub const fn value(ball: BallIndex) -> i32 {
    if ball >= YELLOW { ball as i32 - 14 } else { 1 }
}

/// The rule's place in the WPBSA's rules of snooker, section 3.
pub(crate) const fn rule(foul: Foul) -> &'static str {
    match foul {
        Foul::Scratch
        | Foul::CueBallOffTable
        | Foul::NoContact
        | Foul::WrongBallFirst
        | Foul::BallOffTable
        | Foul::WrongBallPocketed
        | Foul::Jump
        | Foul::Push
        | Foul::SnookeredByFreeBall => "WPBSA 3.10",
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
    /// Misses in a row that the player could have avoided.
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

    /// Points for the ball on.
    fn value_on(&self, shot: &Played<'_>) -> i32 {
        match (self.on, shot.play.call) {
            (On::Red, _) => 1,
            (On::Color, Call::On(ball)) => value(ball),
            (On::Color, _) => value(BLACK),
            (On::Sequence, _) => self.balls_on(shot.before).first().map_or(0, |b| value(*b)),
        }
    }

    /// The balls that may be hit first and pocketed in this shot.
    fn allowed(&self, shot: &Played<'_>) -> Vec<BallIndex> {
        match (self.on, self.free_ball, shot.play.call) {
            (On::Color, _, Call::On(ball)) => vec![ball],
            (_, true, Call::On(ball)) => {
                let mut allowed = self.balls_on(shot.before);
                allowed.push(ball);
                allowed
            }
            _ => self.balls_on(shot.before),
        }
    }

    /// Notes the fouls and returns their penalty.
    fn fouls(
        &self,
        state: &mut State,
        shot: &Played<'_>,
        allowed: &[BallIndex],
        touching: &[BallIndex],
        value_on: i32,
    ) -> i32 {
        let facts = shot.facts;
        let mut fouls = Fouls::NONE;
        let mut concerned = LEAST_PENALTY.max(value_on);
        let mut foul = |committed: bool, foul, points: i32| {
            if committed {
                fouls.add_if(true, foul);
                concerned = concerned.max(points);
            }
        };
        foul(facts.is_scratch(), Foul::Scratch, 0);
        foul(facts.off_table.contains(&CUE), Foul::CueBallOffTable, 0);
        let first = facts.first_contact();
        // Who plays away from a touching ball that is on has hit it.
        let played_away = touching.iter().any(|ball| allowed.contains(ball));
        foul(first.is_none() && !played_away, Foul::NoContact, 0);
        if let Some(first) = first {
            let pushed =
                touching.contains(&first) && facts.touched.first() == Some(&Touch::Ball(first));
            foul(pushed, Foul::Push, value(first));
            let wrong = !allowed.contains(&first) && !played_away;
            foul(wrong, Foul::WrongBallFirst, value(first));
        }
        for ball in facts.potted() {
            foul(!allowed.contains(&ball), Foul::WrongBallPocketed, value(ball));
        }
        for ball in facts.thrown_off() {
            foul(true, Foul::BallOffTable, value(ball));
        }
        foul(facts.jumped, Foul::Jump, 0);
        if self.free_ball {
            foul(self.is_behind_free_ball(state, shot), Foul::SnookeredByFreeBall, 0);
        }
        state.ruling.fouls = fouls;
        concerned
    }

    /// Whether a legal shot would leave the other player snookered by the free ball; only pink and black
    /// may (section 3, rule 12).
    fn is_behind_free_ball(&self, state: &State, shot: &Played<'_>) -> bool {
        let Call::On(free) = shot.play.call else { return false };
        let on = self.balls_on(&state.layout);
        let few = state.layout.on_table().filter(|ball| *ball != CUE).count() <= 2;
        let fell = shot.facts.pocketed.iter().any(|(ball, _)| *ball == free);
        if few || fell || on.contains(&free) || state.layout.is_down(CUE) {
            return false;
        }
        hidden::hides_all(&state.layout, &on, |ball| ball == free)
    }

    /// Whether the ball on was not hit first, for which a miss can be called (section 3, rule 14).
    fn is_miss(&self, shot: &Played<'_>, allowed: &[BallIndex], touching: &[BallIndex]) -> bool {
        let hit = shot.facts.first_contact().is_some_and(|first| allowed.contains(&first));
        !hit && !touching.iter().any(|ball| allowed.contains(ball))
    }

    /// Points of a legal shot: every red, or the ball on; a free ball counts as the ball on.
    fn score(&self, shot: &Played<'_>, value_on: i32) -> i32 {
        let potted = shot.facts.potted().count() as i32;
        match self.on {
            On::Red => potted,
            // The ball on and a free ball that fall together count once (section 3, rule 12).
            _ if potted == 0 => 0,
            _ => value_on,
        }
    }

    /// What is on after a legal shot.
    fn advance(&mut self, state: &State, scored: bool) {
        let reds = !state.layout.left(REDS).is_empty();
        self.on = match self.on {
            On::Red if scored => On::Color,
            _ if reds => On::Red,
            _ => On::Sequence,
        };
    }

    /// Colours come back, but for the one that was the ball on in the sequence.
    fn spot_colors(&self, state: &mut State, shot: &Played<'_>) {
        let last = (self.on == On::Sequence && state.ruling.is_legal())
            .then(|| self.balls_on(shot.before).first().copied())
            .flatten();
        // The highest first (section 3, rule 7).
        for ball in COLORS.rev().filter(|ball| Some(*ball) != last) {
            let gone = !shot.before.is_down(ball) && state.layout.is_down(ball);
            if gone {
                spot_color(state, ball);
                state.ruling.spotted.push(ball);
            }
        }
    }

    fn after_foul(&mut self, state: &mut State, shot: &Played<'_>, missed: bool) -> Request {
        let player = shot.turn.player;
        let other = 1 - player;
        let visible = !hidden::is_snookered(state.base.table(), shot.before, &self.allowed(shot));
        self.before = Some(Before {
            layout: shot.before.clone(),
            turn: shot.turn.clone(),
            on: self.on,
            free_ball: self.free_ball,
        });
        self.run = 0;
        if let Some(end) = self.end(state, shot) {
            return end;
        }
        let behind = state.scores[player] + self.left_on_table(shot.before) < state.scores[other];
        let miss = missed && state.options.miss && !behind && self.on_enough(shot);
        self.misses = if miss && visible { self.misses + 1 } else { 0 };
        if self.misses >= MISSES {
            let why = "three misses in a row with a ball in sight";
            return Request::Over { winner: Some(other), why };
        }
        self.free_ball = false;
        // A colour after a red is no more on; the reds are, or the sequence.
        self.on = if state.layout.left(REDS).is_empty() { On::Sequence } else { On::Red };
        let on = self.balls_on(&state.layout);
        let snookered = hidden::is_snookered(state.base.table(), &state.layout, &on);
        self.free_ball = snookered;
        let mut choices = vec![Choice::PlayOn, Choice::PassBack];
        if miss {
            choices.push(Choice::Replace);
        }
        let why = match (miss, snookered) {
            (true, true) => "a foul and a miss, and a free ball",
            (true, false) => "a foul and a miss",
            (false, true) => "a foul, and a free ball",
            (false, false) => "a foul",
        };
        Request::Choice { player: other, choices, why }
    }

    /// A miss is called only while more than the black is left.
    fn on_enough(&self, shot: &Played<'_>) -> bool {
        shot.before.on_table().filter(|ball| *ball != CUE).count() > 1
    }

    /// The most points that the balls on the table are worth: a black with every red, then the colours.
    fn left_on_table(&self, layout: &Layout) -> i32 {
        let reds = layout.left(REDS).len() as i32;
        let colors: i32 = layout.left(COLORS).into_iter().map(value).sum();
        reds * (1 + value(BLACK)) + colors
    }

    /// With only the black left, the first score or foul ends the frame; if the scores are equal then, the
    /// black is spotted, and the next decides (section 3, rule 4).
    fn end(&self, state: &mut State, shot: &Played<'_>) -> Option<Request> {
        let decided = shot.before.left(1..=BLACK) == [BLACK] && state.ruling.points != [0, 0];
        if !decided {
            return None;
        }
        let scores = [0, 1].map(|player| state.scores[player] + state.ruling.points[player]);
        if scores[0] != scores[1] {
            let winner = usize::from(scores[1] > scores[0]);
            return Some(Request::Over { winner: Some(winner), why: "the black decided" });
        }
        spot_color(state, BLACK);
        state.layout.put(CUE, None);
        // The lot falls on one of the two by the seed.
        let player = (state.next_seed() >> 32) as usize & 1;
        Some(self.turn(state, player, Some(Region::TheD)))
    }
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
        let player = shot.player();
        let allowed = self.allowed(shot);
        let value_on = self.value_on(shot);
        let touching = touching(shot.before);
        let penalty = self.fouls(state, shot, &allowed, &touching, value_on);
        let missed = self.is_miss(shot, &allowed, &touching);
        let scored = if state.ruling.is_legal() { self.score(shot, value_on) } else { 0 };
        self.spot_colors(state, shot);
        if !state.ruling.is_legal() {
            state.ruling.points[1 - player] = penalty;
            state.fouls[player] += 1;
            return self.after_foul(state, shot, missed);
        }
        state.ruling.points[player] = scored;
        state.fouls[player] = 0;
        self.misses = 0;
        self.free_ball = false;
        self.advance(state, scored > 0);
        self.run = if scored > 0 { self.run + scored } else { 0 };
        if let Some(end) = self.end(state, shot) {
            return end;
        }
        self.turn(state, if scored > 0 { player } else { 1 - player }, None)
    }

    fn choose(&mut self, state: &mut State, player: Player, choice: Choice) -> Request {
        let other = 1 - player;
        match (choice, self.before.take()) {
            (Choice::Replace, Some(before)) => {
                state.layout = before.layout;
                self.on = before.on;
                self.free_ball = before.free_ball;
                Request::Shot(Turn { hand: None, ..before.turn })
            }
            (Choice::PassBack, _) => {
                self.free_ball = false;
                self.misses = 0;
                self.turn(state, other, None)
            }
            _ => {
                self.misses = 0;
                self.turn(state, player, None)
            }
        }
    }
    fn to_node(&self) -> Node {
        let on = match self.on {
            On::Red => "red",
            On::Color => "color",
            On::Sequence => "sequence",
        };
        Node::object([
            ("on", on.into()),
            ("free_ball", self.free_ball.into()),
            ("break", i64::from(self.run).into()),
        ])
    }
}
/// The balls that touch the cue ball.
fn touching(layout: &Layout) -> Vec<BallIndex> {
    let Some(cue) = layout.place(CUE) else { return Vec::new() };
    let radius = |ball: BallIndex| layout.pieces()[usize::from(ball)].ball.radius;
    let touches = |ball: &BallIndex| {
        let reach = radius(CUE) + radius(*ball) + TOUCHING;
        *ball != CUE && layout.place(*ball).is_some_and(|place| distance(place, cue) <= reach)
    };
    layout.on_table().filter(touches).collect()
}

/// A colour goes to its spot; if that is occupied, to the highest that is free; if none is, as near to its
/// own as possible, towards the top cushion (section 3, rule 7).
fn spot_color(state: &mut State, ball: BallIndex) {
    let table = state.base.table().clone();
    let own = spot_of(&table, ball);
    state.layout.put(ball, None);
    let free = [ball].into_iter().chain(COLORS.rev());
    let place = free.map(|b| spot_of(&table, b)).find(|spot| state.layout.is_free(ball, *spot));
    match place {
        Some(place) => state.layout.put(ball, Some(place)),
        None => state.layout.spot(ball, own, CUE, &table),
    }
}

fn spot_of(table: &carom::Table, ball: BallIndex) -> [f64; 2] {
    match ball {
        16 => spot_named(table, "yellow", 0.2),
        17 => spot_named(table, "green", 0.2),
        18 => spot_named(table, "brown", 0.2),
        19 => spot_named(table, "blue", 0.5),
        20 => spot_named(table, "pink", 0.75),
        _ => spot_named(table, "black", 10.0 / 11.0),
    }
}

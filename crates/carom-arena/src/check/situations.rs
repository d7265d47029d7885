//! The situations in which a player is asked.

use carom::noise::Perception;
use carom_rules::games::eight_ball::Group;
use carom_rules::{Choice, Game, Region, Request};

use super::scripts::{Step, is_choice};
use crate::arena_frame::Ask;
use crate::settings::Disclosure;

/// Standard deviation of the places at which a player sees the balls, per coordinate, m: a tenth of a
/// ball's radius, more than a player at a table would err.
const SEEN: f64 = 0.003;

/// What is special about how a situation is played.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mode {
    /// The player is asked, and its answer is judged.
    Plain,
    /// Its first answer is refused.
    Refused,
    /// Its clock is short.
    ShortClock,
    /// No errors are disclosed: the messages have null for them. For programs alone.
    Undisclosed,
    /// The player sees the balls with errors. For programs alone.
    Perceived,
    /// The request has a menu. For programs alone.
    Menu,
    /// The messages have keys, and a message comes, that the protocol does not have. For programs alone.
    Unknown,
    /// The player plays to the end of the frame.
    WholeFrame,
}

/// A situation.
#[derive(Clone, Debug)]
pub(super) struct CheckSituation {
    /// Its name.
    pub(super) name: String,
    pub(super) game: Game,
    /// The answers that lead there from a rack.
    pub(super) steps: Vec<Step>,
    /// The most answers that may lead there; the searching player gives those after `steps`.
    pub(super) most: usize,
    /// Whether a request is the one that is meant.
    pub(super) is_reached: fn(&Ask<'_>) -> bool,
    pub(super) mode: Mode,
    /// The rack that is tried first: one that has led there, where few do.
    pub(super) first_rack: u64,
}

impl CheckSituation {
    fn new(name: &str, game: Game, steps: &[Step], is_reached: fn(&Ask<'_>) -> bool) -> Self {
        let steps = steps.to_vec();
        Self {
            name: name.into(),
            game,
            most: steps.len(),
            steps,
            is_reached,
            mode: Mode::Plain,
            first_rack: 0,
        }
    }

    fn within(self, most: usize) -> Self {
        Self { most, ..self }
    }

    fn racked_first(self, first_rack: u64) -> Self {
        Self { first_rack, ..self }
    }

    fn with(self, mode: Mode) -> Self {
        Self { mode, ..self }
    }

    /// The errors that the situation discloses.
    pub(super) const fn disclosure(&self) -> Disclosure {
        match self.mode {
            Mode::Undisclosed => Disclosure::Nothing,
            _ => Disclosure::Both,
        }
    }

    /// The errors with which the player sees the balls.
    pub(super) const fn perception(&self) -> Perception {
        Perception::round(if matches!(self.mode, Mode::Perceived) { SEEN } else { 0.0 })
    }

    /// Whether only a program can be asked.
    pub(super) const fn is_for_programs(&self) -> bool {
        matches!(self.mode, Mode::Menu | Mode::Unknown | Mode::Undisclosed | Mode::Perceived)
    }
}

/// All situations, in the order in which they are checked.
pub(super) fn all() -> Vec<CheckSituation> {
    use Game::{EightBall, NineBall, Snooker};
    use Step::{BehindBrown, Choose, Nothing, Opening, PushOut};
    let any = |_: &Ask<'_>| true;
    let of = CheckSituation::new;
    let openings = Game::ALL.map(|game| of(&format!("opening of {}", game.name()), game, &[], any));
    let rest = [
        of("cue ball in hand anywhere", NineBall, &[Nothing], is_in_hand),
        of("choice after a foul on the break", EightBall, &[Nothing], is_choice),
        of(
            "cue ball in hand behind the head string",
            EightBall,
            &[Nothing, Choose(Choice::PlayFromHand)],
            |ask| {
                let turn = ask.situation.frame.turn();
                turn.is_some_and(|turn| turn.hand == Some(Region::BehindHeadString))
            },
        ),
        of("choice to spot the eight", EightBall, &[Opening], |ask| offers(ask, Choice::SpotEight))
            .racked_first(54),
        of("push-out allowed", NineBall, &[Opening], |ask| {
            ask.situation.frame.turn().is_some_and(|turn| turn.calls.push_out)
        }),
        of("choice after a push-out", NineBall, &[Opening, PushOut], |ask| {
            offers(ask, Choice::PassBack)
        }),
        of("warning of three fouls", NineBall, &[Nothing; 4], |ask| {
            ask.situation.frame.fouls_in_a_row()[ask.seat] == 2
        }),
        of("called shot", EightBall, &[Opening], |ask| {
            ask.situation.frame.turn().is_some_and(|turn| turn.calls.required)
        }),
        of("own group", EightBall, &[Opening], has_group).within(12),
        of("foul and a miss", Snooker, &[Nothing], |ask| offers(ask, Choice::Replace)),
        of("shot replayed after a miss", Snooker, &[Nothing, Choose(Choice::Replace)], |ask| {
            ask.situation.frame.turn().is_some() && ask.seat == 0
        }),
        of("free ball", Snooker, &[BehindBrown, Choose(Choice::PlayOn)], |ask| {
            ask.situation.frame.turn().is_some_and(|turn| turn.calls.nominate)
        }),
        of("colour to nominate", Snooker, &[Opening], |ask| {
            ask.situation.frame.turn().is_some_and(|turn| turn.calls.nominate)
        })
        .within(40),
        of(
            "ball or safety to call",
            Game::StraightPool,
            &[Nothing, Choose(Choice::PlayOn)],
            |ask| ask.situation.frame.turn().is_some_and(|turn| turn.calls.safety),
        ),
        of("answer after a refusal", NineBall, &[], any).with(Mode::Refused),
        of("short clock", NineBall, &[], any).with(Mode::ShortClock),
        of("errors that are not disclosed", NineBall, &[], any).with(Mode::Undisclosed),
        of("balls seen with errors", NineBall, &[Opening], |ask| {
            ask.situation.frame.turn().is_some()
        })
        .with(Mode::Perceived),
        of("cue ball in hand among balls seen with errors", NineBall, &[Nothing], is_in_hand)
            .with(Mode::Perceived),
        of("unknown keys and messages", NineBall, &[], any).with(Mode::Unknown),
        of("menu of plays", EightBall, &[Opening], |ask| ask.situation.frame.turn().is_some())
            .with(Mode::Menu),
        of("menu of choices", EightBall, &[Nothing], is_choice).with(Mode::Menu),
        of("whole frame", NineBall, &[], any).with(Mode::WholeFrame),
    ];
    openings.into_iter().chain(rest).collect()
}

fn offers(ask: &Ask<'_>, choice: Choice) -> bool {
    match ask.situation.frame.request() {
        Request::Choice { choices, .. } => choices.contains(&choice),
        _ => false,
    }
}

fn is_in_hand(ask: &Ask<'_>) -> bool {
    ask.situation.frame.turn().is_some_and(|turn| turn.hand == Some(Region::Anywhere))
}

fn has_group(ask: &Ask<'_>) -> bool {
    let group: Option<Group> = ask.situation.frame.group(ask.seat);
    group.is_some() && ask.situation.frame.turn().is_some()
}

//! Asking a player in scripted situations of every kind, for authors of programs.

mod scripts;
mod situations;

use std::sync::Arc;
use std::time::Instant;

use carom::error::InputError;
use carom::format::Node;
use carom::runner::Runner;
use carom::{Error, ErrorKind, Noise};
use carom_mind::{Answer, Budget, Spent};
use carom_plan::Progress;
use carom_rules::FrameSimulator;

use crate::arena_frame::{ArenaFrame, NextStep, REFUSALS};
use crate::clock::{Clock, ClockPeriod, ClockUnit, Cost};
use crate::match_player::{MatchPlayer, Response};
use crate::moves::{Effect, EndReason};
use crate::protocol::{ProtocolSettings, play_node};
use crate::secret::Secret;
use crate::settings::{Match, MatchSettings, PlayerEntry};
use crate::thinking_time::ThinkingTime;
use situations::{CheckSituation, Mode};

/// The racks and errors of the situations. Everybody may know them.
const SECRET: Secret = Secret::new([0x5c; 32]);

/// Number of racks that are tried for a situation.
const RACKS: u64 = 200;

/// Clock of the situation with a short one, s a frame.
const SHORT: f64 = 5.0;

/// Most plays of a menu.
const MENU: u32 = 5;

/// Most requests to the player in the whole frame.
const LONGEST_FRAME: u32 = 60;

/// Number of situations without an answer in time after which the others are not tried.
const MOST_SILENT: u32 = 3;

/// What a player did in a situation.
#[derive(Clone, Debug, PartialEq)]
pub struct CheckVerdict {
    /// The situation.
    pub situation: String,
    /// The game.
    pub game: &'static str,
    /// Whether it was right; `None` if the player was not asked.
    pub passed: Option<bool>,
    /// Its answer, as a program writes it; null if it gave none.
    pub answer: Node,
    /// What was wrong: place, fault and remedy. The reason if the player was not asked.
    pub fault: Option<InputError>,
    /// The time of its answers, s.
    pub seconds: f64,
}

/// How a player is checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CheckSettings {
    /// Its clock.
    pub clock: Clock,
    /// Whether it is a program that speaks the protocol.
    pub is_program: bool,
}

/// The names of all situations, in their order.
pub fn check_situations() -> Vec<String> {
    situations::all().into_iter().map(|situation| situation.name).collect()
}

/// Asks a player in situations of every kind. `make` makes it, for every situation; a program is asked
/// as the settings say. `see` gets every verdict when it is known.
///
/// # Errors
/// Those of `make`, and [`Error::Input`] with [`ErrorKind::Stopped`] if the player or `progress` stopped the check.
pub fn check<C: MatchPlayer>(
    make: &dyn Fn(ProtocolSettings) -> Result<C, Error>,
    settings: &CheckSettings,
    progress: &Progress,
    see: &mut dyn FnMut(&CheckVerdict),
) -> Result<Vec<CheckVerdict>, Error> {
    let all = situations::all();
    progress.begin(0, all.len());
    let mut verdicts: Vec<CheckVerdict> = Vec::new();
    let mut silent = 0;
    for situation in &all {
        let unasked = if situation.is_for_programs() && !settings.is_program {
            Some("it concerns programs that speak the protocol")
        } else if silent >= MOST_SILENT {
            Some("the player did not answer in several situations before")
        } else {
            None
        };
        let verdict = match unasked {
            Some(why) => not_asked(situation, why),
            None => {
                let mut player = make(protocol_settings(situation))?;
                ask_in(situation, &mut player, settings, progress)?
            }
        };
        silent += u32::from(verdict.fault.as_ref().is_some_and(|fault| fault.place == "clock"));
        progress.add(1);
        see(&verdict);
        verdicts.push(verdict);
    }
    Ok(verdicts)
}

const fn protocol_settings(situation: &CheckSituation) -> ProtocolSettings {
    ProtocolSettings {
        menu: if matches!(situation.mode, Mode::Menu) { MENU } else { 0 },
        unknown: matches!(situation.mode, Mode::Unknown),
    }
}

fn not_asked(situation: &CheckSituation, why: &str) -> CheckVerdict {
    let fault = fault(ErrorKind::Unsupported, "situation", why, "");
    CheckVerdict { passed: None, ..verdict(situation, Some(fault), Node::Null, 0.0) }
}

fn verdict(
    situation: &CheckSituation,
    fault: Option<InputError>,
    answer: Node,
    seconds: f64,
) -> CheckVerdict {
    CheckVerdict {
        situation: situation.name.clone(),
        game: situation.game.name(),
        passed: Some(fault.is_none()),
        answer,
        fault,
        seconds,
    }
}

fn fault(kind: ErrorKind, place: &str, what: &str, remedy: &str) -> InputError {
    let details = Vec::new();
    InputError { kind, place: place.into(), what: what.into(), remedy: remedy.into(), details }
}

/// The frame of a situation, in which the player is asked next.
fn reached(
    situation: &CheckSituation,
    clock: Clock,
    simulator: &mut FrameSimulator,
) -> Result<ArenaFrame, Error> {
    let clock = match situation.mode {
        Mode::ShortClock if clock.unit == ClockUnit::Seconds => {
            Clock { amount: SHORT, period: ClockPeriod::Frame, ..clock }
        }
        _ => clock,
    };
    let settings = MatchSettings {
        clock: [clock; 2],
        noise: [const { Noise::olympiad(1.0) }; 2],
        perception: [situation.perception(), situation.perception()],
        disclosure: situation.disclosure(),
        ..MatchSettings::new(situation.game)
    };
    let players = [PlayerEntry::new("checked"), PlayerEntry::new("referee")];
    let of = Arc::new(Match::new(settings, players)?);
    let CheckSituation { steps, most, is_reached, first_rack, .. } = situation;
    for pair in *first_rack..first_rack + RACKS {
        let seeds = SECRET.pair_seeds(pair);
        let mut frame = ArenaFrame::begin(Arc::clone(&of), 2 * pair, seeds, simulator)?;
        if scripts::follow(&mut frame, steps, *most, *is_reached, simulator)? {
            return Ok(frame);
        }
    }
    let what = format!("no rack leads to \"{}\"", situation.name);
    Err(ErrorKind::WrongState.at("situation", what, "please report it"))
}

/// An answer of the player: what the referee makes of it, the answer, and its time, s.
struct Asked {
    fault: Option<InputError>,
    answer: Node,
    seconds: f64,
}

fn ask_in<C: MatchPlayer>(
    situation: &CheckSituation,
    player: &mut C,
    settings: &CheckSettings,
    progress: &Progress,
) -> Result<CheckVerdict, Error> {
    let mut simulator = FrameSimulator::new();
    let mut frame = reached(situation, settings.clock, &mut simulator)?;
    let mut asked = ask(&mut frame, player, &mut simulator, progress)?;
    let mut seconds = asked.seconds;
    match situation.mode {
        Mode::Refused if asked.fault.is_none() => {
            let mut frame = reached(situation, settings.clock, &mut simulator)?;
            let what = "the check refuses the first answer to see what follows";
            let remedy = "answer the same request again";
            let refusal = fault(ErrorKind::NotAMove, "check", what, remedy);
            frame.refuse(&mut simulator, refusal, Cost::default())?;
            asked = ask(&mut frame, player, &mut simulator, progress)?;
            seconds += asked.seconds;
        }
        Mode::WholeFrame => {
            let mut requests = 0;
            while asked.fault.is_none() && requests < LONGEST_FRAME {
                if !play_other(&mut frame, &mut simulator)? {
                    break;
                }
                asked = ask(&mut frame, player, &mut simulator, progress)?;
                seconds += asked.seconds;
                requests += 1;
            }
            if frame.end().is_none()
                && matches!(frame.next(), NextStep::Ask(_))
                && asked.fault.is_none()
            {
                frame.forfeit(EndReason::Stall, "the check ends the frame", Cost::default())?;
            }
            player.frame_over(&frame);
        }
        _ => {}
    }
    Ok(verdict(situation, asked.fault, asked.answer, seconds))
}

/// Lets the referee answer until it is the player's turn again. False if the frame is over.
fn play_other(frame: &mut ArenaFrame, simulator: &mut FrameSimulator) -> Result<bool, Error> {
    loop {
        let answer = {
            let NextStep::Ask(ask) = frame.next() else { return Ok(false) };
            if ask.player == 0 {
                return Ok(true);
            }
            scripts::Step::Best.answer(&ask)?
        };
        let spent = Spent::default();
        let decision = carom_mind::Decision { answer, win_chance: None, spent };
        frame.answer(simulator, &decision, 0.0)?;
    }
}

/// Asks the player once, whatever its seat.
fn ask<C: MatchPlayer>(
    frame: &mut ArenaFrame,
    player: &mut C,
    simulator: &mut FrameSimulator,
    progress: &Progress,
) -> Result<Asked, Error> {
    let (response, seconds, left, before) = {
        let NextStep::Ask(ask) = frame.next() else {
            return Ok(Asked { fault: None, answer: Node::Null, seconds: 0.0 });
        };
        let time = ThinkingTime::begin(ask.seconds().unwrap_or(f64::INFINITY));
        let begin = Instant::now();
        let is_over =
            |_: Spent| progress.is_stopped() || (ask.seconds().is_some() && time.is_over());
        let budget = Budget {
            simulations: ask.simulations(),
            rounds: None,
            is_over: &is_over,
            runner: Runner::new(Some(1))?,
        };
        let response = player.respond(&ask, &budget);
        let seconds = player.seconds().unwrap_or_else(|| begin.elapsed().as_secs_f64());
        let left = ask.left[ask.seat].filter(|_| ask.clock.unit == ClockUnit::Seconds);
        (response, seconds, left, ask.situation.frame.clone())
    };
    let stopped = || ErrorKind::Stopped.at("check", "it was stopped", "start it again");
    if progress.is_stopped() {
        return Err(stopped());
    }
    let decision = match response {
        Response::Decision(decision) | Response::Explained(decision, _) => decision,
        Response::Unread(fault, _) => {
            return Ok(Asked { fault: Some(fault), answer: Node::Null, seconds });
        }
        Response::Failed(reason, why) => {
            return Ok(Asked { fault: Some(loss(reason, &why)), answer: Node::Null, seconds });
        }
        Response::Stop => return Err(stopped()),
    };
    let answer = match decision.answer {
        Answer::Play(play) => play_node(&before, &play),
        Answer::Choice(choice) => Node::object([("choice", choice.name().into())]),
        Answer::Concede => Node::object([("concede", true.into())]),
    };
    if let Some(left) = left.filter(|left| seconds > *left) {
        let what = format!("the answer took {seconds:.1} s, and {left:.1} s were left");
        let fault = fault(ErrorKind::OutOfRange, "clock", &what, CLOCK);
        return Ok(Asked { fault: Some(fault), answer, seconds });
    }
    let made = frame.answer(simulator, &decision, 0.0)?;
    let fault = match &made.effect {
        Effect::Refused(fault) => Some(fault.clone()),
        _ => None,
    };
    Ok(Asked { fault, answer, seconds })
}

const CLOCK: &str = "look at clocks in the request, and answer sooner";

/// The fault of a player that gave no answer.
fn loss(reason: EndReason, why: &str) -> InputError {
    let refused =
        format!("answer each request once, with its id; {REFUSALS} answers may be refused");
    let (place, remedy) = match reason {
        EndReason::TimeOver => ("clock", CLOCK),
        EndReason::Stall => ("clock", "answer every message that asks, and flush the output"),
        EndReason::Crash => ("program", "run it by hand, and look at what it writes to stderr"),
        EndReason::Flood => ("program", "write one line for each answer, and logs to stderr"),
        EndReason::LongLine => ("line", "write at most 1 MiB on a line"),
        _ => ("answer", refused.as_str()),
    };
    fault(ErrorKind::System, place, why, remedy)
}

#[cfg(test)]
mod tests {
    use carom::Error;
    use carom::error::InputError;
    use carom::resolve::cue_ball::Strike;
    use carom_mind::{Answer, Budget, Decision, Spent};
    use carom_plan::Progress;
    use carom_rules::{Choice, FrameSimulator, Play, Request};

    use super::situations::Mode;
    use super::{CheckSettings, CheckVerdict, check, reached, scripts, situations};
    use crate::arena_frame::{Ask, NextStep};
    use crate::clock::Clock;
    use crate::match_player::{MatchPlayer, Response};
    use crate::moves::EndReason;

    const SETTINGS: CheckSettings =
        CheckSettings { clock: Clock::simulations(100), is_program: false };

    #[test]
    fn every_situation_is_reached_and_asks_for_what_it_is_about() {
        let mut simulator = FrameSimulator::new();
        for situation in situations::all() {
            let frame = reached(&situation, SETTINGS.clock, &mut simulator)
                .unwrap_or_else(|error| panic!("{}: {error}", situation.name));
            let NextStep::Ask(ask) = frame.next() else { panic!("{}", situation.name) };
            assert!((situation.is_reached)(&ask), "{}", situation.name);
            assert_eq!(ask.last.is_some(), frame.frame().shots() > 0, "{}", situation.name);
            let sees_errors = ask.situation.frame.layout() != frame.frame().layout();
            assert_eq!(sees_errors, situation.mode == Mode::Perceived, "{}", situation.name);
        }
    }

    /// Answers as the referee would, or as a test says.
    struct Answering(fn(&Ask<'_>) -> Response);

    impl MatchPlayer for Answering {
        fn respond(&mut self, ask: &Ask<'_>, _: &Budget<'_>) -> Response {
            (self.0)(ask)
        }
    }

    fn decision(answer: Answer) -> Response {
        Response::Decision(Decision { answer, win_chance: None, spent: Spent::default() })
    }

    fn good(ask: &Ask<'_>) -> Response {
        let step = match ask.situation.frame.request() {
            Request::Choice { choices, .. } => scripts::Step::Choose(choices[0]),
            _ => scripts::Step::Nothing,
        };
        decision(step.answer(ask).unwrap_or(Answer::Concede))
    }

    fn verdicts(answer: fn(&Ask<'_>) -> Response) -> Vec<CheckVerdict> {
        let make = |_| -> Result<Answering, Error> { Ok(Answering(answer)) };
        let mut seen = Vec::new();
        let found = check(&make, &SETTINGS, &Progress::default(), &mut |verdict| {
            seen.push(verdict.clone())
        })
        .expect("a check");
        assert_eq!(found, seen);
        found
    }

    #[test]
    fn a_player_that_answers_well_passes_every_situation_that_concerns_it() {
        let of_programs = situations::all().iter().filter(|s| s.is_for_programs()).count();
        let found = verdicts(good);
        let skipped = found.iter().filter(|verdict| verdict.passed.is_none()).count();
        assert_eq!((skipped, of_programs), (of_programs, 6));
        for verdict in found.iter().filter(|verdict| verdict.passed.is_some()) {
            assert_eq!(verdict.passed, Some(true), "{verdict:?}");
        }
    }

    #[test]
    fn a_wrong_answer_is_named_with_place_and_remedy() {
        let found = verdicts(|_| decision(Answer::Choice(Choice::PassBack)));
        let passed: Vec<&str> = found
            .iter()
            .filter(|verdict| verdict.passed == Some(true))
            .map(|verdict| verdict.situation.as_str())
            .collect();
        assert_eq!(passed, ["choice after a push-out", "foul and a miss"]);
        let InputError { place, what, remedy, .. } =
            found[0].fault.as_ref().expect("a fault of the opening");
        assert_eq!(place, "choice");
        assert!(!what.is_empty() && !remedy.is_empty());
    }

    #[test]
    fn the_page_of_the_protocol_lists_every_situation() {
        let page = include_str!("../../../../docs/arena-protocol.md");
        for name in super::check_situations() {
            let listed = if name.starts_with("opening of ") { "opening of GAME" } else { &name };
            assert!(page.contains(&format!("| {listed} |")), "{name}");
        }
    }

    #[test]
    fn a_place_of_the_cue_ball_on_a_ball_that_is_seen_is_refused_with_a_remedy() {
        let make = |_| -> Result<Answering, Error> {
            Ok(Answering(|ask| match ask.situation.frame.turn() {
                Some(turn) if turn.hand.is_some() => {
                    let layout = ask.situation.frame.layout();
                    let ball = layout.on_table().find(|ball| *ball != turn.cue);
                    let place = ball.and_then(|ball| layout.place(ball));
                    let strike =
                        Strike { speed: 1.0, azimuth: 0.0, elevation: 0.1, side: 0.0, height: 0.0 };
                    decision(Answer::Play(Play { cue_ball: place, ..Play::new(strike) }))
                }
                _ => good(ask),
            }))
        };
        let settings = CheckSettings { is_program: true, ..SETTINGS };
        let found = check(&make, &settings, &Progress::default(), &mut |_| ()).expect("a check");
        let of = |name: &str| found.iter().find(|verdict| verdict.situation == name);
        assert_eq!(of("balls seen with errors").and_then(|verdict| verdict.passed), Some(true));
        let verdict = of("cue ball in hand among balls seen with errors").expect("a verdict");
        let InputError { place, remedy, .. } = verdict.fault.as_ref().expect("a fault");
        assert_eq!((verdict.passed, place.as_str()), (Some(false), "cue_ball"));
        assert!(!remedy.is_empty());
    }

    #[test]
    fn a_player_that_never_answers_is_not_asked_in_all_situations() {
        let found = verdicts(|_| Response::Failed(EndReason::Stall, "no line".into()));
        let asked = found.iter().filter(|verdict| verdict.passed.is_some()).count();
        assert_eq!(asked, 3);
        assert!(found.iter().all(|verdict| verdict.fault.is_some()));
        let last = situations::all().iter().filter(|s| s.mode == Mode::WholeFrame).count();
        assert_eq!(last, 1);
    }
}

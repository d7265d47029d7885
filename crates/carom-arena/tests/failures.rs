//! What goes wrong in a frame, and what follows.

mod common;

use carom::error::InputError;
use carom::resolve::cue_ball::Strike;
use carom_arena::{
    ArenaFrame, Ask, Clock, Cost, Effect, EndReason, MatchPlayer, MatchSettings, NextStep,
    REFUSALS, Response, play_match, replay,
};
use carom_mind::{Answer, Budget, Decision, Player, Spent};
use carom_plan::Progress;
use carom_rules::FrameSimulator;
use carom_rules::{Choice, Game, Options, Play};
use common::{Failing, Folder, RandomPlayer, Repeater, SECRET, made, plan, played, runner, short};

fn repeater(answer: Answer, simulations: u64) -> Box<dyn Player> {
    Box::new(Repeater { answer, simulations })
}

/// The break of a player who never strikes a ball.
fn nowhere() -> Answer {
    let strike = Strike { speed: 0.2, azimuth: -1.5, elevation: 0.05, side: 0.0, height: 0.0 };
    Answer::Play(Play::new(strike).from([0.6, 0.5]))
}

#[test]
fn a_player_who_concedes_loses_the_frame() {
    let of = made(short(Game::NineBall));
    let frame = played(&of, 0, [repeater(Answer::Concede, 0), Box::new(RandomPlayer)]);
    let end = frame.end().unwrap();
    assert_eq!((end.reason, end.winner), (EndReason::Conceded, Some(1)));
    assert_eq!(frame.points(), Some(0.0));
}

#[test]
fn the_eleventh_refused_answer_loses_the_frame() {
    let of = made(short(Game::NineBall));
    for answer in [
        Answer::Choice(Choice::PassBack),
        Answer::Play(Play::new(Strike {
            speed: f64::NAN,
            azimuth: 0.0,
            elevation: 0.0,
            side: 0.0,
            height: 0.0,
        })),
    ] {
        let frame = played(&of, 0, [repeater(answer, 0), Box::new(RandomPlayer)]);
        let end = frame.end().unwrap();
        assert_eq!((end.reason, end.winner), (EndReason::Refusals, Some(1)));
        assert_eq!(frame.moves().len(), 11);
        for refused in frame.moves() {
            let Effect::Refused(fault) = &refused.effect else { panic!("{refused:?}") };
            assert!(!fault.place.is_empty() && !fault.what.is_empty() && !fault.remedy.is_empty());
        }
    }
}

#[test]
fn ten_refused_answers_lose_nothing_and_are_explained() {
    let of = made(short(Game::NineBall));
    let mut simulator = FrameSimulator::new();
    let mut frame = ArenaFrame::begin(of.clone(), 0, SECRET.pair_seeds(0), &mut simulator).unwrap();
    let fault = InputError {
        kind: carom::ErrorKind::Syntax,
        details: Vec::new(),
        place: "line".into(),
        what: "not JSON".into(),
        remedy: "mend".into(),
    };
    let mut seen = Vec::new();
    for _ in 0..REFUSALS {
        let NextStep::Ask(ask) = frame.next() else { panic!("the same request") };
        assert_eq!(ask.seat, 0);
        seen.push((ask.id, ask.situation.seed));
        frame.refuse(&mut simulator, fault.clone(), Cost::default()).unwrap();
        let NextStep::Ask(ask) = frame.next() else { panic!("the same request") };
        assert_eq!(ask.refused, Some(&fault));
    }
    // A player that draws its answers can find another one.
    seen.dedup_by_key(|(_, seed)| *seed);
    assert_eq!(seen.len(), 10);
    let decision = Decision { answer: nowhere(), win_chance: None, spent: Spent::default() };
    let answered = frame.answer(&mut simulator, &decision, 0.0).unwrap();
    assert!(matches!(answered.effect, Effect::Played { .. }), "{answered:?}");
    assert!(frame.end().is_none());
}

#[test]
fn a_player_whose_simulations_are_used_up_loses_the_frame() {
    let clock = [Clock::simulations(1000).per_frame(); 2];
    let of = made(MatchSettings { clock, ..short(Game::NineBall) });
    let frame = played(&of, 0, [repeater(nowhere(), 1001), Box::new(RandomPlayer)]);
    let end = frame.end().unwrap();
    assert_eq!((end.reason, end.winner), (EndReason::TimeOver, Some(1)));
    assert_eq!(frame.moves()[0].effect, Effect::Late);
    assert_eq!(frame.frame().shots(), 0, "the late answer is not played");
    // The whole clock may be used.
    let frame = played(&of, 0, [repeater(nowhere(), 1000), Box::new(RandomPlayer)]);
    assert!(matches!(frame.moves()[0].effect, Effect::Played { .. }));
}

#[test]
fn a_player_whose_seconds_are_used_up_loses_the_frame() {
    let clock = [Clock::seconds(60.0).per_frame(); 2];
    let of = made(MatchSettings { clock, ..short(Game::NineBall) });
    let mut simulator = FrameSimulator::new();
    let mut frame = ArenaFrame::begin(of.clone(), 0, SECRET.pair_seeds(0), &mut simulator).unwrap();
    let NextStep::Ask(ask) = frame.next() else { panic!("a break") };
    assert_eq!((ask.left, ask.simulations()), ([Some(60.0); 2], u64::MAX));
    // Nine balls: 4.5 shots are expected.
    assert_eq!(ask.seconds(), Some(60.0 / (1.5 * 4.5 + 3.0)));
    let decision = Decision { answer: nowhere(), win_chance: None, spent: Spent::default() };
    frame.answer(&mut simulator, &decision, 59.0).unwrap();
    let NextStep::Ask(ask) = frame.next() else { panic!("the other's shot") };
    assert_eq!((ask.seat, ask.left), (1, [Some(1.0), Some(60.0)]));
    frame.answer(&mut simulator, &decision, 60.1).unwrap();
    let end = frame.end().unwrap();
    assert_eq!((end.reason, end.winner), (EndReason::TimeOver, Some(0)));
}

/// Thinks until its budget is over, then concedes.
struct Ponderer;

impl Player for Ponderer {
    fn name(&self) -> &str {
        "ponderer"
    }

    fn decide(
        &mut self,
        _: &carom_mind::Situation<'_>,
        budget: &carom_mind::Budget<'_>,
    ) -> Result<Decision, carom::Error> {
        let mut spent = Spent { simulations: 1, rounds: 1 };
        while budget.allows(spent, 1) {
            spent.rounds = spent.rounds.saturating_add(1);
            std::thread::yield_now();
        }
        Ok(Decision { answer: Answer::Concede, win_chance: None, spent })
    }
}

#[test]
fn a_clock_of_seconds_ends_the_search_and_the_record_replays() {
    let clock = [Clock::seconds(0.01); 2];
    let plan = plan(MatchSettings { clock, ..short(Game::NineBall) }, 1);
    let folder = Folder::new("seconds");
    let progress = Progress::default();
    let players = |_| Ok(Box::new(Ponderer) as Box<dyn Player>);
    let report = play_match(&plan, folder.path(), &players, &runner(1), &progress).unwrap();
    assert_eq!(report.score.reasons[&EndReason::Conceded], 2);
    let text = folder.read(carom_arena::RECORD);
    assert!(text.contains("\"seconds\": "), "{text}");
    assert_eq!(replay(&text, &runner(1), &progress).unwrap().difference, None);
}

#[test]
fn a_player_that_fails_loses_the_frame_with_its_error_as_the_reason() {
    let of = made(short(Game::EightBall));
    // Player 1 has seat 0 in the second frame.
    for (number, winner) in [(0, 1), (1, 0)] {
        let frame = played(&of, number, [Box::new(Failing(0)), Box::new(RandomPlayer)]);
        let end = frame.end().unwrap();
        assert_eq!((end.reason, end.winner), (EndReason::Crash, Some(winner)));
        assert_eq!(end.why, "mind: it has lost its way; mend it");
        assert_eq!(frame.points(), Some(0.0));
    }
}

#[test]
fn failures_of_programs_have_reasons_of_their_own() {
    let of = made(short(Game::NineBall));
    let mut simulator = FrameSimulator::new();
    for reason in EndReason::ALL {
        let mut frame =
            ArenaFrame::begin(of.clone(), 0, SECRET.pair_seeds(0), &mut simulator).unwrap();
        let ended = frame.forfeit(reason, "it hung", Cost::default()).map(|_| ());
        let is_failure = matches!(
            reason,
            EndReason::TimeOver
                | EndReason::Crash
                | EndReason::Stall
                | EndReason::Flood
                | EndReason::LongLine
        );
        assert_eq!(ended.is_ok(), is_failure, "{reason:?}");
        assert_eq!(
            frame.end().map(|end| (end.reason, end.winner)),
            is_failure.then_some((reason, Some(1)))
        );
        assert_eq!(EndReason::named(reason.name()), Some(reason));
    }
}

#[test]
fn a_frame_whose_shot_reaches_the_cap_of_events_does_not_count() {
    let settings = MatchSettings { max_events: 20, ..short(Game::NineBall) };
    let folder = Folder::new("event-cap");
    let plan = plan(settings, 2);
    let progress = Progress::default();
    let players = |_| Ok(Box::new(RandomPlayer) as Box<dyn Player>);
    let report = play_match(&plan, folder.path(), &players, &runner(1), &progress).unwrap();
    assert_eq!((report.score.void, report.score.pairs.pairs()), (4, 0));
    assert_eq!(report.score.reasons[&EndReason::EventCap], 4);
    let text = folder.read(carom_arena::RECORD);
    let replayed = replay(&text, &runner(1), &progress).unwrap();
    assert_eq!((replayed.difference, replayed.score.void), (None, 4));
}

#[test]
fn two_stalemates_give_half_a_point_each() {
    let options = Options { patience: 3, ..Options::default() };
    let of = made(MatchSettings { options, ..short(Game::EightBall) });
    let frame = played(&of, 0, [Box::new(Idler), Box::new(Idler)]);
    let end = frame.end().unwrap();
    assert_eq!((end.reason, end.winner), (EndReason::Drawn, None));
    assert_eq!(frame.points(), Some(0.5));
    let racks = frame
        .moves()
        .iter()
        .filter(|m| matches!(&m.effect, Effect::Played { ruling, .. } if ruling.racked));
    assert_eq!(racks.count(), 1, "the first stalemate has the balls racked again");
}

/// Plays softly to the head rail, and takes the first of all choices.
struct Idler;

impl Player for Idler {
    fn name(&self) -> &str {
        "idler"
    }

    fn decide(
        &mut self,
        situation: &carom_mind::Situation<'_>,
        _: &carom_mind::Budget<'_>,
    ) -> Result<Decision, carom::Error> {
        use carom_rules::{Call, Request};
        let answer = match (situation.frame.request(), nowhere()) {
            (Request::Choice { choices, .. }, _) => Answer::Choice(choices[0]),
            (Request::Shot(turn), Answer::Play(play)) => {
                let call = if turn.calls.required { Call::Safety } else { Call::Nothing };
                let cue_ball = play.cue_ball.filter(|_| turn.hand.is_some());
                Answer::Play(Play { call, cue_ball, ..play })
            }
            _ => Answer::Concede,
        };
        Ok(Decision { answer, win_chance: None, spent: Spent::default() })
    }
}

#[test]
fn a_frame_with_every_kind_of_failure_replays() {
    for (name, answer, simulations) in [
        ("concede", Answer::Concede, 0),
        ("refused", Answer::Choice(Choice::SpotEight), 5),
        ("late", nowhere(), 100_000),
    ] {
        let clock = [Clock::simulations(1000).per_frame(); 2];
        let plan = plan(MatchSettings { clock, ..short(Game::NineBall) }, 1);
        let folder = Folder::new(name);
        let progress = Progress::default();
        let players = |player| -> Result<Box<dyn Player>, carom::Error> {
            Ok(if player == 0 { Box::new(RandomPlayer) } else { repeater(answer, simulations) })
        };
        let report = play_match(&plan, folder.path(), &players, &runner(1), &progress).unwrap();
        assert_eq!(report.score.frames, [0, 0, 2], "{name}");
        let text = folder.read(carom_arena::RECORD);
        assert_eq!(replay(&text, &runner(1), &progress).unwrap().difference, None, "{name}");
    }
    let plan = plan(short(Game::NineBall), 1);
    let folder = Folder::new("crash");
    let progress = Progress::default();
    let players = |player| -> Result<Box<dyn Player>, carom::Error> {
        Ok(if player == 0 { Box::new(Failing(0)) } else { Box::new(RandomPlayer) })
    };
    play_match(&plan, folder.path(), &players, &runner(1), &progress).unwrap();
    let text = folder.read(carom_arena::RECORD);
    assert!(text.contains("\"failed\": {\"reason\": \"crash\""));
    assert_eq!(replay(&text, &runner(1), &progress).unwrap().difference, None);
}

/// Gives this response to every request.
struct Responder(Response);

impl MatchPlayer for Responder {
    fn respond(&mut self, _: &Ask<'_>, _: &Budget<'_>) -> Response {
        self.0.clone()
    }
}

#[test]
fn a_player_of_a_match_may_fail_or_give_no_answer_that_can_be_read() {
    let fault = InputError {
        kind: carom::ErrorKind::Syntax,
        details: Vec::new(),
        place: "line".into(),
        what: "not JSON".into(),
        remedy: "mend".into(),
    };
    let unread = Response::Unread(fault, Spent { simulations: 7, rounds: 1 });
    let failed = Response::Failed(EndReason::Flood, "it wrote too much".into());
    let plan = plan(short(Game::NineBall), 1);
    for (response, reason, moves, simulations) in
        [(unread, EndReason::Refusals, 11, 7), (failed, EndReason::Flood, 1, 0)]
    {
        let folder = Folder::new(reason.name());
        let make = |_| Ok(Responder(response.clone()));
        let report =
            play_match(&plan, folder.path(), &make, &runner(1), &Progress::default()).unwrap();
        assert_eq!(report.score.reasons[&reason], 2);
        let text = folder.read("match.jsonl");
        assert_eq!(text.matches(&format!("\"simulations\": {simulations}")).count(), 2 * moves);
        assert!(replay(&text, &runner(1), &Progress::default()).unwrap().difference.is_none());
    }
}

#[test]
fn a_player_of_a_match_can_stop_it_and_the_frame_is_played_again() {
    let plan = plan(short(Game::NineBall), 2);
    let folder = Folder::new("stop");
    let progress = Progress::default();
    let stop = |_| Ok(Responder(Response::Stop));
    let stopped = play_match(&plan, folder.path(), &stop, &runner(2), &progress).unwrap();
    assert!(progress.is_stopped());
    assert!(stopped.record.is_none());
    assert_eq!(stopped.pairs, 0);
    let make = |_| Ok(Box::new(RandomPlayer) as Box<dyn Player>);
    let report = play_match(&plan, folder.path(), &make, &runner(2), &Progress::default()).unwrap();
    assert_eq!(report.pairs, 2);
}

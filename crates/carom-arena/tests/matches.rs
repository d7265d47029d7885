//! Whole matches: pairs, threads, interruptions, early ends.

mod common;

use std::fs;
use std::sync::atomic::{AtomicU64, Ordering};

use carom::format::Node;
use carom::noise::{Perception, PositionError};
use carom::resolve::cue_ball::Strike;
use carom::{Error, Noise};
use carom_arena::{
    ArenaFrame, Breaker, Disclosure, Effect, EndReason, Hypothesis, MatchPlan, MatchSettings,
    NextStep, RECORD, SequentialTest, play_match, replay,
};
use carom_mind::{Answer, Decision, Player, Spent};
use carom_plan::Progress;
use carom_rules::{Call, Game, Play};
use common::{
    Folder, RandomPlayer, Repeater, SECRET, lines, made, plan, played, random_players, runner,
    short, two_random,
};

/// A decision without costs.
fn decided(answer: Answer) -> Decision {
    Decision { answer, win_chance: None, spent: Spent::default() }
}

/// Plays a whole match and returns its record.
fn record(plan: &MatchPlan, threads: usize, name: &str) -> String {
    let folder = Folder::new(name);
    let progress = Progress::default();
    let report =
        play_match(plan, folder.path(), &random_players, &runner(threads), &progress).unwrap();
    assert_eq!(report.record.as_deref(), Some(folder.path().join(RECORD).as_path()));
    let names: Vec<_> =
        fs::read_dir(folder.path()).unwrap().map(|e| e.unwrap().file_name()).collect();
    assert_eq!(names, [RECORD], "the working files are removed");
    folder.read(RECORD)
}

#[test]
fn equal_players_play_mirror_images_in_every_game() {
    for game in Game::ALL {
        let of = made(short(game));
        for pair in 0..2 {
            let [one, other] = [0, 1].map(|second| played(&of, 2 * pair + second, two_random()));
            assert_eq!((one.players(), other.players()), ([0, 1], [1, 0]));
            assert!(!one.moves().is_empty());
            assert_eq!(one.moves(), other.moves(), "{}", game.name());
            assert_eq!(one.end(), other.end());
            let points = [one.points(), other.points()].map(Option::unwrap);
            assert_eq!(points[0] + points[1], 1.0, "{}", game.name());
        }
        let [first, second] = [0, 2].map(|number| played(&of, number, two_random()));
        assert_ne!(first.moves(), second.moves(), "another pair has another rack");
    }
}

#[test]
fn streams_of_errors_are_exchanged_if_one_player_always_breaks() {
    let settings = MatchSettings { breaker: Breaker::Always(1), ..short(Game::NineBall) };
    let of = made(settings);
    let [one, other] = [0, 1].map(|number| played(&of, number, two_random()));
    assert_eq!((one.players(), other.players()), ([1, 0], [1, 0]));
    let (seeds, exchanged) = (one.seeds(), other.seeds());
    assert_eq!(seeds.rack, exchanged.rack);
    assert_eq!(seeds.errors, [exchanged.errors[1], exchanged.errors[0]]);
    assert_ne!(one.moves(), other.moves());
}

#[test]
fn the_number_of_threads_changes_nothing() {
    for game in [Game::NineBall, Game::ThreeCushion] {
        let plan = plan(short(game), 5);
        let alone = record(&plan, 1, "threads-1");
        assert_eq!(alone, record(&plan, 3, "threads-3"));
        assert_eq!(alone.lines().count(), 12, "a header, ten frames and the secret");
    }
}

#[test]
fn a_match_that_was_interrupted_ends_with_the_same_bytes() {
    let plan = plan(short(Game::EightBall), 4);
    let whole = record(&plan, 1, "whole");
    let folder = Folder::new("interrupted");
    let mut interruptions = 0;
    loop {
        // Ctrl-C while the second pair of this run is played: in the middle of its first frame.
        let (progress, made) = (Progress::default(), AtomicU64::new(0));
        let make_player = |player| {
            if made.fetch_add(1, Ordering::Relaxed) == 5 {
                progress.stop();
            }
            random_players(player)
        };
        let report = play_match(&plan, folder.path(), &make_player, &runner(1), &progress).unwrap();
        if report.record.is_some() {
            assert_eq!(report.pairs, 4);
            break;
        }
        interruptions += 1;
        assert_eq!(report.pairs, interruptions, "the pair that had ended is kept");
        tear(&folder, interruptions);
    }
    assert_eq!(interruptions, 3);
    assert_eq!(folder.read(RECORD), whole);
}

#[test]
fn a_match_on_three_threads_that_was_interrupted_ends_with_the_same_bytes() {
    let plan = plan(short(Game::TenBall), 8);
    let whole = record(&plan, 1, "whole-threads");
    let folder = Folder::new("interrupted-threads");
    let mut runs = 0;
    loop {
        let (progress, made) = (Progress::default(), AtomicU64::new(0));
        let make_player = |player| {
            // Every run gets further than the one before.
            if made.fetch_add(1, Ordering::Relaxed) == 7 + 6 * runs {
                progress.stop();
            }
            random_players(player)
        };
        let report = play_match(&plan, folder.path(), &make_player, &runner(3), &progress).unwrap();
        runs += 1;
        if report.record.is_some() {
            break;
        }
    }
    assert!(runs > 1);
    assert_eq!(folder.read(RECORD), whole);
}

/// Adds the beginning of a pair to the played frames: as if the program had been ended while it
/// wrote. Once within a line, once after the first of two lines.
fn tear(folder: &Folder, interruption: u64) {
    let path = folder.path().join("played.jsonl");
    let text = fs::read_to_string(&path).unwrap();
    let line = text.lines().nth(1).unwrap();
    let torn = match interruption {
        1 => &line[..40],
        2 => &format!("{line}\n"),
        _ => "",
    };
    fs::write(&path, text.clone() + torn).unwrap();
}

#[test]
fn a_finished_match_is_not_played_again() {
    let plan = plan(short(Game::NineBall), 2);
    let folder = Folder::new("finished");
    let progress = Progress::default();
    let first = play_match(&plan, folder.path(), &random_players, &runner(1), &progress).unwrap();
    let never = |_| -> Result<Box<dyn Player>, _> {
        Err(carom::ErrorKind::System.at("player", "it is not needed", ""))
    };
    let again = play_match(&plan, folder.path(), &never, &runner(1), &progress).unwrap();
    assert_eq!((again.score, again.pairs), (first.score, first.pairs));
}

#[test]
fn a_folder_with_another_match_is_refused() {
    let folder = Folder::new("another");
    let progress = Progress::default();
    let play =
        |plan: &MatchPlan| play_match(plan, folder.path(), &random_players, &runner(1), &progress);
    play(&plan(short(Game::NineBall), 1)).unwrap();
    for other in [
        plan(short(Game::NineBall), 2),
        plan(short(Game::TenBall), 1),
        MatchPlan {
            secret: Some(carom_arena::Secret::new([1; 32])),
            ..plan(short(Game::NineBall), 1)
        },
    ] {
        let error = play(&other).unwrap_err().to_string();
        assert!(error.starts_with("folder: it has another match"), "{error}");
    }
}

#[test]
fn a_match_is_not_played_by_two_programs_at_once() {
    let plan = plan(short(Game::NineBall), 1);
    let folder = Folder::new("locked");
    let progress = Progress::default();
    let make_player = |player| {
        // While the first frame is played, a second call continues the same match.
        let second = play_match(&plan, folder.path(), &random_players, &runner(1), &progress);
        let error = second.unwrap_err().to_string();
        assert!(error.starts_with("folder: another program is playing this match"), "{error}");
        random_players(player)
    };
    let report = play_match(&plan, folder.path(), &make_player, &runner(1), &progress).unwrap();
    assert_eq!(report.pairs, 1);
}

/// The file was locked after it had been written and moved to its place: of two programs that began
/// at once, the second replaced the file that the first had locked.
#[test]
fn of_two_programs_that_begin_a_match_at_once_the_second_changes_nothing() {
    let plan = plan(short(Game::NineBall), 1);
    let folder = Folder::new("at-once");
    fs::create_dir_all(folder.path()).unwrap();
    let path = folder.path().join("played.jsonl");
    let first = fs::File::create(&path).unwrap();
    first.lock().unwrap();
    let play =
        || play_match(&plan, folder.path(), &random_players, &runner(1), &Progress::default());
    let error = play().unwrap_err().to_string();
    assert!(error.starts_with("folder: another program is playing this match"), "{error}");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "it wrote no secret");
    // A program that was ended before it wrote the header has left the file empty.
    drop(first);
    assert_eq!(play().unwrap().pairs, 1);
}

#[cfg(feature = "os-secret")]
#[test]
fn a_secret_of_the_operating_system_is_kept_for_the_continuation() {
    let plan = MatchPlan { secret: None, ..plan(short(Game::NineBall), 2) };
    let folder = Folder::new("os-secret");
    let (progress, made) = (Progress::default(), AtomicU64::new(0));
    let make_player = |player| {
        if made.fetch_add(1, Ordering::Relaxed) == 5 {
            progress.stop();
        }
        random_players(player)
    };
    let stopped = play_match(&plan, folder.path(), &make_player, &runner(1), &progress).unwrap();
    assert_eq!((stopped.record, stopped.pairs), (None, 1));
    let progress = Progress::default();
    let report = play_match(&plan, folder.path(), &random_players, &runner(1), &progress).unwrap();
    assert_eq!(report.secret_sha256, stopped.secret_sha256);
    let replayed = replay(&folder.read(RECORD), &runner(1), &progress).unwrap();
    assert_eq!((replayed.difference, replayed.frames), (None, 4));
}

#[test]
fn a_sequential_test_ends_the_match_at_the_same_pair_for_any_number_of_threads() {
    let concedes = Repeater { answer: Answer::Concede, simulations: 0 };
    let make_player = |player| -> Result<Box<dyn Player>, Error> {
        let Repeater { answer, simulations } = concedes;
        Ok(if player == 0 {
            Box::new(RandomPlayer)
        } else {
            Box::new(Repeater { answer, simulations })
        })
    };
    let test = SequentialTest::of_shares(0.5, 0.9).unwrap();
    let plan = MatchPlan { test: Some(test), ..plan(short(Game::NineBall), 60) };
    let ends = [1, 3].map(|threads| {
        let folder = Folder::new(&format!("sequential-{threads}"));
        let progress = Progress::default();
        let report =
            play_match(&plan, folder.path(), &make_player, &runner(threads), &progress).unwrap();
        assert_eq!(report.test.unwrap().accepted, Some(Hypothesis::P1));
        assert!((5..20).contains(&report.pairs), "{}", report.pairs);
        assert_eq!(lines(&folder.read(RECORD)).len() as u64, 2 * report.pairs + 2);
        folder.read(RECORD)
    });
    assert_eq!(ends[0], ends[1]);
}

#[test]
fn a_match_without_pairs_is_refused() {
    let folder = Folder::new("no-pairs");
    let plan = plan(short(Game::NineBall), 0);
    let progress = Progress::default();
    let error = play_match(&plan, folder.path(), &random_players, &runner(1), &progress);
    assert!(error.unwrap_err().to_string().starts_with("pairs: 0 is out of range"));
    assert!(!folder.path().exists(), "nothing was written");
}

#[test]
fn the_same_break_is_played_for_both_players() {
    let strike = Strike { speed: 8.0, azimuth: 1.57, elevation: 0.05, side: 0.0, height: 0.1 };
    let breaks = Play::new(strike).from([0.635, 0.6]);
    let settings = MatchSettings { same_break: Some(breaks), ..short(Game::NineBall) };
    let of = made(settings);
    for number in 0..2 {
        let frame = played(&of, number, two_random());
        let first = &frame.moves()[0];
        assert_eq!((first.is_given, first.seat), (true, 0));
        assert_eq!(first.answer, Some(Answer::Play(breaks)));
        let Effect::Played { execution, .. } = &first.effect else { panic!("{first:?}") };
        assert_ne!(execution.strike, strike, "the break has the errors of the breaker");
        assert!(frame.moves()[1..].iter().all(|m| !m.is_given));
    }
}

#[test]
fn the_same_break_is_repeated_after_another_rack() {
    let strike = Strike { speed: 1.0, azimuth: 1.57, elevation: 0.05, side: 0.0, height: 0.0 };
    let soft = Play::new(strike).from([0.635, 0.6]);
    let settings = MatchSettings { same_break: Some(soft), ..short(Game::EightBall) };
    let of = made(settings);
    let mut simulator = carom_rules::FrameSimulator::new();
    let seeds = SECRET.pair_seeds(0);
    let mut frame = ArenaFrame::begin(of.clone(), 0, seeds, &mut simulator).unwrap();
    // A soft break: the other player may have the balls racked again.
    let NextStep::Ask(ask) = frame.next() else { panic!("a choice") };
    assert_eq!(ask.seat, 1);
    let decision = decided(Answer::Choice(carom_rules::Choice::Rebreak));
    frame.answer(&mut simulator, &decision, 0.0).unwrap();
    let given: Vec<_> = frame.moves().iter().map(|m| (m.seat, m.is_given)).collect();
    assert_eq!(given, [(0, true), (1, false), (1, true)]);
}

#[test]
fn players_are_told_the_errors_that_the_settings_disclose() {
    let noise = [Noise::olympiad(1.0), Noise::olympiad(2.0)];
    let perception = [Perception::round(0.001), Perception::round(0.002)];
    for (disclosure, told, seen) in [
        (Disclosure::Both, noise.clone(), perception[0].position),
        (Disclosure::Own, [noise[0].clone(), Noise::NONE], perception[0].position),
        (Disclosure::Nothing, [Noise::NONE; 2], PositionError::default()),
    ] {
        let settings = MatchSettings {
            noise: noise.clone(),
            perception: perception.clone(),
            disclosure,
            ..short(Game::NineBall)
        };
        let of = made(settings);
        let mut simulator = carom_rules::FrameSimulator::new();
        let frame = ArenaFrame::begin(of.clone(), 0, SECRET.pair_seeds(0), &mut simulator).unwrap();
        let NextStep::Ask(ask) = frame.next() else { panic!("a break") };
        assert_eq!((ask.situation.noise, ask.situation.perception.position), (told, seen));
        // In the second frame of the pair the players have exchanged the seats.
        let frame = ArenaFrame::begin(of.clone(), 1, SECRET.pair_seeds(0), &mut simulator).unwrap();
        let NextStep::Ask(ask) = frame.next() else { panic!("a break") };
        if disclosure == Disclosure::Both {
            assert_eq!(ask.situation.noise, [noise[1].clone(), noise[0].clone()]);
        }
    }
}

#[test]
fn players_with_errors_of_perception_play_whole_frames_that_replay() {
    let perception = [Perception::round(0.003), Perception::default()];
    let noise = Noise { cling_probability: 0.2, ..Noise::olympiad(1.0) };
    let settings =
        MatchSettings { perception, noise: [noise.clone(), noise], ..short(Game::NineBall) };
    let plan = plan(settings, 2);
    let text = record(&plan, 2, "perception");
    let replayed = replay(&text, &runner(2), &Progress::default()).unwrap();
    assert_eq!(replayed.difference, None);
    assert!(text.contains("\"cling\": {\"contacts\""));
}

#[test]
fn a_cue_ball_is_moved_if_an_unseen_ball_is_in_the_way() {
    let perception = [const { Perception::round(0.005) }; 2];
    let settings = MatchSettings { perception, noise: [Noise::NONE; 2], ..short(Game::NineBall) };
    let of = made(settings);
    let mut simulator = carom_rules::FrameSimulator::new();
    let (mut moved, mut kept) = (0, 0);
    for pair in 0..10 {
        let seeds = SECRET.pair_seeds(pair);
        let mut frame = ArenaFrame::begin(of.clone(), 2 * pair, seeds, &mut simulator).unwrap();
        // A break spreads the balls. Then strikes that hit nothing: every foul gives the other
        // player the cue ball in hand.
        for shot in 0..20 {
            let NextStep::Ask(ask) = frame.next() else { break };
            let seen = ask.situation.frame;
            let turn = seen.turn().expect("nine-ball without choices");
            let lowest = seen.layout().on_table().find(|ball| *ball != turn.cue).unwrap();
            let [x, y] = seen.layout().place(lowest).unwrap();
            let gap = 2.0 * seen.layout().balls()[0].ball.radius + 0.0005;
            // Close to the seen place of a ball, 0.5 mm away from it.
            let beside = [[x, y - gap], [x, y + gap], [x - gap, y], [x + gap, y]][shot % 4];
            let place = if shot == 0 { [0.6, 0.5] } else { beside };
            let (speed, azimuth) = if shot == 0 { (8.0, 1.57) } else { (0.1, -1.5) };
            let strike = Strike { speed, azimuth, elevation: 0.05, side: 0.0, height: 0.0 };
            let cue_ball = turn.hand.map(|_| place);
            let answer = Answer::Play(Play { cue_ball, ..Play::new(strike) });
            let answered = frame.answer(&mut simulator, &decided(answer), 0.0).unwrap();
            if let Effect::Played { execution, .. } = &answered.effect
                && let (Some(at), true) = (execution.cue_ball, shot > 0)
            {
                let distance = (at[0] - place[0]).abs() + (at[1] - place[1]).abs();
                assert!(distance < 0.05, "{distance}");
                moved += u32::from(at != place);
                kept += u32::from(at == place);
            }
        }
    }
    assert!(moved > 10 && kept > 10, "about half of the places are truly taken: {moved}, {kept}");
}

#[test]
fn a_frame_that_is_over_takes_no_answer() {
    let of = made(short(Game::NineBall));
    let mut frame = played(&of, 0, two_random());
    let mut simulator = carom_rules::FrameSimulator::new();
    let decision = decided(Answer::Concede);
    let before = frame.moves().len();
    let error = frame.answer(&mut simulator, &decision, 0.0).unwrap_err().to_string();
    assert!(error.starts_with("answer: the frame is over"), "{error}");
    let error = frame.forfeit(EndReason::Stall, "", Default::default()).unwrap_err().to_string();
    assert!(error.starts_with("answer: the frame is over"), "{error}");
    assert_eq!(frame.moves().len(), before);
}

#[test]
fn a_call_of_a_ball_that_does_not_exist_is_refused_and_recorded() {
    let of = made(short(Game::Snooker));
    let mut simulator = carom_rules::FrameSimulator::new();
    let mut frame = ArenaFrame::begin(of.clone(), 0, SECRET.pair_seeds(0), &mut simulator).unwrap();
    let strike = Strike { speed: f64::NAN, azimuth: 0.0, elevation: 0.0, side: 0.0, height: 0.0 };
    let play = Play { call: Call::On(99), ..Play::new(strike) };
    let decision = decided(Answer::Play(play));
    let answered = frame.answer(&mut simulator, &decision, 0.0).unwrap();
    let Effect::Refused(fault) = &answered.effect else { panic!("{answered:?}") };
    assert_eq!(fault.place, "call");
    let NextStep::Ask(ask) = frame.next() else { panic!("the same request") };
    assert_eq!((ask.seat, ask.refused.map(|e| e.place.as_str())), (0, Some("call")));
}

#[test]
fn a_plain_frame_repeats_the_executed_shots() {
    let of = made(short(Game::EightBall));
    let arena_frame = played(&of, 0, two_random());
    let seed = arena_frame.seeds().rack;
    let mut frame =
        carom_rules::Frame::new(Game::EightBall, of.settings().options, None, None, seed).unwrap();
    let mut shots = 0;
    for made in arena_frame.moves() {
        match (&made.answer, &made.effect) {
            (Some(Answer::Play(play)), Effect::Played { execution, ruling, trace, .. }) => {
                let play = Play { strike: execution.strike, ..*play };
                assert_eq!(frame.shot(&play).unwrap().simulate().unwrap().hash(), *trace);
                assert_eq!(frame.play(&play).unwrap().0, *ruling);
                shots += 1;
            }
            (Some(Answer::Choice(choice)), Effect::Chosen { ruling }) => {
                assert_eq!(frame.choose(*choice).unwrap(), *ruling);
            }
            _ => {}
        }
    }
    assert!(shots > 10);
    assert_eq!(frame.to_node(), arena_frame.frame().to_node());
}

#[test]
fn a_header_has_every_setting_with_dated_names() {
    let text = record(&plan(short(Game::ThreeCushion), 1), 1, "header");
    let header = &lines(&text)[0];
    assert_eq!(header.get("game"), Some(&Node::from("three-cushion")));
    assert_eq!(header.get("secret_sha256"), Some(&Node::from(SECRET.sha256())));
    let Some(Node::Text(table)) = header.get("table") else { panic!("{header:?}") };
    assert!(table.starts_with("carom-10ft-20"), "{table}");
}

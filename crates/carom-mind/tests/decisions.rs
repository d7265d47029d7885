//! What the searching player answers.

use std::sync::atomic::{AtomicU32, Ordering};

use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::shot::PlacedBall;
use carom::{Error, Noise, Shot};
use carom_mind::search::PlayKind;
use carom_mind::value::{Logistic, Markov};
use carom_mind::{Answer, Budget, Decision, Player, SearchSettings, Searcher, Situation, Spent};
use carom_plan::Prepared;
use carom_rules::{Call, Frame, FrameSimulator, Game, Objective, Options, Play, Request};

const FEW: u64 = 300;

fn new_frame(game: Game, seed: u64) -> Frame {
    let options = Options { points: 3, patience: 40, ..Options::default() };
    Frame::new(game, options, None, None, seed).expect("a frame")
}

/// An eight-ball frame in which seat 0 has the cue ball where it lies.
fn eight_ball(places: &[(usize, [f64; 2])]) -> Frame {
    let mut frame = new_frame(Game::EightBall, 0);
    let mut all = vec![None; frame.layout().len()];
    for (ball, place) in places {
        all[*ball] = Some(*place);
    }
    frame.resume_at(&all, 0).expect("a position");
    frame
}

fn decide(frame: &Frame, noise: Noise, simulations: u64) -> Decision {
    let situation = Situation::new(frame, noise, 1);
    Searcher::default().decide(&situation, &Budget::simulations(simulations)).expect("a decision")
}

#[test]
fn every_request_of_every_game_gets_an_answer_until_the_frame_is_over() {
    let mut player = Searcher::default();
    let noise = Noise::olympiad(1.0);
    let mut simulator = FrameSimulator::new();
    for game in Game::ALL {
        let mut frame = new_frame(game, 3);
        // Frames of snooker are long.
        let is_long = frame.facts().objective == Objective::RedsAndColors;
        let most = if is_long { 60 } else { 400 };
        for index in 0..most {
            if frame.is_over() {
                break;
            }
            let situation = Situation::new(&frame, noise.clone(), index);
            let decision = player
                .decide(&situation, &Budget::simulations(FEW))
                .unwrap_or_else(|error| panic!("{}: {error}", game.name()));
            match decision.answer {
                Answer::Play(play) => {
                    let struck =
                        Prepared::new(&frame, play.cue_ball).expect("a shot").struck_ball();
                    let strike = noise.draw(&play.strike, &struck, 7, index);
                    frame.play_in(&mut simulator, &Play { strike, ..play }).expect("a shot");
                }
                Answer::Choice(choice) => {
                    frame.choose(choice).expect("an offered choice");
                }
                Answer::Concede => {
                    frame.concede().expect("a frame that is not over");
                }
            }
            let chance = decision.win_chance.expect("an estimate");
            assert!((0.0..=1.0).contains(&chance), "{}: {chance}", game.name());
        }
        assert!(frame.is_over() || is_long, "{} did not end", game.name());
    }
}

fn six_balls() -> Frame {
    eight_ball(&[
        (0, [0.4, 0.6]),
        (1, [0.7, 1.2]),
        (3, [0.2, 1.6]),
        (8, [0.5, 0.5]),
        (9, [0.9, 0.9]),
        (12, [0.6, 2.0]),
    ])
}

#[test]
fn a_decision_has_the_same_bits_for_any_number_of_threads() {
    let frame = six_balls();
    let situation = Situation::new(&frame, Noise::olympiad(1.0), 4);
    let with = |threads| {
        let runner = Runner::new(Some(threads)).expect("a runner");
        let budget = Budget { runner, ..Budget::simulations(9000) };
        Searcher::default().decide(&situation, &budget).expect("a decision")
    };
    let one = with(1);
    assert!(one.spent.rounds >= 2, "{:?}", one.spent);
    assert_eq!(with(2), one);
    assert_eq!(with(5), one);
}

#[test]
fn the_number_of_rounds_repeats_a_decision_that_a_clock_has_ended() {
    let frame = eight_ball(&[(0, [0.4, 0.6]), (1, [0.7, 1.2]), (8, [0.5, 0.5]), (9, [0.9, 0.9])]);
    let situation = Situation::new(&frame, Noise::olympiad(1.0), 4);
    let asked = AtomicU32::new(0);
    let ends = |spent: Spent| {
        asked.fetch_add(1, Ordering::Relaxed);
        spent.rounds >= 2
    };
    let clock = Budget { is_over: &ends, ..Budget::simulations(50_000) };
    let timed = Searcher::default().decide(&situation, &clock).expect("a decision");
    assert!(asked.load(Ordering::Relaxed) >= 1);
    assert_eq!(timed.spent.rounds, 2);
    let again = Budget { rounds: Some(2), ..Budget::simulations(50_000) };
    assert_eq!(Searcher::default().decide(&situation, &again).expect("a decision"), timed);
}

#[test]
fn an_easy_pot_is_played_and_called() {
    // The eight lies near a corner pocket, the cue ball straight behind it.
    let frame = eight_ball(&[(0, [0.5, 0.5]), (8, [0.2, 0.2]), (9, [0.9, 1.8])]);
    // Seat 0 has no group: the nine and the eight are not both on, so solids are gone.
    let decision = decide(&frame, Noise::olympiad(1.0), 1500);
    let Answer::Play(play) = decision.answer else { panic!("a play") };
    assert!(matches!(play.call, Call::Pocket(8, _)), "{:?}", play.call);
    assert!(decision.win_chance.is_some_and(|chance| chance > 0.9), "{:?}", decision.win_chance);
}

#[test]
fn a_push_out_is_considered_when_the_rules_offer_it_only() {
    let mut frame = new_frame(Game::NineBall, 11);
    let before = Searcher::default()
        .analyse(&Situation::new(&frame, Noise::olympiad(1.0), 0), &Budget::simulations(FEW), 40)
        .expect("plays");
    assert!(before.plays.iter().all(|play| play.kind == PlayKind::Break));
    // A legal break is played, and the next shot may be a push-out.
    let mut seed = 0;
    while !frame.turn().is_some_and(|turn| turn.calls.push_out) {
        seed += 1;
        frame = new_frame(Game::NineBall, seed);
        let decision = decide(&frame, Noise::olympiad(1.0), FEW);
        let Answer::Play(play) = decision.answer else { panic!("a break") };
        frame.play(&play).expect("a break");
        assert!(seed < 50, "no legal break");
    }
    let found = Searcher::default()
        .analyse(&Situation::new(&frame, Noise::olympiad(1.0), 0), &Budget::simulations(2000), 60)
        .expect("plays");
    assert!(found.plays.iter().any(|play| play.kind == PlayKind::PushOut));
}

#[test]
fn stated_chances_come_from_errors_that_took_no_part_in_the_choice() {
    let frame = eight_ball(&[(0, [0.4, 0.6]), (1, [0.7, 1.2]), (8, [0.5, 0.5]), (9, [0.9, 0.9])]);
    let situation = Situation::new(&frame, Noise::olympiad(2.0), 9);
    let analysis =
        Searcher::default().analyse(&situation, &Budget::simulations(4000), 3).expect("plays");
    assert_eq!(analysis.plays.len(), 3);
    for play in &analysis.plays {
        assert!(play.kept.variants >= 8);
        assert!(play.kept.met <= play.kept.variants && play.foul.met <= play.foul.variants);
        assert!(play.error >= 0.0 && play.error < 0.2);
    }
    let wins: Vec<f64> = analysis.plays.iter().map(|play| play.win).collect();
    assert!(wins.is_sorted_by(|a, b| a >= b), "{wins:?}");
}

#[test]
fn a_finished_frame_and_impossible_settings_are_refused_at_their_place() {
    let mut frame = new_frame(Game::EightBall, 0);
    let wild = Noise { azimuth: -1.0, ..Noise::NONE };
    let refused = |frame: &Frame, noise| {
        let situation = Situation::new(frame, noise, 0);
        let error = Searcher::default().decide(&situation, &Budget::simulations(10));
        match error {
            Err(Error::Input(e)) => e.place,
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(refused(&frame, wild), "noise.azimuth");
    frame.concede().expect("a frame that is not over");
    assert_eq!(refused(&frame, Noise::NONE), "frame");

    for (settings, place) in [
        (SearchSettings { exploring: 1.5, ..SearchSettings::default() }, "settings.exploring"),
        (SearchSettings { racing: 0, ..SearchSettings::default() }, "settings.racing"),
    ] {
        match Searcher::new("wrong", Box::<Markov>::default(), settings) {
            Err(Error::Input(e)) => assert_eq!(e.place, place),
            _ => panic!("{place} was accepted"),
        }
    }
}

#[test]
fn a_player_with_another_value_of_positions_has_another_opinion() {
    let frame = six_balls();
    let situation = Situation::new(&frame, Noise::olympiad(1.0), 4);
    let opinion = |value: Box<dyn carom_mind::value::Value>| {
        let mut player = Searcher::new("p", value, SearchSettings::default()).expect("a player");
        player.decide(&situation, &Budget::simulations(1000)).expect("a decision").win_chance
    };
    assert_ne!(opinion(Box::<Markov>::default()), opinion(Box::<Logistic>::default()));
}

#[test]
fn the_search_finds_its_way_out_of_a_snooker() {
    // The nine hides behind the eight; the nine must be hit first off a cushion.
    let mut frame = new_frame(Game::NineBall, 0);
    let mut all = vec![None; frame.layout().len()];
    all[0] = Some([0.3, 0.3]);
    all[9] = Some([0.6, 0.6]);
    all[2] = Some([0.45, 0.45 + 1e-3]);
    all[2] = Some([0.9, 2.2]);
    all[5] = Some([0.60, 0.665]);
    frame.resume_at(&all, 0).expect("a position");
    assert!(matches!(frame.request(), Request::Shot(turn) if turn.on == [2]));
    let decision = decide(&frame, Noise::olympiad(0.5), 1500);
    let Answer::Play(play) = decision.answer else { panic!("a play") };
    let (ruling, _) = frame.play(&play).expect("a play");
    assert!(ruling.is_legal(), "{:?}", ruling.fouls);
}

#[test]
fn balls_of_a_shot_become_a_situation() {
    let frame = eight_ball(&[(0, [0.5, 0.5]), (8, [0.2, 0.2]), (9, [0.9, 1.8])]);
    let shot: Shot = {
        let decision = decide(&frame, Noise::olympiad(1.0), FEW);
        let Answer::Play(play) = decision.answer else { panic!("a play") };
        frame.shot(&play).expect("a shot")
    };
    assert!(shot.balls().iter().all(|PlacedBall { id, .. }| !id.is_empty()));
    let again = Frame::of_shot(Game::EightBall, Options::default(), &shot, None).expect("a frame");
    let decision = decide(&again, Noise::olympiad(1.0), FEW);
    assert!(matches!(decision.answer, Answer::Play(_)));
}

/// A frame of snooker after a foul: seat 1 chooses who plays on.
fn after_a_foul() -> Frame {
    let mut frame = new_frame(Game::Snooker, 1);
    let strike = Strike { speed: 1.0, azimuth: -1.5, elevation: 0.1, side: 0.0, height: 0.0 };
    frame.play(&Play { cue_ball: Some([0.889, 0.6]), ..Play::new(strike) }).expect("a foul");
    frame
}

#[test]
fn the_position_after_each_choice_is_searched_within_the_budget() {
    let frame = after_a_foul();
    let Request::Choice { choices, .. } = frame.request() else { panic!("a choice") };
    let situation = Situation::new(&frame, Noise::olympiad(1.0), 4);
    let with = |threads, rounds| {
        let runner = Runner::new(Some(threads)).expect("a runner");
        let budget = Budget { runner, rounds, ..Budget::simulations(8000) };
        Searcher::default().decide(&situation, &budget).expect("a decision")
    };
    let whole = with(1, None);
    assert!((7000..8800).contains(&whole.spent.simulations), "{:?}", whole.spent);
    assert_eq!(with(3, None), whole);
    assert_eq!(with(2, Some(whole.spent.rounds)), whole);
    assert!(with(1, Some(1)).spent.simulations < whole.spent.simulations);
    // The chosen one is the best by decisions after each choice.
    let chances = choices.iter().map(|choice| {
        let mut next = frame.clone();
        next.choose(*choice).expect("an offered choice");
        let after = Situation { frame: &next, ..situation.clone() };
        let share = Budget::simulations(8000 / choices.len() as u64);
        let decision = Searcher::default().decide(&after, &share).expect("a decision");
        let chance = decision.win_chance.expect("an estimate");
        (*choice, if next.player() == frame.player() { chance } else { 1.0 - chance })
    });
    let (best, chance) = chances.max_by(|a, b| a.1.total_cmp(&b.1)).expect("choices");
    assert_eq!((whole.answer, whole.win_chance), (Answer::Choice(best), Some(chance)));
}

#[test]
fn a_listed_play_occurs_once_and_has_the_kind_of_what_it_does() {
    let frames = [(0.45, 0.75), (0.9, 1.9), (0.3, 1.3)].map(|(x, y)| {
        let mut frame = new_frame(Game::NineBall, 0);
        let mut all = vec![None; frame.layout().len()];
        (all[0], all[7], all[9]) = (Some([x, y]), Some([0.8, 1.45]), Some([0.95, 0.5]));
        frame.resume_at(&all, 0).expect("a position");
        frame
    });
    let mut kinds = Vec::new();
    for frame in &frames {
        let situation = Situation::new(frame, Noise::olympiad(2.0), 3);
        let analysis = Searcher::default()
            .analyse(&situation, &Budget::simulations(20_000), 20)
            .expect("an analysis");
        let plays: Vec<Play> = analysis.plays.iter().map(|listed| listed.play).collect();
        for (k, listed) in analysis.plays.iter().enumerate() {
            assert!(!plays[..k].contains(&listed.play), "{:?}", listed.play);
            let mut after = frame.clone();
            after.play(&listed.play).expect("a shot");
            if listed.kind == PlayKind::Safety {
                assert!(!after.keeps_turn(0), "{:?}", listed.play);
            }
            kinds.push(listed.kind);
        }
    }
    assert!(kinds.contains(&PlayKind::Safety) && kinds.contains(&PlayKind::Indirect), "{kinds:?}");
}

#[test]
fn a_clock_that_is_over_leaves_few_variants_to_count() {
    let frame = six_balls();
    let situation = Situation::new(&frame, Noise::olympiad(1.0), 4);
    let ends = |spent: Spent| spent.rounds >= 1;
    let clock = Budget { is_over: &ends, ..Budget::simulations(1 << 50) };
    let analysis = Searcher::default().analyse(&situation, &clock, 5).expect("an analysis");
    let counted: u64 = analysis.plays.iter().map(|play| play.kept.variants).sum();
    assert!(counted > 0 && 2 * counted <= analysis.spent.simulations, "{counted} {analysis:?}");
}

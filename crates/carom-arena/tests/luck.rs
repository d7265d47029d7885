//! The luck of shots: what is measured, and what it does not change.

mod common;

use carom::Noise;
use carom::noise::Perception;
use carom_arena::{
    AdjustedPairs, ArenaFrame, Breaker, Effect, LuckSettings, LuckValue, MatchPlan, MatchReport,
    MatchSettings, RECORD, measure_luck, play_frame, play_match, replay,
};
use carom_plan::{Interval, Progress};
use carom_rules::{FrameSimulator, Game};
use common::{
    Folder, SECRET, lines, made, plan, played, random_players, runner, short, two_random,
};

/// Settings with the luck of every shot, measured with a few fresh errors.
fn lucky(game: Game, value: LuckValue) -> MatchSettings {
    MatchSettings { luck: Some(LuckSettings { draws: 3, value }), ..short(game) }
}

/// Plays a whole match; its record and its report.
fn finished(plan: &MatchPlan, threads: usize, name: &str) -> (String, MatchReport) {
    let folder = Folder::new(name);
    let progress = Progress::default();
    let report =
        play_match(plan, folder.path(), &random_players, &runner(threads), &progress).unwrap();
    (folder.read(RECORD), report)
}

#[test]
fn the_luck_of_a_record_is_that_of_the_match_to_the_bit_in_every_game() {
    for game in Game::ALL {
        let measured = lucky(game, LuckValue::Logistic);
        let luck = measured.luck.unwrap();
        let perception = [Perception::round(0.001), Perception::default()];
        let noise = Noise { cling_probability: 0.1, ..Noise::olympiad(1.0) };
        let measured = MatchSettings { perception, noise: [noise.clone(), noise], ..measured };
        let without = MatchSettings { luck: None, ..measured.clone() };
        let (with_luck, report) = finished(&plan(measured, 1), 1, "with-luck");
        let (text, usual) = finished(&plan(without, 1), 1, "without-luck");
        assert!(!text.contains("\"luck\"") && usual.score.adjusted.pairs() == 0);
        assert_eq!(report.score.pairs, usual.score.pairs, "the luck changes no result");
        let found = measure_luck(&text, luck, &runner(1), &Progress::default()).unwrap();
        assert_eq!(found.difference, None, "{}", game.name());
        assert_eq!(found.with_luck.as_ref(), Some(&with_luck), "{}", game.name());
        assert_eq!(found.score, report.score);
        let replayed = replay(&with_luck, &runner(1), &Progress::default()).unwrap();
        assert_eq!((replayed.difference, replayed.score), (None, report.score));
        let shots = with_luck.matches("\"executed\": ").count();
        assert_eq!(with_luck.matches("\"expected\": ").count(), shots, "{}", game.name());
    }
}

#[test]
fn luck_that_is_measured_again_replaces_that_of_the_record() {
    let (text, _) = finished(&plan(lucky(Game::NineBall, LuckValue::Noise), 1), 1, "replaced");
    let luck = LuckSettings { draws: 2, value: LuckValue::Logistic };
    let found = measure_luck(&text, luck, &runner(1), &Progress::default()).unwrap();
    assert_eq!(found.difference, None);
    let again = found.with_luck.unwrap();
    let header = &lines(&again)[0];
    assert_eq!(header.get("luck").unwrap().to_json_line(), r#"{"draws": 2, "value": "logistic"}"#);
    assert_eq!(replay(&again, &runner(1), &Progress::default()).unwrap().difference, None);
    let none = LuckSettings { draws: 0, ..luck };
    let error = measure_luck(&text, none, &runner(1), &Progress::default()).unwrap_err();
    assert!(error.to_string().starts_with("luck.draws: 0 is out of range"), "{error}");
}

#[test]
fn the_luck_does_not_depend_on_the_number_of_threads() {
    let plan = plan(lucky(Game::EightBall, LuckValue::Logistic), 4);
    let [alone, many] = [1, 3].map(|threads| finished(&plan, threads, "luck-threads"));
    assert_eq!(alone.0, many.0);
    assert_eq!(alone.1.score, many.1.score);
}

#[test]
fn a_changed_luck_is_found() {
    let (text, _) = finished(&plan(lucky(Game::NineBall, LuckValue::Logistic), 1), 1, "changed");
    let start = text.find("\"expected\": 0.").unwrap() + 16;
    let digit = if &text[start..=start] == "1" { "2" } else { "1" };
    let changed = format!("{}{digit}{}", &text[..start], &text[start + 1..]);
    let found = replay(&changed, &runner(1), &Progress::default()).unwrap().difference.unwrap();
    assert_eq!((found.line, found.key.as_str()), (2, "moves[0].luck.expected"));
}

#[test]
fn shots_without_errors_have_no_luck() {
    for game in [Game::EightBall, Game::ThreeCushion] {
        let settings =
            MatchSettings { noise: [Noise::NONE; 2], ..lucky(game, LuckValue::Logistic) };
        let frame = played(&made(settings), 0, two_random());
        let mut shots = 0;
        for played in frame.moves() {
            let Effect::Played { luck, .. } = &played.effect else { continue };
            shots += 1;
            assert!(luck.unwrap().luck().abs() < 1e-12, "{luck:?}");
        }
        assert!(shots > 0 && frame.luck().unwrap().abs() < 1e-10);
    }
}

/// The mean luck of many shots is 0 for the built-in value and for one that means nothing, also
/// when players see the balls with errors and one player always breaks.
#[test]
fn the_mean_luck_is_zero_for_a_true_value_and_for_a_meaningless_one() {
    for value in LuckValue::ALL {
        let perception = [const { Perception::round(0.002) }; 2];
        let settings = MatchSettings {
            perception,
            breaker: Breaker::Always(0),
            ..lucky(Game::NineBall, value)
        };
        let of = made(settings);
        let (mut sum, mut squares, mut shots) = (0.0, 0.0, 0);
        for number in 0..40 {
            for played in played(&of, number, two_random()).moves() {
                let Effect::Played { luck: Some(luck), .. } = &played.effect else { continue };
                sum += luck.luck();
                squares += luck.luck() * luck.luck();
                shots += 1;
            }
        }
        assert!(shots > 500, "{shots}");
        let deviations = sum / f64::sqrt(squares);
        assert!(deviations.abs() < 3.0, "{}: {deviations}", value.name());
    }
}

/// Every frame has a rack of its own: the two frames of a pair of identical players are mirror images,
/// whose points are always even.
#[test]
fn identical_players_are_even_raw_and_corrected_by_any_value() {
    for value in LuckValue::ALL {
        let of = made(lucky(Game::NineBall, value));
        let (mut simulator, mut frames) = (FrameSimulator::new(), AdjustedPairs::default());
        let (mut raw, mut count) = (0.0, 0.0);
        for number in 0..120 {
            let seeds = SECRET.pair_seeds(1000 + number);
            let mut frame = ArenaFrame::begin(of.clone(), number, seeds, &mut simulator).unwrap();
            play_frame(&mut frame, &mut two_random(), &mut simulator, &Progress::default())
                .unwrap();
            let points = frame.points().unwrap();
            frames.add(points, frame.luck().unwrap());
            raw += points;
            count += 1.0;
        }
        let sigma = 0.5 / f64::sqrt(count);
        assert!((raw / count - 0.5).abs() < 3.0 * sigma, "{raw}");
        let adjusted = frames.share(0.997).unwrap();
        let Interval { low, high } = adjusted.interval;
        assert!(low < 0.5 && 0.5 < high, "{}: {adjusted:?}", value.name());
    }
}

//! Records: replay to the bit, changed and damaged records.

mod common;

use carom::ErrorKind;
use carom::noise::Perception;
use carom::resolve::cue_ball::Strike;
use carom_arena::{
    Breaker, MATCH_FORMAT, MatchHeader, MatchPlan, MatchSettings, Replay, SequentialTest,
    positions, replay,
};
use carom_plan::Progress;
use carom_rules::{Call, Game, Play};
use common::{lines, plan, record, runner, short, with_changed_digit};

fn replayed(text: &str) -> Result<Replay, carom::Error> {
    replay(text, &runner(1), &Progress::default())
}

#[test]
fn records_of_all_games_replay_to_the_bit() {
    for game in Game::ALL {
        let text = record(&plan(short(game), 1), game.name());
        let replayed = replayed(&text).unwrap();
        assert_eq!(replayed.difference, None, "{}", game.name());
        assert_eq!((replayed.frames, replayed.is_of_another_engine()), (2, false));
        assert_eq!(replayed.score.pairs.counts, [0, 0, 1, 0, 0], "mirror images");
    }
}

#[test]
fn the_positions_of_a_record_are_the_requests_to_which_its_moves_answer() {
    let text = record(&plan(short(Game::NineBall), 2), "positions");
    let frames = positions(&text, &runner(2), |ask| (ask.seat, ask.situation.frame.player()));
    let frames = frames.unwrap();
    assert_eq!(frames.len(), 4);
    let written = text.lines().filter(|line| line.contains("\"moves\""));
    for ((seen, end), line) in frames.iter().zip(written) {
        assert!(seen.iter().all(|(seat, asked)| *asked == Some(*seat)));
        assert_eq!(seen.len(), line.matches("\"seat\": ").count());
        assert!(end.winner.is_some(), "{end:?}");
    }
    let unfinished = text.lines().next().unwrap();
    assert!(positions(unfinished, &runner(1), |_| ()).is_err());
}

#[test]
fn records_with_given_breaks_and_errors_of_perception_replay() {
    let strike = Strike { speed: 8.0, azimuth: 1.57, elevation: 0.05, side: 0.0, height: 0.1 };
    let same_break = Some(Play::new(strike).from([0.635, 0.6]));
    let perception = [const { Perception::round(0.002) }; 2];
    for breaker in [Breaker::Alternate, Breaker::Always(1)] {
        let settings = MatchSettings {
            same_break,
            perception: perception.clone(),
            breaker,
            ..short(Game::EightBall)
        };
        let text = record(&plan(settings, 2), &format!("given-{breaker:?}"));
        assert_eq!(text.matches("\"given\": true").count(), 4, "{breaker:?}");
        assert_eq!(replayed(&text).unwrap().difference, None, "{breaker:?}");
    }
}

#[test]
fn a_replay_finds_a_changed_digit() {
    let text = record(&plan(short(Game::NineBall), 1), "digits");
    assert_eq!(replayed(&text).unwrap().difference, None);
    for (line, key, place) in [
        // The azimuth of the intended strike changes the one that is executed.
        (2, "azimuth", "moves[0].executed.strike.azimuth"),
        (3, "trace", "moves[0].trace"),
        (2, "rack", "seeds.rack"),
        (3, "scores", "scores[0]"),
        (1, "secret_sha256", "secret_sha256"),
        // Values that a replay repeats: the hash of the lines covers them.
        (2, "win_chance", "sha256"),
        (3, "simulations", "sha256"),
        (1, "pairs", "sha256"),
    ] {
        let changed = with_changed_digit(&text, line, key);
        assert_ne!(changed, text);
        let difference = replayed(&changed).unwrap().difference.expect(key);
        let line = if place == "sha256" { 4 } else { line as u64 };
        assert_eq!((difference.line, difference.key.as_str()), (line, place), "{difference:?}");
        assert_ne!(difference.recorded, difference.replayed);
    }
}

#[test]
fn a_replay_finds_an_executed_strike_that_differs_by_one_bit() {
    let text = record(&plan(short(Game::NineBall), 1), "bits");
    let executed = text.find("\"executed\"").unwrap();
    let start = executed + text[executed..].find("\"side\": ").unwrap() + 8;
    let end = start + text[start..].find(',').unwrap();
    let side: f64 = text[start..end].parse().unwrap();
    let changed = format!("{}{:?}{}", &text[..start], side.next_up(), &text[end..]);
    let difference = replayed(&changed).unwrap().difference.unwrap();
    assert_eq!(difference.key, "moves[0].executed.strike.side");
    assert_eq!(difference.replayed, text[start..end]);
}

#[test]
fn a_replay_finds_moves_that_were_removed_or_added() {
    let text = record(&plan(short(Game::NineBall), 1), "moves");
    let all: Vec<&str> = text.lines().collect();
    let start = all[1].find("{\"seat\"").unwrap();
    let next = start + 1 + all[1][start + 1..].find("{\"seat\"").unwrap();
    let without = format!("{}{}", &all[1][..start], &all[1][next..]);
    let twice = format!("{}{}{}", &all[1][..start], &all[1][start..next], &all[1][start..]);
    for line in [without, twice] {
        let changed = text.replacen(all[1], &line, 1);
        let difference = replayed(&changed).unwrap().difference.unwrap();
        assert_eq!(difference.line, 2);
        assert!(difference.key.starts_with("moves["), "{difference:?}");
    }
}

#[test]
fn a_damaged_record_is_refused_with_its_line_and_key() {
    let text = record(&plan(short(Game::NineBall), 1), "damaged");
    let all: Vec<&str> = text.lines().collect();
    let replaced = |line: usize, from: &str, to: &str| {
        let mut all: Vec<String> = all.iter().map(|&line| line.to_owned()).collect();
        assert!(all[line - 1].contains(from), "{from}");
        all[line - 1] = all[line - 1].replacen(from, to, 1);
        all.join("\n")
    };
    for (damaged, expected) in [
        (String::new(), "line 1: the record ends before"),
        (all[..3].join("\n"), "line 3: the record ends before the line with the secret"),
        (replaced(1, MATCH_FORMAT, "carom-match/9"), "line 1, format: it is another format"),
        (replaced(1, "\"pairs\"", "\"pars\""), "line 1, pars: unknown key; did you mean `pairs`?"),
        (replaced(1, "\"nine-ball\"", "\"nine-bal\""), "line 1, game: there is no game"),
        (
            replaced(1, "\"simulations\": 100", "\"simulations\": 0"),
            "line 1, clock[0].simulations: ",
        ),
        (replaced(2, "\"strike\"", "\"strik\""), "line 2, moves[0].play.strik: unknown key"),
        (replaced(2, "\"speed\": ", "\"speed\": ["), "line 2, "),
        (replaced(3, "\"frame\": 1", "\"frame\": 7"), "line 3, frame: found frame 7"),
        (
            replaced(3, "\"reason\": \"", "\"reason\": \"x"),
            "line 3, end.reason: there is no reason",
        ),
        (replaced(3, "\"cost\"", "\"costs\""), "line 3, moves[0].cost: the key is missing"),
        (
            replaced(4, "\"secret\": \"2a", "\"secret\": \"zz"),
            "line 4, secret: it does not have 64",
        ),
    ] {
        let error = replayed(&damaged).unwrap_err().to_string();
        assert!(error.starts_with(expected), "{error}");
    }
    let cut = replaced(2, "\"executed\": {", "\"executed\": ");
    let error = replayed(&cut).unwrap_err().to_string();
    assert!(error.starts_with("line 2, ") && error.contains("not JSON"), "{error}");
    assert!(!error.contains("line 1"), "{error}");
}

#[test]
fn a_stopped_replay_is_an_error() {
    let text = record(&plan(short(Game::NineBall), 1), "stopped");
    let progress = Progress::default();
    progress.stop();
    let error = replay(&text, &runner(1), &progress).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Stopped);
    let error = error.to_string();
    assert!(error.starts_with("progress: the replay was stopped"), "{error}");
}

#[test]
fn a_header_reads_back_to_the_same_settings() {
    let strike = Strike { speed: 2.5, azimuth: 1.4, elevation: 0.05, side: 0.1, height: 0.0 };
    let safety = Play { call: Call::Safety, ..Play::new(strike).from([0.5, 0.5]) };
    let settings = MatchSettings {
        same_break: Some(safety),
        physics: Some("pool-worn-cloth".into()),
        ..short(Game::StraightPool)
    };
    let test = SequentialTest::of_elo(0.0, 20.0).unwrap();
    let plan = MatchPlan { test: Some(test), ..plan(settings, 50) };
    let header = MatchHeader::new(plan.of, plan.pairs, plan.test, "00".into());
    let node = header.to_node();
    let again = MatchHeader::from_node(&node).unwrap();
    assert_eq!(again.to_node(), node);
    assert_eq!(again.of.settings().same_break, Some(safety));
    assert_eq!((again.test, again.pairs), (Some(test), 50));
    let Some(carom::format::Node::Text(physics)) = node.get("physics") else { panic!("{node:?}") };
    assert!(physics.starts_with("pool-worn-cloth-20"), "{physics}");
    assert_eq!(lines(&node.to_json_line()), std::slice::from_ref(&node));
    // A test of shares has no unit, one of normalised Elo has.
    assert!(node.get("test").unwrap().get("unit").is_none());
    let test = SequentialTest::of_normalised_elo(-5.0, 25.0).unwrap();
    let header = MatchHeader::new(header.of, 50, Some(test), "00".into());
    let again = MatchHeader::from_node(&header.to_node()).unwrap();
    assert_eq!(again.test, Some(test));
    let unit = header.to_node().get("test").and_then(|test| test.get("unit").cloned());
    assert_eq!(unit, Some("nelo".into()));
}

//! A frame with its history: its record is played again to the same bits.

use carom::format::Node;
use carom::resolve::cue_ball::Strike;
use carom::{ErrorKind, ShotFile};
use carom_rules::{Choice, FrameHistory, Game, Options, Play, Request};

fn frame(game: Game, seed: u64) -> FrameHistory {
    FrameHistory::new(game, Options::default(), None, None, seed).unwrap()
}

fn opening() -> Play {
    let azimuth = std::f64::consts::FRAC_PI_2;
    let strike = Strike { speed: 8.0, azimuth, elevation: 0.1, side: 0.05, height: -0.1 };
    Play { cue_ball: Some([0.635, 0.6]), ..Play::new(strike) }
}

/// Ten moves of a player without a plan.
fn played(game: Game, seed: u64) -> FrameHistory {
    let mut history = frame(game, seed);
    let call = history.frame().legal_calls()[0];
    history.play(&Play { call, ..opening() }).unwrap();
    for number in 0..10 {
        match *history.frame().request() {
            Request::Over { .. } => break,
            Request::Choice { choices, .. } => drop(history.choose(choices[0]).unwrap()),
            Request::Shot(_) => {
                let places = history.frame().legal_places(1, number);
                let call = history.frame().legal_calls()[0];
                let azimuth = 0.7 * number as f64;
                let strike = Strike { speed: 3.0, azimuth, elevation: 0.2, side: 0.0, height: 0.1 };
                let cue_ball = places.first().copied();
                history.play(&Play { cue_ball, call, ..Play::new(strike) }).unwrap();
            }
        }
    }
    history
}

#[test]
fn a_record_is_played_again_to_the_same_bits() {
    for game in [Game::NineBall, Game::EightBall, Game::Snooker, Game::StraightPool] {
        let history = played(game, 5);
        let record = history.record().to_json();
        let again = FrameHistory::replay(&Node::from_json(&record).unwrap()).unwrap();
        assert_eq!(again.frame().hash(), history.frame().hash(), "{}", game.name());
        assert_eq!(again.record().to_json(), record);
        assert!(history.moves().len() > 2, "{}", game.name());
    }
}

#[test]
fn a_move_carries_over_to_another_computer() {
    let (mut here, mut there) = (frame(Game::NineBall, 7), frame(Game::NineBall, 7));
    let (ruling, trace) = here.play(&opening()).unwrap();
    let sent = here.moves()[0].to_json_line();
    let (same, traced) = there.make(&Node::from_json(&sent).unwrap()).unwrap();
    assert_eq!((same, traced.map(|trace| trace.hash())), (ruling, Some(trace.hash())));
    assert_eq!(there.frame().hash(), here.frame().hash());
}

#[test]
fn a_seed_that_javascript_cannot_hold_is_written_in_hexadecimal() {
    for (seed, written) in [(u64::MAX, "\"seed\": \"ffffffffffffffff\""), (12, "\"seed\": 12")] {
        let history = frame(Game::NineBall, seed);
        assert!(history.record().to_json().contains(written));
        let again = FrameHistory::replay(&history.record()).unwrap();
        assert_eq!(again.frame().hash(), history.frame().hash());
    }
}

#[test]
fn a_frame_of_a_shot_is_played_again_too() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shots/half_ball_cut.json");
    let shot = ShotFile::from_json(&std::fs::read_to_string(file).unwrap()).unwrap();
    let mut history =
        FrameHistory::of_shot(Game::Practice, Options::default(), &shot, None).unwrap();
    let strike = shot.strike().unwrap().1;
    history.play(&Play::new(strike)).unwrap();
    history.concede().unwrap();
    let again = FrameHistory::replay(&history.record()).unwrap();
    assert_eq!(again.frame().hash(), history.frame().hash());
}

/// Records of before the key `player` begin with player 0, whichever ball the shot strikes.
#[test]
fn a_record_of_a_shot_says_when_the_second_player_begins() {
    let text = r#"{"format": "carom-shot/1", "table": "carom-10ft", "balls": [
        {"id": "cue", "position": [0.7, 0.7]}, {"id": "yellow", "position": [0.3, 0.3]},
        {"id": "red", "position": [0.7, 2.13]}],
        "strike": {"ball": "yellow", "speed": 2, "azimuth_deg": 90}}"#;
    let shot = ShotFile::from_json(text).unwrap();
    for (player, expected) in [(None, 1), (Some(0), 0), (Some(1), 1)] {
        let history =
            FrameHistory::of_shot(Game::ThreeCushion, Options::default(), &shot, player).unwrap();
        let record = history.record();
        assert_eq!(record.to_json().contains("\"player\": 1"), expected == 1);
        let again = FrameHistory::replay(&record).unwrap();
        assert_eq!(again.frame().player(), Some(expected));
        assert_eq!(again.frame().hash(), history.frame().hash());
    }
}

#[test]
fn a_wrong_move_is_refused_with_its_place_and_changes_nothing() {
    let mut history = frame(Game::NineBall, 7);
    let before = history.frame().hash();
    for (made, kind, place) in [
        ("{}", ErrorKind::NotAMove, ""),
        ("{\"concede\": false}", ErrorKind::NotAMove, ""),
        ("{\"choice\": \"dance\"}", ErrorKind::UnknownName, "choice"),
        ("{\"choice\": \"play-on\"}", ErrorKind::WrongState, "choice"),
        ("{\"play\": {}}", ErrorKind::Missing, "strike"),
        ("{\"play\": {\"strike\": {\"speed\": 1}}}", ErrorKind::Missing, "strike.azimuth_deg"),
        (
            "{\"play\": {\"strike\": {\"speed\": 99, \"azimuth\": 1}}}",
            ErrorKind::OutOfRange,
            "strike.speed",
        ),
    ] {
        let error = history.make(&Node::from_json(made).unwrap()).unwrap_err();
        assert_eq!(error.kind(), kind, "{made}: {error}");
        assert!(error.to_string().starts_with(place), "{error}");
    }
    assert_eq!((history.frame().hash(), history.moves().len()), (before, 0));
    assert_eq!(history.choose(Choice::PlayOn).unwrap_err().kind(), ErrorKind::WrongState);
}

#[test]
fn a_damaged_record_is_refused_with_the_move_and_the_engine_that_made_it() {
    let mut record = played(Game::NineBall, 5).record();
    record.set("engine", "carom 0.0.1");
    record.set("moves", Node::list([Node::object([("choice", Node::from("play-on"))])]));
    let error = FrameHistory::replay(&record).unwrap_err().to_string();
    assert!(error.starts_with("moves[0].choice: "), "{error}");
    assert!(error.contains("made by carom 0.0.1"), "{error}");
    let wrong = Node::object([("format", "carom-frame/1".into())]);
    assert_eq!(FrameHistory::replay(&wrong).unwrap_err().kind(), ErrorKind::Missing);
}

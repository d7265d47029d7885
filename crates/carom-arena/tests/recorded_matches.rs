//! Records as viewers read them: every game, matches that go on, and damaged lines.

mod common;

use carom::format::Node;
use carom::resolve::cue_ball::Strike;
use carom_arena::{MatchHeader, RecordedMatch};
use carom_rules::{Call, Choice, Game, Play, check_record};
use common::{plan, record, short, with_changed_digit};

#[test]
fn every_recorded_game_is_played_again_with_the_same_traces_and_scores() {
    for game in Game::ALL {
        let text = record(&plan(short(game), 1), &format!("games-{}", game.name()));
        let recorded = RecordedMatch::read(&text).unwrap();
        assert!(recorded.is_finished());
        for line in recorded.frames() {
            let number = i64::from(line.get("frame") == Some(&Node::Integer(1)));
            let game = recorded.game(number.unsigned_abs()).unwrap();
            check_record(game.get("record").unwrap()).unwrap();
            let (traces, scores) = play_again(recorded.header(), &game);
            assert_eq!(traces.as_slice(), list(&game, "moves").as_slice());
            assert_eq!(Some(&scores), line.get("scores"));
        }
    }
}

/// The moves of a recorded game with the hashes of the traces that they have when they are played,
/// and the scores at the end.
fn play_again(header: &MatchHeader, game: &Node) -> (Vec<Node>, Node) {
    let record = game.get("record").unwrap();
    let Some(Node::Text(seed)) = record.get("setup").unwrap().get("seed") else { panic!() };
    let seed = u64::from_str_radix(seed, 16).unwrap();
    let mut frame = header.of.start().with_seed(seed).unwrap();
    let made = list(record, "moves");
    let again = list(game, "moves").into_iter().map(|mut node| {
        let Some(Node::Integer(index)) = node.get("index") else { return node };
        let made = &made[*index as usize];
        if let Some(play) = made.get("play") {
            let (strike, place) = (play.get("strike").unwrap(), play.get("cue_ball"));
            let number = |key| match strike.get(key) {
                Some(Node::Number(x)) => *x,
                other => panic!("{other:?}"),
            };
            let strike = Strike {
                speed: number("speed"),
                azimuth: number("azimuth"),
                elevation: number("elevation"),
                side: number("side"),
                height: number("height"),
            };
            let text = |node: &Node, key| match node.get(key) {
                Some(Node::Text(text)) => Some(text.clone()),
                _ => None,
            };
            let call = play.get("call").map_or(Ok(Call::Nothing), |call| {
                let (ball, pocket) = (text(call, "ball"), text(call, "into"));
                frame.call(&text(call, "kind").unwrap(), ball.as_deref(), pocket.as_deref())
            });
            let cue_ball = place.map(|place| match place {
                Node::List(xy) => match xy[..] {
                    [Node::Number(x), Node::Number(y)] => [x, y],
                    _ => panic!("{xy:?}"),
                },
                other => panic!("{other:?}"),
            });
            let play = Play { cue_ball, call: call.unwrap(), ..Play::new(strike) };
            let trace = frame.shot(&play).unwrap().simulate().unwrap();
            frame.apply(&play, &trace).unwrap();
            node.set("trace", format!("{:016x}", trace.hash()));
        } else if let Some(Node::Text(choice)) = made.get("choice") {
            frame.choose(Choice::named(choice).unwrap()).unwrap();
        } else {
            frame.concede().unwrap();
        }
        node
    });
    let again = again.collect();
    (again, Node::list(frame.scores().map(i64::from)))
}

fn list(node: &Node, key: &str) -> Vec<Node> {
    match node.get(key) {
        Some(Node::List(items)) => items.clone(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_record_of_a_match_that_goes_on_is_read_without_its_incomplete_line() {
    let text = record(&plan(short(Game::NineBall), 2), "goes-on");
    let lines: Vec<&str> = text.lines().collect();
    // The frames of pair 1 ended first, and a line is being written.
    let half = &lines[1][..lines[1].len() / 2];
    let played = [lines[0], lines[3], lines[4], half].join("\n");
    let recorded = RecordedMatch::read(&played).unwrap();
    assert!(!recorded.is_finished());
    let numbers: Vec<_> = recorded.frames().iter().map(|f| f.get("frame").cloned()).collect();
    assert_eq!(numbers, [Some(Node::Integer(2)), Some(Node::Integer(3))]);
    assert!(recorded.game(2).is_ok());
    assert_eq!(place_of(recorded.game(0)), "frame");
}

#[test]
fn a_record_that_was_damaged_is_refused_with_its_line_and_key() {
    let text = record(&plan(short(Game::NineBall), 1), "damaged");
    let lines: Vec<&str> = text.lines().collect();
    let read = |text: &str| place_of(RecordedMatch::read(text));
    assert_eq!(read(""), "line 1");
    assert_eq!(read(&text.replacen("carom-match/1", "carom-match/9", 1)), "line 1, format");
    assert_eq!(read(&text.replacen("\"pairs\"", "\"peers\"", 1)), "line 1, peers");
    assert_eq!(read(&text.replacen("\"speed\": ", "\"spied\": ", 7)), "line 1, noise[0].spied");
    assert_eq!(read(&text.replacen("\"seats\": [1, 0]", "\"seats\": [0, 1]", 1)), "line 3, seats");
    assert_eq!(read(&[lines[0], lines[2], lines[2], ""].join("\n")), "line 3, frame");
    assert_eq!(read(&with_changed_digit(&text, 2, "trace")), "line 4, sha256");
    assert_eq!(read(&with_changed_digit(&text, 4, "secret")), "line 4, secret");
    assert_eq!(read(&with_changed_digit(&text, 4, "sha256")), "line 4, sha256");
    let half = format!("{}\n{{\"frame\": 0, ", lines[0]);
    assert!(read(&format!("{half}\n")).starts_with("line 2"), "a complete line must be JSON");
    assert!(RecordedMatch::read(&half).is_ok());
}

fn place_of<T: std::fmt::Debug>(read: Result<T, carom::Error>) -> String {
    match read.unwrap_err() {
        carom::Error::Input(error) => error.place,
        other => panic!("{other}"),
    }
}

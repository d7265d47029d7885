//! A frame in words, and the schemas of the answers to it.

use carom::format::Node;
use carom::resolve::cue_ball::Strike;
use carom_rules::{Choice, Frame, Game, Options, Play, Request, play_schema};

fn frame(game: Game) -> Frame {
    Frame::new(game, Options::default(), None, None, 4).expect("the game's own table")
}

/// Eight-ball after a break that was too soft: the frame asks player 1 for a choice.
fn choosing() -> Frame {
    let mut frame = frame(Game::EightBall);
    let soft = Strike { speed: 1.0, azimuth: 1.5, elevation: 0.0, side: 0.0, height: 0.0 };
    frame.play(&Play::new(soft).from([0.6, 0.5])).expect("it can be played");
    frame
}

#[test]
fn the_description_of_a_frame_has_what_a_player_needs() {
    assert_eq!(
        frame(Game::ThreeCushion).describe(),
        "Game: three-cushion. Score: 0 to 0.\n\
         Innings: player 0 1, player 1 0. 40 points win.\n\
         Table: x from 0 to 1.4200 m (left to right), y from 0 to 2.8400 m (bottom to top). \
         Azimuths are counter-clockwise from +x. A ball's radius: 0.0307 m.\n\
         Balls: cue (0.8925, 0.7100), yellow (0.7100, 0.7100), red (0.7100, 2.1300).\n\
         Player 0 shoots the opening shot with cue, where it lies.\n\
         To be hit first: red.\n\
         Call: nothing is called."
    );
    let break_shot = frame(Game::EightBall).describe();
    for part in [
        "The table is open.",
        "Pockets: bottom-left (",
        ", 8 (0.6350, 2.0042)",
        "with cue in hand behind the head string; its centre may be put where y < 0.635 m.",
        "Any ball may be hit first.",
    ] {
        assert!(break_shot.contains(part), "{part}: {break_shot}");
    }
}

#[test]
fn the_description_of_every_game_names_every_ball_and_the_seat() {
    for game in Game::ALL {
        let frame = frame(game);
        let text = frame.describe();
        for ball in frame.layout().on_table() {
            let id = &frame.layout().balls()[usize::from(ball)].id;
            assert!(text.contains(&format!(" {id} (")), "{}: {text}", game.name());
        }
        assert!(text.contains("Player 0 shoots the opening shot"), "{text}");
        assert!(text.lines().all(|line| !line.ends_with(' ')) && !text.contains("  "), "{text}");
    }
}

#[test]
fn the_description_of_a_choice_lists_it_and_that_of_an_end_the_winner() {
    let mut frame = choosing();
    let Request::Choice { choices, .. } = *frame.request() else { panic!("{:?}", frame.request()) };
    let text = frame.describe();
    assert!(text.contains("Player 1 chooses ("));
    assert!(choices.iter().all(|choice| text.contains(&format!("\n- {}: ", choice.name()))));
    assert!(!text.contains(Choice::SpotFrozen.name()));
    frame.concede().expect("player 1 may");
    assert!(
        frame
            .describe()
            .ends_with("The frame is over: player 0 has won; the other player conceded."),
        "{}",
        frame.describe()
    );
}

fn at<'a>(node: &'a Node, path: &str) -> &'a Node {
    path.split('/').fold(node, |node, key| node.get(key).unwrap_or_else(|| panic!("no {key}")))
}

#[test]
fn the_schema_of_an_answer_allows_what_the_request_allows() {
    let nine = frame(Game::NineBall).answer_schema();
    let cue_ball = at(&nine, "properties/play/properties/cue_ball/prefixItems").to_json();
    assert!(cue_ball.contains("\"maximum\": 0.635"), "{cue_ball}");
    let call = |frame: &Frame| {
        at(&frame.answer_schema(), "properties/play/properties/call").to_json_line()
    };
    assert_eq!(call(&frame(Game::NineBall)).matches("const").count(), 1, "nothing is called");
    assert!(choosing().answer_schema().to_json_line().contains("\"enum\": [\"play-on\""));
    let mut called = choosing();
    called.choose(Choice::PlayOn).expect("it is offered");
    let text = call(&called);
    assert!(text.contains("\"pocket\"") && text.contains("\"safety\""), "{text}");
    assert!(!text.contains("\"nothing\"") && !text.contains("\"cue\""), "{text}");
    let schema = called.answer_schema();
    assert_eq!(at(&schema, "properties/play/required").to_json(), "[\"strike\", \"call\"]");
    let mut over = called;
    over.concede().expect("a player may");
    assert_eq!(at(&over.answer_schema(), "properties").to_json(), "{}");
}

#[test]
fn the_schema_of_a_play_has_the_strike_of_a_shot_file() {
    let schema = play_schema();
    let strike = at(&schema, "properties/strike");
    assert!(strike.get("properties").and_then(|keys| keys.get("ball")).is_none());
    assert_eq!(at(strike, "properties/speed/maximum").to_json(), "50");
    assert_eq!(at(strike, "required").to_json(), "[\"speed\"]");
}

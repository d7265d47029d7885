//! What is asked of a frame at the wrong time, or is not there at all, is refused, and changes nothing.

use carom::resolve::cue_ball::Strike;
use carom::table::PocketName;
use carom_rules::{Call, Choice, Frame, Options, Play, Request, Rules};

/// Up the table.
const STRIKE: Strike = Strike { speed: 1.0, azimuth: 1.5, elevation: 0.0, side: 0.0, height: 0.0 };
const BEHIND: [f64; 2] = [0.6, 0.5];
const CORNER: PocketName = PocketName::TopLeft;

fn frame(rules: Rules) -> Frame {
    Frame::new(rules, Options::default(), None, None, 4).expect("the game's own table")
}

/// Three balls of a game that goes on: the cue ball, and two others.
fn middle(rules: Rules, balls: [usize; 2]) -> Frame {
    let mut frame = frame(rules);
    let mut places = vec![None; frame.layout().len()];
    for (ball, place) in [(0, [0.5, 0.5]), (balls[0], [0.4, 1.4]), (balls[1], [0.8, 1.9])] {
        places[ball] = Some(place);
    }
    frame.scatter(&places, 0).expect("a game that goes on");
    frame
}

/// A break of eight-ball that is too soft: player 1 is to choose.
fn choosing() -> Frame {
    let mut frame = frame(Rules::EightBall);
    frame.play(&Play::new(STRIKE).from(BEHIND)).expect("it can be played");
    assert!(matches!(frame.request(), Request::Choice { player: 1, .. }));
    frame
}

#[track_caller]
fn refused(frame: &mut Frame, play: &Play, place: &str) {
    let before = frame.to_node();
    let shown = frame.shot(play).expect_err("it is refused").to_string();
    let played = frame.play(play).expect_err("it is refused").to_string();
    assert!(shown.starts_with(place), "{shown}");
    assert_eq!(shown, played);
    assert_eq!(frame.to_node(), before, "nothing has changed");
}

#[test]
fn no_shot_is_played_while_a_choice_is_due_or_after_the_end() {
    let mut frame = choosing();
    refused(&mut frame, &Play::new(STRIKE), "play: ");
    frame.concede().expect("player 1 may");
    refused(&mut frame, &Play::new(STRIKE), "play: ");
    assert!(frame.choose(Choice::PlayOn).is_err() && frame.concede().is_err());
}

#[test]
fn no_choice_is_made_while_a_shot_is_due_nor_one_that_is_not_offered() {
    for choice in Choice::ALL {
        assert!(frame(Rules::EightBall).choose(choice).is_err(), "{}", choice.name());
        let mut frame = choosing();
        let Request::Choice { choices, .. } = frame.request().clone() else { unreachable!() };
        let before = frame.to_node();
        assert_eq!(frame.choose(choice).is_ok(), choices.contains(&choice), "{}", choice.name());
        assert_eq!(frame.to_node() == before, !choices.contains(&choice));
    }
}

#[test]
fn a_call_is_of_a_ball_on_the_table_into_a_pocket_that_it_has() {
    let mut eight = middle(Rules::EightBall, [1, 8]);
    let call = |call| Play { call, ..Play::new(STRIKE) };
    for ball in [0, 2, 16, 255] {
        refused(&mut eight, &Play::new(STRIKE).calling(ball, CORNER), "call: the called ball");
    }
    refused(&mut eight, &call(Call::Nothing), "call: nothing is called");
    refused(&mut eight, &call(Call::PushOut), "call: a push-out");
    refused(&mut eight, &call(Call::On(1)), "call: that ball");
    refused(&mut middle(Rules::NineBall, [1, 9]), &call(Call::Safety), "call: no safety");
    let snooker = frame(Rules::Snooker);
    let places: Vec<_> = (0..22).map(|ball| snooker.layout().place(ball)).collect();
    let mut snooker = snooker;
    snooker.scatter(&places, 0).expect("a rack");
    refused(&mut snooker, &call(Call::On(1)).from([0.8, 0.6]), "call: that ball");
}

#[test]
fn a_cue_ball_that_lies_stays_and_one_in_hand_is_put_in_its_region() {
    let mut lying = middle(Rules::NineBall, [1, 9]);
    refused(&mut lying, &Play::new(STRIKE).from(BEHIND), "cue_ball: ");
    let mut breaking = frame(Rules::NineBall);
    let string = 0.635;
    for place in [[0.6, string], [0.6, 2.0], [f64::NAN, 0.3], [0.3, f64::INFINITY], [-1.0, 0.3]] {
        refused(&mut breaking, &Play::new(STRIKE).from(place), "cue_ball: ");
    }
    let mut snooker = frame(Rules::Snooker);
    for place in [[0.3, 0.7], [0.889, 0.8], [0.889, 0.4]] {
        refused(&mut snooker, &Play::new(STRIKE).from(place), "cue_ball: ");
    }
    let brown = snooker.layout().place(18).expect("it is on its spot");
    refused(&mut snooker, &Play::new(STRIKE).from(brown), "cue_ball: it would touch");
}

#[test]
fn only_two_players_play() {
    let mut frame = frame(Rules::Practice);
    let places: Vec<_> = (0..16).map(|ball| frame.layout().place(ball)).collect();
    assert!(frame.scatter(&places, 2).expect_err("a third").to_string().starts_with("player: "));
}

#[test]
fn a_copy_goes_its_own_way_and_the_same_way_to_the_bit() {
    let frame = choosing();
    let mut one = frame.clone();
    one.choose(Choice::PlayOn).expect("it is offered");
    let play = Play { call: Call::Safety, ..Play::new(STRIKE) };
    one.play(&play).expect("it can be played");
    let mut other = frame.clone();
    other.choose(Choice::PlayOn).expect("it is offered");
    other.play(&play).expect("it can be played");
    assert_eq!(one.to_node().to_json(), other.to_node().to_json());
    assert_ne!(one.to_node(), frame.to_node());
}

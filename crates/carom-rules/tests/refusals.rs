//! A frame refuses plays and choices that it does not ask for or that do not exist; it is unchanged
//! afterwards.

use carom::resolve::cue_ball::Strike;
use carom::table::PocketName;
use carom_rules::{Call, Choice, Frame, Game, Options, Play, Request};

/// Up the table.
const STRIKE: Strike = Strike { speed: 1.0, azimuth: 1.5, elevation: 0.0, side: 0.0, height: 0.0 };
const BEHIND: [f64; 2] = [0.6, 0.5];
const CORNER: PocketName = PocketName::TopLeft;

fn frame(game: Game) -> Frame {
    Frame::new(game, Options::default(), None, None, 4).expect("the game's own table")
}

/// A game that continues with three balls: the cue ball and two others.
fn middle(game: Game, balls: [usize; 2]) -> Frame {
    let mut frame = frame(game);
    let mut places = vec![None; frame.layout().len()];
    for (ball, place) in [(0, [0.5, 0.5]), (balls[0], [0.4, 1.4]), (balls[1], [0.8, 1.9])] {
        places[ball] = Some(place);
    }
    frame.resume_at(&places, 0).expect("a valid position");
    frame
}

/// Eight-ball after a break that was too soft: the frame asks player 1 for a choice.
fn choosing() -> Frame {
    let mut frame = frame(Game::EightBall);
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
fn a_shot_is_refused_while_a_choice_is_due_and_after_the_end() {
    let mut frame = choosing();
    refused(&mut frame, &Play::new(STRIKE), "play: ");
    frame.concede().expect("player 1 may");
    refused(&mut frame, &Play::new(STRIKE), "play: ");
    assert!(frame.choose(Choice::PlayOn).is_err() && frame.concede().is_err());
}

#[test]
fn a_choice_is_refused_while_a_shot_is_due_and_when_it_is_not_offered() {
    for choice in Choice::ALL {
        assert!(frame(Game::EightBall).choose(choice).is_err(), "{}", choice.name());
        let mut frame = choosing();
        let Request::Choice { choices, .. } = *frame.request() else { unreachable!() };
        let before = frame.to_node();
        assert_eq!(frame.choose(choice).is_ok(), choices.contains(&choice), "{}", choice.name());
        assert_eq!(frame.to_node() == before, !choices.contains(&choice));
    }
}

#[test]
fn a_call_must_be_allowed_and_of_a_ball_on_the_table() {
    let mut eight = middle(Game::EightBall, [1, 8]);
    let call = |call| Play { call, ..Play::new(STRIKE) };
    for ball in [0, 2, 16, 255] {
        refused(&mut eight, &Play::new(STRIKE).calling(ball, CORNER), "call: the called ball");
    }
    refused(&mut eight, &call(Call::Nothing), "call: nothing is called");
    refused(&mut eight, &call(Call::PushOut), "call: a push-out");
    refused(&mut eight, &call(Call::On(1)), "call: that ball");
    refused(&mut middle(Game::NineBall, [1, 9]), &call(Call::Safety), "call: a safety");
    let snooker = frame(Game::Snooker);
    let places: Vec<_> = (0..22).map(|ball| snooker.layout().place(ball)).collect();
    let mut snooker = snooker;
    snooker.resume_at(&places, 0).expect("a rack");
    refused(&mut snooker, &call(Call::On(1)).from([0.8, 0.6]), "call: that ball");
}

#[test]
fn a_cue_ball_may_be_placed_only_if_it_is_in_hand_and_only_in_its_region() {
    let mut lying = middle(Game::NineBall, [1, 9]);
    refused(&mut lying, &Play::new(STRIKE).from(BEHIND), "cue_ball: ");
    let mut breaking = frame(Game::NineBall);
    let string = 0.635;
    for place in [[0.6, string], [0.6, 2.0], [f64::NAN, 0.3], [0.3, f64::INFINITY], [-1.0, 0.3]] {
        refused(&mut breaking, &Play::new(STRIKE).from(place), "cue_ball: ");
    }
    let mut snooker = frame(Game::Snooker);
    for place in [[0.3, 0.7], [0.889, 0.8], [0.889, 0.4]] {
        refused(&mut snooker, &Play::new(STRIKE).from(place), "cue_ball: ");
    }
    let brown = snooker.layout().place(18).expect("it is on its spot");
    refused(&mut snooker, &Play::new(STRIKE).from(brown), "cue_ball: it would touch");
}

#[test]
fn a_third_player_and_places_that_are_not_numbers_are_refused() {
    let mut frame = frame(Game::Practice);
    let places: Vec<_> = (0..16).map(|ball| frame.layout().place(ball)).collect();
    let mut refused =
        |places: &[_], seat| frame.resume_at(places, seat).expect_err("it is refused").to_string();
    assert!(refused(&places, 2).starts_with("player: "));
    let mut nowhere = places.clone();
    nowhere[3] = Some([0.5, f64::NAN]);
    assert!(refused(&nowhere, 0).starts_with("places: "));
}

#[test]
fn a_copy_does_not_change_its_original_and_plays_the_same_bits() {
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

#[test]
fn a_ball_that_the_frame_does_not_have_is_not_on_the_table() {
    let frame = frame(Game::NineBall);
    assert_eq!(frame.layout().place(255), None);
    assert!(frame.layout().is_down(255));
}

/// Seen: "[0.635, 1.6] is not behind the head string; put it there", without a number.
#[test]
fn the_refusal_of_a_place_of_the_cue_ball_has_the_limits_in_numbers() {
    let sentence = |game, place| {
        let refused = frame(game).play(&Play::new(STRIKE).from(place));
        refused.expect_err("it is refused").to_string()
    };
    let pool = "cue_ball: [0.6, 2.0] is not behind the head string; put it where y < 0.635 m";
    assert_eq!(sentence(Game::NineBall, [0.6, 2.0]), pool);
    let snooker = "cue_ball: [0.3, 0.7] is not in the D; put it where y ≤ 0.737 m, at most 0.292 m \
                   from [0.889, 0.737]";
    assert_eq!(sentence(Game::Snooker, [0.3, 0.7]), snooker);
}

#[test]
fn the_bounds_of_the_hand_are_those_of_its_region() {
    assert_eq!(frame(Game::NineBall).hand_bounds(), Some([[0.0, 0.0], [1.27, 0.635]]));
    let [[left, bottom], [right, top]] = frame(Game::Snooker).hand_bounds().expect("the D");
    assert!((right - left - 2.0 * (top - bottom)).abs() < 1e-12, "a half disk");
    assert_eq!(middle(Game::NineBall, [1, 9]).hand_bounds(), None);
    assert_eq!(choosing().hand_bounds(), None);
}

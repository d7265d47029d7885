//! Frames that continue with the balls of a shot.

use carom::Shot;
use carom_rules::{Choice, Frame, Game, Options, Request};

fn shot(balls: &str) -> Shot {
    let text =
        format!(r#"{{"format": "carom-shot/1", "table": "showood-7ft", "balls": [{balls}]}}"#);
    Shot::from_json(&text).expect("a shot")
}

const CUE: &str = r#"{"id": "cue", "position": [0.5, 1.0]}"#;

#[test]
fn the_balls_are_where_the_shot_has_them_and_the_others_are_down() {
    let shot = shot(&format!(
        r#"{{"id": "9", "position": [0.3, 1.5]}}, {CUE}, {{"id": "4", "position": [0.7, 0.4]}}"#
    ));
    let frame = Frame::of_shot(Game::NineBall, Options::default(), &shot, None).expect("a frame");
    let layout = frame.layout();
    for (ball, frame_ball) in (0..).zip(layout.balls()) {
        let lies = shot.ball_index(&frame_ball.id).map(|i| shot.balls()[i].state.position);
        assert_eq!(layout.place(ball), lies.map(|p| [p.x, p.y]), "{}", frame_ball.id);
    }
    assert_eq!(frame.base().table(), shot.table());
    assert_eq!(frame.base().physics(), shot.physics());
    assert!(
        matches!(frame.request(), Request::Shot(turn) if turn.player == 0 && turn.hand.is_none())
    );
}

#[test]
fn balls_that_the_game_cannot_have_are_refused() {
    for (more, place) in [
        (
            r#"{"id": "9", "position": [0.3, 1.5]}, {"id": "x", "position": [0.7, 0.4]}"#,
            "balls[2].id: ",
        ),
        (r#"{"id": "9", "position": [0.3, 1.5], "mass": 0.2}"#, "balls[1]: "),
        (r#"{"id": "9", "position": [0.3, 1.5], "velocity": [1, 0, 0]}"#, "balls[1]: "),
        (r#"{"id": "8", "position": [0.3, 1.5]}"#, "places: "),
    ] {
        let shot = shot(&format!("{CUE}, {more}"));
        let refused = Frame::of_shot(Game::NineBall, Options::default(), &shot, None);
        let error = refused.expect_err("it is refused").to_string();
        assert!(error.starts_with(place), "{error}");
    }
}

#[test]
fn a_frame_that_is_seen_elsewhere_has_the_same_request_and_other_places() {
    let frame = Frame::new(Game::EightBall, Options::default(), None, None, 1).expect("a rack");
    let mut places: Vec<_> = (0..).take(16).map(|ball| frame.layout().place(ball)).collect();
    places[3] = Some([0.2, 0.3]);
    let seen = frame.seen_at(&places).expect("the same balls");
    assert_eq!((seen.request(), seen.shots()), (frame.request(), 0));
    assert_eq!(seen.layout().place(3), Some([0.2, 0.3]));
    assert_eq!(seen.layout().place(4), frame.layout().place(4));
    assert_ne!(frame.layout().place(3), Some([0.2, 0.3]));
    let missing = [&places[..15], &[None]].concat();
    for wrong in [&places[..15], &missing] {
        let error = frame.seen_at(wrong).expect_err("another set of balls").to_string();
        assert!(error.starts_with("places: "), "{error}");
    }
}

#[test]
fn a_cap_of_events_stays_in_the_following_shots_and_racks() {
    let frame = Frame::new(Game::NineBall, Options::default(), None, None, 1).expect("a rack");
    let capped = frame.with_max_events(7).with_seed(2).expect("a rack");
    assert_eq!((capped.base().max_events(), capped.options().patience), (7, 100));
}

fn on_carom_table(yellow: [f64; 2]) -> Frame {
    let text = format!(
        r#"{{"format": "carom-shot/1", "table": "carom-10ft", "balls": [
            {{"id": "cue", "position": [0.7, 0.7]}}, {{"id": "yellow", "position": [{}, {}]}},
            {{"id": "red", "position": [0.7, 2.13]}}]}}"#,
        yellow[0], yellow[1]
    );
    let shot = Shot::from_json(&text).expect("a shot");
    Frame::of_shot(Game::ThreeCushion, Options::default(), &shot, None).expect("a frame")
}

/// Seen: a frame that began with the cue ball frozen to a ball asked for a shot. Right: the player may
/// have the balls spotted (UMB 27), as after a shot that leaves them so.
#[test]
fn a_frame_of_a_shot_with_the_cue_ball_frozen_asks_whether_to_spot() {
    let diameter = 2.0 * on_carom_table([0.3, 0.3]).base().physics().ball.radius;
    let mut frozen = on_carom_table([0.7 + diameter, 0.7]);
    let Request::Choice { player: 0, choices, .. } = *frozen.request() else {
        panic!("{:?}", frozen.request())
    };
    assert_eq!(*choices, [Choice::PlayOn, Choice::SpotFrozen]);
    let ruling = frozen.choose(Choice::SpotFrozen).expect("it is offered");
    assert_eq!(ruling.spotted.len(), 2);
    assert!(frozen.turn().is_some());
    for apart in [[0.3, 0.3], [0.7 + diameter + 2e-4, 0.7]] {
        assert!(on_carom_table(apart).turn().is_some(), "{apart:?}");
    }
}

#[test]
fn a_frame_resumed_at_places_with_the_cue_ball_frozen_asks_the_seat_that_shoots() {
    let mut frame = on_carom_table([0.3, 0.3]);
    let diameter = 2.0 * frame.base().physics().ball.radius;
    let places = [Some([0.7, 0.7]), Some([0.7, 1.0]), Some([0.7, 1.0 + diameter])];
    frame.resume_at(&places, 0).expect("three balls");
    assert!(frame.turn().is_some(), "the white touches nothing");
    frame.resume_at(&places, 1).expect("three balls");
    assert!(matches!(frame.request(), Request::Choice { player: 1, .. }), "the yellow is frozen");
}

/// Seen: the recommendations refused a position of three-cushion in which the yellow was struck, because the first
/// player has the white.
#[test]
fn the_player_whose_cue_ball_is_struck_shoots_unless_another_one_is_given() {
    let text = |ball: &str| {
        format!(
            r#"{{"format": "carom-shot/1", "table": "carom-10ft", "balls": [
                {{"id": "cue", "position": [0.7, 0.7]}}, {{"id": "yellow", "position": [0.3, 0.3]}},
                {{"id": "red", "position": [0.7, 2.13]}}],
                "strike": {{"ball": "{ball}", "speed": 2, "azimuth_deg": 90}}}}"#
        )
    };
    let shooter = |game, ball: &str, player| {
        let shot = Shot::from_json(&text(ball)).expect("a shot");
        let frame = Frame::of_shot(game, Options::default(), &shot, player).expect("a frame");
        let turn = frame.turn().expect("a shot");
        (turn.player, frame.layout().balls()[usize::from(turn.cue)].id.to_string())
    };
    let expected = |player, id: &str| (player, id.to_owned());
    for game in [Game::ThreeCushion, Game::StraightRail] {
        assert_eq!(shooter(game, "yellow", None), expected(1, "yellow"));
        assert_eq!(shooter(game, "cue", None), expected(0, "cue"));
        assert_eq!(shooter(game, "red", None), expected(0, "cue"));
        assert_eq!(shooter(game, "yellow", Some(0)), expected(0, "cue"));
        assert_eq!(shooter(game, "cue", Some(1)), expected(1, "yellow"));
    }
    // Where the players share the cue ball, the struck ball tells nothing.
    let pool = Shot::from_json(&format!(
        r#"{{"format": "carom-shot/1", "table": "showood-7ft", "balls": [{CUE},
            {{"id": "1", "position": [0.3, 1.5]}}, {{"id": "9", "position": [0.7, 0.4]}}],
            "strike": {{"ball": "1", "speed": 2, "azimuth_deg": 90}}}}"#
    ));
    let frame = Frame::of_shot(Game::NineBall, Options::default(), &pool.expect("a shot"), None);
    assert_eq!(frame.expect("a frame").player(), Some(0));
    let shot = Shot::from_json(&text("cue")).expect("a shot");
    let refused = Frame::of_shot(Game::ThreeCushion, Options::default(), &shot, Some(2));
    assert!(refused.expect_err("there are two players").to_string().starts_with("player: "));
}

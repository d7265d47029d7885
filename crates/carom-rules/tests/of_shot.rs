//! Frames that continue with the balls of a shot.

use carom::Shot;
use carom_rules::{Frame, Options, Request, Rules};

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
    let frame = Frame::of_shot(Rules::NineBall, Options::default(), &shot).expect("a frame");
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
        let refused = Frame::of_shot(Rules::NineBall, Options::default(), &shot);
        let error = refused.expect_err("it is refused").to_string();
        assert!(error.starts_with(place), "{error}");
    }
}

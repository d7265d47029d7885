//! What a referee looks at besides the outcome of a shot, in shots that are played.

use carom::resolve::cue_ball::Strike;
use carom_rules::{Call, Foul, Frame, Options, Play, Rules, Ruling};

/// Straight up the table.
const UP: f64 = core::f64::consts::FRAC_PI_2;

fn frame(rules: Rules) -> Frame {
    Frame::new(rules, Options::default(), None, None, 1).expect("the game's own table")
}

fn break_at(azimuth: f64, speed: f64) -> Ruling {
    let strike = Strike { speed, azimuth, elevation: 0.0, side: 0.0, height: 0.0 };
    let play = Play { strike, cue_ball: Some([0.3, 0.3]), call: Call::Safety };
    frame(Rules::StraightPool).play(&play).expect("it can be played").0
}

#[test]
fn a_cue_ball_that_crosses_the_head_string_is_seen_to() {
    let fouls = |ruling: Ruling| ruling.fouls.iter().collect::<Vec<_>>();
    assert_eq!(
        fouls(break_at(UP, 0.15)),
        [Foul::NoContact, Foul::BehindHeadString, Foul::SoftBreak],
        "it stops before the string"
    );
    assert_eq!(fouls(break_at(UP, 2.0)), [Foul::NoContact, Foul::SoftBreak], "it passes the rack");
}

/// With the blue in front of the cue ball and a red behind it: the fouls of a stroke up the table.
fn over_the_blue(elevation: f64) -> Ruling {
    let mut frame = frame(Rules::Snooker);
    let mut places: Vec<_> = (0..22).map(|ball| frame.layout().place(ball)).collect();
    (1..=15).for_each(|red| places[red] = None);
    places[0] = Some([0.6, 1.0]);
    places[19] = Some([0.6, 1.15]);
    places[1] = Some([0.6, 2.2]);
    frame.scatter(&places, 0).expect("a red is left");
    let strike = Strike { speed: 5.0, azimuth: UP, elevation, side: 0.0, height: 0.0 };
    frame.play(&Play::new(strike)).expect("it can be played").0
}

#[test]
fn to_jump_over_a_ball_that_is_not_on_is_a_foul_though_the_red_is_hit_first() {
    let jump = over_the_blue(0.9);
    assert!(jump.fouls.has(Foul::Jump) && !jump.fouls.has(Foul::WrongBallFirst), "{jump:?}");
    let level = over_the_blue(0.0);
    assert!(level.fouls.has(Foul::WrongBallFirst) && !level.fouls.has(Foul::Jump), "{level:?}");
}

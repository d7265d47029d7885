use carom::candidates::{Candidates, Variation};
use carom::error::ErrorKind;
use carom::format::{Node, PhysicsNumber};
use carom::math::Vec3;
use carom::resolve::cue_ball::Strike;
use carom::shot::StartState;
use carom::{Error, Physics, Shot};

use super::{example, three_balls};

fn number(key: &str) -> PhysicsNumber {
    PhysicsNumber::find(key).unwrap_or_else(|e| panic!("{e}"))
}

fn candidates(shot: &Shot, count: usize, variation: Variation) -> Candidates {
    Candidates::new(vec![shot.clone()], vec![0; count], variation).unwrap_or_else(|e| panic!("{e}"))
}

fn starts(shot: &Shot) -> Vec<StartState> {
    let start = |ball: &carom::shot::PlacedBall| StartState {
        position: ball.state.position,
        velocity: ball.state.velocity,
        angular_velocity: ball.state.angular_velocity,
    };
    shot.balls().iter().map(start).collect()
}

fn refusal(candidates: &Candidates, k: usize) -> (String, ErrorKind) {
    match candidates.shot(k) {
        Err(Error::Input(e)) => (e.place, e.kind),
        other => panic!("expected a refusal, got {other:?}"),
    }
}

#[test]
fn a_candidate_is_the_shot_that_a_file_with_its_numbers_gives() {
    let shot = three_balls();
    let variation = Variation {
        numbers: vec![number("cloth.sliding_friction"), number("cushion.restitution.a")],
        values: vec![0.2, 0.9, 0.17, 0.93],
        ..Variation::default()
    };
    let all = candidates(&shot, 2, variation);
    let file = Node::from_json(&shot.to_json()).unwrap_or_else(|e| panic!("{e}"));
    for (k, (sliding, a)) in [(0.2, 0.9), (0.17, 0.93)].into_iter().enumerate() {
        let mut physics = Physics::clone(shot.physics());
        physics.cloth.sliding_friction = sliding;
        physics.cushion.restitution.a = a;
        let mut node = file.clone();
        node.set("physics", physics.to_node());
        let expected = carom::ShotFile::from_node(node).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(*all.shot(k).expect("a shot"), *expected.shot());
    }
}

#[test]
fn an_unchanged_candidate_is_its_shot() {
    let shot = three_balls();
    let (_, strike) = shot.strike().expect("a strike");
    let variation = Variation {
        numbers: vec![number("cue.tip_friction")],
        values: vec![shot.physics().cue.tip_friction],
        states: Some(starts(&shot)),
        strikes: Some(vec![strike]),
        default_elevation: true,
    };
    assert_eq!(*candidates(&shot, 1, variation).shot(0).expect("a shot"), shot);
}

#[test]
fn a_default_elevation_is_that_of_the_candidate() {
    let shot = three_balls();
    assert!(shot.has_default_elevation());
    let (_, own) = shot.strike().expect("a strike");
    let strike = Strike { azimuth: own.azimuth + 1.5, elevation: 0.3, ..own };
    let of = |default_elevation: bool| {
        let strikes = Some(vec![strike]);
        let variation = Variation { strikes, default_elevation, ..Variation::default() };
        let all = candidates(&shot, 1, variation);
        let (_, strike) = all.shot(0).expect("a shot").strike().expect("a strike");
        strike.elevation
    };
    assert_eq!(of(false), 0.3);
    assert_eq!(of(true), shot.default_elevation(&strike));
}

#[test]
fn the_error_of_a_candidate_names_the_number() {
    let shot = three_balls();
    let values = vec![0.2, -0.1, f64::NAN, 1e12];
    let numbers = vec![number("cloth.sliding_friction")];
    let all = candidates(&shot, 4, Variation { numbers, values, ..Variation::default() });
    assert!(all.shot(0).is_ok());
    for k in 1..4 {
        let expected = ("physics.cloth.sliding_friction".into(), ErrorKind::OutOfRange);
        assert_eq!(refusal(&all, k), expected);
    }
}

#[test]
fn impossible_start_states_are_refused() {
    let shot = example("half_ball_cut");
    let own = starts(&shot);
    let changed = |change: fn(&mut [StartState])| {
        let mut states = own.clone();
        change(&mut states);
        let variation = Variation { states: Some(states), ..Variation::default() };
        refusal(&candidates(&shot, 1, variation), 0)
    };
    let at = |place: &str, kind| (place.to_owned(), kind);
    assert_eq!(
        changed(|s| s[1].position = s[0].position + Vec3::new(0.01, 0.0, 0.0)),
        at("balls[1].position", ErrorKind::Overlap)
    );
    assert_eq!(
        changed(|s| s[1].position.x = -0.5),
        at("balls[1].position", ErrorKind::OutsideTable)
    );
    assert_eq!(
        changed(|s| s[1].position.y = f64::NAN),
        at("balls[1].position", ErrorKind::OutOfRange)
    );
    assert_eq!(
        changed(|s| s[1].velocity.x = f64::NAN),
        at("balls[1].velocity", ErrorKind::OutOfRange)
    );
    assert_eq!(
        changed(|s| s[1].angular_velocity.z = f64::INFINITY),
        at("balls[1].angular_velocity", ErrorKind::OutOfRange)
    );
    assert_eq!(changed(|s| s[1].position.z = 0.01), at("balls[1].position", ErrorKind::InSlate));
    assert_eq!(changed(|s| s[0].velocity.x = 1.0), at("strike.ball", ErrorKind::Moving));
}

#[test]
fn parts_of_a_wrong_length_are_refused() {
    let shot = three_balls();
    let refused = |shots: Vec<Shot>, shot_of: Vec<u32>, variation: Variation| match Candidates::new(
        shots, shot_of, variation,
    ) {
        Err(Error::Input(e)) => (e.place, e.kind),
        other => panic!("expected a refusal, got {other:?}"),
    };
    let numbers = vec![number("gravity")];
    let one = || vec![shot.clone()];
    let values = Variation { numbers, values: vec![9.8; 3], ..Variation::default() };
    assert_eq!(refused(one(), vec![0; 2], values), ("values".into(), ErrorKind::WrongCount));
    let states = Variation { states: Some(starts(&shot)), ..Variation::default() };
    assert_eq!(
        refused(one(), vec![0; 2], states.clone()),
        ("states".into(), ErrorKind::WrongCount)
    );
    let both = vec![shot.clone(), example("half_ball_cut")];
    assert_eq!(refused(both, vec![0], states), ("states".into(), ErrorKind::WrongCount));
    let strikes = Variation { strikes: Some(Vec::new()), ..Variation::default() };
    assert_eq!(refused(one(), vec![0], strikes), ("strikes".into(), ErrorKind::WrongCount));
    let none = Variation::default();
    assert_eq!(refused(one(), vec![0, 1], none), ("shot_of[1]".into(), ErrorKind::OutOfRange));
}

#[test]
fn a_part_has_the_same_candidates() {
    let shot = three_balls();
    let (_, own) = shot.strike().expect("a strike");
    let variation = Variation {
        numbers: vec![number("gravity"), number("cloth.spin_deceleration")],
        values: (0..8).map(|k| 9.0 + f64::from(k)).collect(),
        states: Some(starts(&shot).repeat(4)),
        strikes: Some((0..4).map(|k| Strike { speed: 1.0 + f64::from(k), ..own }).collect()),
        default_elevation: false,
    };
    let all = candidates(&shot, 4, variation);
    let part = all.part(1, 3);
    assert_eq!(part.len(), 2);
    for k in 0..2 {
        assert_eq!(part.shot(k).expect("a shot"), all.shot(k + 1).expect("a shot"));
    }
}

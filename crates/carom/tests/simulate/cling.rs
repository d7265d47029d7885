//! Contacts that cling: in a shot file, and drawn under noise.

use carom::batch::{draw_strikes, draw_variant, simulate_batch, simulate_variants};
use carom::math::{Vec3, atan2, cos, radians, sin};
use carom::noise::Errors;
use carom::physics::{BallBall, SlipFriction};
use carom::resolve::{Body, ball_ball};
use carom::runner::Runner;
use carom::shot::Cling;
use carom::trace::TraceEventKind;
use carom::{BallState, Noise, Shot, ShotFile, Trace};

/// A stunned cue ball meets an object ball at 45°, 0.447 m/s; the object ball then meets a third.
const CUT: &str = r#"{"format": "carom-shot/1", "table": "wpa-9ft",
    "balls": [{"id": "cue", "position": [0.6, 0.6], "velocity": [0, 0.447, 0]},
        {"id": "1", "position": [0.640411, 0.640911]},
        {"id": "2", "position": [0.70, 0.7015]}]CLING}"#;

fn cut(cling: &str) -> ShotFile {
    let text = CUT.replace("CLING", cling);
    ShotFile::from_json(&text).unwrap_or_else(|e| panic!("{e}"))
}

fn played(shot: &Shot) -> Trace {
    shot.simulate().unwrap_or_else(|e| panic!("{e}"))
}

/// States of the balls before and after each collision of two balls.
fn contacts(trace: &Trace) -> Vec<([BallState; 2], [BallState; 2])> {
    let pairs =
        trace.events().filter(|e| e.kind == TraceEventKind::BallCollision && e.balls.len() == 2);
    pairs.map(|e| ([e.before[0], e.before[1]], [e.after[0], e.after[1]])).collect()
}

/// The direction (rad) of the second ball after a contact of two pool balls with the friction `mu`.
fn direction(before: &[BallState; 2], mu: f64) -> f64 {
    let physics = carom::Physics::pool();
    let law = BallBall { friction: SlipFriction::constant(mu), ..physics.ball_ball };
    let body = |state: &BallState| Body {
        velocity: state.velocity,
        angular_velocity: state.angular_velocity,
        mass: physics.ball.mass,
        radius: physics.ball.radius,
    };
    let (mut a, mut b) = (body(&before[0]), body(&before[1]));
    let line = before[1].position - before[0].position;
    ball_ball::resolve(&law, &physics.cloth, line * (1.0 / line.length()), &mut a, &mut b);
    atan2(b.velocity.y, b.velocity.x)
}

#[test]
fn the_listed_contact_has_the_friction_of_the_cling_and_no_other_has() {
    let plain = played(&cut(""));
    let clung = played(&cut(r#", "cling": {"contacts": [1], "friction": 0.3}"#));
    let (plain, clung) = (contacts(&plain), contacts(&clung));
    assert!(plain.len() >= 2, "{} contacts", plain.len());
    assert_eq!(plain[0], clung[0]);
    assert_eq!(plain[1].0, clung[1].0);
    assert_ne!(plain[1].1, clung[1].1);
    let found = clung[1].1[1].velocity;
    // The positions of a trace are rounded to the file's coordinates.
    let off = atan2(found.y, found.x) - direction(&clung[1].0, 0.3);
    assert!(off.abs() < 1e-12, "{off}");
}

#[test]
fn bb27_the_usual_friction_throws_as_a_chalked_contact() {
    // Alciatore, Throw follow-up I: 11.6° at a 45° cut, slow, with chalk at the contact.
    let physics = carom::Physics::pool();
    let law = BallBall {
        friction: SlipFriction::constant(Noise::default().cling_friction),
        ..physics.ball_ball
    };
    let ball = |velocity| Body {
        velocity,
        angular_velocity: Vec3::ZERO,
        mass: physics.ball.mass,
        radius: physics.ball.radius,
    };
    let (mut cue, mut object) = (ball(Vec3::new(0.0, 0.447, 0.0)), ball(Vec3::ZERO));
    let line = Vec3::new(sin(radians(45.0)), cos(radians(45.0)), 0.0);
    ball_ball::resolve(&law, &physics.cloth, line, &mut cue, &mut object);
    let throw = 45.0 - atan2(object.velocity.x, object.velocity.y) / radians(1.0);
    assert!((throw - 11.6).abs() < 0.05, "{throw}°");
}

#[test]
fn a_shot_file_with_cling_is_written_back_and_names_its_faults() {
    let clung = cut(r#", "cling": {"contacts": [3, 0, 255]}"#);
    assert!(clung.cling().contacts().eq([0, 3, 255]));
    assert_eq!(clung.cling().friction(), 0.22);
    assert_eq!(ShotFile::from_json(&clung.to_json()).expect("a file"), clung);
    let written = clung.shot().to_json();
    assert!(
        written.contains(r#""cling": {"contacts": [0, 3, 255], "friction": 0.22}"#),
        "{written}"
    );
    assert_eq!(Shot::from_json(&written).expect("a file"), *clung.shot());
    assert_eq!(cut(r#", "cling": {"contacts": []}"#), cut(""));
    for (cling, sentence) in [
        (r#"{"contacts": [0, 256]}"#, "cling.contacts[1]: 256 is out of range"),
        (r#"{"contacts": [4, 4]}"#, "cling.contacts[1]: contact 4 is listed twice"),
        (r#"{"contacts": [1], "friction": -1}"#, "cling.friction: "),
        (r#"{"friction": 0.2}"#, "cling.contacts: "),
        (r#"{"contacts": [1], "ball": "a"}"#, "cling.ball: unknown key"),
    ] {
        let text = CUT.replace("CLING", &format!(r#", "cling": {cling}"#));
        let error = ShotFile::from_json(&text).expect_err(cling).to_string();
        assert!(error.starts_with(sentence), "{error}");
    }
}

/// A struck pot with noise in which every third contact clings.
fn noisy() -> (ShotFile, Noise) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shots/half_ball_cut.json");
    let text = std::fs::read_to_string(path).expect("an example shot");
    let noise = Noise { cling_probability: 0.3, ..Noise::olympiad(1.0) };
    (ShotFile::from_json(&text).expect("a shot"), noise)
}

#[test]
fn every_variant_is_an_ordinary_shot_that_replays_to_the_bit() {
    const N: usize = 60;
    let (shot, noise) = noisy();
    let errors = Errors { noise: noise.clone(), seed: 5, ..Errors::default() };
    let strikes = draw_strikes(&shot, &noise, N, 5, 100).expect("strikes");
    let one = Runner::new(Some(1)).expect("a thread");
    let rows = simulate_variants(&shot, &strikes, &errors, 100, &one).expect("rows");
    let two = Runner::new(Some(2)).expect("two threads");
    assert_eq!(rows, simulate_variants(&shot, &strikes, &errors, 100, &two).expect("rows"));
    let read = |k| {
        let drawn = draw_variant(&shot, &noise, 5, 100 + k).expect("a strike that can be played");
        Shot::from_json(&drawn.to_json()).expect("its file")
    };
    let shots: Vec<Shot> = (0..N as u64).map(read).collect();
    assert_eq!(rows, simulate_batch(&shots, &one));
    let clean = Errors { noise: Noise::olympiad(1.0), ..errors };
    assert_ne!(rows, simulate_variants(&shot, &strikes, &clean, 100, &one).expect("rows"));
    assert!(shots.iter().any(|shot| shot.cling().contains(0)));
    assert!(shots.iter().any(|shot| !shot.cling().contains(0)));
}

#[test]
fn cling_moves_no_other_random_number() {
    let (shot, noise) = noisy();
    let with = draw_strikes(&shot, &noise, 100, 3, 0).expect("strikes");
    assert_eq!(with, draw_strikes(&shot, &Noise::olympiad(1.0), 100, 3, 0).expect("strikes"));
    assert_eq!(noise.scaled(2.0).cling_probability, 0.3);
}

#[test]
fn contacts_cling_as_often_as_the_noise_says_and_more_with_a_higher_probability() {
    let noise = |cling_probability| Noise { cling_probability, ..Noise::default() };
    assert_eq!(noise(0.0).draw_cling(1, 2), Cling::NONE);
    assert_eq!(noise(1.0).draw_cling(1, 2).contacts().count(), 256);
    let mut count = 0;
    for index in 0..400 {
        let [few, many] = [0.02, 0.05].map(|p| noise(p).draw_cling(9, index));
        assert!(few.contacts().all(|contact| many.contains(contact)));
        count += few.contacts().count();
    }
    // 102 400 contacts at 2 %: 2048 with a standard deviation of 45.
    assert!((1870..2230).contains(&count), "{count}");
}

#[test]
fn without_a_probability_the_cling_of_the_shot_itself_remains() {
    let (shot, noise) = noisy();
    let own = shot.with_cling(Cling::new([0], 0.4));
    let kept = draw_variant(&own, &Noise::olympiad(1.0), 1, 1).expect("a variant");
    assert_eq!(kept.cling(), own.cling());
    let drawn = draw_variant(&own, &noise, 1, 1).expect("a variant");
    assert_eq!(*drawn.cling(), noise.draw_cling(1, 1));
}

#[test]
fn a_probability_that_is_none_is_refused() {
    for (noise, place) in [
        (Noise { cling_probability: 1.1, ..Noise::default() }, "noise.cling_probability"),
        (Noise { cling_probability: f64::NAN, ..Noise::default() }, "noise.cling_probability"),
        (Noise { cling_friction: -0.1, ..Noise::default() }, "noise.cling_friction"),
    ] {
        let sentence = noise.check().expect_err(place).to_string();
        assert!(sentence.starts_with(place), "{sentence}");
    }
}

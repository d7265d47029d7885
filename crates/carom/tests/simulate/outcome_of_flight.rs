//! The outcome of whole shots in which balls fly.

use carom::outcome::Outcome;
use carom::table::{LIP_OVERHANG, PocketName};
use carom::trace::TraceEventKind;
use carom::{MotionState, Shot, Trace};

const RADIUS: f64 = 0.028575;

fn played(balls: &str, more: &str) -> Trace {
    let shot = Shot::from_json(&format!(
        r#"{{"format": "carom-shot/1", "table": "wpa-9ft", "balls": [{balls}]{more}}}"#
    ));
    shot.and_then(|shot| shot.simulate()).unwrap_or_else(|e| panic!("{e}"))
}

fn outcome(balls: &str, more: &str) -> Outcome {
    played(balls, more).outcome().clone()
}

#[test]
fn a_jump_shot_jumps_the_blocking_ball_and_none_beside_it() {
    let balls = r#"{"id": "cue", "position": [0.635, 0.6]}, {"id": "in the way", "position": [0.635, 0.8]},
        {"id": "beside", "position": [0.75, 0.8]}, {"id": "behind", "position": [0.635, 2.0]}"#;
    // A jump cue: light, with a phenolic tip (TP A.30).
    let strike = |elevation: f64| {
        format!(
            r#", "physics": {{"cue": {{"mass": 0.25, "tip_restitution": 0.87}}, "contact_times": {{"tip": 8e-4}}}},
            "strike": {{"ball": "cue", "speed": 5, "azimuth_deg": 90, "elevation_deg": {elevation}}}"#
        )
    };
    let jump = outcome(balls, &strike(50.0));
    assert_eq!(jump.jumped[0], (0, 1));
    assert!(!jump.jumped.contains(&(0, 2)), "{jump:?}");
    assert_eq!(jump.first_contact, Some(3));
    let level = outcome(balls, &strike(0.0));
    assert!(level.jumped.is_empty(), "{level:?}");
    assert_eq!(level.first_contact, Some(1));
}

#[test]
fn a_ball_that_flies_over_the_rails_is_off_the_table() {
    let trace = played(
        r#"{"id": "a", "position": [0.3, 0.8, 0.1], "velocity": [-3, 0, 1.5]}, {"id": "b", "position": [0.6, 0.8]}"#,
        "",
    );
    assert_eq!(trace.outcome().off_table, [0]);
    assert!(trace.outcome().driven_to_rail.is_empty());
    assert_eq!(trace.last()[0].motion, MotionState::OffTable);
    assert_eq!(trace.last()[1].motion, MotionState::Stationary);
}

#[test]
fn a_ball_laid_on_a_rails_top_is_off_the_table_at_once() {
    let top = 0.635 * 2.0 * RADIUS + RADIUS;
    let trace = played(&format!(r#"{{"id": "a", "position": [-0.05, 0.8, {top:?}]}}"#), "");
    assert_eq!(trace.outcome().off_table, [0]);
    assert!(trace.duration() < 1e-6, "{}", trace.duration());
}

#[test]
fn a_ball_driven_down_on_the_bed_bounces_at_once() {
    let trace = played(r#"{"id": "a", "position": [0.6, 0.8], "velocity": [0, 0, -1]}"#, "");
    let first = trace.events().next().expect("an event");
    assert_eq!((first.time, first.kind), (0.0, TraceEventKind::SlateCollision));
    assert!(first.after[0].velocity.z > 0.3, "{first:?}");
    assert_eq!(trace.last()[0].motion, MotionState::Stationary);
}

#[test]
fn a_ball_dropped_into_a_hole_is_pocketed_and_one_dropped_on_the_cloth_is_not() {
    let table = carom::Table::preset("wpa-9ft").expect("a preset");
    let hole = table.pockets[0].center + table.center();
    let at = |x: f64, y: f64| {
        outcome(&format!(r#"{{"id": "a", "position": [{x:?}, {y:?}, 0.04]}}"#), "").pocketed
    };
    assert_eq!(at(hole.x, hole.y), [(0, PocketName::BottomLeft)]);
    assert_eq!(at(0.5, 0.5), []);
}

#[test]
fn a_ball_that_reaches_the_lip_very_slowly_hangs_there_and_a_faster_one_falls() {
    let table = carom::Table::preset("wpa-9ft").expect("a preset");
    let physics = carom::Physics::pool();
    let (pocket, distance) = (&table.pockets[0], 0.05);
    let start = pocket.center + table.center() - pocket.axis * (pocket.radius + distance);
    let friction = physics.cloth.rolling_friction.at(0.0);
    let braking = friction * physics.gravity;
    let limit = friction * (physics.gravity * RADIUS).sqrt();
    // The speed at the lip.
    let with = |left: f64| {
        let v = pocket.axis * (left * left + 2.0 * braking * distance).sqrt();
        let spin = [-v.y / RADIUS, v.x / RADIUS, 0.0];
        let ball = format!(
            r#"{{"id": "8", "position": [{:?}, {:?}], "velocity": [{:?}, {:?}, 0], "angular_velocity": {spin:?}}}"#,
            start.x, start.y, v.x, v.y
        );
        outcome(&ball, "")
    };
    let hung = with(0.5 * limit);
    assert_eq!(
        (&hung.hanging[..], &hung.pocketed[..]),
        (&[(0, PocketName::BottomLeft)][..], &[][..])
    );
    let fallen = with(5.0 * limit);
    assert_eq!(
        (&fallen.hanging[..], &fallen.pocketed[..]),
        (&[][..], &[(0, PocketName::BottomLeft)][..])
    );
}

#[test]
fn a_ball_left_hanging_can_be_in_the_next_shot_and_falls_when_it_is_touched() {
    let table = carom::Table::preset("wpa-9ft").expect("a preset");
    let pocket = &table.pockets[0];
    let hole = pocket.center + table.center();
    let at = |over: f64| hole - pocket.axis * (pocket.radius - over * RADIUS);
    let file = |over: f64, strike: &str| {
        let (ball, cue) = (at(over), hole - pocket.axis * 0.4);
        format!(
            r#"{{"format": "carom-shot/1", "table": "wpa-9ft"{strike}, "balls": [
                {{"id": "cue", "position": [{:?}, {:?}]}}, {{"id": "8", "position": [{:?}, {:?}]}}]}}"#,
            cue.x, cue.y, ball.x, ball.y
        )
    };
    let play = |over: f64, strike: &str| {
        let shot = Shot::from_json(&file(over, strike)).unwrap_or_else(|e| panic!("{e}"));
        shot.simulate().unwrap_or_else(|e| panic!("{e}"))
    };
    let alone = play(0.99 * LIP_OVERHANG, "");
    assert_eq!(alone.outcome().hanging, [(1, PocketName::BottomLeft)]);
    assert_eq!(alone.last()[1].position.xy(), at(0.99 * LIP_OVERHANG));
    for azimuth in [225, 224, 226] {
        let strike =
            format!(r#", "strike": {{"ball": "cue", "speed": 0.5, "azimuth_deg": {azimuth}}}"#);
        let hit = play(0.99 * LIP_OVERHANG, &strike);
        assert!(hit.outcome().pocketed.contains(&(1, PocketName::BottomLeft)), "{azimuth}");
    }
    let refusal = Shot::from_json(&file(1.01 * LIP_OVERHANG, "")).expect_err("it would fall");
    assert!(refusal.to_string().contains("stands over the bottom-left pocket"), "{refusal}");
}

#[test]
fn a_ball_dropped_on_another_hits_it_even_if_they_do_not_approach_in_plan() {
    let top = 3.0 * RADIUS;
    for (x, z, speed) in
        [(0.61, 0.3, 0.0), (0.61, 0.3, 0.01), (0.6001, 0.3, 0.0), (0.601, top, 0.0)]
    {
        let balls = format!(
            r#"{{"id": "under", "position": [0.6, 0.8]}},
               {{"id": "over", "position": [{x}, 0.8, {z:?}], "velocity": [{speed}, 0, 0]}}"#
        );
        let trace = played(&balls, "");
        let first = trace.events().next().expect("an event");
        assert_eq!(first.kind, TraceEventKind::BallCollision, "{x} {z} {speed}: {first:?}");
        assert!(trace.outcome().jumped.is_empty());
    }
}

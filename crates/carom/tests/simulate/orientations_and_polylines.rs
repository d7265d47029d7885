//! Orientations and polylines, which pictures are drawn from.

use std::fs;
use std::path::Path;

use carom::math::{Vec3, cos, sin, sqrt};
use carom::{Shot, Trace};

const RADIUS: f64 = 0.028_575;

fn trace(name: &str) -> Trace {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shots");
    let file = fs::read_to_string(folder.join(format!("{name}.json"))).expect(name);
    Shot::from_json(&file).and_then(|shot| shot.simulate()).expect(name)
}

/// One ball on unbounded cloth with these initial velocities.
fn lone(velocity: [f64; 3], spin: [f64; 3], cloth: &str) -> Trace {
    let file = format!(
        r#"{{"format": "carom-shot/1", "table": {{"cloth": "unbounded"}},
            "physics": {{"cloth": {{{cloth}}}, "ball": {{"radius": {RADIUS}}}}},
            "balls": [{{"id": "cue", "position": [0, 0],
                        "velocity": {velocity:?}, "angular_velocity": {spin:?}}}]}}"#
    );
    Shot::from_json(&file).and_then(|shot| shot.simulate()).expect("a lone ball")
}

/// The largest difference of the components of `q` and `p`. Both signs are the same rotation.
fn apart(q: [f64; 4], p: [f64; 4]) -> f64 {
    let worst = |sign: f64| q.iter().zip(p).map(|(a, b)| (a - sign * b).abs()).fold(0.0, f64::max);
    f64::min(worst(1.0), worst(-1.0))
}

/// The rotation `q` after `p`, both x, y, z, w.
fn product(q: [f64; 4], p: [f64; 4]) -> [f64; 4] {
    let (u, v) = (Vec3::new(q[0], q[1], q[2]), Vec3::new(p[0], p[1], p[2]));
    let vector = v * q[3] + u * p[3] + u.cross(v);
    [vector.x, vector.y, vector.z, q[3] * p[3] - u.dot(v)]
}

/// The rotation by the vector `by`, rad.
fn turn(by: Vec3) -> [f64; 4] {
    let angle = by.length();
    let along = if angle > 0.0 { sin(angle / 2.0) / angle } else { 0.0 };
    [by.x * along, by.y * along, by.z * along, cos(angle / 2.0)]
}

#[test]
fn a_rolling_ball_rotates_by_its_distance_over_its_radius_about_the_axis_to_its_left() {
    const ROUNDING: f64 = 1e-12;
    let velocity = [1.2, 0.9, 0.0];
    let spin = [-0.9 / RADIUS, 1.2 / RADIUS, 0.0];
    for cloth in ["", r#""rolling_friction": 0"#] {
        let trace = lone(velocity, spin, cloth);
        let orientations = trace.orientations();
        for k in 0..100 {
            let time = 0.05 * f64::from(k);
            let way = trace.at(time).expect("a time ≥ 0")[0].position.xy().length();
            let axis = Vec3::new(-0.6, 0.8, 0.0);
            let error = apart(orientations.at(0, time), turn(axis * (way / RADIUS)));
            assert!(error < ROUNDING, "{error:e} after {way} m");
        }
    }
}

#[test]
fn after_one_circumference_a_rolling_ball_has_its_first_orientation() {
    let trace = lone([0.0, 1.0, 0.0], [-1.0 / RADIUS, 0.0, 0.0], r#""rolling_friction": 0"#);
    let orientations = trace.orientations();
    let circumference = std::f64::consts::TAU * RADIUS;
    assert!(apart(orientations.at(0, circumference), [0.0, 0.0, 0.0, 1.0]) < 1e-14);
    // After half of it the ball is upside down: rotated forwards, about −x.
    assert!(apart(orientations.at(0, circumference / 2.0), [-1.0, 0.0, 0.0, 0.0]) < 1e-14);
}

#[test]
fn sidespin_rotates_a_resting_ball_by_half_its_square_over_its_deceleration() {
    let trace = lone([0.0; 3], [0.0, 0.0, 20.0], r#""spin_deceleration": 10"#);
    let turned = turn(Vec3::new(0.0, 0.0, 20.0 * 20.0 / (2.0 * 10.0)));
    assert!(apart(trace.orientations().at(0, trace.duration()), turned) < 1e-12);
    assert!(apart(trace.orientations().at(0, 1e3), turned) < 1e-12);
}

/// Integrates the spin of ball `ball` of the trace from event to event with the midpoint rule
/// (second order), in steps of at most `step` s.
fn integrated(trace: &Trace, ball: usize, step: f64) -> [f64; 4] {
    let mut times: Vec<f64> = trace.events().map(|e| e.time).collect();
    times.insert(0, 0.0);
    let mut q = [0.0, 0.0, 0.0, 1.0];
    for pair in times.windows(2) {
        let steps = ((pair[1] - pair[0]) / step).ceil();
        let h = (pair[1] - pair[0]) / steps;
        let mut k = 0.0;
        while k < steps {
            let middle = trace.at(pair[0] + (k + 0.5) * h).expect("a time ≥ 0")[ball];
            q = product(turn(middle.angular_velocity * h), q);
            k += 1.0;
        }
    }
    q
}

#[test]
fn orientations_agree_with_a_fine_integration_of_the_spin() {
    // Error of the integration: h²/12·|ω × dω/dt| per second for a few seconds, where the product
    // is about 10⁴ rad²/s³ at most.
    const STEP: f64 = 1e-4;
    const STEP_ERROR: f64 = 5e-5;
    for name in ["masse", "kick_shot", "jump_shot", "three_cushion", "spit_out"] {
        let trace = trace(name);
        let orientations = trace.orientations();
        for ball in 0..trace.shot().balls().len().min(3) {
            let error =
                apart(orientations.at(ball, trace.duration()), integrated(&trace, ball, STEP));
            assert!(error < STEP_ERROR, "{name}, ball {ball}: {error:e}");
        }
    }
}

#[test]
fn orientations_are_unit_quaternions_and_continuous() {
    let trace = trace("nine_ball_break");
    let orientations = trace.orientations();
    const INSTANT: f64 = 1e-7;
    for ball in 0..trace.shot().balls().len() {
        for k in 0..2000 {
            let time = trace.duration() * f64::from(k) / 2000.0;
            let now = orientations.at(ball, time);
            let norm = sqrt(now.iter().map(|x| x * x).sum());
            assert!((norm - 1.0).abs() < 1e-15, "ball {ball} at {time} s: {norm}");
            let spin = trace.at(time).expect("a time ≥ 0")[ball].angular_velocity.length();
            let moved = apart(now, orientations.at(ball, time + INSTANT));
            // An event in between may make the ball spin faster, by 500 rad/s at most.
            assert!(moved <= (spin + 500.0) * INSTANT, "ball {ball} at {time} s: {moved:e}");
        }
    }
}

/// Distance of `point` from the segment from `a` to `b`.
fn from_segment(point: Vec3, a: Vec3, b: Vec3) -> f64 {
    let along = b - a;
    let squared = along.length_squared();
    let t = if squared > 0.0 { (point - a).dot(along) / squared } else { 0.0 };
    (point - (a + along * t.clamp(0.0, 1.0))).length()
}

#[test]
fn the_chords_of_a_polyline_stay_within_the_tolerance_of_the_exact_path() {
    const ROUNDING: f64 = 1e-12;
    for name in ["draw_shot", "masse", "jump_shot", "rattle", "off_the_table", "three_cushion"] {
        let trace = trace(name);
        for tolerance in [1e-2, 1e-4] {
            for ball in 0..trace.shot().balls().len() {
                let way = trace.polyline(ball, tolerance);
                let mut chord = 0;
                for k in 0..=4000 {
                    let time = trace.duration() * f64::from(k) / 4000.0;
                    while chord + 2 < way.len() && way[chord + 1].time < time {
                        chord += 1;
                    }
                    let [a, b] = [chord, (chord + 1).min(way.len() - 1)].map(|i| way[i].position);
                    let position = trace.at(time).expect("a time ≥ 0")[ball].position;
                    let distance = from_segment(position, a, b);
                    assert!(
                        distance <= tolerance + ROUNDING,
                        "{name}, ball {ball}, {time} s: {distance:e} m from the chord"
                    );
                }
            }
        }
    }
}

#[test]
fn a_polyline_has_a_point_at_every_event_of_its_ball_and_all_its_points_lie_on_the_path() {
    const ROUNDING: f64 = 1e-12;
    for name in ["nine_ball_break", "jump_shot", "hanging_ball"] {
        let trace = trace(name);
        for ball in 0..trace.shot().balls().len() {
            let way = trace.polyline(ball, 1e-3);
            assert!(way.windows(2).all(|pair| pair[0].time <= pair[1].time));
            // A ball that falls into a pocket has two points at that time: at the lip or in the
            // hole, and at rest below it.
            let last_at_its_time = |i: usize| way.get(i + 1).is_none_or(|p| p.time > way[i].time);
            for point in (0..way.len()).filter(|i| last_at_its_time(*i)).map(|i| way[i]) {
                let exact = trace.at(point.time).expect("a time ≥ 0")[ball].position;
                let error = (point.position - exact).length();
                assert!(error < ROUNDING, "{name}, ball {ball}, {} s: {error:e} m", point.time);
            }
            for event in trace.events().filter(|e| e.balls.contains(&(ball as u16))) {
                assert!(way.iter().any(|p| p.time == event.time), "{name}: {} s", event.time);
            }
        }
    }
}

#[test]
fn straight_paths_need_two_points_and_curves_few() {
    let rolling = lone([0.0, 1.0, 0.0], [-1.0 / RADIUS, 0.0, 0.0], "");
    assert_eq!(rolling.polyline(0, 1e-4).len(), 2);
    // A ball with backspin moves to a turning point and back along the same line.
    let back = lone([0.0, 1.0, 0.0], [100.0, 0.0, 0.0], "");
    let way = back.polyline(0, 1e-4);
    let furthest = way.iter().map(|p| p.position.y).fold(0.0, f64::max);
    let friction = 0.2 * 9.806_65;
    assert!((furthest - 1.0 / (2.0 * friction)).abs() < 1e-12, "{furthest}");
    assert!(way.len() <= 4, "{way:?}");
    // The velocity and the friction of a rolling ball are parallel up to rounding, in any
    // direction.
    for k in 0..64 {
        let (x, y) = (cos(0.1 * f64::from(k)), sin(0.1 * f64::from(k)));
        let rolling = lone([x, y, 0.0], [-y / RADIUS, x / RADIUS, 0.0], "");
        let way = rolling.polyline(0, 1e-4);
        assert!(way.len() <= 4, "at {k} tenths of a radian: {} points", way.len());
    }
    let masse: usize = (0..2).map(|ball| trace("masse").polyline(ball, 5e-4).len()).sum();
    assert!((20..200).contains(&masse), "{masse} points");
}

#[test]
fn the_polyline_of_a_ball_that_never_rests_ends_with_the_shot() {
    let file = r#"{"format": "carom-shot/1", "table": {"cloth": "unbounded"}, "physics": {"cloth": {"rolling_friction": 0}},
        "balls": [{"id": "a", "position": [0, 0], "velocity": [0, 1, 0], "angular_velocity": [-30, 0, 0]},
                  {"id": "b", "position": [0, 1]}]}"#;
    let trace = Shot::from_json(file).and_then(|s| s.simulate()).expect("a shot");
    assert!(!trace.outcome().never_resting.is_empty());
    for ball in 0..2 {
        let way = trace.polyline(ball, 1e-3);
        assert_eq!(way.last().map(|p| p.time), Some(trace.duration()), "{way:?}");
    }
    let [x, ..] = trace.orientations().at(1, 1e6);
    assert!(x.is_finite());
}

/// Seen: the orientation of a ball that rests was not a number after 2e117 s.
/// Cause: the cube of the time overflowed and was multiplied by 0.
#[test]
fn every_state_is_finite_at_any_time() {
    let file = r#"{"format": "carom-shot/1", "table": {"cloth": "unbounded"}, "physics": {"cloth": {"rolling_friction": 0}},
        "balls": [{"id": "a", "position": [0, 0]},
                  {"id": "b", "position": [0, 1], "velocity": [0, 1, 0], "angular_velocity": [-30, 0, 9]}]}"#;
    let trace = Shot::from_json(file).and_then(|s| s.simulate()).expect("a shot");
    let orientations = trace.orientations();
    for time in [1e9, 1e100, 1e117, 1e160, 1e300, f64::MAX] {
        let states = trace.at(time).expect("a time");
        for (ball, state) in states.iter().enumerate() {
            assert!(state.position.is_finite(), "{ball} at {time} s: {state:?}");
            assert!(
                orientations.at(ball, time).iter().all(|x| x.is_finite()),
                "{ball} at {time} s"
            );
        }
    }
}

/// Seen: memory ran out. Cause: a step for every tenth of a radian, for as long as the ball slides.
#[test]
fn the_orientations_of_a_ball_that_slides_for_centuries_take_bounded_memory() {
    let shot = Shot::from_json(
        r#"{"format": "carom-shot/1", "table": {"cloth": "unbounded"},
            "physics": {"cloth": {"sliding_friction": 1e-9}},
            "balls": [{"id": "1", "position": [0, 0], "velocity": [0, 1, 0],
                       "angular_velocity": [5000, 0, 5000]}]}"#,
    )
    .unwrap_or_else(|e| panic!("{e}"));
    let trace = shot.simulate().unwrap_or_else(|e| panic!("{e}"));
    assert!(trace.duration() > 1e9, "{} s", trace.duration());
    let [x, y, z, w] = trace.orientations().at(0, 0.5 * trace.duration());
    assert!((x * x + y * y + z * z + w * w - 1.0).abs() < 1e-12);
}

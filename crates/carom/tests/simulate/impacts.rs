//! Impacts have a strength and a place, for instance for sounds. Both follow from the states before
//! and after.

use carom::format::Node;
use carom::math::Vec3;
use carom::table::{Part, Rail};
use carom::trace::{TraceEvent, TraceEventKind};
use carom::{Shot, Trace};

/// Largest error of a place, m, and of an impulse, N s: rounding, and the gaps of touching balls.
const SMALL: f64 = 1e-9;

fn examples() -> Vec<(String, Trace)> {
    let folder = format!("{}/../../shots", env!("CARGO_MANIFEST_DIR"));
    let files = std::fs::read_dir(folder).expect("shots/").map(|file| file.expect("a file").path());
    let mut all: Vec<_> = files
        .map(|path| {
            let text = std::fs::read_to_string(&path).expect("a shot file");
            let trace = Shot::from_json(&text).and_then(|shot| shot.simulate());
            (path.display().to_string(), trace.unwrap_or_else(|e| panic!("{e}")))
        })
        .collect();
    all.sort_by(|a, b| a.0.cmp(&b.0));
    all
}

fn simulated(text: &str) -> Trace {
    Shot::from_json(text).and_then(|shot| shot.simulate()).unwrap_or_else(|e| panic!("{e}"))
}

fn radius(trace: &Trace, ball: u16) -> f64 {
    trace.shot().balls()[usize::from(ball)].ball.radius
}

/// The distances of the event's points from the surface of its first ball, m.
fn gaps<'a>(trace: &'a Trace, event: &'a TraceEvent<'_>) -> impl Iterator<Item = f64> + 'a {
    let center = event.before[0].position;
    let radius = radius(trace, event.balls[0]);
    trace.contact_points(event).into_iter().map(move |point| (point - center).length() - radius)
}

#[test]
fn a_point_of_contact_lies_on_the_ball_and_on_what_it_touches() {
    let mut parts = std::collections::BTreeMap::new();
    for (name, trace) in examples() {
        let table = trace.shot().table();
        for event in trace.events() {
            let what = format!("{name} at {} s: {:?}", event.time, event.kind);
            let points = trace.contact_points(&event);
            match event.kind {
                TraceEventKind::RailCollision { part, .. } => {
                    *parts.entry(part.name()).or_insert(0) += 1;
                    assert_eq!(points.len(), 1, "{what}");
                    assert!(gaps(&trace, &event).all(|gap| gap.abs() < SMALL), "{what}");
                    let high = points[0].z > table.cushion_height - SMALL;
                    assert!(high || part == Part::Liner, "{what}: {points:?}");
                }
                TraceEventKind::SlateCollision => {
                    assert_eq!(points.len(), 1, "{what}");
                    assert!(gaps(&trace, &event).all(|gap| gap.abs() < SMALL), "{what}");
                    assert!(points[0].z < SMALL, "{what}: {points:?}");
                }
                TraceEventKind::BallCollision if event.balls.len() == 2 => {
                    assert_eq!(points.len(), 1, "{what}");
                    assert!(gaps(&trace, &event).all(|gap| gap.abs() < SMALL), "{what}");
                    let other = (points[0] - event.before[1].position).length();
                    assert!((other - radius(&trace, event.balls[1])).abs() < SMALL, "{what}");
                }
                TraceEventKind::CueStrike { .. } => {
                    assert!(gaps(&trace, &event).next().expect("the tip").abs() < SMALL, "{what}");
                }
                TraceEventKind::BallCollision => {}
                _ => assert!(points.is_empty() && trace.impulses(&event).is_empty(), "{what}"),
            }
        }
    }
    for part in ["nose", "facing", "point", "top", "liner"] {
        assert!(parts.contains_key(part), "no example meets a {part}");
    }
}

#[test]
fn a_ball_that_is_hit_head_on_takes_the_whole_momentum_of_the_other() {
    let trace = simulated(
        r#"{"format": "carom-shot/1", "table": {"cloth": "unbounded"}, "physics": "ideal",
            "balls": [{"id": "a", "position": [0, 0], "velocity": [2, 0, 0], "mass": 0.2,
                       "angular_velocity": [0, 70, 0]},
                      {"id": "b", "position": [0.07, 0], "mass": 0.2}]}"#,
    );
    let event = trace.events().find(|event| event.balls.len() == 2).expect("they meet");
    let (before, after) = (event.before[0].velocity, event.after[0].velocity);
    let impulses = trace.impulses(&event);
    assert_eq!(impulses[0], (after - before) * 0.2);
    assert!((impulses[1].x - 0.2 * before.x).abs() < SMALL, "{impulses:?}");
    let [point] = trace.contact_points(&event)[..] else { panic!("one point") };
    let middle = (event.before[0].position + event.before[1].position) * 0.5;
    assert!((point - middle).length() < SMALL, "{point:?}");
}

#[test]
fn the_balls_of_a_collision_give_each_other_opposite_impulses() {
    let mut several = 0;
    for (name, trace) in examples() {
        for event in trace.events().filter(|event| event.kind == TraceEventKind::BallCollision) {
            let sum = trace.impulses(&event).into_iter().fold(Vec3::ZERO, |sum, one| sum + one);
            assert!(sum.xy().length() < SMALL, "{name} at {} s: {sum:?}", event.time);
            several += usize::from(event.balls.len() > 2);
        }
    }
    assert!(several > 0);
}

#[test]
fn every_ball_of_a_many_ball_contact_touches_another_at_a_point() {
    let (name, trace) =
        examples().into_iter().find(|(name, _)| name.contains("nine_ball_break")).expect("it");
    let event = trace.events().max_by_key(|event| event.balls.len()).expect("events");
    assert!(event.balls.len() > 5, "{name}");
    let points = trace.contact_points(&event);
    assert!(points.len() >= event.balls.len() - 1, "{points:?}");
    for (k, &ball) in event.balls.iter().enumerate() {
        let gap = |point: &Vec3| {
            ((*point - event.before[k].position).length() - radius(&trace, ball)).abs()
        };
        assert!(points.iter().any(|point| gap(point) < 1e-3), "ball {ball}");
    }
}

#[test]
fn the_tip_meets_the_ball_at_the_offset_of_the_strike() {
    let strike = |more: &str| {
        let trace = simulated(&format!(
            r#"{{"format": "carom-shot/1", "table": {{"cloth": "unbounded"}},
                "balls": [{{"id": "cue", "position": [0, 0], "radius": 0.03}}],
                "strike": {{"ball": "cue", "speed": 1, "azimuth_deg": 0{more}}}}}"#
        ));
        let event = trace.events().next().expect("the strike");
        let [point] = trace.contact_points(&event)[..] else { panic!("one point") };
        (point, trace.impulses(&event)[0])
    };
    let (point, impulse) = strike("");
    assert!((point - Vec3::new(-0.03, 0.0, 0.03)).length() < SMALL, "{point:?}");
    assert!(impulse.x > 0.0 && impulse.y.abs() < SMALL, "{impulse:?}");
    // Right of the cue is −y.
    let (point, _) = strike(r#", "side": 0.3, "height": 0.4"#);
    let depth = 0.03 * (1.0f64 - 0.25).sqrt();
    assert!((point - Vec3::new(-depth, -0.009, 0.042)).length() < SMALL, "{point:?}");
    let (point, _) = strike(r#", "elevation_deg": 60"#);
    let lifted = 0.03 + 0.03 * 0.75f64.sqrt();
    assert!((point - Vec3::new(-0.015, 0.0, lifted)).length() < SMALL, "{point:?}");
}

#[test]
fn a_ball_meets_the_nose_at_its_height_on_the_nose_line() {
    let trace = simulated(
        r#"{"format": "carom-shot/1", "table": "wpa-9ft", "balls":
            [{"id": "a", "position": [0.4, 0.8], "velocity": [-2, 0.5, 0]}]}"#,
    );
    let event = trace
        .events()
        .find(|event| {
            matches!(event.kind, TraceEventKind::RailCollision { rail: Rail::LeftLower, .. })
        })
        .expect("it comes to the left rail");
    let [point] = trace.contact_points(&event)[..] else { panic!("one point") };
    assert!(point.x.abs() < SMALL, "{point:?}");
    assert!((point.y - event.before[0].position.y).abs() < SMALL, "{point:?}");
    assert!((point.z - trace.shot().table().cushion_height).abs() < SMALL, "{point:?}");
    let mass = trace.shot().balls()[0].ball.mass;
    let change = event.after[0].velocity - event.before[0].velocity;
    assert_eq!(trace.impulses(&event), [change * mass]);
}

#[test]
fn a_trace_lists_impulses_and_points_of_its_impacts_and_reads_without_them() {
    for (name, trace) in examples() {
        let node = trace.to_node();
        let Some(Node::List(events)) = node.get("events") else { panic!("{name}: no events") };
        for (event, node) in trace.events().zip(events) {
            assert_eq!(node.get("impulses").is_some(), event.is_impact(), "{name}");
            assert_eq!(node.get("points").is_some(), event.is_impact(), "{name}");
        }
        let without = events.iter().cloned().map(|mut event| {
            event.remove("impulses");
            event.remove("points");
            event
        });
        let mut older = node.clone();
        older.set("events", Node::list(without));
        assert_eq!(Trace::from_node(&older), Ok(trace), "{name}");
    }
}

//! Traces are written and read without losing a bit, and give the exact state at any time.

use carom::event::NullRecorder;
use carom::format::Node;
use carom::math::Vec3;
use carom::trace::TraceEventKind;
use carom::{BallState, Error, MotionState, Shot, Simulator, Trace};

fn played(name: &str) -> Trace {
    let path = format!("{}/../../shots/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
    let shot = Shot::from_json(&text).unwrap_or_else(|e| panic!("{e}"));
    shot.simulate().unwrap_or_else(|e| panic!("{e}"))
}

const NAMES: [&str; 4] = ["nine_ball_break", "masse", "three_cushion", "follow_shot"];

fn bits(s: &BallState) -> ([u64; 9], MotionState) {
    let mut words = [0; 9];
    let vectors = [s.position, s.velocity, s.angular_velocity];
    for (word, x) in words.iter_mut().zip(vectors.iter().flat_map(|v| v.to_array())) {
        *word = x.to_bits();
    }
    (words, s.motion)
}

#[test]
fn a_trace_keeps_every_bit_through_json() {
    for name in NAMES {
        let trace = played(name);
        let again = Trace::from_json(&trace.to_json()).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!(trace, again, "{name}");
        assert_eq!(trace.first_difference(&again), None, "{name}");
        assert_eq!(trace.hash(), again.hash(), "{name}");
        assert_eq!(trace.to_json(), again.to_json(), "{name}");
        for (a, b) in trace.events().zip(again.events()) {
            assert!(a.before.iter().map(bits).eq(b.before.iter().map(bits)), "{name}");
            assert!(a.after.iter().map(bits).eq(b.after.iter().map(bits)), "{name}");
        }
    }
}

#[test]
fn a_second_simulation_has_the_same_hash_and_another_shot_a_different_one() {
    let trace = played("masse");
    let again = trace.shot().simulate().unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(trace.hash(), again.hash());
    let (_, mut strike) = trace.shot().strike().expect("a strike");
    strike.speed = strike.speed.next_up();
    let other = trace.shot().with_strike(&strike).and_then(|s| s.simulate());
    let other = other.unwrap_or_else(|e| panic!("{e}"));
    assert_ne!(trace.hash(), other.hash());
    let sentence = trace.first_difference(&other).expect("they differ");
    assert!(sentence.starts_with("events[0].after[0].velocity: "), "{sentence}");
}

#[test]
fn two_flipped_signs_change_the_hash() {
    let trace = played("follow_shot");
    let mut node = trace.to_node();
    let flip = |node: &mut Node, ball: usize| {
        let Node::Object(fields) = node else { panic!("an object") };
        let (_, last) = fields.iter_mut().find(|(k, _)| k == "final").expect("final");
        let Node::List(balls) = last else { panic!("a list") };
        balls[ball].set("velocity", [-0.0, 0.0, 0.0]);
    };
    flip(&mut node, 0);
    flip(&mut node, 1);
    let e = Trace::from_node(&node).expect_err("two flipped signs change the hash");
    assert!(e.to_string().starts_with("hash: "), "{e}");
}

#[test]
fn a_trace_that_was_edited_is_refused() {
    let json = played("follow_shot").to_json();
    let refused = |from: &str, to: &str| {
        assert!(json.contains(from), "{from}");
        match Trace::from_json(&json.replacen(from, to, 1)) {
            Err(Error::Input(e)) => e.place,
            other => panic!("{from}: {other:?}"),
        }
    };
    assert_eq!(refused("carom-trace/1", "carom-trace/9"), "format");
    assert_eq!(refused("\"time\": 0.0", "\"time\": 1e-300"), "hash");
    assert_eq!(refused("cue-strike", "cue-strick"), "events[0].type");
    assert_eq!(
        refused("\"motion\": \"stationary\"", "\"motion\": \"still\""),
        "events[0].before[0].motion"
    );
    assert_eq!(refused("\"wpa-9ft-2026-12\"", "\"wpa-9ft-2026\""), "shot.table");
    assert_eq!(refused("\"duration\"", "\"during\""), "duration");
}

#[test]
fn unknown_keys_of_a_newer_engine_are_ignored() {
    let trace = played("follow_shot");
    let mut node = trace.to_node();
    node.set("weather", "fine");
    node.set("engine", "carom 99.0.0");
    let read = Trace::from_node(&node).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(read.hash(), trace.hash());
    assert_eq!(read.engine(), "carom 99.0.0");
}

#[test]
fn states_are_exact_at_events_and_between_them() {
    for name in NAMES {
        let trace = played(name);
        let mut follows: Vec<BallState> = trace.shot().balls().iter().map(|b| b.state).collect();
        for event in trace.events() {
            for (&i, before) in event.balls.iter().zip(event.before) {
                // The path from the ball's last event leads to its position at this one. Times are
                // rounded to 1e-16 of their size, which at 10 m/s is 1e-13 m.
                if event.time > 1e-6 && trace_is_quiet(&trace, event.time, i) {
                    let at = trace.at(event.time - 1e-9).unwrap_or_else(|e| panic!("{e}"));
                    let was = at[usize::from(i)];
                    let moved = was.position + before.velocity * 1e-9;
                    let gap = (moved - before.position).length();
                    assert!(gap < 1e-13, "{name} {}: {gap}", event.time);
                }
            }
            for (&i, after) in event.balls.iter().zip(event.after) {
                follows[usize::from(i)] = *after;
            }
            let last_here = !trace.events().any(|e| e.time == event.time && e != event);
            if last_here {
                let at = trace.at(event.time).unwrap_or_else(|e| panic!("{e}"));
                for &i in event.balls {
                    let i = usize::from(i);
                    assert_eq!(bits(&at[i]), bits(&follows[i]), "{name} {}", event.time);
                }
            }
        }
        let end = trace.at(trace.duration()).unwrap_or_else(|e| panic!("{e}"));
        assert!(end.iter().map(bits).eq(trace.last().iter().map(bits)), "{name}");
        let late = trace.at(1e6).unwrap_or_else(|e| panic!("{e}"));
        assert!(late.iter().map(bits).eq(trace.last().iter().map(bits)), "{name}");
    }
}

/// Whether ball `i` has no other event within 2 ns before `time`.
fn trace_is_quiet(trace: &Trace, time: f64, i: u16) -> bool {
    !trace.events().any(|e| e.balls.contains(&i) && e.time < time && e.time > time - 2e-9)
        && trace.events().filter(|e| e.balls.contains(&i) && e.time == time).count() == 1
}

#[test]
fn a_negative_or_infinite_time_is_refused() {
    let trace = played("follow_shot");
    for time in [-1e-300, f64::NAN, f64::NEG_INFINITY, f64::INFINITY] {
        let e = trace.at(time).expect_err("no such time");
        assert!(e.is_bad_input() && e.to_string().starts_with("time: "), "{e}");
    }
}

#[test]
fn a_ball_that_never_moves_keeps_the_bits_of_the_file() {
    let text = r#"{"format": "carom-shot/1", "table": "wpa-9ft",
        "balls": [{"id": "cue", "position": [0.635, 0.4]},
            {"id": "a", "position": [0.1000000000000001, 2.2000000000000006]}],
        "strike": {"ball": "cue", "speed": 0.3, "azimuth_deg": 90}}"#;
    let trace = Shot::from_json(text).and_then(|s| s.simulate()).unwrap_or_else(|e| panic!("{e}"));
    let resting = Vec3::new(0.1000000000000001, 2.2000000000000006, 0.028575);
    assert_eq!(trace.last()[1].position, resting);
    // The cue ball runs along y: its x never changes.
    assert!(trace.events().all(|e| e.after[0].position.x == 0.635));
    assert!(trace.last()[0].position.y > 0.5);
}

#[test]
fn the_cap_on_events_carries_the_shot() {
    let shot = played("nine_ball_break").shot().clone();
    let mut node = shot.to_node();
    node.set("max_events", 10u32);
    let capped = Shot::from_node(&node).unwrap_or_else(|e| panic!("{e}"));
    match capped.simulate() {
        Err(Error::TooManyEvents(error)) => {
            assert_eq!(error.cap, 10);
            assert_eq!(Shot::from_json(&error.shot).unwrap_or_else(|e| panic!("{e}")), capped);
        }
        other => panic!("expected the cap, got {other:?}"),
    }
}

#[test]
fn the_cap_on_events_carries_the_strike_that_was_played_on_a_shot_without_one() {
    let shot = played("nine_ball_break").shot().clone();
    let strike = shot.strike();
    let mut node = shot.to_node();
    node.set("max_events", 10u32);
    let capped = Shot::from_node(&node).unwrap_or_else(|e| panic!("{e}"));
    let without =
        capped.with_balls(capped.balls().to_vec(), None).unwrap_or_else(|e| panic!("{e}"));
    match Simulator::new().play_strike(&without, strike, &mut NullRecorder) {
        Err(Error::TooManyEvents(error)) => {
            assert_eq!(error.cap, 10);
            assert_eq!(Shot::from_json(&error.shot).unwrap_or_else(|e| panic!("{e}")), capped);
        }
        other => panic!("expected the cap, got {other:?}"),
    }
}

#[test]
fn the_outcome_agrees_with_the_events() {
    for name in NAMES {
        let trace = played(name);
        let outcome = trace.outcome();
        assert_eq!(outcome.events as usize, trace.events().len(), "{name}");
        let fallen: Vec<u16> = trace
            .events()
            .filter(|e| matches!(e.kind, TraceEventKind::PocketCollision(_)))
            .map(|e| e.balls[0])
            .collect();
        assert!(outcome.pocketed.iter().map(|(b, _)| *b).eq(fallen.iter().copied()), "{name}");
        assert_eq!(outcome.cue_ball_scratched(), fallen.contains(&0), "{name}");
        for (i, state) in trace.last().iter().enumerate() {
            assert_eq!(
                state.motion == MotionState::Pocketed,
                fallen.contains(&(i as u16)),
                "{name}"
            );
        }
        let first =
            trace.events().find(|e| e.kind == TraceEventKind::BallCollision).expect("a contact");
        assert_eq!(outcome.first_contact, first.balls.iter().copied().find(|&b| b != 0), "{name}");
        assert!(outcome.never_resting.is_empty(), "{name}");
    }
}

#[test]
fn a_ball_without_friction_is_listed_as_never_resting() {
    let text = r#"{"format": "carom-shot/1", "table": {"cloth": "unbounded"},
        "physics": {"cloth": {"sliding_friction": 0, "rolling_friction": 0}},
        "balls": [{"id": "a", "position": [0, 0], "velocity": [1, 0, 0]},
            {"id": "b", "position": [0, 1]}]}"#;
    let trace = Shot::from_json(text).and_then(|s| s.simulate()).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(trace.outcome().never_resting, [0]);
    assert_eq!(trace.outcome().cue_ball, None);
}

#[test]
fn a_miscue_is_reported_if_the_shot_says_so() {
    let text = r#"{"format": "carom-shot/1", "table": "wpa-9ft",
        "balls": [{"id": "cue", "position": [0.635, 0.4]}],
        "strike": {"ball": "cue", "speed": 1, "azimuth_deg": 90, "side": 0.8, "miscue": "report"}}"#;
    let trace = Shot::from_json(text).and_then(|s| s.simulate()).unwrap_or_else(|e| panic!("{e}"));
    let reported = |trace: &Trace| trace.to_node().get("outcome")?.get("miscue").cloned();
    assert_eq!(reported(&trace), Some(Node::Bool(true)));
    assert_eq!(reported(&played("follow_shot")), Some(Node::Bool(false)));
}

/// The hash as `docs/formats.md` describes it, from the trace as written.
fn documented_hash(trace: &Node) -> String {
    fn text(node: Option<&Node>) -> &str {
        match node {
            Some(Node::Text(s)) => s,
            other => panic!("expected a text, got {other:?}"),
        }
    }
    fn list(node: Option<&Node>) -> &[Node] {
        match node {
            Some(Node::List(items)) => items,
            other => panic!("expected a list, got {other:?}"),
        }
    }
    fn double(node: &Node) -> u64 {
        match node {
            Node::Number(x) => x.to_bits(),
            other => panic!("expected a double, got {other:?}"),
        }
    }
    fn number(words: &[&str], word: &str) -> u64 {
        words.iter().position(|w| *w == word).expect("a known word") as u64
    }
    const MOTIONS: &[&str] =
        &["stationary", "spinning", "rolling", "sliding", "airborne", "pocketed", "off-table"];
    const RAILS: &[&str] = &[
        "bottom",
        "top",
        "left",
        "right",
        "left-lower",
        "left-upper",
        "right-lower",
        "right-upper",
    ];
    const PARTS: &[&str] = &["nose", "facing", "point", "top", "liner"];
    const POCKETS: &[&str] =
        &["bottom-left", "bottom-right", "left", "right", "top-left", "top-right"];

    let mut words: Vec<u64> = Vec::new();
    let state = |words: &mut Vec<u64>, ball: &Node| {
        for key in ["position", "velocity", "angular_velocity"] {
            words.extend(list(ball.get(key)).iter().map(double));
        }
        words.push(number(MOTIONS, text(ball.get("motion"))));
    };
    let shot = trace.get("shot").expect("the shot");
    let ids: Vec<&str> = list(shot.get("balls")).iter().map(|b| text(b.get("id"))).collect();
    for event in list(trace.get("events")) {
        let word = |key| text(event.get(key));
        words.push(double(event.get("time").expect("a time")));
        words.extend(match word("type") {
            "cue-strike" => {
                let Some(Node::Integer(contacts)) = event.get("tip_contacts") else {
                    panic!("no tip_contacts");
                };
                let pushed = event.get("pushed") == Some(&Node::Bool(true));
                [0, *contacts as u64 - 1, u64::from(pushed)]
            }
            "ball-collision" => [1, 0, 0],
            "rail-collision" => [2, number(RAILS, word("rail")), number(PARTS, word("part"))],
            "pocket-collision" => [3, number(POCKETS, word("pocket")), 0],
            "motion-transition" => [4, number(MOTIONS, word("from")), number(MOTIONS, word("to"))],
            "slate-collision" => [5, 0, 0],
            "off-table" => [6, 0, 0],
            other => panic!("{other}"),
        });
        let (before, after) = (list(event.get("before")), list(event.get("after")));
        words.push(before.len() as u64);
        for (before, after) in before.iter().zip(after) {
            words.push(number(&ids, text(before.get("id"))));
            state(&mut words, before);
            state(&mut words, after);
        }
    }
    list(trace.get("final")).iter().for_each(|ball| state(&mut words, ball));
    let mut h: u64 = 0xcbf2_9ce4_8422_2325;
    for w in words {
        h = (h ^ w).wrapping_mul(0x100_0000_01b3);
        h ^= h >> 32;
    }
    format!("{h:016x}")
}

#[test]
fn the_hash_is_computed_as_documented() {
    for name in NAMES {
        let node = played(name).to_node();
        let written = node.get("hash").cloned();
        assert_eq!(written, Some(Node::Text(documented_hash(&node))), "{name}");
    }
}

#[test]
fn a_malformed_number_is_refused_with_a_short_error() {
    let text = played("follow_shot").to_json().replacen("\"time\": 0.0", "\"time\": null", 1);
    let sentence = Trace::from_json(&text).expect_err("no number").to_string();
    assert_eq!(sentence, "events[0].time: found null; write a finite number ≥ 0 s");
}

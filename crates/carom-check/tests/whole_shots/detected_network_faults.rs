//! The checker detects wrong impulses in a collision of more than two balls: records of simulated
//! shots are falsified in one place.

use carom::event::{EventKind, Recorder};
use carom::math::Vec3;
use carom::{BallState, Shot};
use carom_check::CheckRecorder;

use crate::owned_event::{OwnedEvent, events};

/// Radius of a ball, m.
const R: f64 = 0.03;

/// A ball with sidespin that meets balls at these places, in radii from the first of them.
fn a_shot(others: &[[f64; 2]]) -> Shot {
    let list: Vec<String> = others
        .iter()
        .enumerate()
        .map(|(k, [x, y])| {
            format!(r#"{{"id": "{}", "position": [{:?}, {:?}]}}"#, k + 1, 0.7 + R * x, 1.2 + R * y)
        })
        .collect();
    let file = format!(
        r#"{{"format": "carom-shot/1", "table": "carom-10ft", "physics": {{"base": "pool",
            "ball": {{"radius": {R}, "mass": 0.2}}}},
            "balls": [{{"id": "0", "position": [0.69, 1.0], "velocity": [0, 3, 0],
            "angular_velocity": [-40, 0, 60]}}, {}]}}"#,
        list.join(", ")
    );
    Shot::from_json(&file).unwrap_or_else(|e| panic!("{e}"))
}

/// Three balls in a row.
fn row() -> Shot {
    a_shot(&[[0.0, 0.0], [0.0, 2.0], [0.0, 4.0]])
}

/// Six balls of a rack.
fn rack() -> Shot {
    let h = 3.0_f64.sqrt();
    a_shot(&[[0.0, 0.0], [-1.0, h], [1.0, h], [-2.0, 2.0 * h], [0.0, 2.0 * h], [2.0, 2.0 * h]])
}

fn faults(shot: &Shot, falsify: impl Fn(&mut OwnedEvent)) -> Vec<String> {
    let mut all = events(shot);
    let is_network = |e: &OwnedEvent| e.kind == EventKind::BallCollision && e.balls.len() > 2;
    let k = all.iter().position(is_network).expect("a network");
    assert_eq!(all[k].balls.len(), shot.balls().len());
    falsify(&mut all[k]);
    all.truncate(k + 1);
    let mut checker = CheckRecorder::new(shot);
    all.iter().for_each(|e| checker.record(&e.event()));
    checker.faults.iter().map(ToString::to_string).collect()
}

fn assert_detected(shot: &Shot, word: &str, falsify: impl Fn(&mut OwnedEvent)) {
    let found = faults(shot, falsify);
    assert!(found.iter().any(|f| f.contains(word)), "no {word:?} in {found:#?}");
}

/// Adds the impulse (m/s; the masses are equal) of a contact of balls `a` and `b` to their motion.
fn add_impulse(event: &mut OwnedEvent, a: usize, b: usize, impulse: impl Fn(Vec3) -> Vec3) {
    let line = event.before[b].position - event.before[a].position;
    let normal = line * (1.0 / line.length());
    let push = impulse(normal);
    let turn = normal.cross(push) * (2.5 / R);
    let change = |s: &mut BallState, push: Vec3| {
        s.velocity += push;
        s.angular_velocity -= turn;
    };
    change(&mut event.after[a], -push);
    change(&mut event.after[b], push);
}

#[test]
fn accepts_unchanged_records() {
    for shot in [row(), rack()] {
        assert_eq!(faults(&shot, |_| {}), Vec::<String>::new());
    }
}

/// Replaces the event's result by impulses of 0.5 and 0.4 m/s along the first contacts of a chain of
/// balls, and another impulse at the last contact.
fn chain(event: &mut OwnedEvent, balls: [usize; 4], last: impl Fn(Vec3) -> Vec3) {
    for (after, before) in event.after.iter_mut().zip(&event.before) {
        let motion = if after.velocity == Vec3::ZERO { before.motion } else { after.motion };
        *after = BallState { motion, ..*before };
    }
    let [a, b, c, d] = balls;
    add_impulse(event, a, b, |normal| normal * 0.5);
    add_impulse(event, b, c, |normal| normal * 0.4);
    add_impulse(event, c, d, last);
}

/// The chains of the row, and of one side of the rack.
fn chains() -> [(Shot, [usize; 4]); 2] {
    [(row(), [0, 1, 2, 3]), (rack(), [0, 1, 3, 6])]
}

fn across(normal: Vec3) -> Vec3 {
    Vec3::new(-normal.y, normal.x, 0.0)
}

#[test]
fn accepts_a_chain_of_impulses_within_the_cone() {
    for (shot, balls) in chains() {
        let impulse = |normal| normal * 0.3 + across(normal) * 0.02;
        let found = faults(&shot, |e| chain(e, balls, impulse));
        assert!(!found.iter().any(|f| f.contains("no impulses")), "{found:#?}");
    }
}

#[test]
fn detects_a_pull() {
    for (shot, balls) in chains() {
        assert_detected(&shot, "without a pull", |e| chain(e, balls, |normal| normal * -0.3));
    }
}

#[test]
fn detects_friction_beyond_the_cone() {
    for (shot, balls) in chains() {
        let impulse = |normal| normal * 0.3 + across(normal) * 0.2;
        assert_detected(&shot, "without a pull", |e| chain(e, balls, impulse));
    }
}

#[test]
fn detects_spin_that_no_impulses_explain() {
    for shot in [row(), rack()] {
        assert_detected(&shot, "no impulses", |e| e.after[2].angular_velocity.z += 20.0);
    }
}

#[test]
fn detects_an_impulse_between_balls_that_do_not_touch() {
    assert_detected(&row(), "no impulses at the 3 contacts", |e| {
        add_impulse(e, 0, 3, |_| Vec3::new(0.2, 0.0, 0.0));
    });
    // Sideways impulses of balls beside each other in the last row but one.
    assert_detected(&rack(), "no impulses", |e| {
        add_impulse(e, 1, 5, |normal| across(normal) * 0.1);
    });
}

#[test]
fn detects_a_ball_that_is_too_far_away() {
    assert_detected(&row(), "no impulses at the 2 contacts", |e| {
        e.before[3].position.y += 1e-3;
        e.after[3].position.y += 1e-3;
    });
}

#[test]
fn reports_balls_that_still_approach() {
    let shot = row();
    let mut all = events(&shot);
    let k = all.iter().position(|e| e.balls.len() > 2).expect("a network");
    let left = |event: &OwnedEvent| {
        let mut checker = CheckRecorder::new(&shot);
        checker.record(&event.event());
        checker.left_approaching
    };
    assert!(left(&all[k]) < carom_check::LEFT_APPROACHING);
    // Only a third of the impulses.
    for i in 0..4 {
        let (before, after) = (all[k].before[i], &mut all[k].after[i]);
        after.velocity = before.velocity + (after.velocity - before.velocity) * (1.0 / 3.0);
    }
    assert!(left(&all[k]) > 0.1);
}

/// Seen in 200 000 random shots (`Frozen`, 77012290), and judged a fault: ball 7 comes back from the
/// rail and hits ball 8 to ball 0, from which ball 8 is just moving away. Before they meet again, the
/// line of their centres has turned by 0.0077 rad, which was more than the judge allowed.
#[test]
fn accepts_a_ball_that_is_hit_back_to_the_one_it_has_just_left() {
    let file = r#"{"format": "carom-shot/1", "table": "carom-9ft", "physics": "carom-2026-12",
        "balls": [{"id": "0", "position": [1.130597902370058, 0.3628891312538034],
            "velocity": [0.27902410931020105, 0.12719946540442897, 0],
            "angular_velocity": [-4.1365679806318365, 9.073954774315482, -7.856262264630199]},
        {"id": "7", "position": [1.239891861565351, 0.3985837477466361]},
        {"id": "8", "position": [1.178461374594468, 0.4015069772142286]}]}"#;
    let shot = Shot::from_json(file).unwrap_or_else(|e| panic!("{e}"));
    let networks = events(&shot).iter().filter(|e| e.balls.len() == 3).count();
    assert_eq!(networks, 2);
    let checker = CheckRecorder::run(&shot);
    assert!(checker.faults.is_empty(), "{:#?}", checker.faults);
}

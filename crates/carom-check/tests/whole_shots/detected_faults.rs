//! The checker detects faults: records of simulated shots are falsified in one place.

use carom::event::{EventKind, Recorder};
use carom::math::Vec3;
use carom::{BallState, Shot};
use carom_check::CheckRecorder;
use carom_check::random_shots::{ShotFamily, shot_file};

use crate::owned_event::{OwnedEvent, events};

/// A shot with a collision of exactly two balls and a rail contact, both early in the shot.
fn a_shot() -> Shot {
    let shots =
        (0..).map(|seed| Shot::from_json(&shot_file(ShotFamily::Pot, seed)).expect("a shot"));
    let rich = |shot: &Shot| {
        let all = events(shot);
        let early = &all[..all.len() / 3];
        early.iter().any(is_collision) && early.iter().any(is_rail)
    };
    shots.into_iter().find(rich).expect("an ordinary shot")
}

fn is_collision(e: &OwnedEvent) -> bool {
    e.kind == EventKind::BallCollision && e.balls.len() == 2
}

fn is_rail(e: &OwnedEvent) -> bool {
    matches!(e.kind, EventKind::RailCollision(_))
}

/// Index of the first collision of two balls.
fn collision(events: &[OwnedEvent]) -> usize {
    events.iter().position(is_collision).expect("a collision")
}

fn faults(falsify: impl FnOnce(&mut Vec<OwnedEvent>)) -> Vec<String> {
    let shot = a_shot();
    let mut all = events(&shot);
    falsify(&mut all);
    let mut checker = CheckRecorder::new(&shot);
    all.iter().for_each(|e| checker.record(&e.event()));
    checker.faults.iter().map(ToString::to_string).collect()
}

fn assert_detected(word: &str, falsify: impl FnOnce(&mut Vec<OwnedEvent>)) {
    let found = faults(falsify);
    assert!(found.iter().any(|f| f.contains(word)), "no {word:?} in {found:#?}");
}

/// Changes the first ball of the first collision.
fn after_collision(change: impl Fn(&mut BallState)) -> impl FnOnce(&mut Vec<OwnedEvent>) {
    move |all| {
        let k = collision(all);
        change(&mut all[k].after[0]);
    }
}

#[test]
fn accepts_an_unchanged_record() {
    assert_eq!(faults(|_| {}), Vec::<String>::new());
}

#[test]
fn detects_a_missing_collision() {
    assert_detected("overlap", |all| {
        // Also without the later events of these balls, which would be off their paths.
        let k = collision(all);
        let gone = all[k].balls.clone();
        let rest = all.split_off(k);
        all.extend(rest.into_iter().filter(|e| e.balls.iter().all(|b| !gone.contains(b))));
    });
}

#[test]
fn detects_a_missing_rail_contact() {
    assert_detected(" rail overlap", |all| {
        let k = all.iter().position(is_rail).expect("a rail");
        all.truncate(k);
        let mut end = all[k - 1].clone();
        end.time += 1.0;
        all.push(end);
    });
}

#[test]
fn detects_a_gain_of_energy() {
    assert_detected("raises the energy", after_collision(|s| s.velocity.x += 20.0));
}

#[test]
fn detects_a_loss_of_momentum() {
    assert_detected("momentum", after_collision(|s| s.velocity = s.velocity * (1.0 - 1e-9)));
}

#[test]
fn detects_spin_that_no_force_at_the_contact_can_cause() {
    assert_detected("angular momentum", |all| {
        let k = collision(all);
        all[k].after[0].angular_velocity += Vec3::new(0.0, 0.0, 1e-6);
    });
}

#[test]
fn detects_a_ball_off_its_path() {
    assert_detected("from its path", |all| {
        let last = all.len() - 1;
        all[last].before[0].position.x += 1e-9;
    });
}

#[test]
fn detects_time_that_runs_backwards() {
    assert_detected("time runs backwards", |all| {
        let last = all.len() - 1;
        all[last].time = 0.0;
    });
}

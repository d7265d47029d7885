//! The judge sees what is wrong: records of true shots are falsified in one place.

use carom::event::{EventKind, Recorder};
use carom::math::Vec3;
use carom::{BallState, Shot};
use carom_check::CheckRecorder;
use carom_check::random_shots::{ShotFamily, shot_file};

use crate::owned_event::{OwnedEvent, events};

/// A shot with a collision of two balls alone, a rail, and much that happens after both.
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

fn assert_noticed(word: &str, falsify: impl FnOnce(&mut Vec<OwnedEvent>)) {
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
fn accepts_a_true_record() {
    assert_eq!(faults(|_| {}), Vec::<String>::new());
}

#[test]
fn detects_a_collision_left_out() {
    assert_noticed("overlap", |all| {
        // With all that these balls do later, which alone would give them away.
        let k = collision(all);
        let gone = all[k].balls.clone();
        let rest = all.split_off(k);
        all.extend(rest.into_iter().filter(|e| e.balls.iter().all(|b| !gone.contains(b))));
    });
}

#[test]
fn detects_a_rail_gone_through() {
    assert_noticed(" rail overlap", |all| {
        let k = all.iter().position(is_rail).expect("a rail");
        all.truncate(k);
        let mut end = all[k - 1].clone();
        end.time += 1.0;
        all.push(end);
    });
}

#[test]
fn detects_energy_from_nowhere() {
    assert_noticed("raises the energy", after_collision(|s| s.velocity.x += 20.0));
}

#[test]
fn detects_momentum_that_is_lost() {
    assert_noticed("momentum", after_collision(|s| s.velocity = s.velocity * (1.0 - 1e-9)));
}

#[test]
fn detects_spin_that_no_force_at_the_contact_gives() {
    assert_noticed("angular momentum", |all| {
        let k = collision(all);
        all[k].after[0].angular_velocity += Vec3::new(0.0, 0.0, 1e-6);
    });
}

#[test]
fn detects_a_ball_that_is_not_on_its_path() {
    assert_noticed("from its path", |all| {
        let last = all.len() - 1;
        all[last].before[0].position.x += 1e-9;
    });
}

#[test]
fn detects_time_that_goes_back() {
    assert_noticed("time goes back", |all| {
        let last = all.len() - 1;
        all[last].time = 0.0;
    });
}

//! The judge sees what is wrong off the cloth: records written by hand, each false in one place.

use carom::event::{EventKind, Recorder};
use carom::math::Vec3;
use carom::{BallState, MotionState, Shot, Summary};
use carom_check::CheckRecorder;

/// Radius of a pool ball, m.
const R: f64 = 0.028_575;

/// The pool table: half its width, m, and the height of its noses, m.
const HALF_WIDTH: f64 = 0.635;
const NOSE: f64 = 0.635 * 0.057_15;

/// A record written by hand.
struct Record<'a> {
    checker: CheckRecorder<'a>,
    gravity: f64,
    states: Vec<BallState>,
    time: f64,
}

/// A shot of balls at places and with velocities in the engine's frame, on the 9-ft pool table.
fn shot(balls: &[([f64; 3], [f64; 3])]) -> Shot {
    let list: Vec<String> = balls
        .iter()
        .enumerate()
        .map(|(k, ([x, y, z], v))| {
            let place = [x + HALF_WIDTH, y + 1.27, *z];
            format!("{{\"id\": \"{k}\", \"position\": {place:?}, \"velocity\": {v:?}}}")
        })
        .collect();
    let file = format!(
        "{{\"format\": \"carom-shot/1\", \"table\": \"wpa-9ft\", \"balls\": [{}]}}",
        list.join(", ")
    );
    Shot::from_json(&file).unwrap_or_else(|e| panic!("{e}"))
}

impl<'a> Record<'a> {
    fn new(shot: &'a Shot) -> Self {
        let states = shot.balls().iter().map(|b| shot.table().to_engine_frame(&b.state)).collect();
        Self {
            checker: CheckRecorder::new(shot),
            gravity: shot.physics().gravity,
            states,
            time: 0.0,
        }
    }

    /// All balls fly on freely, then an event of ball 0 happens, after which it is as `change` says.
    fn then(&mut self, after: f64, kind: EventKind, change: impl FnOnce(&mut BallState)) {
        self.time += after;
        for s in self.states.iter_mut().filter(|s| s.motion == MotionState::Airborne) {
            s.position +=
                s.velocity * after - Vec3::new(0.0, 0.0, 0.5 * self.gravity * after * after);
            s.velocity.z -= self.gravity * after;
        }
        let before = [self.states[0]];
        change(&mut self.states[0]);
        self.checker.record(&carom::event::Event {
            time: self.time,
            kind,
            balls: &[0],
            before: &before,
            after: &[self.states[0]],
        });
    }

    fn assert_noticed(self, word: &str) {
        let found: Vec<String> = self.checker.faults.iter().map(ToString::to_string).collect();
        assert!(found.iter().any(|f| f.contains(word)), "no {word:?} in {found:#?}");
    }
}

/// When a ball that falls from rest has fallen so far, s.
fn fall(distance: f64) -> f64 {
    (2.0 * distance / carom::physics::presets::STANDARD_GRAVITY).sqrt()
}

/// Over the cloth, `height` m above where it lands.
fn falling(height: f64) -> Shot {
    shot(&[([0.1, 0.3, R + height], [0.5, 0.0, 0.0])])
}

/// A right bounce: half the speed, and of the friction what grips.
fn bounce(s: &mut BallState) {
    let fall = -s.velocity.z;
    s.velocity.z = 0.5 * fall;
    let impulse = (0.2 * 1.5 * fall).min(2.0 / 7.0 * s.velocity.x);
    s.velocity.x -= impulse;
    s.angular_velocity.y = 2.5 * impulse / R;
}

/// The record of a ball that falls 5 cm on to the slate, and is then changed.
fn bounced(change: impl FnOnce(&mut BallState)) -> (Shot, impl FnOnce(&mut Record<'_>)) {
    let act = |record: &mut Record<'_>| record.then(fall(0.05), EventKind::SlateCollision, change);
    (falling(0.05), act)
}

fn assert_bounce_noticed(word: &str, change: impl FnOnce(&mut BallState)) {
    let (shot, act) = bounced(change);
    let mut record = Record::new(&shot);
    act(&mut record);
    record.assert_noticed(word);
}

#[test]
fn accepts_a_right_bounce() {
    let (shot, act) = bounced(bounce);
    let mut record = Record::new(&shot);
    act(&mut record);
    assert!(record.checker.faults.is_empty(), "{:#?}", record.checker.faults);
}

#[test]
fn detects_a_bounce_that_gains_energy() {
    assert_bounce_noticed("raises the energy", |s| {
        bounce(s);
        s.velocity.z *= 2.1;
    });
}

#[test]
fn detects_a_bounce_with_more_friction_than_there_is() {
    assert_bounce_noticed("a friction of", |s| {
        let fall = -s.velocity.z;
        s.velocity.z = 0.0;
        let impulse = 0.5 * fall;
        s.velocity.x -= impulse;
        s.angular_velocity.y = 2.5 * impulse / R;
    });
}

#[test]
fn detects_a_bounce_that_turns_the_ball_as_no_force_at_its_foot_does() {
    assert_bounce_noticed("angular momentum", |s| {
        bounce(s);
        s.angular_velocity.z = 1e-6;
    });
}

#[test]
fn detects_a_ball_that_goes_on_into_the_slate() {
    assert_bounce_noticed("goes on into what it has met", |s| s.velocity.z *= 0.5);
}

#[test]
fn detects_a_bounce_in_mid_air() {
    let shot = falling(0.05);
    let mut record = Record::new(&shot);
    record.then(0.9 * fall(0.05), EventKind::SlateCollision, bounce);
    record.assert_noticed("from what it is said to touch");
}

#[test]
fn detects_a_flight_through_the_slate() {
    let shot = falling(0.05);
    let mut record = Record::new(&shot);
    record.then(1.1 * fall(0.05), EventKind::SlateCollision, bounce);
    record.assert_noticed("the slate overlap");
}

#[test]
fn detects_a_ball_let_through_a_nose_from_above() {
    let shot = shot(&[([HALF_WIDTH - 0.01, 0.5, 0.1], [0.0, 0.0, 0.0])]);
    let mut record = Record::new(&shot);
    record.then(fall(0.1 - R), EventKind::SlateCollision, |s| s.velocity.z = 0.0);
    record.assert_noticed("the right-upper rail overlap");
}

#[test]
fn detects_a_ball_let_through_a_nose_at_its_height() {
    let shot = shot(&[([HALF_WIDTH - 0.05, 0.5, NOSE + 0.01], [8.0, 0.0, 0.0])]);
    let mut record = Record::new(&shot);
    record.then(0.01, EventKind::RailCollision(0), |_| {});
    record.assert_noticed("the right-upper rail overlap");
}

#[test]
fn detects_a_ball_let_through_another_in_the_air() {
    let shot = shot(&[([0.0, 0.0, 0.2], [3.0, 0.0, 0.5]), ([0.3, 0.01, 0.21], [-3.0, 0.0, 0.4])]);
    let mut record = Record::new(&shot);
    record.then(0.1, EventKind::OffTable, |_| {});
    record.assert_noticed("balls 0 and 1 overlap");
}

/// Over the middle of a corner's hole, at the height `z`, m, falling at `speed` m/s.
fn over_hole(z: f64, speed: f64) -> Shot {
    let table = carom::Table::preset("wpa-9ft").expect("a preset");
    let hole = table.pockets[0].center;
    shot(&[([hole.x, hole.y, z], [0.0, 0.0, -speed])])
}

fn sink(s: &mut BallState) {
    *s = BallState {
        position: Vec3::new(s.position.x, s.position.y, -R),
        motion: MotionState::Pocketed,
        ..BallState::default()
    };
}

#[test]
fn detects_a_ball_sunk_too_early() {
    let shot = over_hole(0.05, 0.1);
    let mut record = Record::new(&shot);
    record.then(0.01, EventKind::PocketCollision(0), sink);
    record.assert_noticed("is pocketed");
}

#[test]
fn detects_a_ball_sunk_that_could_come_back() {
    let shot = over_hole(0.04, 4.0);
    let mut record = Record::new(&shot);
    record.then(0.012, EventKind::PocketCollision(0), sink);
    record.assert_noticed("could come up to");
}

#[test]
fn accepts_a_ball_that_falls_down_a_hole() {
    let shot = over_hole(0.04, 4.0);
    let mut record = Record::new(&shot);
    // A radius below the slate it is lost however fast it is.
    record.then(0.018, EventKind::PocketCollision(0), sink);
    assert!(record.checker.faults.is_empty(), "{:#?}", record.checker.faults);
}

#[test]
fn detects_a_flight_through_the_wall_of_a_hole() {
    let table = carom::Table::preset("wpa-9ft").expect("a preset");
    let hole = table.pockets[0].center;
    let shot = shot(&[([hole.x, hole.y, 0.03], [-3.0, -3.0, 0.0])]);
    let mut record = Record::new(&shot);
    record.then(0.03, EventKind::PocketCollision(0), sink);
    record.assert_noticed("the liner of the bottom-left pocket overlap");
}

fn leave(s: &mut BallState) {
    *s = BallState { position: s.position, motion: MotionState::OffTable, ..BallState::default() };
}

#[test]
fn detects_a_ball_off_the_table_that_is_still_over_it() {
    let shot = shot(&[([HALF_WIDTH - 0.1, 0.5, 0.2], [4.0, 0.0, 1.0])]);
    let mut record = Record::new(&shot);
    record.then(0.05, EventKind::OffTable, leave);
    record.assert_noticed("inside its border");
}

#[test]
fn detects_a_ball_beyond_the_border_that_is_not_off_the_table() {
    let shot = shot(&[([HALF_WIDTH - 0.1, 0.5, 0.2], [4.0, 0.0, 1.0])]);
    let mut record = Record::new(&shot);
    record.then(0.08, EventKind::OffTable, leave);
    record.assert_noticed("the border overlap");
}

#[test]
fn detects_a_ball_that_takes_off_from_level_cloth() {
    let shot = shot(&[([0.0, 0.0, R], [0.5, 0.0, 0.0])]);
    let mut record = Record::new(&shot);
    let kind =
        EventKind::MotionTransition { from: MotionState::Sliding, to: MotionState::Airborne };
    record.then(0.0, kind, |s| s.motion = MotionState::Airborne);
    record.assert_noticed("takes off where there is ground");
}

#[test]
fn detects_a_ball_that_stands_on_air() {
    let shot = falling(0.05);
    let mut record = Record::new(&shot);
    record.then(fall(0.05), EventKind::SlateCollision, |s| {
        s.velocity = Vec3::ZERO;
        s.position.z += 1e-6;
        s.motion = MotionState::Stationary;
    });
    record.assert_noticed("is stationary at z =");
}

#[test]
fn detects_a_ball_that_is_still_in_the_air_in_the_end() {
    let (shot, act) = bounced(bounce);
    let mut record = Record::new(&shot);
    act(&mut record);
    record.checker.finish(Ok(Summary { duration: record.time, events: 1 }));
    record.assert_noticed("still airborne in the end");
}

#[test]
fn detects_a_ball_at_rest_on_a_rail_in_the_end() {
    let shot = shot(&[([HALF_WIDTH + 0.06, 0.5, NOSE + R + 0.05], [0.0, 0.0, 0.0])]);
    let mut record = Record::new(&shot);
    record.then(fall(0.05), EventKind::RailCollision(0), |s| {
        s.velocity = Vec3::ZERO;
        s.motion = MotionState::Stationary;
    });
    record.checker.finish(Ok(Summary { duration: record.time, events: 1 }));
    record.assert_noticed("still stationary in the end");
}

#[test]
fn detects_momentum_that_changes_where_no_ball_stands_on_anything() {
    let d = 2.0 * R;
    let shot = shot(&[([0.0, 0.0, 0.2], [1.0, 0.0, 0.0]), ([d, 0.0, 0.2], [0.0, 0.0, 0.0])]);
    let mut checker = CheckRecorder::new(&shot);
    let before: Vec<BallState> =
        shot.balls().iter().map(|b| shot.table().to_engine_frame(&b.state)).collect();
    let mut after = before.clone();
    after[0].velocity.x = 0.0;
    after[1].velocity = Vec3::new(1.0, 0.0, 1e-9);
    checker.record(&carom::event::Event {
        time: 0.0,
        kind: EventKind::BallCollision,
        balls: &[0, 1],
        before: &before,
        after: &after,
    });
    let found: Vec<String> = checker.faults.iter().map(ToString::to_string).collect();
    assert!(found.iter().any(|f| f.contains("momentum changes")), "{found:#?}");
}

#[test]
fn detects_a_pocketed_ball_that_takes_part_in_something() {
    let shot = over_hole(0.04, 4.0);
    let mut record = Record::new(&shot);
    record.then(0.018, EventKind::PocketCollision(0), sink);
    record.then(0.0, EventKind::SlateCollision, |_| {});
    record.assert_noticed("is pocketed, and out of play");
}

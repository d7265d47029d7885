//! The checker detects faults off the cloth: records written by hand, each wrong in one place.

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

/// A shot of balls with these positions and velocities (engine coordinates) on the 9-ft pool table.
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
        let states =
            shot.balls().iter().map(|b| shot.table().to_engine_coordinates(&b.state)).collect();
        Self {
            checker: CheckRecorder::new(shot),
            gravity: shot.physics().gravity,
            states,
            time: 0.0,
        }
    }

    /// All balls fly freely for `after` seconds; then ball 0 has an event that applies `change` to
    /// it.
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

    fn assert_detected(self, word: &str) {
        let found: Vec<String> = self.checker.faults.iter().map(ToString::to_string).collect();
        assert!(found.iter().any(|f| f.contains(word)), "no {word:?} in {found:#?}");
    }
}

/// Time in which a ball falls from rest by `distance`, s.
fn fall(distance: f64) -> f64 {
    (2.0 * distance / carom::physics::presets::STANDARD_GRAVITY).sqrt()
}

/// A ball in the air, `height` m above the point where it touches the cloth.
fn falling(height: f64) -> Shot {
    shot(&[([0.1, 0.3, R + height], [0.5, 0.0, 0.0])])
}

/// A valid bounce: half the normal speed, and the friction that stops the slip.
fn bounce(s: &mut BallState) {
    let fall = -s.velocity.z;
    s.velocity.z = 0.5 * fall;
    let impulse = (0.2 * 1.5 * fall).min(2.0 / 7.0 * s.velocity.x);
    s.velocity.x -= impulse;
    s.angular_velocity.y = 2.5 * impulse / R;
}

/// A ball that falls 5 cm onto the slate, and its bounce there.
fn bounced(change: impl FnOnce(&mut BallState)) -> (Shot, impl FnOnce(&mut Record<'_>)) {
    let act = |record: &mut Record<'_>| record.then(fall(0.05), EventKind::SlateCollision, change);
    (falling(0.05), act)
}

fn assert_bounce_detected(word: &str, change: impl FnOnce(&mut BallState)) {
    let (shot, act) = bounced(change);
    let mut record = Record::new(&shot);
    act(&mut record);
    record.assert_detected(word);
}

#[test]
fn accepts_a_valid_bounce() {
    let (shot, act) = bounced(bounce);
    let mut record = Record::new(&shot);
    act(&mut record);
    assert!(record.checker.faults.is_empty(), "{:#?}", record.checker.faults);
}

#[test]
fn detects_a_bounce_that_gains_energy() {
    assert_bounce_detected("raises the energy", |s| {
        bounce(s);
        s.velocity.z *= 2.1;
    });
}

#[test]
fn detects_a_bounce_with_too_much_friction() {
    assert_bounce_detected("a friction of", |s| {
        let fall = -s.velocity.z;
        s.velocity.z = 0.0;
        let impulse = 0.5 * fall;
        s.velocity.x -= impulse;
        s.angular_velocity.y = 2.5 * impulse / R;
    });
}

#[test]
fn detects_a_bounce_with_spin_that_no_force_at_the_contact_can_cause() {
    assert_bounce_detected("angular momentum", |s| {
        bounce(s);
        s.angular_velocity.z = 1e-6;
    });
}

#[test]
fn detects_a_ball_that_moves_on_into_the_slate() {
    assert_bounce_detected("moves on into the part that it met", |s| s.velocity.z *= 0.5);
}

#[test]
fn detects_a_bounce_in_mid_air() {
    let shot = falling(0.05);
    let mut record = Record::new(&shot);
    record.then(0.9 * fall(0.05), EventKind::SlateCollision, bounce);
    record.assert_detected("from the part that it touches");
}

#[test]
fn detects_a_flight_through_the_slate() {
    let shot = falling(0.05);
    let mut record = Record::new(&shot);
    record.then(1.1 * fall(0.05), EventKind::SlateCollision, bounce);
    record.assert_detected("the slate overlap");
}

#[test]
fn detects_a_ball_that_falls_through_a_nose() {
    let shot = shot(&[([HALF_WIDTH - 0.01, 0.5, 0.1], [0.0, 0.0, 0.0])]);
    let mut record = Record::new(&shot);
    record.then(fall(0.1 - R), EventKind::SlateCollision, |s| s.velocity.z = 0.0);
    record.assert_detected("the right-upper rail overlap");
}

#[test]
fn detects_a_ball_that_flies_through_a_nose() {
    let shot = shot(&[([HALF_WIDTH - 0.05, 0.5, NOSE + 0.01], [8.0, 0.0, 0.0])]);
    let mut record = Record::new(&shot);
    record.then(0.01, EventKind::RailCollision(0), |_| {});
    record.assert_detected("the right-upper rail overlap");
}

#[test]
fn detects_a_ball_that_flies_through_another() {
    let shot = shot(&[([0.0, 0.0, 0.2], [3.0, 0.0, 0.5]), ([0.3, 0.01, 0.21], [-3.0, 0.0, 0.4])]);
    let mut record = Record::new(&shot);
    record.then(0.1, EventKind::OffTable, |_| {});
    record.assert_detected("balls 0 and 1 overlap");
}

/// A ball over the centre of a corner pocket at height `z` (m) that falls at `speed` (m/s).
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
fn detects_a_ball_pocketed_too_early() {
    let shot = over_hole(0.05, 0.1);
    let mut record = Record::new(&shot);
    record.then(0.01, EventKind::PocketCollision(0), sink);
    record.assert_detected("is pocketed");
}

#[test]
fn detects_a_pocketed_ball_that_could_come_back() {
    let shot = over_hole(0.04, 4.0);
    let mut record = Record::new(&shot);
    record.then(0.012, EventKind::PocketCollision(0), sink);
    record.assert_detected("could come up to");
}

#[test]
fn accepts_a_ball_that_falls_down_a_hole() {
    let shot = over_hole(0.04, 4.0);
    let mut record = Record::new(&shot);
    // A radius below the slate a ball counts as pocketed at any speed.
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
    record.assert_detected("the liner of the bottom-left pocket overlap");
}

fn leave(s: &mut BallState) {
    *s = BallState { position: s.position, motion: MotionState::OffTable, ..BallState::default() };
}

#[test]
fn detects_a_ball_off_the_table_that_is_still_over_it() {
    let shot = shot(&[([HALF_WIDTH - 0.1, 0.5, 0.2], [4.0, 0.0, 1.0])]);
    let mut record = Record::new(&shot);
    record.then(0.05, EventKind::OffTable, leave);
    record.assert_detected("inside its border");
}

#[test]
fn detects_a_ball_beyond_the_border_that_is_not_off_the_table() {
    let shot = shot(&[([HALF_WIDTH - 0.1, 0.5, 0.2], [4.0, 0.0, 1.0])]);
    let mut record = Record::new(&shot);
    record.then(0.08, EventKind::OffTable, leave);
    record.assert_detected("the border overlap");
}

#[test]
fn detects_a_ball_that_takes_off_from_level_cloth() {
    let shot = shot(&[([0.0, 0.0, R], [0.5, 0.0, 0.0])]);
    let mut record = Record::new(&shot);
    let kind =
        EventKind::MotionTransition { from: MotionState::Sliding, to: MotionState::Airborne };
    record.then(0.0, kind, |s| s.motion = MotionState::Airborne);
    record.assert_detected("takes off where there is ground");
}

#[test]
fn detects_a_ball_at_rest_without_support() {
    let shot = falling(0.05);
    let mut record = Record::new(&shot);
    record.then(fall(0.05), EventKind::SlateCollision, |s| {
        s.velocity = Vec3::ZERO;
        s.position.z += 1e-6;
        s.motion = MotionState::Stationary;
    });
    record.assert_detected("is stationary at z =");
}

#[test]
fn detects_a_ball_in_the_air_at_the_end() {
    let (shot, act) = bounced(bounce);
    let mut record = Record::new(&shot);
    act(&mut record);
    record.checker.finish(Ok(Summary { duration: record.time, events: 1 }));
    record.assert_detected("still airborne in the end");
}

#[test]
fn detects_a_ball_at_rest_on_a_rail_at_the_end() {
    let shot = shot(&[([HALF_WIDTH + 0.06, 0.5, NOSE + R + 0.05], [0.0, 0.0, 0.0])]);
    let mut record = Record::new(&shot);
    record.then(fall(0.05), EventKind::RailCollision(0), |s| {
        s.velocity = Vec3::ZERO;
        s.motion = MotionState::Stationary;
    });
    record.checker.finish(Ok(Summary { duration: record.time, events: 1 }));
    record.assert_detected("still stationary in the end");
}

#[test]
fn detects_a_change_of_momentum_of_two_balls_in_the_air() {
    let d = 2.0 * R;
    let shot = shot(&[([0.0, 0.0, 0.2], [1.0, 0.0, 0.0]), ([d, 0.0, 0.2], [0.0, 0.0, 0.0])]);
    let mut checker = CheckRecorder::new(&shot);
    let before: Vec<BallState> =
        shot.balls().iter().map(|b| shot.table().to_engine_coordinates(&b.state)).collect();
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
fn detects_an_event_of_a_pocketed_ball() {
    let shot = over_hole(0.04, 4.0);
    let mut record = Record::new(&shot);
    record.then(0.018, EventKind::PocketCollision(0), sink);
    record.then(0.0, EventKind::SlateCollision, |_| {});
    record.assert_detected("is pocketed, and out of play");
}

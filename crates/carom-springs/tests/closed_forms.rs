//! Impacts whose results are known.

use carom_springs::Vector;
use carom_springs::impact::{SpringImpact, resolve};
use carom_springs::law::{Law, stiffness_of_time, tip_restitution};
use carom_springs::motion::Settings;
use carom_springs::network::{Network, SpringBall, SpringCue};

const MASS: f64 = 0.17;
const RADIUS: f64 = 0.028_575;
const CUE: f64 = 0.567;
/// The accuracy that the judge promises, as a share of the fastest speed.
const PROMISED: f64 = 1e-4;

fn ball(place: f64, speed: f64) -> SpringBall {
    SpringBall {
        mass: MASS,
        radius: RADIUS,
        position: Vector::new(2.0 * RADIUS * place, 0.0, 0.0),
        velocity: Vector::new(speed, 0.0, 0.0),
        spin: Vector::zeros(),
    }
}

fn after(network: &Network) -> SpringImpact {
    resolve(network, &Settings::USUAL, 1e-3).expect("an impact")
}

fn close(found: f64, expected: f64, by: f64) {
    assert!((found - expected).abs() < by, "{found} instead of {expected}");
}

#[test]
fn three_balls_in_a_row_part_as_published() {
    // TP B.29.
    let balls = vec![ball(0.0, 1.0), ball(1.0, 0.0), ball(2.0, 0.0)];
    let impact = after(&Network::of_balls(balls, Law::rigid(1.0, 0.0), 1e-3));
    for (found, expected) in impact.pauses[0].1.balls.iter().zip([-0.071, 0.076, 0.995]) {
        close(found.velocity.x, expected, 6e-4);
    }
}

#[test]
fn two_balls_part_with_the_restitution() {
    for e in [0.0, 0.5, 0.9, 1.0] {
        let balls = vec![ball(0.0, 1.0), ball(1.0, 0.0)];
        let end = after(&Network::of_balls(balls, Law::rigid(e, 0.0), 1e-3)).end().clone();
        close(end.balls[1].velocity.x - end.balls[0].velocity.x, e, PROMISED);
        close(end.balls[1].velocity.x + end.balls[0].velocity.x, 1.0, 1e-12);
    }
}

#[test]
fn a_gap_closes_first() {
    let balls = vec![ball(0.0, 1.0), ball(1.1, 0.0)];
    let impact = after(&Network::of_balls(balls, Law::rigid(0.9, 0.0), 0.1));
    close(impact.end().balls[1].velocity.x, 0.95, PROMISED);
    // A contact lasts about a quarter of a millisecond.
    let gap = 0.2 * RADIUS;
    assert!(impact.pauses[0].0 > gap && impact.pauses[0].0 < gap + 4e-4);
}

#[test]
fn slow_balls_part_without_losses() {
    for (speed, e) in [(0.5e-3, 1.0), (1.5e-3, 0.75), (2e-3, 0.5)] {
        let balls = vec![ball(0.0, speed), ball(1.0, 0.0)];
        let end = after(&Network::of_balls(balls, Law::rigid(0.5, 0.0), 1e-3)).end().clone();
        let apart = end.balls[1].velocity.x - end.balls[0].velocity.x;
        close(apart / speed, e, PROMISED);
    }
}

#[test]
fn a_contact_lasts_as_long_as_its_stiffness_was_chosen_for() {
    let mut network = Network { balls: vec![ball(0.0, 1.0)], ..Network::default() };
    let stiffness = stiffness_of_time(MASS, 2e-3);
    network.add_wall(0, Vector::x(), 0.0, stiffness, Law::rigid(1.0, 0.0));
    let impact = after(&network);
    close(impact.end().balls[0].velocity.x, -1.0, PROMISED);
    // The end is noticed at the next step, which takes up to a tenth of a contact.
    close(impact.pauses[0].0, 2.1e-3, 1.05e-4);
}

fn thrown(law: Law, slip: f64) -> f64 {
    let mut moving = ball(0.0, 1.0);
    moving.velocity.y = slip;
    let start = Network::of_balls(vec![moving, ball(1.0, 0.0)], law, 1e-3);
    let end = after(&start).end().clone();
    assert!((end.momentum() - start.momentum()).norm() < 1e-13);
    assert!(end.energy() < start.energy() * (1.0 + 1e-6));
    end.balls[1].velocity.y
}

#[test]
fn a_rigid_pair_slides_or_sticks() {
    // The normal impulse per mass is (1 + e)/2; sticking takes a seventh of the slip.
    for slip in [0.01, 0.1, 0.3, 0.6, 1.0] {
        let expected = (0.06 * 0.95_f64).min(slip / 7.0);
        // The line of centres turns by up to (slip × contact time)/(2R), which is 0.005 here.
        close(thrown(Law::rigid(0.9, 0.06), slip), expected, 6e-3 * slip + PROMISED);
    }
}

/// The slip of a ball of mass 1 after a compliant wall whose lossless contact at 1 m/s takes the time
/// 1, in small steps of time.
fn stepped(slip: f64, e: f64, mu: f64, ratio: f64) -> f64 {
    let k = stiffness_of_time(1.0, 1.0);
    let step = 2e-6;
    let (mut approach, mut depth, mut slip, mut pull) = (1.0, 0.0_f64, slip, 0.0_f64);
    let mut last = 0.0_f64;
    loop {
        depth += step * approach;
        if depth <= 0.0 {
            return slip;
        }
        let root = depth.sqrt();
        let closing = k * depth * root;
        let force = if approach > 0.0 { closing } else { e * e * closing };
        if root < last {
            pull *= root / last;
        }
        last = root;
        pull += 1.25 * (2.0 / 7.0) * ratio * ratio * k * root * slip * step;
        pull = pull.clamp(-mu * force, mu * force);
        approach -= step * force;
        slip -= step * 3.5 * pull;
    }
}

#[test]
fn a_compliant_wall_returns_slip_as_in_small_steps() {
    for (slip, e, mu, ratio) in [
        (0.02, 0.9, 0.2, 1.7),
        (0.2, 0.9, 0.2, 1.7),
        (0.5, 0.5, 0.3, 1.3),
        (1.0, 1.0, 0.2, 1.9),
        (3.0, 0.7, 0.2, 1.7),
    ] {
        let mut moving = ball(0.0, 1.0);
        moving.velocity.y = slip;
        let mut network = Network { balls: vec![moving], ..Network::default() };
        let stiffness = stiffness_of_time(MASS, 1e-3);
        network.add_wall(0, Vector::x(), 0.0, stiffness, Law::compliant(e, mu, ratio));
        let end = after(&network).end().balls[0];
        let left = end.velocity.y + end.spin.z * RADIUS;
        close(left, stepped(slip, e, mu, ratio), 2.0 * PROMISED);
    }
}

#[test]
fn a_rigid_wall_stops_the_slip_or_slides() {
    for mu in [0.05, 0.2, 1.0] {
        let mut moving = ball(0.0, 1.0);
        moving.velocity.y = 1.0;
        let mut network = Network { balls: vec![moving], ..Network::default() };
        let stiffness = stiffness_of_time(MASS, 1e-3);
        network.add_wall(0, Vector::x(), 0.0, stiffness, Law::rigid(0.5, mu));
        let end = after(&network).end().balls[0];
        let lost = (1.5 * mu).min(2.0 / 7.0);
        close(end.velocity.y, 1.0 - lost, PROMISED);
        close((end.spin * RADIUS).norm(), 2.5 * lost, 2.5 * PROMISED);
    }
}

/// A cue at 3 m/s strikes a ball at rest; on a slate if `friction` is given.
fn strike(elevation: f64, side: f64, height: f64, friction: Option<f64>) -> Network {
    let (sin, cos) = elevation.sin_cos();
    let axis = Vector::new(cos, 0.0, -sin);
    let (right, up) = (Vector::new(0.0, -1.0, 0.0), Vector::new(sin, 0.0, cos));
    let inward = (1.0 - side * side - height * height).sqrt();
    let arm = right * side + up * height - axis * inward;
    let mut network = Network { balls: vec![ball(0.0, 0.0)], ..Network::default() };
    let stiffness = stiffness_of_time(MASS * CUE / (MASS + CUE), 1e-3);
    let e = tip_restitution(0.6, 0.0, 0.0);
    network.add_tip(0, SpringCue { mass: CUE, speed: 3.0 }, [axis, axis, arm], stiffness, e);
    if let Some(mu) = friction {
        let slate = stiffness_of_time(MASS, 0.5e-3);
        network.add_wall(0, -Vector::z(), 0.0, slate, Law::rigid(0.5, mu));
    }
    after(&network).end().clone()
}

#[test]
fn a_tip_alone_gives_the_speed_of_leckie_and_greenspan() {
    for (side, height) in [(0.0, 0.0), (0.3, 0.2), (0.0, -0.5)] {
        let end = strike(0.4, side, height, None).balls[0];
        let square: f64 = side * side + height * height;
        let expected = 1.6 * 3.0 / (MASS / CUE + 1.0 + 2.5 * square);
        close(end.velocity.norm(), expected, 3.0 * PROMISED);
        close(end.spin.norm() * RADIUS, 2.5 * square.sqrt() * expected, 6.0 * PROMISED);
    }
}

#[test]
fn the_direction_of_a_masse_does_not_depend_on_the_friction() {
    // TP A.19: tan θ = a sin φ/(R cos φ + b), for a = ¼R on the right and b = ¼R below the centre.
    let elevation = 75_f64.to_radians();
    for friction in [0.0, 0.2, 0.4] {
        let end = strike(elevation, 0.25, -0.25, Some(friction)).balls[0];
        let (v, w) = (end.velocity, end.spin * RADIUS);
        // What rolls at the end: 5/7 v + 2/7 Rω × ẑ; friction at the cloth does not change it.
        let (x, y) = (5.0 * v.x + 2.0 * w.y, 5.0 * v.y - 2.0 * w.x);
        let expected = (0.25 * elevation.sin()).atan2(elevation.cos() - 0.25).to_degrees();
        close((-y).atan2(x).to_degrees(), expected, 0.01);
    }
}

#[test]
fn a_cue_that_presses_a_ball_on_the_slate_holds_it_down() {
    // Taken one after another, tip and slate make the ball hop by 12 cm (e = 0.73).
    let end = strike(75_f64.to_radians(), 0.25, -0.25, Some(0.2)).balls[0];
    let hop = end.velocity.z * end.velocity.z / (2.0 * 9.806_65);
    assert!(end.velocity.z > 0.0 && hop < 0.015, "{hop}");
}

//! Balls that touch when one of them is struck: published chains, an independent integration,
//! conservation, symmetry.

use crate::near::assert_near;
use carom::math::{Vec3, cos, pow, sin, sqrt};
use carom::physics::{BallBall, BallBallModel, Physics, SlipFriction};
use carom::resolve::Body;
use carom::resolve::network::{
    NetworkImpact, NetworkScratch, Stepping, TipTouch, Touch, WallTouch, resolve,
};
use carom::resolve::{ball_ball, network};

/// Largest difference from the limit of small steps, as a fraction of the speed.
const STEPS: f64 = 9e-4;

/// Largest difference between a pair in a network and the pair's own law, as a fraction of the
/// approach speed: the law keeps the line of centres, and the network turns it with the balls.
const TURN: f64 = 8e-3;

const RADIUS: f64 = 0.028_575;
const MASS: f64 = 0.17;

fn ball(velocity: Vec3) -> Body {
    Body { velocity, angular_velocity: Vec3::ZERO, mass: MASS, radius: RADIUS }
}

fn still() -> Body {
    ball(Vec3::ZERO)
}

fn along_x(speed: f64) -> Vec3 {
    Vec3::new(speed, 0.0, 0.0)
}

fn law(model: BallBallModel, restitution: f64, friction: f64) -> BallBall {
    BallBall {
        model,
        restitution,
        friction: SlipFriction::constant(friction),
        ..Physics::pool().ball_ball
    }
}

fn elastic() -> BallBall {
    law(BallBallModel::Elastic, 1.0, 0.0)
}

/// A row along x in which each ball touches the next.
fn row(bodies: &[Body]) -> Vec<Touch> {
    let touch = |k: usize| Touch { a: k as u8, b: k as u8 + 1, normal: along_x(1.0), gap: 0.0 };
    (0..bodies.len() - 1).map(touch).collect()
}

/// The speeds after the impact of a row of equal balls, of which the first `moving` have 1 m/s.
fn cradle<const N: usize>(moving: usize) -> [f64; N] {
    let mut bodies = core::array::from_fn(|k| ball(along_x(f64::from(k < moving))));
    let touches = row(&bodies);
    assert!(resolve(&elastic(), &mut bodies, &touches));
    bodies.map(|b: Body| b.velocity.x)
}

/// The speeds from the classical Runge–Kutta method with 50 000 small steps: m v̇ = ±k δ^(3/2),
/// with any k.
fn reference(speeds: &[f64], masses: &[f64], stiffness: &[f64]) -> Vec<f64> {
    let n = speeds.len();
    let rate = |y: &[f64]| -> Vec<f64> {
        let force: Vec<f64> =
            (0..n - 1).map(|i| stiffness[i] * pow((y[i] - y[i + 1]).max(0.0), 1.5)).collect();
        let push = |i: usize| {
            let left = if i > 0 { force[i - 1] } else { 0.0 };
            left - force.get(i).copied().unwrap_or(0.0)
        };
        (0..n).map(|i| y[n + i]).chain((0..n).map(|i| push(i) / masses[i])).collect()
    };
    let ahead = |y: &[f64], k: &[f64], h: f64| -> Vec<f64> {
        y.iter().zip(k).map(|(y, k)| y + h * k).collect()
    };
    let mut y: Vec<f64> = core::iter::repeat_n(0.0, n).chain(speeds.iter().copied()).collect();
    let h = 1e-3;
    for _ in 0..50_000 {
        let k1 = rate(&y);
        let k2 = rate(&ahead(&y, &k1, 0.5 * h));
        let k3 = rate(&ahead(&y, &k2, 0.5 * h));
        let k4 = rate(&ahead(&y, &k3, h));
        for i in 0..2 * n {
            y[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
        }
    }
    y.split_off(n)
}

/// TP B.29: a ball of 1 m/s hits two in line that touch.
#[test]
fn three_balls_in_line_leave_with_the_published_speeds_of_hertz_contacts() {
    let speeds = cradle::<3>(1);
    for (ours, published) in speeds.into_iter().zip([-0.071, 0.076, 0.995]) {
        assert_near(ours, published, 1e-3);
    }
}

#[test]
fn rows_struck_by_one_or_more_balls_agree_with_an_independent_integration() {
    fn compare<const N: usize>(moving: usize) {
        let speeds: [f64; N] = core::array::from_fn(|k| f64::from(k < moving));
        let expected = reference(&speeds, &[1.0; N], &[1.0; N]);
        for (ours, expected) in cradle::<N>(moving).into_iter().zip(expected) {
            assert_near(ours, expected, STEPS);
        }
    }
    compare::<3>(1);
    compare::<5>(1);
    compare::<8>(1);
    compare::<4>(2);
    compare::<5>(2);
    compare::<6>(3);
}

#[test]
fn the_last_ball_of_a_cradle_takes_most_of_the_speed_and_the_others_separate_slowly() {
    for speeds in [cradle::<3>(1).to_vec(), cradle::<4>(1).to_vec(), cradle::<5>(1).to_vec()] {
        let last = speeds[speeds.len() - 1];
        assert!((0.988..0.996).contains(&last), "{speeds:?}");
        assert!(speeds[0] < -0.07 && speeds.is_sorted(), "{speeds:?}");
    }
}

#[test]
fn unequal_balls_agree_with_an_independent_integration() {
    let radii = [0.0254, 0.030_75, 0.023_8];
    let mut bodies =
        radii.map(|radius| Body { mass: 7e3 * radius * radius * radius, radius, ..still() });
    bodies[0].velocity = along_x(1.0);
    let masses: Vec<f64> = bodies.iter().map(|b| b.mass / bodies[0].mass).collect();
    let spring = |i: usize| sqrt(radii[i] * radii[i + 1] / (radii[i] + radii[i + 1]) / radii[0]);
    let expected = reference(&[1.0, 0.0, 0.0], &masses, &[spring(0), spring(1)]);
    let touches = row(&bodies);
    resolve(&elastic(), &mut bodies, &touches);
    for (body, expected) in bodies.iter().zip(expected) {
        assert_near(body.velocity.x, expected, STEPS);
    }
}

#[test]
fn a_narrow_gap_closes_within_the_impact_and_a_wide_one_is_left_to_a_later_impact() {
    let speeds = |gap: f64| {
        let mut bodies = [ball(along_x(1.0)), still(), still()];
        let mut touches = row(&bodies);
        touches[1].gap = gap;
        resolve(&elastic(), &mut bodies, &touches);
        bodies.map(|b| b.velocity.x)
    };
    // A contact at 1 m/s compresses the balls by about 0.1 mm.
    let (none, tiny, wide) = (speeds(0.0), speeds(1e-9), speeds(1e-3));
    assert!(none.iter().zip(tiny).all(|(a, b)| (a - b).abs() < 1e-4), "{none:?} and {tiny:?}");
    assert!(wide[0].abs() < STEPS && (wide[1] - 1.0).abs() < STEPS && wide[2] == 0.0, "{wide:?}");
    // The later the second contact begins, the closer the result is to two separate impacts: 0, 0,
    // 1.
    let between = speeds(5e-5)[1];
    assert!(between > 0.0 && between < none[1], "{between}");
}

#[test]
fn results_are_proportional_to_the_speed() {
    let speeds = |v: f64| {
        let mut bodies = [ball(along_x(v)), still(), still(), still()];
        let touches = row(&bodies);
        resolve(&law(BallBallModel::Frictional, 0.9, 0.06), &mut bodies, &touches);
        bodies.map(|b| b.velocity.x / v)
    };
    for v in [0.05, 10.0] {
        for (a, b) in speeds(1.0).into_iter().zip(speeds(v)) {
            assert_near(a, b, 1e-9);
        }
    }
}

/// Two balls that meet at an angle, spinning.
fn skew_pair(angle: f64) -> ([Body; 2], Touch) {
    let (s, c) = (sin(angle), cos(angle));
    let a = Body { angular_velocity: Vec3::new(9.0, 20.0, -15.0), ..ball(along_x(1.5)) };
    ([a, still()], Touch { a: 0, b: 1, normal: Vec3::new(c, s, 0.0), gap: 0.0 })
}

/// Differences between a pair in the network and the pair's own law, as fractions of the approach
/// speed, in the velocities of centres and surfaces.
fn difference_from_pair_law(law: &BallBall, angle: f64) -> f64 {
    let (mut ours, touch) = skew_pair(angle);
    let [mut a, mut b] = ours;
    let approach = (a.velocity - b.velocity).dot(touch.normal);
    let Physics { cloth, .. } = Physics::pool();
    ball_ball::resolve(law, &cloth, touch.normal, &mut a, &mut b);
    resolve(law, &mut ours, &[touch]);
    let of = |ours: &Body, theirs: &Body| {
        let v = (ours.velocity - theirs.velocity).length();
        v.max((ours.angular_velocity - theirs.angular_velocity).length() * RADIUS)
    };
    of(&ours[0], &a).max(of(&ours[1], &b)) / approach
}

#[test]
fn a_pair_alone_agrees_with_the_laws_restitution_and_rigid_friction() {
    for angle in [0.0, 0.2, 0.6, 1.0] {
        for e in [1.0, 0.95, 0.7, 0.3] {
            let smooth = difference_from_pair_law(&law(BallBallModel::Elastic, e, 0.0), angle);
            assert!(smooth < TURN, "e {e}, angle {angle}: {smooth}");
            for mu in [0.06, 0.3] {
                let rough = difference_from_pair_law(&law(BallBallModel::Frictional, e, mu), angle);
                assert!(rough < TURN, "e {e}, μ {mu}, angle {angle}: {rough}");
            }
        }
    }
}

#[test]
fn the_throw_of_a_compliant_pair_alone_is_close_to_that_of_its_own_law() {
    for angle in [0.1, 0.2, 0.35, 0.5, 0.8, 1.1] {
        for mu in [0.03, 0.06, 0.12] {
            let law = law(BallBallModel::Compliant, 0.95, mu);
            let difference = difference_from_pair_law(&law, angle);
            // The difference of the surfaces; that of the centres is 2/5 of it, 0.4° of throw.
            assert!(difference < 0.018, "μ {mu}, angle {angle}: {difference}");
        }
    }
}

/// Fifteen frozen balls and a cue ball that moves along y; the rack is symmetric about x = 0.
fn rack(velocity: Vec3) -> (Vec<Body>, Vec<Touch>, Vec<[f64; 2]>) {
    let mut places = vec![[0.0, -2.0 * RADIUS]];
    for line in 0..5 {
        for k in 0..=line {
            let x = RADIUS * (2.0 * f64::from(k) - f64::from(line));
            places.push([x, 2.0 * RADIUS * 0.75_f64.sqrt() * f64::from(line)]);
        }
    }
    let mut touches = Vec::new();
    for a in 0..places.len() {
        for b in a + 1..places.len() {
            let d = Vec3::new(places[b][0] - places[a][0], places[b][1] - places[a][1], 0.0);
            if d.length() < 2.0 * RADIUS + 1e-9 {
                touches.push(Touch {
                    a: a as u8,
                    b: b as u8,
                    normal: d * (1.0 / d.length()),
                    gap: 0.0,
                });
            }
        }
    }
    let mut bodies = vec![still(); places.len()];
    bodies[0].velocity = velocity;
    (bodies, touches, places)
}

fn break_law() -> BallBall {
    Physics::pool().ball_ball
}

#[test]
fn a_rack_struck_along_its_axis_breaks_symmetrically_to_the_bit() {
    let (mut bodies, touches, places) = rack(Vec3::new(0.0, 9.0, 0.0));
    assert_eq!(touches.len(), 31);
    resolve(&break_law(), &mut bodies, &touches);
    for (body, place) in bodies.iter().zip(&places) {
        let mirror = places.iter().position(|p| p[0] == -place[0] && p[1] == place[1]).unwrap();
        let image = &bodies[mirror];
        assert_eq!(body.velocity.x, -image.velocity.x);
        assert_eq!(body.velocity.y, image.velocity.y);
        assert_eq!(body.velocity.z, image.velocity.z);
        let (spin, other) = (body.angular_velocity, image.angular_velocity);
        assert_eq!([spin.x, spin.y, spin.z], [other.x, -other.y, -other.z]);
    }
}

/// TP B.20 estimates v/5 for balls without losses, with an effective mass of the rack of one and a
/// half balls: ±30 %.
#[test]
fn a_cue_ball_comes_back_from_a_frozen_rack_with_about_a_fifth_of_its_speed() {
    let speed = 13.4; // 30 mph
    for law in [elastic(), break_law()] {
        let (mut bodies, touches, _) = rack(Vec3::new(0.0, speed, 0.0));
        resolve(&law, &mut bodies, &touches);
        let back = -bodies[0].velocity.y / speed;
        assert!((0.14..0.26).contains(&back), "{back}");
        // The corner balls leave fastest, and the balls inside the rack hardly move.
        let fastest = bodies.iter().map(|b| b.velocity.length()).fold(0.0, f64::max);
        assert_eq!(fastest, bodies[11].velocity.length());
        assert!(bodies[5].velocity.length() < 0.05 * speed);
    }
}

#[test]
fn the_order_of_the_balls_and_of_their_contacts_does_not_matter() {
    let velocity = Vec3::new(0.8, 9.0, 0.0);
    let (mut bodies, touches, _) = rack(velocity);
    resolve(&break_law(), &mut bodies, &touches);
    let (other, _, _) = rack(velocity);
    let last = other.len() - 1;
    let mut other: Vec<Body> = other.into_iter().rev().collect();
    let turned: Vec<Touch> = touches
        .iter()
        .rev()
        .map(|t| Touch { a: last as u8 - t.a, b: last as u8 - t.b, ..*t })
        .map(|t| if t.a % 2 == 0 { t } else { Touch { a: t.b, b: t.a, normal: -t.normal, ..t } })
        .collect();
    resolve(&break_law(), &mut other, &turned);
    for (a, b) in bodies.iter().zip(other.iter().rev()) {
        assert_near((a.velocity - b.velocity).length(), 0.0, 1e-14);
        assert_near((a.angular_velocity - b.angular_velocity).length(), 0.0, 1e-12);
    }
}

#[test]
fn no_two_balls_of_a_broken_rack_approach_and_momentum_is_conserved() {
    for (x, y) in [(0.0, 9.0), (0.8, 9.0), (-3.0, 5.0), (0.1, 0.05)] {
        let velocity = Vec3::new(x, y, 0.0);
        let (mut bodies, touches, _) = rack(velocity);
        resolve(&break_law(), &mut bodies, &touches);
        for t in &touches {
            let (a, b) = (&bodies[usize::from(t.a)], &bodies[usize::from(t.b)]);
            let approach = (a.velocity - b.velocity).dot(t.normal);
            assert!(approach <= 2e-9 * y, "{} and {}: {approach:e}", t.a, t.b);
        }
        let momentum = bodies.iter().fold(Vec3::ZERO, |sum, b| sum + b.velocity);
        assert_near((momentum - velocity).length(), 0.0, 1e-13);
        let energy = |b: &Body| {
            let surface = b.angular_velocity * b.radius;
            0.5 * b.velocity.length_squared() + 0.2 * surface.length_squared()
        };
        let left: f64 = bodies.iter().map(energy).sum();
        assert!(left <= 0.5 * velocity.length_squared());
    }
}

#[test]
fn balls_that_the_impact_does_not_reach_keep_their_bits() {
    let mut bodies = [ball(along_x(-1.0)), still(), still()];
    bodies[2] = Body { angular_velocity: Vec3::new(0.1, 0.2, 0.3), ..ball(along_x(3.0)) };
    let (touches, last) = (row(&bodies), bodies[2]);
    assert!(!resolve(&elastic(), &mut bodies, &touches));
    bodies[0].velocity = along_x(0.5);
    assert!(resolve(&elastic(), &mut bodies, &touches));
    assert_eq!(bodies[2], last);
}

#[test]
fn friction_throws_the_second_ball_of_a_frozen_combination() {
    // The cue ball hits the first ball at an angle to the line of centres of the frozen pair.
    let throw = |mu: f64| {
        let angle = 0.5;
        let mut bodies = [ball(along_x(1.0)), still(), still()];
        let touches = [
            Touch { a: 0, b: 1, normal: along_x(1.0), gap: 0.0 },
            Touch { a: 1, b: 2, normal: Vec3::new(cos(angle), sin(angle), 0.0), gap: 0.0 },
        ];
        resolve(&law(BallBallModel::Compliant, 0.95, mu), &mut bodies, &touches);
        let v = bodies[2].velocity;
        angle - carom::math::atan2(v.y, v.x)
    };
    // While the balls touch, their line of centres turns by a thousandth of a radian.
    assert_near(throw(0.0), 0.0, 2e-3);
    assert!(throw(0.06) > 0.03 && throw(0.06) < 0.07, "{}", throw(0.06));
}

#[test]
fn more_contacts_than_fit_are_left_to_the_next_impact() {
    let mut bodies = vec![still(); network::MAX_BODIES];
    bodies[0].velocity = along_x(1.0);
    let first = Touch { a: 0, b: 1, normal: along_x(1.0), gap: 0.0 };
    let idle = Touch { a: 2, b: 3, normal: along_x(1.0), gap: 0.0 };
    let mut touches = vec![first; 1];
    touches.resize(network::MAX_CONTACTS + 5, idle);
    assert!(resolve(&elastic(), &mut bodies, &touches));
    assert_near(bodies[1].velocity.x, 1.0, STEPS);
}

/// A strike at 30° with English, on a ball that the slate supports.
fn raised_strike() -> (TipTouch, WallTouch) {
    let axis = Vec3::new(sqrt(0.75), 0.0, -0.5);
    let arm = Vec3::new(0.1, 0.3, 0.1) - axis * 0.9;
    let tip = TipTouch {
        ball: 0,
        cue_mass: 0.54,
        cue_speed: 3.0,
        launch: axis,
        twist: arm.cross(axis),
        stiffness: network::stiffness_of_time(0.13, 1e-3),
        restitution: 0.73,
    };
    let slate = WallTouch {
        ball: 0,
        normal: Vec3::new(0.0, 0.0, -1.0),
        stiffness: network::stiffness_of_time(MASS, 0.5e-3),
        restitution: 0.5,
        friction: 0.2,
        frequency_ratio: None,
    };
    (tip, slate)
}

#[test]
fn a_strike_beside_an_idle_ball_gives_what_the_same_strike_alone_gives() {
    let (tip, slate) = raised_strike();
    let law = break_law();
    let impact = NetworkImpact { law: &law, touches: &[], walls: &[slate], tip: Some(tip) };
    let mut alone = [still()];
    let mut beside = [still(), still()];
    let mut scratch = NetworkScratch::default();
    let first = impact.resolve(&mut alone, &mut scratch);
    let second = impact.resolve(&mut beside, &mut scratch);
    let near = |a: Vec3, b: Vec3| (a - b).length() < 1e-11 * a.length();
    assert!(near(alone[0].velocity, beside[0].velocity));
    assert!(near(alone[0].angular_velocity, beside[0].angular_velocity));
    assert_eq!(beside[1].velocity, Vec3::ZERO);
    assert_eq!(first.map(|report| report.contacts), second.map(|report| report.contacts));
}

#[test]
fn the_error_of_a_strike_on_the_slate_falls_with_the_second_power_of_the_step() {
    let (tip, slate) = raised_strike();
    let law = break_law();
    let impact = NetworkImpact { law: &law, touches: &[], walls: &[slate], tip: Some(tip) };
    let play = |steps: f64| {
        let mut bodies = [still()];
        impact.resolve_in_steps(&mut bodies, &Stepping::new(steps));
        bodies[0].velocity
    };
    let exact = play(4096.0);
    let error = |steps: f64| (play(steps) - exact).length() / exact.length();
    assert!(error(24.0) < 1e-3, "{}", error(24.0));
    assert!(error(256.0) < 1e-5, "{}", error(256.0));
}

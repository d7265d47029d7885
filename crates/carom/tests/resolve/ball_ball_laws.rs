//! Laws that every model of a collision of two balls obeys: energy, momentum, angular momentum
//! about the contact, symmetry. The inputs are pseudo-random and the same in every run.

use std::sync::LazyLock;

use crate::near::assert_near;
use crate::random::Random;
use carom::Physics;
use carom::math::{Vec2, Vec3, exp, sin_cos, sqrt};
use carom::physics::{BallBall, BallBallModel, Cloth, SlipFriction};
use carom::resolve::ball_ball;
use carom::resolve::network::{self, Touch};
use carom::resolve::{Body, ball_slate};

static CLOTH: LazyLock<Cloth> =
    LazyLock::new(|| Cloth { sliding_friction: 0.2, ..Physics::pool().cloth });
const GRAVITY: f64 = 9.81;
const IMPACTS: u32 = 100_000;

struct RandomImpact {
    law: BallBall,
    normal: Vec3,
    a: Body,
    b: Body,
}

impl RandomImpact {
    /// Balls of any size, with speeds from 1e-6 to 10 m/s, most of them spinning.
    fn random(random: &mut Random, model: BallBallModel) -> Self {
        let mut ball = |alike: bool| {
            let size = exp(random.between(-14.0, 2.3));
            let spin = if random.pick(5) == 0 { 0.0 } else { size * 60.0 };
            let velocity = random.vector(size);
            let angular_velocity = random.vector(spin);
            let (mass, radius) = if alike {
                (0.17, 0.028575)
            } else {
                (random.between(0.02, 0.5), random.between(0.01, 0.06))
            };
            Body { velocity, angular_velocity, mass, radius }
        };
        let (first, second) = (ball(true), ball(true));
        let (mut a, mut b) = if random.pick(2) == 0 {
            (first, second)
        } else {
            let mut other = |body: Body| Body {
                mass: random.between(0.02, 0.5),
                radius: random.between(0.01, 0.06),
                ..body
            };
            (other(first), other(second))
        };
        match random.pick(4) {
            0 => b = Body { velocity: Vec3::ZERO, angular_velocity: Vec3::ZERO, ..b },
            1 => a = Body { velocity: Vec3::ZERO, angular_velocity: Vec3::ZERO, ..a },
            _ => {}
        }
        // On the bed or anywhere, including one directly above the other.
        let on_bed = random.pick(2) == 0;
        if on_bed {
            (a.velocity.z, b.velocity.z) = (0.0, 0.0);
        }
        let normal = Self::normal(random, on_bed, &a, &b);
        let mut law = BallBall { model, ..Physics::pool().ball_ball };
        law.restitution = if random.pick(3) == 0 { 1.0 } else { random.between(0.0, 1.0) };
        law.friction = SlipFriction {
            a: random.between(0.0, 0.3),
            b: random.between(0.0, 0.3),
            c: random.between(0.0, 2.0),
        };
        law.frequency_ratio = random.between(1.0, 2.0);
        Self { law, normal, a, b }
    }

    /// A line of centres along which the balls approach.
    fn normal(random: &mut Random, on_bed: bool, a: &Body, b: &Body) -> Vec3 {
        let mut d = Vec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), 0.0);
        if on_bed {
            let tilt = (b.radius - a.radius) / (a.radius + b.radius);
            let level = sqrt(1.0 - tilt * tilt) / d.length();
            d = (d.xy() * level).with_z(tilt);
            // With the opposite sign it still rises to the larger ball.
            if (a.velocity - b.velocity).dot(d) < 0.0 {
                d = (-d.xy()).with_z(tilt);
            }
            return d;
        }
        if random.pick(10) == 0 {
            d = Vec3::ZERO;
        }
        d.z = random.between(-1.0, 1.0);
        let sign = if (a.velocity - b.velocity).dot(d) < 0.0 { -1.0 } else { 1.0 };
        d * (sign / d.length())
    }

    fn resolve(&self) -> (Body, Body) {
        let (mut a, mut b) = (self.a, self.b);
        ball_ball::resolve(&self.law, &CLOTH, self.normal, &mut a, &mut b);
        (a, b)
    }

    fn speeds(&self) -> f64 {
        self.a.velocity.length()
            + self.b.velocity.length()
            + self.a.radius * self.a.angular_velocity.length()
            + self.b.radius * self.b.angular_velocity.length()
    }
}

fn energy(ball: &Body) -> f64 {
    let surface = ball.angular_velocity * ball.radius;
    0.5 * ball.mass * ball.velocity.length_squared() + 0.2 * ball.mass * surface.length_squared()
}

fn every_impact(check: impl Fn(&RandomImpact, Body, Body)) {
    for (seed, model) in BallBallModel::ALL.into_iter().enumerate() {
        let mut random = Random(1 + seed as u64);
        // Integrated collisions take a hundred times longer.
        let impacts = if model == BallBallModel::Mathavan2014 { IMPACTS / 25 } else { IMPACTS };
        for _ in 0..impacts {
            let impact = RandomImpact::random(&mut random, model);
            let (a, b) = impact.resolve();
            check(&impact, a, b);
        }
    }
}

fn assert_energy_does_not_rise(impact: &RandomImpact, a: &Body, b: &Body) {
    let before = energy(&impact.a) + energy(&impact.b);
    let after = energy(a) + energy(b);
    assert!(
        after <= before * (1.0 + 1e-14),
        "{:?}: {before:e} J, then {after:e} J, {:e}",
        impact.law,
        after / before - 1.0
    );
}

#[test]
fn energy_never_rises() {
    every_impact(|impact, a, b| assert_energy_does_not_rise(impact, &a, &b));
}

#[test]
#[ignore = "a minute; make stress"]
fn energy_never_rises_in_a_hundred_thousand_integrated_impacts() {
    let mut random = Random(5);
    for _ in 0..IMPACTS {
        let impact = RandomImpact::random(&mut random, BallBallModel::Mathavan2014);
        let (a, b) = impact.resolve();
        assert_energy_does_not_rise(&impact, &a, &b);
    }
}

#[test]
fn an_elastic_impact_conserves_energy_for_balls_of_any_size() {
    let mut random = Random(7);
    for _ in 0..IMPACTS {
        let mut impact = RandomImpact::random(&mut random, BallBallModel::Elastic);
        impact.law.restitution = 1.0;
        let (a, b) = impact.resolve();
        let before = energy(&impact.a) + energy(&impact.b);
        assert_near((energy(&a) + energy(&b)) / before, 1.0, 1e-14);
    }
}

/// Whether friction of the cloth takes part in the impact.
fn on_cloth(impact: &RandomImpact) -> bool {
    impact.law.model == BallBallModel::Mathavan2014
        && impact.normal.z == 0.0
        && impact.a.velocity.z == 0.0
        && impact.b.velocity.z == 0.0
}

#[test]
fn restitution_holds_along_the_normal() {
    every_impact(|impact, a, b| {
        let approach = |a: &Body, b: &Body| (a.velocity - b.velocity).dot(impact.normal);
        let (before, after) = (approach(&impact.a, &impact.b), approach(&a, &b));
        assert!(after <= 2e-15 * impact.speeds(), "{:?}: still approach at {after:e}", impact.law);
        if !on_cloth(impact) {
            let e = carom::resolve::restitution::effective(impact.law.restitution, before);
            assert_near(after + e * before, 0.0, 4e-15 * impact.speeds());
        }
    });
}

#[test]
fn mathavan_2014_keeps_balls_on_the_cloth_and_is_a_rigid_impulse_off_it() {
    every_impact(|impact, a, b| {
        if on_cloth(impact) {
            assert_eq!((a.velocity.z, b.velocity.z), (0.0, 0.0));
        } else if impact.law.model == BallBallModel::Mathavan2014 {
            let law = BallBall { model: BallBallModel::Frictional, ..impact.law };
            assert_eq!(RandomImpact { law, ..*impact }.resolve(), (a, b));
        }
    });
}

#[test]
fn momentum_is_conserved_without_friction_of_the_cloth() {
    every_impact(|impact, a, b| {
        if on_cloth(impact) {
            return;
        }
        let momentum = |a: &Body, b: &Body| a.velocity * a.mass + b.velocity * b.mass;
        let change = momentum(&a, &b) - momentum(&impact.a, &impact.b);
        let scale = (impact.a.mass + impact.b.mass) * impact.speeds();
        assert_near(change.length(), 0.0, 1e-15 * scale);
    });
}

#[test]
fn each_balls_angular_momentum_about_the_contact_is_conserved() {
    every_impact(|impact, a, b| {
        if on_cloth(impact) {
            return;
        }
        for (before, after, sign) in [(&impact.a, &a, 1.0), (&impact.b, &b, -1.0)] {
            // The centre lies at −R·n from the contact for a, +R·n for b.
            let arm = impact.normal * (-sign * before.radius);
            let inertia = 0.4 * before.mass * before.radius * before.radius;
            let change = arm.cross((after.velocity - before.velocity) * before.mass)
                + (after.angular_velocity - before.angular_velocity) * inertia;
            let scale = before.mass * before.radius * impact.speeds();
            assert_near(change.length(), 0.0, 1e-14 * scale);
        }
    });
}

#[test]
fn friction_opposes_the_slip_and_stays_within_coulombs_bound() {
    every_impact(|impact, a, b| {
        if on_cloth(impact) {
            return;
        }
        let n = impact.normal;
        let surface = |ball: &Body, arm: Vec3| ball.velocity + ball.angular_velocity.cross(arm);
        let slip = |a: &Body, b: &Body| {
            let u = surface(a, n * a.radius) - surface(b, n * -b.radius);
            u - n * u.dot(n)
        };
        let before = slip(&impact.a, &impact.b);
        let push = (b.velocity - impact.b.velocity) * b.mass;
        let along = push.dot(n);
        let friction = push - n * along;
        let scale = impact.speeds();
        let rounding = 1e-14 * (a.mass + b.mass) * scale;
        assert!(friction.cross(before).length() <= rounding * scale);
        assert!(friction.dot(before) >= -rounding * scale);
        let mu = impact.law.friction.at(before.length());
        assert!(friction.length() <= mu * along + rounding, "{:?}", impact.law);
        // With rigid surfaces the slip keeps its direction or ends.
        let left = slip(&a, &b);
        if impact.law.model == BallBallModel::Frictional {
            assert!(left.dot(before) >= -1e-14 * scale * scale);
        }
        assert!(left.length() <= before.length() + 1e-14 * scale);
    });
}

#[test]
fn turning_the_whole_impact_about_the_vertical_turns_the_result() {
    let mut random = Random(13);
    for model in BallBallModel::ALL {
        let impacts = if model == BallBallModel::Mathavan2014 { IMPACTS / 100 } else { IMPACTS };
        for _ in 0..impacts {
            let impact = RandomImpact::random(&mut random, model);
            let (s, c) = sin_cos(random.between(0.0, core::f64::consts::TAU));
            let turn = |v: Vec3| Vec3::new(v.x * c - v.y * s, v.x * s + v.y * c, v.z);
            let turned = |ball: Body| Body {
                velocity: turn(ball.velocity),
                angular_velocity: turn(ball.angular_velocity),
                ..ball
            };
            let image = RandomImpact {
                law: impact.law,
                normal: turn(impact.normal),
                a: turned(impact.a),
                b: turned(impact.b),
            };
            let (a, b) = impact.resolve();
            let (p, q) = image.resolve();
            // Integrated impacts are converged to 1e-9 of the speeds, not to rounding.
            let tolerance = if on_cloth(&impact) { 1e-9 } else { 1e-13 };
            for (ours, theirs) in [(turned(a), p), (turned(b), q)] {
                let gap = (ours.velocity - theirs.velocity).length()
                    + ours.radius * (ours.angular_velocity - theirs.angular_velocity).length();
                assert_near(gap, 0.0, tolerance * impact.speeds());
            }
        }
    }
}

#[test]
fn the_result_changes_smoothly_as_the_line_of_centres_tilts() {
    /// Tilt, rad.
    const STEP: f64 = 1e-7;
    let mut random = Random(17);
    for model in BallBallModel::ALL.into_iter().filter(|model| !model.traits().cloth) {
        for _ in 0..IMPACTS / 10 {
            let mut impact = RandomImpact::random(&mut random, model);
            let level = impact.normal.xy();
            if level == Vec2::ZERO {
                continue;
            }
            let level = level * (1.0 / level.length());
            let after = [-STEP, 0.0, STEP].map(|tilt| {
                impact.normal = level.with_z(tilt);
                impact.resolve()
            });
            // If they hardly approach, a tilt decides whether they meet.
            let approach = (impact.a.velocity - impact.b.velocity).xy().dot(level);
            if approach.abs() < 1e-5 * impact.speeds() {
                continue;
            }
            for pair in after.windows(2) {
                for (p, q) in [(pair[0].0, pair[1].0), (pair[0].1, pair[1].1)] {
                    let gap = (p.velocity - q.velocity).length()
                        + p.radius * (p.angular_velocity - q.angular_velocity).length();
                    // Coefficients of friction change with the speed; the relative change is at
                    // most a few thousand per radian.
                    assert!(gap <= 1e4 * STEP * impact.speeds(), "{:?}: {gap:e}", impact.law);
                }
            }
        }
    }
}

#[test]
fn english_pools_unequal_balls_still_separate_after_the_slate_has_acted() {
    let mut random = Random(19);
    let english = carom::Physics::english();
    let sizes = [(0.116, 0.0254), (0.094, 0.0238)];
    for model in BallBallModel::ALL {
        let law = BallBall { model, ..english.ball_ball };
        for _ in 0..IMPACTS / 10 {
            let speed = exp(random.between(-9.0, 2.3));
            let mut ball = |(mass, radius): (f64, f64)| Body {
                velocity: Vec3 { z: 0.0, ..random.vector(speed) },
                angular_velocity: random.vector(2.0 * speed / radius),
                mass,
                radius,
            };
            let (mut a, mut b) = (ball(sizes[0]), ball(sizes[1]));
            let normal = RandomImpact::normal(&mut random, true, &a, &b);
            let before = (a.velocity - b.velocity).dot(normal);
            ball_ball::resolve(&law, &CLOTH, normal, &mut a, &mut b);
            for ball in [&mut a, &mut b] {
                ball_slate::settle(&english.slate, GRAVITY, ball);
            }
            let parting = (b.velocity - a.velocity).dot(normal);
            assert!(parting > 0.5 * before, "{model:?}: {before} then {parting}");
        }
    }
}

#[test]
fn a_mirrored_impact_gives_the_mirrored_result_to_the_bit() {
    let flip = |v: Vec3| Vec3 { x: -v.x, ..v };
    let turn = |w: Vec3| Vec3 { y: -w.y, z: -w.z, ..w };
    let mirror = |ball: Body| Body {
        velocity: flip(ball.velocity),
        angular_velocity: turn(ball.angular_velocity),
        ..ball
    };
    every_impact(|impact, a, b| {
        let image = RandomImpact {
            law: impact.law,
            normal: flip(impact.normal),
            a: mirror(impact.a),
            b: mirror(impact.b),
        };
        assert_eq!(image.resolve(), (mirror(a), mirror(b)), "{:?}", impact.law);
    });
}

#[test]
fn exchanging_the_balls_exchanges_the_results_to_the_bit() {
    every_impact(|impact, a, b| {
        let exchanged =
            RandomImpact { law: impact.law, normal: -impact.normal, a: impact.b, b: impact.a };
        assert_eq!(exchanged.resolve(), (b, a), "{:?}", impact.law);
    });
}

#[test]
fn a_networks_energy_never_rises_and_its_momentum_is_conserved() {
    let mut random = Random(11);
    for _ in 0..IMPACTS / 4 {
        let model = BallBallModel::ALL[random.pick(BallBallModel::ALL.len())];
        let size = 3 + random.pick(4);
        let mut bodies: Vec<Body> =
            (0..size).map(|_| RandomImpact::random(&mut random, model).a).collect();
        let law = RandomImpact::random(&mut random, model).law;
        let mut contacts = Vec::new();
        for j in 1..size {
            for _ in 0..1 + random.pick(2) {
                let i = random.pick(j);
                let normal = RandomImpact::normal(&mut random, false, &bodies[i], &bodies[j]);
                contacts.push(Touch { a: i as u8, b: j as u8, normal, gap: 0.0 });
            }
        }
        let energy_of = |bodies: &[Body]| -> f64 { bodies.iter().map(energy).sum() };
        let momentum =
            |bodies: &[Body]| bodies.iter().fold(Vec3::ZERO, |sum, b| sum + b.velocity * b.mass);
        let (before, push) = (energy_of(&bodies), momentum(&bodies));
        let old = bodies.clone();
        network::resolve(&law, &mut bodies, &contacts);
        let after = energy_of(&bodies);
        assert!(after <= before * (1.0 + 1e-13), "{law:?}: {before:e} then {after:e}");
        let scale: f64 = old.iter().map(|b| b.mass * b.velocity.length()).sum();
        assert_near((momentum(&bodies) - push).length(), 0.0, 1e-12 * scale);
    }
}

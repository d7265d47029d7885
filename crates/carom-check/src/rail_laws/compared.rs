//! The judge's laws and the engine's give the same motion, although they are computed in different
//! ways.

use std::sync::LazyLock;

use carom::Physics;
use carom::math::{Vec3, sqrt};
use carom::physics::{Cloth, Cushion, CushionFriction, CushionModel, CushionRestitution};
use carom::resolve::{Body, ball_cushion};

use super::{RailImpact, Rebound};
use crate::random::Random;

const RADIUS: f64 = 0.03;
const ROUNDING: f64 = 1e-12;

/// Random impacts of each model.
const IMPACTS: usize = 2000;

static CLOTH: LazyLock<Cloth> =
    LazyLock::new(|| Cloth { sliding_friction: 0.2, ..Physics::pool().cloth });

/// A random law of `model`, within and beyond the published parameters.
fn law(random: &mut Random, model: CushionModel) -> Cushion {
    let mut law = Cushion { model, ..Physics::pool().cushion };
    law.restitution = CushionRestitution {
        a: random.between(0.0, 1.0),
        b: random.between(-0.1, 0.1),
        c: random.between(-0.02, 0.02),
        lowest: random.between(0.0, 0.5),
        highest: random.between(0.5, 1.0),
    };
    law.friction = CushionFriction { a: random.between(0.0, 0.6), b: random.between(-0.2, 0.2) };
    law.frequency_ratio = random.between(1.05, 1.95);
    law.tangential_factor = random.between(0.0, 1.0);
    law.spin_factor = random.between(0.0, 1.0);
    law
}

/// A ball that slides or rolls into a rail, with noses below and above its centre.
fn impact(random: &mut Random) -> RailImpact {
    let sin = random.between(-0.2, 0.5);
    let speed = random.log_uniform(1e-4, 10.0);
    let velocity = Vec3::new(speed, speed * random.between(-3.0, 3.0), 0.0);
    let surface = if random.chance(0.3) {
        Vec3::new(-velocity.y, velocity.x, speed * random.between(-2.0, 2.0))
    } else {
        Vec3::from([(); 3].map(|()| speed * random.between(-3.0, 3.0)))
    };
    RailImpact { sin, cos: sqrt(1.0 - sin * sin), velocity, surface }
}

/// The engine's result.
fn engine(law: &Cushion, impact: &RailImpact) -> Rebound {
    let mut body = Body {
        velocity: impact.velocity,
        angular_velocity: impact.surface * (1.0 / RADIUS),
        mass: 0.2,
        radius: RADIUS,
    };
    let normal = Vec3::new(impact.cos, 0.0, impact.sin);
    ball_cushion::resolve(law, &CLOTH, normal, true, &mut body);
    let surface = body.angular_velocity * RADIUS;
    Rebound { velocity: body.velocity, surface, accuracy: 0.0 }
}

/// The largest difference of the two, as a fraction of the allowed one.
fn largest_difference(model: CushionModel) -> f64 {
    let mut random = Random::new(7);
    let mut largest = 0.0_f64;
    for _ in 0..IMPACTS {
        let law = law(&mut random, model);
        let impact = impact(&mut random);
        let (ours, theirs) = (impact.rebound(&law, &CLOTH), engine(&law, &impact));
        let rounding = ROUNDING * (impact.velocity.length() + impact.surface.length());
        let allowed = ours.accuracy + rounding;
        let moved = (ours.velocity - theirs.velocity).length() / allowed;
        let turned = (ours.surface - theirs.surface).length() / (2.5 * allowed);
        largest = largest.max(moved).max(turned);
    }
    println!("{model:?}: {largest}");
    largest
}

#[test]
fn laws_in_closed_form_agree_to_rounding() {
    for model in [CushionModel::Restitution, CushionModel::Factors, CushionModel::Han2005] {
        assert!(largest_difference(model) < 1.0, "{model:?}");
    }
}

#[test]
fn springs_in_small_steps_agree_with_stronges_closed_form() {
    assert!(largest_difference(CushionModel::Stronge) < 1.0);
}

#[test]
fn mathavans_equations_in_small_steps_agree_with_the_engine() {
    assert!(largest_difference(CushionModel::Mathavan2010) < 1.0);
}

//! Cushion impacts compared with pooltool 0.6.0, on its own 7-ft table (facts in
//! `data/cushion_pooltool.json`).
//!
//! Only the impacts are compared, with pooltool's normal. Differences:
//!
//! * It finds the impact with a vertical plane through the nose, so at a rail its ball is at the
//!   horizontal distance R from the nose. The normal of its Stronge model is the direction from the
//!   nose line to the ball's centre, sin θ = (h − R)/√(R² + (h − R)²) instead of (h − R)/R; at a
//!   jaw it is the direction from the *centre* of the jaw's arc, which is even flatter. Its Han and
//!   Mathavan models use (h − R)/R.
//! * Its Mathavan model has steps of impulse of 1e-3 N·s, 6 mm/s of the ball's speed, and at most
//!   1000 of them in a phase.
//! * All its models first move the ball 1 µm away; the directions here are those after this move.
//! * All its models set the vertical velocity after the impact to 0.

use carom::Physics;
use carom::math::{Vec2, Vec3, sqrt};
use carom::physics::{Cloth, Cushion, CushionFriction, CushionModel, CushionRestitution};
use carom::resolve::{Body, ball_cushion::resolve};
use serde_json::Value;

fn numbers<const N: usize>(v: &Value) -> [f64; N] {
    core::array::from_fn(|i| v[i].as_f64().expect("a number"))
}

/// The largest difference over the impacts of one kind, m/s (spins times the radius).
fn largest_difference(data: &Value, kind: &str, name: &str, model: CushionModel, e: f64) -> f64 {
    let f = |key: &str| data[key].as_f64().expect("a number");
    let (mass, radius) = (data["ball"]["m"].as_f64(), data["ball"]["R"].as_f64());
    let (mass, radius) = (mass.expect("m"), radius.expect("R"));
    let law = Cushion {
        model,
        restitution: CushionRestitution::constant(e),
        friction: CushionFriction { a: f("f_c"), b: 0.0 },
        frequency_ratio: 1.7,
        ..Physics::pool().cushion
    };
    let cloth = Cloth { sliding_friction: f("u_s"), ..Physics::pool().cloth };
    let nose = f("cushion_height") - radius;
    let mut largest: f64 = 0.0;
    for sample in data[kind].as_array().expect("samples") {
        let [x, y] = numbers(&sample["into"]);
        let [vx, vy, wx, wy, wz] = numbers(&sample["in"]);
        let mut ball = Body {
            velocity: Vec3::new(vx, vy, 0.0),
            angular_velocity: Vec3::new(wx, wy, wz),
            mass,
            radius,
        };
        let across = if model == CushionModel::Stronge {
            let [distance] = numbers(&serde_json::json!([sample["distance"]]));
            nose / Vec2::new(distance, nose).length()
        } else {
            nose / radius
        };
        let level = sqrt(1.0 - across * across);
        resolve(&law, &cloth, Vec3::new(x * level, y * level, across), true, &mut ball);
        let [vx, vy, wx, wy, wz] = numbers(&sample[name]);
        let off = (ball.velocity.xy() - Vec2::new(vx, vy)).length()
            + radius * (ball.angular_velocity - Vec3::new(wx, wy, wz)).length();
        largest = largest.max(off);
    }
    largest
}

fn data() -> Value {
    serde_json::from_str(include_str!("../data/cushion_pooltool.json")).expect("JSON")
}

/// Each number is stored with 12 digits.
const STORED: f64 = 1e-10;

#[test]
fn a_reflection_agrees_with_pooltools_unrealistic_cushion() {
    for kind in ["linear", "circular"] {
        let off = largest_difference(&data(), kind, "unrealistic", CushionModel::Restitution, 1.0);
        assert!(off < STORED, "{kind}: {off:e}");
    }
}

#[test]
fn han_2005_agrees_with_pooltools() {
    for kind in ["linear", "circular"] {
        let off = largest_difference(&data(), kind, "han_2005", CushionModel::Han2005, 0.85);
        assert!(off < STORED, "{kind}: {off:e}");
    }
}

#[test]
fn stronge_agrees_with_pooltools() {
    /// pooltool's search for the root ends early, m/s.
    const SEARCHED: f64 = 1e-7;
    for kind in ["linear", "circular"] {
        let off =
            largest_difference(&data(), kind, "stronge_compliant", CushionModel::Stronge, 0.85);
        assert!(off < SEARCHED, "{kind}: {off:e}");
    }
}

#[test]
fn mathavan_2010_agrees_with_pooltools_within_its_steps() {
    /// Three of its steps, m/s: compression and restitution end up to one step late, and the
    /// friction of a step has the direction at its start.
    const COARSE: f64 = 3.0 * 1e-3 / 0.170_097;
    for kind in ["linear", "circular"] {
        let off =
            largest_difference(&data(), kind, "mathavan_2010", CushionModel::Mathavan2010, 0.85);
        assert!(off < COARSE, "{kind}: {off:e}");
    }
}

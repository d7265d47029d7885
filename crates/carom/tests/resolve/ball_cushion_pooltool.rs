//! Cushion impacts beside pooltool 0.6.0's, on its own 7-ft table (facts in
//! `data/cushion_pooltool.json`).
//!
//! Compared is the resolution alone, with the normal that pooltool gives it. Where it differs:
//!
//! * It finds the impact with a vertical plane through the nose, so at a rail its ball is R from
//!   the nose horizontally. Its Stronge model then takes the direction from the nose line to the
//!   ball's centre for the normal, sin θ = (h − R)/√(R² + (h − R)²) instead of (h − R)/R, and at a
//!   jaw the direction from the *centre* of the jaw's arc, which is flatter still; its Han and
//!   Mathavan models take (h − R)/R.
//! * Its Mathavan model steps the impulse by 1e-3 N·s, 6 mm/s of the ball's speed, and at most
//!   1000 times a phase.
//! * All its models put the ball 1 µm away first; the directions here are those from there.
//!
//! * All its models drop the vertical velocity after the impact.
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
        restitution: CushionRestitution { a: e, b: 0.0, c: 0.0 },
        friction: CushionFriction { a: f("f_c"), b: 0.0 },
        frequency_ratio: 1.7,
        tangential_factor: 1.0,
        spin_factor: 1.0,
    };
    let cloth =
        Cloth { sliding_friction: f("u_s"), rolling_friction: 0.01, spin_deceleration: 10.9 };
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

/// 12 digits are stored of each number.
const STORED: f64 = 1e-10;

#[test]
fn a_reflection_is_pooltools_unrealistic_cushion() {
    for kind in ["linear", "circular"] {
        let off = largest_difference(&data(), kind, "unrealistic", CushionModel::Restitution, 1.0);
        assert!(off < STORED, "{kind}: {off:e}");
    }
}

#[test]
fn han_2005_is_pooltools() {
    for kind in ["linear", "circular"] {
        let off = largest_difference(&data(), kind, "han_2005", CushionModel::Han2005, 0.85);
        assert!(off < STORED, "{kind}: {off:e}");
    }
}

#[test]
fn stronge_is_pooltools() {
    /// pooltool's root search ends early; m/s.
    const SEARCHED: f64 = 1e-7;
    for kind in ["linear", "circular"] {
        let off =
            largest_difference(&data(), kind, "stronge_compliant", CushionModel::Stronge, 0.85);
        assert!(off < SEARCHED, "{kind}: {off:e}");
    }
}

#[test]
fn mathavan_2010_is_pooltools_to_its_own_steps() {
    /// Three of its steps, m/s: compression and restitution end up to a step late, and the
    /// friction of a step has the direction of its start.
    const COARSE: f64 = 3.0 * 1e-3 / 0.170_097;
    for kind in ["linear", "circular"] {
        let off =
            largest_difference(&data(), kind, "mathavan_2010", CushionModel::Mathavan2010, 0.85);
        assert!(off < COARSE, "{kind}: {off:e}");
    }
}

//! The time of one impact on a cushion, for each model.
//!
//! `cargo run --release -p carom --example ball_cushion_cost`

use carom::Physics;
use carom::math::{Vec3, sin_cos, sqrt};
use carom::physics::CushionModel;
use carom::resolve::{Body, ball_cushion::resolve};
use std::hint::black_box;
use std::time::Instant;

fn main() {
    let pool = Physics::pool();
    // Angles from perpendicular to grazing, sliding and rolling, with and without sidespin.
    let balls: Vec<Body> = (0..240)
        .map(|i| {
            let (sin, cos) = sin_cos(f64::from(i % 16) * 0.09);
            let rolling = f64::from(i % 3) / 2.0;
            let velocity = Vec3::new(cos, sin, 0.0) * (0.3 + 0.2 * f64::from(i % 11));
            let spin = velocity.xy().perp() * (rolling / pool.ball.radius);
            Body {
                velocity,
                angular_velocity: spin.with_z(f64::from(i % 5 - 2) * 20.0),
                mass: pool.ball.mass,
                radius: pool.ball.radius,
            }
        })
        .collect();
    let nose = Vec3::new(sqrt(1.0 - 0.27 * 0.27), 0.0, 0.27);
    for model in CushionModel::ALL {
        let law = carom::physics::Cushion { model, ..pool.cushion };
        let passes = if model == CushionModel::Mathavan2010 { 40 } else { 4000 };
        let best = (0..9)
            .map(|_| {
                let start = Instant::now();
                for _ in 0..passes {
                    for ball in &balls {
                        let mut ball = *black_box(ball);
                        resolve(&law, &pool.cloth, nose, true, &mut ball);
                        black_box(ball);
                    }
                }
                start.elapsed().as_secs_f64() / f64::from(passes) / balls.len() as f64
            })
            .fold(f64::INFINITY, f64::min);
        println!("{model:?}: {:.1} ns", best * 1e9);
    }
}

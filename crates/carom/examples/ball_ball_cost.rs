//! The time of one impact of two equal balls on the cloth, for each model.
//!
//! `cargo run --release -p carom --example ball_ball_cost`

use carom::Physics;
use carom::math::{Vec3, sin_cos};
use carom::physics::{BallBall, BallBallModel};
use carom::resolve::{Body, ball_ball::resolve};
use std::hint::black_box;
use std::time::Instant;

fn main() {
    let pool = Physics::pool();
    // Full to grazing hits, sliding and rolling, with and without sidespin.
    let hits: Vec<(Vec3, Body)> = (0..240)
        .map(|i| {
            let (sin, cos) = sin_cos(f64::from(i % 16) * 0.09);
            let rolling = f64::from(i % 3) / 2.0;
            let velocity = Vec3::new(0.0, 0.3 + 0.2 * f64::from(i % 11), 0.0);
            let spin = velocity.xy().perp() * (rolling / pool.ball.radius);
            let body = Body {
                velocity,
                angular_velocity: spin.with_z(f64::from(i % 5 - 2) * 20.0),
                mass: pool.ball.mass,
                radius: pool.ball.radius,
            };
            (Vec3::new(sin, cos, 0.0), body)
        })
        .collect();
    for model in BallBallModel::ALL {
        let law = BallBall { model, ..pool.ball_ball };
        let passes = if model == BallBallModel::Mathavan2014 { 40 } else { 4000 };
        let best = (0..9)
            .map(|_| {
                let start = Instant::now();
                for _ in 0..passes {
                    for (normal, body) in &hits {
                        let mut a = *black_box(body);
                        let mut b =
                            Body { velocity: Vec3::ZERO, angular_velocity: Vec3::ZERO, ..a };
                        resolve(&law, &pool.cloth, *normal, &mut a, &mut b);
                        black_box((a, b));
                    }
                }
                start.elapsed().as_secs_f64() / f64::from(passes) / hits.len() as f64
            })
            .fold(f64::INFINITY, f64::min);
        println!("{model:?}: {:.1} ns", best * 1e9);
    }
}

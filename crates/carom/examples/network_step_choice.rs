//! Shows how the steps of `carom::resolve::ball_ball::network` were chosen: prints, as JSON, the
//! error of its long steps against an integration with small ones, over a grid of the two constants
//! `ahead` and `trend`.
//!
//! `cargo run --release -p carom --example network_step_choice`
//!
//! Balls stand in rows of three to eight and touch; the first one to four of them move at 1 m/s,
//! without losses. The reference solves m·dv/dt = k·δ^(3/2) by the classical Runge–Kutta method.
//! The error of a row is the largest difference of a ball's speed from the reference, as a fraction
//! of the first ball's speed.

use std::process::Command;

use carom::math::{Vec3, pow, sqrt};
use carom::physics::{BallBall, BallBallModel, Physics, SlipFriction};
use carom::resolve::Body;
use carom::resolve::ball_ball::network::{Stepping, Touch, resolve_in_steps};

/// Numbers of balls in the rows.
const ROWS: std::ops::RangeInclusive<usize> = 3..=8;
/// The most balls that move at the start.
const MOST_MOVING: usize = 4;
/// The values of `ahead`; 1/12 is best for small steps.
const AHEAD: [f64; 10] = [0.045, 0.05, 0.055, 0.06, 0.065, 0.07, 0.075, 0.08, 1.0 / 12.0, 0.09];
/// The values of `trend`; 1 is best for small steps.
const TREND: [f64; 8] = [0.75, 1.0, 1.125, 1.25, 1.375, 1.5, 1.75, 2.0];
/// Step of the reference, in units in which a pair's contact lasts 3.21.
const REFERENCE_STEP: f64 = 1e-3;
/// Number of its steps: all impacts are over by then.
const REFERENCE_STEPS: u32 = 50_000;

/// One impact: how many balls stand in the row, and how many of them move at 1 m/s at the start.
struct Row {
    balls: usize,
    moving: usize,
    /// Speeds of the balls after the impact, m/s.
    reference: Vec<f64>,
}

/// Errors of all rows with one choice of the constants, as fractions of the first speed.
struct Errors {
    worst: f64,
    root_mean_square: f64,
}

fn main() {
    let rows = rows();
    let chosen = errors(&rows, &Stepping::CHOSEN);
    let plain = errors(&rows, &Stepping { ahead: 0.0, trend: 0.0, ..Stepping::CHOSEN });
    let mut best = (f64::INFINITY, 0.0, 0.0);
    let mut mean_best = best;
    let mut lines = Vec::new();
    for ahead in AHEAD {
        let mut cells = Vec::new();
        for trend in TREND {
            let found = errors(&rows, &Stepping { ahead, trend, ..Stepping::CHOSEN });
            if found.worst < best.0 {
                best = (found.worst, ahead, trend);
            }
            if found.root_mean_square < mean_best.0 {
                mean_best = (found.root_mean_square, ahead, trend);
            }
            let cell = format!("[{:.2e}, {:.2e}]", found.worst, found.root_mean_square);
            cells.push(cell);
        }
        lines.push(format!(r#"  {{"ahead": {ahead:.4}, "errors": [{}]}}"#, cells.join(", ")));
    }
    println!("{{");
    println!(r#" "command": "cargo run --release -p carom --example network_step_choice","#);
    println!(r#" "commit": "{}","#, commit());
    println!(r#" "rows": {},"#, rows.len());
    println!(r#" "steps_per_contact": {},"#, Stepping::CHOSEN.steps_per_contact);
    println!(
        r#" "error_pairs": "worst and root mean square error, fractions of the first speed","#
    );
    println!(" \"trend\": {TREND:?},");
    println!(" \"grid\": [\n{}\n ],", lines.join(",\n"));
    println!(
        r#" "chosen": {{"ahead": {}, "trend": {}, "worst": {:.2e}, "root_mean_square": {:.2e}}},"#,
        Stepping::CHOSEN.ahead,
        Stepping::CHOSEN.trend,
        chosen.worst,
        chosen.root_mean_square
    );
    println!(
        r#" "without_both": {{"worst": {:.2e}, "root_mean_square": {:.2e}}},"#,
        plain.worst, plain.root_mean_square
    );
    println!(
        r#" "least_worst": {{"ahead": {:.4}, "trend": {}, "error": {:.2e}}},"#,
        best.1, best.2, best.0
    );
    println!(
        r#" "least_root_mean_square": {{"ahead": {:.4}, "trend": {}, "error": {:.2e}}}"#,
        mean_best.1, mean_best.2, mean_best.0
    );
    println!("}}");
}

fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    for balls in ROWS {
        for moving in 1..=MOST_MOVING.min(balls - 1) {
            rows.push(Row { balls, moving, reference: reference(balls, moving) });
        }
    }
    rows
}

fn errors(rows: &[Row], stepping: &Stepping) -> Errors {
    let (mut worst, mut squares) = (0.0_f64, 0.0);
    for row in rows {
        let error = row.error(stepping);
        worst = worst.max(error);
        squares += error * error;
    }
    Errors { worst, root_mean_square: sqrt(squares / rows.len() as f64) }
}

impl Row {
    /// The largest difference of a speed from the reference.
    fn error(&self, stepping: &Stepping) -> f64 {
        let pool = Physics::pool();
        let law = BallBall {
            model: BallBallModel::Elastic,
            restitution: 1.0,
            friction: SlipFriction::constant(0.0),
            ..pool.ball_ball
        };
        let body = |k: usize| Body {
            velocity: Vec3::new(f64::from(k < self.moving), 0.0, 0.0),
            angular_velocity: Vec3::ZERO,
            mass: pool.ball.mass,
            radius: pool.ball.radius,
        };
        let normal = Vec3::new(1.0, 0.0, 0.0);
        let touch = |k: usize| Touch { a: k as u8, b: k as u8 + 1, normal, gap: 0.0 };
        let mut bodies: Vec<Body> = (0..self.balls).map(body).collect();
        let touches: Vec<Touch> = (0..self.balls - 1).map(touch).collect();
        assert!(
            resolve_in_steps(&law, &mut bodies, &touches, stepping),
            "the first balls approach"
        );
        let difference = |(body, expected): (&Body, &f64)| (body.velocity.x - expected).abs();
        bodies.iter().zip(&self.reference).map(difference).fold(0.0, f64::max)
    }
}

/// Speeds after the impact, by the classical Runge–Kutta method, in units in which masses and
/// stiffnesses are 1.
fn reference(balls: usize, moving: usize) -> Vec<f64> {
    let rate = |y: &[f64]| -> Vec<f64> {
        let force: Vec<f64> =
            (0..balls - 1).map(|i| pow((y[i] - y[i + 1]).max(0.0), 1.5)).collect();
        let push = |i: usize| {
            let from_left = if i > 0 { force[i - 1] } else { 0.0 };
            from_left - force.get(i).copied().unwrap_or(0.0)
        };
        (0..balls).map(|i| y[balls + i]).chain((0..balls).map(push)).collect()
    };
    let moved = |y: &[f64], rate: &[f64], h: f64| -> Vec<f64> {
        y.iter().zip(rate).map(|(y, rate)| y + h * rate).collect()
    };
    let mut y = vec![0.0; 2 * balls];
    y[balls..balls + moving].fill(1.0);
    let h = REFERENCE_STEP;
    for _ in 0..REFERENCE_STEPS {
        let k1 = rate(&y);
        let k2 = rate(&moved(&y, &k1, 0.5 * h));
        let k3 = rate(&moved(&y, &k2, 0.5 * h));
        let k4 = rate(&moved(&y, &k3, h));
        for i in 0..2 * balls {
            y[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
        }
    }
    y.split_off(balls)
}

/// The checkout's commit.
fn commit() -> String {
    let output = Command::new("git").args(["rev-parse", "--short", "HEAD"]).output();
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned());
    text.ok().filter(|text| !text.is_empty()).unwrap_or_else(|| "unknown".to_owned())
}

//! Breaks whose first milliseconds are integrated with springs.
//!
//! The engine plays the cue ball up to the rack. From there all balls are bodies of one network,
//! until none can touch another one for some milliseconds. Their states then are the start of a
//! shot that the engine plays to its end. Gravity and the friction of the cloth do not act in
//! between: in 10 ms they change speeds by 0.1 m/s at most, vertical ones, and by 0.02 m/s.

use carom::math::Vec3;
use carom::noise::StruckBall;
use carom::rack::{Break, Game, break_shot};
use carom::trace::TraceEventKind;
use carom::{Noise, Shot, Simulator};

use crate::Vector;
use crate::build::{Springs, network};
use crate::impact::resolve;
use crate::motion::Settings;
use crate::network::Network;

/// The network ends when no two balls meet for this time, s.
pub const APART: f64 = 5e-3;
/// A ball that is lower than this above the slate, m, and slower than [`LOW_SPEED`], rolls or
/// slides: the engine leaves out hops of less than 0.05 mm.
const LOW: f64 = 5e-5;
/// √(2gh) of a hop of 0.05 mm, m/s.
const LOW_SPEED: f64 = 0.032;
/// Balls that would overlap by rounding are moved apart by this share of their distance.
const ROUNDING: f64 = 1e-9;

/// How often all pairs are moved apart.
const PASSES: u32 = 20;

/// A way to compute the first milliseconds of a break.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BreakMethod {
    /// The engine.
    Engine,
    /// Springs.
    MovingSprings,
    /// Springs whose lines of centres keep their first directions.
    FixedSprings,
}

/// What happened in a break.
#[derive(Clone, Copy, Debug, Default)]
pub struct BreakResult {
    /// Object balls that fell.
    pub potted: usize,
    /// Whether the cue ball fell.
    pub scratch: bool,
}

/// Eight-ball break `k`: its own rack, and its own errors of a professional's strike. `gap` is the
/// rack's mean gap, m; `speed` the cue's, m/s.
///
/// # Errors
/// What the engine refuses.
pub fn opening(gap: f64, speed: f64, k: u64) -> Result<Shot, String> {
    let opening = Break { gap, speed: Some(speed), ..Break::new(Game::EightBall, k) };
    let shot = break_shot(&opening).map_err(|error| error.to_string())?;
    let noise = Noise::preset("professional").ok_or("the preset is missing")?;
    let (ball, meant) = shot.strike().ok_or("a break has a strike")?;
    let struck = noise.draw(&meant, &StruckBall::of(&shot, &shot.balls()[ball].ball), 1, k);
    shot.with_strike(&struck).map_err(|error| error.to_string())
}

/// Plays a break.
///
/// # Errors
/// What the engine refuses, or that the cue ball misses the rack.
pub fn play(shot: &Shot, method: BreakMethod) -> Result<BreakResult, String> {
    let text = |error: carom::Error| error.to_string();
    let shot = match method {
        BreakMethod::Engine => shot.clone(),
        BreakMethod::MovingSprings | BreakMethod::FixedSprings => {
            spread(shot, method == BreakMethod::FixedSprings)?
        }
    };
    let trace = Simulator::new().record(&shot).map_err(text)?;
    let mut result = BreakResult::default();
    for event in trace.events() {
        if matches!(event.kind, TraceEventKind::PocketCollision(_)) {
            for &ball in event.balls {
                if ball == 0 {
                    result.scratch = true;
                } else {
                    result.potted += 1;
                }
            }
        }
    }
    Ok(result)
}

/// The shot that begins when the balls of a break are apart.
fn spread(shot: &Shot, keeps_normals: bool) -> Result<Shot, String> {
    let text = |error: carom::Error| error.to_string();
    let trace = Simulator::new().record(shot).map_err(text)?;
    let hit = trace.events().find(|event| matches!(event.kind, TraceEventKind::BallCollision));
    let hit = hit.ok_or("the cue ball misses the rack")?;
    let mut balls = shot.balls().to_vec();
    for (&ball, before) in hit.balls.iter().zip(hit.before) {
        balls[usize::from(ball)].state = *before;
    }
    let started = shot.with_balls(balls.clone(), None).map_err(text)?;
    let springs = Springs { reach: f64::INFINITY, keeps_normals, ..Springs::USUAL };
    let impact = resolve(&network(&started, &springs), &Settings::USUAL, APART);
    let mut end = impact.ok_or("the cue ball misses the rack")?.end().clone();
    // Moving one pair apart may push another one together.
    for _ in 0..PASSES {
        separate(&mut end);
    }
    for (placed, ball) in balls.iter_mut().zip(&end.balls) {
        let vector = |v: Vector| Vec3::new(v.x, v.y, v.z);
        placed.state.position = vector(ball.position);
        placed.state.velocity = vector(ball.velocity);
        placed.state.angular_velocity = vector(ball.spin);
        if ball.position.z - ball.radius < LOW && ball.velocity.z < LOW_SPEED {
            placed.state.position.z = ball.radius;
            placed.state.velocity.z = 0.0;
        }
    }
    shot.with_balls(balls, None).map_err(text)
}

/// Moves balls apart that overlap by rounding.
fn separate(network: &mut Network) {
    for a in 0..network.balls.len() {
        for b in a + 1..network.balls.len() {
            let (p, q) = (network.balls[a], network.balls[b]);
            let way = q.position - p.position;
            let overlap = p.radius + q.radius - way.norm();
            if overlap > -ROUNDING * p.radius {
                let shift = way.normalize() * (0.5 * overlap + ROUNDING * p.radius);
                network.balls[a].position -= shift;
                network.balls[b].position += shift;
            }
        }
    }
}

//! Random balls on unbounded cloth that touch each other, one of which moves.

use carom::physics::BallBallModel;
use serde_json::{Value, json};

use crate::random::Draws;

/// Mass (kg) and radius (m) of a usual ball.
pub(crate) const USUAL: (f64, f64) = (0.17, 0.028_575);
/// Gaps up to this count as touching, m.
const TOUCH: f64 = 1e-9;
/// Free space between balls that are not neighbours, m.
const CLEAR: f64 = 2e-3;
/// The widest gap between neighbours, m.
const WIDEST: f64 = 1e-4;
/// Restitution and friction that are drawn.
const RESTITUTIONS: [f64; 4] = [0.85, 0.92, 0.95, 1.0];

/// A kind of cluster.
#[derive(Clone, Copy, Debug)]
pub struct ClusterKind {
    /// The model of the contacts of balls.
    pub model: &'static str,
    /// Whether all balls have one size and mass.
    pub alike: bool,
    /// Whether neighbours have gaps of up to 0.1 mm.
    pub gaps: bool,
    /// Whether there are only two balls. The engine follows the law of a pair there.
    pub pair: bool,
}

struct Disc {
    at: [f64; 2],
    radius: f64,
    /// Gap to its first neighbour.
    gap: f64,
}

/// Distance in plan of two balls on the cloth whose surfaces are `gap` apart.
fn reach(r: f64, s: f64, gap: f64) -> f64 {
    let (sum, difference) = (r + s + gap, r - s);
    (sum * sum - difference * difference).sqrt()
}

fn distance(p: [f64; 2], q: [f64; 2]) -> f64 {
    (q[0] - p[0]).hypot(q[1] - p[1])
}

/// The place at the distances `p` and `q` from two others.
fn between(a: [f64; 2], p: f64, b: [f64; 2], q: f64) -> Option<[f64; 2]> {
    let d = distance(a, b);
    if d > p + q {
        return None;
    }
    let along = (d * d + p * p - q * q) / (2.0 * d);
    let across = (p * p - along * along).max(0.0).sqrt();
    let (c, s) = ((b[0] - a[0]) / d, (b[1] - a[1]) / d);
    Some([a[0] + c * along - s * across, a[1] + s * along + c * across])
}

/// The shot file of cluster `seed`.
pub fn shot_file(kind: &ClusterKind, seed: u64) -> String {
    let random = &mut Draws::new(seed);
    let size = if kind.pair { 2 } else { 3 + random.below(13) };
    let mut discs: Vec<Disc> = Vec::new();
    while discs.len() < size {
        let is_last = discs.len() + 1 == size;
        let radius = if kind.alike { USUAL.1 } else { random.between(0.022, 0.034) };
        // The ball that moves touches a neighbour, so that nothing else happens first.
        let mut gap = || if kind.gaps && !is_last { random.between(0.0, WIDEST) } else { 0.0 };
        let gaps = [gap(), gap()];
        let Some(a) = (!discs.is_empty()).then(|| random.below(discs.len())) else {
            discs.push(Disc { at: [0.0; 2], radius, gap: 0.0 });
            continue;
        };
        let b = random.below(discs.len());
        let p = reach(discs[a].radius, radius, gaps[0]);
        let at = if a != b && random.chance(0.6) {
            between(discs[a].at, p, discs[b].at, reach(discs[b].radius, radius, gaps[1]))
        } else {
            let (sin, cos) = random.between(0.0, std::f64::consts::TAU).sin_cos();
            Some([discs[a].at[0] + p * cos, discs[a].at[1] + p * sin])
        };
        let Some(at) = at else { continue };
        let is_free = discs.iter().all(|disc| {
            let apart = distance(disc.at, at) - reach(disc.radius, radius, 0.0);
            apart > CLEAR || apart.abs() < TOUCH || kind.gaps && (0.0..=WIDEST).contains(&apart)
        });
        if is_free {
            discs.push(Disc { at, radius, gap: gaps[0] });
        }
    }
    moved(kind, &discs, random)
}

/// The last ball moves towards one that it touches, more or less.
fn moved(kind: &ClusterKind, discs: &[Disc], random: &mut Draws) -> String {
    let (last, others) = discs.split_last().expect("at least two balls");
    let met: Vec<f64> = others
        .iter()
        .filter(|disc| {
            distance(disc.at, last.at) < reach(disc.radius, last.radius, last.gap) + TOUCH
        })
        .map(|disc| (disc.at[1] - last.at[1]).atan2(disc.at[0] - last.at[0]))
        .collect();
    let heading = random.choice(&met) + random.between(-1.1, 1.1);
    let speed = random.log_between(1.0, 10.0);
    let spin = random.vector(speed / last.radius);
    let balls: Vec<Value> = std::iter::once(last)
        .chain(others)
        .enumerate()
        .map(|(k, disc)| {
            let mass = USUAL.0 * (disc.radius / USUAL.1).powi(3);
            let mut ball = json!({
                "id": k.to_string(), "position": disc.at, "mass": mass, "radius": disc.radius,
            });
            if k == 0 {
                ball["velocity"] = json!([speed * heading.cos(), speed * heading.sin(), 0.0]);
                ball["angular_velocity"] = json!(spin.as_slice());
            }
            ball
        })
        .collect();
    let file = json!({
        "format": "carom-shot/1",
        "table": {"cloth": "unbounded"},
        "physics": {"base": "pool", "ball_ball": ball_law(kind.model, random)},
        "balls": balls,
    });
    file.to_string()
}

/// The names of the models of two balls that springs can judge: those without friction of the cloth
/// during the impact.
pub(crate) fn spring_models() -> Vec<&'static str> {
    BallBallModel::NAMED
        .iter()
        .filter(|(_, model)| !model.traits().cloth)
        .map(|(name, _)| *name)
        .collect()
}

/// A random law of the contacts of balls.
pub(crate) fn ball_law(model: &str, random: &mut Draws) -> Value {
    let friction = match (model, random.chance(0.5)) {
        ("elastic", _) => json!(0.0),
        (_, true) => json!(0.06),
        (_, false) => json!({"a": 0.01, "b": 0.11, "c": 1.1}),
    };
    json!({
        "model": model,
        "restitution": random.choice(&RESTITUTIONS),
        "friction": friction,
        "frequency_ratio": random.between(1.3, 1.9),
    })
}

//! The differences between the engine's impacts and the springs.

use carom::physics::BallBallModel;
use carom::trace::TraceEventKind;
use carom::{Shot, Simulator};

use crate::Vector;
use crate::build::{Springs, network};
use crate::clusters::{self, ClusterKind};
use crate::impact::{SpringImpact, resolve};
use crate::motion::Settings;
use crate::network::Network;
use crate::{rails, strikes};

/// Bodies that meet again within this time, s, may do so in the same impact. The springs do not say
/// when an impact ends: at any instant without a force it may.
const HORIZON: f64 = 2e-3;

/// A larger difference is computed again with [`Settings::FINE`].
const DOUBTFUL: f64 = 5e-4;

/// A kind of random case.
#[derive(Clone, Copy, Debug)]
pub enum CaseKind {
    /// Balls on unbounded cloth.
    Cluster(ClusterKind),
    /// A cue ball that touches balls and perhaps a rail is struck.
    Strike,
    /// A ball that touches a rail is hit.
    Rail,
}

impl CaseKind {
    /// Every kind.
    pub fn all() -> Vec<Self> {
        let mut kinds = Vec::new();
        // Those of a network, which has no friction of the cloth.
        let models = BallBallModel::ALL.into_iter().filter(|model| !model.traits().cloth);
        let models = models.map(BallBallModel::name);
        for gaps in [false, true] {
            for model in models.clone() {
                for alike in [true, false] {
                    kinds.push(Self::Cluster(ClusterKind { model, alike, gaps, pair: false }));
                }
            }
        }
        let pair =
            |model| Self::Cluster(ClusterKind { model, alike: true, gaps: false, pair: true });
        kinds.extend(models.map(pair));
        kinds.extend([Self::Strike, Self::Rail]);
        kinds
    }

    /// The name on the command line.
    pub fn name(&self) -> String {
        match self {
            Self::Cluster(ClusterKind { model, pair: true, .. }) => format!("{model}-pair"),
            Self::Cluster(ClusterKind { model, alike, gaps, .. }) => {
                let size = if *alike { "equal" } else { "unequal" };
                format!("{model}-{size}{}", if *gaps { "-gaps" } else { "" })
            }
            Self::Strike => "strike".into(),
            Self::Rail => "rail".into(),
        }
    }

    /// The shot file of case `seed`.
    pub fn shot_file(&self, seed: u64) -> String {
        match self {
            Self::Cluster(kind) => clusters::shot_file(kind, seed),
            Self::Strike => strikes::shot_file(seed),
            Self::Rail => rails::shot_file(seed),
        }
    }
}

/// The largest differences of one case, as shares of the fastest ball's speed.
#[derive(Clone, Copy, Debug)]
pub struct Difference {
    /// Of a ball's velocity. A vertical velocity counts only where the engine has one.
    pub velocity: f64,
    /// Of a ball's Rω.
    pub surface: f64,
}

/// The springs' result for a shot.
///
/// # Errors
/// What is wrong, if nothing meets.
pub fn integrated(
    shot: &Shot,
    springs: &Springs,
    settings: &Settings,
) -> Result<SpringImpact, String> {
    resolve(&network(shot, springs), settings, HORIZON).ok_or_else(|| "no impact".into())
}

/// The balls right after the engine's first impact.
///
/// # Errors
/// What is wrong: the engine fails, or there is no impact.
pub fn played(shot: &Shot) -> Result<Network, String> {
    let trace = Simulator::new().record(shot).map_err(|error| error.to_string())?;
    let is_impact = |kind: TraceEventKind| match shot.strike() {
        Some(_) => matches!(kind, TraceEventKind::CueStrike { .. }),
        None => matches!(kind, TraceEventKind::BallCollision),
    };
    let event = trace.events().find(|event| is_impact(event.kind)).ok_or("no impact")?;
    let mut result = network(shot, &Springs { walls: false, ..Springs::USUAL });
    for (&k, after) in event.balls.iter().zip(event.after) {
        let ball = &mut result.balls[usize::from(k)];
        ball.velocity = Vector::new(after.velocity.x, after.velocity.y, after.velocity.z);
        let w = after.angular_velocity;
        ball.spin = Vector::new(w.x, w.y, w.z);
    }
    Ok(result)
}

/// The difference of two results.
pub fn difference(found: &Network, exact: &Network) -> Difference {
    let fastest = exact.balls.iter().map(|ball| ball.velocity.norm()).fold(0.0, f64::max);
    let mut most = Difference { velocity: 0.0, surface: 0.0 };
    for (found, exact) in found.balls.iter().zip(&exact.balls) {
        let mut apart = found.velocity - exact.velocity;
        if found.velocity.z == 0.0 {
            apart.z = 0.0;
        }
        let turned = (found.spin - exact.spin) * exact.radius;
        most.velocity = most.velocity.max(apart.norm() / fastest);
        most.surface = most.surface.max(turned.norm() / fastest);
    }
    most
}

/// The difference between the engine and the springs in the first impact of a shot file. The springs
/// have several ends; the nearest one counts.
///
/// # Errors
/// What is wrong, if the engine refuses the shot or nothing meets.
pub fn judge(file: &str, springs: &Springs, settings: &Settings) -> Result<Difference, String> {
    let shot = Shot::from_json(file).map_err(|error| error.to_string())?;
    let found = played(&shot)?;
    let apart = nearest(&found, &integrated(&shot, springs, settings)?);
    if apart.velocity < DOUBTFUL {
        return Ok(apart);
    }
    Ok(nearest(&found, &integrated(&shot, springs, &Settings::FINE)?))
}

/// The difference from the nearest end.
pub fn nearest(found: &Network, impact: &SpringImpact) -> Difference {
    let ends = impact.pauses.iter().map(|(_, exact)| difference(found, exact));
    ends.min_by(|a, b| a.velocity.total_cmp(&b.velocity)).expect("an impact has an end")
}

/// The difference between two accuracies of the springs.
///
/// # Errors
/// As [`judge`].
pub fn own_error(file: &str, springs: &Springs, settings: [&Settings; 2]) -> Result<f64, String> {
    let shot = Shot::from_json(file).map_err(|error| error.to_string())?;
    let [rough, fine] = settings;
    let exact = integrated(&shot, springs, fine)?;
    let found = integrated(&shot, springs, rough)?;
    let errors = found.pauses.iter().map(|(_, found)| nearest(found, &exact).velocity);
    Ok(errors.fold(f64::INFINITY, f64::min))
}

//! What the law of two balls says about the impulse between them, when they meet alone: e of the
//! normal part, and μ of the tangential part, which is that of a cling where the contact clings.
//! Rigid surfaces slide or grip (Coulomb); compliant ones follow Stronge's springs, integrated in
//! small steps ([`stronge`]).

use carom::math::Vec3;
use carom::physics::{BallBall, BallBallModel};

use crate::rail_laws::{restitution, stronge};

/// Approach speed up to which the rule for persistent contacts may replace the law, m/s: the
/// engine's `MIN_SEPARATION`, rounded up.
const SLOW: f64 = 1.1e-3;

/// The same if one ball is off the bed, m/s: more than the speed of the engine's last hop. A slower
/// ball comes to lie on the other one.
const SLOW_IN_AIR: f64 = 0.05;

/// Separation speed, as a fraction of the approach speed, below which the law does not decide: with
/// no restitution, or where the slate stops the ball that is pressed down, the engine lets the balls
/// separate with a rounding error of their speeds.
const LEAST_SEPARATION: f64 = 1e-6;

/// Least squared level part of a line of centres for which a ball on the bed shows its impulse.
const LEAST_LEVEL: f64 = 0.01;

/// Allowed error as a fraction of the impulse: rounding, enlarged by lines of centres that are
/// almost upright.
const ROUNDING: f64 = 1e-10;

/// β of two solid spheres: the change of slip per tangential impulse and reduced mass.
const BETA: f64 = 3.5;

/// The contact of a ball with another one, and what the other gave it.
pub(super) struct PairImpulse {
    /// Unit vector to the other ball.
    pub(super) normal: Vec3,
    /// Velocity relative to the other ball, and that of the surface along which the balls slip, m/s.
    pub(super) velocity: Vec3,
    pub(super) surface: Vec3,
    /// Speed at which the balls separate, m/s.
    pub(super) separation: f64,
    /// The impulse on the ball per reduced mass, m/s, and its rounding error.
    pub(super) impulse: Vec3,
    pub(super) rounding: f64,
    /// Whether both balls are on the bed.
    pub(super) on_bed: bool,
}

impl PairImpulse {
    /// What contradicts `law`, if anything does.
    pub(super) fn audit(&self, law: &BallBall) -> Option<String> {
        let approach = self.velocity.dot(self.normal);
        let slow = if self.on_bed { SLOW } else { SLOW_IN_AIR };
        let e = restitution(law.restitution, approach);
        let level = self.normal.xy().length_squared();
        let is_wedged = self.separation < LEAST_SEPARATION * approach;
        if approach < slow || is_wedged || level < LEAST_LEVEL {
            return None;
        }
        let slip = self.velocity - self.normal * approach + self.surface;
        let speed = slip.length();
        let (grip, accuracy) = self.grip(law, approach, speed, e)?;
        let against = if speed > 0.0 { slip * (-grip / speed) } else { Vec3::ZERO };
        let expected = against - self.normal * ((1.0 + e) * approach);
        let off = (self.impulse - expected).length();
        let allowed = accuracy + self.rounding + ROUNDING * expected.length();
        (off > allowed).then(|| {
            let along = self.impulse.dot(self.normal);
            let across = (self.impulse - self.normal * along).length();
            format!(
                "an impulse of {:e} m/s along the line of centres and {across:e} across it, where \
                 the law has {:e} and {grip:e}; allowed {allowed:e}",
                -along,
                (1.0 + e) * approach
            )
        })
    }

    /// The tangential impulse per reduced mass, and its accuracy, m/s. `None` for the model that also
    /// has the cloth's friction.
    fn grip(&self, law: &BallBall, approach: f64, slip: f64, e: f64) -> Option<(f64, f64)> {
        let mu = law.friction.a + law.friction.b * carom::math::exp(-law.friction.c * slip);
        match law.model {
            BallBallModel::Elastic => Some((0.0, 0.0)),
            BallBallModel::Frictional => {
                Some((slip.min(BETA * mu * (1.0 + e) * approach) / BETA, 0.0))
            }
            BallBallModel::Compliant => {
                let grip = stronge::friction_impulse(slip / approach, e, mu, law.frequency_ratio);
                Some((approach * grip, stronge::ACCURACY * mu * approach))
            }
            BallBallModel::Mathavan2014 => None,
        }
    }
}

//! The cue strike (Leckie & Greenspan 2005; tip efficiency TP A.30; squirt TP A.31).
//!
//! # The shooter's frame
//!
//! **d** is the direction of the cue, **r** the horizontal direction to its right, and **u** = r ×
//! d the third, which points up for a level cue. At every elevation the contact point is R(x·r +
//! y·u − √(1 − x² − y²)·d) from the ball's centre, with x = `side` and y = `height`, and the
//! impulse acts along d. So its lever arm is R√(x² + y²), and the ball's inverse mass at the
//! contact is k/m with k = 1 + 5/2·(x² + y²). This equals Leckie & Greenspan's 1 + (5/2R²)(a² +
//! b²cos²θ + c²sin²θ − 2bc·cosθ·sinθ): with their vertical b = R(y·cosθ + q·sinθ) and horizontal c
//! = R(q·cosθ − y·sinθ), q = √(1 − x² − y²), b·cosθ − c·sinθ = R·y.
//!
//! # Squirt
//!
//! The end of the shaft, of mass m_e, must follow the turning ball sideways, and pushes the ball
//! the other way. Right English sends the ball to the left of the aim, by the angle α with tan α =
//! 5/2·x√(1 − x²)/[1 + m/m_e + 5/2·(1 − x²)] at any speed (TP A.31, x the side offset). The
//! velocity turns by α about u. For a level cue that changes the azimuth by α; a masse shot has the
//! same sideways speed v·sin α at any elevation. Speed and spin stay those of Leckie & Greenspan.
//! The same effect of `height` is neglected, because in the vertical plane slate and bridge hold
//! the cue.

use alloc::format;
use alloc::string::String;
use core::fmt;

use crate::Ball;
use crate::error::ErrorKind;
use crate::math::{Vec3, atan, sin_cos, sqrt};
use crate::physics::{Cue, Tip};
use crate::resolve::SPIN_PER_IMPULSE;
use crate::resolve::network::{TipTouch, stiffness_of_time};

/// One tip, the unit in which players count English, follow and draw: ball radii.
///
/// Three tips are half a radius, where a usual tip miscues (Alciatore, TP 2.1). It is also the way
/// of the contact point, d·R/(R + r), when the cue moves aside by half the width of a 13 mm tip: d =
/// 6.5 mm, R = 28.6 mm, and r = 10.6 mm, the curvature of a US nickel, give 0.166 R. It is not the
/// width of a tip, which is 0.45 R.
pub const TIP: f64 = 1.0 / 6.0;

/// A strike, in the shooter's frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Strike {
    /// Cue speed at contact, m/s.
    pub speed: f64,
    /// Direction in which the cue moves, counter-clockwise from +x, rad.
    pub azimuth: f64,
    /// Elevation of the butt above the horizontal, rad.
    pub elevation: f64,
    /// Contact point right of centre, in ball radii, perpendicular to the cue's axis.
    pub side: f64,
    /// Contact point above centre, in ball radii, perpendicular to the cue's axis.
    pub height: f64,
}

impl Strike {
    /// Distance of the cue's axis from the ball's centre, √(side² + height²), in ball radii.
    pub fn offset(&self) -> f64 {
        sqrt(self.side * self.side + self.height * self.height)
    }
}

/// Why a strike is impossible.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StrikeError {
    /// The contact point is not on the ball.
    OffBall {
        /// √(side² + height²), in ball radii.
        offset: f64,
    },
    /// A miscue: the tip slips off beyond the miscue limit.
    Miscue {
        /// √(side² + height²), in ball radii.
        offset: f64,
        /// The largest offset at which the tip's friction holds.
        limit: f64,
    },
    /// The radicand of TP A.30 is negative: no speed has this efficiency at this offset.
    Unreachable {
        /// √(side² + height²), in ball radii.
        offset: f64,
    },
}

impl StrikeError {
    /// What is wrong.
    pub fn fault(&self) -> String {
        match self {
            Self::OffBall { offset } => {
                format!("the tip would miss the ball: √(side² + height²) is {offset:.4} ball radii")
            }
            Self::Miscue { offset, limit } => format!(
                "a miscue: √(side² + height²) is {offset:.4} ball radii, and this tip slips off \
                 beyond {limit:.4}"
            ),
            Self::Unreachable { offset } => format!(
                "physics.cue.tip_efficiency is too low for a tip offset of {offset:.4} ball radii \
                 (the radicand of TP A.30 is negative)"
            ),
        }
    }

    /// What kind of error it is.
    pub const fn kind(&self) -> ErrorKind {
        match self {
            Self::OffBall { .. } => ErrorKind::MissesBall,
            Self::Miscue { .. } => ErrorKind::Miscue,
            Self::Unreachable { .. } => ErrorKind::Unreachable,
        }
    }

    /// What to do about it.
    pub const fn remedy(&self) -> &'static str {
        match self {
            Self::OffBall { .. } => "keep it below 1, and below the miscue limit",
            Self::Miscue { .. } => "strike nearer the centre, or raise physics.cue.tip_friction",
            Self::Unreachable { .. } => {
                "strike nearer the centre, raise physics.cue.tip_efficiency, or give \
                 physics.cue.tip_restitution instead"
            }
        }
    }
}

impl fmt::Display for StrikeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}; {}", self.fault(), self.remedy())
    }
}

impl core::error::Error for StrikeError {}

/// The largest offset (in ball radii) at which a tip with friction `tip_friction` does not slip:
/// the solution x of μ = x/√(1 − x²) (TP 2.1, A.12).
pub fn miscue_limit(tip_friction: f64) -> f64 {
    tip_friction / sqrt(1.0 + tip_friction * tip_friction)
}

/// The angle (rad) from the cue's direction to the ball's, positive to the left, for a strike at
/// `side` (TP A.31); 0 if the cue's end has no mass.
pub fn squirt(cue: &Cue, ball: &Ball, side: f64) -> f64 {
    if cue.end_mass == 0.0 {
        return 0.0;
    }
    let inward = 1.0 - side * side;
    let lever = SPIN_PER_IMPULSE * side * sqrt(inward);
    atan(lever / (1.0 + ball.mass / cue.end_mass + SPIN_PER_IMPULSE * inward))
}

/// The restitution of the tip at `offset` (in ball radii). `None` if the radicand of TP A.30 is
/// negative.
fn tip_restitution(cue: &Cue, ball: &Ball, offset: f64) -> Option<f64> {
    let square = offset * offset;
    match cue.tip {
        Tip::Restitution(e) if cue.tip_off_centre_loss == 0.0 => Some(e),
        Tip::Restitution(e) => {
            let square_tan = square / (1.0 - square);
            Some(e / sqrt(1.0 + cue.tip_off_centre_loss * square_tan))
        }
        Tip::Efficiency(efficiency) => {
            let k = 1.0 + SPIN_PER_IMPULSE * square;
            let radicand = efficiency - (1.0 - efficiency) * k * cue.mass / ball.mass;
            (radicand >= 0.0).then(|| sqrt(radicand))
        }
    }
}

/// The strike's directions, in the frame of the table.
struct Directions {
    /// **u**, and the horizontal **r**.
    up: Vec3,
    right: Vec3,
    /// The cue's axis **d**.
    axis: Vec3,
    /// The axis, turned by squirt.
    launch: Vec3,
}

/// **u**, **r** and **d** of a strike.
fn axes(strike: &Strike) -> [Vec3; 3] {
    let (sin_azimuth, cos_azimuth) = sin_cos(strike.azimuth);
    let (sin_elevation, cos_elevation) = sin_cos(strike.elevation);
    let axis =
        // Subtraction from 0.0 makes this 0 for a level cue, not −0.
        Vec3::new(cos_azimuth * cos_elevation, sin_azimuth * cos_elevation, 0.0 - sin_elevation);
    let up = Vec3::new(cos_azimuth * sin_elevation, sin_azimuth * sin_elevation, cos_elevation);
    let right = Vec3::new(sin_azimuth, -cos_azimuth, 0.0);
    [up, right, axis]
}

fn directions(cue: &Cue, ball: &Ball, strike: &Strike) -> Directions {
    let [up, right, axis] = axes(strike);
    let (sin_squirt, cos_squirt) = sin_cos(squirt(cue, ball, strike.side));
    Directions { up, right, axis, launch: axis * cos_squirt - right * sin_squirt }
}

/// The point of the ball that the tip of `strike` meets, from the ball's centre, in radii.
pub fn contact_arm(strike: &Strike) -> Vec3 {
    arm(strike, axes(strike))
}

fn arm(strike: &Strike, [up, right, axis]: [Vec3; 3]) -> Vec3 {
    let offset = strike.offset();
    let depth = sqrt((1.0 - offset * offset).max(0.0));
    right * strike.side + up * strike.height - axis * depth
}

/// The tip of the cue on the ball with the index `index` in a network. `contact_time` is that of
/// the tip, s.
///
/// # Errors
/// As [`resolve`].
pub fn tip_touch(
    cue: &Cue,
    ball: &Ball,
    strike: &Strike,
    contact_time: f64,
    index: u8,
) -> Result<TipTouch, StrikeError> {
    let offset = strike.offset();
    let restitution =
        tip_restitution(cue, ball, offset).ok_or(StrikeError::Unreachable { offset })?;
    let Directions { up, right, axis, launch } = directions(cue, ball, strike);
    let arm = arm(strike, [up, right, axis]);
    Ok(TipTouch {
        ball: index,
        cue_mass: cue.mass,
        cue_speed: strike.speed,
        launch,
        twist: arm.cross(axis),
        stiffness: stiffness_of_time(ball.mass * cue.mass / (ball.mass + cue.mass), contact_time),
        restitution,
    })
}

/// Velocity (m/s) and spin (rad/s) of a resting ball after the strike. A raised cue drives the ball
/// down at −v·sin φ; the slate's response is a separate impact (launch rule of TP B.10; Leckie &
/// Greenspan 2005).
///
/// The spin is v/R·5/2·(x·**u** − y·**r**), so right English gives ω_z > 0 and a positive height
/// gives follow.
///
/// # Errors
/// [`StrikeError`] for a tip offset of at least 1 ball radius, beyond the miscue limit, or too
/// large for the tip's efficiency.
pub fn resolve(cue: &Cue, ball: &Ball, strike: &Strike) -> Result<(Vec3, Vec3), StrikeError> {
    let offset = strike.offset();
    if offset >= 1.0 {
        return Err(StrikeError::OffBall { offset });
    }
    let limit = miscue_limit(cue.tip_friction);
    if offset > limit {
        return Err(StrikeError::Miscue { offset, limit });
    }
    let recoil = tip_restitution(cue, ball, offset).ok_or(StrikeError::Unreachable { offset })?;
    let inertia = ball.mass / cue.mass + 1.0 + SPIN_PER_IMPULSE * offset * offset;
    let speed = strike.speed * ((1.0 + recoil) / inertia);
    let Directions { up, right, launch, .. } = directions(cue, ball, strike);
    let velocity = launch * speed;
    let spin =
        (up * strike.side - right * strike.height) * (SPIN_PER_IMPULSE * speed / ball.radius);
    Ok((velocity, spin))
}

//! The cue strike (Leckie & Greenspan 2005; squirt TP A.31; tip efficiency TP A.30).

use crate::Ball;
use crate::math::Vec3;
use crate::physics::Cue;

/// What the player does, in the frame of the shooter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strike {
    /// Cue speed at contact, m/s.
    pub speed: f64,
    /// Direction in which the cue moves, counter-clockwise from +x, rad.
    pub azimuth: f64,
    /// Butt raised above horizontal, rad.
    pub elevation: f64,
    /// Contact point right of centre, in ball radii, perpendicular to the cue's axis.
    pub side: f64,
    /// Contact point above centre, in ball radii, perpendicular to the cue's axis.
    pub height: f64,
}

/// Why a strike is refused.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StrikeError {
    /// The contact point is off the ball.
    OffBall {
        /// √(side² + height²), in ball radii.
        offset: f64,
    },
    /// The tip would slip off: beyond the miscue limit.
    Miscue {
        /// √(side² + height²), in ball radii.
        offset: f64,
        /// The largest that the tip's friction holds.
        limit: f64,
    },
    /// TP A.30's radicand is negative: no speed gives this efficiency at this offset.
    Unreachable {
        /// √(side² + height²), in ball radii.
        offset: f64,
    },
}

/// Velocity (m/s) and spin (rad/s) of a resting ball after the strike; the vertical part of the
/// velocity is taken by the slate.
pub fn resolve(cue: &Cue, ball: &Ball, strike: &Strike) -> Result<(Vec3, Vec3), StrikeError> {
    let _ = (cue, ball, strike);
    Ok((Vec3::ZERO, Vec3::ZERO))
}

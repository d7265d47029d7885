//! Checks of a strike, and the policies for strikes that a player could not play cleanly.

use alloc::format;
use core::f64::consts::FRAC_PI_2;

use super::PlacedBall;
use crate::MotionState;
use crate::error::{Error, ErrorKind};
use crate::math::Vec3;
use crate::physics::Physics;
use crate::range::{LARGEST, Range, VANISHING, or_zero};
use crate::resolve::cue_ball::{self, Strike, StrikeError};

/// Largest speed of the cue, m/s. The record is about 15 m/s.
pub(crate) const FASTEST: f64 = 50.0;
/// Speed of the cue, m/s.
pub(crate) const SPEED: Range = Range::above(0.0, FASTEST, " m/s");
/// Angle of the cue above the horizontal, rad.
pub(crate) const ELEVATION: Range =
    Range::half_open(0.0, FRAC_PI_2, " rad (the key with _deg takes degrees)");
pub(crate) const OFFSET: Range = Range::closed(-1.0, 1.0, " ball radii");

/// Tip friction so large that the tip never slips.
const TIP_THAT_HOLDS: f64 = LARGEST;

/// What to do about a strike that a player could not play, or not cleanly.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Policy {
    /// Simulate it, and report it in the outcome.
    Report,
    /// Refuse the shot with an error.
    Refuse,
}

/// The policies for strikes that a player could not play cleanly.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct StrikePolicy {
    /// What to do if the cue would pass through a ball or a rail.
    pub obstruction: Policy,
    /// What to do about a miscue.
    pub miscue: Policy,
}

impl Default for StrikePolicy {
    fn default() -> Self {
        Self { obstruction: Policy::Report, miscue: Policy::Refuse }
    }
}

impl StrikePolicy {
    /// The friction of the tip with which strikes are resolved, for a tip of this friction.
    pub(super) fn used_tip_friction(self, tip_friction: f64) -> f64 {
        if self.miscue == Policy::Report { TIP_THAT_HOLDS } else { tip_friction }
    }
}

/// Refuses numbers that a shot file would refuse. `place` is the place of the strike.
pub(super) fn check_ranges(place: &str, strike: &Strike) -> Result<(), Error> {
    for (key, value, range) in [
        ("speed", strike.speed, SPEED),
        ("azimuth", strike.azimuth, Range::any(" rad")),
        ("elevation", strike.elevation, ELEVATION),
        ("side", strike.side, OFFSET),
        ("height", strike.height, OFFSET),
    ] {
        range.check(|| format!("{place}.{key}"), value)?;
        // A file reads it as 0, so a saved shot or game would be another one.
        if value != or_zero(value) {
            let fault = format!("{value:e} is too close to 0 to be stored in a file");
            return Err(ErrorKind::OutOfRange.at(
                format!("{place}.{key}"),
                fault,
                format!("write 0, or a number from {VANISHING:e} on"),
            ));
        }
    }
    Ok(())
}

/// The velocity (m/s) and the spin (rad/s) that a strike gives. `place` is the place of the strike.
///
/// # Errors
/// [`Error::Input`] for a ball that moves or is not on the cloth, and for a strike off the ball,
/// beyond the miscue limit, or too far off centre for the tip's efficiency.
pub(super) fn check(
    place: &str,
    ball: usize,
    strike: &Strike,
    balls: &[PlacedBall],
    physics: &Physics,
) -> Result<(Vec3, Vec3), Error> {
    let struck = &balls[ball];
    if struck.state.velocity != Vec3::ZERO || struck.state.angular_velocity != Vec3::ZERO {
        return Err(ErrorKind::Moving
            .at(
                format!("{place}.ball"),
                format!("ball \"{}\" (balls[{}]) is already moving", struck.id, ball),
                "strike a ball at rest, or leave the strike out",
            )
            .with("ball", &*struck.id));
    }
    if struck.state.motion == MotionState::Airborne {
        return Err(ErrorKind::NotOnCloth
            .at(
                format!("{place}.ball"),
                format!("ball \"{}\" (balls[{}]) does not lie on the cloth", struck.id, ball),
                "strike a ball that does, or leave the strike out",
            )
            .with("ball", &*struck.id));
    }
    cue_ball::resolve(&physics.cue, &struck.ball, strike).map_err(|e| explain(place, strike, e))
}

/// The error for a strike that cannot be played. `place` is the place of the strike.
pub(crate) fn explain(place: &str, strike: &Strike, e: StrikeError) -> Error {
    // The error names the larger of the two offsets.
    let key = if strike.side.abs() >= strike.height.abs() { "side" } else { "height" };
    e.kind().at(format!("{place}.{key}"), e.fault(), e.remedy())
}

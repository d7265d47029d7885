//! The pose of the cue in space: where its tip is and where it points.
//!
//! With the cue's direction d = (cos θ·cos φ, cos θ·sin φ, −sin θ) for the azimuth φ and the
//! elevation θ, the horizontal r = (sin φ, −cos φ, 0) to its right, and u = r × d = (sin θ·cos φ,
//! sin θ·sin φ, cos θ), the tip touches the ball with the centre C and the radius R at
//!
//! C + R(side·r + height·u − √(1 − side² − height²)·d).
//!
//! Side and height are measured across the cue's axis at every elevation: for a raised cue, u leans
//! towards the target, and a point at the height 0 lies above the ball's centre.

use alloc::format;

use super::obstruction::{BallInSpace, LENGTH, Touched};
use super::{PlacedBall, Shot};
use crate::error::{Error, ErrorKind};
use crate::math::{Vec3, atan2, sin_cos, sqrt};
use crate::resolve::cue_ball::Strike;

/// The cue at the moment when its tip touches the ball, in the file's coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CuePose {
    /// Where the tip touches the ball, m. It is on the cue's axis.
    pub tip: Vec3,
    /// The direction in which the cue moves, a unit vector along its axis.
    pub direction: Vec3,
}

/// The directions d, r and u of a cue.
fn axes(azimuth: f64, elevation: f64) -> [Vec3; 3] {
    let ((sin, cos), (rise, level)) = (sin_cos(azimuth), sin_cos(elevation));
    let direction = Vec3::new(cos * level, sin * level, 0.0 - rise);
    let up = Vec3::new(cos * rise, sin * rise, level);
    [direction, Vec3::new(sin, 0.0 - cos, 0.0), up]
}

impl CuePose {
    /// The pose of the cue for `strike` on `ball`.
    pub fn new(strike: &Strike, ball: BallInSpace) -> Self {
        let [direction, right, up] = axes(strike.azimuth, strike.elevation);
        let offset = strike.offset();
        let depth = sqrt((1.0 - offset * offset).max(0.0));
        let arm = right * strike.side + up * strike.height - direction * depth;
        Self { tip: ball.center + arm * ball.radius, direction }
    }

    /// The end of the butt, m, of a cue of 1.47 m.
    pub fn butt(&self) -> Vec3 {
        self.tip - self.direction * LENGTH
    }

    /// The strike of a cue in this pose with `speed` (m/s) on `ball`. The tip may be anywhere on
    /// the cue's axis, also before it touches the ball, and the direction may have any length.
    ///
    /// # Errors
    /// [`Error::Input`] if the direction has no length, points up or straight down, or if the axis
    /// misses the ball.
    pub fn strike(&self, speed: f64, ball: BallInSpace) -> Result<Strike, Error> {
        let Vec3 { x, y, z } = self.direction;
        let level = sqrt(x * x + y * y);
        if !self.direction.is_finite() || !self.tip.is_finite() {
            let what = "a coordinate is not a finite number";
            return Err(ErrorKind::OutOfRange.at("pose", what, "give finite numbers"));
        }
        if level == 0.0 || z > 0.0 {
            let what = format!("a cue along ({x:?}, {y:?}, {z:?}) has no azimuth, or points up");
            let remedy = "give the direction in which the cue moves: forwards, level or downwards";
            return Err(ErrorKind::OutOfRange.at("direction", what, remedy));
        }
        let (azimuth, elevation) = (atan2(y, x), atan2(0.0 - z, level));
        let [_, right, up] = axes(azimuth, elevation);
        let arm = (self.tip - ball.center) * (1.0 / ball.radius);
        let strike =
            Strike { speed, azimuth, elevation, side: arm.dot(right), height: arm.dot(up) };
        let offset = strike.offset();
        if offset >= 1.0 {
            let what = format!("the cue's axis passes the ball's centre at {offset:.4} ball radii");
            return Err(ErrorKind::MissesBall.at("tip", what, "let it point at the ball: below 1"));
        }
        Ok(strike)
    }
}

/// How far a cue is from what is nearest to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CueClearance {
    /// How much the cue may move across its axis, in its vertical plane, until it touches, m.
    /// Negative if it passes through.
    pub distance: f64,
    /// The ball or rail.
    pub nearest: Touched,
}

impl Shot {
    /// The pose of the cue for the shot's strike; none without a strike.
    pub fn cue_pose(&self) -> Option<CuePose> {
        let (ball, strike) = self.strike?;
        Some(CuePose::new(&strike, (&self.balls[ball]).into()))
    }

    /// The clearance of the cue over the balls and rails behind the struck ball; none without a
    /// strike, and if nothing is in the cue's vertical plane.
    pub fn cue_clearance(&self) -> Option<CueClearance> {
        let (ball, strike) = self.strike?;
        let clearance = self.cue_on(ball, &strike).clearance(strike.elevation);
        clearance.map(|(distance, nearest)| CueClearance { distance, nearest })
    }

    /// The strike of a cue in this pose with `speed` (m/s) on the ball with the index `ball`.
    ///
    /// # Errors
    /// As [`CuePose::strike`].
    pub fn strike_of_pose(&self, pose: &CuePose, speed: f64, ball: usize) -> Result<Strike, Error> {
        let struck: &PlacedBall = &self.balls[ball];
        pose.strike(speed, struck.into())
    }
}

//! A shot with other numbers: physics, start states and strike of a candidate.

use alloc::vec::Vec;

use super::{PlacedBall, Shot, balls};
use crate::error::{Error, ErrorKind};
use crate::math::Vec3;
use crate::physics::Physics;
use crate::resolve::cue_ball::Strike;

/// The centre (m), velocity (m/s) and spin (rad/s) of a ball at the start, in the file's coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StartState {
    /// Centre, m.
    pub position: Vec3,
    /// Velocity, m/s.
    pub velocity: Vec3,
    /// Spin, rad/s.
    pub angular_velocity: Vec3,
}

/// What a shot shall have in place of its own.
pub(crate) struct Changes<'a, P> {
    /// Changes the physics.
    pub(crate) physics: Option<P>,
    /// A start state for each ball.
    pub(crate) states: Option<&'a [StartState]>,
    /// A strike on the struck ball.
    pub(crate) strike: Option<Strike>,
    /// Whether the strike has the default elevation, if that of the shot is the default.
    pub(crate) default_elevation: bool,
}

impl Shot {
    /// The shot with `changes`, after the checks of a shot file.
    pub(crate) fn varied<P>(&self, changes: Changes<'_, P>) -> Result<Self, Error>
    where
        P: FnOnce(&mut Physics) -> Result<(), Error>,
    {
        let mut shot = self.clone();
        if let Some(change) = changes.physics {
            let mut physics = Physics::clone(&self.physics);
            physics.cue.tip_friction = self.tip_friction;
            change(&mut physics).map_err(|error| error.inside("physics"))?;
            shot.tip_friction = physics.cue.tip_friction;
            physics.cue.tip_friction = self.policy.used_tip_friction(shot.tip_friction);
            shot.physics = physics.into();
        }
        if let Some(states) = changes.states {
            let placed = |(own, start): (&PlacedBall, &StartState)| {
                let mut ball = own.clone();
                ball.state.position = start.position;
                ball.state.velocity = start.velocity;
                ball.state.angular_velocity = start.angular_velocity;
                ball
            };
            let all: Vec<PlacedBall> = self.balls.iter().zip(states).map(placed).collect();
            shot.balls = balls::checked(all, &self.table)?.into_inner();
        }
        if let Some(strike) = changes.strike {
            let Some((ball, _)) = self.strike else {
                return Err(ErrorKind::NoStrike.at(
                    "strike",
                    "the shot has no strike to vary",
                    "give it one",
                ));
            };
            shot.strike = Some((ball, strike));
        }
        shot.has_default_elevation &= changes.default_elevation;
        shot.checked()
    }
}

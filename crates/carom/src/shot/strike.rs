//! The `strike` of a shot file.

use alloc::format;
use alloc::string::String;

use super::PlacedBall;
use super::read::{At, LARGEST, Range};
use crate::MotionState;
use crate::error::Error;
use crate::math::{Vec3, radians};
use crate::physics::Physics;
use crate::resolve::cue_ball::{self, Strike, StrikeError};

/// Cue speeds, m/s: the record is about 15.
const SPEED: Range = Range::above(0.0, 50.0, " m/s");
const ELEVATION: Range = Range::half_open(0.0, 90.0, " degrees");
const OFFSET: Range = Range::closed(-1.0, 1.0, " ball radii");

/// Friction of a tip that never slips off.
pub(super) const TIP_THAT_HOLDS: f64 = LARGEST;

const KEYS: &[&str] =
    &["ball", "speed", "azimuth_deg", "elevation_deg", "side", "height", "obstruction", "miscue"];

/// What to do about something that a player could not do, or not cleanly.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Policy {
    /// Simulate, and say so in the outcome.
    Report,
    /// Refuse the shot.
    Refuse,
}

const POLICIES: &[(&str, Policy)] = &[("report", Policy::Report), ("refuse", Policy::Refuse)];

/// What to do about a strike that a player could not play cleanly.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct StrikePolicy {
    /// What to do if the cue would pass through a ball or a rail.
    pub obstruction: Policy,
    /// What to do if the tip would slip off.
    pub miscue: Policy,
}

impl Default for StrikePolicy {
    fn default() -> Self {
        Self { obstruction: Policy::Report, miscue: Policy::Refuse }
    }
}

/// Reads what `strike` says about policies.
pub(super) fn read_policy(at: &At<'_>) -> Result<StrikePolicy, Error> {
    let fields = at.fields(KEYS)?;
    let policy = |key, default| match fields.get(key) {
        Some(at) => at.choice("policy", POLICIES),
        None => Ok(default),
    };
    let StrikePolicy { obstruction, miscue } = StrikePolicy::default();
    Ok(StrikePolicy {
        obstruction: policy("obstruction", obstruction)?,
        miscue: policy("miscue", miscue)?,
    })
}

/// Reads the struck ball and the strike itself.
pub(super) fn read(
    at: &At<'_>,
    balls: &[PlacedBall],
    physics: &Physics,
) -> Result<(usize, Strike), Error> {
    let fields = at.fields(KEYS)?;
    let at_ball = fields.require("ball", "the id of the struck ball")?;
    let ball = find_ball(&at_ball, balls)?;
    let number = |key, range, default: Option<f64>, example| match (fields.get(key), default) {
        (Some(at), _) => at.number(range),
        (None, Some(default)) => Ok(default),
        (None, None) => fields.require(key, example)?.number(range),
    };
    let degrees = Range::any(" degrees");
    let strike = Strike {
        speed: number("speed", &SPEED, None, "the cue's speed in m/s")?,
        azimuth: radians(number("azimuth_deg", &degrees, None, "the cue's direction in degrees")?),
        elevation: radians(number("elevation_deg", &ELEVATION, Some(0.0), "")?),
        side: number("side", &OFFSET, Some(0.0), "")?,
        height: number("height", &OFFSET, Some(0.0), "")?,
    };
    check(at.place(), ball, &strike, balls, physics)?;
    Ok((ball, strike))
}

fn find_ball(at: &At<'_>, balls: &[PlacedBall]) -> Result<usize, Error> {
    let id = at.text("the id of the struck ball")?;
    balls.iter().position(|b| b.id == id).ok_or_else(|| {
        let mut ids = String::new();
        for (i, b) in balls.iter().take(24).enumerate() {
            ids += &format!("{}\"{}\"", if i > 0 { ", " } else { "" }, b.id);
        }
        if balls.len() > 24 {
            ids += ", ...";
        }
        at.refuse(format!("no ball has the id \"{id}\""), format!("write one of {ids}"))
    })
}

/// Refuses numbers that a shot file would refuse. `place` is where the strike stands.
pub(super) fn check_ranges(place: &str, strike: &Strike) -> Result<(), Error> {
    let quarter_turn = Range::half_open(0.0, core::f64::consts::FRAC_PI_2, " rad");
    for (key, value, range) in [
        ("speed", strike.speed, SPEED),
        ("azimuth", strike.azimuth, Range::any(" rad")),
        ("elevation", strike.elevation, quarter_turn),
        ("side", strike.side, OFFSET),
        ("height", strike.height, OFFSET),
    ] {
        range.check(|| format!("{place}.{key}"), value)?;
    }
    Ok(())
}

/// Refuses a strike on a ball that moves or is not on the cloth, out of range, off the ball, past the miscue limit, or out
/// of reach; otherwise the velocity (m/s) and the spin (rad/s) that it gives. `place` is where
/// the strike stands.
pub(super) fn check(
    place: &str,
    ball: usize,
    strike: &Strike,
    balls: &[PlacedBall],
    physics: &Physics,
) -> Result<(Vec3, Vec3), Error> {
    let struck = &balls[ball];
    if struck.state.velocity != Vec3::ZERO || struck.state.angular_velocity != Vec3::ZERO {
        return Err(Error::input(
            format!("{place}.ball"),
            format!("ball \"{}\" (balls[{}]) moves already", struck.id, ball),
            "strike a ball at rest, or leave the strike out",
        ));
    }
    if struck.state.motion == MotionState::Airborne {
        return Err(Error::input(
            format!("{place}.ball"),
            format!("ball \"{}\" (balls[{}]) does not lie on the cloth", struck.id, ball),
            "strike a ball that does, or leave the strike out",
        ));
    }
    cue_ball::resolve(&physics.cue, &struck.ball, strike).map_err(|e| explain(place, strike, e))
}

/// A refused strike in words. `place` is where the strike stands.
pub(super) fn explain(place: &str, strike: &Strike, e: StrikeError) -> Error {
    // The larger offset is the one to blame.
    let key = if strike.side.abs() >= strike.height.abs() { "side" } else { "height" };
    let place = format!("{place}.{key}");
    match e {
        StrikeError::OffBall { offset } => Error::input(
            place,
            format!("the tip would miss the ball: √(side² + height²) is {offset:.4} ball radii"),
            "keep it below 1, and below the miscue limit",
        ),
        StrikeError::Miscue { offset, limit } => Error::input(
            place,
            format!(
                "a miscue: √(side² + height²) is {offset:.4} ball radii, and this tip slips off beyond {limit:.4}"
            ),
            "strike nearer the centre, or raise physics.cue.tip_friction",
        ),
        StrikeError::Unreachable { offset } => Error::input(
            place,
            format!(
                "unreachable: physics.cue.tip_efficiency cannot hold {offset:.4} ball radii off centre (TP A.30's radicand is negative)"
            ),
            "strike nearer the centre, raise the efficiency, or use tip_restitution",
        ),
    }
}

//! What a shot must do. Lengths in m; places in the file's coordinates, origin at the bottom left corner.

use carom::table::PocketName;
use carom::{Error, ErrorKind, Shot};

use crate::area::DrillArea;

/// What a shot must do. Every shot must also keep the cue ball on the table.
#[derive(Clone, Debug, PartialEq)]
pub enum DrillCondition {
    /// The ball falls, into the pocket if one is given.
    Pot(String, Option<PocketName>),
    /// A ball falls that is not the cue ball.
    PotAny,
    /// The cue ball meets this ball first.
    First(String),
    /// The cue ball meets this number of cushions or more before a ball.
    Kick(u32),
    /// The ball meets the noses of this number of cushions or more.
    Cushions(String, u32),
    /// The cue ball meets two balls, the second after this number of cushions or more.
    Carom(u32),
    /// The cue ball meets all these balls.
    Touch(Vec<String>),
    /// The cue ball does not meet this ball.
    Avoid(String),
    /// The ball, or else the cue ball, stops in the area.
    Stop(Option<String>, DrillArea),
    /// At the end the cue ball cannot meet the ball on a straight line.
    Hidden(String),
    /// At the end the cue ball can pot the ball: see [`crate::lanes::can_pot`].
    Next(String),
    /// At the end the two balls lie at least so far apart (centres, m), or one has fallen.
    Apart([String; 2], f64),
    /// At the end every other ball lies within this distance (m) of the cue ball.
    Gather(f64),
}

/// The names of the kinds of condition in files.
pub const CONDITIONS: [&str; 13] = [
    "pot", "pot-any", "first", "kick", "cushions", "carom", "touch", "avoid", "stop", "hidden",
    "next", "apart", "gather",
];

impl DrillCondition {
    /// The name of its kind.
    pub const fn kind(&self) -> &'static str {
        CONDITIONS[match self {
            Self::Pot(..) => 0,
            Self::PotAny => 1,
            Self::First(_) => 2,
            Self::Kick(_) => 3,
            Self::Cushions(..) => 4,
            Self::Carom(_) => 5,
            Self::Touch(_) => 6,
            Self::Avoid(_) => 7,
            Self::Stop(..) => 8,
            Self::Hidden(_) => 9,
            Self::Next(_) => 10,
            Self::Apart(..) => 11,
            Self::Gather(_) => 12,
        }]
    }

    /// The balls that it names.
    pub fn balls(&self) -> &[String] {
        match self {
            Self::Pot(ball, _) | Self::Cushions(ball, _) => core::slice::from_ref(ball),
            Self::First(ball) | Self::Avoid(ball) | Self::Hidden(ball) | Self::Next(ball) => {
                core::slice::from_ref(ball)
            }
            Self::Touch(balls) => balls,
            Self::Apart(balls, _) => balls,
            Self::Stop(ball, _) => ball.as_slice(),
            Self::PotAny | Self::Kick(_) | Self::Carom(_) | Self::Gather(_) => &[],
        }
    }

    /// Refuses a condition at `place` that names a ball, pocket or marking that the shot lacks.
    pub(crate) fn check(&self, place: &str, shot: &Shot) -> Result<(), Error> {
        let key = if matches!(self, Self::Touch(_) | Self::Apart(..)) { "balls" } else { "ball" };
        let named = format!("{place}.{key}");
        self.balls().iter().try_for_each(|ball| check_ball(&named, ball, shot))?;
        match self {
            Self::Pot(_, Some(pocket))
                if !shot.table().pockets.iter().any(|known| known.name == *pocket) =>
            {
                let remedy = "take a table with pockets, or another condition";
                let place = format!("{place}.pocket");
                Err(ErrorKind::Unsupported.at(place, "the table has no such pocket", remedy))
            }
            Self::Stop(_, area) => area.check(&format!("{place}.area"), shot.table()),
            _ => Ok(()),
        }
    }
}

/// Points for the place where the cue ball stops.
#[derive(Clone, Debug, PartialEq)]
pub struct Zone {
    /// Where.
    pub area: DrillArea,
    /// How many.
    pub points: u32,
}

/// In which order a run pots its balls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RunOrder {
    /// In any order, but the last ball must be met and fall last.
    Eight,
    /// The first ball that is left must be met first; the last ball ends the run whenever it falls.
    Rotation,
    /// The first ball that is left must fall, and no other.
    Sequence,
}

impl RunOrder {
    /// Every order.
    pub const ALL: [Self; 3] = [Self::Eight, Self::Rotation, Self::Sequence];

    /// Its name in files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Eight => "eight",
            Self::Rotation => "rotation",
            Self::Sequence => "sequence",
        }
    }
}

/// The goal of an attempt.
#[derive(Clone, Debug, PartialEq)]
pub enum DrillGoal {
    /// One shot.
    Shot {
        /// What it must do.
        needs: Vec<DrillCondition>,
        /// The points of an attempt that does it, without zones.
        points: u32,
        /// From the smallest area to the largest: the first one that has the cue ball counts. An
        /// attempt that ends outside them all fails. Empty if the place does not matter.
        zones: Vec<Zone>,
    },
    /// Several shots, until one fails or the last ball falls: a point for every ball.
    Run {
        /// The balls to pot.
        balls: Vec<String>,
        /// In which order.
        order: RunOrder,
    },
}

impl DrillGoal {
    /// A goal of one shot and one point.
    pub const fn one(needs: Vec<DrillCondition>) -> Self {
        Self::Shot { needs, points: 1, zones: Vec::new() }
    }

    /// Refuses a goal at `place` that names a ball, pocket or marking that the shot lacks.
    pub(crate) fn check(&self, place: &str, shot: &Shot) -> Result<(), Error> {
        match self {
            Self::Run { balls, .. } => {
                let place = format!("{place}.balls");
                balls.iter().try_for_each(|ball| check_ball(&place, ball, shot))
            }
            Self::Shot { needs, zones, .. } => {
                for (k, need) in needs.iter().enumerate() {
                    need.check(&format!("{place}.needs[{k}]"), shot)?;
                }
                for (k, zone) in zones.iter().enumerate() {
                    zone.area.check(&format!("{place}.zones[{k}].area"), shot.table())?;
                }
                Ok(())
            }
        }
    }

    /// The most points of an attempt.
    pub fn most_points(&self) -> u32 {
        match self {
            Self::Shot { points, zones, .. } => {
                zones.iter().map(|zone| zone.points).max().unwrap_or(*points)
            }
            Self::Run { balls, .. } => balls.len() as u32,
        }
    }
}

fn check_ball(place: &str, ball: &str, shot: &Shot) -> Result<(), Error> {
    if shot.ball_index(ball).is_some() {
        return Ok(());
    }
    let known: Vec<&str> = shot.balls().iter().map(|ball| ball.id.as_str()).collect();
    let remedy = format!("write one of {}", known.join(", "));
    let what = format!("there is no ball \"{ball}\"");
    Err(ErrorKind::UnknownBall.at(place, what, remedy).with("ball", ball))
}

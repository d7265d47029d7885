//! The `strike` of a shot file.

use alloc::format;
use alloc::string::String;

use super::angle::{AZIMUTH, ELEVATION};
use super::node::{Node, word_of};
use super::read::At;
use crate::error::{Error, ErrorKind};
use crate::resolve::cue_ball::Strike;
use crate::shot::{OFFSET, PlacedBall, Policy, SPEED, StrikePolicy};

const KEYS: &[&str] = &[
    "ball",
    "speed",
    "azimuth",
    "azimuth_deg",
    "elevation",
    "elevation_deg",
    "side",
    "height",
    "obstruction",
    "miscue",
];

const POLICIES: &[(&str, Policy)] = &[("report", Policy::Report), ("refuse", Policy::Refuse)];

/// Largest number of ids that an error lists.
const MOST_IDS: usize = 24;

/// Reads the policies of `strike`.
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

impl StrikePolicy {
    /// The policies of these names, as `obstruction` and `miscue` of a shot file's `strike`.
    ///
    /// # Errors
    /// [`Error::Input`] for a name other than `report` and `refuse`.
    pub fn from_names(obstruction: &str, miscue: &str) -> Result<Self, Error> {
        let node = Node::object([("obstruction", obstruction.into()), ("miscue", miscue.into())]);
        read_policy(&At::root(&node)).map_err(|error| error.inside("strike"))
    }
}

/// A strike as a file has it.
pub(super) struct ReadStrike {
    /// The struck ball's index.
    pub(super) ball: usize,
    /// Its elevation is 0 if the file has none.
    pub(super) strike: Strike,
    /// Whether the file has an elevation.
    pub(super) has_elevation: bool,
}

/// Reads a strike. Whether it can be played is checked with the rest of the shot.
pub(super) fn read(at: &At<'_>, balls: &[PlacedBall]) -> Result<ReadStrike, Error> {
    let fields = at.fields(KEYS)?;
    let ball = find_ball(&fields.require("ball", "the id of the struck ball")?, balls)?;
    let offset = |key| fields.get(key).map_or(Ok(0.0), |at| at.number(&OFFSET));
    let speed = fields.require("speed", "the cue's speed in m/s")?.number(&SPEED)?;
    let azimuth = AZIMUTH.read(&fields)?.ok_or_else(|| {
        fields.missing("azimuth_deg", "the cue's direction in degrees, or `azimuth` in radians")
    })?;
    let elevation = ELEVATION.read(&fields)?;
    let strike = Strike {
        speed,
        azimuth,
        elevation: elevation.unwrap_or(0.0),
        side: offset("side")?,
        height: offset("height")?,
    };
    Ok(ReadStrike { ball, strike, has_elevation: elevation.is_some() })
}

fn find_ball(at: &At<'_>, balls: &[PlacedBall]) -> Result<usize, Error> {
    let id = at.text("the id of the struck ball")?;
    balls.iter().position(|b| b.id == id).ok_or_else(|| {
        let mut ids = String::new();
        for (i, b) in balls.iter().take(MOST_IDS).enumerate() {
            ids += &format!("{}\"{}\"", if i > 0 { ", " } else { "" }, b.id);
        }
        if balls.len() > MOST_IDS {
            ids += ", ...";
        }
        at.refuse(
            ErrorKind::UnknownBall,
            format!("no ball has the id \"{id}\""),
            format!("write one of {ids}"),
        )
        .with("ball", id)
    })
}

/// Writes the elevation of `strike` into `node`, an object; its other keys stay.
pub(super) fn write_elevation_into(node: &mut Node, strike: &Strike) {
    ELEVATION.write(node, strike.elevation);
}

/// Removes the elevation from `node`, an object.
pub(super) fn remove_elevation(node: &mut Node) {
    ELEVATION.remove(node);
}

/// Writes the struck ball's `id` and `strike` into `node`, an object; its other keys stay.
pub(super) fn write_into(node: &mut Node, id: &str, strike: &Strike) {
    node.set("ball", id);
    node.set("speed", strike.speed);
    AZIMUTH.write(node, strike.azimuth);
    ELEVATION.write(node, strike.elevation);
    node.set("side", strike.side);
    node.set("height", strike.height);
}

/// A strike as a shot file has it; `id` is that of the struck ball. Default values are left out,
/// but not the elevation: its default depends on the layout.
pub(super) fn write(id: &str, strike: &Strike, policy: StrikePolicy) -> Node {
    let mut node = Node::object([]);
    write_into(&mut node, id, strike);
    for (key, value) in [("side", strike.side), ("height", strike.height)] {
        if value == 0.0 {
            node.remove(key);
        }
    }
    let usual = StrikePolicy::default();
    for (key, policy, usual) in [
        ("obstruction", policy.obstruction, usual.obstruction),
        ("miscue", policy.miscue, usual.miscue),
    ] {
        if policy != usual {
            node.set(key, word_of(POLICIES, policy));
        }
    }
    node
}

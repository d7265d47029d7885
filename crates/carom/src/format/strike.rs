//! The `strike` of a shot file.

use alloc::format;
use alloc::string::String;
use core::f64::consts::FRAC_PI_2;

use super::key_path::KeyPath;
use super::node::{Node, word_of};
use super::read::{At, Fields};
use crate::error::Error;
use crate::math::{degrees, radians};
use crate::range::Range;
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

/// An angle that a file gives in radians or in degrees.
struct Angle {
    radians_key: &'static str,
    degrees_key: &'static str,
    radians: Range,
    degrees: Range,
}

const AZIMUTH: Angle = Angle {
    radians_key: "azimuth",
    degrees_key: "azimuth_deg",
    radians: Range::any(" rad"),
    degrees: Range::any(" degrees"),
};

const ELEVATION: Angle = Angle {
    radians_key: "elevation",
    degrees_key: "elevation_deg",
    radians: Range::half_open(0.0, FRAC_PI_2, " rad"),
    degrees: Range::half_open(0.0, 90.0, " degrees"),
};

impl Angle {
    /// The angle in radians, if either key is there.
    fn read(&self, fields: &Fields<'_>) -> Result<Option<f64>, Error> {
        match (fields.get(self.radians_key), fields.get(self.degrees_key)) {
            (Some(at), Some(_)) => Err(at.refuse(
                format!("{} gives the same angle", self.degrees_key),
                format!("keep {} (rad) or {} (degrees)", self.radians_key, self.degrees_key),
            )),
            (Some(at), None) => at.number(&self.radians).map(Some),
            (None, Some(at)) => at.number(&self.degrees).map(|angle| Some(radians(angle))),
            (None, None) => Ok(None),
        }
    }

    /// Writes `angle` (rad): in degrees if it reads back to the same bits, else in radians.
    fn write(&self, node: &mut Node, angle: f64) {
        let in_degrees = degrees(angle);
        let is_exact = radians(in_degrees).to_bits() == angle.to_bits();
        if is_exact && self.degrees.contains(in_degrees) {
            node.remove(self.radians_key);
            node.set(self.degrees_key, in_degrees);
        } else {
            node.remove(self.degrees_key);
            node.set(self.radians_key, angle);
        }
    }
}

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

/// Reads the struck ball's index and the strike itself. Whether it can be played is checked with
/// the rest of the shot.
pub(super) fn read(at: &At<'_>, balls: &[PlacedBall]) -> Result<(usize, Strike), Error> {
    let fields = at.fields(KEYS)?;
    let ball = find_ball(&fields.require("ball", "the id of the struck ball")?, balls)?;
    let offset = |key| fields.get(key).map_or(Ok(0.0), |at| at.number(&OFFSET));
    let speed = fields.require("speed", "the cue's speed in m/s")?.number(&SPEED)?;
    let azimuth = AZIMUTH.read(&fields)?.ok_or_else(|| {
        fields.missing("azimuth_deg", "the cue's direction in degrees, or `azimuth` in radians")
    })?;
    let elevation = ELEVATION.read(&fields)?.unwrap_or(0.0);
    Ok((
        ball,
        Strike { speed, azimuth, elevation, side: offset("side")?, height: offset("height")? },
    ))
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
        at.refuse(format!("no ball has the id \"{id}\""), format!("write one of {ids}"))
    })
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

/// If `path` is an angle of the strike in one unit, removes the same angle in the other unit, so
/// that the file has the angle once.
pub(super) fn remove_other_unit(file: &mut Node, path: &KeyPath) {
    for Angle { radians_key, degrees_key, .. } in [&AZIMUTH, &ELEVATION] {
        for (written, other) in [(radians_key, degrees_key), (degrees_key, radians_key)] {
            if path.is(&["strike", *written])
                && let Node::Object(fields) = file
                && let Some((_, strike)) = fields.iter_mut().find(|(key, _)| key == "strike")
            {
                strike.remove(other);
            }
        }
    }
}

/// A strike as a shot file has it; `id` is that of the struck ball. Default values are left out.
pub(super) fn write(id: &str, strike: &Strike, policy: StrikePolicy) -> Node {
    let mut node = Node::object([]);
    write_into(&mut node, id, strike);
    for (key, value) in
        [("elevation_deg", strike.elevation), ("side", strike.side), ("height", strike.height)]
    {
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

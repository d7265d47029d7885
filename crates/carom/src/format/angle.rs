//! Angles that a file may have in radians or in degrees.

use alloc::format;

use super::key_path::KeyPath;
use super::node::Node;
use super::read::Fields;
use crate::error::{Error, ErrorKind};
use crate::math::{degrees, radians};
use crate::range::Range;
use crate::shot;

/// An angle that a file gives in radians or in degrees.
pub(super) struct Angle {
    /// The object that has it, as the keys that lead there.
    parent: &'static [&'static str],
    radians_key: &'static str,
    degrees_key: &'static str,
    radians: Range,
    degrees: Range,
}

pub(super) const AZIMUTH: Angle = Angle {
    parent: &["strike"],
    radians_key: "azimuth",
    degrees_key: "azimuth_deg",
    radians: Range::any(" rad"),
    degrees: Range::any(" degrees"),
};

pub(super) const ELEVATION: Angle = Angle {
    parent: &["strike"],
    radians_key: "elevation",
    degrees_key: "elevation_deg",
    radians: shot::ELEVATION,
    degrees: Range::half_open(0.0, 90.0, " degrees"),
};

pub(super) const STROKE_ELEVATION: Angle = Angle {
    parent: &["physics", "cue"],
    radians_key: "stroke_elevation",
    degrees_key: "stroke_elevation_deg",
    ..ELEVATION
};

impl Angle {
    /// The key in radians, and the one in degrees.
    pub(super) const fn keys(&self) -> [&'static str; 2] {
        [self.radians_key, self.degrees_key]
    }

    /// Its ranges in radians and in degrees.
    pub(super) fn ranges(&self) -> [Range; 2] {
        [self.radians.in_unit(" rad"), self.degrees.in_unit(" deg")]
    }

    /// The angle in radians, if either key is there.
    pub(super) fn read(&self, fields: &Fields<'_>) -> Result<Option<f64>, Error> {
        match (fields.get(self.radians_key), fields.get(self.degrees_key)) {
            (Some(at), Some(_)) => Err(at.refuse(
                ErrorKind::Duplicate,
                format!("{} gives the same angle", self.degrees_key),
                format!("keep {} (rad) or {} (degrees)", self.radians_key, self.degrees_key),
            )),
            (Some(at), None) => at.number(&self.radians).map(Some),
            (None, Some(at)) => at.number(&self.degrees).map(|angle| Some(radians(angle))),
            (None, None) => Ok(None),
        }
    }

    /// Removes the angle from `node`, an object.
    pub(super) fn remove(&self, node: &mut Node) {
        node.remove(self.radians_key);
        node.remove(self.degrees_key);
    }

    /// Writes `angle` (rad): in degrees if it reads back to the same bits, else in radians.
    pub(super) fn write(&self, node: &mut Node, angle: f64) {
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

/// If `path` is an angle in one unit, removes the same angle in the other unit, so that the file
/// has the angle once.
pub(super) fn remove_other_unit(file: &mut Node, path: &KeyPath) {
    for angle in [&AZIMUTH, &ELEVATION, &STROKE_ELEVATION] {
        let (parent, [in_radians, in_degrees]) = (angle.parent, angle.keys());
        for (written, other) in [(in_radians, in_degrees), (in_degrees, in_radians)] {
            let keys: alloc::vec::Vec<&str> = parent.iter().copied().chain([written]).collect();
            if path.is(&keys) {
                let parent = parent.iter().try_fold(&mut *file, |node, key| node.get_mut(key));
                if let Some(parent) = parent {
                    parent.remove(other);
                }
            }
        }
    }
}

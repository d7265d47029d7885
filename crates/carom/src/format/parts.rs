//! The parts of a shot file, checked by themselves, before there is a shot.

use super::node::Node;
use super::read::At;
use super::{balls, physics, table};
use crate::error::Error;
use crate::{Ball, Physics, edition};

/// Checks the `table` of a shot file.
///
/// # Errors
/// [`Error::Input`] as for a shot file with this table.
pub fn check_table(value: &Node) -> Result<(), Error> {
    table::read(&At::root(value)).map(|_| ()).map_err(|error| error.inside("table"))
}

/// Checks the `physics` of a shot file. Without a `base` it is that of the table, which is not known
/// here, so the physics is refused only if no preset could be its base.
///
/// # Errors
/// [`Error::Input`] as for a shot file with this physics.
pub fn check_physics(value: &Node) -> Result<(), Error> {
    let read = |base: &str| physics::read(Some(&At::root(value)), base);
    let bases = edition::names(edition::PHYSICS);
    let mut refused = None;
    for base in bases {
        match read(base) {
            Ok(_) => return Ok(()),
            Err(error) => refused = refused.or(Some(error)),
        }
    }
    refused.map_or(Ok(()), |error| Err(error.inside("physics")))
}

/// Checks the `balls` of a shot file: keys and numbers, and not whether the balls have room.
///
/// # Errors
/// [`Error::Input`] as for a shot file with these balls.
pub fn check_balls(value: &Node) -> Result<(), Error> {
    let default: Ball = Physics::pool().ball;
    balls::read(&At::root(value), &default).map(|_| ()).map_err(|error| error.inside("balls"))
}

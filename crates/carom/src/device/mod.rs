//! Shots as flat arrays, for devices that are not this machine's cores, such as graphics cards.
//!
//! [`FlatShots`] holds many shots without pointers: their tables, physics and balls, each stored once
//! if several shots share it. A device gets the bytes of these arrays and runs
//! [`FlatView::play`] for each shot, the same source as on this machine, compiled for the device. The
//! types have the C layout, because device and machine may have different compilers (docs/gpu.md).

mod flat;

use alloc::vec;
use alloc::vec::Vec;
use core::fmt::Debug;

pub use flat::{FlatBall, FlatEnd, FlatRow, FlatShot, FlatShots, FlatView, NO_STRIKE};

use crate::error::Error;
use crate::math::Vec3;

/// The results of [`FlatShots`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FlatEnds {
    /// Number of places for balls of each shot.
    pub width: usize,
    /// The end of every shot.
    pub end: Vec<FlatEnd>,
    /// Final centres in the file's coordinates, m.
    pub position: Vec<Vec3>,
    /// Pockets, as in [`BatchResult::pocket`](crate::batch::BatchResult::pocket).
    pub pocket: Vec<i8>,
}

impl FlatEnds {
    /// Room for the results of `shots`.
    pub fn of(shots: &FlatShots) -> Self {
        let (count, width) = (shots.shots.len(), shots.width);
        let places = count * width;
        Self {
            width,
            end: vec![FlatEnd::default(); count],
            position: vec![Vec3::ZERO; places],
            pocket: vec![0; places],
        }
    }
}

/// Something that plays many shots at once, with the bits that the engine has on this machine.
pub trait Device: Debug + Send + Sync {
    /// The most balls of a shot that it can play.
    fn most_balls(&self) -> usize;

    /// The most shots of one call. Its memory depends on this number.
    fn most_shots(&self) -> usize;

    /// Plays `shots`.
    ///
    /// # Errors
    /// [`Error::Input`] of the kind [`System`](crate::ErrorKind::System) if it cannot.
    fn play(&self, shots: &FlatShots) -> Result<FlatEnds, Error>;
}

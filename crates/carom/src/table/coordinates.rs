//! The two systems of coordinates. In files, traces and arrays the origin is the bottom left
//! corner of the playing area; in the engine it is the centre, so that a mirrored table has
//! mirrored bits.

use super::TableGeometry;
use crate::BallState;
use crate::math::{Vec2, Vec3};

impl TableGeometry {
    /// The engine's origin in the file's coordinates, m: the centre of the playing area, or the
    /// file's own origin on unbounded cloth.
    pub fn center(&self) -> Vec2 {
        let half = |size: f64| if size.is_finite() { 0.5 * size } else { 0.0 };
        Vec2::new(half(self.size.x), half(self.size.y))
    }

    /// `state`, given in the file's coordinates, converted to the engine's.
    pub fn to_engine_coordinates(&self, state: &BallState) -> BallState {
        shifted(state, -self.center())
    }

    /// `state`, given in the engine's coordinates, converted to the file's.
    pub fn to_file_coordinates(&self, state: &BallState) -> BallState {
        shifted(state, self.center())
    }

    /// [`Self::to_file_coordinates`] of a ball that began the shot in the state `start`, given in
    /// the file's coordinates. A coordinate that has not changed since then gets exactly the value
    /// of `start`; the conversion would round it.
    pub fn to_file_coordinates_from(&self, start: &BallState, state: &BallState) -> BallState {
        let began = self.to_engine_coordinates(start).position;
        let mut out = self.to_file_coordinates(state);
        if state.position.x == began.x {
            out.position.x = start.position.x;
        }
        if state.position.y == began.y {
            out.position.y = start.position.y;
        }
        out
    }
}

fn shifted(state: &BallState, by: Vec2) -> BallState {
    let Vec3 { x, y, z } = state.position;
    BallState { position: Vec3::new(x + by.x, y + by.y, z), ..*state }
}

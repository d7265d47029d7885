//! The positions of the sights.

use alloc::vec::Vec;

use super::{PocketLayout, Table};
use crate::math::Vec2;

impl Table {
    /// Centres of the sights, m, in the engine's coordinates: bottom and top rail from left to
    /// right, then left and right rail upwards. Empty if the description has no sights. There is
    /// none at the ends of a rail and at a pocket.
    pub fn sight_positions(&self) -> Vec<Vec2> {
        let mut positions = Vec::new();
        let Some(description) = &self.description else { return positions };
        let Some(sights) = description.sights else { return positions };
        let half = self.index.half;
        let along = |half: f64, intervals: u32, i: u32| {
            half * (2.0 * f64::from(i) / f64::from(intervals) - 1.0)
        };
        for side in [-1.0, 1.0] {
            for i in 1..sights.along_width {
                let x = along(half.x, sights.along_width, i);
                positions.push(Vec2::new(x, side * (half.y + sights.setback)));
            }
        }
        for side in [-1.0, 1.0] {
            for i in 1..sights.along_length {
                let at_pocket =
                    description.pockets == PocketLayout::Six && 2 * i == sights.along_length;
                if !at_pocket {
                    let y = along(half.y, sights.along_length, i);
                    positions.push(Vec2::new(side * (half.x + sights.setback), y));
                }
            }
        }
        positions
    }
}

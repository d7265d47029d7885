//! Regions of the table in which a cue ball in hand may be placed.

use carom::Table;

use crate::markings::{distance, head_string, the_d};
use crate::state_bytes::state_bytes;

/// A region of the table in which a cue ball in hand may be placed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Region {
    /// Anywhere on the table.
    Anywhere,
    /// Behind the head string: the ball's centre is nearer to the head rail than the string is.
    BehindHeadString,
    /// In the D, its lines included.
    TheD,
}

state_bytes!(
    enum Region {
        Anywhere,
        BehindHeadString,
        TheD,
    }
);

impl Region {
    /// Whether a ball with its centre at `place` (file coordinates, m) is in the region.
    pub fn holds(self, table: &Table, place: [f64; 2]) -> bool {
        match self {
            Self::Anywhere => true,
            Self::BehindHeadString => place[1] < head_string(table),
            Self::TheD => {
                let (center, radius) = the_d(table);
                place[1] <= center[1] && distance(place, center) <= radius
            }
        }
    }

    /// The bounding box of the region: its lower left and upper right corners (file coordinates,
    /// m).
    pub fn bounds(self, table: &Table) -> [[f64; 2]; 2] {
        let size = table.size;
        match self {
            Self::Anywhere => [[0.0, 0.0], [size.x, size.y]],
            Self::BehindHeadString => [[0.0, 0.0], [size.x, head_string(table)]],
            Self::TheD => {
                let ([middle, line], radius) = the_d(table);
                [[middle - radius, line - radius], [middle + radius, line]]
            }
        }
    }

    /// The region's limits in numbers (file coordinates, m), after the words "put it" of an error
    /// message.
    pub fn limits(self, table: &Table) -> String {
        let [[left, bottom], [right, top]] = self.bounds(table);
        match self {
            Self::Anywhere => format!("within {left} < x < {right} and {bottom} < y < {top} (m)"),
            Self::BehindHeadString => format!("where y < {} m", head_string(table)),
            Self::TheD => {
                let ([x, y], radius) = the_d(table);
                format!("where y ≤ {y} m, at most {radius} m from [{x}, {y}]")
            }
        }
    }

    /// The region's name in files and in Python.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Anywhere => "anywhere",
            Self::BehindHeadString => "behind-head-string",
            Self::TheD => "the-d",
        }
    }

    /// The region in words, as error messages use it.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Anywhere => "on the table",
            Self::BehindHeadString => "behind the head string",
            Self::TheD => "in the D",
        }
    }
}

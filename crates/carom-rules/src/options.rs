//! The options of a frame.

use carom::format::Node;
use carom::{Error, ErrorKind};

/// The settings of a frame, agreed before it starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Points needed to win: straight pool (usually 100 to 150) and three-cushion (usually 40).
    pub points: i32,
    /// Whether the foul-and-a-miss rule applies in snooker.
    pub miss: bool,
    /// Number of consecutive shots without progress that make a stalemate. A shot makes progress if
    /// fewer balls than ever since the last rack remain on the table; in straight pool and
    /// three-cushion, if it raises a player's best score. The limit guarantees that every frame
    /// ends.
    pub patience: u32,
}

impl Default for Options {
    fn default() -> Self {
        Self { points: 40, miss: true, patience: 100 }
    }
}

impl Options {
    /// The options as an object, in the form of a record.
    pub fn to_node(&self) -> Node {
        let Self { points, miss, patience } = *self;
        Node::object([
            ("points", i64::from(points).into()),
            ("miss", miss.into()),
            ("patience", patience.into()),
        ])
    }

    /// Checks that all options are in range.
    ///
    /// # Errors
    /// [`Error::Input`] if one is not.
    pub fn check(&self) -> Result<(), Error> {
        let wrong = |place: &str, value: i64| {
            Err(ErrorKind::OutOfRange.at(
                place,
                format!("{value} is out of range"),
                "write at least 1",
            ))
        };
        if self.points < 1 {
            return wrong("options.points", self.points.into());
        }
        if self.patience < 1 {
            return wrong("options.patience", self.patience.into());
        }
        Ok(())
    }
}

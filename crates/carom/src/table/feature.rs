//! What a ball can meet on a table.

/// Something that a ball can meet on a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum TableFeature {
    /// Index into `Table::cushions`.
    Cushion(u16),
    /// A pocket, index into `Table::pockets`: the ball's centre comes over the hole. Where the
    /// pocket captures at its mouth, the centre crosses the mouth line.
    Pocket(u8),
    /// The slate, from above.
    Slate,
    /// The edge of a hole in the slate, index into `Table::pockets`.
    Lip(u8),
    /// A depth in the hole of a pocket, index into `Table::pockets`. First the ball's centre comes
    /// down to the slate's surface, then to one radius below it.
    Depth(u8),
    /// The edge of a rail's top, where a ball on the top loses its support.
    Brink,
    /// The outer border of the rails.
    Border,
}

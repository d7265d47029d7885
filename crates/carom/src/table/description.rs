//! The description of a table in a maker's terms: plain data, from which the geometry follows.

use alloc::string::String;
use alloc::vec::Vec;

/// Inch, m.
pub(crate) const INCH: f64 = 0.0254;

/// A table with rails. Every preset is one of these; unbounded cloth is [`Table::unbounded`].
///
/// In the shot file the keys are the fields' names.
///
/// [`Table::unbounded`]: crate::Table::unbounded
#[derive(Clone, Debug, PartialEq)]
pub struct TableDescription {
    /// Playing area along y, nose line to nose line, m. Greater than 0.
    pub length: f64,
    /// Playing area along x, nose line to nose line, m. Greater than 0.
    pub width: f64,
    /// Height of the nose line above the slate, m. Between 0 and the diameter of the balls, 0.6 to
    /// 0.75 of it on real tables.
    pub cushion_height: f64,
    /// Width of the rubber: from the nose line to where the facings end, m. Greater than 0.
    pub cushion_width: f64,
    /// Width of the rail, cushion included, m: a ball whose centre is further out is off the table.
    /// At least `cushion_width`, and wide enough to hold the holes.
    pub rail_width: f64,
    /// Whether there are pockets.
    pub pockets: PocketLayout,
    /// What captures a ball.
    pub pocket_model: PocketModel,
    /// The four corner pockets; needed where `pockets` is `six`.
    pub corner_pocket: Option<PocketDescription>,
    /// The two pockets in the middle of the long rails; needed where `pockets` is `six`.
    pub side_pocket: Option<PocketDescription>,
    /// Marks on the rails. They are only drawn.
    pub sights: Option<Sights>,
    /// Lines and spots on the cloth. They are drawn, and racks use them.
    pub markings: Markings,
    /// Name of the physics preset that belongs to the table.
    pub physics: String,
}

/// The pockets of a table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum PocketLayout {
    /// No pockets.
    #[default]
    None,
    /// Four in the corners, two in the middle of the long rails.
    Six,
}

/// What captures a ball.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum PocketModel {
    /// A ball falls when its centre is over the hole in the slate, and is captured once it cannot
    /// come back.
    #[default]
    DropCircle,
    /// The ball's centre crosses the line from tip to tip away from the table's centre (Leckie &
    /// Greenspan 2006, section 2.2). There is no table behind that line.
    MouthLine,
}

/// The shape of a pocket and of its two jaws.
///
/// A tip is the point where a nose line and the line of a facing would meet if the corner were not
/// rounded. Mouths are measured from tip to tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PocketDescription {
    /// Distance between the two tips, m.
    pub mouth: f64,
    /// Angle inside the rubber between nose and facing, degrees. Facings are parallel at 135 in a
    /// corner and at 90 in a side pocket; with larger angles the pocket narrows inwards.
    pub cut_angle_deg: f64,
    /// From the mouth (the line from tip to tip) to the edge of the hole, along the pocket's axis,
    /// m. Negative where the hole reaches in front of the mouth.
    pub shelf: f64,
    /// Radius of the hole in the slate, m.
    pub hole_radius: f64,
    /// Radius that rounds the point between nose and facing, m; 0 leaves it sharp.
    pub point_radius: f64,
    /// Distance between the deep ends of the two facings, m, if it differs from the one that
    /// `cut_angle_deg` gives: the facing is then straight from the rounding to that end.
    pub throat: Option<f64>,
}

/// Positions of the sights (diamonds) on the rails.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sights {
    /// Intervals along the length; the ends and, with pockets, the middle have no sight.
    pub along_length: u32,
    /// Intervals along the width.
    pub along_width: u32,
    /// From the nose line to the sight's centre, m.
    pub setback: f64,
}

/// Lines and spots on the cloth. Distances are from the bottom nose line, the breaker's end.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Markings {
    /// The head string or baulk line, m.
    pub head_string: Option<f64>,
    /// Radius of the D, m.
    pub d_radius: Option<f64>,
    /// Spots.
    pub spots: Vec<Spot>,
}

/// A spot on the cloth.
#[derive(Clone, Debug, PartialEq)]
pub struct Spot {
    /// Its name: `head`, `center`, `foot`, or that of the ball that stands on it.
    pub name: String,
    /// Its position in the file's coordinates (origin at the bottom left corner), m.
    pub position: [f64; 2],
}

/// 63.5 % of a pool ball's diameter (WPA), m.
const CUSHION_HEIGHT: f64 = 0.635 * (2.25 * INCH);
/// The wider of the WPA's limits, 2 in.
const CUSHION_WIDTH: f64 = 2.0 * INCH;
/// 5 in, within the WPA's 4 to 7½ in.
const RAIL_WIDTH: f64 = 5.0 * INCH;

impl TableDescription {
    /// A plain rectangle of `width` by `length` (m) with the WPA's nose height and no pockets.
    pub fn rectangle(width: f64, length: f64) -> Self {
        Self {
            length,
            width,
            cushion_height: CUSHION_HEIGHT,
            cushion_width: CUSHION_WIDTH,
            rail_width: RAIL_WIDTH,
            pockets: PocketLayout::None,
            pocket_model: PocketModel::DropCircle,
            corner_pocket: None,
            side_pocket: None,
            sights: None,
            markings: Markings::default(),
            physics: "pool".into(),
        }
    }
}

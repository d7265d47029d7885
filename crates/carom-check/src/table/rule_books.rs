//! Published figures of the tables that have a name. They are written here as their sources print
//! them, and not read from the engine's presets.

/// Inch, m.
const INCH: f64 = 0.0254;

/// What a source says about one dimension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Figure {
    /// One value. The judge uses it.
    Is(f64),
    /// The limits of a range. The judge uses the value of the shot if it is inside.
    Within(f64, f64),
}

use Figure::{Is, Within};

/// Dimensions by their keys in docs/tables.md, m or degrees.
pub(crate) type Sheet = &'static [(&'static str, Figure)];

/// WPA equipment specifications, 9 ft: playing area 100 by 50 in; nose at 63.5 % of the diameter of
/// a ball of 2¼ in; cushion 1⅞ to 2 in; rail 4 to 7½ in; corner pocket: mouth 4½ to 4⅝ in, 142°,
/// shelf 1 to 2¼ in; side pocket: mouth 5 to 5⅛ in, 104°, shelf 0 to ⅜ in. Radii of holes and
/// points are not published.
const WPA_9FT: Sheet = &[
    ("length", Is(100.0 * INCH)),
    ("width", Is(50.0 * INCH)),
    ("cushion_height", WPA_NOSE),
    ("cushion_width", WPA_CUSHION),
    ("rail_width", WPA_RAIL),
    ("corner_pocket.mouth", WPA_CORNER_MOUTH),
    ("corner_pocket.cut_angle_deg", Is(142.0)),
    ("corner_pocket.shelf", WPA_CORNER_SHELF),
    ("side_pocket.mouth", WPA_SIDE_MOUTH),
    ("side_pocket.cut_angle_deg", Is(104.0)),
    ("side_pocket.shelf", WPA_SIDE_SHELF),
];

/// The same, 8 ft: playing area 92 by 46 in.
const WPA_8FT: Sheet = &[
    ("length", Is(92.0 * INCH)),
    ("width", Is(46.0 * INCH)),
    ("cushion_height", WPA_NOSE),
    ("cushion_width", WPA_CUSHION),
    ("rail_width", WPA_RAIL),
    ("corner_pocket.mouth", WPA_CORNER_MOUTH),
    ("corner_pocket.cut_angle_deg", Is(142.0)),
    ("corner_pocket.shelf", WPA_CORNER_SHELF),
    ("side_pocket.mouth", WPA_SIDE_MOUTH),
    ("side_pocket.cut_angle_deg", Is(104.0)),
    ("side_pocket.shelf", WPA_SIDE_SHELF),
];

const WPA_NOSE: Figure = Is(63.5 / 100.0 * 2.25 * INCH);
const WPA_CUSHION: Figure = Within(1.875 * INCH, 2.0 * INCH);
const WPA_RAIL: Figure = Within(4.0 * INCH, 7.5 * INCH);
const WPA_CORNER_MOUTH: Figure = Within(4.5 * INCH, 4.625 * INCH);
const WPA_CORNER_SHELF: Figure = Within(1.0 * INCH, 2.25 * INCH);
const WPA_SIDE_MOUTH: Figure = Within(5.0 * INCH, 5.125 * INCH);
const WPA_SIDE_SHELF: Figure = Within(0.0, 0.375 * INCH);

/// WPBSA rules of snooker, section 1: 3569 by 1778 mm. Mathavan, Jackson & Parkin 2010: nose at 7/5
/// of the radius of a ball of 52.5 mm. The WPBSA does not publish its templates of the pockets; the
/// other figures are those of pooltool 0.6.0, whose depth is that of the hole's centre behind the
/// nose lines: corner 80.14 mm wide, 67.35 mm deep; side 84.57 mm wide, 51.59 mm deep.
const SNOOKER_12FT: Sheet = &[
    ("length", Is(3.569)),
    ("width", Is(1.778)),
    ("cushion_height", Is(7.0 / 5.0 * 0.0525 / 2.0)),
    ("cushion_width", Is(0.04763)),
    ("corner_pocket.mouth", Is(0.08014)),
    ("corner_pocket.cut_angle_deg", Is(135.0)),
    ("corner_pocket.shelf", Is(0.08014 / 2.0 + 0.06735 - 0.0889)),
    ("corner_pocket.hole_radius", Is(0.0889)),
    ("corner_pocket.point_radius", Is(0.0889)),
    ("side_pocket.mouth", Is(0.08457)),
    ("side_pocket.cut_angle_deg", Is(90.0)),
    ("side_pocket.shelf", Is(0.05159 - 0.05319)),
    ("side_pocket.hole_radius", Is(0.05319)),
    ("side_pocket.point_radius", Is(0.0669)),
];

/// UMB rules, chapter II: 2840 by 1420 mm, nose at 37 mm, frame 125 ± 10 mm behind the cushion (2
/// in, not published).
const CAROM_10FT: Sheet = &[
    ("length", Is(2.84)),
    ("width", Is(1.42)),
    ("cushion_height", Is(0.037)),
    ("rail_width", Within(0.115 + 2.0 * INCH, 0.135 + 2.0 * INCH)),
];

/// WEPF specifications of world eight-ball pool: 6 by 3 ft to 7 by 3½ ft. BAPTO standard: mouths of
/// 1.6 balls of 2 in. The rest of the pockets is not published.
const ENGLISH_7FT: Sheet = &[
    ("length", Within(72.0 * INCH, 84.0 * INCH)),
    ("width", Within(36.0 * INCH, 42.0 * INCH)),
    ("corner_pocket.mouth", Is(1.6 * 2.0 * INCH)),
    ("side_pocket.mouth", Is(1.6 * 2.0 * INCH)),
];

/// pooltool 0.6.0, table `7_foot_showood`: its angles are those between facing and axis (5.3° and
/// 7.14°), its depths those of the hole's centre behind the nose lines (41.7 and 68.5 mm). Nose at
/// 64 % of a ball of 2¼ in. Facings of the side pocket are moved inwards by the sine of their angle
/// times the width of the cushion, 2 in.
const SHOWOOD_7FT: Sheet = &[
    ("length", Is(1.9812)),
    ("width", Is(0.9906)),
    ("cushion_height", Is(0.64 * 2.25 * INCH)),
    ("cushion_width", Is(2.0 * INCH)),
    ("corner_pocket.mouth", Is(0.118)),
    ("corner_pocket.cut_angle_deg", Is(135.0 + 5.3)),
    ("corner_pocket.shelf", Is(0.118 / 2.0 + 0.0417 - 0.062)),
    ("corner_pocket.hole_radius", Is(0.062)),
    ("corner_pocket.point_radius", Is(0.02095)),
    ("side_pocket.mouth", Is(0.137)),
    ("side_pocket.cut_angle_deg", Is(90.0 + 7.14)),
    ("side_pocket.shelf", Is(0.0685 - 0.0645)),
    ("side_pocket.hole_radius", Is(0.0645)),
    ("side_pocket.point_radius", Is(0.00795)),
    ("side_pocket.throat", Is(0.137 - 2.0 * 2.0 * INCH * SIN_7_14_DEG)),
];

/// sin 7.14°: x − x³/6 + x⁵/120 − x⁷/5040 with x = 7.14 π/180.
const SIN_7_14_DEG: f64 = {
    let x = 7.14 * core::f64::consts::PI / 180.0;
    x * (1.0 - x * x / 6.0 * (1.0 - x * x / 20.0 * (1.0 - x * x / 42.0)))
};

/// FastFiz 0.2, `FastFiz.h`: 2.236 by 1.116 m; a ball of 1⅛ in rebounds a radius from the rail's
/// line; the mouths are lines 110 and 120 mm long with sharp ends.
const POOLFIZ: Sheet = &[
    ("length", Is(2.236)),
    ("width", Is(1.116)),
    ("cushion_height", Is(1.125 * INCH)),
    ("corner_pocket.mouth", Is(0.11)),
    ("corner_pocket.point_radius", Is(0.0)),
    ("side_pocket.mouth", Is(0.12)),
    ("side_pocket.point_radius", Is(0.0)),
];

/// Chinese Billiards Association, rules of eight-ball (szxjbilliards.com): 2540 by 1270 mm. Its pockets and cushions are
/// not published.
const CHINESE_9FT: Sheet = &[("length", Is(2.540)), ("width", Is(1.270))];

/// The published figures of the table `name`. Nothing is published about `bar-7ft` and `carom-9ft`.
pub(crate) fn sheet(name: &str) -> Sheet {
    match name {
        "wpa-9ft" => WPA_9FT,
        "wpa-8ft" => WPA_8FT,
        "showood-7ft" => SHOWOOD_7FT,
        "snooker-12ft" => SNOOKER_12FT,
        "english-7ft" => ENGLISH_7FT,
        "carom-10ft" => CAROM_10FT,
        "poolfiz" => POOLFIZ,
        "chinese-9ft" => CHINESE_9FT,
        _ => &[],
    }
}

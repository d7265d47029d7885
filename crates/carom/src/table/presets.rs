//! The table presets. Every figure has its source; `docs/tables.md` lists them.

use alloc::string::ToString;
use alloc::sync::Arc;

use super::description::INCH;
use super::sheet::{Figure, PocketSheet, Sheet, Source, SpotPattern, figure};
use super::{PocketModel, Table, TableDescription};
use crate::edition::{self, Edition};

/// Names of the presets, without dates, in the order in which `carom tables` lists them.
/// [`edition::TABLES`] also has the dated names.
pub const PRESETS: [&str; 10] = edition::undated(edition::TABLES);

const WPA: Source = Source::RuleBook("WPA equipment specifications");
const WPBSA: Source = Source::RuleBook("WPBSA rules of snooker, section 1");
const UMB: Source = Source::RuleBook("UMB rules, chapter II");
const WEPF: Source = Source::RuleBook("WEPF world eight-ball pool specifications");
const BAPTO: Source = Source::RuleBook("BAPTO standard for UK pool tables");
const SHOWOOD: Source = Source::Published("pooltool 0.6.0, table 7_foot_showood");
const PT_SNOOKER: Source = Source::Published("pooltool 0.6.0, its snooker table");
const MATHAVAN: Source = Source::Published("Mathavan, Jackson & Parkin 2010: h = 7R/5, R 26.25 mm");
const FASTFIZ: Source = Source::Published("FastFiz 0.2, FastFiz.h");
const CBSA: Source =
    Source::Published("Chinese Billiards Association, rules of eight-ball, szxjbilliards.com");
const IN_THE_TRADE: Source = Source::Estimated(
    "dealers give about 82 to 85 mm for corners, 86 to 90 mm for sides; none found to cite",
);
const BEHIND_THE_LINE: Source = Source::Estimated("behind the mouth line, never reached");
const UNREGULATED: Source = Source::Estimated("the rule book leaves it open");
const LIKE_WPA: Source = Source::Estimated("as on the WPA's tables");
const LIKE_SNOOKER: Source =
    Source::Estimated("as on the snooker table, in proportion to the ball");
const LIKE_10FT: Source = Source::Estimated("as on the 10-ft carom table");
const OUTSIDE_7FT: Source = Source::Estimated("a \"7 ft\" table measures that outside");
const DRAWN: Source = Source::Estimated("drawn only");

const fn inches(value: f64, source: Source) -> Figure {
    figure(value * INCH, source)
}

/// 63.5 ± 1 % of the diameter of a pool ball, 2¼ in.
const WPA_NOSE: Figure = figure(0.635 * (2.25 * INCH), WPA);

/// Mouth 4½ to 4⅝ in, 142 ± 1°, shelf 1 to 2¼ in.
const WPA_CORNER: PocketSheet = PocketSheet {
    mouth: inches(4.5625, WPA),
    cut_angle_deg: figure(142.0, WPA),
    shelf: inches(1.625, WPA),
    hole_radius: inches(2.4375, UNREGULATED),
    point_radius: inches(0.25, Source::Memory),
    throat: None,
};

/// Mouth 5 to 5⅛ in, 104 ± 1°, shelf 0 to ⅜ in.
const WPA_SIDE: PocketSheet = PocketSheet {
    mouth: inches(5.0625, WPA),
    cut_angle_deg: figure(104.0, WPA),
    shelf: inches(0.1875, WPA),
    hole_radius: inches(2.5, UNREGULATED),
    point_radius: inches(0.25, Source::Memory),
    throat: None,
};

const WPA_9FT: Sheet = Sheet {
    length: inches(100.0, WPA),
    width: inches(50.0, WPA),
    cushion_height: WPA_NOSE,
    // 1⅞ to 2 in.
    cushion_width: inches(2.0, WPA),
    // The rule allows 4 to 7½ in. 5 in would be too narrow for the holes of the side pockets.
    rail_width: inches(6.0, WPA),
    pocket_model: PocketModel::DropCircle,
    pockets: Some([WPA_CORNER, WPA_SIDE]),
    sight_setback: Some(inches(3.6875, WPA)),
    head_string: Some(inches(25.0, WPA)),
    d_radius: None,
    black_spot: None,
    spots: SpotPattern::Quarters,
    physics: "pool",
};

const WPA_8FT: Sheet = Sheet {
    length: inches(92.0, WPA),
    width: inches(46.0, WPA),
    head_string: Some(inches(23.0, WPA)),
    ..WPA_9FT
};

const BAR_7FT: Sheet = Sheet {
    length: inches(76.0, Source::Memory),
    width: inches(38.0, Source::Memory),
    cushion_height: figure(WPA_NOSE.value, LIKE_WPA),
    cushion_width: inches(2.0, LIKE_WPA),
    rail_width: inches(6.0, LIKE_WPA),
    pockets: Some([as_if(WPA_CORNER, LIKE_WPA), as_if(WPA_SIDE, LIKE_WPA)]),
    sight_setback: Some(inches(3.6875, DRAWN)),
    head_string: Some(inches(19.0, LIKE_WPA)),
    ..WPA_9FT
};

/// The same pocket on a table that its source does not cover.
const fn as_if(p: PocketSheet, source: Source) -> PocketSheet {
    PocketSheet {
        mouth: figure(p.mouth.value, source),
        cut_angle_deg: figure(p.cut_angle_deg.value, source),
        shelf: figure(p.shelf.value, source),
        hole_radius: figure(p.hole_radius.value, source),
        point_radius: figure(p.point_radius.value, source),
        throat: p.throat,
    }
}

/// pooltool describes a pocket by the angle between facing and axis (5.3° and 7.14°) and by the
/// depth of the hole's centre behind the nose lines (41.7 and 68.5 mm). Shelf and cut angle follow
/// from them.
const SHOWOOD_7FT: Sheet = Sheet {
    length: figure(1.9812, SHOWOOD),
    width: figure(0.9906, SHOWOOD),
    cushion_height: figure(0.036576, SHOWOOD),
    cushion_width: figure(0.0508, SHOWOOD),
    rail_width: inches(6.0, LIKE_WPA),
    pockets: Some([
        PocketSheet {
            mouth: figure(0.118, SHOWOOD),
            cut_angle_deg: figure(140.3, SHOWOOD),
            shelf: figure(0.059 + 0.0417 - 0.062, SHOWOOD),
            hole_radius: figure(0.062, SHOWOOD),
            point_radius: figure(0.02095, SHOWOOD),
            throat: None,
        },
        PocketSheet {
            mouth: figure(0.137, SHOWOOD),
            cut_angle_deg: figure(97.14, SHOWOOD),
            shelf: figure(0.0685 - 0.0645, SHOWOOD),
            hole_radius: figure(0.0645, SHOWOOD),
            point_radius: figure(0.00795, SHOWOOD),
            // pooltool moves the facing inwards by c·sin 7.14°; the angle would require c·tan
            // 7.14°.
            throat: Some(figure(0.137 - 2.0 * 0.0508 * SIN_7_14_DEG, SHOWOOD)),
        },
    ]),
    sight_setback: Some(inches(3.6875, DRAWN)),
    head_string: Some(figure(0.25 * 1.9812, LIKE_WPA)),
    ..WPA_9FT
};

/// sin 7.14°, because `sin` is not a `const fn`.
const SIN_7_14_DEG: f64 = 0.124_294_224_946_840_18;

const SNOOKER_12FT: Sheet = Sheet {
    length: figure(3.569, WPBSA),
    width: figure(1.778, WPBSA),
    cushion_height: figure(0.03675, MATHAVAN),
    cushion_width: figure(0.04763, PT_SNOOKER),
    rail_width: inches(6.0, LIKE_WPA),
    pocket_model: PocketModel::DropCircle,
    pockets: Some([
        PocketSheet {
            mouth: figure(0.08014, PT_SNOOKER),
            cut_angle_deg: figure(135.0, PT_SNOOKER),
            shelf: figure(0.04007 + 0.06735 - 0.0889, PT_SNOOKER),
            hole_radius: figure(0.0889, PT_SNOOKER),
            point_radius: figure(0.0889, PT_SNOOKER),
            throat: None,
        },
        PocketSheet {
            mouth: figure(0.08457, PT_SNOOKER),
            cut_angle_deg: figure(90.0, PT_SNOOKER),
            shelf: figure(0.05159 - 0.05319, PT_SNOOKER),
            hole_radius: figure(0.05319, PT_SNOOKER),
            point_radius: figure(0.0669, PT_SNOOKER),
            throat: None,
        },
    ]),
    sight_setback: None,
    head_string: Some(figure(0.737, WPBSA)),
    d_radius: Some(figure(0.292, WPBSA)),
    black_spot: Some(figure(0.324, WPBSA)),
    spots: SpotPattern::Snooker,
    physics: "snooker",
};

/// Diameter of an English pool ball, 2 in, over that of a snooker ball, 52.5 mm.
const ENGLISH_TO_SNOOKER: f64 = 2.0 * INCH / 0.0525;

const ENGLISH_7FT: Sheet = Sheet {
    // The rule allows 6 × 3 ft to 7 × 3½ ft. A “7 ft” table is 7 ft long outside.
    length: inches(72.0, WEPF),
    width: inches(36.0, WEPF),
    cushion_height: figure(0.03675 * ENGLISH_TO_SNOOKER, LIKE_SNOOKER),
    cushion_width: figure(0.04763 * ENGLISH_TO_SNOOKER, LIKE_SNOOKER),
    rail_width: inches(6.0, OUTSIDE_7FT),
    pocket_model: PocketModel::DropCircle,
    pockets: Some([
        PocketSheet {
            // 1.6 ball diameters.
            mouth: inches(3.2, BAPTO),
            cut_angle_deg: figure(135.0, LIKE_SNOOKER),
            shelf: figure(0.01852 * ENGLISH_TO_SNOOKER, LIKE_SNOOKER),
            hole_radius: figure(0.0889 * ENGLISH_TO_SNOOKER, LIKE_SNOOKER),
            point_radius: figure(0.0889 * ENGLISH_TO_SNOOKER, LIKE_SNOOKER),
            throat: None,
        },
        PocketSheet {
            mouth: inches(3.2, BAPTO),
            cut_angle_deg: figure(90.0, LIKE_SNOOKER),
            shelf: figure(-0.0016 * ENGLISH_TO_SNOOKER, LIKE_SNOOKER),
            hole_radius: figure(0.05319 * ENGLISH_TO_SNOOKER, LIKE_SNOOKER),
            point_radius: figure(0.0669 * ENGLISH_TO_SNOOKER, LIKE_SNOOKER),
            throat: None,
        },
    ]),
    sight_setback: None,
    // A fifth of the length.
    head_string: Some(inches(14.4, WEPF)),
    d_radius: None,
    black_spot: None,
    spots: SpotPattern::EnglishPool,
    physics: "english",
};

const CAROM_10FT: Sheet = Sheet {
    length: figure(2.84, UMB),
    width: figure(1.42, UMB),
    cushion_height: figure(0.037, UMB),
    cushion_width: inches(2.0, DRAWN),
    rail_width: figure(0.125 + 2.0 * INCH, UMB),
    pocket_model: PocketModel::DropCircle,
    pockets: None,
    sight_setback: Some(inches(3.6875, DRAWN)),
    head_string: Some(figure(0.71, Source::Memory)),
    d_radius: None,
    black_spot: None,
    spots: SpotPattern::Quarters,
    physics: "carom",
};

const CAROM_9FT: Sheet = Sheet {
    length: figure(2.54, Source::Memory),
    width: figure(1.27, Source::Memory),
    cushion_height: figure(0.037, LIKE_10FT),
    rail_width: figure(0.125 + 2.0 * INCH, LIKE_10FT),
    head_string: Some(figure(0.635, LIKE_10FT)),
    ..CAROM_10FT
};

/// In FastFiz a ball rebounds when its centre is R from a rail's line, so the nose is as high as
/// the centre. FastFiz uses its `RAIL_HEIGHT`, 40.005 mm, only to find cues that are obstructed.
const POOLFIZ: Sheet = Sheet {
    length: figure(2.236, FASTFIZ),
    width: figure(1.116, FASTFIZ),
    cushion_height: figure(0.028575, FASTFIZ),
    cushion_width: inches(2.0, BEHIND_THE_LINE),
    rail_width: inches(6.0, BEHIND_THE_LINE),
    pocket_model: PocketModel::MouthLine,
    pockets: Some([
        PocketSheet {
            mouth: figure(0.11, FASTFIZ),
            cut_angle_deg: figure(135.0, BEHIND_THE_LINE),
            shelf: inches(1.0, BEHIND_THE_LINE),
            hole_radius: figure(0.06, BEHIND_THE_LINE),
            point_radius: figure(0.0, FASTFIZ),
            throat: None,
        },
        PocketSheet {
            mouth: figure(0.12, FASTFIZ),
            cut_angle_deg: figure(90.0, BEHIND_THE_LINE),
            shelf: figure(0.0, BEHIND_THE_LINE),
            hole_radius: figure(0.065, BEHIND_THE_LINE),
            point_radius: figure(0.0, FASTFIZ),
            throat: None,
        },
    ]),
    sight_setback: Some(inches(3.6875, DRAWN)),
    // A quarter of the length.
    head_string: Some(figure(0.559, FASTFIZ)),
    d_radius: None,
    black_spot: None,
    spots: SpotPattern::Quarters,
    physics: "poolfiz",
};

/// Diameter of a pool ball, 2¼ in, over that of a snooker ball, 52.5 mm.
const POOL_TO_SNOOKER: f64 = 2.25 * INCH / 0.0525;

/// The table of Chinese eight-ball: "snooker-style pockets and steel block cushions" (billiardsboutique.com, 2016), so cushions and
/// jaws are those of a snooker table in proportion to the ball. The rules of August 2017 (9ballpool.co.uk) have the same
/// head string and foot spot, and a width of 1260 ± 9 mm.
const CHINESE_9FT: Sheet = Sheet {
    length: figure(2.54, CBSA),
    width: figure(1.27, CBSA),
    cushion_height: figure(0.03675 * POOL_TO_SNOOKER, LIKE_SNOOKER),
    cushion_width: figure(0.04763 * POOL_TO_SNOOKER, LIKE_SNOOKER),
    rail_width: inches(6.0, LIKE_WPA),
    pockets: Some([
        PocketSheet {
            mouth: figure(0.084, IN_THE_TRADE),
            cut_angle_deg: figure(135.0, LIKE_SNOOKER),
            shelf: figure(0.01852 * POOL_TO_SNOOKER, LIKE_SNOOKER),
            hole_radius: figure(0.0889 * POOL_TO_SNOOKER, LIKE_SNOOKER),
            point_radius: figure(0.0889 * POOL_TO_SNOOKER, LIKE_SNOOKER),
            throat: None,
        },
        PocketSheet {
            mouth: figure(0.088, IN_THE_TRADE),
            cut_angle_deg: figure(90.0, LIKE_SNOOKER),
            shelf: figure(-0.0016 * POOL_TO_SNOOKER, LIKE_SNOOKER),
            hole_radius: figure(0.05319 * POOL_TO_SNOOKER, LIKE_SNOOKER),
            point_radius: figure(0.0669 * POOL_TO_SNOOKER, LIKE_SNOOKER),
            throat: None,
        },
    ]),
    head_string: Some(figure(0.45, CBSA)),
    sight_setback: Some(inches(3.6875, DRAWN)),
    ..WPA_9FT
};

/// The figures of the preset `name`, which may have a date. The editions have the same figures so far;
/// they differ in their physics.
pub(super) fn sheet(name: &str) -> Option<&'static Sheet> {
    match edition::find(edition::TABLES, name)?.name {
        "wpa-9ft" => Some(&WPA_9FT),
        "wpa-8ft" => Some(&WPA_8FT),
        "bar-7ft" => Some(&BAR_7FT),
        "showood-7ft" => Some(&SHOWOOD_7FT),
        "snooker-12ft" => Some(&SNOOKER_12FT),
        "english-7ft" => Some(&ENGLISH_7FT),
        "carom-10ft" => Some(&CAROM_10FT),
        "carom-9ft" => Some(&CAROM_9FT),
        "poolfiz" => Some(&POOLFIZ),
        "chinese-9ft" => Some(&CHINESE_9FT),
        _ => None,
    }
}

/// The name under which a table is known: without the date if this is the same as the preset of that
/// name without a date, the physics included.
fn current_name(edition: &Edition) -> &'static str {
    let is_current = edition::find(edition::PHYSICS, edition.physics)
        .is_some_and(|physics| physics.is_newest_of(edition::PHYSICS));
    if is_current { edition.current_name(edition::TABLES) } else { edition.dated }
}

impl TableDescription {
    /// The preset of that name: one of [`PRESETS`] with the newest values, or a dated name with the
    /// values of that edition and its physics.
    pub fn preset(name: &str) -> Option<Self> {
        let mut description = sheet(name)?.description();
        let edition = edition::find(edition::TABLES, name)?;
        if name == edition.dated && name != edition.name {
            description.physics = edition::current_physics_name(edition.physics)?.to_string();
        }
        Some(description)
    }
}

impl Table {
    /// The preset of that name, as [`TableDescription::preset`]. Its own name has no date if the
    /// values are the newest.
    pub fn preset(name: &str) -> Option<Self> {
        // `ok` hides no error: the tests build every preset.
        let mut table = Self::from_description(&TableDescription::preset(name)?).ok()?;
        let edition = edition::find(edition::TABLES, name)?;
        let known = if name == edition.name { edition.name } else { current_name(edition) };
        table.name = Some(known.to_string());
        Some(table)
    }

    /// The dated name of a preset, with or without a date: `wpa-9ft-2026-11` for `wpa-9ft`.
    pub fn dated_name(name: &str) -> Option<&'static str> {
        edition::find(edition::TABLES, name).map(|edition| edition.dated)
    }

    /// The preset of that name, shared by all shots on it, so that it stays in the processor's
    /// cache from shot to shot. A new one for an edition that is not the newest, and for every call
    /// without the standard library.
    pub(crate) fn shared_preset(name: &str) -> Option<Arc<Self>> {
        #[cfg(feature = "std")]
        {
            use std::sync::OnceLock;
            static TABLES: [OnceLock<Arc<Table>>; PRESETS.len()] =
                [const { OnceLock::new() }; PRESETS.len()];
            let edition = edition::find(edition::TABLES, name)?;
            let known = if name == edition.name { name } else { current_name(edition) };
            if let Some(index) = PRESETS.iter().position(|&preset| preset == known) {
                let shared = &TABLES[index];
                if shared.get().is_none() {
                    let table = Self::preset(known)?;
                    return Some(shared.get_or_init(|| table.into()).clone());
                }
                return shared.get().cloned();
            }
        }
        Self::preset(name).map(Arc::new)
    }
}

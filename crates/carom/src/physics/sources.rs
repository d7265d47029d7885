//! The source of every value of the physics presets. `carom physics` prints them.
//!
//! A key stands for all keys below it: `ball_ball.friction` for its `a`, `b` and `c`. A preset has the
//! sources of its base for the keys that it does not list; a test checks that the values are the same.
//! An edition with new values gets a sheet of its own.

/// What a value rests on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evidence {
    /// Measured on real equipment; the source has this value, or a range that contains it.
    Measured,
    /// Fitted to measurements with this engine.
    Fit,
    /// Set by a rule book, a convention or a definition, or chosen among the published models.
    Specified,
    /// No source that we could verify.
    Estimate,
}

impl Evidence {
    /// The word that lists and JSON have.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Measured => "measured",
            Self::Fit => "fit",
            Self::Specified => "specified",
            Self::Estimate => "estimate",
        }
    }
}

/// A key, what its value rests on, and the source.
pub(crate) type SourceRow = (&'static str, Evidence, &'static str);

/// The sources of a dated preset.
struct SourceSheet {
    /// The preset's dated name.
    dated: &'static str,
    /// The dated preset whose sources apply to keys that are not listed.
    base: Option<&'static str>,
    rows: &'static [SourceRow],
}

use Evidence::{Estimate, Fit, Measured, Specified};

const POOL: &[SourceRow] = &[
    ("gravity", Specified, "standard gravity, CGPM 1901"),
    ("ball.radius", Specified, "WPA: 2.250 in diameter"),
    ("ball.mass", Specified, "WPA: 5.5 to 6 oz; 6 oz as in pooltool"),
    (
        "cloth.sliding_friction",
        Measured,
        "Alciatore TP 4.1, B.12; his FAQ: 0.15 to 0.4, typically 0.2",
    ),
    ("cloth.rolling_friction", Measured, "Alciatore TP B.12; his FAQ: 0.005 to 0.015"),
    ("cloth.spin_deceleration", Measured, "Alciatore TP B.2: 10 rad/s²; his FAQ: 5 to 15"),
    (
        "ball_ball.model",
        Specified,
        "contact with a tangential spring, as Stronge 2000 (docs/validation.md)",
    ),
    ("ball_ball.restitution", Measured, "Alciatore's FAQ: 0.92 to 0.98"),
    ("ball_ball.friction", Fit, "Alciatore's throw tests of 2006 and 2014 together: 0.66° rms"),
    ("ball_ball.frequency_ratio", Specified, "√(β/η²) with Poisson's ratio 0.3 of phenolic resin"),
    ("cushion.model", Specified, "Stronge 2000"),
    ("cushion.restitution", Fit, "fast banks of Alciatore TP B.28; WPA: 4 to 4.5 table lengths"),
    ("cushion.friction", Fit, "fast banks of Alciatore TP B.28"),
    ("cushion.frequency_ratio", Specified, "pooltool's Stronge model"),
    ("cushion.tangential_factor", Specified, "not used by this model"),
    ("cushion.spin_factor", Specified, "not used by this model"),
    ("facing.restitution", Estimate, "neoprene: from memory, 0.5 to 0.7; no measurement found"),
    ("facing.friction", Estimate, "more than a nose; no measurement found"),
    ("liner.restitution", Estimate, "leather or plastic: from memory, 0.3 to 0.5; none measured"),
    ("liner.friction", Estimate, "no measurement found"),
    ("slate.restitution", Measured, "Alciatore's FAQ: 0.5 to 0.7"),
    ("slate.friction", Specified, "as in sliding, Alciatore TP B.10"),
    ("cue.model", Specified, "docs/contact.md"),
    ("cue.mass", Specified, "20 oz, a common cue; Alciatore TP A.30 has 19 oz"),
    ("cue.end_mass", Specified, "a thirtieth of the ball, as in pooltool; Alciatore TP A.31"),
    ("cue.tip_radius", Measured, "a nickel's curvature, Alciatore"),
    ("cue.tip_friction", Measured, "Alciatore TP 2.1, A.12: 0.577 to 0.66"),
    ("cue.tip_restitution", Measured, "leather: Alciatore TP A.30, 0.71 to 0.75"),
    ("cue.tip_off_centre_loss", Fit, "Alciatore TP B.10, A.30: 11.194 mph at half a radius"),
    (
        "cue.stroke_elevation",
        Estimate,
        "clears the rail 0.3 m behind a ball; strokes of TP A.19, B.10: 4° and 5°",
    ),
    ("contact_times.tip", Measured, "Alciatore's high-speed video: about 1 ms"),
    ("contact_times.slate", Fit, "a massé hops by less than 15 mm (docs/contact.md)"),
];

const SNOOKER: &[SourceRow] = &[
    ("ball", Measured, "a match set: Mathavan, Jackson & Parkin 2009, 2014"),
    ("cloth.sliding_friction", Measured, "film: Mathavan, Jackson & Parkin 2009, 0.178 to 0.245"),
    ("cloth.rolling_friction", Measured, "film: Mathavan, Jackson & Parkin 2009, 0.0127 to 0.0129"),
    ("cloth.spin_deceleration", Measured, "Mathavan, Jackson & Parkin 2014"),
    ("ball_ball.restitution", Measured, "Mathavan, Jackson & Parkin 2014; their balls are rigid"),
    ("ball_ball.friction", Measured, "Mathavan, Jackson & Parkin 2014; their balls are rigid"),
    (
        "cushion.restitution",
        Fit,
        "31 filmed rebounds, 0.28 to 3.5 m/s: Mathavan, Jackson & Parkin 2009, Fig. 9",
    ),
    ("cushion.friction", Fit, "least value with the least error on the same 31 rebounds"),
    ("cushion.frequency_ratio", Specified, "pooltool 0.6.0"),
    ("cue.mass", Estimate, "17 oz, from memory"),
    ("cue.end_mass", Estimate, "in proportion to the ball"),
    ("cue.tip_radius", Estimate, "a smaller tip than in pool, from memory"),
];

const ENGLISH: &[SourceRow] = &[
    ("ball.radius", Specified, "2 in diameter; from memory, not verified"),
    ("ball.mass", Estimate, "116 g, from memory"),
    ("cloth", Estimate, "as in snooker"),
    ("ball_ball.restitution", Estimate, "phenolic balls as in pool"),
    ("ball_ball.friction", Estimate, "phenolic balls as in pool"),
    ("cushion.restitution", Estimate, "as in snooker"),
    ("cushion.friction", Estimate, "as in snooker"),
    ("cue.end_mass", Estimate, "in proportion to the ball"),
];

const CAROM: &[SourceRow] = &[
    ("ball.radius", Specified, "UMB: 61 to 61.5 mm diameter"),
    ("ball.mass", Specified, "205 to 220 g from memory; 210 g as in pooltool"),
    ("cloth.sliding_friction", Estimate, "as in pool; Han 2005 found 0.069 on his table"),
    (
        "cloth.rolling_friction",
        Fit,
        "a ball of 0.6 m/s stops where it does with 0.0383 + 0.0150 v m/s², fitted to matches",
    ),
    ("cloth.spin_deceleration", Measured, "Han 2005: M_z 3.82e-4 N·m on 0.23 kg, 32.75 mm"),
    ("ball_ball.restitution", Measured, "Han 2005"),
    ("ball_ball.friction", Estimate, "as in pool"),
    ("cushion.restitution", Estimate, "as on a pool table"),
    ("cushion.friction", Estimate, "as on a pool table"),
    ("cue.mass", Estimate, "a carom cue is lighter"),
    ("cue.end_mass", Estimate, "a carom cue is stiffer"),
];

/// Filmed at 50 Hz with a noise of 1 mm; published with the tracker 3cushiontool.
const MATCH: &str = "tracks of a three-cushion match of 2022, 91 shots";

const POOL_NEW_CLOTH: &[SourceRow] = &[
    (
        "cloth.sliding_friction",
        Estimate,
        "the low end of 0.15 to 0.4 in Alciatore's FAQ; new cloth is slippery",
    ),
    (
        "cloth.rolling_friction",
        Estimate,
        "between the low end and the middle of 0.005 to 0.015 in Alciatore's FAQ",
    ),
    ("cloth.spin_deceleration", Estimate, "the low end of 5 to 15 rad/s² in Alciatore's FAQ"),
];

const POOL_WORN_CLOTH: &[SourceRow] = &[
    ("cloth.sliding_friction", Estimate, "the middle of 0.15 to 0.4 in Alciatore's FAQ"),
    ("cloth.rolling_friction", Estimate, "the high end of 0.005 to 0.015 in Alciatore's FAQ"),
    ("cloth.spin_deceleration", Estimate, "the high end of 5 to 15 rad/s² in Alciatore's FAQ"),
];

/// What changed in December 2026.
const POOL_2026_12: &[SourceRow] = &[
    (
        "ball_ball.friction",
        Fit,
        "used balls: Alciatore's throw test of 2006, 12 of 15 readings within 0.5°",
    ),
    (
        "cushion.restitution",
        Fit,
        "fast banks of Alciatore TP B.28, Olhausen 9 ft: within 0.28 diamonds; its fall with speed as \
         in Mathavan's film",
    ),
    ("cushion.friction", Fit, "fast banks of Alciatore TP B.28, Olhausen 9 ft"),
    ("cushion.frequency_ratio", Fit, "fast banks of Alciatore TP B.28, three tables together"),
];

const POOL_CLEAN_BALLS: &[SourceRow] = &[(
    "ball_ball.friction",
    Fit,
    "Alciatore's Throw follow-up I: 3.6° at 45°, slow, after a ball cleaner; fall with speed as for used \
     balls",
)];

const POOL_DIRTY_BALLS: &[SourceRow] = &[(
    "ball_ball.friction",
    Fit,
    "Alciatore's throw test of 2014 (follow-up II): five readings within 0.21°",
)];

const POOL_GOLD_CROWN: &[SourceRow] = &[(
    "cushion.friction",
    Fit,
    "fast banks of Alciatore TP B.28, Gold Crown: within 0.25 diamonds",
)];

const POOL_VALLEY: &[SourceRow] = &[(
    "cushion.friction",
    Fit,
    "fast banks of Alciatore TP B.28, Valley 7 ft: within 0.21 diamonds",
)];

const FILMED_BALLS: &str =
    "three filmed collisions, Mathavan, Jackson & Parkin 2009: within 0.015 m/s and 0.63°";

const SNOOKER_2026_12: &[SourceRow] = &[
    ("ball_ball.restitution", Fit, FILMED_BALLS),
    ("ball_ball.friction", Fit, FILMED_BALLS),
    (
        "cushion.restitution",
        Fit,
        "31 filmed rebounds, 0.28 to 3.5 m/s, within 0.039 m/s: Mathavan, Jackson & Parkin 2009, Fig. 9",
    ),
];

const ENGLISH_2026_12: &[SourceRow] = &[
    ("ball_ball.friction", Estimate, "used phenolic balls as in pool"),
    ("cushion.restitution", Estimate, "as in snooker"),
];

const CAROM_2026_12: &[SourceRow] = &[
    ("cloth.sliding_friction", Fit, MATCH),
    (
        "cloth.rolling_friction",
        Fit,
        "0.0410 + 0.0142 v m/s², 0.1 to 1.35 m/s, in bands: tracks of a three-cushion match of 2022",
    ),
    ("cloth.spin_deceleration", Fit, MATCH),
    ("ball_ball.restitution", Fit, MATCH),
    ("ball_ball.friction", Fit, "used pool balls; the match's throw, 2.3° at 2.5 to 6 m/s, agrees"),
    ("cushion.model", Specified, "Han 2005"),
    ("cushion.restitution", Fit, "337 rebounds in the tracks of a three-cushion match of 2022"),
    ("cushion.friction", Fit, "337 rebounds in the tracks of a three-cushion match of 2022"),
    ("cushion.frequency_ratio", Specified, "not used by this model"),
];

const FASTFIZ: &str = "FastFiz 0.2, FastFiz.h";

const POOLFIZ: &[SourceRow] = &[
    ("gravity", Specified, FASTFIZ),
    ("ball", Specified, FASTFIZ),
    ("cloth", Specified, FASTFIZ),
    ("ball_ball", Specified, FASTFIZ),
    ("cushion", Specified, FASTFIZ),
    ("facing", Specified, "FastFiz has no jaws: as the rails"),
    ("slate", Specified, "in FastFiz no ball leaves the cloth"),
    ("cue", Specified, FASTFIZ),
    ("cue.tip_radius", Specified, "not used by FastFiz"),
];

const NO_LOSS: &str = "no losses and no throw, by definition";

const IDEAL: &[SourceRow] = &[
    ("ball_ball", Specified, NO_LOSS),
    ("cushion", Specified, NO_LOSS),
    ("facing", Specified, NO_LOSS),
    ("liner.friction", Specified, NO_LOSS),
    ("slate.friction", Specified, NO_LOSS),
    ("cue.model", Specified, "a tip alone"),
    ("cue.end_mass", Specified, "no squirt, by definition"),
    ("cue.tip_restitution", Specified, NO_LOSS),
    ("cue.tip_off_centre_loss", Specified, NO_LOSS),
    ("cue.stroke_elevation", Specified, "a level cue, by definition"),
];

const SHEETS: &[SourceSheet] = &[
    sheet("pool-2026-11", None, POOL),
    sheet("snooker-2026-11", Some("pool-2026-11"), SNOOKER),
    sheet("english-2026-11", Some("snooker-2026-11"), ENGLISH),
    sheet("carom-2026-11", Some("pool-2026-11"), CAROM),
    sheet("poolfiz-2026-11", Some("pool-2026-11"), POOLFIZ),
    sheet("ideal-2026-11", Some("pool-2026-11"), IDEAL),
    sheet("pool-2026-12", Some("pool-2026-11"), POOL_2026_12),
    sheet("pool-new-cloth-2026-12", Some("pool-2026-12"), POOL_NEW_CLOTH),
    sheet("pool-worn-cloth-2026-12", Some("pool-2026-12"), POOL_WORN_CLOTH),
    sheet("pool-clean-balls-2026-12", Some("pool-2026-12"), POOL_CLEAN_BALLS),
    sheet("pool-dirty-balls-2026-12", Some("pool-2026-12"), POOL_DIRTY_BALLS),
    sheet("pool-gold-crown-2026-12", Some("pool-2026-12"), POOL_GOLD_CROWN),
    sheet("pool-valley-2026-12", Some("pool-2026-12"), POOL_VALLEY),
    sheet("snooker-2026-12", Some("snooker-2026-11"), SNOOKER_2026_12),
    sheet("english-2026-12", Some("english-2026-11"), ENGLISH_2026_12),
    sheet("carom-2026-12", Some("carom-2026-11"), CAROM_2026_12),
];

const fn sheet(
    dated: &'static str,
    base: Option<&'static str>,
    rows: &'static [SourceRow],
) -> SourceSheet {
    SourceSheet { dated, base, rows }
}

/// The source of the value at `key` of the preset `dated`, and the dated preset that lists it.
pub(crate) fn source(dated: &str, key: &str) -> Option<(&'static str, SourceRow)> {
    let sheet = SHEETS.iter().find(|sheet| sheet.dated == dated)?;
    let holds = |row: &&SourceRow| {
        key.strip_prefix(row.0).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
    };
    // The longest key is the most precise one.
    match sheet.rows.iter().filter(holds).max_by_key(|row| row.0.len()) {
        Some(row) => Some((sheet.dated, *row)),
        None => source(sheet.base?, key),
    }
}

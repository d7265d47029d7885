//! The named physics of `carom-shot/1`.
//!
//! Every value has its source. Values marked *estimated* or *from memory* have none; they are the
//! first to be replaced by a measurement.

mod november_2026;

use super::{
    BallBall, BallBallModel, Cloth, ContactTimes, Cue, Cushion, CushionFriction, CushionModel,
    CushionRestitution, Physics, RollingBand, RollingFriction, SlipFriction, StrikeModel, Surface,
    Tip, ball_surface,
};
use crate::Ball;
use crate::edition;
use crate::math::radians;

/// Standard gravity, m/s² (CGPM 1901).
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// ω_t/ω_n of the compliant ball–ball contact: √(β/η²) with β = 7/2, η² = (2 − ν)/(2 − 2ν) and
/// Poisson's ratio ν = 0.3 of phenolic resin.
const BALL_FREQUENCY_RATIO: f64 = 1.70;

/// Least elevation of a real stroke, rad: 3°. Estimated: we found no measurement of many strokes.
/// Some elevation is unavoidable, because the butt is over a rail (Fieldhammer 2010); at 3° the cue
/// clears the rail 0.3 m behind a ball. The slightly raised strokes of TP A.19 and B.10 have 4° and
/// 5°.
const STROKE_ELEVATION: f64 = radians(3.0);

impl Physics {
    /// The names of the presets, without dates. [`edition::PHYSICS`] also has the dated names.
    pub const PRESETS: [&str; 12] = [
        "pool",
        "pool-new-cloth",
        "pool-worn-cloth",
        "pool-clean-balls",
        "pool-dirty-balls",
        "pool-gold-crown",
        "pool-valley",
        "snooker",
        "english",
        "carom",
        "poolfiz",
        "ideal",
    ];

    /// The preset of this name: `pool` has the newest values, `pool-2026-11` those of that edition.
    pub fn preset(name: &str) -> Option<Self> {
        match edition::find(edition::PHYSICS, name)?.dated {
            "pool-2026-12" => Some(Self::pool()),
            "pool-new-cloth-2026-12" => Some(Self::pool().on(NEW_CLOTH)),
            "pool-worn-cloth-2026-12" => Some(Self::pool().on(WORN_CLOTH)),
            "pool-clean-balls-2026-12" => Some(Self::pool().with_throw(ball_surface::CLEAN)),
            "pool-dirty-balls-2026-12" => Some(Self::pool().with_throw(ball_surface::DIRTY)),
            "pool-gold-crown-2026-12" => Some(Self::pool().between(GOLD_CROWN_RAIL)),
            "pool-valley-2026-12" => Some(Self::pool().between(VALLEY_RAIL)),
            "snooker-2026-12" => Some(Self::snooker()),
            "english-2026-12" => Some(Self::english()),
            "carom-2026-12" => Some(Self::carom()),
            "pool-2026-11" => Some(november_2026::pool()),
            "snooker-2026-11" => Some(november_2026::snooker()),
            "english-2026-11" => Some(november_2026::english()),
            "carom-2026-11" => Some(november_2026::carom()),
            "poolfiz-2026-11" => Some(Self::poolfiz()),
            "ideal-2026-11" => Some(Self::ideal()),
            _ => None,
        }
    }

    /// The dated name of a preset, with or without a date: `pool-2026-11` for `pool`.
    pub fn dated_name(name: &str) -> Option<&'static str> {
        edition::find(edition::PHYSICS, name).map(|edition| edition.dated)
    }

    /// Pool: 2¼ in balls on worsted cloth.
    pub fn pool() -> Self {
        Self {
            gravity: STANDARD_GRAVITY,
            // WPA: 2.250 in, 5½–6 oz; 6 oz as in pooltool.
            ball: Ball { mass: 0.170097, radius: 0.028575 },
            cloth: Cloth {
                // TP 4.1, B.12.
                sliding_friction: 0.2,
                rolling_friction: RollingFriction::constant(0.01),
                // TP B.2: 10 rad/s² (5 to 15 measured).
                spin_deceleration: 10.0,
            },
            ball_ball: BallBall {
                model: BallBallModel::Compliant,
                // Dr. Dave FAQ: 0.92–0.98.
                restitution: 0.95,
                friction: ball_surface::USED,
                frequency_ratio: BALL_FREQUENCY_RATIO,
            },
            cushion: OLHAUSEN_RAIL,
            // Neoprene: less restitution and more friction than a nose; 0.5 to 0.7, from memory.
            facing: Surface { restitution: 0.7, friction: 0.25 },
            // Leather or plastic, from memory: 0.3 to 0.5; friction estimated.
            liner: Surface { restitution: 0.35, friction: 0.15 },
            // Dr. Dave FAQ: 0.5 to 0.7; friction as in sliding (TP B.10).
            slate: Surface { restitution: 0.5, friction: 0.2 },
            cue: Cue {
                model: StrikeModel::Network,
                // 20 oz.
                mass: 0.567,
                // m_b/30 (pooltool): 1.9° of squirt at half a radius, a common playing shaft.
                end_mass: 0.00567,
                // A nickel's curvature (Alciatore).
                tip_radius: 0.0106,
                // TP 2.1, A.12: 0.577 allows half a radius; the largest measured value is 0.66.
                tip_friction: 0.6,
                // Leather, TP A.30: 0.71–0.75.
                tip: Tip::Restitution(0.73),
                tip_off_centre_loss: OFF_CENTRE_LOSS,
                stroke_elevation: STROKE_ELEVATION,
            },
            contact_times: CONTACT_TIMES,
        }
    }

    /// Snooker: 52.5 mm balls on napped cloth.
    pub fn snooker() -> Self {
        let pool = Self::pool();
        Self {
            // Mathavan 2009, 2014: measured match set.
            ball: Ball { mass: 0.1406, radius: 0.02625 },
            // Mathavan 2009 (μ_s .178–.245, μ_r .0127–.0129 on film), 2014 (spin).
            cloth: Cloth {
                sliding_friction: 0.212,
                rolling_friction: RollingFriction::constant(0.0128),
                spin_deceleration: 22.0,
            },
            ball_ball: BallBall { restitution: 0.921, friction: SNOOKER_THROW, ..pool.ball_ball },
            cushion: SNOOKER_RAIL,
            // 17 oz and a smaller tip, from memory; end mass in proportion, estimated.
            cue: Cue { mass: 0.48, end_mass: 0.0047, tip_radius: 0.009, ..pool.cue },
            ..pool
        }
    }

    /// English pool: 2 in balls on napped cloth. The layout gives the smaller cue ball (1⅞ in,
    /// about 94 g).
    pub fn english() -> Self {
        let snooker = Self::snooker();
        Self {
            // 2 in, 116 g: from memory.
            ball: Ball { mass: 0.116, radius: 0.0254 },
            // Phenolic balls as in pool; cloth and cushions as in snooker (estimated).
            ball_ball: Self::pool().ball_ball,
            cue: Cue { end_mass: 0.0039, ..snooker.cue },
            ..snooker
        }
    }

    /// Carom on a heated table, as the UMB requires it: the tracks of a three-cushion match of 2022, 91
    /// shots.
    pub fn carom() -> Self {
        let pool = Self::pool();
        Self {
            // UMB: 61–61.5 mm; 205–220 g from memory, 210 g as in pooltool.
            ball: Ball { mass: 0.210, radius: 0.03075 },
            cloth: Cloth {
                sliding_friction: 0.178,
                rolling_friction: RollingFriction::of_bands(&HEATED_CLOTH),
                spin_deceleration: 3.6,
            },
            // The tracks; their throw of 2.3° at 2.5 to 6 m/s is that of used pool balls.
            ball_ball: BallBall { restitution: 0.92, ..pool.ball_ball },
            cushion: HEATED_RAIL,
            // A carom cue is lighter and stiffer: estimated.
            cue: Cue { mass: 0.51, end_mass: 0.007, ..pool.cue },
            ..pool
        }
    }

    /// The same physics on another cloth.
    fn on(self, cloth: Cloth) -> Self {
        Self { cloth, ..self }
    }

    /// The same physics with another friction of the balls.
    fn with_throw(self, friction: SlipFriction) -> Self {
        Self { ball_ball: BallBall { friction, ..self.ball_ball }, ..self }
    }

    /// The same physics between other rails.
    fn between(self, cushion: Cushion) -> Self {
        Self { cushion, ..self }
    }

    /// Close to Poolfiz, the engine of the Computational Olympiad, with the figures of its
    /// successor FastFiz 0.2 (`FastFiz.h`); docs/poolfiz.md lists what agrees and what differs.
    pub fn poolfiz() -> Self {
        const GRAVITY: f64 = 9.81;
        const RADIUS: f64 = 0.028575;
        const SPIN_FRICTION: f64 = 0.044;
        let pool = november_2026::pool();
        Self {
            gravity: GRAVITY,
            // 5.57 oz, 2¼ in.
            ball: Ball { mass: 0.16301, radius: RADIUS },
            cloth: Cloth {
                sliding_friction: 0.2,
                rolling_friction: RollingFriction::constant(0.015),
                // Leckie & Greenspan 2005: dω_z/dt = −5μ_sp·g/(2R).
                spin_deceleration: 2.5 * SPIN_FRICTION * GRAVITY / RADIUS,
            },
            // The balls exchange their normal velocities.
            ball_ball: BallBall {
                model: BallBallModel::Frictional,
                restitution: 1.0,
                friction: SlipFriction::constant(0.01),
                ..pool.ball_ball
            },
            cushion: Cushion {
                model: CushionModel::Factors,
                restitution: CushionRestitution::constant(0.6),
                friction: CushionFriction { a: 0.0, b: 0.0 },
                tangential_factor: 0.9,
                spin_factor: 0.1,
                ..november_2026::RAIL
            },
            // FastFiz has no jaws, so the ends of the rails have the properties of the rails.
            facing: Surface { restitution: 0.6, friction: 0.0 },
            // In FastFiz no ball leaves the cloth. Here the slate absorbs the downward motion from
            // a raised cue.
            slate: Surface { restitution: 0.0, friction: 0.0 },
            // No squirt, and a tip without losses.
            cue: Cue {
                mass: 0.6,
                end_mass: 0.0,
                tip_friction: 0.7,
                tip: Tip::Restitution(1.0),
                tip_off_centre_loss: 0.0,
                model: StrikeModel::Sequential,
                // In FastFiz a cue without an elevation is level.
                stroke_elevation: 0.0,
                ..pool.cue
            },
            ..pool
        }
    }

    /// Pool without losses in collisions and without throw or squirt; the cloth is real.
    pub fn ideal() -> Self {
        let pool = november_2026::pool();
        Self {
            ball_ball: BallBall {
                model: BallBallModel::Elastic,
                restitution: 1.0,
                friction: SlipFriction::constant(0.0),
                frequency_ratio: BALL_FREQUENCY_RATIO,
            },
            cushion: Cushion {
                model: CushionModel::Restitution,
                restitution: CushionRestitution::constant(1.0),
                friction: CushionFriction { a: 0.0, b: 0.0 },
                ..november_2026::RAIL
            },
            facing: Surface { restitution: 1.0, friction: 0.0 },
            liner: Surface { friction: 0.0, ..pool.liner },
            // The slate still absorbs energy; otherwise a hopping ball would hop for ever.
            slate: Surface { restitution: 0.5, friction: 0.0 },
            cue: Cue {
                end_mass: 0.0,
                tip: Tip::Restitution(1.0),
                tip_off_centre_loss: 0.0,
                model: StrikeModel::Sequential,
                stroke_elevation: 0.0,
                ..pool.cue
            },
            ..pool
        }
    }
}

/// New worsted cloth: slippery, fast, and spin lasts. No measurement of one cloth was found; the
/// values are in the lower half of the ranges of Alciatore's FAQ (sliding 0.15 to 0.4, rolling 0.005 to
/// 0.015, spin 5 to 15 rad/s²). Heated carom cloth has 0.005, so new pool cloth is above that.
const NEW_CLOTH: Cloth = Cloth {
    sliding_friction: 0.15,
    rolling_friction: RollingFriction::constant(0.0075),
    spin_deceleration: 5.0,
};

/// Worn cloth of a club: the middle of the range for sliding, the high ends for rolling and spin (same
/// source as [`NEW_CLOTH`]).
const WORN_CLOTH: Cloth = Cloth {
    sliding_friction: 0.275,
    rolling_friction: RollingFriction::constant(0.015),
    spin_deceleration: 15.0,
};

/// The loss of a leather tip off the centre, fitted: a cue of 20 oz at 15 mph, half a radius off the
/// centre, gives a ball of 6 oz 11.194 mph (TP B.10, A.30). Its restitution is then 0.44.
const OFF_CENTRE_LOSS: f64 = 5.388_423;

/// Contact times at 1 m/s. A leather tip stays on the ball for about 1 ms (Alciatore, high-speed
/// video). The slate's half of that is a fit: a massé then hops by less than 15 mm
/// (docs/contact.md).
const CONTACT_TIMES: ContactTimes = ContactTimes { tip: 1e-3, slate: 5e-4 };

/// Cushions of an Olhausen 9 ft table, fitted to its fast sliding banks (Alciatore, TP B.28: 0.28
/// diamonds at most). The banks of a Gold Crown and of a Valley 7 ft table have the same restitution
/// and compliance, and another friction. The fall of the restitution with speed is that of
/// Mathavan's film and of the tracked match; the banks, at 3.4 to 5.3 m/s, do not determine it. A
/// rolling ball comes back from a perpendicular hit with 0.96 of its speed at 1 m/s, and with 0.84
/// at 3.5 m/s. With the cue at 10 mph a ball travels 4.8 lengths of a 9 ft table, between the rails
/// below 5.7 (Gold Crown) and 4.6 (Valley); the WPA asks for 4 to 4½ (row CU-19).
const OLHAUSEN_RAIL: Cushion = Cushion {
    model: CushionModel::Stronge,
    // No rail was measured at more than 5.3 m/s: the lower limit keeps faster shots plausible.
    restitution: CushionRestitution { a: 1.04, b: -0.05, c: 0.0, lowest: 0.5, highest: 1.0 },
    friction: CushionFriction { a: 0.225, b: 0.0 },
    frequency_ratio: 1.53,
    tangential_factor: 1.0,
    spin_factor: 1.0,
};

/// Cushions of a Brunswick Gold Crown 9 ft table: 0.25 diamonds at most (TP B.28).
const GOLD_CROWN_RAIL: Cushion =
    Cushion { friction: CushionFriction { a: 0.274, b: 0.0 }, ..OLHAUSEN_RAIL };

/// Cushions of a Valley 7 ft table: 0.21 diamonds at most (TP B.28).
const VALLEY_RAIL: Cushion =
    Cushion { friction: CushionFriction { a: 0.208, b: 0.0 }, ..OLHAUSEN_RAIL };

/// Cushions of a snooker table, fitted to the 31 filmed rebounds of a rolling ball that hits a nose
/// at 7R/5 squarely (Mathavan, Jackson & Parkin 2009, Fig. 9, 0.28 to 3.5 m/s): 0.039 m/s at most.
/// The limit is the fit's value at the end of the film. Friction and frequency ratio as before
/// (`november_2026.rs`).
const SNOOKER_RAIL: Cushion = Cushion {
    model: CushionModel::Stronge,
    restitution: CushionRestitution {
        a: 0.978,
        b: 0.0596,
        c: -0.027_43,
        lowest: 0.851,
        highest: 1.0,
    },
    friction: CushionFriction { a: 0.38, b: 0.0 },
    frequency_ratio: 1.7,
    tangential_factor: 1.0,
    spin_factor: 1.0,
};

/// Friction of snooker balls, fitted with their restitution of 0.921 to the filmed collisions of
/// Mathavan, Jackson & Parkin 2009: within 0.015 m/s and 0.63° of all nine numbers. Three collisions
/// do not determine how the friction falls with the slip speed; that is as for used pool balls.
const SNOOKER_THROW: SlipFriction = SlipFriction { a: 0.0, b: 0.0508, c: 0.344 };

/// Cushions of the tracked carom table: the law of Han 2005 with restitution and friction learned
/// from 337 rebounds, 0.15 to 3.5 m/s. Han's own table returned 0.51 to 0.765 and its restitution
/// rose with speed.
const HEATED_RAIL: Cushion = Cushion {
    model: CushionModel::Han2005,
    restitution: CushionRestitution { a: 0.915, b: -0.034, c: -0.005, lowest: 0.5, highest: 1.0 },
    friction: CushionFriction { a: 0.240, b: 0.034 },
    frequency_ratio: 1.8,
    tangential_factor: 1.0,
    spin_factor: 1.0,
};

/// The deceleration 0.0410 + 0.0142 v m/s² of the tracked match in bands up to 3 m/s: a ball stops
/// within 1 % or 10 mm of where it does with this law (`carom.rolling_bands(0.0410, 0.0142,
/// share=0.01, least=0.01)`). The tracks show rolling balls up to 1.35 m/s.
const HEATED_CLOTH: [RollingBand; 7] = [
    band(0.283_782_435_581_088_07, 0.004_452_647_461_077_105),
    band(0.495_281_006_829_030_3, 0.004_757_125_884_432_819),
    band(0.779_485_577_398_366, 0.005_116_335_080_286_76),
    band(1.150_281_069_509_329, 0.005_590_920_081_083_174),
    band(1.626_319_109_195_984_4, 0.006_204_445_341_562_901),
    band(2.232_160_281_319_124, 0.006_988_191_722_284_195_5),
    band(f64::INFINITY, 0.007_983_247_533_537_964),
];

const fn band(up_to: f64, friction: f64) -> RollingBand {
    RollingBand { up_to, friction }
}

#[cfg(test)]
mod tests {
    use super::{HEATED_CLOTH, Physics, Tip};
    use crate::edition;
    use crate::resolve::cue_ball::{Strike, miscue_limit, resolve};

    #[test]
    fn presets_are_found_by_their_exact_names() {
        for name in Physics::PRESETS {
            assert!(Physics::preset(name).is_some(), "{name}");
        }
        assert_eq!(Physics::preset("Pool"), None);
    }

    #[test]
    fn every_preset_has_numbers_that_a_shot_file_accepts() {
        for name in edition::PHYSICS.iter().map(|edition| edition.dated) {
            let p = Physics::preset(name).unwrap();
            let cloth = p.cloth;
            let bands = || cloth.rolling_friction.bands();
            assert!(bands().count() >= 1 && bands().all(|band| band.friction > 0.0), "{name}");
            let positive = [p.gravity, p.ball.mass, p.ball.radius, p.cue.mass, p.cue.tip_radius];
            assert!(positive.iter().all(|&x| x > 0.0 && x.is_finite()), "{name}");
            let e = [p.ball_ball.restitution, p.cushion.restitution.at(3.0), p.slate.restitution];
            assert!(e.iter().all(|e| (0.0..=1.0).contains(e)), "{name}");
            assert!(p.cushion.restitution.is_possible(), "{name}");
            assert!((1.0..=2.0).contains(&p.ball_ball.frequency_ratio), "{name}");
            assert!((1.0..=2.0).contains(&p.cushion.frequency_ratio), "{name}");
            let Tip::Restitution(e) = p.cue.tip else { panic!("{name}") };
            assert!((0.0..=1.0).contains(&e), "{name}");
        }
    }

    #[test]
    fn the_heated_cloth_has_the_bands_of_its_law() {
        let bands = Physics::carom().cloth.rolling_friction;
        assert!(bands.bands().eq(HEATED_CLOTH));
        // A ball stops within 1 % or 10 mm of where it does with 0.0410 + 0.0142 v m/s².
        let law = crate::physics::RollingLaw { a: 0.0410, b: 0.0142 };
        let tolerance = crate::physics::RollingTolerance { fastest: 3.0, share: 0.01, least: 0.01 };
        let made = law.bands(super::STANDARD_GRAVITY, &tolerance).unwrap();
        // An end that differs by this share changes no roll by 10 µm.
        let near = |a: f64, b: f64| a == b || (a / b - 1.0).abs() < 1e-6;
        for (stored, made) in bands.bands().zip(made.bands()) {
            assert!(near(stored.up_to, made.up_to), "{stored:?} {made:?}");
            assert!(near(stored.friction, made.friction), "{stored:?} {made:?}");
        }
        assert_eq!(made.bands().count(), HEATED_CLOTH.len());
    }

    #[test]
    fn the_spin_deceleration_of_poolfiz_is_that_of_a_friction_of_0_044() {
        // Friction force μ_sp·m·g, lever R, moment of inertia 2/5·m·R².
        let p = Physics::poolfiz();
        let alpha = p.cloth.spin_deceleration;
        let inertia = 0.4 * p.ball.mass * p.ball.radius * p.ball.radius;
        let friction = inertia * alpha / (p.ball.mass * p.gravity * p.ball.radius);
        assert!((friction - 0.044).abs() < 1e-15);
    }

    #[test]
    fn an_offset_of_half_a_radius_does_not_miscue_with_any_preset() {
        for name in Physics::PRESETS {
            let p = Physics::preset(name).unwrap();
            assert!(p.cue.tip_friction >= 0.6 && miscue_limit(p.cue.tip_friction) > 0.5);
            let strike =
                Strike { speed: 2.0, azimuth: 0.0, elevation: 0.0, side: 0.3, height: -0.4 };
            assert!(resolve(&p.cue, &p.ball, &strike).is_ok(), "{name}");
        }
    }

    #[test]
    fn the_ideal_preset_loses_nothing_in_a_centre_strike() {
        let p = Physics::ideal();
        let strike = Strike { speed: 2.0, azimuth: 0.7, elevation: 0.0, side: 0.0, height: 0.0 };
        let (v, _) = resolve(&p.cue, &p.ball, &strike).unwrap();
        let cue_after = 2.0 - v.length() * p.ball.mass / p.cue.mass;
        let energy = p.cue.mass * cue_after * cue_after + p.ball.mass * v.length_squared();
        assert!((energy / (p.cue.mass * 4.0) - 1.0).abs() < 1e-14);
    }
}

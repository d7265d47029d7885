//! The values of November 2026: pool, snooker, English pool and carom. `poolfiz` and `ideal` still
//! take from them what they do not change.

use super::{
    BALL_FREQUENCY_RATIO, CONTACT_TIMES, OFF_CENTRE_LOSS, STANDARD_GRAVITY, STROKE_ELEVATION,
};
use crate::Ball;
use crate::physics::{
    BallBall, BallBallModel, Cloth, Cue, Cushion, CushionFriction, CushionModel,
    CushionRestitution, Physics, RollingFriction, SlipFriction, StrikeModel, Surface, Tip,
};

/// Pool: 2¼ in balls on worsted cloth.
pub(super) fn pool() -> Physics {
    Physics {
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
            friction: THROW,
            frequency_ratio: BALL_FREQUENCY_RATIO,
        },
        cushion: RAIL,
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
pub(super) fn snooker() -> Physics {
    let pool = pool();
    Physics {
        // Mathavan 2009, 2014: measured match set.
        ball: Ball { mass: 0.1406, radius: 0.02625 },
        // Mathavan 2009 (μ_s .178–.245, μ_r .0127–.0129 on film), 2014 (spin).
        cloth: Cloth {
            sliding_friction: 0.212,
            rolling_friction: RollingFriction::constant(0.0128),
            spin_deceleration: 22.0,
        },
        // Mathavan 2014, whose balls are rigid; compliant here, as in pool.
        ball_ball: BallBall {
            restitution: 0.89,
            friction: SlipFriction::constant(0.05),
            ..pool.ball_ball
        },
        cushion: SNOOKER_RAIL,
        // 17 oz and a smaller tip, from memory; end mass in proportion, estimated.
        cue: Cue { mass: 0.48, end_mass: 0.0047, tip_radius: 0.009, ..pool.cue },
        ..pool
    }
}

/// English pool: 2 in balls on napped cloth. The layout gives the smaller cue ball (1⅞ in,
/// about 94 g).
pub(super) fn english() -> Physics {
    let snooker = snooker();
    Physics {
        // 2 in, 116 g: from memory.
        ball: Ball { mass: 0.116, radius: 0.0254 },
        // Phenolic balls as in pool; cloth and cushions as in snooker (estimated).
        ball_ball: pool().ball_ball,
        cue: Cue { end_mass: 0.0039, ..snooker.cue },
        ..snooker
    }
}

/// Carom: 61.5 mm balls on heated cloth.
pub(super) fn carom() -> Physics {
    let pool = pool();
    Physics {
        // UMB: 61–61.5 mm; 205–220 g from memory, 210 g as in pooltool.
        ball: Ball { mass: 0.210, radius: 0.03075 },
        cloth: Cloth {
            // As in pool and in pooltool; Han 2005 found 0.069 on his table.
            sliding_friction: 0.2,
            // Heated cloth. A fit to matches gives the deceleration 0.0383 + 0.0150 v m/s² at
            // the speed v. With 0.0045 a ball of 0.6 m/s stops where it does in the fit; a
            // ball of 1 m/s would need 0.0049.
            rolling_friction: RollingFriction::constant(0.0045),
            // Han 2005: M_z = 3.82e-4 N·m on m = 0.23 kg, R = 32.75 mm gives 3.9 rad/s².
            spin_deceleration: 3.9,
        },
        // Han 2005; friction as in pool. The cushions too are those of a pool table: estimated.
        ball_ball: BallBall { restitution: 0.98, ..pool.ball_ball },
        // A carom cue is lighter and stiffer: estimated.
        cue: Cue { mass: 0.51, end_mass: 0.007, ..pool.cue },
        ..pool
    }
}

/// Friction of pool balls, fitted with the compliant model to Alciatore's throw measurements of
/// 2006 and 2014 together (`tests/resolve/ball_ball_measured.rs`): 0.66° rms over 20 readings. TP
/// A.14's friction between rigid balls has 1.39°. A fit to the data of 2014 alone, 0.150·e^(−0.52
/// s), has 0.24° there and 1.2° on the data of 2006.
const THROW: SlipFriction = SlipFriction { a: 0.0, b: 0.115, c: 0.41 };

/// Cushions of a pool table, chosen on measurements: fast sliding banks on three tables (TP B.28:
/// 0.25 diamonds rms at 12 mph, where the tables differ by 0.13 among themselves) and the four
/// table lengths of a firm shot (WPA: 4.1 with the cue at 10 mph). A rolling ball comes back from a
/// perpendicular hit with 0.85 of its speed, a sliding one with 0.78. The tangential compliance is
/// that of pooltool's Stronge model.
pub(super) const RAIL: Cushion = Cushion {
    model: CushionModel::Stronge,
    restitution: CushionRestitution::constant(0.9),
    friction: CushionFriction { a: 0.175, b: 0.0 },
    frequency_ratio: 1.8,
    tangential_factor: 1.0,
    spin_factor: 1.0,
};

/// Cushions of a snooker table, fitted to the 31 filmed rebounds of a rolling ball that hits a nose
/// at 7R/5 squarely (Mathavan, Jackson & Parkin 2009, Fig. 9, 0.28 to 3.5 m/s): 0.023 m/s rms,
/// 0.044 m/s at most. The friction is the least with this error, because more friction moves
/// oblique rebounds away from Mathavan 2010's equations. The fit is 1 up to 2 m/s: the remaining
/// loss there comes from the wedge of slate and nose. Its minimum is 0.58 at 10 m/s, so that it
/// stays plausible for shots faster than the film. Frequency ratio as in pooltool 0.6.0.
const SNOOKER_RAIL: Cushion = Cushion {
    model: CushionModel::Stronge,
    restitution: CushionRestitution::polynomial(1.24, -0.132, 0.0066),
    friction: CushionFriction { a: 0.38, b: 0.0 },
    frequency_ratio: 1.7,
    tangential_factor: 1.0,
    spin_factor: 1.0,
};

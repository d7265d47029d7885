//! Every value of [`Physics`] once: its key in a shot file, its range with the unit, and its meaning.
//!
//! The reader and the writer of shot files, the list of `carom physics`, the JSON Schema, the forms of
//! the page and the table in docs/formats.md follow from these rows. Their order is that of a shot file.

use alloc::vec::Vec;

use super::{BallBallModel, CushionModel, Physics, SlipFriction, StrikeModel, Tip};
use crate::ball::{MASS, RADIUS};
use crate::math::sin_cos;
use crate::range::Range;

/// A coefficient of restitution, an efficiency, or a share that is kept.
pub(crate) const FRACTION: Range = Range::closed(0.0, 1.0, "");
/// A coefficient of friction.
pub(crate) const FRICTION: Range = Range::not_negative("");
/// The end of a speed band.
pub(crate) const BAND_END: Range = Range::positive(" m/s");
/// ω_t/ω_n: Stronge's piecewise solution holds if the tangential spring oscillates faster than the
/// normal one, but less than twice as fast.
const FREQUENCY_RATIO: Range = Range::closed(1.0, 2.0, "");
/// How long a contact lasts at 1 m/s. Two balls touch for 0.35 ms (Alciatore, TP B.29); beyond this
/// range the steps of a network would not resolve its shortest and its longest contact together.
const CONTACT_TIME: Range = Range::closed(5e-5, 5e-2, " s");

/// One value of the physics.
pub(crate) struct Quantity {
    /// The keys that lead to it: `cloth.sliding_friction`.
    pub(crate) path: &'static str,
    /// What it is, for programmers, without the unit.
    pub(crate) about: &'static str,
    /// How a file has it.
    pub(crate) shape: QuantityShape,
}

/// How a file has a value.
pub(crate) enum QuantityShape {
    Number(Number),
    /// An angle in radians or in degrees, with the keys and ranges of `format::angle`.
    Angle(Number),
    /// The name of a published model, and what gives it.
    Model(Words, fn(&Physics) -> &'static str),
    /// A number, the name of a surface, or an object: the rows with its path before their key.
    Formula(Formula),
    /// A number, or a list of speed bands: `cloth.rolling_friction`.
    Bands,
    /// The number of a [`Tip`] that is of this kind.
    Tip(fn(f64) -> Tip),
}

/// A number and its field.
pub(crate) struct Number {
    pub(crate) range: Range,
    /// In a formula, its value where the coefficient is constant.
    pub(crate) flat: f64,
    pub(crate) get: fn(&Physics) -> f64,
    pub(crate) place: fn(&mut Physics) -> &mut f64,
}

/// Words that a file may have for a value.
pub(crate) struct Words {
    /// What they name, for errors.
    pub(crate) kind: &'static str,
    pub(crate) names: fn() -> Vec<&'static str>,
    /// Sets the value to that of the word with this number.
    pub(crate) set: fn(&mut Physics, usize),
}

/// What gives a coefficient at a speed (m/s) or an angle (rad).
pub(crate) type CoefficientLaw = fn(&Physics, f64) -> f64;

/// A coefficient as a formula of a speed or an angle.
pub(crate) struct Formula {
    pub(crate) text: &'static str,
    /// What it depends on: `speed` (m/s) or `angle` (rad).
    pub(crate) argument: &'static str,
    pub(crate) at: CoefficientLaw,
    /// The range of a constant coefficient.
    pub(crate) constant: Range,
    pub(crate) names: Option<Words>,
}

/// The groups of a shot file's `physics`.
pub(crate) const GROUPS: &[(&str, &str)] = &[
    ("ball", "Defaults for every ball."),
    ("cloth", "Ball on cloth."),
    ("ball_ball", "Ball against ball."),
    ("cushion", "Ball against cushion."),
    ("facing", "Ball against the facings and points of a pocket's jaws, in the cushion's model."),
    ("liner", "Ball against the wall behind a pocket's hole, in the cushion's model."),
    ("slate", "A ball that bounces on the slate, on the edge of a hole, or on a rail's top."),
    ("cue", "The cue."),
    (
        "contact_times",
        "How long contacts last at an approach of 1 m/s without losses, s. They matter where several \
         contacts act at once.",
    ),
];

macro_rules! number {
    ($range:expr, $flat:expr, $($field:ident).+) => {
        Number { range: $range, flat: $flat, get: |p| p.$($field).+, place: |p| &mut p.$($field).+ }
    };
}

macro_rules! shape {
    (number($range:expr $(, flat $flat:literal)?) $($field:ident).+) => {
        QuantityShape::Number(number!($range, 0.0 $(+ $flat)?, $($field).+))
    };
    (angle() $($field:ident).+) => { QuantityShape::Angle(number!(FRICTION, 0.0, $($field).+)) };
    (model($Model:ident, $kind:literal $(, $then:expr)?) $($field:ident).+) => {
        QuantityShape::Model(
            Words {
                kind: $kind,
                names: || $Model::ALL.map($Model::name).to_vec(),
                set: |p, i| {
                    p.$($field).+ = $Model::ALL[i];
                    $($then(p);)?
                },
            },
            |p| p.$($field).+.name(),
        )
    };
    (formula($formula:expr) $($field:ident).+) => { QuantityShape::Formula($formula) };
    (bands() $($field:ident).+) => { QuantityShape::Bands };
    (tip($tip:expr) $($field:ident).+) => { QuantityShape::Tip($tip) };
}

macro_rules! quantities {
    ($($first:ident$(.$key:ident)*: $shape:ident($($detail:tt)*) $about:literal;)+) => {
        &[$(Quantity {
            path: concat!(stringify!($first) $(, ".", stringify!($key))*),
            about: $about,
            shape: shape!($shape($($detail)*) $first$(.$key)*),
        }),+]
    };
}

/// All values; the numbers of a formula are behind it.
pub(crate) const QUANTITIES: &[Quantity] = quantities! {
    gravity: number(Range::positive(" m/s²")) "Gravitational acceleration.";

    ball.mass: number(MASS) "Mass.";
    ball.radius: number(RADIUS) "Radius.";

    cloth.sliding_friction: number(FRICTION) "Coefficient of sliding friction.";
    cloth.rolling_friction: bands()
        "Coefficient of rolling resistance: a number, or one for each band of speeds.";
    cloth.spin_deceleration: number(Range::not_negative(" rad/s²"))
        "Deceleration of the spin about the vertical.";

    ball_ball.model: model(BallBallModel, "ball–ball model", of_elastic_balls)
        "The published model.";
    ball_ball.restitution: number(FRACTION)
        "Coefficient of normal restitution; with the model elastic the default is 1.";
    ball_ball.friction: formula(SLIP_FRICTION)
        "Coefficient of friction, μ(s) = a + b·exp(−c·s) of the slip speed s in m/s, or the name of a surface; a + b ≥ 0. Missing keys are taken from the base.";
    ball_ball.friction.a: number(FRICTION) "Limit at high slip speed.";
    ball_ball.friction.b: number(Range::any("")) "Addition at slip speed 0.";
    ball_ball.friction.c: number(Range::not_negative(" s/m")) "Decay.";
    ball_ball.frequency_ratio: number(FREQUENCY_RATIO) "ω_t/ω_n of the model compliant.";

    cushion.model: model(CushionModel, "cushion model")
        "The published model; restitution: normal velocity × −e and nothing else changes; factors: normal velocity × −e, velocity along the rail × tangential_factor, spin × spin_factor.";
    cushion.restitution: formula(CUSHION_RESTITUTION)
        "Coefficient of restitution: a number, or e = a + bV + cV² of the normal speed V in m/s, kept in [lowest, highest].";
    cushion.restitution.a: number(Range::any("")) "Constant part.";
    cushion.restitution.b: number(Range::any(" per m/s")) "Rise with the normal speed.";
    cushion.restitution.c: number(Range::any(" per (m/s)²")) "Rise with its square.";
    cushion.restitution.lowest: number(FRACTION) "Lower limit of e, at most highest.";
    cushion.restitution.highest: number(FRACTION, flat 1.0) "Upper limit of e.";
    cushion.friction: formula(CUSHION_FRICTION)
        "Coefficient of friction: a number, or μ = a + bγ of the incidence γ from the normal in rad, at least 0.";
    cushion.friction.a: number(FRICTION) "Constant part.";
    cushion.friction.b: number(Range::any(" per rad")) "Rise with the incidence.";
    cushion.frequency_ratio: number(FREQUENCY_RATIO) "ω_t/ω_n of the model stronge.";
    cushion.tangential_factor: number(FRACTION)
        "Share of the velocity along the rail that the model factors keeps.";
    cushion.spin_factor: number(FRACTION) "Share of the spin that the model factors keeps.";

    facing.restitution: number(FRACTION) "Coefficient of restitution.";
    facing.friction: number(FRICTION) "Coefficient of friction.";
    liner.restitution: number(FRACTION) "Coefficient of restitution.";
    liner.friction: number(FRICTION) "Coefficient of friction.";
    slate.restitution: number(FRACTION) "Coefficient of restitution.";
    slate.friction: number(FRICTION) "Coefficient of friction.";

    cue.model: model(StrikeModel, "strike model")
        "network: tip, slate and all that touches the ball act at once; sequential: first the tip alone, then the slate.";
    cue.mass: number(MASS) "Mass.";
    cue.end_mass: number(Range::not_negative(" kg"))
        "Mass of the shaft's end that takes part in squirt; 0 for a cue without squirt.";
    cue.tip_radius: number(Range::not_negative(" m")) "Radius of the tip's curvature.";
    cue.tip_friction: number(FRICTION)
        "Friction between tip and ball. It sets the miscue limit.";
    cue.tip_restitution: tip(Tip::Restitution)
        "Newton's coefficient of restitution of the tip; replaces the base's efficiency.";
    cue.tip_efficiency: tip(Tip::Efficiency)
        "Energy efficiency η of the tip (TP A.30); replaces the base's restitution.";
    cue.tip_off_centre_loss: number(Range::not_negative(""))
        "c: the tip's restitution is e/√(1 + c·tan²β), where β is the angle between the cue's axis and the ball's surface normal. Writing tip_restitution or tip_efficiency sets it to 0.";
    cue.stroke_elevation: angle()
        "Least elevation of a real stroke: the default elevation of a strike is at least this angle. With 0 the default elevation is 0.";

    contact_times.tip: number(CONTACT_TIME) "The tip of the cue on the ball.";
    contact_times.slate: number(CONTACT_TIME) "The ball on the slate.";
};

const SLIP_FRICTION: Formula = Formula {
    text: "μ(s) = a + b·exp(−c·s).",
    argument: "speed",
    at: |p, slip| p.ball_ball.friction.at(slip),
    constant: FRICTION,
    names: Some(Words {
        kind: "surface of the balls",
        names: || SlipFriction::SURFACES.map(|(name, _)| name).to_vec(),
        set: |p, i| p.ball_ball.friction = SlipFriction::SURFACES[i].1,
    }),
};

const CUSHION_RESTITUTION: Formula = Formula {
    text: "e = a + bV + cV².",
    argument: "speed",
    at: |p, speed| p.cushion.restitution.at(speed),
    constant: FRACTION,
    names: None,
};

const CUSHION_FRICTION: Formula = Formula {
    text: "μ = a + bγ.",
    argument: "angle",
    at: |p, incidence| {
        let (sin, cos) = sin_cos(incidence);
        p.cushion.friction.at(sin, cos)
    },
    constant: FRICTION,
    names: None,
};

/// A user who chooses elastic balls does not expect the base's losses.
fn of_elastic_balls(physics: &mut Physics) {
    if physics.ball_ball.model == BallBallModel::Elastic {
        physics.ball_ball.restitution = 1.0;
    }
}

impl Quantity {
    /// The value at `path`.
    pub(crate) fn find(path: &str) -> Option<&'static Self> {
        QUANTITIES.iter().find(|quantity| quantity.path == path)
    }

    /// The unit of the number that a file has at `path`; empty if it has none.
    pub(crate) fn unit(path: &str) -> &'static str {
        let in_degrees = path.strip_suffix("_deg");
        match Self::find(in_degrees.unwrap_or(path)).map(|quantity| &quantity.shape) {
            Some(QuantityShape::Number(number)) => number.range.unit(),
            Some(QuantityShape::Angle(_)) if in_degrees.is_some() => "deg",
            Some(QuantityShape::Angle(_)) => "rad",
            _ => "",
        }
    }

    /// The values directly below `path`: of a group or of a formula; those outside of groups if it is
    /// empty.
    pub(crate) fn below(path: &str) -> impl Iterator<Item = &'static Self> {
        QUANTITIES.iter().filter(move |quantity| quantity.split().0 == path)
    }

    /// The path of its group or formula, empty outside of groups, and its own key.
    pub(crate) fn split(&self) -> (&'static str, &'static str) {
        self.path.rsplit_once('.').unwrap_or(("", self.path))
    }

    /// The numbers of a formula.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = &'static Number> {
        Self::below(self.path).filter_map(|quantity| match &quantity.shape {
            QuantityShape::Number(number) => Some(number),
            _ => None,
        })
    }

    /// The coefficient of a formula, if it is the same at every speed or angle: its first number.
    pub(crate) fn constant(&self, physics: &Physics) -> Option<f64> {
        let mut numbers = self.numbers();
        let first = numbers.next()?;
        numbers.all(|n| (n.get)(physics) == n.flat).then(|| (first.get)(physics))
    }

    /// Makes the coefficient of a formula the same at every speed or angle.
    pub(crate) fn set_constant(&self, physics: &mut Physics, coefficient: f64) {
        for (i, n) in self.numbers().enumerate() {
            *(n.place)(physics) = if i == 0 { coefficient } else { n.flat };
        }
    }

    /// What a coefficient may depend on, and its law.
    pub(crate) fn law(&self) -> Option<(&'static str, CoefficientLaw)> {
        match &self.shape {
            QuantityShape::Formula(formula) => Some((formula.argument, formula.at)),
            QuantityShape::Bands => Some(("speed", |p, speed| p.cloth.rolling_friction.at(speed))),
            _ => None,
        }
    }
}

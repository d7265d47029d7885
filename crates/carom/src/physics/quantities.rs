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
    /// The keys of its group and its own: `cloth.sliding_friction`.
    pub(crate) path: &'static str,
    /// What it is, for programmers, without the unit.
    pub(crate) about: &'static str,
    /// How a file has it.
    pub(crate) shape: QuantityShape,
}

/// How a file has a value.
pub(crate) enum QuantityShape {
    /// A number.
    Number(Number),
    /// [`STROKE_ELEVATION`](crate::format): an angle in radians or in degrees.
    Angle(Number),
    /// The name of a published model.
    Model(Words, fn(&Physics) -> &'static str),
    /// A number, the numbers of a formula, or a name.
    Formula(Formula),
    /// A number, or a list of speed bands: `cloth.rolling_friction`.
    Bands,
    /// [`Tip`]: the key says which of two properties the number is.
    Tip,
}

/// A number and its field.
pub(crate) struct Number {
    pub(crate) range: Range,
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

/// A coefficient as a formula of a speed or an angle.
pub(crate) struct Formula {
    pub(crate) law: FormulaLaw,
    pub(crate) formula: &'static str,
    /// The range of a constant coefficient.
    pub(crate) constant: Range,
    /// The numbers of the formula. A constant is the first one alone.
    pub(crate) numbers: &'static [FormulaNumber],
    pub(crate) names: Option<Words>,
}

/// Which formula.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum FormulaLaw {
    /// [`SlipFriction`] between balls.
    SlipFriction,
    /// [`CushionRestitution`](super::CushionRestitution).
    CushionRestitution,
    /// [`CushionFriction`](super::CushionFriction).
    CushionFriction,
}

/// A number of a formula.
pub(crate) struct FormulaNumber {
    pub(crate) key: &'static str,
    pub(crate) about: &'static str,
    /// Its value where the coefficient is constant.
    pub(crate) flat: f64,
    pub(crate) number: Number,
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
    ($range:expr, $($field:ident).+) => {
        Number { range: $range, get: |p| p.$($field).+, place: |p| &mut p.$($field).+ }
    };
}

macro_rules! shape {
    (number($range:expr) $($field:ident).+) => { QuantityShape::Number(number!($range, $($field).+)) };
    // Its ranges are those of `format::angle`.
    (angle() $($field:ident).+) => { QuantityShape::Angle(number!(FRICTION, $($field).+)) };
    (model($Model:ident, $kind:literal $(, $then:expr)?) $($field:ident).+) => {
        QuantityShape::Model(
            Words {
                kind: $kind,
                names: || $Model::NAMED.iter().map(|(name, _)| *name).collect(),
                set: |p, i| {
                    p.$($field).+ = $Model::ALL[i];
                    $($then(p);)?
                },
            },
            |p| p.$($field).+.name(),
        )
    };
    (fit($fit:expr) $($field:ident).+) => { QuantityShape::Formula($fit) };
    (bands() $($field:ident).+) => { QuantityShape::Bands };
    (tip() $($field:ident).+) => { QuantityShape::Tip };
}

macro_rules! quantities {
    ($($group:ident$(.$key:ident)?: $shape:ident($($detail:tt)*) $about:literal;)+) => {
        &[$(Quantity {
            path: concat!(stringify!($group) $(, ".", stringify!($key))?),
            about: $about,
            shape: shape!($shape($($detail)*) $group$(.$key)?),
        }),+]
    };
}

/// All values, those without a group first.
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
    ball_ball.friction: fit(SLIP_FRICTION)
        "Coefficient of friction, μ(s) = a + b·exp(−c·s) of the slip speed s in m/s, or the name of a surface; a + b ≥ 0. Missing keys are taken from the base.";
    ball_ball.frequency_ratio: number(FREQUENCY_RATIO) "ω_t/ω_n of the model compliant.";

    cushion.model: model(CushionModel, "cushion model")
        "The published model; restitution: normal velocity × −e and nothing else changes; factors: normal velocity × −e, velocity along the rail × tangential_factor, spin × spin_factor.";
    cushion.restitution: fit(CUSHION_RESTITUTION)
        "Coefficient of restitution: a number, or e = a + bV + cV² of the normal speed V in m/s, kept in [lowest, highest].";
    cushion.friction: fit(CUSHION_FRICTION)
        "Coefficient of friction: a number, or μ = a + bγ of the incidence γ from the normal in rad, at least 0.";
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
    cue.tip: tip() "How much of the impact the tip returns.";
    cue.tip_off_centre_loss: number(Range::not_negative(""))
        "c: the tip's restitution is e/√(1 + c·tan²β), where β is the angle between the cue's axis and the ball's surface normal. Writing tip_restitution or tip_efficiency sets it to 0.";
    cue.stroke_elevation: angle()
        "Least elevation of a real stroke: the default elevation of a strike is at least this angle. With 0 the default elevation is 0.";

    contact_times.tip: number(CONTACT_TIME) "The tip of the cue on the ball.";
    contact_times.slate: number(CONTACT_TIME) "The ball on the slate.";
};

/// A property of the tip: its key, its meaning, and the tip with a number of it.
type TipProperty = (&'static str, &'static str, fn(f64) -> Tip);

/// The two properties of [`Tip`].
pub(crate) const TIPS: [TipProperty; 2] = [
    (
        "tip_restitution",
        "Newton's coefficient of restitution of the tip; replaces the base's efficiency.",
        Tip::Restitution,
    ),
    (
        "tip_efficiency",
        "Energy efficiency η of the tip (TP A.30); replaces the base's restitution.",
        Tip::Efficiency,
    ),
];

macro_rules! numbers {
    ($group:ident.$quantity:ident {
        $($key:ident: $range:expr, flat $flat:literal, $about:literal;)+
    }) => {
        &[$(FormulaNumber {
            key: stringify!($key),
            about: $about,
            flat: $flat,
            number: number!($range, $group.$quantity.$key),
        }),+]
    };
}

const SLIP_FRICTION: Formula = Formula {
    law: FormulaLaw::SlipFriction,
    formula: "μ(s) = a + b·exp(−c·s).",
    constant: FRICTION,
    numbers: numbers! { ball_ball.friction {
        a: FRICTION, flat 0.0, "Limit at high slip speed.";
        b: Range::any(""), flat 0.0, "Addition at slip speed 0.";
        c: Range::not_negative(" s/m"), flat 0.0, "Decay.";
    }},
    names: Some(Words {
        kind: "surface of the balls",
        names: || SlipFriction::SURFACES.map(|(name, _)| name).into(),
        set: |p, i| p.ball_ball.friction = SlipFriction::SURFACES[i].1,
    }),
};

const CUSHION_RESTITUTION: Formula = Formula {
    law: FormulaLaw::CushionRestitution,
    formula: "e = a + bV + cV².",
    constant: FRACTION,
    numbers: numbers! { cushion.restitution {
        a: Range::any(""), flat 0.0, "Constant part.";
        b: Range::any(" per m/s"), flat 0.0, "Rise with the normal speed.";
        c: Range::any(" per (m/s)²"), flat 0.0, "Rise with its square.";
        lowest: FRACTION, flat 0.0, "Lower limit of e, at most highest.";
        highest: FRACTION, flat 1.0, "Upper limit of e.";
    }},
    names: None,
};

const CUSHION_FRICTION: Formula = Formula {
    law: FormulaLaw::CushionFriction,
    formula: "μ = a + bγ.",
    constant: FRICTION,
    numbers: numbers! { cushion.friction {
        a: FRICTION, flat 0.0, "Constant part.";
        b: Range::any(" per rad"), flat 0.0, "Rise with the incidence.";
    }},
    names: None,
};

/// A user who chooses elastic balls does not expect the base's losses.
fn of_elastic_balls(physics: &mut Physics) {
    if physics.ball_ball.model == BallBallModel::Elastic {
        physics.ball_ball.restitution = 1.0;
    }
}

impl Quantity {
    /// The value at `path`, such as `cloth.sliding_friction`.
    pub(crate) fn find(path: &str) -> Option<&'static Self> {
        QUANTITIES.iter().find(|quantity| quantity.path == path)
    }

    /// The values of a group; those outside of all groups for an empty key.
    pub(crate) fn of_group(group: &str) -> impl Iterator<Item = &'static Self> + Clone {
        QUANTITIES.iter().filter(move |quantity| quantity.group() == group)
    }

    /// The key of the group, empty outside of groups, and its own.
    fn split(&self) -> (&'static str, &'static str) {
        self.path.split_once('.').unwrap_or(("", self.path))
    }

    /// The key of its group; empty outside of groups.
    pub(crate) fn group(&self) -> &'static str {
        self.split().0
    }

    /// Its key in its group.
    pub(crate) fn key(&self) -> &'static str {
        self.split().1
    }

    /// The unit of the number that a file has under `key`, which is [`Self::key`] or a key below it;
    /// empty if it has none.
    pub(crate) fn unit(&self, key: &str) -> &'static str {
        match &self.shape {
            QuantityShape::Number(number) => number.range.unit(),
            QuantityShape::Angle(_) => {
                if key.ends_with("_deg") {
                    "deg"
                } else {
                    "rad"
                }
            }
            QuantityShape::Formula(fit) => {
                let number = fit
                    .numbers
                    .iter()
                    .find(|n| key.split_once('.').is_some_and(|(_, k)| k == n.key));
                number.map_or("", |n| n.number.range.unit())
            }
            QuantityShape::Model(..) | QuantityShape::Bands | QuantityShape::Tip => "",
        }
    }

    /// The coefficient at a speed (m/s) or an angle of incidence (rad); `None` if none can be given.
    pub(crate) fn at(&self, physics: &Physics, at: f64) -> Option<f64> {
        let Physics { cloth, ball_ball, cushion, .. } = physics;
        match &self.shape {
            QuantityShape::Bands => Some(cloth.rolling_friction.at(at)),
            QuantityShape::Formula(fit) => Some(match fit.law {
                FormulaLaw::SlipFriction => ball_ball.friction.at(at),
                FormulaLaw::CushionRestitution => cushion.restitution.at(at),
                FormulaLaw::CushionFriction => {
                    let (sin, cos) = sin_cos(at);
                    cushion.friction.at(sin, cos)
                }
            }),
            _ => None,
        }
    }

    /// What the coefficient depends on, if it may depend on something.
    pub(crate) fn argument(&self) -> Option<&'static str> {
        match &self.shape {
            QuantityShape::Formula(Formula { law: FormulaLaw::CushionFriction, .. }) => {
                Some("angle")
            }
            QuantityShape::Formula(_) | QuantityShape::Bands => Some("speed"),
            _ => None,
        }
    }
}

impl Formula {
    /// The coefficient, if it is the same at every speed or angle.
    pub(crate) fn as_constant(&self, physics: &Physics) -> Option<f64> {
        let (first, others) = self.numbers.split_first()?;
        let is_flat = others.iter().all(|n| (n.number.get)(physics) == n.flat);
        is_flat.then(|| (first.number.get)(physics))
    }

    /// Makes the coefficient the same at every speed or angle.
    pub(crate) fn set_constant(&self, physics: &mut Physics, coefficient: f64) {
        for (i, n) in self.numbers.iter().enumerate() {
            *(n.number.place)(physics) = if i == 0 { coefficient } else { n.flat };
        }
    }
}

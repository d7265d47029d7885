//! The `physics` of a shot file: a preset's name, or an object merged key by key over its base.

use alloc::format;
use alloc::vec::Vec;

use super::angle::STROKE_ELEVATION;
use super::node::Node;
use super::read::At;
use crate::Ball;
use crate::edition;
use crate::error::Error;
use crate::physics::{
    BallBall, BallBallModel, Cloth, ContactTimes, Cue, Cushion, CushionFriction, CushionModel,
    CushionRestitution, Physics, RollingBand, RollingFriction, SlipFriction, StrikeModel, Surface,
    Tip,
};
use crate::range::Range;
use crate::shot::{MASS, RADIUS};

/// A coefficient of restitution, an efficiency, or a share that is kept.
const FRACTION: Range = Range::closed(0.0, 1.0, "");
/// A coefficient of friction.
pub(super) const FRICTION: Range = Range::not_negative("");
/// ω_t/ω_n: Stronge's piecewise solution holds if the tangential spring oscillates faster than the
/// normal one, but less than twice as fast.
const FREQUENCY_RATIO: Range = Range::closed(1.0, 2.0, "");

/// How long a contact lasts at 1 m/s. Two balls touch for 0.35 ms (Alciatore, TP B.29); beyond this
/// range the steps of a network would not resolve its shortest and its longest contact together.
const CONTACT_TIME: Range = Range::closed(5e-5, 5e-2, " s");

/// Reads `physics`; `default` is the preset that belongs to the table.
pub(super) fn read(at: Option<&At<'_>>, default: &str) -> Result<Physics, Error> {
    let Some(at) = at else { return Ok(preset(default)) };
    if !at.is_object() {
        return named(at);
    }
    let fields = at.fields(&[
        "base",
        "gravity",
        "ball",
        "cloth",
        "ball_ball",
        "cushion",
        "facing",
        "liner",
        "slate",
        "cue",
        "contact_times",
    ])?;
    let mut physics = match fields.get("base") {
        Some(base) => named(&base)?,
        None => preset(default),
    };
    fields.number_into("gravity", &Range::positive(" m/s²"), &mut physics.gravity)?;
    if let Some(at) = fields.get("ball") {
        ball(&at, &mut physics.ball)?;
    }
    if let Some(at) = fields.get("cloth") {
        cloth(&at, &mut physics.cloth)?;
    }
    if let Some(at) = fields.get("ball_ball") {
        ball_ball(&at, &mut physics.ball_ball)?;
    }
    if let Some(at) = fields.get("cushion") {
        cushion(&at, &mut physics.cushion)?;
    }
    let Physics { facing, liner, slate, .. } = &mut physics;
    for (key, law) in [("facing", facing), ("liner", liner), ("slate", slate)] {
        if let Some(at) = fields.get(key) {
            surface(&at, law)?;
        }
    }
    if let Some(at) = fields.get("cue") {
        cue(&at, &mut physics.cue)?;
    }
    if let Some(at) = fields.get("contact_times") {
        contact_times(&at, &mut physics.contact_times)?;
    }
    Ok(physics)
}

fn preset(name: &str) -> Physics {
    Physics::preset(name).expect("every table names a physics preset that exists")
}

fn named(at: &At<'_>) -> Result<Physics, Error> {
    let name = at.text("a physics preset's name, or an object {...}")?;
    let known = || edition::names(edition::PHYSICS);
    Physics::preset(name).ok_or_else(|| at.unknown_word(name, "physics preset", &known()))
}

fn ball(at: &At<'_>, ball: &mut Ball) -> Result<(), Error> {
    let fields = at.fields(&["mass", "radius"])?;
    fields.number_into("mass", &MASS, &mut ball.mass)?;
    fields.number_into("radius", &RADIUS, &mut ball.radius)
}

fn cloth(at: &At<'_>, cloth: &mut Cloth) -> Result<(), Error> {
    let fields = at.fields(&["sliding_friction", "rolling_friction", "spin_deceleration"])?;
    fields.number_into("sliding_friction", &FRICTION, &mut cloth.sliding_friction)?;
    if let Some(at) = fields.get("rolling_friction") {
        cloth.rolling_friction = rolling_friction(&at)?;
    }
    let deceleration = Range::not_negative(" rad/s²");
    fields.number_into("spin_deceleration", &deceleration, &mut cloth.spin_deceleration)
}

/// A number, or a list of speed bands. A list replaces that of the base.
fn rolling_friction(at: &At<'_>) -> Result<RollingFriction, Error> {
    if let Node::Integer(_) | Node::Number(_) = at.node() {
        return Ok(RollingFriction::constant(at.number(&FRICTION)?));
    }
    let items = at.items("a number ≥ 0, or a list of speed bands")?;
    let bands: Result<Vec<_>, _> = items.iter().map(rolling_band).collect();
    RollingFriction::from_bands(&bands?).map_err(|error| error.inside(at.place()))
}

fn rolling_band(at: &At<'_>) -> Result<RollingBand, Error> {
    let fields = at.fields(&["up_to", "friction"])?;
    let mut up_to = f64::INFINITY;
    fields.number_into("up_to", &Range::positive(" m/s"), &mut up_to)?;
    let friction = fields.require("friction", "the coefficient, such as 0.01")?;
    Ok(RollingBand { up_to, friction: friction.number(&FRICTION)? })
}

fn ball_ball(at: &At<'_>, law: &mut BallBall) -> Result<(), Error> {
    let fields = at.fields(&["model", "restitution", "friction", "frequency_ratio"])?;
    if let Some(at) = fields.get("model") {
        law.model = at.choice("ball–ball model", BallBallModel::NAMED)?;
        if law.model == BallBallModel::Elastic {
            // A user who chooses elastic balls does not expect the base's losses.
            law.restitution = 1.0;
        }
    }
    fields.number_into("restitution", &FRACTION, &mut law.restitution)?;
    if let Some(at) = fields.get("friction") {
        slip_friction(&at, &mut law.friction)?;
    }
    fields.number_into("frequency_ratio", &FREQUENCY_RATIO, &mut law.frequency_ratio)
}

fn slip_friction(at: &At<'_>, friction: &mut SlipFriction) -> Result<(), Error> {
    if at.is_text() {
        *friction = at.choice("surface of the balls", &SlipFriction::SURFACES)?;
        return Ok(());
    }
    if !at.is_object() {
        *friction = SlipFriction::constant(at.number(&FRICTION)?);
        return Ok(());
    }
    let fields = at.fields(&["a", "b", "c"])?;
    fields.number_into("a", &FRICTION, &mut friction.a)?;
    fields.number_into("b", &Range::any(""), &mut friction.b)?;
    fields.number_into("c", &Range::not_negative(" s/m"), &mut friction.c)?;
    if friction.a + friction.b < 0.0 {
        return Err(at.refuse(
            format!("the friction a + b at slip speed 0 is {:?}", friction.a + friction.b),
            "choose a and b with a + b ≥ 0",
        ));
    }
    Ok(())
}

/// Reads `cushion` over the law of the base. A new model keeps the fits of the base as a whole,
/// because every model takes them: a coefficient alone, without the others and the limits, would be
/// another rail.
fn cushion(at: &At<'_>, law: &mut Cushion) -> Result<(), Error> {
    let fields = at.fields(&[
        "model",
        "restitution",
        "friction",
        "frequency_ratio",
        "tangential_factor",
        "spin_factor",
    ])?;
    if let Some(at) = fields.get("model") {
        law.model = at.choice("cushion model", CushionModel::NAMED)?;
    }
    if let Some(at) = fields.get("restitution") {
        cushion_restitution(&at, &mut law.restitution)?;
    }
    if let Some(at) = fields.get("friction") {
        cushion_friction(&at, &mut law.friction)?;
    }
    fields.number_into("tangential_factor", &FRACTION, &mut law.tangential_factor)?;
    fields.number_into("spin_factor", &FRACTION, &mut law.spin_factor)?;
    fields.number_into("frequency_ratio", &FREQUENCY_RATIO, &mut law.frequency_ratio)
}

fn cushion_restitution(at: &At<'_>, restitution: &mut CushionRestitution) -> Result<(), Error> {
    if !at.is_object() {
        *restitution = CushionRestitution::constant(at.number(&FRACTION)?);
        return Ok(());
    }
    let fields = at.fields(&["a", "b", "c", "lowest", "highest"])?;
    fields.number_into("a", &Range::any(""), &mut restitution.a)?;
    fields.number_into("b", &Range::any(" per m/s"), &mut restitution.b)?;
    fields.number_into("c", &Range::any(" per (m/s)²"), &mut restitution.c)?;
    fields.number_into("lowest", &FRACTION, &mut restitution.lowest)?;
    fields.number_into("highest", &FRACTION, &mut restitution.highest)?;
    let CushionRestitution { lowest, highest, .. } = *restitution;
    if lowest > highest {
        let (key, other) = if fields.get("lowest").is_some() {
            ("lowest", format!("highest is {highest:?}"))
        } else {
            ("highest", format!("lowest is {lowest:?}"))
        };
        let place = fields.get(key).unwrap_or_else(|| at.clone());
        return Err(place.refuse(
            format!("the lower limit is above the upper one: {other}"),
            "choose lowest ≤ highest",
        ));
    }
    if !restitution.is_possible() {
        return Err(at.refuse(
            format!("a + bV + cV² is outside [{lowest}, {highest}] at every normal speed V"),
            "choose a, b and c that give a coefficient of restitution within the limits",
        ));
    }
    Ok(())
}

fn cushion_friction(at: &At<'_>, friction: &mut CushionFriction) -> Result<(), Error> {
    if !at.is_object() {
        *friction = CushionFriction { a: at.number(&FRICTION)?, b: 0.0 };
        return Ok(());
    }
    let fields = at.fields(&["a", "b"])?;
    fields.number_into("a", &FRICTION, &mut friction.a)?;
    fields.number_into("b", &Range::any(" per rad"), &mut friction.b)
}

fn surface(at: &At<'_>, law: &mut Surface) -> Result<(), Error> {
    let fields = at.fields(&["restitution", "friction"])?;
    fields.number_into("restitution", &FRACTION, &mut law.restitution)?;
    fields.number_into("friction", &FRICTION, &mut law.friction)
}

fn cue(at: &At<'_>, cue: &mut Cue) -> Result<(), Error> {
    let fields = at.fields(&[
        "model",
        "mass",
        "end_mass",
        "tip_radius",
        "tip_friction",
        "tip_restitution",
        "tip_efficiency",
        "tip_off_centre_loss",
        "stroke_elevation",
        "stroke_elevation_deg",
    ])?;
    if let Some(at) = fields.get("model") {
        cue.model = at.choice("strike model", StrikeModel::NAMED)?;
    }
    fields.number_into("mass", &MASS, &mut cue.mass)?;
    fields.number_into("end_mass", &Range::not_negative(" kg"), &mut cue.end_mass)?;
    fields.number_into("tip_radius", &Range::not_negative(" m"), &mut cue.tip_radius)?;
    fields.number_into("tip_friction", &FRICTION, &mut cue.tip_friction)?;
    if let Some(angle) = STROKE_ELEVATION.read(&fields)? {
        cue.stroke_elevation = angle;
    }
    match (fields.get("tip_restitution"), fields.get("tip_efficiency")) {
        (Some(_), Some(efficiency)) => {
            return Err(efficiency.refuse(
                "tip_restitution and tip_efficiency describe the same property",
                "keep one of the two",
            ));
        }
        (Some(e), None) => {
            cue.tip = Tip::Restitution(e.number(&FRACTION)?);
            cue.tip_off_centre_loss = 0.0;
        }
        (None, Some(eta)) => {
            cue.tip = Tip::Efficiency(eta.number(&FRACTION)?);
            cue.tip_off_centre_loss = 0.0;
        }
        (None, None) => {}
    }
    let Some(loss) = fields.get("tip_off_centre_loss") else { return Ok(()) };
    cue.tip_off_centre_loss = loss.number(&Range::not_negative(""))?;
    if matches!(cue.tip, Tip::Efficiency(_)) && cue.tip_off_centre_loss > 0.0 {
        return Err(loss.refuse(
            "tip_efficiency describes the loss off the centre, too",
            "leave it out, or give tip_restitution instead of tip_efficiency",
        ));
    }
    Ok(())
}

fn contact_times(at: &At<'_>, times: &mut ContactTimes) -> Result<(), Error> {
    let fields = at.fields(&["tip", "slate"])?;
    fields.number_into("tip", &CONTACT_TIME, &mut times.tip)?;
    fields.number_into("slate", &CONTACT_TIME, &mut times.slate)
}

/// `physics` as a shot file has it, if `default` is the preset that belongs to the table; `None` if
/// it equals that preset.
pub(super) fn write_over(physics: &Physics, default: &str) -> Option<Node> {
    if Physics::preset(default).as_ref() == Some(physics) {
        return None;
    }
    let is_same = |name: &&str| Physics::preset(name).as_ref() == Some(physics);
    let named = edition::names(edition::PHYSICS).into_iter().find(is_same);
    Some(named.map_or_else(|| physics.to_node(), Node::from))
}

impl Physics {
    /// All keys of `physics` as a shot file has them. They read back to the same bits over any
    /// base.
    pub fn to_node(&self) -> Node {
        write(self)
    }
}

fn write(physics: &Physics) -> Node {
    let Physics { gravity, ball, cloth, ball_ball, cushion, .. } = physics;
    let Physics { facing, liner, slate, cue, contact_times, .. } = physics;
    let tip = match cue.tip {
        Tip::Restitution(e) => ("tip_restitution", e.into()),
        Tip::Efficiency(eta) => ("tip_efficiency", eta.into()),
    };
    let mut cue_node = Node::object([
        ("model", Node::from(cue.model.name())),
        ("mass", cue.mass.into()),
        ("end_mass", cue.end_mass.into()),
        ("tip_radius", cue.tip_radius.into()),
        ("tip_friction", cue.tip_friction.into()),
        tip,
        ("tip_off_centre_loss", cue.tip_off_centre_loss.into()),
    ]);
    STROKE_ELEVATION.write(&mut cue_node, cue.stroke_elevation);
    Node::object([
        ("gravity", (*gravity).into()),
        ("ball", Node::object([("mass", ball.mass.into()), ("radius", ball.radius.into())])),
        (
            "cloth",
            Node::object([
                ("sliding_friction", cloth.sliding_friction.into()),
                ("rolling_friction", cloth.rolling_friction.to_node()),
                ("spin_deceleration", cloth.spin_deceleration.into()),
            ]),
        ),
        (
            "ball_ball",
            Node::object([
                ("model", Node::from(ball_ball.model.name())),
                ("restitution", ball_ball.restitution.into()),
                ("friction", write_slip_friction(&ball_ball.friction)),
                ("frequency_ratio", ball_ball.frequency_ratio.into()),
            ]),
        ),
        ("cushion", write_cushion(cushion)),
        ("facing", write_surface(facing)),
        ("liner", write_surface(liner)),
        ("slate", write_surface(slate)),
        ("cue", cue_node),
        (
            "contact_times",
            Node::object([
                ("tip", contact_times.tip.into()),
                ("slate", contact_times.slate.into()),
            ]),
        ),
    ])
}

impl RollingFriction {
    /// `physics.cloth.rolling_friction` as a shot file has it: a number, or a list of bands.
    pub fn to_node(&self) -> Node {
        if let Some(mu) = self.as_constant() {
            return mu.into();
        }
        Node::list(self.bands().map(|RollingBand { up_to, friction }| {
            let mut band = Node::object([]);
            if up_to.is_finite() {
                band.set("up_to", up_to);
            }
            band.set("friction", friction);
            band
        }))
    }
}

fn write_surface(law: &Surface) -> Node {
    Node::object([("restitution", law.restitution.into()), ("friction", law.friction.into())])
}

fn write_slip_friction(friction: &SlipFriction) -> Node {
    let SlipFriction { a, b, c } = *friction;
    if b == 0.0 && c == 0.0 {
        return a.into();
    }
    Node::object([("a", a.into()), ("b", b.into()), ("c", c.into())])
}

fn write_cushion(cushion: &Cushion) -> Node {
    let CushionRestitution { a, b, c, lowest, highest } = cushion.restitution;
    let restitution = if cushion.restitution.is_constant() {
        a.into()
    } else {
        // The limits too, because a base may have others.
        let numbers = [("a", a), ("b", b), ("c", c), ("lowest", lowest), ("highest", highest)];
        Node::object(numbers.map(|(key, x)| (key, x.into())))
    };
    let CushionFriction { a, b } = cushion.friction;
    let friction =
        if b == 0.0 { a.into() } else { Node::object([("a", a.into()), ("b", b.into())]) };
    Node::object([
        ("model", Node::from(cushion.model.name())),
        ("restitution", restitution),
        ("friction", friction),
        ("frequency_ratio", cushion.frequency_ratio.into()),
        ("tangential_factor", cushion.tangential_factor.into()),
        ("spin_factor", cushion.spin_factor.into()),
    ])
}

//! The `physics` of a shot file: a preset's name, or an object merged key by key over its base. The
//! keys, their order and their ranges are those of [`quantities`](crate::physics::quantities).

use alloc::format;
use alloc::vec::Vec;

use super::angle::STROKE_ELEVATION;
use super::node::Node;
use super::read::{At, Fields};
use crate::edition;
use crate::error::{Error, ErrorKind};
use crate::physics::quantities::{
    BAND_END, FRACTION, FRICTION, Formula, GROUPS, QUANTITIES, Quantity, QuantityShape, Words,
};
use crate::physics::{Physics, RollingBand, RollingFriction, Tip};

/// Reads `physics`; `default` is the preset that belongs to the table.
pub(super) fn read(at: Option<&At<'_>>, default: &str) -> Result<Physics, Error> {
    let Some(at) = at else { return Ok(preset(default)) };
    if !at.is_object() {
        return named(at);
    }
    let mut known = alloc::vec!["base"];
    known.extend(keys(""));
    known.extend(GROUPS.iter().map(|(group, _)| *group));
    let fields = at.fields(&known)?;
    let mut physics = match fields.get("base") {
        Some(base) => named(&base)?,
        None => preset(default),
    };
    read_values("", &fields, &mut physics)?;
    for (group, _) in GROUPS {
        if let Some(at) = fields.get(group) {
            read_values(group, &at.fields(&keys(group))?, &mut physics)?;
        }
    }
    Ok(physics)
}

/// The keys that a file may have below a path.
fn keys(path: &str) -> Vec<&'static str> {
    let of = |quantity: &Quantity| match quantity.shape {
        QuantityShape::Angle(_) => STROKE_ELEVATION.keys().to_vec(),
        _ => [quantity.split().1].to_vec(),
    };
    Quantity::below(path).flat_map(of).collect()
}

fn preset(name: &str) -> Physics {
    Physics::preset(name).expect("every table names a physics preset that exists")
}

fn named(at: &At<'_>) -> Result<Physics, Error> {
    let name = at.text("a physics preset's name, or an object {...}")?;
    let known = || edition::names(edition::PHYSICS);
    Physics::preset(name).ok_or_else(|| at.unknown_word(name, "physics preset", &known()))
}

fn read_values(path: &str, fields: &Fields<'_>, physics: &mut Physics) -> Result<(), Error> {
    for quantity in Quantity::below(path) {
        if let QuantityShape::Angle(angle) = &quantity.shape {
            if let Some(read) = STROKE_ELEVATION.read(fields)? {
                *(angle.place)(physics) = read;
            }
            continue;
        }
        let Some(at) = fields.get(quantity.split().1) else { continue };
        match &quantity.shape {
            QuantityShape::Number(n) => *(n.place)(physics) = at.number(&n.range)?,
            QuantityShape::Model(models, _) => read_word(&at, models, physics)?,
            QuantityShape::Formula(formula) => read_formula(&at, quantity, formula, physics)?,
            QuantityShape::Bands => physics.cloth.rolling_friction = rolling_friction(&at)?,
            QuantityShape::Tip(tip) => read_tip(&at, *tip, fields, physics)?,
            QuantityShape::Angle(_) => {}
        }
    }
    match fields.get("tip_off_centre_loss") {
        Some(loss) => check_tip_loss(physics).map_err(|error| error.at(loss.place())),
        None => Ok(()),
    }
}

fn read_word(at: &At<'_>, words: &Words, physics: &mut Physics) -> Result<(), Error> {
    let names = (words.names)().into_iter().enumerate();
    let options: Vec<_> = names.map(|(i, name)| (name, i)).collect();
    (words.set)(physics, at.choice(words.kind, &options)?);
    Ok(())
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
    fields.number_into("up_to", &BAND_END, &mut up_to)?;
    let friction = fields.require("friction", "the coefficient, such as 0.01")?;
    Ok(RollingBand { up_to, friction: friction.number(&FRICTION)? })
}

/// Reads a number, the name of a surface, or the numbers of a formula over those of the base. A new
/// model keeps the formulas of the base as a whole, because every model takes them: a coefficient
/// alone, without the others and the limits, would be another rail.
fn read_formula(
    at: &At<'_>,
    quantity: &Quantity,
    formula: &Formula,
    physics: &mut Physics,
) -> Result<(), Error> {
    if let (Some(names), true) = (&formula.names, at.is_text()) {
        return read_word(at, names, physics);
    }
    if !at.is_object() {
        quantity.set_constant(physics, at.number(&formula.constant)?);
        return Ok(());
    }
    let fields = at.fields(&keys(quantity.path))?;
    read_values(quantity.path, &fields, physics)?;
    match quantity.path {
        "ball_ball.friction" => check_slip_friction(physics),
        "cushion.restitution" => {
            let only_highest = fields.get("highest").is_some() && fields.get("lowest").is_none();
            check_restitution(physics, if only_highest { "highest" } else { "lowest" })
        }
        _ => Ok(()),
    }
    .map_err(|error| error.inside(at.place()))
}

/// Refuses a friction of the balls that is negative without slip; the place is empty.
pub(super) fn check_slip_friction(physics: &Physics) -> Result<(), Error> {
    let at_rest = physics.ball_ball.friction.a + physics.ball_ball.friction.b;
    if at_rest >= 0.0 {
        return Ok(());
    }
    let what = format!("the friction a + b at slip speed 0 is {at_rest:?}");
    Err(ErrorKind::OutOfRange.at("", what, "choose a and b with a + b ≥ 0"))
}

/// Refuses a restitution of the cushion without a value within its limits; the place is inside that of
/// the restitution. `limit` is the key of the limit that is at fault if the two do not fit together.
pub(super) fn check_restitution(physics: &Physics, limit: &str) -> Result<(), Error> {
    let restitution = physics.cushion.restitution;
    let (lowest, highest) = (restitution.lowest, restitution.highest);
    if lowest > highest {
        let other = match limit {
            "highest" => format!("lowest is {lowest:?}"),
            _ => format!("highest is {highest:?}"),
        };
        let what = format!("the lower limit is above the upper one: {other}");
        return Err(ErrorKind::OutOfRange.at(limit, what, "choose lowest ≤ highest"));
    }
    if restitution.is_possible() {
        return Ok(());
    }
    Err(ErrorKind::OutOfRange.at(
        "",
        format!("a + bV + cV² is outside [{lowest}, {highest}] at every normal speed V"),
        "choose a, b and c that give a coefficient of restitution within the limits",
    ))
}

/// Reads a property of the tip. The base's loss off the centre belongs to the base's tip.
fn read_tip(
    at: &At<'_>,
    tip: fn(f64) -> Tip,
    fields: &Fields<'_>,
    physics: &mut Physics,
) -> Result<(), Error> {
    if let (Some(_), Some(efficiency)) =
        (fields.get("tip_restitution"), fields.get("tip_efficiency"))
    {
        let what = "tip_restitution and tip_efficiency describe the same property";
        return Err(efficiency.refuse(ErrorKind::Duplicate, what, "keep one of the two"));
    }
    physics.cue.tip = tip(at.number(&FRACTION)?);
    physics.cue.tip_off_centre_loss = 0.0;
    Ok(())
}

/// Refuses a loss off the centre beside an efficiency of the tip; the place is empty.
pub(super) fn check_tip_loss(physics: &Physics) -> Result<(), Error> {
    let is_efficiency = matches!(physics.cue.tip, Tip::Efficiency(_));
    if !is_efficiency || physics.cue.tip_off_centre_loss == 0.0 {
        return Ok(());
    }
    let what = "tip_efficiency describes the loss off the centre, too";
    Err(ErrorKind::Conflict.at(
        "",
        what,
        "leave it out, or give tip_restitution instead of tip_efficiency",
    ))
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
        let mut node = write_values(self, "");
        for (group, _) in GROUPS {
            node.set(group, write_values(self, group));
        }
        node
    }
}

/// The values directly below a path, as an object.
fn write_values(physics: &Physics, path: &str) -> Node {
    let mut node = Node::object([]);
    for quantity in Quantity::below(path) {
        write_value(physics, quantity, &mut node);
    }
    node
}

/// Writes the value into `node`, its group.
pub(super) fn write_value(physics: &Physics, quantity: &Quantity, node: &mut Node) {
    let key = quantity.split().1;
    match &quantity.shape {
        QuantityShape::Number(number) => node.set(key, (number.get)(physics)),
        QuantityShape::Model(_, name) => node.set(key, name(physics)),
        QuantityShape::Angle(angle) => STROKE_ELEVATION.write(node, (angle.get)(physics)),
        QuantityShape::Bands => node.set(key, physics.cloth.rolling_friction.to_node()),
        QuantityShape::Tip(tip) => {
            let (Tip::Restitution(number) | Tip::Efficiency(number)) = physics.cue.tip;
            if tip(number) == physics.cue.tip {
                node.set(key, number);
            }
        }
        QuantityShape::Formula(_) => match quantity.constant(physics) {
            Some(coefficient) => node.set(key, coefficient),
            // All numbers, because a base may have others.
            None => node.set(key, write_values(physics, quantity.path)),
        },
    }
}

/// All keys of `physics`. Where the file's own `physics` has the name of a surface or a formula, the
/// value has this form too.
pub(super) fn write_as_given(physics: &Physics, own: &Node) -> Node {
    let mut node = physics.to_node();
    let formulas = QUANTITIES.iter().filter(|q| matches!(q.shape, QuantityShape::Formula(_)));
    for quantity in formulas {
        let (group, key) = quantity.split();
        let form = match own.get(group).and_then(|group| group.get(key)) {
            Some(name @ Node::Text(_)) => name.clone(),
            Some(Node::Object(_)) => write_values(physics, quantity.path),
            _ => continue,
        };
        if let Some(group) = node.get_mut(group) {
            group.set(key, form);
        }
    }
    node
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

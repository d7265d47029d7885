//! The `physics` of a shot file: a preset's name, or an object merged key by key over its base. The
//! keys, their order and their ranges are those of [`quantities`](crate::physics::quantities).

use alloc::format;
use alloc::vec::Vec;

use super::angle::STROKE_ELEVATION;
use super::node::Node;
use super::read::{At, Fields};
use crate::edition;
use crate::error::Error;
use crate::physics::quantities::{
    BAND_END, FRACTION, FRICTION, Formula, FormulaLaw, GROUPS, QUANTITIES, Quantity, QuantityShape,
    TIPS, Words,
};
use crate::physics::{Physics, RollingBand, RollingFriction, Tip};
use crate::range::Range;

/// Reads `physics`; `default` is the preset that belongs to the table.
pub(super) fn read(at: Option<&At<'_>>, default: &str) -> Result<Physics, Error> {
    let Some(at) = at else { return Ok(preset(default)) };
    if !at.is_object() {
        return named(at);
    }
    let single = keys(Quantity::of_group(""));
    let groups = GROUPS.iter().map(|(group, _)| *group);
    let known: Vec<_> = ["base"].into_iter().chain(single).chain(groups).collect();
    let fields = at.fields(&known)?;
    let mut physics = match fields.get("base") {
        Some(base) => named(&base)?,
        None => preset(default),
    };
    read_values("", &fields, &mut physics)?;
    for (group, _) in GROUPS {
        if let Some(at) = fields.get(group) {
            let known: Vec<_> = keys(Quantity::of_group(group)).collect();
            read_values(group, &at.fields(&known)?, &mut physics)?;
        }
    }
    Ok(physics)
}

/// The keys that a file may have for these values.
pub(super) fn keys(
    quantities: impl Iterator<Item = &'static Quantity>,
) -> impl Iterator<Item = &'static str> {
    quantities.flat_map(|quantity| match quantity.shape {
        QuantityShape::Tip => TIPS.map(|(key, ..)| key).to_vec(),
        QuantityShape::Angle(_) => STROKE_ELEVATION.keys().to_vec(),
        _ => [quantity.key()].to_vec(),
    })
}

fn preset(name: &str) -> Physics {
    Physics::preset(name).expect("every table names a physics preset that exists")
}

fn named(at: &At<'_>) -> Result<Physics, Error> {
    let name = at.text("a physics preset's name, or an object {...}")?;
    let known = || edition::names(edition::PHYSICS);
    Physics::preset(name).ok_or_else(|| at.unknown_word(name, "physics preset", &known()))
}

fn read_values(group: &str, fields: &Fields<'_>, physics: &mut Physics) -> Result<(), Error> {
    for quantity in Quantity::of_group(group) {
        match (&quantity.shape, fields.get(quantity.key())) {
            (QuantityShape::Angle(angle), _) => {
                if let Some(read) = STROKE_ELEVATION.read(fields)? {
                    *(angle.place)(physics) = read;
                }
            }
            (QuantityShape::Tip, _) => read_tip(fields, physics)?,
            (_, None) => {}
            (QuantityShape::Number(n), Some(at)) => *(n.place)(physics) = at.number(&n.range)?,
            (QuantityShape::Model(models, _), Some(at)) => read_word(&at, models, physics)?,
            (QuantityShape::Formula(fit), Some(at)) => read_fit(&at, fit, physics)?,
            (QuantityShape::Bands, Some(at)) => {
                physics.cloth.rolling_friction = rolling_friction(&at)?
            }
        }
    }
    Ok(())
}

fn read_word(at: &At<'_>, words: &Words, physics: &mut Physics) -> Result<(), Error> {
    let names: Vec<_> =
        (words.names)().into_iter().enumerate().map(|(i, name)| (name, i)).collect();
    (words.set)(physics, at.choice(words.kind, &names)?);
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
/// model keeps the fits of the base as a whole, because every model takes them: a coefficient alone,
/// without the others and the limits, would be another rail.
fn read_fit(at: &At<'_>, fit: &Formula, physics: &mut Physics) -> Result<(), Error> {
    if let (Some(names), true) = (&fit.names, at.is_text()) {
        return read_word(at, names, physics);
    }
    if !at.is_object() {
        fit.set_constant(physics, at.number(&fit.constant)?);
        return Ok(());
    }
    let known: Vec<_> = fit.numbers.iter().map(|n| n.key).collect();
    let fields = at.fields(&known)?;
    for n in fit.numbers {
        fields.number_into(n.key, &n.number.range, (n.number.place)(physics))?;
    }
    match fit.law {
        FormulaLaw::SlipFriction => check_slip_friction(at, physics),
        FormulaLaw::CushionRestitution => check_cushion_restitution(at, &fields, physics),
        FormulaLaw::CushionFriction => Ok(()),
    }
}

fn check_slip_friction(at: &At<'_>, physics: &Physics) -> Result<(), Error> {
    let at_rest = physics.ball_ball.friction.a + physics.ball_ball.friction.b;
    if at_rest >= 0.0 {
        return Ok(());
    }
    Err(at.refuse(
        format!("the friction a + b at slip speed 0 is {at_rest:?}"),
        "choose a and b with a + b ≥ 0",
    ))
}

fn check_cushion_restitution(
    at: &At<'_>,
    fields: &Fields<'_>,
    physics: &Physics,
) -> Result<(), Error> {
    let restitution = physics.cushion.restitution;
    let (lowest, highest) = (restitution.lowest, restitution.highest);
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
    if restitution.is_possible() {
        return Ok(());
    }
    Err(at.refuse(
        format!("a + bV + cV² is outside [{lowest}, {highest}] at every normal speed V"),
        "choose a, b and c that give a coefficient of restitution within the limits",
    ))
}

/// Reads the tip's restitution or efficiency. The base's loss off the centre belongs to the base's tip.
fn read_tip(fields: &Fields<'_>, physics: &mut Physics) -> Result<(), Error> {
    let given = TIPS.map(|(key, _, tip)| fields.get(key).map(|at| (at, tip)));
    if let [Some(_), Some((efficiency, _))] = &given {
        return Err(efficiency.refuse(
            "tip_restitution and tip_efficiency describe the same property",
            "keep one of the two",
        ));
    }
    for (at, tip) in given.into_iter().flatten() {
        physics.cue.tip = tip(at.number(&FRACTION)?);
        physics.cue.tip_off_centre_loss = 0.0;
    }
    let Some(loss) = fields.get("tip_off_centre_loss") else { return Ok(()) };
    if matches!(physics.cue.tip, Tip::Efficiency(_)) && loss.number(&Range::any(""))? > 0.0 {
        return Err(loss.refuse(
            "tip_efficiency describes the loss off the centre, too",
            "leave it out, or give tip_restitution instead of tip_efficiency",
        ));
    }
    Ok(())
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
        let mut node = Node::object([]);
        write_values(self, "", &mut node);
        for (group, _) in GROUPS {
            let mut values = Node::object([]);
            write_values(self, group, &mut values);
            node.set(group, values);
        }
        node
    }
}

fn write_values(physics: &Physics, group: &str, node: &mut Node) {
    for quantity in Quantity::of_group(group) {
        write_value(physics, quantity, node);
    }
}

/// Writes the value into `node`, its group.
pub(super) fn write_value(physics: &Physics, quantity: &Quantity, node: &mut Node) {
    let key = quantity.key();
    match &quantity.shape {
        QuantityShape::Number(number) => node.set(key, (number.get)(physics)),
        QuantityShape::Model(_, name) => node.set(key, name(physics)),
        QuantityShape::Angle(angle) => STROKE_ELEVATION.write(node, (angle.get)(physics)),
        QuantityShape::Bands => node.set(key, physics.cloth.rolling_friction.to_node()),
        QuantityShape::Tip => match physics.cue.tip {
            Tip::Restitution(e) => node.set(TIPS[0].0, e),
            Tip::Efficiency(eta) => node.set(TIPS[1].0, eta),
        },
        QuantityShape::Formula(fit) => match fit.as_constant(physics) {
            Some(coefficient) => node.set(key, coefficient),
            None => node.set(key, write_numbers(physics, fit)),
        },
    }
}

/// All numbers of a formula, because a base may have others.
fn write_numbers(physics: &Physics, fit: &Formula) -> Node {
    let mut numbers = Node::object([]);
    for n in fit.numbers {
        numbers.set(n.key, (n.number.get)(physics));
    }
    numbers
}

/// All keys of `physics`. Where the file's own `physics` has the name of a surface or a formula, the
/// value has this form too.
pub(super) fn write_as_given(physics: &Physics, own: &Node) -> Node {
    let mut node = physics.to_node();
    for quantity in QUANTITIES {
        let QuantityShape::Formula(fit) = &quantity.shape else { continue };
        let form = match own.get(quantity.group()).and_then(|group| group.get(quantity.key())) {
            Some(name @ Node::Text(_)) => name.clone(),
            Some(Node::Object(_)) => write_numbers(physics, fit),
            _ => continue,
        };
        if let Some(group) = node.get_mut(quantity.group()) {
            group.set(quantity.key(), form);
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

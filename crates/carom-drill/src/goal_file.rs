//! Goals and areas as plain values.

use carom::format::{Node, Reader};
use carom::table::PocketName;
use carom::{Error, ErrorKind};

use crate::area::{DrillArea, length};
use crate::goal::{CONDITIONS, DrillCondition, DrillGoal, RunOrder, Zone};

/// The most conditions and zones of a goal, cushions of a condition, balls of a list, and points of an attempt.
const MOST_NEEDS: usize = 12;
const MOST_CUSHIONS: i64 = 20;
const MOST_BALLS: usize = 32;
pub(crate) const MOST_POINTS: i64 = 1000;

impl DrillCondition {
    fn read(at: &Reader<'_>) -> Result<Self, Error> {
        let kind = at.require("kind", "\"pot\"")?;
        let word = kind.text("the kind of a condition")?;
        let keys = |more: &[&str]| at.keys(&[&["kind"], more].concat());
        let ball = || text(&at.require("ball", "\"1\"")?);
        let cushions =
            |least| at.require("cushions", "1")?.whole(least, MOST_CUSHIONS).map(|n| n as u32);
        let distance = || length(&at.require("distance", "0.3")?);
        match word {
            "pot" => {
                keys(&["ball", "pocket"])?;
                let pocket = at.get("pocket").map(|pocket| pocket_of(&pocket)).transpose()?;
                Ok(Self::Pot(ball()?, pocket))
            }
            "pot-any" => keys(&[]).map(|()| Self::PotAny),
            "kick" => keys(&["cushions"]).and_then(|()| cushions(1)).map(Self::Kick),
            "carom" => keys(&["cushions"]).and_then(|()| cushions(0)).map(Self::Carom),
            "cushions" => {
                keys(&["ball", "cushions"])?;
                Ok(Self::Cushions(ball()?, cushions(1)?))
            }
            "first" => keys(&["ball"]).and_then(|()| ball()).map(Self::First),
            "avoid" => keys(&["ball"]).and_then(|()| ball()).map(Self::Avoid),
            "hidden" => keys(&["ball"]).and_then(|()| ball()).map(Self::Hidden),
            "next" => keys(&["ball"]).and_then(|()| ball()).map(Self::Next),
            "touch" => keys(&["balls"]).and_then(|()| balls(at)).map(Self::Touch),
            "stop" => {
                keys(&["ball", "area"])?;
                let ball = at.get("ball").map(|ball| text(&ball)).transpose()?;
                Ok(Self::Stop(ball, DrillArea::required(at)?))
            }
            "apart" => {
                keys(&["balls", "distance"])?;
                let pair: [String; 2] = balls(at)?.try_into().map_err(|_| {
                    let list = at.require("balls", "[\"1\", \"2\"]");
                    list.map_or_else(
                        |e| e,
                        |list| {
                            list.refuse(
                                ErrorKind::WrongCount,
                                "it does not name two balls",
                                "name two",
                            )
                        },
                    )
                })?;
                Ok(Self::Apart(pair, distance()?))
            }
            "gather" => keys(&["distance"]).and_then(|()| distance()).map(Self::Gather),
            _ => Err(kind.unknown_word(word, "condition", &CONDITIONS)),
        }
    }

    /// The plain values.
    pub fn to_node(&self) -> Node {
        let mut node = Node::object([("kind", self.kind().into())]);
        match self {
            Self::Pot(ball, pocket) => {
                node.set("ball", ball);
                if let Some(pocket) = pocket {
                    node.set("pocket", pocket.name());
                }
            }
            Self::PotAny => {}
            Self::First(ball) | Self::Avoid(ball) | Self::Hidden(ball) | Self::Next(ball) => {
                node.set("ball", ball);
            }
            Self::Kick(cushions) | Self::Carom(cushions) => node.set("cushions", *cushions),
            Self::Cushions(ball, cushions) => {
                node.set("ball", ball);
                node.set("cushions", *cushions);
            }
            Self::Touch(balls) => node.set("balls", Node::list(balls)),
            Self::Stop(ball, area) => {
                if let Some(ball) = ball {
                    node.set("ball", ball);
                }
                node.set("area", area.to_node());
            }
            Self::Apart(balls, distance) => {
                node.set("balls", Node::list(balls));
                node.set("distance", *distance);
            }
            Self::Gather(distance) => node.set("distance", *distance),
        }
        node
    }
}

impl DrillGoal {
    /// The goal with these plain values.
    ///
    /// # Errors
    /// [`Error::Input`] with the place of what is wrong.
    pub fn read(at: &Reader<'_>) -> Result<Self, Error> {
        let kind = at.require("kind", "\"shot\"")?;
        match kind.text("\"shot\" or \"run\"")? {
            "shot" => {
                at.keys(&["kind", "needs", "points", "zones"])?;
                let needs = read_needs(&at.require("needs", "[{\"kind\": \"pot-any\"}]")?)?;
                let points =
                    at.get("points").map_or(Ok(1), |points| points.whole(1, MOST_POINTS))?;
                let zones = at.get("zones").map_or(Ok(Vec::new()), |zones| {
                    few(&zones)?.iter().map(read_zone).collect::<Result<Vec<_>, _>>()
                })?;
                if needs.is_empty() && zones.is_empty() {
                    let remedy = "name what the shot must do, such as {\"kind\": \"pot-any\"}";
                    return Err(at.refuse(ErrorKind::Missing, "the goal is empty", remedy));
                }
                Ok(Self::Shot { needs, points: points as u32, zones })
            }
            "run" => {
                at.keys(&["kind", "balls", "order"])?;
                let order = at.require("order", "\"rotation\"")?;
                let word = order.text("the order of a run")?;
                let known = RunOrder::ALL.map(RunOrder::name);
                let order = RunOrder::ALL.into_iter().find(|one| one.name() == word);
                let order = order.ok_or_else(|| at.unknown_word(word, "order", &known))?;
                Ok(Self::Run { balls: balls(at)?, order })
            }
            other => Err(kind.unknown_word(other, "goal", &["shot", "run"])),
        }
    }

    /// The plain values.
    pub fn to_node(&self) -> Node {
        match self {
            Self::Shot { needs, points, zones } => {
                let needs = Node::list(needs.iter().map(DrillCondition::to_node));
                let mut node = Node::object([("kind", "shot".into()), ("needs", needs)]);
                if *points != 1 {
                    node.set("points", *points);
                }
                if !zones.is_empty() {
                    let zone = |zone: &Zone| {
                        Node::object([
                            ("area", zone.area.to_node()),
                            ("points", zone.points.into()),
                        ])
                    };
                    node.set("zones", Node::list(zones.iter().map(zone)));
                }
                node
            }
            Self::Run { balls, order } => Node::object([
                ("kind", "run".into()),
                ("balls", Node::list(balls)),
                ("order", order.name().into()),
            ]),
        }
    }
}

/// The conditions of a goal.
pub(crate) fn read_needs(at: &Reader<'_>) -> Result<Vec<DrillCondition>, Error> {
    few(at)?.iter().map(DrillCondition::read).collect()
}

fn read_zone(at: &Reader<'_>) -> Result<Zone, Error> {
    at.keys(&["area", "points"])?;
    let area = DrillArea::required(at)?;
    let points = at.require("points", "1")?.whole(1, MOST_POINTS)? as u32;
    Ok(Zone { area, points })
}

fn few<'a>(at: &Reader<'a>) -> Result<Vec<Reader<'a>>, Error> {
    bounded(at, MOST_NEEDS)
}

/// The items of a list with at most `most`.
pub(crate) fn bounded<'a>(at: &Reader<'a>, most: usize) -> Result<Vec<Reader<'a>>, Error> {
    let items = at.items("a list")?;
    if items.len() > most {
        let what = format!("the list has {} items", items.len());
        return Err(at.refuse(ErrorKind::WrongCount, what, format!("write at most {most}")));
    }
    Ok(items)
}

fn balls(at: &Reader<'_>) -> Result<Vec<String>, Error> {
    let list = at.require("balls", "[\"1\", \"2\"]")?;
    let balls = bounded(&list, MOST_BALLS)?.iter().map(text).collect::<Result<Vec<_>, _>>()?;
    if balls.is_empty() {
        return Err(list.refuse(ErrorKind::Missing, "the list is empty", "name a ball"));
    }
    Ok(balls)
}

fn text(at: &Reader<'_>) -> Result<String, Error> {
    at.text("the id of a ball").map(String::from)
}

pub(crate) fn pocket_of(at: &Reader<'_>) -> Result<PocketName, Error> {
    let word = at.text("the name of a pocket")?;
    let found = PocketName::ALL.into_iter().find(|pocket| pocket.name() == word);
    found.ok_or_else(|| at.unknown_word(word, "pocket", &PocketName::ALL.map(PocketName::name)))
}

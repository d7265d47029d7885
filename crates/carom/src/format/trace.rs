//! `carom-trace/1`: a trace as a tree of values and as JSON, read and written without losing a bit.
//!
//! The reader ignores unknown keys, which a newer engine may have written. It checks the known
//! ones, and that the events have the hash that the trace states.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::dated::with_dated_names;
use super::node::Node;
use super::read::{At, Fields};
use super::shot::ShotFile;
use crate::error::{Error, ErrorKind};
use crate::math::Vec3;
use crate::range::Range;
use crate::shot::{PlacedBall, Shot};
use crate::table::{Part, PocketName, Rail};
use crate::trace::{Log, Trace, TraceEnd};
use crate::trace_event::{TraceEvent, TraceEventKind};
use crate::{BallState, MotionState};

/// The value of `format` in a trace.
pub const TRACE_FORMAT: &str = "carom-trace/1";

const TIME: Range = Range::closed(0.0, f64::MAX, " s");
/// Any finite number: a trace has results.
const RESULT: Range = Range::closed(f64::MIN, f64::MAX, "");

const RAILS: [Rail; 8] = [
    Rail::Bottom,
    Rail::Top,
    Rail::Left,
    Rail::Right,
    Rail::LeftLower,
    Rail::LeftUpper,
    Rail::RightLower,
    Rail::RightUpper,
];

const PARTS: [Part; 5] = [Part::Nose, Part::Facing, Part::Point, Part::Top, Part::Liner];

const POCKETS: [PocketName; 6] = [
    PocketName::BottomLeft,
    PocketName::BottomRight,
    PocketName::Left,
    PocketName::Right,
    PocketName::TopLeft,
    PocketName::TopRight,
];

impl Trace {
    /// The trace as a tree of values, with the shot file as it is written from the shot's data.
    pub fn to_node(&self) -> Node {
        self.to_node_with(self.shot().to_node())
    }

    /// The trace as a tree of values, with `shot` as its shot file: the tree of the [`ShotFile`]
    /// that was simulated. Presets get their dated names ([`crate::edition`]).
    pub fn to_node_with(&self, shot: Node) -> Node {
        let balls = self.shot().balls();
        Node::object([
            ("format", TRACE_FORMAT.into()),
            ("engine", self.engine().into()),
            ("shot", with_dated_names(&shot)),
            ("duration", self.duration().into()),
            ("end", self.end().name().into()),
            ("events", Node::list(self.events().map(|e| self.write_event(&e)))),
            ("final", Node::list(balls.iter().zip(self.last()).map(|(b, s)| write_ball(b, s)))),
            ("outcome", self.outcome().to_node(self.shot())),
            ("hash", format!("{:016x}", self.hash()).into()),
        ])
    }

    /// The trace as JSON; [`Self::from_json`] reads it back to the same bits.
    pub fn to_json(&self) -> String {
        self.to_node().to_json()
    }

    /// Reads a saved trace.
    ///
    /// # Errors
    /// [`Error::Input`] that names the place, as for a shot file.
    #[cfg(feature = "json")]
    pub fn from_json(text: &str) -> Result<Self, Error> {
        Self::from_node(&Node::from_json(text)?)
    }

    /// Reads a trace from a tree of values. The outcome is computed from the events, so that a
    /// trace of an older engine gets the keys of this one.
    ///
    /// # Errors
    /// [`Error::Input`] that names the place, as for a shot file.
    pub fn from_node(node: &Node) -> Result<Self, Error> {
        Self::from_node_with_file(node).map(|(trace, _)| trace)
    }

    /// [`Self::from_node`], and also the shot file that the trace has.
    ///
    /// # Errors
    /// As [`Self::from_node`].
    pub fn from_node_with_file(node: &Node) -> Result<(Self, ShotFile), Error> {
        let fields = At::root(node).known_fields()?;
        fields.require("format", &format!("\"{TRACE_FORMAT}\""))?.format(TRACE_FORMAT)?;
        let at = fields.require("shot", "the shot file that the trace was made from")?;
        let file = ShotFile::from_node(at.node().clone()).map_err(|e| e.inside("shot"))?;
        let shot = file.shot().clone();
        let engine = fields.require("engine", "the engine's name and version")?;
        let engine = String::from(engine.text("the engine's name and version")?);
        let duration = fields.require("duration", "the duration in s")?.number(&TIME)?;
        let mut log = Log::default();
        for at in fields.require("events", "a list of events")?.items("a list of events")? {
            read_event(&at, &shot, &mut log)?;
        }
        let at = fields.require("final", "a list of balls")?;
        let last = read_final(&at, &shot)?;
        let end = read_end(&fields, &shot, &last)?;
        let trace = Self::assemble(shot, engine, duration, end, log, last);
        check_hash(&fields, &trace)?;
        Ok((trace, file))
    }
}

fn check_hash(fields: &Fields<'_>, trace: &Trace) -> Result<(), Error> {
    let at = fields.require("hash", "16 hexadecimal digits")?;
    let written = at.text("16 hexadecimal digits")?;
    let ours = format!("{:016x}", trace.hash());
    if written == ours {
        return Ok(());
    }
    Err(at.refuse(
        ErrorKind::Changed,
        format!("the events and final states hash to {ours}, not to \"{written}\""),
        "the trace was changed after it was written: simulate its shot again",
    ))
}

/// What ended the shot. Traces of earlier versions do not have it.
fn read_end(fields: &Fields<'_>, shot: &Shot, last: &[BallState]) -> Result<TraceEnd, Error> {
    let usual = TraceEnd::of(shot, last);
    let Some(at) = fields.get("end") else { return Ok(usual) };
    let end = at.choice("end", &TraceEnd::ALL.map(|end| (end.name(), end)))?;
    if end == usual || end == TraceEnd::Cap {
        return Ok(end);
    }
    Err(at.refuse(
        ErrorKind::Changed,
        format!(
            "found \"{}\", but the shot and the final states say \"{}\"",
            end.name(),
            usual.name()
        ),
        "the trace was changed after it was written: simulate its shot again",
    ))
}

impl Trace {
    fn write_event(&self, event: &TraceEvent<'_>) -> Node {
        let of = |i: &u16| &self.shot().balls()[usize::from(*i)];
        let states = |states: &[BallState]| {
            Node::list(event.balls.iter().zip(states).map(|(i, s)| write_ball(of(i), s)))
        };
        let mut node = Node::object([
            ("time", event.time.into()),
            ("type", event.kind.name().into()),
            ("balls", Node::list(event.balls.iter().map(|i| &of(i).id))),
        ]);
        match event.kind {
            TraceEventKind::RailCollision { rail, part } => {
                node.set("rail", rail.name());
                node.set("part", part.name());
            }
            TraceEventKind::PocketCollision(pocket) => node.set("pocket", pocket.name()),
            TraceEventKind::MotionTransition { from, to } => {
                node.set("from", from.name());
                node.set("to", to.name());
            }
            TraceEventKind::CueStrike { tip_contacts, pushed } => {
                node.set("tip_contacts", u32::from(tip_contacts));
                node.set("pushed", pushed);
            }
            TraceEventKind::BallCollision
            | TraceEventKind::SlateCollision
            | TraceEventKind::OffTable => {}
        }
        if event.is_impact() {
            let vectors = |list: Vec<Vec3>| Node::list(list.into_iter().map(Vec3::to_array));
            node.set("impulses", vectors(self.impulses(event)));
            node.set("points", vectors(self.contact_points(event)));
        }
        node.set("before", states(event.before));
        node.set("after", states(event.after));
        node
    }
}

fn write_ball(placed: &PlacedBall, state: &BallState) -> Node {
    Node::object([
        ("id", (&placed.id).into()),
        ("position", state.position.to_array().into()),
        ("velocity", state.velocity.to_array().into()),
        ("angular_velocity", state.angular_velocity.to_array().into()),
        ("motion", state.motion.name().into()),
    ])
}

fn read_event(at: &At<'_>, shot: &Shot, log: &mut Log) -> Result<(), Error> {
    let fields = at.known_fields()?;
    let time = fields.require("time", "the time in s")?.number(&TIME)?;
    let kind = read_kind(&fields)?;
    let mut balls = Vec::new();
    for at in fields.require("balls", "a list of ids")?.items("a list of ids")? {
        balls.push(read_id(&at, shot)?);
    }
    for (key, states) in [("before", &mut log.before), ("after", &mut log.after)] {
        let at = fields.require(key, "a list of balls")?;
        let items = at.items("a list of balls")?;
        if items.len() != balls.len() {
            return Err(at.refuse(
                ErrorKind::WrongCount,
                format!("found {} balls, but the event has {}", items.len(), balls.len()),
                "write one for each ball of the event",
            ));
        }
        for (item, &ball) in items.iter().zip(&balls) {
            states.push(read_ball(item, &shot.balls()[usize::from(ball)].id)?);
        }
    }
    log.push(time, kind, &balls);
    Ok(())
}

fn read_kind(fields: &Fields<'_>) -> Result<TraceEventKind, Error> {
    let motion = |key| {
        let names = MotionState::ALL.map(|m| (m.name(), m));
        fields.require(key, "a motion state")?.choice("motion state", &names)
    };
    let at = fields.require("type", "the type of event")?;
    match at.text("the type of event")? {
        "cue-strike" => Ok(TraceEventKind::CueStrike {
            // Traces of earlier versions do not have these two.
            tip_contacts: fields.get("tip_contacts").map_or(Ok(1), |at| at.whole(1, u8::MAX))?,
            pushed: fields.get("pushed").map_or(Ok(false), |at| at.flag())?,
        }),
        "ball-collision" => Ok(TraceEventKind::BallCollision),
        "rail-collision" => {
            let rails = RAILS.map(|r| (r.name(), r));
            let parts = PARTS.map(|p| (p.name(), p));
            Ok(TraceEventKind::RailCollision {
                rail: fields.require("rail", "a rail")?.choice("rail", &rails)?,
                part: fields.require("part", "a part of a cushion")?.choice("part", &parts)?,
            })
        }
        "pocket-collision" => {
            let pockets = POCKETS.map(|p| (p.name(), p));
            let at = fields.require("pocket", "a pocket")?;
            Ok(TraceEventKind::PocketCollision(at.choice("pocket", &pockets)?))
        }
        "slate-collision" => Ok(TraceEventKind::SlateCollision),
        "off-table" => Ok(TraceEventKind::OffTable),
        "motion-transition" => {
            Ok(TraceEventKind::MotionTransition { from: motion("from")?, to: motion("to")? })
        }
        other => Err(at.unknown_word(
            other,
            "type of event",
            &[
                "cue-strike",
                "ball-collision",
                "rail-collision",
                "pocket-collision",
                "slate-collision",
                "off-table",
                "motion-transition",
            ],
        )),
    }
}

fn read_id(at: &At<'_>, shot: &Shot) -> Result<u16, Error> {
    let id = at.text("a ball's id")?;
    shot.ball_index(id).and_then(|i| u16::try_from(i).ok()).ok_or_else(|| {
        at.refuse(
            ErrorKind::UnknownBall,
            format!("no ball has the id \"{id}\""),
            "write the id of one of shot.balls",
        )
        .with("ball", id)
    })
}

fn read_final(at: &At<'_>, shot: &Shot) -> Result<Vec<BallState>, Error> {
    let items = at.items("a list of balls")?;
    if items.len() != shot.balls().len() {
        return Err(at.refuse(
            ErrorKind::WrongCount,
            format!("found {} balls, but the shot has {}", items.len(), shot.balls().len()),
            "write one for each ball of the shot, in its order",
        ));
    }
    items.iter().zip(shot.balls()).map(|(item, placed)| read_ball(item, &placed.id)).collect()
}

fn read_ball(at: &At<'_>, id: &str) -> Result<BallState, Error> {
    let fields = at.known_fields()?;
    let at_id = fields.require("id", "the ball's id")?;
    let written = at_id.text("the ball's id")?;
    if written != id {
        let what = format!("found the id \"{written}\" in the place of ball \"{id}\"");
        return Err(at_id.refuse(ErrorKind::Mismatch, what, format!("write \"{id}\"")));
    }
    let vector = |key| {
        let v = fields.require(key, "three numbers")?.numbers_in(3, 3, &RESULT)?;
        Ok(Vec3::new(v[0], v[1], v[2]))
    };
    let motions = MotionState::ALL.map(|m| (m.name(), m));
    Ok(BallState {
        position: vector("position")?,
        velocity: vector("velocity")?,
        angular_velocity: vector("angular_velocity")?,
        motion: fields.require("motion", "a motion state")?.choice("motion state", &motions)?,
    })
}

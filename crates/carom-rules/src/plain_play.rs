//! Plays as trees of values, in the form of records and of [`Frame::answer_schema`].

use carom::format::{Node, Reader};
use carom::math::radians;
use carom::resolve::cue_ball::Strike;
use carom::shot::{Policy, StrikePolicy};
use carom::{Error, ErrorKind};

use crate::frame::Frame;
use crate::layout::BallIndex;
use crate::play::{Call, Play};

impl Frame {
    /// Reads a play: its strike, the place of a cue ball in hand, and its call. Without an elevation
    /// it gets the default one. Other keys are passed over.
    ///
    /// # Errors
    /// [`Error::Input`] with the place, for a value that is missing or has a wrong type, and as
    /// [`Self::at_default_elevation`].
    pub fn read_play(&self, at: &Reader<'_>) -> Result<Play, Error> {
        let strike = at.require("strike", "\"strike\": {\"speed\": 2.0, \"azimuth_deg\": 90.0}")?;
        let speed = strike.require("speed", "the cue's speed in m/s")?.number()?;
        let azimuth = read_angle(&strike, "azimuth", "azimuth_deg")?;
        let azimuth = azimuth.ok_or_else(|| {
            let remedy = "write the cue's direction in degrees, or `azimuth` in radians";
            ErrorKind::Missing.at("strike.azimuth_deg", "the key is missing", remedy)
        })?;
        let elevation = read_angle(&strike, "elevation", "elevation_deg")?;
        let offset = |key| strike.get(key).map_or(Ok(0.0), |value| value.number());
        let strike = Strike {
            speed,
            azimuth,
            elevation: elevation.unwrap_or(0.0),
            side: offset("side")?,
            height: offset("height")?,
        };
        let cue_ball = at.get("cue_ball").map(|place| read_place(&place)).transpose()?;
        let call = at.get("call").map_or(Ok(Call::Nothing), |call| read_call(self, &call))?;
        let play = Play { cue_ball, call, ..Play::new(strike) };
        if elevation.is_some() { Ok(play) } else { self.at_default_elevation(&play) }
    }

    /// A play with all numbers of its strike, as a record keeps it. Policies and cling are left out
    /// where they are the usual ones.
    pub fn play_node(&self, play: &Play) -> Node {
        let Play { strike: s, cue_ball, call, policy, cling } = play;
        let numbers = [
            ("speed", s.speed),
            ("azimuth", s.azimuth),
            ("elevation", s.elevation),
            ("side", s.side),
            ("height", s.height),
        ];
        let mut strike = Node::object(numbers.map(|(key, x)| (key, Node::from(x))));
        let StrikePolicy { obstruction, miscue } = StrikePolicy::default();
        for (key, policy, usual) in
            [("obstruction", policy.obstruction, obstruction), ("miscue", policy.miscue, miscue)]
        {
            if policy != usual {
                strike.set(key, if policy == Policy::Refuse { "refuse" } else { "report" });
            }
        }
        let mut node = Node::object([("strike", strike)]);
        if let Some(place) = cue_ball {
            node.set("cue_ball", Node::list(*place));
        }
        if let Some(call) = self.call_node(*call) {
            node.set("call", call);
        }
        if !cling.is_empty() {
            node.set("cling", cling.to_node());
        }
        node
    }

    /// A call in the form of [`Self::answer_schema`]; `None` if nothing is called.
    pub fn call_node(&self, call: Call) -> Option<Node> {
        let kind = |kind: &str| ("kind", Node::from(kind));
        // A player may have called a ball that the frame does not have.
        let ball = |ball: BallIndex| {
            let known = self.layout().balls().get(usize::from(ball));
            ("ball", Node::from(known.map(|known| known.id.clone())))
        };
        Some(match call {
            Call::Nothing => return None,
            Call::Safety => Node::object([kind("safety")]),
            Call::PushOut => Node::object([kind("push-out")]),
            Call::On(on) => Node::object([kind("on"), ball(on)]),
            Call::Pocket(called, pocket) => {
                Node::object([kind("pocket"), ball(called), ("into", pocket.name().into())])
            }
        })
    }
}

/// An angle, rad, in radians or in degrees; `None` if neither key is there.
fn read_angle(at: &Reader<'_>, rad: &str, deg: &str) -> Result<Option<f64>, Error> {
    match (at.get(rad), at.get(deg)) {
        (Some(one), Some(_)) => {
            let what = format!("{deg} gives the same angle");
            let remedy = format!("keep {rad} (rad) or {deg} (degrees)");
            Err(one.refuse(ErrorKind::Duplicate, what, remedy))
        }
        (Some(angle), None) => angle.number().map(Some),
        (None, Some(angle)) => angle.number().map(|angle| Some(radians(angle))),
        (None, None) => Ok(None),
    }
}

fn read_place(at: &Reader<'_>) -> Result<[f64; 2], Error> {
    const WANTED: &str = "a list of two numbers, x and y in m";
    match at.items(WANTED)?.as_slice() {
        [x, y] => Ok([x.number()?, y.number()?]),
        _ => Err(at.wrong_type(WANTED)),
    }
}

/// A call. Records of matches name the pocket `pocket`, so this key is read too.
fn read_call(frame: &Frame, at: &Reader<'_>) -> Result<Call, Error> {
    let kind = at.require("kind", "\"kind\": \"pocket\"")?.text("the kind of the call")?;
    // Python writes null for the parts that a call does not have.
    let text = |key: &str| {
        let value = at.get(key).filter(|value| *value.node() != Node::Null);
        value.map(|value| value.text("a name")).transpose()
    };
    let into = text("into")?.or(text("pocket")?);
    frame.call(kind, text("ball")?, into)
}

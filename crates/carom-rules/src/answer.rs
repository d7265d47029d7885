//! JSON Schemas of answers to a frame's requests, for programs that write JSON.
//!
//! An answer has the form of a move in a record (`carom-frame/1`): `{"play": {"strike": …}}`,
//! `{"choice": …}` or `{"concede": true}`.

use carom::format::{Node, schema};

use crate::frame::Frame;
use crate::layout::BallIndex;
use crate::request::{Request, Turn};

/// The draft of JSON Schema.
const DRAFT: &str = "https://json-schema.org/draft/2020-12/schema";

/// The JSON Schema of a play in any frame: the strike, the place of a cue ball in hand, and the call.
pub fn play_schema() -> Node {
    let text = || Node::object([("type", "string".into())]);
    let kinds = ["nothing", "pocket", "safety", "push-out", "on"];
    let into =
        Node::object([("enum", Node::list(carom::table::PocketName::ALL.map(|p| p.name())))]);
    let call =
        [("kind", Node::object([("enum", Node::list(kinds))])), ("ball", text()), ("into", into)];
    let mut play = play(object(&["kind"], Node::object(call)), Some(place(None)), &["strike"]);
    play.set("$schema", DRAFT);
    play.set("title", "A play");
    play
}

impl Frame {
    /// The JSON Schema of an answer to the present request: only the choices, calls, balls and pockets
    /// that the frame allows, and the box around the region of a cue ball in hand. A play that follows
    /// it may still be refused: for a place of the cue ball within the box and not in the region or on
    /// another ball, and for a strike beyond the miscue limit.
    pub fn answer_schema(&self) -> Node {
        let concede = ("concede", Node::object([("const", true.into())]));
        let answers = match self.request() {
            Request::Shot(turn) => Node::object([("play", self.play_schema(turn)), concede]),
            Request::Choice { choices, .. } => {
                let names = Node::list(choices.iter().map(|choice| choice.name()));
                Node::object([("choice", Node::object([("enum", names)])), concede])
            }
            Request::Over { .. } => Node::object([]),
        };
        let mut answer = object(&[], answers);
        for bound in ["minProperties", "maxProperties"] {
            answer.set(bound, 1_i64);
        }
        answer.set("$schema", DRAFT);
        answer
    }

    fn play_schema(&self, turn: &Turn) -> Node {
        let mut required = vec!["strike"];
        if turn.calls.required || turn.calls.nominate {
            required.push("call");
        }
        if turn.hand.is_some() && self.layout().is_down(turn.cue) {
            required.push("cue_ball");
        }
        let place = self.hand_bounds().map(|bounds| place(Some(bounds)));
        play(self.call_schema(turn), place, &required)
    }

    /// The calls that this shot allows.
    fn call_schema(&self, turn: &Turn) -> Node {
        let of_ball = |balls: &[BallIndex]| Node::object([("enum", self.ids(balls))]);
        let object_balls: Vec<_> =
            self.layout().on_table().filter(|ball| *ball != turn.cue).collect();
        let pockets = self.base().table().pockets.iter().map(|pocket| pocket.name.name());
        let into = Node::object([("enum", Node::list(pockets))]);
        let calls = turn.calls.names().map(|kind| {
            let mut fields = Node::object([("kind", Node::object([("const", kind.into())]))]);
            match kind {
                "pocket" => {
                    fields.set("ball", of_ball(&object_balls));
                    fields.set("into", into.clone());
                    object(&["kind", "ball", "into"], fields)
                }
                "on" => {
                    fields.set("ball", of_ball(&turn.on));
                    object(&["kind", "ball"], fields)
                }
                _ => object(&["kind"], fields),
            }
        });
        Node::object([("anyOf", Node::list(calls))])
    }
}

/// A play with this schema of its call, and of the place of the cue ball where there is one.
fn play(call: Node, place: Option<Node>, required: &[&str]) -> Node {
    let mut fields = Node::object([("strike", strike())]);
    if let Some(place) = place {
        fields.set("cue_ball", place);
    }
    fields.set("call", call);
    object(required, fields)
}

/// The strike of a shot file, without the key of the struck ball.
fn strike() -> Node {
    let file = Node::from_json(schema::SHOT).unwrap_or(Node::Null);
    let mut strike =
        file.get("$defs").and_then(|defs| defs.get("strike")).cloned().unwrap_or(Node::Null);
    let mut fields = strike.get("properties").cloned().unwrap_or(Node::Null);
    fields.remove("ball");
    strike.set("properties", fields);
    strike.set("description", "The strike of the cue ball.");
    strike.set("required", Node::list(["speed"]));
    strike
}

/// Where a cue ball in hand is placed (x and y, m), within a box.
fn place(bounds: Option<[[f64; 2]; 2]>) -> Node {
    let coordinate = |axis: usize| {
        let mut number = Node::object([("type", "number".into())]);
        if let Some([least, most]) = bounds {
            number.set("minimum", least[axis]);
            number.set("maximum", most[axis]);
        }
        number
    };
    Node::object([
        ("type", "array".into()),
        ("description", "Centre of a cue ball in hand (x, y), m.".into()),
        ("prefixItems", Node::list([0, 1].map(coordinate))),
        ("minItems", 2_i64.into()),
        ("maxItems", 2_i64.into()),
    ])
}

/// An object without further keys.
fn object(required: &[&str], fields: Node) -> Node {
    Node::object([
        ("type", "object".into()),
        ("additionalProperties", false.into()),
        ("properties", fields),
        ("required", Node::list(required.iter().copied())),
    ])
}

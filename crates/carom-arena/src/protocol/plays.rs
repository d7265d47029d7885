//! Plays and calls in the form in which programs read and write them.

use carom::format::Node;
use carom_rules::{BallIndex, Call, Frame, Play};

use crate::record::{place, strike};

/// A play as a program may answer it.
pub(crate) fn play_node(frame: &Frame, play: &Play) -> Node {
    let mut node = Node::object([("strike", strike(&play.strike))]);
    if let Some(at) = play.cue_ball {
        node.set("cue_ball", place(at));
    }
    if let Some(call) = call_node(frame, play.call) {
        node.set("call", call);
    }
    node
}

/// A call in the form of `frame.answer_schema()`; `None` if nothing is called.
pub(super) fn call_node(frame: &Frame, call: Call) -> Option<Node> {
    let id = |ball: BallIndex| {
        let known = frame.layout().balls().get(usize::from(ball));
        Node::from(known.map(|known| known.id.clone()))
    };
    let kind = |kind: &str| ("kind", Node::from(kind));
    Some(match call {
        Call::Nothing => return None,
        Call::Safety => Node::object([kind("safety")]),
        Call::PushOut => Node::object([kind("push-out")]),
        Call::On(ball) => Node::object([kind("on"), ("ball", id(ball))]),
        Call::Pocket(ball, pocket) => {
            Node::object([kind("pocket"), ("ball", id(ball)), ("into", pocket.name().into())])
        }
    })
}

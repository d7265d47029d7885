//! Plays in the form in which programs read and write them.

use carom::format::Node;
use carom_rules::{Frame, Play};

use crate::record::{place, strike};

/// A play as a program may answer it.
pub(crate) fn play_node(frame: &Frame, play: &Play) -> Node {
    let mut node = Node::object([("strike", strike(&play.strike))]);
    if let Some(at) = play.cue_ball {
        node.set("cue_ball", place(at));
    }
    if let Some(call) = frame.call_node(play.call) {
        node.set("call", call);
    }
    node
}

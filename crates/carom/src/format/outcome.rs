//! The `outcome` of a trace.

use alloc::vec::Vec;

use super::node::Node;
use crate::math::degrees;
use crate::outcome::{Outcome, Touched};
use crate::shot::Shot;
use crate::table::{PocketName, Rail};

impl Outcome {
    /// The outcome as it is written in a trace: with the balls' ids, and with the miscue and the
    /// obstruction of `shot`'s strike.
    pub fn to_node(&self, shot: &Shot) -> Node {
        let balls = shot.balls();
        let id = |i: u16| Node::from(&balls[usize::from(i)].id);
        let ids = |list: &[u16]| Node::list(list.iter().map(|&i| id(i)));
        let touched = |t: &Touched| match *t {
            Touched::Ball(i) => Node::object([("ball", id(i))]),
            Touched::Rail(rail) => Node::object([("rail", rail.name().into())]),
        };
        let name = |t: &Touched| match *t {
            Touched::Ball(i) => id(i),
            Touched::Rail(rail) => rail.name().into(),
        };
        let mut after = Vec::new();
        for (i, ball) in balls.iter().enumerate() {
            let mine =
                |(b, rail): &(u16, Rail)| (usize::from(*b) == i).then(|| Node::from(rail.name()));
            let rails: Vec<Node> = self.rails_after_first_contact.iter().filter_map(mine).collect();
            if !rails.is_empty() {
                after.push((ball.id.clone(), Node::List(rails)));
            }
        }
        let in_pockets = |list: &[(u16, PocketName)]| {
            Node::list(list.iter().map(|&(i, p)| Node::List([id(i), p.name().into()].into())))
        };
        let jumped = self.jumped.iter().map(|&(i, j)| Node::List([id(i), id(j)].into()));
        Node::object([
            ("cue_ball", self.cue_ball.map(id).into()),
            ("first_contact", self.first_contact.map(id).into()),
            ("pocketed", in_pockets(&self.pocketed)),
            ("cue_ball_scratched", self.cue_ball_scratched().into()),
            ("off_table", ids(&self.off_table)),
            ("hanging", in_pockets(&self.hanging)),
            ("jumped", Node::list(jumped)),
            (
                "rails_before_first_contact",
                Node::list(self.rails_before_first_contact().map(Rail::name)),
            ),
            ("rails_after_first_contact", Node::Object(after)),
            ("driven_to_rail", ids(&self.driven_to_rail)),
            ("cue_ball_touched", Node::list(self.cue_ball_touched.iter().map(touched))),
            ("tip_contacts", u32::from(self.tip_contacts).into()),
            ("pushed", self.pushed.into()),
            ("met_during_strike", ids(&self.met_during_strike)),
            ("never_resting", ids(&self.never_resting)),
            ("miscue", shot.is_miscue().into()),
            ("cue_obstructed", shot.cue_obstruction().as_ref().map(name).into()),
            ("least_elevation_deg", shot.least_elevation().map(degrees).into()),
            ("events", self.events.into()),
        ])
    }
}

//! A puzzle as plain values.

use carom::Shot;
use carom::format::Node;

use super::levels::{LEVELS, Way};
use super::make::Puzzle;

impl Puzzle {
    /// The plain values: `id`, `theme`, `rating`, `shot` (a shot file), `goal` (as in a drill file), `chances` by
    /// level, and the `ways`, each with its `strike` and its `chances`.
    pub fn to_node(&self) -> Node {
        Node::object([
            ("id", self.id().into()),
            ("theme", self.theme.name().into()),
            ("rating", self.rating.into()),
            ("shot", layout_node(&self.shot)),
            ("goal", self.goal.to_node()),
            ("chances", by_level(&self.chances)),
            ("ways", Node::list(self.ways.iter().map(Way::to_node))),
        ])
    }
}

impl Way {
    fn to_node(&self) -> Node {
        let s = &self.strike;
        let strike = [
            ("speed", s.speed),
            ("azimuth", s.azimuth),
            ("elevation", s.elevation),
            ("side", s.side),
            ("height", s.height),
        ];
        let strike = Node::object(strike.map(|(key, number)| (key, number.into())));
        Node::object([("strike", strike), ("chances", by_level(&self.chances))])
    }
}

/// The shot file without the elevation, which follows from the aim.
pub(crate) fn layout_node(shot: &Shot) -> Node {
    let mut file = shot.to_node();
    if let Some(mut strike) = file.get("strike").cloned() {
        strike.remove("elevation_deg");
        file.set("strike", strike);
    }
    file
}

fn by_level(chances: &[f64; 5]) -> Node {
    Node::object(core::array::from_fn::<_, 5, _>(|level| (LEVELS[level], chances[level].into())))
}

//! A table's geometry as a tree of values, in the file's coordinates, for bindings and pictures.

use super::node::Node;
use super::table::{write_sights, write_spots};
use crate::math::Vec2;
use crate::table::{
    Capture, CushionPart, Dimension, Part, Pocket, Shape, Source, Table, TableDescription,
};

impl Table {
    /// Cushions, liners and pockets; for a table with rails also markings and dimensions. Lengths
    /// are in m, and the origin is the bottom left corner. `size` is null for unbounded cloth.
    pub fn to_node(&self) -> Node {
        let point = |p: Vec2| {
            let p = p + self.center();
            Node::from([p.x, p.y])
        };
        let size = if self.size.x.is_finite() {
            Node::from([self.size.x, self.size.y])
        } else {
            Node::Null
        };
        let parts = |is_listed: &dyn Fn(Part) -> bool| {
            let listed = self.cushions.iter().filter(|c| is_listed(c.part));
            Node::list(listed.map(|c| cushion(c, point)))
        };
        let mut node = Node::object([
            ("name", self.name.as_ref().into()),
            ("dated_name", self.name.as_deref().and_then(Table::dated_name).into()),
            ("size", size),
            ("cushion_height", self.cushion_height.into()),
            ("cushions", parts(&|part| !matches!(part, Part::Liner | Part::Top))),
            ("liners", parts(&|part| part == Part::Liner)),
            ("pockets", Node::list(self.pockets.iter().map(|p| pocket(p, point)))),
        ]);
        if let Some(description) = &self.description {
            add_drawing(&mut node, description);
            node.set("dimensions", Node::list(self.dimensions().iter().map(dimension)));
        }
        node
    }
}

fn dimension(dimension: &Dimension) -> Node {
    Node::object([
        ("key", (&dimension.key).into()),
        ("value", dimension.value.into()),
        ("unit", dimension.unit.into()),
        ("source", dimension.source.map(Source::text).into()),
    ])
}

fn cushion(part: &CushionPart, point: impl Fn(Vec2) -> Node) -> Node {
    let mut node =
        Node::object([("rail", part.rail.name().into()), ("part", part.part.name().into())]);
    match part.shape {
        Shape::Segment { start, end, .. } => {
            node.set("start", point(start));
            node.set("end", point(end));
        }
        Shape::Arc { center, radius, start, end }
        | Shape::Hollow { center, radius, start, end } => {
            node.set("start", point(center + start * radius));
            node.set("end", point(center + end * radius));
            node.set("center", point(center));
            node.set("radius", radius);
        }
        Shape::Plane { .. } => {}
    }
    node
}

fn pocket(pocket: &Pocket, point: impl Fn(Vec2) -> Node) -> Node {
    let mut node = Node::object([
        ("name", pocket.name.name().into()),
        ("center", point(pocket.center)),
        ("radius", pocket.radius.into()),
    ]);
    if let Capture::MouthLine { start, end } = pocket.capture {
        node.set("mouth", Node::list([point(start), point(end)]));
    }
    node
}

/// Adds the values that only pictures and racks need.
fn add_drawing(node: &mut Node, description: &TableDescription) {
    node.set("cushion_width", description.cushion_width);
    node.set("rail_width", description.rail_width);
    node.set("physics", &description.physics);
    if let Some(sights) = &description.sights {
        node.set("sights", write_sights(sights));
    }
    let markings = &description.markings;
    node.set(
        "markings",
        Node::object([
            ("head_string", markings.head_string.into()),
            ("d_radius", markings.d_radius.into()),
            ("spots", write_spots(&markings.spots)),
        ]),
    );
}

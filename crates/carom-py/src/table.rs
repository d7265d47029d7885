//! A table's geometry as a dict, in the file's frame.

use carom::Table;
use carom::math::Vec2;
use carom::shot::Node;
use carom::table::{
    Capture, CushionPart, Dimension, Part, Pocket, Shape, Source, Spot, TableDescription,
};

/// Dimensions, cushions, liners, pockets and markings, m; origin at the bottom left corner.
pub(crate) fn geometry(table: &Table) -> Node {
    let point = |p: Vec2| {
        let p = p + table.center();
        Node::from([p.x, p.y])
    };
    let size = if table.size.x.is_finite() {
        Node::from([table.size.x, table.size.y])
    } else {
        Node::Null
    };
    let parts = |which: &dyn Fn(Part) -> bool| {
        let those = table.cushions.iter().filter(|c| which(c.part));
        Node::list(those.map(|c| cushion(c, point)))
    };
    let mut node = Node::object([
        ("name", table.name.as_ref().into()),
        ("size", size),
        ("cushion_height", table.cushion_height.into()),
        ("cushions", parts(&|part| !matches!(part, Part::Liner | Part::Top))),
        ("liners", parts(&|part| part == Part::Liner)),
        ("pockets", Node::list(table.pockets.iter().map(|p| pocket(p, point)))),
    ]);
    if let Some(description) = &table.description {
        drawn(&mut node, description);
        let dimension = |d: &Dimension| {
            Node::object([
                ("key", (&d.key).into()),
                ("value", d.value.into()),
                ("unit", d.unit.into()),
                ("source", d.source.map(Source::text).into()),
            ])
        };
        node.set("dimensions", Node::List(table.dimensions().iter().map(dimension).collect()));
    }
    node
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

/// What only pictures and racks need.
fn drawn(node: &mut Node, description: &TableDescription) {
    node.set("cushion_width", description.cushion_width);
    node.set("rail_width", description.rail_width);
    node.set("physics", &description.physics);
    if let Some(sights) = &description.sights {
        node.set(
            "sights",
            Node::object([
                ("along_length", sights.along_length.into()),
                ("along_width", sights.along_width.into()),
                ("setback", sights.setback.into()),
            ]),
        );
    }
    let markings = &description.markings;
    let spot =
        |s: &Spot| Node::object([("name", (&s.name).into()), ("position", s.position.into())]);
    node.set(
        "markings",
        Node::object([
            ("head_string", markings.head_string.into()),
            ("d_radius", markings.d_radius.into()),
            ("spots", Node::list(markings.spots.iter().map(spot))),
        ]),
    );
}

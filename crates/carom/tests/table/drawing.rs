//! Drawings of every preset, from its parts alone: `target/tmp/table-<name>.svg`.

use std::fmt::Write;

use carom::Table;
use carom::math::Vec2;
use carom::table::{PRESETS, Part, Shape};

/// Millimetres, the unit of the drawing.
const MM: f64 = 1000.0;

/// The two ends of a part; for a rail's top, the ends of its mitre.
fn ends(shape: &Shape) -> [Vec2; 2] {
    match *shape {
        Shape::Segment { start, end, .. } => [start, end],
        Shape::Plane { corners: [a, .., d] } => [a, d],
        Shape::Arc { center, radius, start, end }
        | Shape::Hollow { center, radius, start, end } => {
            [center + start * radius, center + end * radius]
        }
    }
}

fn draw(table: &Table) -> String {
    let description = table.description.as_ref().unwrap();
    let frame = description.rail_width;
    let (w, h) = (table.size.x + 2.0 * frame, table.size.y + 2.0 * frame);
    // SVG's y points down.
    let at = |p: Vec2| ((p.x + 0.5 * w) * MM, (0.5 * h - p.y) * MM);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#5b3a21\"/>\n",
        w * MM,
        h * MM
    );
    let (x, y) = at(Vec2::new(-0.5 * table.size.x, 0.5 * table.size.y));
    let (width, height) = (table.size.x * MM, table.size.y * MM);
    let _ = writeln!(
        svg,
        "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" fill=\"#2a7f62\"/>"
    );
    for pocket in &table.pockets {
        let mouth: Vec<String> =
            [pocket.mouth[0], pocket.mouth[1], pocket.throat[1], pocket.throat[0]]
                .map(|p| format!("{},{}", at(p).0, at(p).1))
                .into();
        let (x, y) = at(pocket.center);
        let _ = writeln!(svg, "<polygon points=\"{}\" fill=\"#2a7f62\"/>", mouth.join(" "));
        let _ = writeln!(svg, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{}\"/>", pocket.radius * MM);
    }
    for cushion in &table.cushions {
        let [a, b] = ends(&cushion.shape).map(at);
        let color = match cushion.part {
            Part::Nose => "#ffffff",
            Part::Facing => "#ffd23f",
            Part::Point => "#ff3b3b",
            Part::Top | Part::Liner => "#888888",
        };
        let _ = match cushion.shape {
            Shape::Segment { .. } | Shape::Plane { .. } => writeln!(
                svg,
                "<path d=\"M{} {}L{} {}\" stroke=\"{color}\" stroke-width=\"3\"/>",
                a.0, a.1, b.0, b.1
            ),
            Shape::Arc { radius, start, end, .. } | Shape::Hollow { radius, start, end, .. } => {
                writeln!(
                    svg,
                    "<path d=\"M{} {}A{r} {r} 0 0 {} {} {}\" stroke=\"{color}\" stroke-width=\"3\" \
                 fill=\"none\"/>",
                    a.0,
                    a.1,
                    u8::from(start.cross(end) < 0.0),
                    b.0,
                    b.1,
                    r = radius * MM
                )
            }
        };
    }
    for spot in &description.markings.spots {
        let (x, y) = at(Vec2::new(spot.position[0], spot.position[1]) - table.center());
        let _ = writeln!(svg, "<circle cx=\"{x}\" cy=\"{y}\" r=\"5\" fill=\"#000\"/>");
    }
    for sight in table.sight_positions() {
        let (x, y) = at(sight);
        let _ = writeln!(svg, "<circle cx=\"{x}\" cy=\"{y}\" r=\"7\" fill=\"#fff\"/>");
    }
    svg.push_str("</svg>\n");
    svg
}

#[test]
fn every_preset_is_drawn_with_each_of_its_parts() {
    for name in PRESETS {
        let table = Table::preset(name).unwrap();
        let svg = draw(&table);
        assert_eq!(svg.matches("<path").count(), table.cushions.len(), "{name}");
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{name}");
        let file = format!("{}/table-{name}.svg", env!("CARGO_TARGET_TMPDIR"));
        std::fs::write(&file, svg).unwrap();
    }
}

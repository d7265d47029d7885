//! Every preset has the figures of its sources.

use std::fmt::Write;

use carom::Table;
use carom::math::Vec2;
use carom::table::{CushionPart, PRESETS, Part, Pocket, Shape, TableDescription};
use serde_json::Value;

/// Tolerance between two descriptions of one geometry, m: ten thousand roundings.
const SAME_POINT: f64 = 1e-12;

fn point(value: &Value, center: Vec2) -> Vec2 {
    Vec2::new(value[0].as_f64().unwrap(), value[1].as_f64().unwrap()) - center
}

fn near(a: Vec2, b: Vec2) -> bool {
    (a - b).length() <= SAME_POINT
}

#[test]
fn showood_7ft_has_the_segments_arcs_and_holes_of_the_published_table() {
    let data: Value = serde_json::from_str(include_str!("../data/showood_7ft.json")).unwrap();
    let table = Table::preset("showood-7ft").unwrap();
    let center = table.center();
    assert_eq!(table.cushion_height, data["cushion_height"].as_f64().unwrap());

    let segments: Vec<_> = table
        .cushions
        .iter()
        .filter(|c| c.part != Part::Liner)
        .filter_map(|c| match c.shape {
            Shape::Segment { start, end, .. } => Some([start, end]),
            _ => None,
        })
        .collect();
    let theirs = data["segments"].as_array().unwrap();
    assert_eq!(segments.len(), theirs.len());
    for segment in theirs {
        let (a, b) = (point(&segment[0], center), point(&segment[1], center));
        let found =
            |[s, e]: &[Vec2; 2]| (near(*s, a) && near(*e, b)) || (near(*s, b) && near(*e, a));
        assert_eq!(segments.iter().filter(|s| found(s)).count(), 1, "{a:?} {b:?}");
    }

    let arcs: Vec<_> = table
        .cushions
        .iter()
        .filter_map(|c| match c.shape {
            Shape::Arc { center, radius, .. } if radius > 0.0 => Some((center, radius)),
            _ => None,
        })
        .collect();
    let theirs = data["arcs"].as_array().unwrap();
    assert_eq!(arcs.len(), theirs.len());
    for arc in theirs {
        let c = point(&arc["center"], center);
        let r = arc["radius"].as_f64().unwrap();
        let found = |&&(p, radius): &&(Vec2, f64)| near(p, c) && radius == r;
        assert_eq!(arcs.iter().filter(found).count(), 1, "{arc}");
    }

    let theirs = data["pockets"].as_array().unwrap();
    assert_eq!(table.pockets.len(), theirs.len());
    for (pocket, theirs) in table.pockets.iter().zip(theirs) {
        assert!(near(pocket.center, point(&theirs["center"], center)), "{theirs}");
        assert_eq!(pocket.radius, theirs["radius"].as_f64().unwrap());
    }
}

/// Unit vector from a facing's start to its deep end.
fn direction(start: Vec2, end: Vec2) -> Vec2 {
    (end - start) * (1.0 / (end - start).length())
}

/// The figures of a rule book for a pocket, measured on its parts.
#[derive(Debug)]
struct Measured {
    /// Tip to tip, m.
    mouth: f64,
    /// Cut angle, inside the rubber, rad.
    cut_angles: [f64; 2],
    /// From the mouth to the hole's edge, m.
    shelf: f64,
}

/// Every pocket's figures, in the order of the pockets.
fn measure(table: &Table) -> Vec<Measured> {
    // Within each rail: facing, point …, nose, point …, facing.
    let mut jaws = Vec::new();
    for (i, nose) in table.cushions.iter().enumerate().filter(|(_, c)| c.part == Part::Nose) {
        let before = table.cushions[..i].iter().rev().find(|c| c.part == Part::Facing);
        let after = table.cushions[i..].iter().find(|c| c.part == Part::Facing);
        let Shape::Segment { start: a, end: b, normal } = nose.shape else { unreachable!() };
        for (facing, along) in
            [(before.unwrap(), direction(b, a)), (after.unwrap(), direction(a, b))]
        {
            assert_eq!(facing.rail, nose.rail);
            let Shape::Segment { start, end, .. } = facing.shape else { unreachable!() };
            let down = direction(start, end);
            // The intersection of the two lines.
            let tip = start + down * (normal.dot(a - start) / normal.dot(down));
            jaws.push((tip, carom::math::acos(-along.dot(down))));
        }
    }
    let near = |pocket: &Pocket| {
        let mut tips = jaws.clone();
        tips.sort_by(|a, b| {
            let d = |j: &(Vec2, f64)| (j.0 - pocket.center).length();
            d(a).total_cmp(&d(b))
        });
        [tips[0], tips[1]]
    };
    table
        .pockets
        .iter()
        .map(|pocket| {
            let [a, b] = near(pocket);
            let middle = (a.0 + b.0) * 0.5;
            Measured {
                mouth: (a.0 - b.0).length(),
                cut_angles: [a.1, b.1],
                shelf: (pocket.center - middle).length() - pocket.radius,
            }
        })
        .collect()
}

const INCH: f64 = 0.0254;

/// Whether `value` is within the limits of a rule, up to rounding.
fn within(value: f64, low: f64, high: f64) -> bool {
    (low - SAME_POINT..=high + SAME_POINT).contains(&value)
}

#[test]
fn the_wpa_tables_keep_the_wpa_equipment_specifications() {
    let degrees = carom::math::radians;
    for (name, length, width, sight) in
        [("wpa-9ft", 100.0, 50.0, 12.5), ("wpa-8ft", 92.0, 46.0, 11.5)]
    {
        let table = Table::preset(name).unwrap();
        assert!(within(table.size.y, (length - 0.125) * INCH, (length + 0.125) * INCH));
        assert!(within(table.size.x, (width - 0.125) * INCH, (width + 0.125) * INCH));
        let ball = 2.25 * INCH;
        assert!(within(table.cushion_height, 0.625 * ball, 0.645 * ball));
        let description = table.description.as_ref().unwrap();
        assert!(within(description.cushion_width, 1.875 * INCH, 2.0 * INCH));
        assert!(within(description.rail_width, 4.0 * INCH, 7.5 * INCH));
        for (pocket, measured) in table.pockets.iter().zip(measure(&table)) {
            let corner = pocket.axis.y != 0.0;
            let (mouth, cut, shelf) = if corner {
                ([4.5, 4.625], [141.0, 143.0], [1.0, 2.25])
            } else {
                ([5.0, 5.125], [103.0, 105.0], [0.0, 0.375])
            };
            let name = pocket.name.name();
            assert!(
                within(measured.mouth, mouth[0] * INCH, mouth[1] * INCH),
                "{name} {measured:?}"
            );
            assert!(
                within(measured.shelf, shelf[0] * INCH, shelf[1] * INCH),
                "{name} {measured:?}"
            );
            for angle in measured.cut_angles {
                assert!(within(angle, degrees(cut[0]), degrees(cut[1])), "{name} {measured:?}");
            }
        }
        let sights = table.sight_positions();
        assert_eq!(sights.len(), 18);
        for p in &sights {
            let behind = (p.x.abs() - 0.5 * table.size.x).max(p.y.abs() - 0.5 * table.size.y);
            assert!(within(behind, (3.6875 - 0.125) * INCH, (3.6875 + 0.125) * INCH));
            // Neighbouring sights, and pockets between them, are one interval apart.
            let along = if p.x.abs() > 0.5 * table.size.x { p.y } else { p.x };
            let intervals = along / (sight * INCH);
            assert!((intervals - intervals.round()).abs() <= 1e-9, "{p:?}");
        }
        let head_string = description.markings.head_string.unwrap();
        assert!((head_string - 0.25 * table.size.y).abs() <= SAME_POINT);
    }
}

#[test]
fn the_snooker_table_keeps_the_wpbsa_rules_and_the_published_pockets() {
    let table = Table::preset("snooker-12ft").unwrap();
    assert!(within(table.size.y, 3.569 - 0.013, 3.569 + 0.013));
    assert!(within(table.size.x, 1.778 - 0.013, 1.778 + 0.013));
    assert!((table.cushion_height - 7.0 * 0.02625 / 5.0).abs() <= SAME_POINT);
    let markings = &table.description.as_ref().unwrap().markings;
    assert_eq!(markings.head_string, Some(0.737));
    assert_eq!(markings.d_radius, Some(0.292));
    let spot = |name: &str| markings.spots.iter().find(|s| s.name == name).unwrap().position;
    assert!((table.size.y - spot("black")[1] - 0.324).abs() <= SAME_POINT);
    assert_eq!(spot("blue"), [0.5 * table.size.x, 0.5 * table.size.y]);
    assert_eq!(spot("pink")[1], 0.5 * (spot("blue")[1] + table.size.y));
    assert!(spot("yellow")[0] > spot("green")[0]);
    assert!((spot("yellow")[0] - spot("brown")[0] - 0.292).abs() <= SAME_POINT);

    let corner = &table.pockets[0];
    let from_corner = corner.center + table.center();
    assert!((from_corner.length() - 0.06735).abs() <= SAME_POINT && corner.radius == 0.0889);
    let [a, b] = corner.mouth;
    assert!(((a - b).length() - 0.08014).abs() <= SAME_POINT);
    let side = &table.pockets[2];
    assert!((side.center.x + 0.5 * table.size.x + 0.05159).abs() <= SAME_POINT);
    assert_eq!((side.center.y, side.radius), (0.0, 0.05319));
    let [a, b] = side.mouth;
    assert!(((a - b).length() - 0.08457).abs() <= SAME_POINT);
    let radii: Vec<f64> = table
        .cushions
        .iter()
        .filter_map(|c| if let Shape::Arc { radius, .. } = c.shape { Some(radius) } else { None })
        .collect();
    assert_eq!(radii.iter().filter(|r| **r == 0.0889).count(), 8);
    assert_eq!(radii.iter().filter(|r| **r == 0.0669).count(), 4);
}

#[test]
fn the_carom_table_keeps_the_umb_rules() {
    let table = Table::preset("carom-10ft").unwrap();
    assert!(within(table.size.y, 2.835, 2.845) && within(table.size.x, 1.415, 1.425));
    assert!(within(table.cushion_height, 0.036, 0.038));
    let description = table.description.as_ref().unwrap();
    assert!(within(description.rail_width - description.cushion_width, 0.115, 0.135));
    assert!(table.pockets.is_empty());
    let sights = table.sight_positions();
    let eighth = table.size.y / 8.0;
    assert_eq!(sights.len(), 2 * 3 + 2 * 7);
    for p in sights {
        let along = if p.x.abs() > 0.5 * table.size.x { p.y } else { p.x };
        assert!((along / eighth - (along / eighth).round()).abs() <= 1e-9, "{p:?}");
    }
}

#[test]
fn the_english_table_keeps_the_wepf_limits_and_pockets_of_1_6_balls() {
    let table = Table::preset("english-7ft").unwrap();
    assert!(within(table.size.y, 72.0 * INCH, 84.0 * INCH));
    assert!(within(table.size.x, 36.0 * INCH, 42.0 * INCH));
    for pocket in &table.pockets {
        let [a, b] = pocket.mouth;
        let mouth = (a - b).length();
        assert!(within(mouth, (3.2 - 0.125) * INCH, (3.2 + 0.125) * INCH), "{mouth}");
    }
    let baulk = table.description.as_ref().unwrap().markings.head_string.unwrap();
    assert!((baulk - 0.2 * table.size.y).abs() <= SAME_POINT);
}

#[test]
fn the_chinese_table_keeps_its_rules_and_has_the_jaws_of_snooker_in_proportion() {
    let table = Table::preset("chinese-9ft").unwrap();
    assert_eq!((table.size.y, table.size.x), (2.54, 1.27));
    let markings = &table.description.as_ref().unwrap().markings;
    assert_eq!(markings.head_string, Some(0.45));
    let foot = markings.spots.iter().find(|spot| spot.name == "foot").unwrap();
    assert!((table.size.y - foot.position[1] - 0.635).abs() <= SAME_POINT);
    // Mouths of 1.4 to 1.6 balls: narrower than on tables of pool, where they have two.
    for pocket in &table.pockets {
        let [a, b] = pocket.mouth;
        let balls = (a - b).length() / (2.25 * INCH);
        assert!(within(balls, 1.4, 1.6), "{balls}");
    }
    let snooker = Table::preset("snooker-12ft").unwrap();
    let radii = |table: &Table| -> Vec<f64> {
        let jaws = table.cushions.iter().filter(|part| is_cushion(part));
        jaws.filter_map(|part| {
            if let Shape::Arc { radius, .. } = part.shape { Some(radius) } else { None }
        })
        .collect()
    };
    let (own, of_snooker) = (radii(&table), radii(&snooker));
    assert_eq!(own.len(), of_snooker.len());
    for (own, other) in own.iter().zip(of_snooker) {
        assert!((own / (2.25 * INCH) - other / 0.0525).abs() < 1e-9, "{own} {other}");
    }
}

/// Whether a part is made of rubber.
fn is_cushion(part: &CushionPart) -> bool {
    !matches!(part.part, Part::Liner | Part::Top)
}

/// Start and end of a part, with the outward normals there.
fn ends(shape: &Shape) -> [(Vec2, Vec2); 2] {
    match *shape {
        Shape::Segment { start, end, normal } => [(start, normal), (end, normal)],
        Shape::Arc { center, radius, start, end } => {
            [(center + start * radius, start), (center + end * radius, end)]
        }
        Shape::Hollow { center, radius, start, end } => {
            [(center + start * radius, -start), (center + end * radius, -end)]
        }
        Shape::Plane { corners: [a, b, c, d] } => [(a, d - a), (b, c - b)],
    }
}

#[test]
fn within_every_rail_the_parts_join_without_gap_or_corner() {
    for name in PRESETS {
        let table = Table::preset(name).unwrap();
        let edges: Vec<_> = table.cushions.iter().filter(|c| is_cushion(c)).collect();
        for pair in edges.windows(2).filter(|p| p[0].rail == p[1].rail) {
            let joined = ends(&pair[0].shape).iter().any(|(p, n)| {
                ends(&pair[1].shape).iter().any(|(q, m)| near(*p, *q) && near(*n, *m))
            });
            assert!(joined, "{name}: {pair:?}");
        }
    }
}

#[test]
fn every_preset_has_mirrored_parts_with_mirrored_bits() {
    for name in PRESETS {
        let table = Table::preset(name).unwrap();
        for signs in [[-1.0, 1.0], [1.0, -1.0]] {
            let by = |p: Vec2| Vec2::new(p.x * signs[0], p.y * signs[1]);
            for cushion in &table.cushions {
                let [(a, n), (b, m)] = ends(&cushion.shape).map(|(p, n)| (by(p), by(n)));
                let same = |c: &&CushionPart| {
                    let [p, q] = ends(&c.shape);
                    c.part == cushion.part
                        && ([p, q] == [(a, n), (b, m)] || [q, p] == [(a, n), (b, m)])
                };
                assert_eq!(table.cushions.iter().filter(same).count(), 1, "{name}: {cushion:?}");
            }
            for pocket in &table.pockets {
                let same = |p: &&Pocket| p.center == by(pocket.center) && p.axis == by(pocket.axis);
                assert_eq!(table.pockets.iter().filter(same).count(), 1, "{name}");
            }
        }
    }
}

#[test]
fn the_order_of_rails_and_pockets_is_the_documented_one() {
    let table = Table::preset("wpa-9ft").unwrap();
    let of_rails = table.cushions.iter().filter(|c| is_cushion(c));
    let mut rails: Vec<&str> = of_rails.map(|c| c.rail.name()).collect();
    rails.dedup();
    let around = ["bottom", "right-lower", "right-upper", "top", "left-upper", "left-lower"];
    assert_eq!(rails, around);
    let bottom: Vec<&str> = table.cushions[..5].iter().map(|c| c.part.name()).collect();
    assert_eq!(bottom, ["facing", "point", "nose", "point", "facing"]);
    for (pocket, (name, x, y)) in table.pockets.iter().zip([
        ("bottom-left", -1.0, -1.0),
        ("bottom-right", 1.0, -1.0),
        ("left", -1.0, 0.0),
        ("right", 1.0, 0.0),
        ("top-left", -1.0, 1.0),
        ("top-right", 1.0, 1.0),
    ]) {
        assert_eq!(pocket.name.name(), name);
        let at = (
            pocket.center.x.signum(),
            if y == 0.0 { pocket.center.y } else { pocket.center.y.signum() },
        );
        assert_eq!(at, (x, y), "{name}");
    }
    let plain = Table::from_description(&TableDescription::rectangle(1.0, 2.0)).unwrap();
    let rails: Vec<&str> = plain.parts_on_cloth().iter().map(|c| c.rail.name()).collect();
    assert_eq!(rails, ["bottom", "right", "top", "left"]);
}

#[test]
fn every_dimension_of_every_preset_has_a_source() {
    for name in PRESETS {
        for dimension in Table::preset(name).unwrap().dimensions() {
            let source = dimension.source.map(|s| s.text()).unwrap_or_default();
            assert!(!source.is_empty(), "{name}: {}", dimension.key);
        }
    }
}

#[test]
fn the_page_on_tables_lists_every_dimension_of_every_preset() {
    let mut page = String::new();
    for name in PRESETS {
        let _ = writeln!(page, "\n## `{name}`\n\n| key | value | source |\n|---|---|---|");
        for d in Table::preset(name).unwrap().dimensions() {
            let value = match d.unit {
                "m" => format!("{:.2} mm", d.value * 1000.0),
                unit => format!("{:.2} {unit}", d.value),
            };
            let source = d.source.map(|s| s.text()).unwrap_or_default();
            let _ = writeln!(page, "| `{}` | {value} | {source} |", d.key);
        }
    }
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/tables.md");
    let committed = std::fs::read_to_string(file).unwrap();
    let fresh = format!("{}/tables.md", env!("CARGO_TARGET_TMPDIR"));
    std::fs::write(&fresh, &page).unwrap();
    assert!(
        committed.ends_with(&page),
        "docs/tables.md does not end as {fresh} says: copy it there"
    );
}

#[test]
fn an_impossible_description_is_refused_with_its_key() {
    let wpa = TableDescription::preset("wpa-9ft").unwrap();
    let refused = |change: &dyn Fn(&mut TableDescription)| {
        let mut description = wpa.clone();
        change(&mut description);
        Table::from_description(&description).unwrap_err().to_string()
    };
    fn corner(d: &mut TableDescription) -> &mut carom::table::PocketDescription {
        d.corner_pocket.as_mut().unwrap()
    }
    fn side(d: &mut TableDescription) -> &mut carom::table::PocketDescription {
        d.side_pocket.as_mut().unwrap()
    }
    let small_with_large_holes = |d: &mut TableDescription| {
        (d.width, d.length) = (0.5, 0.5);
        corner(d).hole_radius = 0.2;
        (side(d).hole_radius, side(d).cut_angle_deg) = (0.2, 90.0);
    };
    for (key, remedy, text) in [
        ("width", "above 0", refused(&|d| d.width = -1.0)),
        ("length", "above 0", refused(&|d| d.length = f64::NAN)),
        ("length", "finite", refused(&|d| d.length = f64::INFINITY)),
        ("cushion_height", "above 0", refused(&|d| d.cushion_height = 0.0)),
        ("cushion_width", "above 0", refused(&|d| d.cushion_width = 0.0)),
        ("rail_width", "at least", refused(&|d| d.rail_width = 0.01)),
        ("rail_width", "too narrow for the hole", refused(&|d| d.rail_width = 0.13)),
        ("corner_pocket", "describe it", refused(&|d| d.corner_pocket = None)),
        ("side_pocket", "describe it", refused(&|d| d.side_pocket = None)),
        ("corner_pocket.mouth", "above 0", refused(&|d| corner(d).mouth = 0.0)),
        ("corner_pocket.mouth", "widen", refused(&|d| corner(d).mouth = 0.01)),
        (
            "corner_pocket.mouth",
            "smaller",
            refused(&|d| {
                (corner(d).mouth, corner(d).shelf) = (1.0, 1.0);
            }),
        ),
        ("side_pocket.mouth", "smaller", refused(&|d| side(d).mouth = 2.4)),
        ("corner_pocket.cut_angle_deg", "below 180", refused(&|d| corner(d).cut_angle_deg = 180.0)),
        ("side_pocket.cut_angle_deg", "at least 90", refused(&|d| side(d).cut_angle_deg = 80.0)),
        ("side_pocket.point_radius", "0 (sharp)", refused(&|d| side(d).point_radius = -1.0)),
        ("side_pocket.shelf", "at least", refused(&|d| side(d).shelf = -0.5)),
        ("side_pocket.hole_radius", "smaller", refused(&small_with_large_holes)),
        ("corner_pocket.hole_radius", "nothing closes", refused(&|d| corner(d).hole_radius = 0.04)),
        (
            "corner_pocket.hole_radius",
            "in front of the facings' deep ends",
            refused(&|d| {
                (d.cushion_width, d.rail_width) = (0.2, 0.25);
                corner(d).cut_angle_deg = 135.0;
            }),
        ),
        ("side_pocket.cut_angle_deg", "meet before", refused(&|d| side(d).cut_angle_deg = 120.0)),
        ("corner_pocket.throat", "above 0", refused(&|d| corner(d).throat = Some(-0.1))),
    ] {
        assert!(text.starts_with(&format!("{key}: ")), "{key}: {text}");
        assert!(text.contains(remedy), "{remedy}: {text}");
    }
}

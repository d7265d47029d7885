//! Every preset, held to the figures that it was made from.

use carom::Table;
use carom::math::Vec2;
use carom::table::{PRESETS, Part, Shape};
use serde_json::Value;

/// Two descriptions of one geometry agree to this, m: ten thousand roundings.
const SAME_POINT: f64 = 1e-12;

fn point(value: &Value, center: Vec2) -> Vec2 {
    Vec2::new(value[0].as_f64().unwrap(), value[1].as_f64().unwrap()) - center
}

fn near(a: Vec2, b: Vec2) -> bool {
    (a - b).length() <= SAME_POINT
}

#[test]
fn showood_7ft_has_the_segments_arcs_and_holes_of_the_published_table() {
    let data: Value = serde_json::from_str(include_str!("data/showood_7ft.json")).unwrap();
    let table = Table::preset("showood-7ft").unwrap();
    let center = table.center();
    assert_eq!(table.cushion_height, data["cushion_height"].as_f64().unwrap());

    let segments: Vec<_> = table
        .cushions
        .iter()
        .filter_map(|c| match c.shape {
            Shape::Segment { start, end, .. } => Some([start, end]),
            Shape::Arc { .. } => None,
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

#[test]
fn every_preset_makes_a_table_whose_parts_follow_each_other_around_it() {
    for name in PRESETS {
        let table = Table::preset(name).unwrap_or_else(|| panic!("{name}"));
        assert_eq!(table.name.as_deref(), Some(name));
        let with_pockets = !table.pockets.is_empty();
        let noses = table.cushions.iter().filter(|c| c.part == Part::Nose).count();
        assert_eq!(noses, if with_pockets { 6 } else { 4 }, "{name}");
        assert!(matches!(table.pockets.len(), 0 | 6), "{name}");
    }
}

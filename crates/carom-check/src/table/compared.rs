//! The judge's tables and the engine's have the same edges, although they are constructed in
//! different ways.

use carom::Table;
use carom::math::Vec2;
use carom::table::{Capture, PRESETS, Part, Shape, TableDescription};

use super::{EdgeKind, EdgeLine, TablePlan};
use crate::random::Random;

/// Largest distance of two points that are the same up to rounding, m.
const SAME: f64 = 1e-12;

/// Random tables to compare.
const TABLES: usize = 2000;

/// Least share of them that must be possible tables.
const POSSIBLE: usize = TABLES / 4;

fn apart(ours: &[Vec2], theirs: &[Vec2]) -> f64 {
    let each = ours.iter().zip(theirs).map(|(p, q)| (*p - *q).length());
    each.fold(0.0, f64::max)
}

/// The largest distance between the points of two edges, m or in unit vectors; infinite for edges
/// of different kinds.
fn difference(ours: &EdgeLine, theirs: &Shape) -> f64 {
    match (*ours, *theirs) {
        (
            EdgeLine::Straight { start, end, normal },
            Shape::Segment { start: a, end: b, normal: n },
        ) => apart(&[start, end, normal], &[a, b, n]),
        (
            EdgeLine::Round { center, radius, from, to },
            Shape::Arc { center: c, radius: r, start, end },
        )
        | (
            EdgeLine::Wall { center, radius, from, to },
            Shape::Hollow { center: c, radius: r, start, end },
        ) => apart(&[center, from, to], &[c, start, end]).max((radius - r).abs()),
        (EdgeLine::Flat, Shape::Plane { .. }) => 0.0,
        _ => f64::INFINITY,
    }
}

fn same_kind(ours: EdgeKind, theirs: Part) -> bool {
    matches!(
        (ours, theirs),
        (EdgeKind::Nose, Part::Nose)
            | (EdgeKind::Point, Part::Point)
            | (EdgeKind::Facing, Part::Facing)
            | (EdgeKind::Liner, Part::Liner)
            | (EdgeKind::Top, Part::Top)
    )
}

/// The first difference between the engine's table and the judge's, if there is one.
fn first_difference(table: &Table) -> Option<String> {
    let plan = TablePlan::of(table);
    if plan.parts.len() != table.cushions.len() || plan.pockets.len() != table.pockets.len() {
        return Some(format!("{} parts, not {}", plan.parts.len(), table.cushions.len()));
    }
    for (k, ((rail, kind, line), theirs)) in plan.parts.iter().zip(&table.cushions).enumerate() {
        let off = difference(line, &theirs.shape);
        let same = *rail == theirs.rail.name() && same_kind(*kind, theirs.part);
        if !same || off > SAME || off.is_nan() {
            return Some(format!("part {k}: {rail} {kind:?} {line:?} is {off:e} off {theirs:?}"));
        }
    }
    for (ours, theirs) in plan.pockets.iter().zip(&table.pockets) {
        let off = apart(&[ours.center, ours.axis], &[theirs.center, theirs.axis]);
        let tips = apart(&ours.mouth, &theirs.mouth)
            .min(apart(&ours.mouth, &[theirs.mouth[1], theirs.mouth[0]]));
        let at_line = matches!(theirs.capture, Capture::MouthLine { .. });
        let same = ours.name == theirs.name.name() && at_line == plan.has_mouth_lines;
        let wrong = off.max(tips).max((ours.radius - theirs.radius).abs());
        if !same || wrong > SAME || wrong.is_nan() {
            return Some(format!("{ours:?} is {wrong:e} off {theirs:?}"));
        }
    }
    let size = (table.size - plan.half * 2.0).length();
    let height = (table.cushion_height - plan.height).abs();
    (size > SAME || height > SAME).then(|| format!("size {size:e}, height {height:e}"))
}

/// A preset with other dimensions, which may be impossible.
fn drawn(random: &mut Random) -> TableDescription {
    let name = PRESETS[random.below(PRESETS.len())];
    let mut drawn = TableDescription::preset(name).expect("a preset");
    let mut scale = |value: f64, most: f64| value * (1.0 + random.between(-most, most));
    drawn.width = scale(drawn.width, 0.3);
    drawn.length = scale(drawn.length, 0.3);
    drawn.cushion_height = scale(drawn.cushion_height, 0.1);
    drawn.cushion_width = scale(drawn.cushion_width, 0.2);
    drawn.rail_width *= 2.0;
    for pocket in [&mut drawn.corner_pocket, &mut drawn.side_pocket].into_iter().flatten() {
        pocket.mouth = scale(pocket.mouth, 0.1);
        pocket.cut_angle_deg = scale(pocket.cut_angle_deg, 0.05).max(90.0);
        pocket.shelf = scale(pocket.shelf, 0.3);
        pocket.hole_radius = scale(pocket.hole_radius, 0.1);
        pocket.point_radius = scale(pocket.point_radius, 1.0);
        pocket.throat = pocket.throat.map(|throat| scale(throat, 0.05));
    }
    for pocket in [&mut drawn.corner_pocket, &mut drawn.side_pocket].into_iter().flatten() {
        // A throat narrower or wider than the cut angle gives.
        if random.below(4) == 0 {
            pocket.throat = Some(pocket.mouth * random.between(0.7, 1.0));
        }
    }
    drawn
}

#[test]
fn the_presets_have_the_same_edges() {
    for name in PRESETS {
        let table = Table::preset(name).expect("a preset");
        assert_eq!(first_difference(&table), None, "{name}");
    }
    assert_eq!(first_difference(&Table::unbounded()).as_deref(), None);
}

#[test]
fn random_tables_have_the_same_edges() {
    let mut random = Random::new(5);
    let mut possible = 0;
    for _ in 0..TABLES {
        let description = drawn(&mut random);
        let Ok(table) = Table::from_description(&description) else { continue };
        possible += 1;
        assert_eq!(first_difference(&table), None, "{description:?}");
    }
    assert!(possible >= POSSIBLE, "{possible} possible tables");
}

/// Each change is one that an error in the engine's construction could make.
#[test]
fn detects_an_edge_of_the_engine_that_is_out_of_place() {
    let falsified = |change: fn(&mut Table)| {
        let mut table = Table::preset("wpa-9ft").expect("a preset");
        change(&mut table);
        first_difference(&table)
    };
    let moved = |shape: &mut Shape| match shape {
        Shape::Segment { end, .. } => end.x += 1e-11,
        Shape::Arc { center, .. } | Shape::Hollow { center, .. } => center.y += 1e-11,
        Shape::Plane { .. } => {}
    };
    let parts = Table::preset("wpa-9ft").expect("a preset").geometry.cushions;
    for (k, part) in parts.iter().enumerate().filter(|(_, part)| part.part != Part::Top) {
        let mut table = Table::preset("wpa-9ft").expect("a preset");
        moved(&mut table.cushions[k].shape);
        assert!(first_difference(&table).is_some(), "part {k}: {part:?}");
    }
    assert!(falsified(|t| t.cushions.swap(0, 2)).is_some());
    assert!(falsified(|t| t.pockets[3].center.x += 1e-11).is_some());
    assert!(falsified(|t| t.pockets[2].radius += 1e-11).is_some());
    assert!(falsified(|t| t.cushion_height += 1e-11).is_some());
    assert!(falsified(|t| t.size.x += 1e-11).is_some());
}

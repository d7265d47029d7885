//! The positions that a ball may have, compared with distances to the drawn curves.

use crate::oracle::{Dice, clearance, distance_to_pocket, first_violation};
use carom::Table;
use carom::math::Vec2;
use carom::table::{
    Capture, LIP_OVERHANG, PRESETS, Part, Placement, PocketModel, TOUCH_TOLERANCE,
    TableDescription, nose_reach,
};
use carom_roots::Motion;

const POOL_BALL: f64 = 0.028575;
/// Tolerance of depths, m.
const SAME_DEPTH: f64 = 1e-12;

fn tables() -> Vec<(String, Table)> {
    let mut all = Vec::new();
    for name in PRESETS {
        let description = TableDescription::preset(name).unwrap();
        let lines = TableDescription { pocket_model: PocketModel::MouthLine, ..description };
        all.push((name.to_string(), Table::preset(name).unwrap()));
        all.push((format!("{name} with mouth lines"), Table::from_description(&lines).unwrap()));
    }
    all
}

#[test]
fn in_front_of_the_noses_the_depth_in_a_cushion_is_the_missing_distance() {
    for (name, table) in tables() {
        let (reach, half) = (table.reach(POOL_BALL), table.size * 0.5);
        let lines = table.pockets.iter().any(|p| p.capture != Capture::DropCircle);
        let mut dice = Dice(0x1A1D);
        let mut seen = [0; 3];
        for _ in 0..20_000 {
            // Most positions are near the edges, where balls touch something.
            let mut p = Vec2::new(dice.between(-half.x, half.x), dice.between(-half.y, half.y));
            if dice.unit() < 0.5 {
                p.x = half.x - dice.between(0.0, 2.0 * reach);
            } else {
                p.y = -half.y + dice.between(0.0, 2.0 * reach);
            }
            let (free, _) = clearance(&table, reach, p);
            let place = table.place_check(p, POOL_BALL);
            let way = distance_to_pocket(&table, p);
            // A ball may hang this far over a lip.
            let hangs = way >= -(LIP_OVERHANG * POOL_BALL + TOUCH_TOLERANCE) && !lines;
            if way < -TOUCH_TOLERANCE && !hangs {
                assert!(matches!(place, Placement::OverHole { .. }), "{name}: {p:?} {place:?}");
                seen[0] += 1;
            } else if free < -TOUCH_TOLERANCE {
                let Placement::InCushion { depth, .. } = place else {
                    panic!("{name}: {p:?} {place:?}, {free} free");
                };
                assert!((depth + free).abs() <= SAME_DEPTH, "{name}: {p:?} {depth} {free}");
                seen[1] += 1;
            } else if free > TOUCH_TOLERANCE {
                assert_eq!(place, Placement::Inside, "{name}: {p:?}");
                seen[2] += 1;
            }
        }
        assert!(seen[1] > 1000 && seen[2] > 1000, "{name}: {seen:?}");
    }
}

#[test]
fn behind_the_noses_a_ball_is_inside_where_it_can_roll_to_and_nowhere_else() {
    let with_holes = PRESETS.map(|name| (name, Table::preset(name).unwrap()));
    let has_holes = |t: &Table| t.pockets.iter().any(|p| p.capture == Capture::DropCircle);
    for (name, table) in with_holes.into_iter().filter(|(_, t)| has_holes(t)) {
        let reach = table.reach(POOL_BALL);
        let half = table.size * 0.5;
        let mut dice = Dice(0x9A7);
        let mut reached = 0;
        for _ in 0..20_000 {
            let pocket = &table.pockets[(dice.unit() * 6.0) as usize];
            let p = pocket.center + Vec2::new(dice.between(-0.15, 0.15), dice.between(-0.15, 0.15));
            if p.x.abs() <= half.x && p.y.abs() <= half.y {
                continue;
            }
            let inside = table.place_check(p, POOL_BALL).is_inside();
            // Straight from a point in front of the mouth, or first along the axis.
            let from = |way: f64| pocket.center - pocket.axis * way;
            let rolled = [0.2, 0.16, 0.12, 0.1, 0.09].iter().any(|&way| {
                let (start, v) = (from(way), p - from(way));
                let path = Motion { d: [start.x, start.y], v: [v.x, v.y], h: [0.0, 0.0] };
                first_violation(&table, reach, &path, 0.0, 1.0).is_none()
            });
            reached += usize::from(rolled);
            if rolled {
                assert!(inside, "{name}: {p:?} {:?}", table.place_check(p, POOL_BALL));
            } else if inside {
                // It may reach the point by a longer path: it overlaps nothing.
                assert!(clearance(&table, reach, p).0 >= -TOUCH_TOLERANCE, "{name}: {p:?}");
                assert!(distance_to_pocket(&table, p) >= -TOUCH_TOLERANCE, "{name}: {p:?}");
            }
        }
        assert!(reached > 10, "{name}: {reached}");
    }
}

#[test]
fn a_ball_frozen_to_a_rail_touches_it_and_a_nanometre_either_way_still_does() {
    for (name, table) in tables() {
        let x = 0.5 * table.size.x - table.reach(POOL_BALL);
        for (off, touches) in [(0.0, true), (0.9e-9, true), (-0.9e-9, true), (-1.1e-9, false)] {
            let place = table.place_check(Vec2::new(x + off, 0.3), POOL_BALL);
            match place {
                Placement::TouchesCushion { part } => {
                    assert!(touches, "{name}: {off:e}");
                    assert_eq!(table.cushions[usize::from(part)].part, Part::Nose);
                }
                _ => assert!(!touches && place == Placement::Inside, "{name}: {off:e} {place:?}"),
            }
        }
        let place = table.place_check(Vec2::new(x + 1.1e-9, 0.3), POOL_BALL);
        let Placement::InCushion { depth, .. } = place else { panic!("{name}: {place:?}") };
        assert!((depth - 1.1e-9).abs() <= 1e-15, "{name}: {depth:e}");
    }
}

#[test]
fn beyond_the_rails_and_at_nan_a_ball_is_outside() {
    for (name, table) in tables() {
        for p in [[5.0, 0.0], [0.0, -5.0], [0.0, f64::NAN], [f64::INFINITY, 0.0]] {
            let place = table.place_check(Vec2::new(p[0], p[1]), POOL_BALL);
            assert_eq!(place, Placement::Outside, "{name}: {p:?}");
        }
    }
}

#[test]
fn on_unbounded_cloth_every_position_is_inside() {
    for p in [[0.0, 0.0], [1e9, -1e9]] {
        let place = Table::unbounded().place_check(Vec2::new(p[0], p[1]), POOL_BALL);
        assert_eq!(place, Placement::Inside);
    }
}

#[test]
fn a_nose_below_the_cloth_or_above_the_ball_touches_no_ball() {
    assert_eq!(nose_reach(0.0, POOL_BALL), None);
    assert_eq!(nose_reach(2.0 * POOL_BALL, POOL_BALL), None);
    assert_eq!(nose_reach(-0.01, POOL_BALL), None);
    assert_eq!(nose_reach(POOL_BALL, POOL_BALL), Some(POOL_BALL));
    let reach = nose_reach(0.635 * 2.0 * POOL_BALL, POOL_BALL).unwrap();
    // cos of the angle whose sine is 0.27.
    assert!((reach / POOL_BALL - (1.0_f64 - 0.27 * 0.27).sqrt()).abs() <= 1e-15);
}

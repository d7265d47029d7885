//! The first feature that a flying ball meets, compared with a walk through a solid table.

use crate::meeting::{mirrored_feature, paths, tables};
use crate::oracle::Dice;
use crate::solid::Solid;
use carom::Table;
use carom::detect::ball_table;
use carom::detect::flight::first_meeting;
use carom::detect::rail_top::first_loss_of_support;
use carom::math::{Vec2, Vec3};
use carom::table::TableFeature;
use carom::table::{Capture, PRESETS, Part, Shape};
use carom_roots::Motion;

const POOL_BALL: f64 = 0.028575;
const GRAVITY: f64 = 9.80665;
/// Largest overlap and largest gap at a meeting, m: the rounding of a position, and of a time at 20
/// m/s.
const CONTACT_GAP: f64 = 1e-14;
/// Tolerance of a touched point, m.
const SAME_POINT: f64 = 1e-12;

fn flight(d: Vec3, v: Vec3) -> Motion<3> {
    Motion { d: d.to_array(), v: v.to_array(), h: [0.0, 0.0, -0.5 * GRAVITY] }
}

fn direction(dice: &mut Dice) -> Vec3 {
    let z = dice.between(-1.0, 1.0);
    (dice.direction() * carom::math::sqrt(1.0 - z * z)).with_z(z)
}

/// A flight from a random free position: over the bed, over the rails, or inside a pocket.
fn random_flight(dice: &mut Dice, solid: &Solid<'_>) -> Motion<3> {
    let Solid { table, radius, .. } = *solid;
    let rail = table.description.as_ref().unwrap().rail_width;
    let out = table.size * 0.5 + Vec2::new(rail, rail);
    loop {
        let p = if dice.unit() < 0.5 && !table.pockets.is_empty() {
            let pocket = &table.pockets[(dice.unit() * 6.0) as usize];
            let spread = dice.between(0.0, 0.2);
            pocket.center + dice.direction() * spread
        } else {
            Vec2::new(dice.between(-out.x, out.x), dice.between(-out.y, out.y))
        };
        let z = match (dice.unit() * 4.0) as u32 {
            0 => dice.between(-radius, radius),
            1 => radius,
            2 => dice.between(0.0, 0.15),
            _ => dice.between(0.0, 0.6),
        };
        let start = p.with_z(z);
        let is_gone = z < table.cushion_height + radius && is_beyond_a_line(table, p);
        if solid.is_within_border(p) && solid.clearance(start) >= 0.0 && !is_gone {
            let speed = carom::math::pow(10.0, dice.between(-2.0, 1.301));
            return flight(start, direction(dice) * speed);
        }
    }
}

/// Whether `p` is beyond a mouth line.
fn is_beyond_a_line(table: &Table, p: Vec2) -> bool {
    table.pockets.iter().any(|pocket| match pocket.capture {
        Capture::MouthLine { start, .. } => {
            pocket.axis.dot(p - start) >= 0.0 && pocket.axis.cross(p - start).abs() < 0.2
        }
        Capture::DropCircle => false,
    })
}

/// The gap at a meeting, or why the meeting is wrong.
fn judge(
    solid: &Solid<'_>,
    path: &Motion<3>,
    t: f64,
    feature: TableFeature,
) -> Result<f64, String> {
    let (table, radius) = (solid.table, solid.radius);
    let (p, v) = (Vec3::from(path.at(t)), Vec3::from(path.velocity_at(t)));
    let top = table.cushion_height + radius;
    match feature {
        TableFeature::Slate | TableFeature::Lip(_) | TableFeature::Cushion(_) => {
            let normal = table.contact_normal(feature, p, radius);
            if (normal.length() - 1.0).abs() > 1e-15 {
                return Err(format!("{normal:?} is not a unit vector"));
            }
            if v.dot(normal) <= 0.0 {
                return Err(format!("moves away by {}", v.dot(normal)));
            }
            // Along the normal there is only the ball between centre and feature.
            let touched = p + normal * radius;
            let at_touched = off_surface(table, feature, touched, p, radius);
            if at_touched > SAME_POINT {
                return Err(format!("{normal:?} misses the surface by {at_touched:e}"));
            }
            Ok(solid.gap(feature, p))
        }
        TableFeature::Depth(k) => {
            let pocket = &table.pockets[usize::from(k)];
            if (p.xy() - pocket.center).length() > pocket.radius {
                return Err("not in the hole".into());
            }
            Ok(if path.d[2] > 1e-12 { p.z } else { p.z + radius })
        }
        TableFeature::Pocket(k) => {
            let pocket = &table.pockets[usize::from(k)];
            let Capture::MouthLine { start, .. } = pocket.capture else {
                return Err("there is no mouth line that captures it".into());
            };
            let beyond = pocket.axis.dot(p.xy() - start);
            if p.z > top + CONTACT_GAP || beyond < -CONTACT_GAP {
                return Err(format!("{beyond:e} beyond the line at {}", p.z));
            }
            Ok(if beyond < (p.z - top).abs() { beyond } else { p.z - top })
        }
        TableFeature::Border => {
            let rail = table.description.as_ref().unwrap().rail_width;
            let x = p.x.abs() - 0.5 * table.size.x - rail;
            let y = p.y.abs() - 0.5 * table.size.y - rail;
            Ok(x.max(y))
        }
        TableFeature::Brink => Err("a flying ball has no support to lose".into()),
    }
}

/// Distance of `touched` from the surface of the feature, m. The rubber under an edge recedes, so
/// that the centre itself is on the edge line there.
fn off_surface(
    table: &Table,
    feature: TableFeature,
    touched: Vec3,
    center: Vec3,
    radius: f64,
) -> f64 {
    let height = table.cushion_height;
    let off_circle = |at: Vec2, ring: f64, p: Vec3| ((p.xy() - at).length() - ring).abs();
    match feature {
        TableFeature::Lip(k) => {
            let pocket = &table.pockets[usize::from(k)];
            off_circle(pocket.center, pocket.radius, touched).max(touched.z)
        }
        TableFeature::Cushion(part) => {
            let shape = &table.cushions[usize::from(part)].shape;
            let under = center.z < height - radius;
            let p = if under { center } else { touched };
            match *shape {
                Shape::Plane { .. } => (touched.z - height).abs(),
                Shape::Hollow { center: c, radius, .. } => {
                    off_circle(c, radius, touched).max(touched.z - height)
                }
                Shape::Segment { start, normal, .. } => {
                    let off = normal.dot(p.xy() - start).abs();
                    if under { off } else { off.max((p.z - height).abs()) }
                }
                Shape::Arc { center: c, radius, .. } => {
                    let off = off_circle(c, radius, p);
                    if under { off } else { off.max((p.z - height).abs()) }
                }
            }
        }
        _ => touched.z.abs(),
    }
}

#[test]
fn a_flight_ends_where_the_ball_first_touches_the_table_and_nowhere_before() {
    for (name, table, radius) in tables() {
        let solid = Solid::new(&table, radius);
        let mut dice = Dice(0xF117);
        let mut met = [0_usize; 10];
        let mut worst = 0.0_f64;
        for i in 0..paths() / 20 {
            let path = random_flight(&mut dice, &solid);
            let found = first_meeting(&table, radius, &path, f64::INFINITY);
            let Some((t, feature)) = found else { panic!("{name}, flight {i}: endless {path:?}") };
            if let Some(lost) = solid.first_violation(&path, t) {
                panic!("{name}, flight {i}: lost at {lost} before {found:?}: {path:?}");
            }
            let gap = judge(&solid, &path, t, feature)
                .unwrap_or_else(|why| panic!("{name}, flight {i}: {why} at {found:?}: {path:?}"));
            assert!(gap.abs() <= CONTACT_GAP, "{name}, flight {i}: {gap:e} at {found:?}: {path:?}");
            worst = worst.max(gap.abs());
            met[kind(&table, feature)] += 1;
        }
        println!(
            "{name}: nose, facing, point, top, liner, slate, lip, depth, edge, line {met:?}, {worst:e}"
        );
    }
}

fn kind(table: &Table, feature: TableFeature) -> usize {
    match feature {
        TableFeature::Cushion(i) => match table.cushions[usize::from(i)].part {
            Part::Nose => 0,
            Part::Facing => 1,
            Part::Point => 2,
            Part::Top => 3,
            Part::Liner => 4,
        },
        TableFeature::Slate => 5,
        TableFeature::Lip(_) => 6,
        TableFeature::Depth(_) => 7,
        TableFeature::Border => 8,
        _ => 9,
    }
}

#[test]
fn a_horizon_only_removes_later_meetings() {
    for (name, table, radius) in tables() {
        let solid = Solid::new(&table, radius);
        let mut dice = Dice(0xA110);
        for i in 0..paths() / 100 {
            let path = random_flight(&mut dice, &solid);
            let (t, feature) = first_meeting(&table, radius, &path, f64::INFINITY).unwrap();
            let before = first_meeting(&table, radius, &path, t * (1.0 - 1e-9));
            assert!(t == 0.0 || before.is_none(), "{name}, flight {i}: {before:?}, not {t}");
            let Some((again, _)) = first_meeting(&table, radius, &path, t * (1.0 + 1e-9)) else {
                panic!("{name}, flight {i}: {feature:?} at {t} is lost: {path:?}");
            };
            assert!((again - t).abs() <= 1e-14, "{name}, flight {i}: {again} or {t}");
        }
    }
}

#[test]
fn a_mirrored_flight_meets_the_mirrored_part_at_the_same_time_to_the_bit() {
    for (name, table, radius) in tables() {
        let solid = Solid::new(&table, radius);
        let mut dice = Dice(0x3D);
        for i in 0..paths() / 20 {
            let path = random_flight(&mut dice, &solid);
            let found = first_meeting(&table, radius, &path, f64::INFINITY);
            for [x, y] in [[-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
                let by = |p: [f64; 3]| [p[0] * x, p[1] * y, p[2]];
                let image = Motion { d: by(path.d), v: by(path.v), h: by(path.h) };
                let image = first_meeting(&table, radius, &image, f64::INFINITY);
                let expected =
                    found.map(|(t, f)| (t.to_bits(), mirrored_feature(&table, f, [x, y])));
                let image = image.map(|(t, f)| (t.to_bits(), f));
                assert_eq!(image, expected, "{name}, flight {i}: {path:?}");
            }
        }
    }
}

#[test]
fn a_ball_reflected_by_every_feature_is_never_inside_anything() {
    /// Most meetings of a ball.
    const MEETINGS: usize = 50;
    /// Most meetings at one instant: in the corner of three surfaces.
    const AT_ONCE: usize = 8;
    for (name, table, radius) in tables() {
        let solid = Solid::new(&table, radius);
        let mut dice = Dice(0xB0_11CE);
        let mut met = [0_usize; 10];
        for i in 0..paths() / 500 {
            let mut path = random_flight(&mut dice, &solid);
            let mut at_once = 0;
            for meeting in 0..MEETINGS {
                let Some((t, feature)) = first_meeting(&table, radius, &path, f64::INFINITY) else {
                    panic!("{name}, ball {i}, meeting {meeting}: endless {path:?}");
                };
                let lost = solid.first_violation(&path, t);
                assert_eq!(
                    lost, None,
                    "{name}, ball {i}, meeting {meeting}, {feature:?}: {path:?}"
                );
                at_once = if t > 0.0 { 0 } else { at_once + 1 };
                assert!(at_once < AT_ONCE, "{name}, ball {i}, {feature:?}: {path:?}");
                met[kind(&table, feature)] += 1;
                let (p, v) = (Vec3::from(path.at(t)), Vec3::from(path.velocity_at(t)));
                let normal = table.contact_normal(feature, p, radius);
                if normal == Vec3::ZERO
                    && (!matches!(feature, TableFeature::Depth(_)) || p.z < -0.5 * radius)
                {
                    break;
                }
                path = flight(p, v - normal * (2.0 * v.dot(normal)));
            }
        }
        println!("{name}: {met:?}");
    }
}

/// A ball whose centre is exactly over the lip of pocket `k`, on the axis, moving inwards.
fn over_the_lip(table: &Table, k: usize, speed: f64) -> Motion<3> {
    let pocket = &table.pockets[k];
    let p = pocket.center - pocket.axis * pocket.radius;
    flight(p.with_z(POOL_BALL), (pocket.axis * speed).with_z(0.0))
}

#[test]
fn a_ball_too_slow_to_fly_touches_the_lip_at_once_and_a_fast_one_does_not() {
    let table = Table::preset("wpa-9ft").unwrap();
    // √(gR): at this speed the flight has the curvature of the lip's torus.
    let flies = carom::math::sqrt(GRAVITY * POOL_BALL);
    for k in 0..6 {
        for speed in [1e-9, 1e-3, 0.1, 0.9 * flies] {
            let path = over_the_lip(&table, k, speed);
            let (t, feature) = first_meeting(&table, POOL_BALL, &path, f64::INFINITY).unwrap();
            assert_eq!(feature, TableFeature::Lip(k as u8), "{speed}");
            assert!(t <= 1e-7, "{speed}: {t}");
        }
        for speed in [1.1 * flies, 2.0] {
            let path = over_the_lip(&table, k, speed);
            let (t, feature) = first_meeting(&table, POOL_BALL, &path, f64::INFINITY).unwrap();
            assert!(t > 1e-3, "{speed}: {feature:?} at {t}");
        }
    }
}

#[test]
fn a_ball_that_comes_off_a_rails_top_too_slowly_to_fly_tips_over_its_edge_at_once() {
    let table = Table::preset("wpa-9ft").unwrap();
    for speed in [0.0, 1e-9, 0.1, 0.4] {
        let d = Vec3::new(-0.5 * table.size.x, 0.4, table.cushion_height + POOL_BALL);
        let path = flight(d, Vec3::new(speed, 0.0, 0.0));
        let (t, feature) = first_meeting(&table, POOL_BALL, &path, f64::INFINITY).unwrap();
        let TableFeature::Cushion(part) = feature else { panic!("{speed}: {feature:?}") };
        assert_eq!(table.cushions[usize::from(part)].part, Part::Nose, "{speed}");
        assert!(t <= 1e-7, "{speed}: {t}");
    }
}

#[test]
fn on_unbounded_cloth_every_flight_ends_on_the_slate() {
    let table = Table::unbounded();
    let path = flight(Vec3::new(1e3, -7.0, POOL_BALL), Vec3::new(20.0, -3.0, 2.0));
    let (t, feature) = first_meeting(&table, POOL_BALL, &path, f64::INFINITY).unwrap();
    assert_eq!(feature, TableFeature::Slate);
    assert!((t - 4.0 / GRAVITY).abs() <= 1e-15);
}

#[test]
fn the_drawn_edges_decide_whether_a_point_is_on_the_bed_in_an_opening_on_a_rail_or_outside() {
    for (name, table, radius) in tables() {
        let solid = Solid::new(&table, radius);
        let mut dice = Dice(0x91ACE);
        let mut seen = [0; 4];
        for _ in 0..paths() / 5 {
            let out = table.size * 0.5 + Vec2::new(0.3, 0.3);
            let p = Vec2::new(dice.between(-out.x, out.x), dice.between(-out.y, out.y));
            let on_bed = p.x.abs() <= 0.5 * table.size.x && p.y.abs() <= 0.5 * table.size.y;
            let outside = !solid.is_within_border(p);
            let top = table.top_at(p);
            assert_eq!(table.is_outside(p), outside, "{name}: {p:?}");
            assert_eq!(top.is_some(), !outside && solid.is_behind_edges(p), "{name}: {p:?}");
            assert_eq!(
                table.opening_at(p).is_some(),
                !on_bed && !outside && top.is_none(),
                "{name}: {p:?}"
            );
            if let Some(top) = top {
                let part = &table.cushions[usize::from(top)];
                let Shape::Plane { corners } = part.shape else { panic!("{part:?}") };
                let turn = |i: usize| {
                    let (from, to) = (corners[i], corners[(i + 1) % 4]);
                    (to - from).cross(p - from)
                };
                let inside = (0..4).all(|i| turn(i) >= 0.0) || (0..4).all(|i| turn(i) <= 0.0);
                assert!(part.part == Part::Top && inside, "{name}: {p:?} {part:?}");
            }
            let at = [on_bed, table.opening_at(p).is_some(), top.is_some(), outside];
            seen[at.iter().position(|x| *x).unwrap()] += 1;
        }
        println!("{name}: bed, opening, top, outside {seen:?}");
    }
}

#[test]
fn the_edges_of_every_preset_enclose_its_holes() {
    for name in PRESETS {
        let table = Table::preset(name).unwrap();
        for pocket in table.pockets.iter().filter(|p| p.capture == Capture::DropCircle) {
            let walls: Vec<_> = table
                .cushions
                .iter()
                .filter_map(|c| match c.shape {
                    Shape::Hollow { center, radius, start, end } if center == pocket.center => {
                        Some((c.rail, center + start * radius, end))
                    }
                    _ => None,
                })
                .collect();
            assert_eq!(walls.len(), 2, "{name}");
            for (rail, begin, end) in walls {
                assert_eq!(end, pocket.axis, "{name}");
                // A straight run of the same rail leads from a deep end to the start of the wall.
                let run = table.cushions.iter().find(|c| {
                    let ends_here = matches!(c.shape, Shape::Segment { end, .. } if (end - begin).length() <= SAME_POINT);
                    c.rail == rail && c.part == Part::Liner && ends_here
                });
                let Shape::Segment { start, .. } = run.expect("a run").shape else {
                    unreachable!()
                };
                assert!(pocket.throat.contains(&start), "{name}: {start:?}");
            }
        }
    }
}

#[test]
fn a_ball_whose_centre_passed_an_edge_does_not_land_on_the_surface_that_it_left() {
    for (name, table, radius) in tables() {
        let solid = Solid::new(&table, radius);
        let mut dice = Dice(0x71B);
        for i in 0..paths() / 50 {
            // A ball that rolls from the bed into a pocket, or off the edge of a rail's top.
            let from_bed = dice.unit() < 0.5;
            let out = table.size * 0.5 + Vec2::new(0.1, 0.1);
            let p = Vec2::new(dice.between(-out.x, out.x), dice.between(-out.y, out.y));
            let v = dice.direction() * carom::math::pow(10.0, dice.between(-3.0, 0.5));
            let path = Motion { d: [p.x, p.y], v: [v.x, v.y], h: [0.0, 0.0] };
            let (left, z) = if from_bed {
                if !table.place_check(p, radius).is_inside() {
                    continue;
                }
                (ball_table::first_meeting(&table, radius, &path, 1e3), radius)
            } else {
                if !solid.is_behind_edges(p) || !solid.is_within_border(p) {
                    continue;
                }
                (first_loss_of_support(&table, &path, 1e3), table.cushion_height + radius)
            };
            let Some((t, TableFeature::Pocket(_) | TableFeature::Brink)) = left else { continue };
            if from_bed && !solid.has_holes() {
                continue;
            }
            let [x, y] = path.at(t);
            let path = flight(Vec3::new(x, y, z), v.with_z(0.0));
            let (t, feature) = first_meeting(&table, radius, &path, f64::INFINITY).unwrap();
            // Along a round edge the ball may come back to the surface that it left.
            let is_flat = feature == TableFeature::Slate || kind(&table, feature) == 3;
            assert!(t > 0.0 || !is_flat, "{name}, path {i}: {feature:?} at {t}: {path:?}");
        }
    }
}

//! The first feature that a ball on the cloth meets, compared with an independent search.

use crate::oracle::{self, Dice, clearance, distance_to_pocket, first_violation};
use carom::Table;
use carom::detect::ball_table::first_meeting;
use carom::math::Vec2;
use carom::table::TableFeature;
use carom::table::{PRESETS, Part, Placement, PocketModel, Shape, TableDescription};
use carom_roots::Motion;

const POOL_BALL: f64 = 0.028575;
/// Random paths per table: 100 000, or the value of the environment variable CAROM_PATHS.
pub(crate) fn paths() -> usize {
    std::env::var("CAROM_PATHS").ok().and_then(|n| n.parse().ok()).unwrap_or(100_000)
}
/// Largest overlap and largest gap at a meeting, m.
const CONTACT_GAP: f64 = 1e-14;
/// Median of the gap, m.
const MEDIAN_GAP: f64 = 1e-15;

/// Tables and ball radii: all presets with their balls, the mouth-line model, balls that are far
/// too small, and tables of unusual shape.
pub(crate) fn tables() -> Vec<(String, Table, f64)> {
    let ball = |name: &str| match name {
        "snooker-12ft" => 0.02625,
        "english-7ft" => 0.0254,
        "carom-10ft" | "carom-9ft" => 0.03075,
        _ => POOL_BALL,
    };
    let mut all = Vec::new();
    for name in PRESETS {
        let description = TableDescription::preset(name).unwrap();
        all.push((name.to_string(), Table::preset(name).unwrap(), ball(name)));
        if description.corner_pocket.is_some() {
            let lines = TableDescription { pocket_model: PocketModel::MouthLine, ..description };
            let table = Table::from_description(&lines).unwrap();
            all.push((format!("{name} with mouth lines"), table, ball(name)));
        }
    }
    let wpa = TableDescription::preset("wpa-9ft").unwrap();
    let change = |f: &dyn Fn(&mut TableDescription)| {
        let mut description = wpa.clone();
        f(&mut description);
        Table::from_description(&description).unwrap()
    };
    let sharp = change(&|d| {
        for pocket in [&mut d.corner_pocket, &mut d.side_pocket] {
            pocket.as_mut().unwrap().point_radius = 0.0;
        }
    });
    let far_holes = change(&|d| {
        for pocket in [&mut d.corner_pocket, &mut d.side_pocket] {
            pocket.as_mut().unwrap().shelf = 0.1;
        }
        d.rail_width = 0.25;
    });
    let bent = change(&|d| {
        d.corner_pocket.as_mut().unwrap().throat = Some(0.08);
        d.side_pocket.as_mut().unwrap().throat = Some(0.12);
    });
    let open = change(&|d| {
        let corner = d.corner_pocket.as_mut().unwrap();
        (corner.cut_angle_deg, corner.hole_radius) = (125.0, 0.08);
        d.rail_width = 0.2;
    });
    let low = change(&|d| d.cushion_height = 0.02);
    all.push(("sharp points".into(), sharp, POOL_BALL));
    all.push(("holes far behind the facings".into(), far_holes, POOL_BALL));
    all.push(("facings off the tangent".into(), bent, POOL_BALL));
    all.push(("corners that open inwards".into(), open, POOL_BALL));
    all.push(("tiny balls".into(), low, 0.0105));
    all
}

/// A path of a ball from a random free position, often near a pocket.
fn random_path(dice: &mut Dice, table: &Table, radius: f64) -> (Motion<2>, f64) {
    let (half, reach) = (table.size * 0.5, table.reach(radius));
    let start = loop {
        let p = if dice.unit() < 0.5 && !table.pockets.is_empty() {
            let pocket = &table.pockets[(dice.unit() * 6.0) as usize];
            pocket.center - pocket.axis * dice.between(0.0, 0.3)
                + pocket.axis.perp() * dice.between(-0.15, 0.15)
        } else {
            Vec2::new(dice.between(-half.x, half.x), dice.between(-half.y, half.y))
        };
        if table.place_check(p, radius).is_inside()
            && clearance(table, reach, p).0 > 0.0
            && distance_to_pocket(table, p) > 0.0
        {
            break p;
        }
    };
    let v = dice.direction() * dice.between(0.0, 4.0);
    // Rolling, sliding, or curved far more than on any cloth.
    let kind = dice.unit();
    let h = if kind < 0.4 {
        v * (-0.049 / v.length())
    } else if kind < 0.8 {
        dice.direction() * 0.981
    } else {
        dice.direction() * dice.between(0.0, 20.0)
    };
    let horizon = if dice.unit() < 0.1 { f64::INFINITY } else { dice.between(0.0, 4.0) };
    (Motion { d: [start.x, start.y], v: [v.x, v.y], h: [h.x, h.y] }, horizon)
}

#[test]
fn no_meeting_is_missed_and_none_is_false_on_any_table() {
    for (name, table, radius) in tables() {
        let reach = table.reach(radius);
        let mut dice = Dice(0x00C0_FFEE);
        let mut gaps = Vec::new();
        let mut met = [0_usize; 4];
        for i in 0..paths() {
            let (path, horizon) = random_path(&mut dice, &table, radius);
            let found = first_meeting(&table, radius, &path, horizon);
            // A path without end that meets nothing would stay on the table, which an accelerated
            // one cannot.
            assert!(found.is_some() || horizon.is_finite(), "{name}, path {i}: {path:?}");
            let end = found.map_or(horizon, |(t, _)| t);
            if let Some(t) = first_violation(&table, reach, &path, 0.0, end) {
                panic!("{name}, path {i}: lost at {t} before {found:?}: {path:?}");
            }
            let Some((t, feature)) = found else {
                met[3] += 1;
                continue;
            };
            assert!((0.0..=horizon).contains(&t), "{name}, path {i}: {t}");
            let gap = judge_meeting(&table, reach, &path, t, feature)
                .unwrap_or_else(|why| panic!("{name}, path {i}: {why} at {found:?}: {path:?}"));
            gaps.push(gap.abs());
            met[match feature {
                TableFeature::Pocket(_) => 2,
                TableFeature::Cushion(part) => {
                    usize::from(table.cushions[usize::from(part)].part != Part::Nose)
                }
                _ => panic!("{name}, path {i}: {feature:?} for a ball on the cloth"),
            }] += 1;
        }
        gaps.sort_by(f64::total_cmp);
        assert!(gaps[gaps.len() / 2] <= MEDIAN_GAP, "{name}: median {:e}", gaps[gaps.len() / 2]);
        let worst = gaps[gaps.len() - 1];
        assert!(worst <= CONTACT_GAP, "{name}: worst {worst:e}");
        println!("{name}: nose, jaw, pocket, none {met:?}, worst gap {worst:e}");
    }
}

/// The gap at a meeting, or why the meeting is wrong.
fn judge_meeting(
    table: &Table,
    reach: f64,
    path: &Motion<2>,
    t: f64,
    feature: TableFeature,
) -> Result<f64, String> {
    let ([x, y], [vx, vy]) = (path.at(t), path.velocity_at(t));
    let (p, v) = (Vec2::new(x, y), Vec2::new(vx, vy));
    match feature {
        TableFeature::Cushion(part) => {
            let shape = &table.cushions[usize::from(part)].shape;
            let gap = oracle::distance(shape, p) - reach;
            let into = table.normal_at(usize::from(part), p);
            if v.dot(into) <= 0.0 {
                return Err(format!("moves away from part {part} by {}", v.dot(into)));
            }
            if (into.length() - 1.0).abs() > 1e-15 {
                return Err("the normal is not a unit vector".into());
            }
            if gap.abs() > CONTACT_GAP {
                return Err(format!("gap {gap:e} to part {part}"));
            }
            Ok(gap)
        }
        TableFeature::Pocket(_) => {
            let gap = distance_to_pocket(table, p);
            if gap.abs() > CONTACT_GAP {
                return Err(format!("{gap:e} from the pocket"));
            }
            Ok(gap)
        }
        other => Err(format!("{other:?} for a ball on the cloth")),
    }
}

/// A velocity and acceleration mirrored by the signs `x` and `y`.
pub(crate) fn mirrored(path: &Motion<2>, [x, y]: [f64; 2]) -> Motion<2> {
    let by = |p: [f64; 2]| [p[0] * x, p[1] * y];
    Motion { d: by(path.d), v: by(path.v), h: by(path.h) }
}

/// Index of the mirrored part of a table.
pub(crate) fn mirrored_feature(
    table: &Table,
    feature: TableFeature,
    [x, y]: [f64; 2],
) -> TableFeature {
    let by = |p: Vec2| Vec2::new(p.x * x, p.y * y);
    match feature {
        TableFeature::Pocket(i) => {
            let center = by(table.pockets[usize::from(i)].center);
            let at = |p: &carom::table::Pocket| p.center == center;
            TableFeature::Pocket(table.pockets.iter().position(at).unwrap() as u8)
        }
        TableFeature::Cushion(i) => {
            let shape = table.cushions[usize::from(i)].shape;
            let same = |other: &Shape| match (shape, *other) {
                (
                    Shape::Segment { start, end, normal },
                    Shape::Segment { start: s, end: e, normal: n },
                ) => {
                    let ends = [by(start), by(end)];
                    by(normal) == n && (ends == [s, e] || ends == [e, s])
                }
                (
                    Shape::Arc { center, radius, start, end },
                    Shape::Arc { center: c, radius: r, start: s, end: e },
                ) => by(center) == c && radius == r && by(start) == s && by(end) == e,
                (
                    Shape::Hollow { center, start, end, .. },
                    Shape::Hollow { center: c, start: s, end: e, .. },
                ) => by(center) == c && by(start) == s && by(end) == e,
                (Shape::Plane { corners }, Shape::Plane { corners: others }) => {
                    others.contains(&by(corners[0])) && others.contains(&by(corners[2]))
                }
                _ => false,
            };
            let mut parts = table.cushions.iter();
            TableFeature::Cushion(parts.position(|c| same(&c.shape)).unwrap() as u16)
        }
        TableFeature::Lip(i) | TableFeature::Depth(i) => {
            let center = by(table.pockets[usize::from(i)].center);
            let k = table.pockets.iter().position(|p| p.center == center).unwrap() as u8;
            match feature {
                TableFeature::Lip(_) => TableFeature::Lip(k),
                _ => TableFeature::Depth(k),
            }
        }
        other => other,
    }
}

#[test]
fn a_mirrored_path_meets_the_mirrored_part_at_the_same_time_to_the_bit() {
    for (name, table, radius) in tables() {
        let mut dice = Dice(0x5EED);
        for i in 0..paths() / 20 {
            let (path, horizon) = random_path(&mut dice, &table, radius);
            let found = first_meeting(&table, radius, &path, horizon);
            for signs in [[-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
                let image = first_meeting(&table, radius, &mirrored(&path, signs), horizon);
                let expected =
                    found.map(|(t, f)| (t.to_bits(), mirrored_feature(&table, f, signs)));
                assert_eq!(
                    image.map(|(t, f)| (t.to_bits(), f)),
                    expected,
                    "{name}, path {i}: {path:?}"
                );
            }
        }
    }
}

#[test]
fn a_ball_that_bounces_without_loss_leaves_the_table_only_through_a_pocket() {
    /// Most meetings of a ball.
    const BOUNCES: usize = 100;
    for (name, table, radius) in tables() {
        let reach = table.reach(radius);
        let mut dice = Dice(0xBA11);
        for i in 0..paths() / 500 {
            let (mut path, _) = random_path(&mut dice, &table, radius);
            for bounce in 0..BOUNCES {
                let met = first_meeting(&table, radius, &path, 10.0);
                let end = met.map_or(10.0, |(t, _)| t);
                let lost = first_violation(&table, reach, &path, 0.0, end);
                assert_eq!(lost, None, "{name}, ball {i}, bounce {bounce}: {path:?}");
                let Some((t, TableFeature::Cushion(part))) = met else { break };
                let ([x, y], [vx, vy]) = (path.at(t), path.velocity_at(t));
                let v = Vec2::new(vx, vy);
                let into = table.normal_at(usize::from(part), Vec2::new(x, y));
                let v = v - into * (2.0 * v.dot(into));
                // After every other bounce the path curves back to the cushion, as with topspin.
                let h = if bounce % 2 == 0 { into * 0.981 } else { v * -0.01 };
                path = Motion { d: [x, y], v: [v.x, v.y], h: [h.x, h.y] };
            }
        }
    }
}

/// The path of a ball frozen to the right rail of a table, `along` m above its middle.
fn frozen(table: &Table, along: f64, v: [f64; 2], h: [f64; 2]) -> Motion<2> {
    Motion { d: [0.5 * table.size.x - table.reach(POOL_BALL), along], v, h }
}

#[test]
fn a_ball_frozen_to_a_rail_and_driven_into_it_meets_it_at_once() {
    /// Rounding of a position half a metre from the middle, m.
    const ROUNDING: f64 = 1e-16;
    for name in PRESETS {
        let table = Table::preset(name).unwrap();
        for v in [[1.0, 0.0], [1e-9, 0.0], [1e-9, 3.0], [5.0, -5.0], [0.0, 0.0]] {
            let path = frozen(&table, 0.3, v, [0.5, 0.0]);
            let (t, feature) = first_meeting(&table, POOL_BALL, &path, f64::INFINITY).unwrap();
            let TableFeature::Cushion(part) = feature else { panic!("{name}: {feature:?}") };
            let way = path.at(t)[0] - path.d[0];
            assert!((0.0..=ROUNDING).contains(&way), "{name}, {v:?}: {t}");
            assert_eq!(table.cushions[usize::from(part)].part, Part::Nose);
        }
    }
}

#[test]
fn a_ball_frozen_to_a_rail_and_driven_off_it_or_along_it_does_not_meet_it() {
    for name in PRESETS {
        let table = Table::preset(name).unwrap();
        let horizon = 0.05;
        for (v, h) in [
            ([-1.0, 0.0], [0.0, 0.0]),
            ([-1e-9, 2.0], [0.0, 0.0]),
            ([0.0, 2.0], [0.0, 0.0]),
            ([0.0, 2.0], [-0.5, 0.0]),
            ([0.0, 0.0], [0.0, 0.0]),
            ([0.0, 0.0], [-0.5, 0.0]),
        ] {
            let path = frozen(&table, 0.3, v, h);
            assert_eq!(first_meeting(&table, POOL_BALL, &path, horizon), None, "{name}, {v:?}");
        }
    }
}

#[test]
fn a_ball_driven_off_a_rail_and_pulled_back_by_friction_meets_it_again() {
    let table = Table::preset("wpa-9ft").unwrap();
    // x = −0.1t + t²/2 is 0 again at t = 0.2.
    let path = frozen(&table, 0.3, [-0.1, 0.0], [0.5, 0.0]);
    let (t, _) = first_meeting(&table, POOL_BALL, &path, f64::INFINITY).unwrap();
    assert!((t - 0.2).abs() <= 1e-15, "{t}");
}

#[test]
fn a_ball_one_rounding_behind_the_nose_line_is_treated_alike() {
    let table = Table::preset("wpa-9ft").unwrap();
    let mut path = frozen(&table, 0.3, [-1.0, 0.2], [0.0, 0.0]);
    path.d[0] = f64::from_bits(path.d[0].to_bits() + 1);
    let (t, feature) = first_meeting(&table, POOL_BALL, &path, f64::INFINITY).unwrap();
    assert!(t > 0.5, "{t}: {feature:?}");
    path.v[0] = 1e-12;
    assert_eq!(first_meeting(&table, POOL_BALL, &path, f64::INFINITY).unwrap().0, 0.0);
}

#[test]
fn a_ball_rolling_along_a_rail_passes_the_side_pocket_without_a_contact() {
    for name in ["wpa-9ft", "showood-7ft", "snooker-12ft"] {
        let table = Table::preset(name).unwrap();
        let path = frozen(&table, -0.3, [0.0, 2.0], [0.0, 0.0]);
        let (t, feature) = first_meeting(&table, POOL_BALL, &path, f64::INFINITY).unwrap();
        // Its next meeting is in the corner pocket.
        let y = path.at(t)[1];
        assert!(y > 0.5 * table.size.y - 0.2, "{name}: {feature:?} at y = {y}");
    }
}

#[test]
fn the_pocket_model_decides_whether_the_hole_or_the_mouth_line_captures_a_ball() {
    let description = TableDescription::preset("wpa-9ft").unwrap();
    let lines = TableDescription { pocket_model: PocketModel::MouthLine, ..description.clone() };
    let path = Motion { d: [0.3, 0.0], v: [1.0, 0.0], h: [0.0, 0.0] };
    for (description, behind_nose) in
        [(&description, description.side_pocket.unwrap().shelf), (&lines, 0.0)]
    {
        let table = Table::from_description(description).unwrap();
        let (t, feature) = first_meeting(&table, POOL_BALL, &path, f64::INFINITY).unwrap();
        assert_eq!(feature, TableFeature::Pocket(3));
        let x = 0.3 + t;
        assert!((x - (0.635 + behind_nose)).abs() <= 1e-15, "{x}");
    }
}

#[test]
fn a_ball_aimed_at_a_join_almost_along_the_cushion_does_not_pass_between_the_parts() {
    /// Distance of the paths' start before the join, and their length, m.
    const RUN: [f64; 2] = [0.004, 0.3];
    const SAMPLES: u32 = 300;
    for (name, table, radius) in tables().into_iter().filter(|(_, t, _)| !t.pockets.is_empty()) {
        let reach = table.reach(radius);
        let mut dice = Dice(0x10_1275);
        let noses: Vec<_> = table.cushions.iter().filter(|c| c.part == Part::Nose).collect();
        for i in 0..paths() / 50 {
            let nose = noses[(dice.unit() * noses.len() as f64) as usize];
            let Shape::Segment { start, end, normal } = nose.shape else { unreachable!() };
            let (join, other) = if dice.unit() < 0.5 { (start, end) } else { (end, start) };
            let along = (other - join) * (1.0 / (other - join).length());
            let power = |exponent: f64| carom::math::pow(10.0, exponent);
            let slope = power(dice.between(-14.0, -3.0));
            let before =
                power(dice.between(-17.0, -5.0)) * if dice.unit() < 0.5 { 1.0 } else { -1.0 };
            let v = along - normal * slope;
            let p = join + normal * reach - along * before - v * RUN[0];
            let path = Motion { d: [p.x, p.y], v: [v.x, v.y], h: [0.0, 0.0] };
            let met = first_meeting(&table, radius, &path, RUN[1]);
            let end = met.map_or(RUN[1], |(t, _)| t);
            for k in 0..=SAMPLES {
                let [x, y] = path.at(end * f64::from(k) / f64::from(SAMPLES));
                let free = clearance(&table, reach, Vec2::new(x, y)).0;
                assert!(free >= -oracle::LOST, "{name}, path {i}: {free:e}, {met:?}: {path:?}");
            }
        }
    }
}

#[test]
fn a_ball_aimed_at_a_join_from_any_direction_meets_one_of_its_parts() {
    for (name, table, radius) in tables() {
        let reach = table.reach(radius);
        let mut dice = Dice(0xA1_3ED);
        let shapes: Vec<_> = table.parts_on_cloth().iter().map(|c| c.shape).collect();
        for i in 0..paths() / 20 {
            let (join, normal) = match shapes[(dice.unit() * shapes.len() as f64) as usize] {
                Shape::Segment { start, normal, .. } if dice.unit() < 0.5 => (start, normal),
                Shape::Segment { end, normal, .. } => (end, normal),
                Shape::Arc { center, radius, start, .. } if dice.unit() < 0.5 => {
                    (center + start * radius, start)
                }
                Shape::Arc { center, radius, end, .. } => (center + end * radius, end),
                other => panic!("{other:?} is not met on the cloth"),
            };
            // At the join, or a few roundings next to it.
            let target = join + normal * reach + normal.perp() * dice.between(-1e-15, 1e-15);
            let reachable = clearance(&table, reach, target).0 > -oracle::LOST
                && distance_to_pocket(&table, target) > 0.0;
            if !reachable {
                continue;
            }
            let from = loop {
                let p = target + dice.direction() * dice.between(0.0, 0.02);
                if table.place_check(p, radius) == Placement::Inside
                    && distance_to_pocket(&table, p) > 0.0
                {
                    break p;
                }
            };
            let v = target - from;
            let path = Motion { d: [from.x, from.y], v: [v.x, v.y], h: [0.0, 0.0] };
            let met = first_meeting(&table, radius, &path, 1.5);
            let end = met.map_or(1.5, |(t, _)| t);
            let lost = first_violation(&table, reach, &path, 0.0, end);
            assert_eq!(lost, None, "{name}, path {i}: {met:?}: {path:?}");
        }
    }
}

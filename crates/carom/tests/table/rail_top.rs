//! The time at which a ball leaves a rail's top, compared with a walk along its path.

use crate::meeting::{mirrored, paths, tables};
use crate::oracle::Dice;
use crate::solid::Solid;
use carom::detect::rail_top::first_loss_of_support;
use carom::math::Vec2;
use carom::table::TableFeature;
use carom_roots::Motion;

/// Distance from an edge within which a ball leaves, m: roundings of a position.
const EDGE_GAP: f64 = 1e-14;
/// Points examined along a path.
const SAMPLES: u32 = 400;
/// A path may graze over an edge by the roundings of a position, m.
const GRAZE: f64 = 1e-12;

/// A path that starts on a rail's top, slowing down like a rolling or a sliding ball, and how long
/// it is.
fn random_path(dice: &mut Dice, solid: &Solid<'_>) -> (Motion<2>, f64) {
    let table = solid.table;
    let out = table.size * 0.5 + Vec2::new(0.15, 0.15);
    let p = loop {
        let near = dice.unit() < 0.7 && !table.pockets.is_empty();
        let p = if near {
            let pocket = &table.pockets[(dice.unit() * 6.0) as usize];
            pocket.center + dice.direction() * dice.between(0.0, 0.25)
        } else {
            Vec2::new(dice.between(-out.x, out.x), dice.between(-out.y, out.y))
        };
        if solid.is_behind_edges(p) && solid.is_within_border(p) {
            break p;
        }
    };
    let v = dice.direction() * carom::math::pow(10.0, dice.between(-2.0, 0.5));
    let h = match (dice.unit() * 3.0) as u32 {
        0 => v * (-0.049 / v.length()),
        1 => dice.direction() * 0.981,
        _ => Vec2::ZERO,
    };
    // Friction stops a ball and does not reverse it.
    let slowing = -2.0 * h.dot(v) / v.length();
    let stop = if slowing > 0.0 { v.length() / slowing } else { 2.0 };
    (Motion { d: [p.x, p.y], v: [v.x, v.y], h: [h.x, h.y] }, stop.min(2.0))
}

#[test]
fn a_ball_leaves_a_rails_top_where_its_centre_first_crosses_an_edge_or_the_border() {
    for (name, table, radius) in tables() {
        let solid = Solid::new(&table, radius);
        let mut dice = Dice(0x7095);
        let mut met = [0; 3];
        for i in 0..paths() / 100 {
            let (path, horizon) = random_path(&mut dice, &solid);
            let found = first_loss_of_support(&table, &path, horizon);
            let end = found.map_or(horizon, |(t, _)| t);
            for k in 0..SAMPLES {
                let [x, y] = path.at(end * f64::from(k) / f64::from(SAMPLES));
                let p = Vec2::new(x, y);
                let on_top = solid.is_behind_edges(p) && solid.is_within_border(p);
                let depth = solid.distance_to_edge(p);
                assert!(
                    on_top || depth <= GRAZE,
                    "{name}, path {i}: {depth:e} off at {p:?} of {found:?} {path:?}"
                );
            }
            let Some((t, feature)) = found else {
                met[2] += 1;
                continue;
            };
            let [x, y] = path.at(t);
            let p = Vec2::new(x, y);
            match feature {
                TableFeature::Brink => {
                    let gap = solid.distance_to_edge(p);
                    assert!(gap <= EDGE_GAP, "{name}, path {i}: {gap:e} {path:?}");
                    met[0] += 1;
                }
                TableFeature::Border => {
                    let rail = table.description.as_ref().unwrap().rail_width;
                    let off = (x.abs() - 0.5 * table.size.x).max(y.abs() - 0.5 * table.size.y);
                    assert!((off - rail).abs() <= EDGE_GAP, "{name}, path {i}: {path:?}");
                    met[1] += 1;
                }
                other => panic!("{name}, path {i}: {other:?}"),
            }
            // Shortly after it is off, unless it only grazed a round edge.
            let [vx, vy] = path.velocity_at(t);
            let later = p + Vec2::new(vx, vy) * (1e-7 / Vec2::new(vx, vy).length());
            let off = !solid.is_behind_edges(later) || !solid.is_within_border(later);
            assert!(off || solid.distance_to_edge(later) <= 1e-9, "{name}, path {i}: {path:?}");
        }
        println!("{name}: brink, border, stays {met:?}");
    }
}

#[test]
fn a_mirrored_path_on_a_rails_top_ends_at_the_same_time_to_the_bit() {
    for (name, table, radius) in tables() {
        let solid = Solid::new(&table, radius);
        let mut dice = Dice(0x7096);
        for i in 0..paths() / 50 {
            let (path, horizon) = random_path(&mut dice, &solid);
            let bits = |path: &Motion<2>| {
                first_loss_of_support(&table, path, horizon).map(|(t, f)| (t.to_bits(), f))
            };
            for signs in [[-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
                assert_eq!(bits(&path), bits(&mirrored(&path, signs)), "{name}, {i}: {path:?}");
            }
        }
    }
}

#[test]
fn a_ball_at_the_brink_that_rolls_off_leaves_at_once_and_one_that_rolls_away_does_not() {
    let table = carom::Table::preset("wpa-9ft").unwrap();
    let edge = -0.5 * table.size.x;
    let leaving = |x: f64, v: f64| {
        let path = Motion { d: [x, 0.4], v: [v, 0.0], h: [0.0, 0.0] };
        first_loss_of_support(&table, &path, 0.2)
    };
    assert_eq!(leaving(edge, 0.1), Some((0.0, TableFeature::Brink)));
    assert_eq!(leaving(edge, -0.1), None);
    assert_eq!(leaving(edge, 0.0), None);
    let (t, feature) = leaving(edge - 0.01, 0.1).unwrap();
    assert!(feature == TableFeature::Brink && (t - 0.1).abs() <= 1e-14, "{feature:?} {t}");
    let rail = table.description.as_ref().unwrap().rail_width;
    let (t, feature) = leaving(edge - rail + 0.01, -0.1).unwrap();
    assert!(feature == TableFeature::Border && (t - 0.1).abs() <= 1e-14, "{feature:?} {t}");
}

//! What a ball meets first, judged against an independent search.

use carom::Table;
use carom::detect::ball_table::{TableFeature, first_meeting};
use carom_roots::Motion;

const POOL_BALL: f64 = 0.028575;

#[test]
fn on_unbounded_cloth_a_ball_meets_nothing() {
    let table = Table::unbounded();
    let path = Motion { d: [0.3, -7.0], v: [10.0, 3.0], h: [-0.05, 0.2] };
    assert_eq!(first_meeting(&table, POOL_BALL, &path, f64::INFINITY), None);
    assert_eq!(first_meeting(&table, POOL_BALL, &path, 10.0), None);
}

#[test]
fn a_ball_rolled_across_a_pool_table_meets_the_opposite_nose_at_its_reach() {
    let table = Table::preset("wpa-9ft").unwrap();
    let path = Motion { d: [0.0, 0.3], v: [2.0, 0.0], h: [-0.05, 0.0] };
    let (t, feature) = first_meeting(&table, POOL_BALL, &path, f64::INFINITY).unwrap();
    let TableFeature::Cushion(part) = feature else { panic!("{feature:?}") };
    assert_eq!(table.cushions[part as usize].rail.name(), "right-upper");
    let x = path.at(t)[0];
    assert!((x + table.reach(POOL_BALL) - 0.5 * table.size.x).abs() <= 1e-15);
}

#[test]
fn a_ball_rolled_along_the_diagonal_is_captured_by_the_corner() {
    for name in ["wpa-9ft", "showood-7ft", "snooker-12ft", "english-7ft"] {
        let table = Table::preset(name).unwrap();
        let to = table.pockets[5].center;
        let path = Motion { d: [to.x - 0.3, to.y - 0.3], v: [1.0, 1.0], h: [-0.05, -0.05] };
        let (_, feature) = first_meeting(&table, 0.0254, &path, f64::INFINITY).unwrap();
        assert_eq!(feature, TableFeature::Pocket(5), "{name}");
    }
}

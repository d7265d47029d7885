//! Maps agree with single shots.

use carom::rack::{Break, Game, break_shot};
use carom::{Noise, Shot};
use carom_plan::breaks::{BreakStatistics, breaks};
use carom_plan::maps::{Accepted, Approaches, PotTarget, acceptance, position_map, pot_map};
use carom_plan::{DrawnTables, ErrorModel, Progress};

const TOP_RIGHT: usize = 5;
const TARGET: PotTarget = PotTarget { ball: 1, pocket: TOP_RIGHT };

fn cut() -> Shot {
    let text = r#"{"format": "carom-shot/1", "table": "wpa-9ft",
        "balls": [{"id": "cue", "position": [0.5, 1.2]}, {"id": "1", "position": [0.9, 1.9]}],
        "strike": {"ball": "cue", "speed": 2.0, "azimuth_deg": 60.0}}"#;
    Shot::from_json(text).expect("a shot")
}

fn none() -> DrawnTables {
    DrawnTables::default()
}

#[test]
fn a_pot_is_likely_from_behind_the_ball_and_impossible_from_its_far_side() {
    let model = ErrorModel { seed: 1, variants: 60, ..ErrorModel::default() };
    let map = pot_map(&cut(), TARGET, [6, 12], &model, &none(), None, &Progress::default())
        .expect("a map");
    let at = |x: f64, y: f64| {
        let (column, row) = ((x / 1.27 * 6.0) as usize, (y / 2.54 * 12.0) as usize);
        map.chance[row * 6 + column].share()
    };
    assert!(at(0.6, 1.4) > 0.9, "straight behind it: {}", at(0.6, 1.4));
    assert!(at(1.2, 2.3) < 0.05, "between ball and pocket: {}", at(1.2, 2.3));
    assert!(at(0.1, 0.1) < at(0.6, 1.4), "nearer is easier");
    assert!(map.chance.iter().all(|c| [0, 60].contains(&c.variants) && c.met <= c.variants));
}

#[test]
fn nearly_certain_cells_need_fewer_variants() {
    let model = ErrorModel { variants: 4000, half_width: Some(0.04), ..ErrorModel::default() };
    let map = pot_map(&cut(), TARGET, [3, 6], &model, &none(), None, &Progress::default())
        .expect("a map");
    let mut spent = Vec::new();
    for chance in map.chance.iter().filter(|c| c.variants > 0) {
        assert!(chance.interval(0.95).half_width() <= 0.04, "{chance:?}");
        spent.push(chance.variants);
    }
    let (least, most) = (spent.iter().min(), spent.iter().max());
    assert!(least < most && most < Some(&4000), "{least:?} {most:?}");
}

#[test]
fn every_position_of_the_map_is_the_end_of_the_shot() {
    let shot = cut();
    let (speeds, spins) = ([1.5, 3.0], [[0.0, -0.3], [0.0, 0.0], [0.2, 0.3]]);
    let map = position_map(&shot, 1, TOP_RIGHT, &speeds, &spins, None, &Progress::default())
        .expect("a map");
    assert_eq!(map.met.len(), 6);
    for (cell, met) in map.met.iter().enumerate() {
        assert!(met, "an easy cut");
        let (_, strike) = shot.strike().expect("a strike");
        let [side, height] = spins[cell % 3];
        let strike = carom::resolve::cue_ball::Strike {
            speed: speeds[cell / 3],
            azimuth: map.azimuth[cell],
            side,
            height,
            ..strike
        };
        let trace = shot.with_strike(&strike).expect("a shot").simulate().expect("a trace");
        assert_eq!(trace.outcome().pocketed.len(), 1);
        let end = trace.last()[0].position;
        assert_eq!([end.x, end.y], map.end[cell]);
    }
}

#[test]
fn a_pocket_accepts_fewer_balls_that_are_fast_or_oblique() {
    let offsets: Vec<f64> = (-30..=30).map(|k| 0.002 * f64::from(k)).collect();
    let approaches =
        Approaches { angles: &[0.0, 0.6], offsets: &offsets, speeds: &[0.8, 4.0], distance: 0.3 };
    let found =
        acceptance(&cut(), TOP_RIGHT, &approaches, None, &Progress::default()).expect("curves");
    let width = |row: usize| {
        let row = &found[row * offsets.len()..][..offsets.len()];
        row.iter().filter(|a| **a == Accepted::Falls).count()
    };
    // At an angle, a slow ball rolls in along the rail and a fast one rattles.
    let [slow, _, fast, fast_aslant] = [0, 1, 2, 3].map(width);
    assert!(slow > fast && fast > fast_aslant, "{slow} {fast} {fast_aslant}");
    let middle = found[offsets.len() / 2];
    assert_eq!(middle, Accepted::Falls);
    // The corner is its own mirror image.
    let first: Vec<_> = found[..offsets.len()].to_vec();
    assert!(first.iter().eq(first.iter().rev()));
}

#[test]
fn a_ball_that_returns_from_across_the_table_is_not_accepted() {
    // 61° is nearly the table's diagonal: off both cushions, to the other corner and back.
    let approaches = Approaches {
        angles: &[carom::math::radians(16.0)],
        offsets: &[-0.06, 0.0],
        speeds: &[4.0],
        distance: 0.3,
    };
    let found =
        acceptance(&cut(), TOP_RIGHT, &approaches, None, &Progress::default()).expect("curves");
    assert_eq!(found, [Accepted::Stays, Accepted::Falls]);
}

fn broken(opening: &Break<'_>, model: ErrorModel, threads: Option<usize>) -> BreakStatistics {
    breaks(opening, &model, threads, &Progress::default()).expect("breaks")
}

#[test]
fn breaks_without_noise_are_the_simulated_racks_ball_by_ball() {
    let opening = Break::new(Game::NineBall, 11);
    let model =
        ErrorModel { noise: Noise::default(), seed: 11, variants: 20, ..ErrorModel::default() };
    let statistics = broken(&opening, model, None);
    let all = &statistics.result;
    let columns = break_shot(&opening).expect("a break");
    let (mut fell, mut racks_with_a_pot) = (0, 0);
    for k in 0..20 {
        let shot = break_shot(&Break::new(Game::NineBall, 11 + k)).expect("a break");
        let trace = shot.simulate().expect("a trace");
        let row = &all.pocket[k as usize * all.balls..][..all.balls];
        for (ball, pocket) in columns.balls().iter().zip(row) {
            let own = shot.ball_index(&ball.id).expect("the same balls") as u16;
            let potted = trace.outcome().pocketed.iter().any(|(i, _)| *i == own);
            assert_eq!(potted, *pocket >= 0, "rack {k}, ball {}", ball.id);
            fell += u64::from(potted);
        }
        let objects = trace.outcome().pocketed.iter().any(|(i, _)| *i != 0);
        racks_with_a_pot += u64::from(objects);
        assert_eq!(all.events[k as usize], trace.events().len() as i32);
    }
    assert!(fell > 0, "racks in which nothing falls test nothing");
    assert_eq!(statistics.ball_potted.iter().sum::<u64>(), fell);
    assert_eq!(statistics.any_potted, racks_with_a_pot);
}

#[test]
fn breaks_are_the_same_for_any_number_of_threads() {
    let opening = Break::new(Game::EightBall, 5);
    let model =
        ErrorModel { noise: Noise::olympiad(2.0), seed: 5, variants: 20, ..ErrorModel::default() };
    let alone = broken(&opening, model.clone(), Some(1));
    let together = broken(&opening, model.clone(), Some(2));
    assert_eq!(alone.result.pocket, together.result.pocket);
    // The first racks do not depend on how many follow.
    let few = broken(&opening, ErrorModel { variants: 7, ..model }, None);
    assert_eq!(alone.result.pocket[..7 * alone.result.balls], few.result.pocket);
}

#[test]
fn breaks_end_when_every_interval_is_as_short_as_was_asked_for() {
    let opening = Break::new(Game::NineBall, 1);
    let model = ErrorModel { variants: 3000, half_width: Some(0.04), ..ErrorModel::default() };
    let statistics = broken(&opening, model.clone(), None);
    assert_eq!(statistics.result.shots, 1024, "one round is enough");
}

fn message<T: core::fmt::Debug>(found: Result<T, carom::Error>) -> String {
    found.expect_err("nonsense").to_string()
}

#[test]
fn a_position_map_of_a_billion_cells_is_rejected_before_it_is_allocated() {
    let (speeds, spins) = (vec![1.0; 10_000], vec![[0.0, 0.0]; 100_000]);
    let asked = position_map(&cut(), 1, TOP_RIGHT, &speeds, &spins, None, &Progress::default());
    assert_eq!(
        message(asked),
        "speed, spin: 10000 × 100000 are too many cells; give at most 10000000 in all"
    );
}

#[test]
fn speeds_and_offsets_out_of_range_are_rejected() {
    let ask = |speed, spin| {
        position_map(&cut(), 1, TOP_RIGHT, &[speed], &[spin], None, &Progress::default())
    };
    for speed in [-1.0, 0.0, 1e300, f64::NAN, f64::INFINITY] {
        assert!(message(ask(speed, [0.0, 0.0])).starts_with("speed: "), "{speed}");
    }
    for spin in [[0.0, 5.0], [-0.9, 0.9], [f64::NAN, 0.0]] {
        assert!(message(ask(1.0, spin)).starts_with("side, height: "), "{spin:?}");
    }
}

#[test]
fn approaches_from_beyond_the_table_are_rejected() {
    let ask = |angle, offset, speed, distance| {
        let approaches =
            Approaches { angles: &[angle], offsets: &[offset], speeds: &[speed], distance };
        message(acceptance(&cut(), TOP_RIGHT, &approaches, None, &Progress::default()))
    };
    for distance in [1e9, 0.0, -1.0, f64::NAN] {
        assert!(ask(0.0, 0.0, 1.0, distance).starts_with("distance: "), "{distance}");
    }
    assert!(ask(1e6, 0.0, 1.0, 0.3).starts_with("angle: "));
    assert!(ask(0.0, 1e6, 1.0, 0.3).starts_with("offset: "));
    assert!(ask(0.0, 0.0, 1e6, 0.3).starts_with("speed: "));
}

#[test]
fn a_nine_ball_break_on_a_carom_table_is_rejected() {
    let opening = Break { table: Some("carom-10ft"), ..Break::new(Game::NineBall, 1) };
    let asked = breaks(&opening, &ErrorModel::default(), None, &Progress::default());
    assert!(message(asked).starts_with("table: nine-ball needs a table with pockets"));
}

#[test]
fn a_stopped_map_leaves_the_rest_empty() {
    let progress = Progress::default();
    progress.stop();
    let model = ErrorModel::default();
    let map = pot_map(&cut(), TARGET, [3, 6], &model, &none(), None, &progress).expect("a map");
    assert!(map.chance.iter().all(|c| c.variants == 0) && map.chance.len() == 18);
}

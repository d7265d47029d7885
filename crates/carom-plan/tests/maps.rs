//! Maps are what single shots would say.

use carom::rack::{Break, Game, break_shot};
use carom::{Noise, Shot};
use carom_plan::Errs;
use carom_plan::maps::{Accepted, Approaches, acceptance, breaks, position_map, pot_map};

const TOP_RIGHT: usize = 5;

fn cut() -> Shot {
    let text = r#"{"format": "carom-shot/1", "table": "wpa-9ft",
        "balls": [{"id": "cue", "position": [0.5, 1.2]}, {"id": "1", "position": [0.9, 1.9]}],
        "strike": {"ball": "cue", "speed": 2.0, "azimuth_deg": 60.0}}"#;
    Shot::from_json(text).expect("a shot")
}

#[test]
fn pots_are_likely_from_behind_the_ball_and_impossible_from_before_it() {
    let errs = Errs { seed: 1, variants: 60, ..Errs::default() };
    let map = pot_map(&cut(), (1, TOP_RIGHT), [6, 12], &errs, None, &mut |_| true).expect("a map");
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
fn cells_that_are_nearly_certain_take_fewer_variants() {
    let errs = Errs { variants: 4000, half_width: Some(0.04), ..Errs::default() };
    let map = pot_map(&cut(), (1, TOP_RIGHT), [3, 6], &errs, None, &mut |_| true).expect("a map");
    let mut spent = Vec::new();
    for chance in map.chance.iter().filter(|c| c.variants > 0) {
        assert!(chance.interval(0.95).half_width() <= 0.04, "{chance:?}");
        spent.push(chance.variants);
    }
    let (least, most) = (spent.iter().min(), spent.iter().max());
    assert!(least < most && most < Some(&4000), "{least:?} {most:?}");
}

#[test]
fn every_position_of_the_map_is_where_the_shot_ends() {
    let shot = cut();
    let (speeds, spins) = ([1.5, 3.0], [[0.0, -0.3], [0.0, 0.0], [0.2, 0.3]]);
    let map =
        position_map(&shot, (1, TOP_RIGHT), &speeds, &spins, None, &mut |_| true).expect("a map");
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
        // The shot has its angles in degrees, which rounds them.
        assert!((end.x - map.end[cell][0]).abs() < 1e-6 && (end.y - map.end[cell][1]).abs() < 1e-6);
    }
}

#[test]
fn a_pocket_takes_less_of_what_comes_fast_and_aslant() {
    let offsets: Vec<f64> = (-30..=30).map(|k| 0.002 * f64::from(k)).collect();
    let approaches =
        Approaches { angles: &[0.0, 0.6], offsets: &offsets, speeds: &[0.8, 4.0], distance: 0.3 };
    let found = acceptance(&cut(), TOP_RIGHT, &approaches, None, &mut |_| true).expect("curves");
    let width = |row: usize| {
        let row = &found[row * offsets.len()..][..offsets.len()];
        row.iter().filter(|a| **a == Accepted::Falls).count()
    };
    // Aslant a slow ball rolls in along the rail, a fast one rattles.
    let [slow, _, fast, fast_aslant] = [0, 1, 2, 3].map(width);
    assert!(slow > fast && fast > fast_aslant, "{slow} {fast} {fast_aslant}");
    let middle = found[offsets.len() / 2];
    assert_eq!(middle, Accepted::Falls);
    // The corner is its own mirror image.
    let first: Vec<_> = found[..offsets.len()].to_vec();
    assert!(first.iter().eq(first.iter().rev()));
}

#[test]
fn a_ball_that_comes_back_from_around_the_table_is_not_taken() {
    // 61° is nearly the table's diagonal: off both cushions, to the other corner and back.
    let approaches = Approaches {
        angles: &[carom::math::radians(16.0)],
        offsets: &[-0.06, 0.0],
        speeds: &[4.0],
        distance: 0.3,
    };
    let found = acceptance(&cut(), TOP_RIGHT, &approaches, None, &mut |_| true).expect("curves");
    assert_eq!(found, [Accepted::Stays, Accepted::Falls]);
}

#[test]
fn breaks_without_noise_are_the_racks_own_ball_by_ball() {
    let opening = Break::new(Game::NineBall, 11);
    let all = breaks(&opening, &Noise::default(), 0, 20, None).expect("breaks");
    let columns = break_shot(&opening).expect("a break");
    let mut fell = 0;
    for k in 0..20 {
        let shot = break_shot(&Break::new(Game::NineBall, 11 + k)).expect("a break");
        let trace = shot.simulate().expect("a trace");
        let row = &all.pocket[k as usize * all.balls..][..all.balls];
        for (ball, pocket) in columns.balls().iter().zip(row) {
            let own = shot.ball_index(&ball.id).expect("the same balls") as u16;
            let potted = trace.outcome().pocketed.iter().any(|(i, _)| *i == own);
            assert_eq!(potted, *pocket >= 0, "rack {k}, ball {}", ball.id);
            fell += usize::from(potted);
        }
        assert_eq!(all.events[k as usize], trace.events().len() as i32);
    }
    assert!(fell > 0, "racks in which nothing falls test nothing");
}

#[test]
fn threads_change_nothing() {
    let noise = Noise::olympiad(2.0);
    let opening = Break::new(Game::EightBall, 5);
    let alone = breaks(&opening, &noise, 0, 20, Some(1)).expect("breaks");
    let together = breaks(&opening, &noise, 0, 20, Some(2)).expect("breaks");
    assert_eq!(alone.pocket, together.pocket);
    let later = breaks(&opening, &noise, 10, 10, None).expect("breaks");
    assert_eq!(alone.pocket[10 * alone.balls..], later.pocket);
}

//! Questions about a shot on tables of which each may be the true one.

use std::sync::LazyLock;

use carom::Shot;
use carom::noise::{Noise, Perception};
use carom::resolve::cue_ball::Strike;
use carom_plan::maps::{PotTarget, pot_map};
use carom_plan::{
    Chance, ChanceByTable, DrawnTables, ErrorModel, Evaluation, Goal, Progress, Question, Referee,
    Search, Watched, evaluate, solve,
};
use carom_rules::{Call, Frame, Game, Options};

const TOP_RIGHT: usize = 5;
const TARGET: PotTarget = PotTarget { ball: 1, pocket: TOP_RIGHT };
const CUT: &str = r#"[{"id": "cue", "position": [0.5, 1.2]}, {"id": "9", "position": [0.9, 1.9]}]"#;

/// A cut into the top right corner on a table of this rolling friction and length.
fn cut_on(friction: f64, length: f64) -> Shot {
    let file = format!(
        r#"{{"format": "carom-shot/1", "table": {{"base": "wpa-9ft", "length": {length}}},
        "physics": {{"base": "pool", "cloth": {{"rolling_friction": {friction}}}}}, "balls": {CUT},
        "strike": {{"ball": "cue", "speed": 2.0, "azimuth_deg": 57.0, "elevation_deg": 3.0}}}}"#
    );
    Shot::from_json(&file).expect("a shot")
}

/// The same at a speed that reaches the pocket only on a fast cloth.
fn slow(friction: f64) -> Shot {
    static AZIMUTH: LazyLock<f64> = LazyLock::new(|| {
        let goal = Goal { pot: Some((1, Some(TOP_RIGHT))), ..Goal::default() };
        let search = Search { samples: 0, wanted: 1, speed: [1.5, 2.0], ..Search::default() };
        let found = solve(&cut_on(0.011, 2.54), &goal, &search, &Progress::default());
        found.expect("solutions")[0].strike.azimuth
    });
    let shot = cut_on(friction, 2.54);
    let (_, strike) = shot.strike().expect("a strike");
    shot.with_strike(&Strike { speed: 0.85, azimuth: *AZIMUTH, ..strike }).expect("a shot")
}

fn tables(frictions: &[f64], of: impl Fn(f64) -> Shot) -> DrawnTables {
    DrawnTables::new(frictions.iter().map(|friction| of(*friction)).collect()).expect("tables")
}

fn spread(least: f64, most: f64, count: usize) -> Vec<f64> {
    let step = (most - least) / (count - 1) as f64;
    (0..count).map(|k| least + step * k as f64).collect()
}

fn model(variants: u64) -> ErrorModel {
    ErrorModel { seed: 7, variants, ..ErrorModel::default() }
}

fn answer(shot: &Shot, question: &Question<'_>) -> Evaluation {
    evaluate(shot, question, &Progress::default()).expect("an evaluation")
}

fn falls(evaluation: &Evaluation) -> ChanceByTable {
    evaluation.chance(|counts| counts.falls(1))
}

#[test]
fn tables_that_are_all_alike_give_the_result_of_the_shot_to_the_bit() {
    let shot = cut_on(0.011, 2.54);
    let alike = tables(&[0.011; 6], |friction| cut_on(friction, 2.54));
    for perception in [Perception::default(), Perception::round(0.001)] {
        let plain =
            Question { model: ErrorModel { perception, ..model(3000) }, ..Question::default() };
        let drawn = answer(&shot, &Question { tables: alike.clone(), ..plain.clone() });
        let plain = answer(&shot, &plain);
        assert_eq!(plain.counts, drawn.counts);
        assert_eq!((&plain.ends, &drawn.by_table), (&drawn.ends, &vec![]));
        assert_eq!(plain.interval(|c| c.falls(1)), drawn.interval(|c| c.falls(1)));
        let bits = |e: &Evaluation| -> Vec<u64> {
            e.cue_ball_ends.iter().flatten().map(|x| x.to_bits()).collect()
        };
        assert_eq!(bits(&plain), bits(&drawn));
    }
    let goal = Goal { pot: Some((1, None)), ..Goal::default() };
    let search = Search { model: model(200), samples: 256, ..Search::default() };
    let of =
        |search: &Search| solve(&shot, &goal, search, &Progress::default()).expect("solutions");
    assert_eq!(of(&search), of(&Search { tables: alike.clone(), ..search.clone() }));
    let map = |tables: &DrawnTables| {
        pot_map(&shot, TARGET, [4, 8], &model(60), tables, Some(1), &Progress::default())
            .expect("a map")
    };
    let (plain, drawn) = (map(&DrawnTables::default()), map(&alike));
    assert_eq!((plain.chance, plain.interval), (drawn.chance, drawn.interval));
}

#[test]
fn every_variant_is_the_one_of_its_number_on_its_table() {
    let frictions = [0.009, 0.011, 0.013];
    let shot = slow(0.011);
    for perception in [Perception::default(), Perception::round(0.001)] {
        let asked = Question {
            model: ErrorModel { perception: perception.clone(), ..model(90) },
            tables: tables(&frictions, slow),
            ..Question::default()
        };
        let found = answer(&shot, &asked);
        for threads in [1, 3] {
            assert_eq!(found, answer(&shot, &Question { threads: Some(threads), ..asked.clone() }));
        }
        // The same strikes, all of them on each table alone.
        let alone: Vec<Evaluation> = frictions
            .iter()
            .map(|friction| {
                let table = tables(&[*friction; 2], slow);
                answer(&shot, &Question { tables: table, ..asked.clone() })
            })
            .collect();
        for (k, end) in found.cue_ball_ends.iter().enumerate() {
            let same = alone[k % 3].cue_ball_ends[k];
            assert_eq!(end.map(f64::to_bits), same.map(f64::to_bits), "variant {k}");
        }
        let met = falls(&found);
        assert_eq!(met.0.iter().map(|c| c.variants).collect::<Vec<_>>(), [30, 30, 30]);
        assert_eq!(met.total().met, found.counts.falls(1));
    }
}

#[test]
fn a_number_that_decides_the_shot_widens_the_interval_and_sampling_cannot_shorten_it() {
    let shot = slow(0.011);
    let wide = |from, to| Question {
        model: ErrorModel { noise: Noise::olympiad(0.1), ..model(4000) },
        tables: tables(&spread(from, to, 32), slow),
        watched: Watched::Ball(1),
        ..Question::default()
    };
    let width = |question: &Question<'_>| {
        let found = answer(&shot, question);
        (found.interval(|counts| counts.falls(1)).half_width(), falls(&found))
    };
    let (narrow, _) = width(&wide(0.0110, 0.0111));
    let (broad, met) = width(&wide(0.006, 0.02));
    let decided = met.0.iter().filter(|c| c.met == 0 || c.met == c.variants).count();
    assert!(decided > 24, "the friction decides: {met:?}");
    assert!(broad > 0.12 && broad > 3.0 * narrow, "{broad} {narrow}");
    let precise = Question {
        model: ErrorModel { half_width: Some(0.05), ..wide(0.006, 0.02).model },
        ..wide(0.006, 0.02)
    };
    assert_eq!(answer(&shot, &precise).counts.variants, 4000);
    let certain = Question { tables: DrawnTables::default(), ..precise };
    assert!(answer(&shot, &certain).counts.variants < 4000);
}

/// The mean over the distribution from which tables are drawn is in the interval of a draw of 24
/// tables about as often as it says.
#[test]
fn intervals_over_drawn_tables_cover_the_mean_over_all_tables() {
    let shot = slow(0.011);
    let of = |frictions: &[f64], variants, seed| {
        answer(
            &shot,
            &Question {
                model: ErrorModel {
                    noise: Noise::olympiad(0.2),
                    seed,
                    level: 0.9,
                    ..model(variants)
                },
                tables: tables(frictions, slow),
                ..Question::default()
            },
        )
    };
    let all: Vec<f64> = spread(0.008, 0.026, 961);
    let truth = falls(&of(&all, 20 * 961, 99)).total().share();
    assert!(truth > 0.2 && truth < 0.8, "{truth}");
    let covered = (0..100_u64)
        .filter(|&k| {
            let mut state = k.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
            let mut unit = || {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(k | 1);
                (state >> 11) as f64 / (1_u64 << 53) as f64
            };
            let drawn: Vec<f64> = (0..24).map(|_| 0.008 + 0.018 * unit()).collect();
            let interval = of(&drawn, 480, k).interval(|counts| counts.falls(1));
            interval.low <= truth && truth <= interval.high
        })
        .count();
    // Three standard deviations of a binomial of 100 at 0.9 are 9.
    assert!((81..=99).contains(&covered), "{covered} of 100");
}

#[test]
fn strikes_are_ranked_by_their_chances_over_the_tables() {
    // Only on the fastest of four cloths does the softest strike reach the pocket.
    let goal = Goal { pot: Some((1, Some(TOP_RIGHT))), ..Goal::default() };
    let search = Search {
        model: ErrorModel { noise: Noise::olympiad(0.2), ..model(400) },
        speed: [0.8, 0.9],
        samples: 0,
        ..Search::default()
    };
    let shot = slow(0.008);
    let unsure = Search { tables: tables(&[0.008, 0.024, 0.025, 0.026], slow), ..search.clone() };
    let best = |search: &Search| {
        solve(&shot, &goal, search, &Progress::default()).expect("solutions")[0].clone()
    };
    let (sure, unsure) = (best(&search), best(&unsure));
    assert!(sure.chance.share() > 0.9, "{sure:?}");
    assert!(unsure.chance.share() < 0.5, "{unsure:?}");
    assert_eq!(unsure.by_table.0.len(), 4);
    assert!(unsure.by_table.0[0].share() > 0.9);
    assert!(unsure.interval.half_width() > 2.0 * sure.interval.half_width());
}

#[test]
fn a_cell_without_room_on_one_of_the_tables_has_no_chance() {
    // The top row of cells is 2.9 cm from the long table's cushion, and on the short one in it.
    let (long, short) = (cut_on(0.011, 2.54), cut_on(0.011, 2.53));
    let tables = DrawnTables::new(vec![long.clone(), short]).expect("tables");
    let cells = [2, 43];
    let map = |tables: &DrawnTables| {
        pot_map(&long, TARGET, cells, &model(8), tables, None, &Progress::default()).expect("a map")
    };
    let (plain, drawn) = (map(&DrawnTables::default()), map(&tables));
    let top = 42 * 2;
    assert!(plain.chance[top].variants == 8 && !plain.azimuth[top].is_nan());
    assert_eq!(drawn.chance[top], Chance::default());
    assert!(drawn.azimuth[top].is_nan());
    assert_eq!((drawn.interval[top].low, drawn.interval[top].high), (0.0, 1.0));
    assert!(drawn.chance[top - 2].variants == 8);
}

#[test]
fn a_referee_rules_on_the_variants_of_every_table() {
    let frame =
        Frame::of_shot(Game::NineBall, Options::default(), &slow(0.011), None).expect("a frame");
    let (_, strike) = slow(0.011).strike().expect("a strike");
    let shot = frame.shot(&carom_rules::Play::new(strike)).expect("a shot");
    let asked = Question {
        model: ErrorModel { noise: Noise::olympiad(0.2), ..model(400) },
        tables: tables(&[0.006, 0.02], slow),
        ..Question::default()
    };
    let referee = Some(Referee { frame: &frame, call: Call::Nothing });
    let (alone, ruled) =
        (answer(&shot, &asked), answer(&shot, &Question { referee, ..asked.clone() }));
    assert_eq!(falls(&alone), falls(&ruled));
    let kept = ruled.chance(|counts| counts.turn_kept.expect("a count"));
    assert!(kept.0[0].share() > 0.9 && kept.0[1].share() < 0.1, "{kept:?}");
    assert_eq!(kept.total().met, ruled.counts.turn_kept.expect("a count"));
}

#[test]
fn tables_of_another_shot_are_rejected() {
    let shot = cut_on(0.011, 2.54);
    let other = Shot::from_json(
        r#"{"format": "carom-shot/1", "table": "wpa-9ft", "balls": [{"id": "cue",
        "position": [0.5, 0.5]}], "strike": {"ball": "cue", "speed": 1.0, "azimuth": 0.0}}"#,
    );
    let faster = other.as_ref().expect("a shot").with_until(Some(1.0)).expect("a shot");
    let tables = DrawnTables::new(vec![other.expect("a shot"), faster]).expect("tables");
    let question = Question { tables: tables.clone(), ..Question::default() };
    let refused = evaluate(&shot, &question, &Progress::default()).expect_err("other balls");
    assert!(refused.to_string().starts_with("draws[0]: "), "{refused}");
    let (goal, search) =
        (Goal { first: Some(1), ..Goal::default() }, Search { tables, ..Search::default() });
    let refused = solve(&shot, &goal, &search, &Progress::default()).expect_err("other balls");
    assert!(refused.to_string().starts_with("draws[0]: "), "{refused}");
}

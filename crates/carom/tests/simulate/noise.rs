//! Execution noise: its distribution, its reproducibility, and strikes that cannot be played.

use std::fs;
use std::path::Path;

use carom::batch::{BatchResult, Variants, draw_strikes, simulate_strikes, simulate_variants};
use carom::noise::Perception;
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::{Noise, Shot};
use serde_json::{Value, from_str};

const RADIUS: f64 = 0.028_575;
const MEANT: Strike = Strike { speed: 3.0, azimuth: 1.0, elevation: 0.5, side: 0.1, height: -0.2 };

/// The errors of each parameter, in units of σ.
fn errors(noise: &Noise, seed: u64, count: u64) -> [Vec<f64>; 5] {
    let mut all: [Vec<f64>; 5] = Default::default();
    for index in 0..count {
        let s = noise.draw(&MEANT, RADIUS, seed, index);
        let errors = [
            (s.speed - MEANT.speed) / noise.speed,
            (s.azimuth - MEANT.azimuth) / noise.azimuth,
            (s.elevation - MEANT.elevation) / noise.elevation,
            (s.side - MEANT.side) * RADIUS / noise.side_m,
            (s.height - MEANT.height) * RADIUS / noise.height_m,
        ];
        for (column, error) in all.iter_mut().zip(errors) {
            column.push(error);
        }
    }
    all
}

fn mean(values: impl Iterator<Item = f64>, count: usize) -> f64 {
    values.sum::<f64>() / count as f64
}

#[test]
fn errors_are_gaussian_with_the_given_sigma() {
    const COUNT: usize = 100_000;
    // Five standard errors of each moment: correct deviates fail for one seed in a hundred
    // thousand.
    let five = 5.0 / (COUNT as f64).sqrt();
    for (name, column) in ["speed", "azimuth", "elevation", "side", "height"].iter().zip(errors(
        &Noise::olympiad(1.0),
        1,
        COUNT as u64,
    )) {
        let moment =
            |power| mean(column.iter().map(|e| (0..power).map(|_| e).product::<f64>()), COUNT);
        // The moments of a normal deviate and their variances: 0, 1; 1, 2; 0, 15; 3, 96.
        for (power, expected, variance) in
            [(1, 0.0, 1.0), (2, 1.0, 2.0), (3, 0.0, 15.0), (4, 3.0, 96.0_f64)]
        {
            let off = (moment(power) - expected).abs();
            assert!(off < five * variance.sqrt(), "{name}: moment {power} is off by {off}");
        }
        let beyond = column.iter().filter(|e| e.abs() > 1.959_964).count() as f64 / COUNT as f64;
        assert!((beyond - 0.05).abs() < five * 0.218, "{name}: {beyond} beyond 1.96 σ");
    }
}

#[test]
fn parameters_indices_and_seeds_have_independent_errors() {
    const COUNT: usize = 100_000;
    let five = 5.0 / (COUNT as f64).sqrt();
    let a = errors(&Noise::olympiad(1.0), 1, COUNT as u64);
    let b = errors(&Noise::olympiad(1.0), 2, COUNT as u64);
    let correlation = |x: &[f64], y: &[f64]| mean(x.iter().zip(y).map(|(x, y)| x * y), x.len());
    for i in 0..5 {
        for j in 0..i {
            assert!(correlation(&a[i], &a[j]).abs() < five, "parameters {i} and {j}");
        }
        assert!(correlation(&a[i], &b[i]).abs() < five, "two seeds, parameter {i}");
        assert!(correlation(&a[i][1..], &a[i][..COUNT - 1]).abs() < five, "neighbours, {i}");
    }
}

#[test]
fn changing_one_sigma_changes_no_other_parameter() {
    let all = Noise::olympiad(1.0);
    let still = Noise { speed: 0.0, ..all };
    for index in 0..100 {
        let [moved, kept] = [all, still].map(|n| n.draw(&MEANT, RADIUS, 7, index));
        assert_eq!(kept, Strike { speed: MEANT.speed, ..moved });
    }
    assert_eq!(Noise::default().draw(&MEANT, RADIUS, 7, 3), MEANT);
}

#[test]
fn a_level_cue_is_drawn_level_or_raised_but_never_lowered() {
    let level = Strike { elevation: 0.0, ..MEANT };
    let drawn: Vec<f64> =
        (0..1000).map(|k| Noise::olympiad(1.0).draw(&level, RADIUS, 0, k).elevation).collect();
    let flat = drawn.iter().filter(|e| **e == 0.0).count();
    assert!((400..600).contains(&flat), "{flat} of 1000 are level");
    assert!(drawn.iter().all(|e| *e >= 0.0));
}

fn shot(name: &str) -> Shot {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let text = fs::read_to_string(root.join(format!("shots/{name}.json"))).expect(name);
    Shot::from_json(&text).expect(name)
}

#[test]
fn variants_do_not_depend_on_the_number_of_threads_or_on_where_they_start() {
    let shot = shot("half_ball_cut");
    let noise = Noise::olympiad(2.0);
    let run = |first, n, threads| {
        let strikes = draw_strikes(&shot, &noise, n, 5, first).expect("drawn");
        simulate_strikes(&shot, &strikes, &Runner::new(Some(threads)).expect("threads"))
    };
    let whole = run(0, 200, 1);
    assert_eq!(run(0, 200, 2), whole);
    let tail = run(150, 50, 2);
    let width = shot.balls().len();
    assert_eq!(tail.final_position, whole.final_position[150 * width..]);
    assert_eq!(tail.events, whole.events[150..]);
}

/// A hundred variants of the shot's strike.
fn play(shot: &Shot, noise: &Noise) -> BatchResult {
    let strikes = draw_strikes(shot, noise, 100, 0, 0).expect("drawn");
    simulate_strikes(shot, &strikes, &Runner::default())
}

#[test]
fn strikes_that_cannot_be_played_fail_with_their_reason() {
    let mut file = shot("half_ball_cut").to_node();
    let mut strike = file.get("strike").expect("a strike").clone();
    // 0.01 radii inside the miscue limit of a tip with friction 0.6.
    strike.set("side", 0.5);
    file.set("strike", strike.clone());
    let edge = Shot::from_node(&file).expect("a shot");
    let noise = Noise { side_m: 0.002, ..Noise::default() };
    let result = play(&edge, &noise);
    assert!(result.errors.len() > 20, "{} miscues", result.errors.len());
    for (row, error) in &result.errors {
        assert!(error.to_string().contains("miscue"), "{error}");
        assert_eq!(result.events[*row], 0);
    }

    strike.set("miscue", "report");
    file.set("strike", strike);
    let reported = play(&Shot::from_node(&file).expect("a shot"), &noise);
    assert_eq!(reported.errors, []);

    let soft = Shot::with_strike(&edge, &Strike { speed: 0.01, side: 0.0, ..MEANT }).expect("soft");
    let noise = Noise::olympiad(1.0);
    let result = play(&soft, &noise);
    assert!(result.errors.len() > 30);
    assert!(result.errors.iter().all(|(_, e)| e.to_string().starts_with("strike.speed")));
}

#[test]
fn a_sigma_out_of_range_is_refused() {
    let shot = shot("half_ball_cut");
    for (noise, place) in [
        (Noise { speed: -0.1, ..Noise::default() }, "noise.speed"),
        (Noise { azimuth: f64::NAN, ..Noise::default() }, "noise.azimuth"),
        (Noise { elevation: 4.0, ..Noise::default() }, "noise.elevation"),
        (Noise { side_m: 0.5, ..Noise::default() }, "noise.side_m"),
        (Noise { height_m: f64::INFINITY, ..Noise::default() }, "noise.height_m"),
    ] {
        let error = draw_strikes(&shot, &noise, 1, 0, 0).expect_err(place);
        assert!(error.to_string().starts_with(place), "{error}");
    }
}

#[test]
fn the_goldens_of_noise_have_the_same_bits() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../goldens/noise.json");
    let goldens: Vec<Value> =
        from_str(&fs::read_to_string(path).expect("goldens/noise.json")).expect("JSON");
    assert!(!goldens.is_empty());
    for golden in &goldens {
        let whole = |key: &str| golden[key].as_u64().expect(key);
        let numbers = |value: &Value| -> Vec<f64> {
            value.as_array().expect("a list").iter().map(|x| x.as_f64().expect("f64")).collect()
        };
        let shot = shot(golden["shot"].as_str().expect("a name"));
        let noise = Noise::olympiad(golden["olympiad"].as_f64().expect("a number"));
        let variants = golden["variants"].as_array().expect("a list");
        let (seed, first) = (whole("seed"), whole("first"));
        let strikes = draw_strikes(&shot, &noise, variants.len(), seed, first).expect("drawn");
        let ends = simulate_strikes(&shot, &strikes, &Runner::default());
        for (k, (s, variant)) in strikes.iter().zip(variants).enumerate() {
            let drawn = vec![s.speed, s.azimuth, s.elevation, s.side, s.height];
            assert_eq!(drawn, numbers(&variant["strike"]), "see goldens/README.md");
            assert_eq!(ends.events[k], variant["events"].as_i64().expect("a count") as i32);
            let cue = ends.final_position[k * ends.balls];
            assert_eq!(cue.to_vec(), numbers(&variant["final"]), "see goldens/README.md");
        }
    }
}

#[test]
fn more_strikes_than_fit_in_memory_are_refused() {
    let error = draw_strikes(&shot("half_ball_cut"), &Noise::default(), usize::MAX, 0, 0);
    let sentence = error.expect_err("too many").to_string();
    assert!(sentence.starts_with("n: 18446744073709551615 strikes are too many"), "{sentence}");
}

#[test]
fn a_shot_without_a_strike_has_no_strike_to_vary() {
    let shot = shot("half_ball_cut");
    let strikes = [shot.strike().expect("a strike").1];
    let without = shot.with_balls(shot.balls().to_vec(), None).expect("the balls are valid");
    let drawn = draw_strikes(&without, &Noise::default(), 1, 0, 0).map(|_| ());
    let perception = Perception { position: 1e-3 };
    let variants = Variants { perception, ..Variants::default() };
    let runner = Runner::default();
    let seen = simulate_variants(&without, &strikes, &variants, &runner).map(|_| ());
    for result in [drawn, seen] {
        let sentence = result.expect_err("no strike").to_string();
        assert!(sentence.starts_with("strike: the shot has no strike to vary"), "{sentence}");
    }
}

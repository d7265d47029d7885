//! Execution noise: its distribution, its reproducibility, and strikes that cannot be played.

use std::fs;
use std::path::Path;

use carom::batch::{BatchResult, draw_strikes, simulate_strikes, simulate_variants};
use carom::noise::{Errors, OFFSET_KEPT, Perception, SLOWEST, STEEPEST, StruckBall};
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::{Noise, Shot};
use serde_json::{Value, from_str};

const RADIUS: f64 = 0.028_575;
/// A ball whose tip offsets have no limit but the ball.
const BALL: StruckBall = StruckBall { radius: RADIUS, largest_offset: 1.0 };
const MEANT: Strike = Strike { speed: 3.0, azimuth: 1.0, elevation: 0.5, side: 0.1, height: -0.2 };

/// The errors of each parameter, in units of σ.
fn errors(noise: &Noise, seed: u64, count: u64) -> [Vec<f64>; 5] {
    let mut all: [Vec<f64>; 5] = Default::default();
    for index in 0..count {
        let s = noise.draw(&MEANT, &BALL, seed, index);
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
    let still = Noise { speed: 0.0, ..all.clone() };
    for index in 0..100 {
        let [moved, kept] = [&all, &still].map(|n| n.draw(&MEANT, &BALL, 7, index));
        assert_eq!(kept, Strike { speed: MEANT.speed, ..moved });
    }
    assert_eq!(Noise::default().draw(&MEANT, &BALL, 7, 3), MEANT);
}

#[test]
fn a_level_cue_is_drawn_level_or_raised_but_never_lowered() {
    let level = Strike { elevation: 0.0, ..MEANT };
    let drawn: Vec<f64> =
        (0..1000).map(|k| Noise::olympiad(1.0).draw(&level, &BALL, 0, k).elevation).collect();
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

/// The shot `half_ball_cut` with another strike, which plays miscues if `miscue` is "report".
fn cut(strike: &Strike, miscue: &str) -> Shot {
    let mut file = shot("half_ball_cut").to_node();
    let mut own = file.get("strike").expect("a strike").clone();
    own.set("miscue", miscue);
    for (key, value) in [("side", strike.side), ("height", strike.height), ("speed", strike.speed)]
    {
        own.set(key, value);
    }
    own.set("elevation_deg", carom::math::degrees(strike.elevation));
    file.set("strike", own);
    Shot::from_node(&file).expect("a shot")
}

#[test]
fn an_offset_beyond_the_miscue_limit_is_moved_back_along_its_direction() {
    let noise = Noise { side_m: 0.004, height_m: 0.004, ..Noise::default() };
    let limit = shot("half_ball_cut").miscue_limit();
    for (miscue, limit, share) in [("refuse", limit, 0.95), ("report", 1.0, 0.9)] {
        let out = share * limit;
        let edge = Strike { side: 0.6 * out, height: -0.8 * out, elevation: 0.0, ..MEANT };
        let shot = cut(&edge, miscue);
        let (ball, meant) = shot.strike().expect("a strike");
        let struck = StruckBall::of(&shot, &shot.balls()[ball].ball);
        assert_eq!(struck.largest_offset, OFFSET_KEPT * limit, "{miscue}");
        let unlimited = StruckBall { largest_offset: 10.0, ..struck };
        let (mut moved, mut kept) = (0, 0);
        for index in 0..400 {
            let free = noise.draw(&meant, &unlimited, 3, index);
            let drawn = noise.draw(&meant, &struck, 3, index);
            shot.resolve_strike(&drawn).expect("it can be played");
            if free.offset() <= struck.largest_offset {
                assert_eq!(drawn, free);
                kept += 1;
            } else {
                assert!((drawn.offset() - struck.largest_offset).abs() < 1e-15, "{drawn:?}");
                let across = drawn.side * free.height - drawn.height * free.side;
                assert!(across.abs() < 1e-15, "{drawn:?} is in another direction than {free:?}");
                moved += 1;
            }
        }
        assert!(moved > 50 && kept > 50, "{miscue}: {moved} moved, {kept} kept");
    }
}

#[test]
fn a_speed_and_an_elevation_stay_within_their_limits() {
    let noise = Noise { speed: 5.0, elevation: 0.3, ..Noise::default() };
    let steep = Strike { speed: 0.5, elevation: 1.4, ..MEANT };
    let fast = Strike { speed: 49.0, elevation: 0.1, ..MEANT };
    for (meant, speed, elevation) in [(steep, SLOWEST, STEEPEST), (fast, 50.0, 0.0)] {
        let (mut at_speed, mut at_elevation) = (0, 0);
        for index in 0..400 {
            let drawn = noise.draw(&meant, &BALL, 3, index);
            assert!((SLOWEST..=50.0).contains(&drawn.speed), "{}", drawn.speed);
            assert!((0.0..=STEEPEST).contains(&drawn.elevation), "{}", drawn.elevation);
            at_speed += usize::from(drawn.speed == speed);
            at_elevation += usize::from(drawn.elevation == elevation);
        }
        assert!((50..350).contains(&at_speed), "{at_speed} at {speed} m/s");
        assert!((50..350).contains(&at_elevation), "{at_elevation} at {elevation} rad");
    }
}

#[test]
fn a_parameter_without_errors_stays_as_intended_at_its_limit_too() {
    let edge = Strike { speed: 0.004, azimuth: 1.0, elevation: 1.56, side: -0.0, height: 0.514 };
    let struck = StruckBall { radius: RADIUS, largest_offset: OFFSET_KEPT * 0.514 };
    let bits = |s: Strike| [s.speed, s.azimuth, s.elevation, s.side, s.height].map(f64::to_bits);
    let drawn = Noise::default().draw(&edge, &struck, 1, 2);
    assert_eq!(bits(drawn), bits(edge));
    let turned = Noise { azimuth: 0.1, ..Noise::default() }.draw(&edge, &struck, 1, 2);
    assert_eq!(bits(Strike { azimuth: edge.azimuth, ..turned }), bits(edge));
    assert_ne!(turned.azimuth, edge.azimuth);
}

#[test]
fn every_variant_of_a_strike_at_its_limits_is_played() {
    let limit = shot("half_ball_cut").miscue_limit();
    for (speed, side, elevation) in [(0.02, limit, 0.0), (2.0, -limit, 1.5), (0.005, 0.0, 1.0)] {
        let edge = Strike { speed, side, height: 0.0, elevation, ..MEANT };
        let result = play(&cut(&edge, "refuse"), &Noise::preset("beginner").expect("a preset"));
        assert_eq!(result.errors, []);
    }
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
    let perception = Perception::round(1e-3);
    let errors = Errors { perception, ..Errors::default() };
    let runner = Runner::default();
    let seen = simulate_variants(&without, &strikes, &errors, 0, &runner).map(|_| ());
    for result in [drawn, seen] {
        let sentence = result.expect_err("no strike").to_string();
        assert!(sentence.starts_with("strike: the shot has no strike to vary"), "{sentence}");
    }
}

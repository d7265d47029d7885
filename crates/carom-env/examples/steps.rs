//! Measures the steps per second of a vector of environments, as `carom.bench.environments` does,
//! but without Python.
//!
//! `cargo run --release -p carom-env --example steps -- eight-ball 4096 100 [threads] [noise] [opponent]`
//!
//! 0 threads are one for each core.

use std::time::Instant;

use carom::{Error, Noise};
use carom_env::{Aim, Config, Opponent, Task, VectorEnv};

fn main() -> Result<(), Error> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let argument =
        |k: usize, usual: &str| arguments.get(k).map_or(usual, |a| a.as_str()).to_owned();
    let number = |k: usize, usual: &str| argument(k, usual).parse::<usize>().unwrap_or_default();
    let task = Task::read(&argument(0, "eight-ball"))?;
    let (n, steps, threads) = (number(1, "4096"), number(2, "20"), number(3, "0"));
    let noise = argument(4, "1").parse().unwrap_or(1.0);
    let balls = matches!(task.name(), "eight-ball" | "nine-ball" | "potting").then_some([4, 9]);
    let config = Config {
        noise: Noise::olympiad(noise),
        aim: Aim::Relative,
        max_elevation: 0.0,
        balls,
        opponent: Opponent::read(&argument(5, "none"))?,
        threads: (threads > 0).then_some(threads),
        ..Config::of(task)
    };
    let mut vector = VectorEnv::new(task, n, 0, config)?;
    vector.reset(None, None)?;
    // A linear congruential generator is good enough for arbitrary actions.
    let mut state = 1_u64;
    let mut random = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1 << 23) as f32 - 1.0
    };
    let actions: Vec<Vec<f32>> =
        (0..steps).map(|_| (0..n * vector.action_size()).map(|_| random()).collect()).collect();
    let start = Instant::now();
    let (mut earned, mut ended, mut truncated) = (0.0, 0, 0);
    for actions in &actions {
        let out = vector.step(actions)?;
        earned += out.rewards.iter().sum::<f64>();
        ended += out.terminated.iter().filter(|&&ended| ended).count();
        truncated += out.truncated.iter().filter(|&&truncated| truncated).count();
    }
    let seconds = start.elapsed().as_secs_f64();
    println!(
        "{}: {:.0} steps/s ({earned:.1} earned, {ended} ended, {truncated} truncated)",
        task.name(),
        (n * steps) as f64 / seconds
    );
    Ok(())
}

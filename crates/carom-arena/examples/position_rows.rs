//! The features of every position of recorded matches, and who won: the data to which
//! `scripts/fit_values.py` fits the weights of the logistic regression.
//!
//! ```sh
//! cargo run --release -p carom-arena --example position_rows -- RECORD ... > eight-ball.csv
//! ```
//!
//! The words are records of finished matches (`carom match`). Rows of both frames of a pair have the
//! same number, because they have the same rack.

use std::error::Error;

use carom::runner::Runner;
use carom_arena::{Ask, positions};
use carom_mind::value::{Features, Markov, Position, Value, features};

fn main() -> Result<(), Box<dyn Error>> {
    let runner = Runner::new(None)?;
    println!("pair,azimuth,seat,won,chain,{}", features::NAMES.join(","));
    let mut first = 0;
    for path in std::env::args().skip(1) {
        let text = std::fs::read_to_string(&path)?;
        let frames = positions(&text, &runner, seen)?;
        let count = frames.len() as u64;
        for (number, (rows, end)) in (0..).zip(frames) {
            for (seat, [azimuth, chain], row) in rows.into_iter().flatten() {
                let won = end.winner.map_or(0.5, |winner| f64::from(u8::from(winner == seat)));
                let numbers: Vec<String> = row.0.iter().map(|x| format!("{x:.5}")).collect();
                let pair = first + number / 2;
                println!("{pair},{azimuth},{seat},{won},{chain:.5},{}", numbers.join(","));
            }
        }
        first += count / 2;
    }
    Ok(())
}

/// The seat, the error of its direction (rad), its chance of winning by the Markov chain, and the features
/// of a request for a shot. `None` for opening shots, which the regression does not value.
fn seen(ask: &Ask<'_>) -> Option<(usize, [f64; 2], Features)> {
    let frame = ask.situation.frame;
    let turn = frame.turn().filter(|_| !frame.is_opening())?;
    let noise = &ask.situation.noise;
    let position = Position { frame, noise };
    let chain = Markov::default().of_shot(&position, turn);
    Some((ask.seat, [noise[turn.player].azimuth, chain], Features::of(&position, turn)))
}

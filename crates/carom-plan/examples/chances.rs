//! Evaluates the shots of a file, one in a line, so many variants of each: what `benches/questions.py`
//! counts the instructions of.
//!
//!     cargo run --release -p carom-plan --example chances -- SHOTS VARIANTS

use std::process::exit;

use carom::noise::Perception;
use carom::{Noise, Shot};
use carom_plan::{Question, evaluate};

fn main() {
    let given: Vec<String> = std::env::args().skip(1).collect();
    let [file, variants] = given.as_slice() else {
        eprintln!("give SHOTS and VARIANTS");
        exit(2);
    };
    match run(file, variants) {
        Ok(fell) => println!("{fell}"),
        Err(error) => {
            eprintln!("{error}");
            exit(2);
        }
    }
}

/// How many balls fell in all.
fn run(file: &str, variants: &str) -> Result<u64, Box<dyn std::error::Error>> {
    let question = Question {
        noise: Noise::olympiad(1.0),
        perception: Perception::default(),
        seed: 0,
        most: variants.parse()?,
        level: 0.95,
        precision: None,
        referee: None,
        // Valgrind runs one thread at a time.
        threads: Some(1),
    };
    let mut fell = 0;
    for line in std::fs::read_to_string(file)?.lines() {
        let shot = Shot::from_json(line)?;
        fell += evaluate(&shot, &question, &mut |_| true)?.potted.iter().sum::<u64>();
    }
    Ok(fell)
}

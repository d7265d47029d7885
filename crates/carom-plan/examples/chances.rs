//! Evaluates the shots of a file, one per line, with a number of variants each.
//! `benches/questions.py` counts its instructions.
//!
//!     cargo run --release -p carom-plan --example chances -- SHOTS VARIANTS

use std::process::exit;

use carom::Shot;
use carom_plan::{ErrorModel, Progress, Question, evaluate};

fn main() {
    let given: Vec<String> = std::env::args().skip(1).collect();
    let [file, variants] = given.as_slice() else {
        eprintln!("usage: chances SHOTS VARIANTS");
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

/// The number of balls that fell in all variants.
fn run(file: &str, variants: &str) -> Result<u64, Box<dyn std::error::Error>> {
    let question = Question {
        model: ErrorModel { variants: variants.parse()?, ..ErrorModel::default() },
        // Valgrind runs one thread at a time.
        threads: Some(1),
        ..Question::default()
    };
    let mut fell = 0;
    for line in std::fs::read_to_string(file)?.lines() {
        let shot = Shot::from_json(line)?;
        fell += evaluate(&shot, &question, &Progress::default())?.counts.potted.iter().sum::<u64>();
    }
    Ok(fell)
}

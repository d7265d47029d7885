//! Counts the operations of the engine in the shots of a file, one `carom-shot/1` per line, and
//! prints the sums as JSON. `scripts/count_operations.py` runs it on the shots of the benchmarks.
//!
//! `cargo run --release -p carom-peers --example operations -- FILE`

use std::error::Error;

use carom::Shot;
use carom_peers::operations::Operations;

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args().nth(1).ok_or("usage: operations FILE")?;
    let text = std::fs::read_to_string(file)?;
    let mut shots = 0;
    let mut sum = Operations::default();
    for line in text.lines() {
        let counts = Operations::of(&Shot::from_json(line)?).map_err(|e| format!("{e:?}"))?;
        sum = sum.with(counts);
        shots += 1;
    }
    println!(
        r#"{{"shots": {shots}, "events": {}, "moving": {}, "pairs": {}, "looked_at": {}, "solved": {}, "advanced": {}, "searched": {}, "clear": {}, "operations": {{"by steps of 1 ms": {:.0}, "the paper's events": {}, "carom": {}}}}}"#,
        sum.events,
        sum.moving,
        sum.pairs,
        sum.looked_at,
        sum.solved,
        sum.advanced,
        sum.searched,
        sum.clear,
        sum.by_steps,
        sum.of_the_paper(),
        sum.of_the_engine(),
    );
    Ok(())
}

//! Counts the operations of the engine in the shots of a file, one `carom-shot/1` per line, and
//! prints the sums as JSON. `scripts/count_operations.py` runs it on the shots of the benchmarks.
//!
//! `cargo run --release -p carom-peers --example operations -- FILE`

use std::error::Error;

use carom::Shot;
use carom_peers::operations::{EVENT_KINDS, Operations};

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args().nth(1).ok_or("usage: operations FILE")?;
    let text = std::fs::read_to_string(file)?;
    let mut shots = 0_u64;
    let mut sum = Operations::default();
    for line in text.lines() {
        let counts = Operations::of(&Shot::from_json(line)?).map_err(|e| format!("{e:?}"))?;
        sum = sum.with(counts);
        shots += 1;
    }
    let by_kind: Vec<String> = EVENT_KINDS
        .iter()
        .zip(sum.by_kind)
        .map(|(name, count)| format!(r#""{name}": {count}"#))
        .collect();
    let counts = [
        ("shots", shots),
        ("events", sum.events),
        ("network_balls", sum.network_balls),
        ("moving", sum.moving),
        ("pairs", sum.pairs),
        ("looked_at", sum.looked_at),
        ("solved", sum.solved),
        ("advanced", sum.advanced),
        ("searched", sum.searched),
        ("clear", sum.clear),
        ("searched_off_bed", sum.searched_off_bed),
    ]
    .map(|(name, count)| format!(r#""{name}": {count}"#));
    println!(
        r#"{{{}, "by_kind": {{{}}}, "operations": {{"by steps of 1 ms": {:.0}, "the paper's events": {}, "carom": {}}}}}"#,
        counts.join(", "),
        by_kind.join(", "),
        sum.by_steps,
        sum.of_the_paper(),
        sum.of_the_engine(),
    );
    Ok(())
}

//! Plays the shots of a file (one `carom-shot/1` per line) a number of times, on one core and
//! without traces, and prints the number of shots and events of one pass. `benches/instructions.py`
//! counts its instructions; it is also suitable for a profiler.
//!
//! ```sh
//! cargo run --profile bench --example bench_shots -- shots.jsonl 1000
//! ```
//!
//! A third number is how often each shot is played before the next one.

use std::error::Error;

use carom::Shot;
use carom::event::NullRecorder;
use carom::limits::SMALL_CAPACITY;
use carom::simulate::Simulation;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (file, passes, repeats) = match arguments.as_slice() {
        [file, passes] => (file, passes, "1"),
        [file, passes, repeats] => (file, passes, repeats.as_str()),
        _ => return Err("usage: bench_shots FILE PASSES [REPEATS]".into()),
    };
    let (passes, repeats): (u32, u32) = (passes.parse()?, repeats.parse()?);
    let text = std::fs::read_to_string(file)?;
    let shots = text.lines().map(Shot::from_json).collect::<Result<Vec<_>, _>>()?;
    let mut simulation = Box::new(Simulation::<SMALL_CAPACITY>::new());
    let mut events = 0;
    for _ in 0..passes {
        events = 0;
        for shot in &shots {
            for _ in 1..repeats {
                simulation.play(shot, &mut NullRecorder)?;
            }
            events += simulation.play(shot, &mut NullRecorder)?.events;
        }
    }
    println!("{} {events}", shots.len());
    Ok(())
}

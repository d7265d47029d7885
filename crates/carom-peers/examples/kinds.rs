//! Does every kind of impact and search of [`carom_peers::kinds`] once, and prints a line of JSON for
//! each: group, name, and number of inputs. `benches/operation_kinds.py` runs it under valgrind's
//! callgrind, which counts within `counted_pass` and writes the counts of a kind after
//! `end_of_kind`.
//!
//! `cargo run --release -p carom-peers --example kinds`

use std::hint::black_box;

use carom_peers::kinds;

fn main() {
    for kind in kinds::all() {
        let (group, name, inputs) = (kind.group, &kind.name, kind.inputs);
        println!(r#"{{"group": "{group}", "name": "{name}", "inputs": {inputs}}}"#);
        kind.counted_pass();
        end_of_kind();
    }
}

/// Marks the end of a kind for callgrind.
#[inline(never)]
fn end_of_kind() {
    black_box(0);
}

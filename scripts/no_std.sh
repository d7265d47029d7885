#!/usr/bin/env bash
# Checks that the engine builds without the standard library, natively and for WebAssembly, and that
# the planning crate builds without threads, for a page.
# usage: scripts/no_std.sh
set -euo pipefail

wasm=wasm32-unknown-unknown
check=(cargo check --quiet -p carom-roots -p carom --no-default-features)

"${check[@]}"
"${check[@]}" --target "$wasm"
# With files, without threads.
cargo check --quiet -p carom --no-default-features --features json --target "$wasm"
cargo check --quiet -p carom-plan --no-default-features --target "$wasm"

#!/usr/bin/env bash
# Checks that the engine builds without the standard library, and for WebAssembly where that target
# is installed. usage: scripts/no_std.sh
set -euo pipefail

wasm=wasm32-unknown-unknown
check=(cargo check --quiet -p carom-roots -p carom --no-default-features)

"${check[@]}"
if [ -d "$(rustc --print target-libdir --target "$wasm")" ]; then
    "${check[@]}" --target "$wasm"
    # With files, without threads.
    cargo check --quiet -p carom --no-default-features --features json --target "$wasm"
else
    echo "Not checked for $wasm: rustup target add $wasm"
fi

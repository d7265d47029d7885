#!/usr/bin/env bash
# Checks the builds that the workspace as a whole hides, because cargo gives a crate the features that any other
# one asks for: the engine without the standard library, natively and for WebAssembly; the planning crate without
# threads, for a page; and each published crate alone, with the features that its users get.
# usage: scripts/crate_builds.sh
set -euo pipefail

wasm=wasm32-unknown-unknown
check=(cargo check --quiet -p carom-roots -p carom --no-default-features)

"${check[@]}"
"${check[@]}" --target "$wasm"
# With files, without threads.
cargo check --quiet -p carom --no-default-features --features json --target "$wasm"
cargo check --quiet -p carom-plan --no-default-features --target "$wasm"

for manifest in $(grep -L '^publish = false' crates/*/Cargo.toml); do
    crate=$(basename "$(dirname "$manifest")")
    cargo check --quiet -p "$crate" || {
        echo "The crate $crate does not build alone: ask for the missing feature in $manifest." >&2
        exit 1
    }
done

#!/usr/bin/env bash
# Runs every fuzz target for a while. usage: scripts/fuzz.sh [SECONDS], by default 600 each
set -euo pipefail

seconds=${1:-600}
if ! cargo +nightly fuzz --version > /dev/null 2>&1; then
    echo "Not run: the fuzz targets need a nightly compiler and cargo-fuzz:"
    echo "  rustup toolchain install nightly && cargo install cargo-fuzz"
    exit 0
fi
for target in $(cargo +nightly fuzz list); do
    echo "Fuzz target $target, $seconds s:"
    cargo +nightly fuzz run "$target" -- "-max_total_time=$seconds"
done

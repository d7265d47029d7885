#!/usr/bin/env bash
# Runs every fuzz target for a while. Each begins with the inputs that are kept in fuzz/corpus, and the parser
# with the example shots, too. `keep` then stores the smallest set of inputs that covers the same code.
# usage: scripts/fuzz.sh [SECONDS] [keep], by default 600 each
set -euo pipefail

seconds=${1:-600}
keep=${2:-}
if ! cargo +nightly fuzz --version > /dev/null 2>&1; then
    echo "Not run: the fuzz targets need a nightly compiler and cargo-fuzz:"
    echo "  rustup toolchain install nightly && cargo install cargo-fuzz"
    exit 0
fi
inputs=$(mktemp -d)
trap 'rm -r "$inputs"' EXIT
for target in $(cargo +nightly fuzz list); do
    echo "Fuzz target $target, $seconds s:"
    kept=fuzz/corpus/$target.tar.xz
    folder=$inputs/$target
    mkdir "$folder"
    if [ -f "$kept" ]; then tar -C "$folder" -xf "$kept"; fi
    # New inputs go to the first folder.
    folders=("$folder")
    if [ "$target" = shot_parser ]; then folders+=(shots); fi
    cargo +nightly fuzz run "$target" "${folders[@]}" -- "-max_total_time=$seconds" -max_len=4096
    if [ "$keep" = keep ]; then
        cargo +nightly fuzz cmin "$target" "$folder"
        tar -C "$folder" --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner -cJf "$kept" .
    fi
done

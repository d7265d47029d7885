#!/usr/bin/env bash
# Builds a wheel of this checkout, with the page if `make page` has built it. It is made so that the same commit
# gives the same bytes in every folder, which `make release` checks.
# usage: scripts/wheel.sh OUT [options of maturin, such as --target aarch64-unknown-linux-gnu --zig]
set -euo pipefail
cd "$(dirname "$0")/.."
out=$1
shift

CAROM_COMMIT=$(git rev-parse HEAD 2>/dev/null || true)
if [ -n "$CAROM_COMMIT" ]; then
    [ -z "$(git status --porcelain --untracked-files=no)" ] || CAROM_COMMIT+=+
    SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
    export CAROM_COMMIT SOURCE_DATE_EPOCH
fi
# Paths of this machine do not belong into a library that others load.
home=${CARGO_HOME:-$HOME/.cargo}
export RUSTFLAGS="${RUSTFLAGS:-} --remap-path-prefix=$PWD=carom --remap-path-prefix=$home/registry/src=registry"
# With other flags cargo would build everything again for the tests.
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-target/wheel}
built=$(mktemp -d)
trap 'rm -rf "$built"' EXIT
maturin build --release --locked --out "$built" "$@"
python scripts/wheel_bills.py "$built"/*.whl
mkdir -p "$out"
mv "$built"/*.whl "$out"

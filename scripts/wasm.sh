#!/usr/bin/env bash
# Builds the engine for browsers into web/src/engine/pkg: the WebAssembly, wasm-bindgen's glue, and
# the same WebAssembly as a string in a module, which every bundler, Node and a page opened from disk
# can load alike. usage: scripts/wasm.sh
set -euo pipefail
cd "$(dirname "$0")/.."
me=scripts/wasm.sh

target=wasm32-unknown-unknown
out=web/src/engine/pkg
tool=scripts/wasm_bindgen
bash scripts/prerequisites.sh page

# The glue and the WebAssembly must be of the same version.
version() { awk -v name="name = \"$1\"" '$0 == name { getline; gsub(/"/, "", $3); print $3 }' "$2"; }
wanted=$(version wasm-bindgen Cargo.lock)
found=$(version wasm-bindgen-cli-support $tool/Cargo.lock)
if [ "$wanted" != "$found" ]; then
    echo "carom: Cargo.lock has wasm-bindgen $wanted, $tool/Cargo.lock has $found; write \"=$wanted\" into $tool/Cargo.toml and run: cargo update --manifest-path $tool/Cargo.toml" >&2
    exit 1
fi
cargo build --quiet --locked --manifest-path $tool/Cargo.toml --target-dir target/tools
glue=target/tools/debug/carom-wasm-bindgen

# simd128 is in every browser since Safari 16.4 (2023). A search of a player within a search needs more than
# the usual stack of 1 MiB; beyond its end the memory of the engine would be overwritten.
RUSTFLAGS="-C target-feature=+simd128 -C link-arg=-zstack-size=4194304" \
    cargo build --quiet --profile wasm -p carom-wasm --target "$target"
wasm=${CARGO_TARGET_DIR:-target}/$target/wasm/carom_wasm.wasm

if [ ! "$out/embedded.js" -nt "$wasm" ] || [ ! "$out/embedded.js" -nt "$me" ]; then
    mkdir -p "$out"
    $glue "$wasm" "$out"
    {
        echo "// The WebAssembly, gzip, in Base64: a third of its size."
        echo "export default \"$(gzip -9 -n < "$out/carom_wasm_bg.wasm" | base64 | tr -d '\n')\";"
    } > "$out/embedded.js"
    echo "declare const base64: string; export default base64;" > "$out/embedded.d.ts"
fi

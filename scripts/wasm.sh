#!/usr/bin/env bash
# Builds the engine for browsers into web/src/engine/pkg: the WebAssembly, wasm-bindgen's glue, and
# the same WebAssembly as a string in a module, which every bundler, Node and a page opened from disk
# can load alike. usage: scripts/wasm.sh
set -euo pipefail
cd "$(dirname "$0")/.."
me=scripts/wasm.sh

missing() { echo "carom: $1" >&2; exit 1; }

target=wasm32-unknown-unknown
out=web/src/engine/pkg
tools=target/tools
[ -d "$(rustc --print target-libdir --target "$target")" ] ||
    missing "Rust's standard library for WebAssembly is missing; rustup target add $target."

# Glue and WebAssembly must be of the very version that the crate is built with.
version=$(awk '/^name = "wasm-bindgen"$/ { getline; gsub(/"/, "", $3); print $3 }' Cargo.lock)
export PATH="$PWD/$tools/bin:$PATH"
if [ "$(wasm-bindgen --version 2>/dev/null)" != "wasm-bindgen $version" ]; then
    echo "Installing wasm-bindgen $version (minutes, once) ..." >&2
    cargo install --quiet --root "$tools" wasm-bindgen-cli --version "=$version"
fi

# simd128 is in every browser since Safari 16.4 (2023).
RUSTFLAGS="-C target-feature=+simd128" \
    cargo build --quiet --profile wasm -p carom-wasm --target "$target"
wasm=${CARGO_TARGET_DIR:-target}/$target/wasm/carom_wasm.wasm

if [ ! "$out/embedded.js" -nt "$wasm" ] || [ ! "$out/embedded.js" -nt "$me" ]; then
    mkdir -p "$out"
    wasm-bindgen "$wasm" --target web --omit-default-module-path --remove-name-section --out-dir "$out"
    {
        echo "// The WebAssembly, gzip, in Base64: a third of its size."
        echo "export default \"$(gzip -9 -n < "$out/carom_wasm_bg.wasm" | base64 | tr -d '\n')\";"
    } > "$out/embedded.js"
    echo "declare const base64: string; export default base64;" > "$out/embedded.d.ts"
fi

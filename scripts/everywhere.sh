#!/usr/bin/env bash
# Compares the bits on other processors. On aarch64 and riscv64, under qemu: the goldens of every example shot,
# and with `all` the engine's other tests and 10 000 random shots. On wasm32, in Node and Chromium, with and without
# SIMD: the random shots (`make test` compares the goldens in Node and in Chromium).
# usage: scripts/everywhere.sh [goldens|all] [aarch64|riscv64|wasm32 ...]
set -euo pipefail

what=${1:-goldens}
shift || true
processors=("${@:-aarch64 riscv64 wasm32}")
# shellcheck disable=SC2128,SC2206 # the default is two words
processors=($processors)

# The hashes of the random shots on wasm32, by WASI: it gives the tests their files.
wasm32() {
    local target=wasm32-wasip1 features runner runners=("node --no-warnings $PWD/scripts/wasi.mjs")
    if ! command -v node > /dev/null || ! rustc --print target-libdir --target "$target" | xargs test -d; then
        echo "Not run for wasm32: it needs Node and the Rust target (rustup target add $target)"
        return
    fi
    if [ -d web/node_modules ] && bash scripts/prerequisites.sh has-chromium; then
        runners+=("node $PWD/web/scripts/wasi_chromium.js")
    else
        echo "Not run for wasm32 in Chromium: it needs Chromium and the page's packages (make page)"
    fi
    for features in -simd128 +simd128; do
        for runner in "${runners[@]}"; do
            echo "Random shots on wasm32 with $features, by ${runner##*/}:"
            CARGO_TARGET_WASM32_WASIP1_RUNNER=$runner \
                RUSTFLAGS="-C target-feature=$features" CARGO_TARGET_DIR="target/wasm32$features" \
                cargo test --quiet --target "$target" --profile release-tests -p carom-check --test random_hashes
        done
    done
}

for processor in "${processors[@]}"; do
    case $processor in
        wasm32)
            wasm32
            continue
            ;;
        aarch64) target=aarch64-unknown-linux-gnu gcc=aarch64-linux-gnu ;;
        riscv64) target=riscv64gc-unknown-linux-gnu gcc=riscv64-linux-gnu ;;
        *) echo "$processor is not one of aarch64, riscv64 and wasm32" >&2 && exit 2 ;;
    esac
    missing=()
    for program in "qemu-$processor" "$gcc-gcc"; do
        command -v "$program" > /dev/null || missing+=("$program")
    done
    rustc --print target-libdir --target "$target" | xargs test -d || missing+=("the Rust target $target")
    if [ "${#missing[@]}" -gt 0 ]; then
        echo "Not run for $processor, because these are missing: ${missing[*]}. On Debian:"
        echo "  apt install qemu-user gcc-$gcc libc6-dev-${processor/aarch64/arm64}-cross && rustup target add $target"
        continue
    fi
    variable=$(tr 'a-z-' 'A-Z_' <<< "$target")
    export "CARGO_TARGET_${variable}_LINKER=$gcc-gcc"
    export "CARGO_TARGET_${variable}_RUNNER=qemu-$processor -L /usr/$gcc"
    echo "Goldens on $processor:"
    cargo test --quiet --target "$target" -p carom --test simulate goldens
    if [ "$what" = all ]; then
        echo "The engine's tests on $processor:"
        cargo test --quiet --target "$target" -p carom --lib --tests
        echo "Random shots on $processor:"
        # Optimised, as qemu is slow.
        cargo test --quiet --target "$target" --profile release-tests -p carom-check --test random_hashes
    fi
done

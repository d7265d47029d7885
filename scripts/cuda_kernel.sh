#!/usr/bin/env bash
# Builds the CUDA kernel: PTX, from the engine's source, by a nightly Rust with its own source. The only
# argument is the file to write, compressed if its name ends in .gz. Without the nightly it ends with 3 and says what is missing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
out="${1:?give the file to write, such as carom.ptx}"

# Compute capability 7.0 (2017) and newer: the driver compiles PTX for the card that it finds.
arch=sm_70
sysroot="$(rustc +nightly --print sysroot 2>/dev/null)" || {
  echo "no nightly Rust: rustup toolchain install nightly --component rust-src" >&2
  exit 3
}
if ! [ -f "$sysroot/lib/rustlib/src/rust/library/core/src/lib.rs" ]; then
  echo "the nightly Rust lacks its source: rustup component add rust-src --toolchain nightly" >&2
  exit 3
fi

target="${CAROM_CUDA_TARGET:-target/cuda}"
mkdir -p "$target"
# Nothing is linked: with LTO one assembly file has everything.
printf '#!/bin/sh\nexit 0\n' > "$target/no-linker"
chmod +x "$target/no-linker"
env -u MAKEFLAGS -u MFLAGS -u RUSTFLAGS cargo +nightly rustc --quiet --profile cuda --locked \
  --manifest-path crates/carom-cuda-kernel/Cargo.toml --target-dir "$target" \
  --target nvptx64-nvidia-cuda -Zbuild-std=core,alloc \
  -- --emit=asm -Clinker="$(realpath "$target/no-linker")" -Ctarget-cpu="$arch"
# LLVM writes many comments into PTX; the driver does not need them.
mkdir -p "$(dirname "$out")"
newest="$(ls -t "$target"/nvptx64-nvidia-cuda/cuda/deps/carom_cuda_kernel*.s | head -n 1)"
sed -E 's,[[:space:]]*//.*$,,; /^[[:space:]]*$/d' "$newest" > "$out.part"
case "$out" in
  *.gz) gzip -9 -n -c "$out.part" > "$out" && rm "$out.part" ;;
  *) mv "$out.part" "$out" ;;
esac

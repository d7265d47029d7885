#!/usr/bin/env bash
# Compares builds for wider and wider vectors (SSE2, AVX2, AVX-512) with the goldens, up to the widest
# that this processor has. usage: scripts/vector_builds.sh
set -euo pipefail

if [ "$(uname -m)" != x86_64 ]; then
    echo "Not run: builds for SSE2, AVX2 and AVX-512 are for x86-64."
    exit 0
fi
has=$(rustc --print cfg -C target-cpu=native)
for build in x86-64:sse2 x86-64-v3:avx2 x86-64-v4:avx512f; do
    cpu=${build%:*} feature=${build#*:}
    if ! grep -q "target_feature=\"$feature\"" <<< "$has"; then
        echo "Not run: this processor has no $feature."
        continue
    fi
    echo "Goldens, compiled for $cpu ($feature):"
    RUSTFLAGS="-C target-cpu=$cpu" cargo test --quiet --release --target-dir "target/$cpu" \
        -p carom --test simulate goldens
done

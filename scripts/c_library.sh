#!/usr/bin/env bash
# Puts the C library, built in the folder FROM, into the folder OUT: include, lib, and the files with which
# pkg-config and CMake find it. usage: scripts/c_library.sh FROM OUT
set -euo pipefail

from=$1 out=$2
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
version=$(sed -n 's/^version = "\(.*\)"/\1/p' "$source/Cargo.toml" | head -1)
mkdir -p "$out/include" "$out/lib/pkgconfig" "$out/lib/cmake/carom"
found=0
# Cargo names the library after its crate; the engine's crate has the shorter name.
for file in libcarom_c.so libcarom_c.dylib libcarom_c.a carom_c.dll carom_c.dll.lib carom_c.lib; do
    if [ -f "$from/$file" ]; then
        cp -f "$from/$file" "$out/lib/${file/carom_c/carom}"
        found=1
    fi
done
if [ "$found" = 0 ]; then
    echo "There is no library in $from. Build it first: cargo build --release -p carom-c" >&2
    exit 1
fi
cp -f "$source"/crates/carom-c/include/* "$out/include/"
cp -f "$source"/LICENSE-* "$out/"
package=$source/crates/carom-c/package
sed "s/@VERSION@/$version/" "$package/carom.pc" > "$out/lib/pkgconfig/carom.pc"
for file in carom-config.cmake carom-config-version.cmake; do
    sed "s/@VERSION@/$version/" "$package/$file" > "$out/lib/cmake/carom/$file"
done

"""Play one round robin in a debug and in a release build, and compare the records.

Both builds play crates/carom-arena/examples/round_robin.rs. It takes some minutes.

    python scripts/compare_builds.py
"""

from __future__ import annotations

import hashlib
import json
import subprocess
import sys
import tempfile
from pathlib import Path

COMMAND = ("cargo", "run", "--quiet", "-p", "carom-arena", "--example", "round_robin")
BUILDS: dict[str, tuple[str, ...]] = {"debug": (), "release": ("--release",)}


def records(folder: Path) -> dict[str, bytes]:
    """The records in a folder, by their paths in it."""
    paths = sorted(folder.rglob("match.jsonl"))
    return {str(path.relative_to(folder)): path.read_bytes() for path in paths}


def main() -> int:
    """Print what was compared; 1 if a record differs."""
    with tempfile.TemporaryDirectory() as root:
        played = {}
        for build, options in BUILDS.items():
            folder = Path(root) / build
            print(f"playing with the {build} build", file=sys.stderr)
            subprocess.run([*COMMAND, *options, "--", str(folder)], check=True)
            played[build] = records(folder)
    debug, release = played.values()
    different = [path for path in {**debug, **release} if debug.get(path) != release.get(path)]
    lines = [json.loads(line) for text in debug.values() for line in text.splitlines()]
    frames = [line for line in lines if "moves" in line]
    shots = sum("executed" in made for frame in frames for made in frame["moves"])
    digest = hashlib.sha256(b"".join(debug.values())).hexdigest()
    print(f"{len(debug)} records, {len(frames)} frames, {shots} shots, SHA-256 {digest[:16]}")
    print("\n".join(f"different: {path}" for path in different) or "all are the same to the bit")
    return int(bool(different) or not frames)


if __name__ == "__main__":
    sys.exit(main())

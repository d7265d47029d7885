"""Write goldens/shots.txt anew: event count and hash of every shot in shots/.

python scripts/write_goldens.py
"""

from __future__ import annotations

from pathlib import Path

import carom

ROOT = Path(__file__).parents[1]


def main() -> None:
    """Simulate every example shot and write what came out."""
    lines = []
    for path in sorted((ROOT / "shots").glob("*.json")):
        trace = carom.Shot.load(path).simulate()
        lines.append(f"{path.stem} {len(trace)} {trace.hash}\n")
    (ROOT / "goldens" / "shots.txt").write_text("".join(lines), encoding="utf-8")
    print(f"{len(lines)} goldens written; say in CHANGELOG why they changed")


if __name__ == "__main__":
    main()

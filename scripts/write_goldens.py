"""Write goldens/shots.json anew: event count and hash of every shot in shots/.

The pictures in the README show results too, and are drawn anew.

python scripts/write_goldens.py
"""

from __future__ import annotations

import json
from pathlib import Path

import carom
from carom import picture

ROOT = Path(__file__).parents[1]
PICTURES = ("nine_ball_break", "jump_shot")


def main() -> None:
    """Simulate every example shot; write what came out, and draw the README's."""
    goldens = {}
    for path in sorted((ROOT / "shots").glob("*.json")):
        trace = carom.Shot.load(path).simulate()
        goldens[path.stem] = {"events": len(trace), "hash": trace.hash}
    rows = ",\n".join(f"  {json.dumps(name)}: {json.dumps(row)}" for name, row in goldens.items())
    (ROOT / "goldens" / "shots.json").write_text(f"{{\n{rows}\n}}\n", encoding="utf-8")
    for name in PICTURES:
        trace = carom.Shot.load(ROOT / "shots" / f"{name}.json").simulate()
        drawn = picture.png(trace, title=name.replace("_", " "))
        (ROOT / "docs" / "images" / f"{name}.png").write_bytes(drawn)
    print(f"{len(goldens)} goldens written; say in CHANGELOG why they changed")


if __name__ == "__main__":
    main()

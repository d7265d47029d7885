"""Write goldens/shots.json anew: event count and hash of every shot in shots/.

python scripts/write_goldens.py
"""

from __future__ import annotations

import json
from pathlib import Path

import carom

ROOT = Path(__file__).parents[1]


def main() -> None:
    """Simulate every example shot and write what came out."""
    goldens = {}
    for path in sorted((ROOT / "shots").glob("*.json")):
        trace = carom.Shot.load(path).simulate()
        goldens[path.stem] = {"events": len(trace), "hash": trace.hash}
    rows = ",\n".join(f"  {json.dumps(name)}: {json.dumps(row)}" for name, row in goldens.items())
    (ROOT / "goldens" / "shots.json").write_text(f"{{\n{rows}\n}}\n", encoding="utf-8")
    print(f"{len(goldens)} goldens written; say in CHANGELOG why they changed")


if __name__ == "__main__":
    main()

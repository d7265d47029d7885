"""Breaks as players play them, counted beside published counts: the tables of docs/breaks.md.

    python benches/breaks.py            # count what is missing in the stored result
    python benches/breaks.py --again    # count everything again, for example with other physics

Stored in ``benches/results/breaks.json`` after every block of racks, so an interrupted run goes on
where it stopped. The results do not depend on the machine or its load.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

from carom.bench import report
from carom.plan.chance import Chance
from carom.validation.breaks_on_video.rows import NOISE, happened

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "benches" / "results" / "breaks.json"
#: Racks per row, and racks after which the result is stored.
RACKS, BLOCK = 4000, 1000
#: The breaks that are counted: name, game, break preset, table, gap in m (None is the preset's).
ROWS: tuple[tuple[str, str, str | None, str | None, float | None], ...] = (
    ("nine-ball, beside the rail, template", "nine-ball", "rail", None, None),
    ("nine-ball, beside the rail, 0.01 mm", "nine-ball", "rail", None, 1e-5),
    ("nine-ball, beside the rail, 0.1 mm", "nine-ball", "rail", None, 1e-4),
    ("nine-ball, edge of the box, template", "nine-ball", "box", None, None),
    (
        "nine-ball, beside the rail, triangle, 1 on the spot",
        "nine-ball",
        "rail-triangle",
        None,
        None,
    ),
    ("nine-ball, middle, no spin, 0.1 mm, 1 on the spot", "nine-ball", None, None, None),
    ("eight-ball, 7 ft (bar-7ft), triangle", "eight-ball", "head", "bar-7ft", None),
    ("eight-ball, 7 ft (showood-7ft), triangle", "eight-ball", "head", "showood-7ft", None),
    ("eight-ball, 9 ft, triangle", "eight-ball", "head", None, None),
    ("ten-ball, 9 ft, template", "ten-ball", "head", None, None),
)


def main() -> int:
    """Counts what is missing, prints and stores."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--again", action="store_true", help="count everything again")
    again = parser.parse_args().again
    stored = {} if again or not STORED.exists() else json.loads(STORED.read_text("utf-8"))
    rows: dict[str, Any] = stored.get("rows", {})
    for name, *how in ROWS:
        row = rows.setdefault(name, {"racks": 0, "counts": {}})
        while row["racks"] < RACKS:
            for seed in range(row["racks"], row["racks"] + BLOCK):
                for what in happened(seed, *how):
                    row["counts"][what] = row["counts"].get(what, 0) + 1
            row["racks"] += BLOCK
            result = report.where() | {"noise": NOISE, "rows": rows}
            STORED.write_text(json.dumps(result, indent=1, sort_keys=True) + "\n", "utf-8")
            print(f"{name}: {row['racks']} of {RACKS}", file=sys.stderr)
        print(name)
        for what, count in sorted(row["counts"].items()):
            print(f"  {what}: {Chance.of(count, row['racks'], 0.95)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())

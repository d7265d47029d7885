"""Draws the figures of docs/realism.md and stores its numbers: what is measured beside the engine.

    python scripts/realism_figures.py                      # the present defaults
    python scripts/realism_figures.py --before 2026-11     # beside the dated presets of that month
    python scripts/realism_figures.py --before old.json    # beside changes of each preset
    python scripts/realism_figures.py --after NAME         # another preset than the defaults
    python scripts/realism_figures.py --out out/realism    # for a look: nothing is stored

Rings are measured, solid lines the engine's defaults, dashed lines the physics before. The measured
numbers and their sources are in validation/measured.json. The numbers of the page are stored in
benches/results/realism.json, and `python benches/tables.py --write` writes them into the page.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

from carom.bench import goldens
from carom.validation import plot
from realism import cloth, diamonds, rails, throw
from realism.item import MEASURED, Choice, Item

ROOT = Path(__file__).resolve().parents[1]
IMAGES = ROOT / "docs" / "images"
STORED = ROOT / "benches" / "results" / "realism.json"

#: The items of the page, in its order.
ITEMS: tuple[Item, ...] = (
    throw.ITEM, rails.RETURNS, rails.CAROM_RETURNS, rails.BANKS, cloth.CAROM_ROLLING,
    cloth.SNOOKER_ROLLING, diamonds.CORNER_CAROM, diamonds.CORNER_POOL, diamonds.PLUS, cloth.TURN,
)  # fmt: skip
#: The figures; some of them show several items.
FIGURES = {
    "throw": throw.figure,
    "returns": rails.return_figure,
    "banks": rails.bank_figure,
    "rolling": cloth.rolling_figure,
    "diamonds": diamonds.corner_figure,
    "ball_turn": cloth.turn_figure,
}


def main() -> int:
    """Reads the command line, draws all figures and stores the numbers."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--before", help="a date, a preset or a JSON file of physics")
    parser.add_argument("--after", default="default", help="the same; the defaults if left out")
    parser.add_argument("--out", type=Path, help="a folder for figures and numbers")
    options = parser.parse_args()
    before = None if options.before is None else Choice(options.before, f"{options.before}")
    after = Choice(options.after, "default" if options.after == "default" else options.after)
    if options.out is None and options.after != "default":
        parser.error("--after draws something else than the page shows; give a folder with --out")
    images = options.out or IMAGES
    images.mkdir(parents=True, exist_ok=True)
    command = "python scripts/realism_figures.py"
    if options.before:
        command += f" --before {options.before}"
    result = goldens.stamp(command) | numbers(before, after)
    for name, draw in FIGURES.items():
        path = images / f"realism_{name}.png"
        draw(before, after).savefig(path, dpi=plot.DPI, metadata={"Software": None})
        print(path, file=sys.stderr)
    path = STORED if options.out is None else options.out / STORED.name
    path.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    return 0


def numbers(before: Choice | None, after: Choice) -> dict[str, Any]:
    """The measured numbers of every item beside the engine's."""
    return {
        "before": None if before is None else before.text,
        "items": {item.name: compared(item, before, after) for item in ITEMS},
    }


def compared(item: Item, before: Choice | None, after: Choice) -> dict[str, Any]:
    """One item's numbers with each physics."""
    entry: dict[str, Any] = {
        "title": item.title,
        "unit": item.unit,
        "preset": item.preset,
        "sources": [MEASURED[key]["source"] for key in item.data],
        "points": [
            {
                "label": p.label,
                "measured": number(p.measured),
                "tolerance": number(p.tolerance),
                "after": number(p.ours),
            }
            for p in item.points(after)
        ],
    }
    if before is not None:
        earlier = item.points(before)
        for point, then in zip(entry["points"], earlier, strict=True):
            point["before"] = number(then.ours)
    return entry


def number(value: float) -> float | None:
    """A number for JSON, rounded to what is drawn; None if there is none."""
    return round(value, 6) if value == value else None  # noqa: PLR0124 -- NaN


if __name__ == "__main__":
    sys.exit(main())

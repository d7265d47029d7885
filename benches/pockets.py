"""How much the parameters of a pocket change which balls it accepts: a table of docs/tables.md.

    python benches/pockets.py            # compute what is missing in the stored result
    python benches/pockets.py --again    # compute everything again, for example with other physics

Every parameter is set to the low and to the high end of its range, alone; all others are those of
``wpa-9ft`` and ``pool``. Stored in ``benches/results/pockets.json`` after every parameter. The
results do not depend on the machine or its load.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

import carom
import numpy as np
from carom.bench import report

ROOT = Path(__file__).resolve().parents[1]
STORED = ROOT / "benches" / "results" / "pockets.json"
INCH = 0.0254
#: Speeds of the rolling balls at the start, 0.3 m from the mouth, m/s.
SPEEDS = (1.0, 2.0, 4.0)
#: Offsets from the mouth's centre, m.
OFFSETS = np.arange(-160, 161) * 0.5e-3
#: The pockets: name, key of the table, and the largest angle to the axis, degrees.
POCKETS = (("top-right", "corner_pocket", 40), ("right", "side_pocket", 50))

#: Key, low and high end (SI or degrees), and where the range is from. Ranges of the rule book are
#: tolerances; an estimated range is what real equipment could have, and no source gives it.
TABLE: dict[str, tuple[tuple[str, float, float, str], ...]] = {
    "corner_pocket": (
        ("mouth", 4.5 * INCH, 4.625 * INCH, "WPA"),
        ("cut_angle_deg", 141.0, 143.0, "WPA"),
        ("shelf", 1.0 * INCH, 2.25 * INCH, "WPA"),
        ("hole_radius", 2.3125 * INCH, 2.625 * INCH, "estimate"),
        ("point_radius", 0.0, 0.5 * INCH, "estimate"),
    ),
    "side_pocket": (
        ("mouth", 5.0 * INCH, 5.125 * INCH, "WPA"),
        ("cut_angle_deg", 103.0, 105.0, "WPA"),
        ("shelf", 0.0, 0.375 * INCH, "WPA"),
        ("hole_radius", 2.4375 * INCH, 2.75 * INCH, "estimate"),
        ("point_radius", 0.0, 0.5 * INCH, "estimate"),
    ),
}
PHYSICS: tuple[tuple[str, float, float, str], ...] = (
    ("facing.restitution", 0.5, 0.9, "estimate"),
    ("facing.friction", 0.1, 0.4, "estimate"),
    ("liner.restitution", 0.2, 0.5, "estimate"),
    ("liner.friction", 0.05, 0.3, "estimate"),
    ("slate.restitution", 0.5, 0.7, "Alciatore's FAQ"),
    ("slate.friction", 0.1, 0.4, "Alciatore's FAQ"),
)


def main() -> int:
    """Computes what is missing, prints and stores."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--again", action="store_true", help="compute everything again")
    again = parser.parse_args().again
    stored = {} if again or not STORED.exists() else json.loads(STORED.read_text("utf-8"))
    found: dict[str, Any] = stored.get("pockets", {})
    for pocket, key, angle in POCKETS:
        rows = found.setdefault(key, {})
        if "base" not in rows:
            rows["base"] = widths(pocket, angle)
        for name, low, high, source in (*TABLE[key], *PHYSICS):
            if name not in rows:
                rows[name] = {
                    "range": [low, high],
                    "source": source,
                    "low": widths(pocket, angle, changed(key, name, low)),
                    "high": widths(pocket, angle, changed(key, name, high)),
                }
                result = report.where() | {"speeds_m_s": SPEEDS, "pockets": found}
                STORED.write_text(json.dumps(result, indent=1, sort_keys=True) + "\n", "utf-8")
            print(key, name, rows[name]["low"], rows["base"], rows[name]["high"])
    return 0


def changed(key: str, name: str, value: float) -> dict[str, Any]:
    """The keys of a shot file with one parameter changed."""
    surface, dot, parameter = name.partition(".")
    if dot:
        return {"physics": {"base": "pool", surface: {parameter: value}}}
    return {"table": {"base": "wpa-9ft", key: {name: value}}}


def widths(pocket: str, angle: int, change: dict[str, Any] | None = None) -> list[float]:
    """Mean width of the offsets that fall, over the angles to the axis, mm; one per speed."""
    cue = {"id": "cue", "position": [0.635, 1.27]}
    file = {"format": "carom-shot/1", "table": "wpa-9ft", "balls": [cue]} | (change or {})
    found = carom.acceptance(
        carom.Shot.from_dict(file),
        pocket,
        speed=SPEEDS,
        angle=np.radians(np.arange(-angle, angle + 1)),
        offset=OFFSETS,
    )
    return [round(1000 * float(width), 2) for width in found.width.mean(axis=1)]


if __name__ == "__main__":
    sys.exit(main())

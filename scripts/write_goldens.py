"""Write the goldens anew: event count and hash of every shot in shots/, and some noisy variants.

The pictures in the README show results too, and are drawn anew.

python scripts/write_goldens.py
"""

from __future__ import annotations

import json
from pathlib import Path

import carom
from carom import picture

ROOT = Path(__file__).parents[1]
# Shot, multiple of the Olympiad's noise, seed, first index. The second is beyond 32 bits.
NOISES = (("half_ball_cut", 1.0, 42, 0), ("nine_ball_break", 0.5, (1 << 53) - 1, 1 << 40))
VARIANTS = 8
PICTURES = ("nine_ball_break", "jump_shot")


def main() -> None:
    """Simulate every example shot; write what came out, and draw the README's."""
    goldens = {}
    for path in sorted((ROOT / "shots").glob("*.json")):
        trace = carom.Shot.load(path).simulate()
        goldens[path.stem] = {"events": len(trace), "hash": trace.hash}
    rows = ",\n".join(f"  {json.dumps(name)}: {json.dumps(row)}" for name, row in goldens.items())
    (ROOT / "goldens" / "shots.json").write_text(f"{{\n{rows}\n}}\n", encoding="utf-8")
    (ROOT / "goldens" / "noise.json").write_text(_noise(), encoding="utf-8")
    for name in PICTURES:
        trace = carom.Shot.load(ROOT / "shots" / f"{name}.json").simulate()
        drawn = picture.png(trace, title=name.replace("_", " "))
        (ROOT / "docs" / "images" / f"{name}.png").write_bytes(drawn)
    print(f"{len(goldens)} goldens written; say in CHANGELOG why they changed")


def _noise() -> str:
    goldens = []
    for name, multiplier, seed, first in NOISES:
        shot = carom.Shot.load(ROOT / "shots" / f"{name}.json")
        noise = carom.Noise.olympiad(multiplier)
        result = shot.vary(noise, VARIANTS, seed=seed, first=first)
        strikes = zip(
            result.speed, result.azimuth, result.elevation, result.side, result.height, strict=True
        )
        rows = zip(strikes, result.events, result.final_position[:, 0], strict=True)
        variants = [
            {"strike": list(strike), "events": int(events), "final": final.tolist()}
            for strike, events, final in rows
        ]
        head = {"shot": name, "olympiad": multiplier, "seed": seed, "first": first}
        lines = ",\n".join(f"    {json.dumps(variant)}" for variant in variants)
        goldens.append(f'  {json.dumps(head)[:-1]}, "variants": [\n{lines}\n  ]}}')
    return "[\n" + ",\n".join(goldens) + "\n]\n"


if __name__ == "__main__":
    main()

"""WPA Tour Table and Equipment Specifications: the liveliness of cushions."""

import math

from carom.validation.lab import JSON, MPH, ball, simulate
from carom.validation.row import Kind, Range, row

LENGTH = 2.54


def lengths_travelled(speed: float, physics: JSON | str = "pool") -> float:
    """Table lengths that a centre-ball shot from the head spot travels along the middle."""
    run = simulate(
        ball(position=(0.635, 0.25 * LENGTH)),
        table="wpa-9ft",
        physics=physics,
        strike={
            "ball": "cue",
            "speed": speed,
            "azimuth_deg": 90.0,
            "elevation_deg": 0.0,
            "side": 0.0,
            "height": 0.0,
        },
    )
    path, last = 0.0, 0.25 * LENGTH
    for event in [*run.all("rail-collision", "cue")]:
        y = float(event.after["cue"].position[1])
        path, last = path + abs(y - last), y
    return (path + abs(float(run.final["cue"].position[1]) - last)) / LENGTH


#: The presets whose rails were fitted to banks on pool tables.
PRESETS = ("pool", "pool-gold-crown", "pool-valley")


@row(
    "CU-19",
    "A firm centre-ball shot end to end: table lengths (`wpa-9ft`; cue at 10 mph)",
    unit="lengths",
    source="WPA specifications, cushions",
    kind=Kind.MEASURED,
    held=True,
    uses_preset=True,
    reference={preset: Range(4.0, math.inf) for preset in PRESETS},
    note="The rails were fitted to banks at 12 mph, not to this requirement.",
)
def cu_19() -> list[float]:
    return [lengths_travelled(10 * MPH, preset) for preset in PRESETS]

"""The initial states that are timed: ``carom/data/bench_states.json.gz``, with its source."""

from __future__ import annotations

import gzip
import json
from dataclasses import dataclass
from importlib.resources import files
from typing import Any

#: Classes of state in the order of reports, with the name that a reader sees.
CLASSES = {
    "pots": "pots of all kinds, 2–4 balls",
    "random_eight_ball": "random mid-game, 4–16 balls",
    "nine_ball_break": "nine-ball break",
    "eight_ball_break": "eight-ball break",
}


@dataclass(frozen=True)
class State:
    """One initial state.

    Attributes:
        balls: Centres on the cloth by id, (x, y) in m from the bottom-left corner; the strike is
            on ``cue``.
        speed: Speed of the cue, m/s.
        azimuth_deg: Direction of the strike, counter-clockwise from +x, degrees.
        elevation_deg: Elevation of the cue's butt, degrees.
        side: Contact point right of the ball's centre, in radii, perpendicular to the cue.
        height: Contact point above the ball's centre, in radii, perpendicular to the cue.
        pots: The ball that the shot must pocket, alone; None where that is not checked.
    """

    balls: dict[str, tuple[float, float]]
    speed: float
    azimuth_deg: float
    elevation_deg: float
    side: float
    height: float
    pots: str | None = None

    def shot_file(self) -> dict[str, Any]:
        """The state as a ``carom-shot/1``, with the default models of the table's physics."""
        return {
            "format": "carom-shot/1",
            "table": "showood-7ft",
            "balls": [{"id": i, "position": list(p)} for i, p in self.balls.items()],
            "strike": {
                "ball": "cue",
                "speed": self.speed,
                "azimuth_deg": self.azimuth_deg,
                "elevation_deg": self.elevation_deg,
                "side": self.side,
                "height": self.height,
            },
        }


def load() -> dict[str, list[State]]:
    """Every state, by class, in the order of `CLASSES`."""
    packed = files("carom").joinpath("data", "bench_states.json.gz").read_bytes()
    classes = json.loads(gzip.decompress(packed))["classes"]
    return {name: [State(**state) for state in classes[name]] for name in CLASSES}

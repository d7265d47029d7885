"""Curves of a learned table: restitution and friction of the rails, rolling, and throw."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from carom import _core
from carom.cloth import STANDARD_GRAVITY
from carom.lazy import np
from carom.learn.posterior import MODEL_ERROR, LearnedNumbers
from carom.learn.report_data import ShotFit
from carom.shot import Shot

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

#: Draws from the posterior behind a band, and those behind one whose points are simulated.
DRAWS, SIMULATED_DRAWS = 200, 40
#: Ends of a band, %.
BAND = (5.0, 95.0)
#: Speed of the cue ball at the contact of the figure of throw, m/s; it does not spin.
THROW_SPEED = 1.5


@dataclass(frozen=True, slots=True, eq=False)
class Curve:
    """A curve of the learned table, beside that of the physics from which the fit began.

    Attributes:
        x: Shape (n,).
        learned: At the posterior's mean, shape (n,).
        low: Lower end of the interval of 90 %, shape (n,).
        high: Upper end.
        preset: With the values from which the fit began, shape (n,).
        seen: Values of x at which the shots have contacts, or speeds that they have, shape (m,).
    """

    x: Floats
    learned: Floats
    low: Floats
    high: Floats
    preset: Floats
    seen: Floats


def coefficients(physics: Mapping[str, Any]) -> dict[str, Any]:
    """All numbers of some physics by their keys, merged over the base; formulas by ``key.a``."""
    rows = next(row for row in _core.physics() if row["name"] == physics["base"])["parameters"]
    values: dict[str, Any] = {}
    for key, value in [*((row["key"], row["value"]) for row in rows), *_leaves(physics)]:
        if isinstance(value, int | float) and f"{key}.a" in values:
            values |= {name: 0.0 for name in values if name.startswith(f"{key}.")}
            values[f"{key}.a"] = value
        else:
            values[key] = value
    return values


def rail_restitution(values: Mapping[str, Any], speed: Floats) -> Floats:
    """Restitution e = a + bV + cV² of the speed perpendicular to the rail, m/s, in its bounds."""
    a, b, c = (_part(values, "cushion.restitution", part) for part in "abc")
    low = values.get("cushion.restitution.lowest", 0.0)
    high = values.get("cushion.restitution.highest", 1.0)
    clipped: Floats = np.clip(a + b * speed + c * speed**2, low, high)
    return clipped


def rail_friction(values: Mapping[str, Any], incidence: Floats) -> Floats:
    """Friction μ = a + bγ of the angle of incidence from the normal, rad, at least 0."""
    a, b = (_part(values, "cushion.friction", part) for part in "ab")
    friction: Floats = np.maximum(a + b * incidence, 0.0)
    return friction


def rolling_deceleration(values: Mapping[str, Any], speed: Floats) -> Floats:
    """Deceleration of a rolling ball, m/s²."""
    bands = values["cloth.rolling_friction"]
    gravity = values.get("gravity", STANDARD_GRAVITY)
    if isinstance(bands, int | float):
        return np.full(speed.shape, bands * gravity)
    ends = [band["up_to"] for band in bands if "up_to" in band]
    friction = np.array([band["friction"] for band in bands])
    found: Floats = friction[np.searchsorted(ends, speed)] * gravity
    return found


def throw(physics: Mapping[str, Any], cuts: Floats, radius: float | None) -> Floats:
    """Angle between the object ball's direction and the line of centres, rad, at cut angles, rad.

    A ball that slides at 1.5 m/s without spin meets a ball at rest. The angle is positive where the
    friction turns the object ball towards the direction in which the cue ball moved.
    """
    found = []
    for cut in cuts.tolist():
        ball: dict[str, Any] = {} if radius is None else {"radius": radius}
        alone = {"id": "cue", "position": (0.0, 0.0), "velocity": (THROW_SPEED, 0.0, 0.0)}
        R = Shot({"cloth": "unbounded"}, [alone | ball], physics=physics).radius[0]
        # The centres stand 0.1 mm farther apart than at the contact, along the line of flight.
        place = (2.0 * R * math.cos(cut) + 1e-4, 2.0 * R * math.sin(cut))
        other = {"id": "object", "position": place}
        balls = [alone | ball, other | ball]
        shot = Shot({"cloth": "unbounded"}, balls, physics=physics, until=1e-3)
        after = shot.simulate().at(1e-3).velocity[1]
        found.append(cut - math.atan2(after[1], after[0]))
    return np.array(found)


def curves(posterior: LearnedNumbers, shots: Sequence[ShotFit]) -> dict[str, Curve]:
    """The curves by the names ``restitution``, ``friction``, ``rolling`` and ``throw``."""
    rails, cuts = _contacts(shots)
    speeds = [_speeds(shot) for shot in shots]
    physics = [draw.physics for draw in posterior.draw(DRAWS)]
    values = [_start(posterior), posterior.physics, *physics]
    all_values = [coefficients(each) for each in values]

    def of_values(law: Callable[..., Floats], x: Floats, seen: Floats) -> Curve:
        return _curve(x, [law(each, x) for each in all_values], seen)

    steep, angles = np.linspace(0.0, 4.0, 41), np.linspace(0.0, np.radians(80.0), 41)
    slow = np.linspace(0.0, 3.0, 121)
    aims = np.radians(np.linspace(5.0, 80.0, 16))
    thrown = [throw(each, aims, posterior.model.radius) for each in values[: 2 + SIMULATED_DRAWS]]
    return {
        "restitution": of_values(rail_restitution, steep, rails[:, 0]),
        "friction": of_values(rail_friction, angles, rails[:, 1]),
        "rolling": of_values(
            rolling_deceleration, slow, np.concatenate(speeds) if speeds else np.empty(0)
        ),
        "throw": _curve(aims, thrown, cuts),
    }


def _curve(x: Floats, rows: Sequence[Floats], seen: Floats) -> Curve:
    """A curve from that of the start, that of the mean, and those of draws."""
    ends = np.percentile(np.array(rows[2:]), BAND, axis=0)
    low, high = rows[1] + MODEL_ERROR * (ends - rows[1])
    return Curve(x, rows[1], low, high, rows[0], seen[(seen >= x[0]) & (seen <= x[-1])])


def _start(posterior: LearnedNumbers) -> dict[str, Any]:
    return posterior.model.parts(posterior.model.start)[1]


def _part(values: Mapping[str, Any], key: str, part: str) -> float:
    first = values.get(key, 0.0) if part == "a" else 0.0
    return float(values.get(f"{key}.{part}", first))


def _leaves(tree: Mapping[str, Any], before: str = "") -> list[tuple[str, Any]]:
    found: list[tuple[str, Any]] = []
    for key, value in tree.items():
        name = f"{before}{key}"
        if isinstance(value, Mapping):
            found += _leaves(value, f"{name}.")
        elif name != "base":
            found.append((name, value))
    return found


def _contacts(shots: Sequence[ShotFit]) -> tuple[Floats, Floats]:
    """Contacts of the simulations while these are on the track.

    Returns:
        Of rails the normal speed, m/s, and the angle of incidence, rad, shape (n, 2); of balls the
        cut angle, rad, shape (m,).
    """
    rails, cuts = [], []
    for shot in shots:
        for event in shot.trace.events:
            if event.time > shot.end:
                break
            if event.type == "rail-collision":
                axis = 1 if event["rail"] in ("bottom", "top") else 0
                velocity = event.before[0].velocity
                normal, along = abs(velocity[axis]), abs(velocity[1 - axis])
                rails.append((normal, math.atan2(along, normal)))
            elif event.type == "ball-collision" and len(event.before) == 2:
                one, other = event.before
                line = np.subtract(other.position, one.position)[:2]
                moves = np.subtract(one.velocity, other.velocity)[:2]
                size = np.hypot(*line) * np.hypot(*moves)
                cuts.append(math.acos(min(1.0, abs(line @ moves) / size)) if size else 0.0)
    return np.array(rails).reshape(-1, 2), np.array(cuts)


def _speeds(shot: ShotFit) -> Floats:
    """Speeds of the rolling balls of a simulation while it is on the track, m/s."""
    times = np.arange(0.0, max(shot.end, 0.1), 0.1)
    states = shot.trace.at(times)
    speed = np.hypot(states.velocity[:, :, 0], states.velocity[:, :, 1])
    chosen: Floats = speed[states.motion == "rolling"]
    return chosen

"""What was played, in words."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from carom import _core
from carom.noise import Noise
from carom.reference import DEFAULT_OPTIONS


def condition_of(header: dict[str, Any]) -> str:
    """What was played: game, table, noise and clock, and what differs from the defaults.

    Args:
        header: The header of a record.
    """
    table = header["table"]
    named = table if isinstance(table, str) else "a table of its own"
    noises = {_noise_name(noise) for noise in header["noise"]}
    clocks = {_clock_name(clock) for clock in header["clock"]}
    # Names of built-in players may bring a noise and a clock, which differ from match to match.
    noise = noises.pop() if len(noises) == 1 else "each player's own noise"
    clock = clocks.pop() if len(clocks) == 1 else "each player's own clock"
    return ", ".join((str(header["game"]), named, noise, clock, *_others(header)))


def _others(header: dict[str, Any]) -> Iterator[str]:
    """The settings that differ from the defaults, apart from table, noise and clock."""
    physics = header["physics"]
    if physics is not None:
        yield f"physics {physics}" if isinstance(physics, str) else "physics of its own"
    sights = {sight["position"] for sight in header["perception"]}
    if len(sights) > 1:
        yield "each player's own perception"
    elif (sight := sights.pop()) > 0:
        yield f"perception {1e3 * sight:.3g} mm"
    for name, value in header["options"].items():
        if value != getattr(DEFAULT_OPTIONS, name):
            yield f"{name} {str(value).lower()}"
    if header["same_break"] is not None:
        yield "same break"
    if header["disclosure"] != "both":
        yield f"disclosure {header['disclosure']}"


def _noise_name(values: dict[str, Any]) -> str:
    noise = Noise.from_dict(values)
    if noise == Noise():
        return "no noise"
    for name, _ in _core.noise_presets():
        if Noise.preset(name) == noise:
            return f"noise {name}"
    for factor in (0.25, 0.5, 2.0, 4.0):
        if Noise.olympiad(factor) == noise:
            return f"noise olympiad:{factor:g}"
    azimuth, speed = 1e3 * noise.azimuth, noise.speed
    return f"noise of {azimuth:.2g} mrad and {speed:.2g} m/s"


def _clock_name(clock: dict[str, Any]) -> str:
    unit = "simulations" if "simulations" in clock else "seconds"
    amount = f"{clock[unit]:g}"
    return f"{amount} {unit} a {clock['per']}"

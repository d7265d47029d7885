"""Whether places and times can be those of balls on the table, and what else they would be.

A wrong unit, origin or axis moves whole tracks off the table or into its corner. The places are
tried in every other frame; the frames in which they lie on the table are the remedy.
"""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING

from carom.errors import InputError
from carom.lazy import np
from carom.learn.findings import Finding
from carom.learn.header import AXES, ORIGINS, TIME_UNITS, UNITS, FileFrame, TracksHeader

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from carom.learn.samples import Locate, Rows

# How far a measured centre may lie beyond the nose lines, m: the width of a wide rail, for balls
# that jump off the table or lie in a pocket.
BEYOND = 0.25
# A centre nearer to the nose line than this, m, was measured badly, or the frame is wrong: the
# radius of the smallest ball of a game less an error of a camera.
_INSET = 0.015
# Share of the places that must lie on the table.
_MOST_INSIDE = 0.95
# Places that fill less than this share of the table in both directions have a wrong unit, if
# another unit fits.
_LEAST_SPREAD = 0.2
# No ball is faster, m/s; the fastest breaks have 16 m/s.
MOST_SPEED = 20.0
# A recording whose fastest ball is slower than this, m/s, has another unit of time.
_LEAST_SPEED = 0.05
# Plausible greatest speed of a recording in another unit of time, m/s.
_USUAL = (0.2, 16.0)


def check_frame(places: NDArray[np.float64], header: TracksHeader, name: str) -> None:
    """Refuse places that do not lie on the table.

    Args:
        places: In the file's unit and frame, shape (n, 2), finite.
        header: The table and the frame.
        name: The file, for the message.

    Raises:
        InputError: They do not; the message names the frame in which they would.
    """
    size = header.table_size
    if size is None or not len(places):
        return
    fit = _fit(header.frame, places, size)
    others = [
        frame
        for frame in _frames(header.frame, places)
        if frame != header.frame and _fits(_fit(frame, places, size), small=False)
    ]
    if _fits(fit, small=not others):
        return
    width, length = size
    inside, _ = fit
    low, high = places.min(axis=0), places.max(axis=0)
    fault = (
        f"x is {low[0]:.4g} to {high[0]:.4g} and y is {low[1]:.4g} to {high[1]:.4g}; with "
        f"{_all_words(header.frame)}, {100 * inside:.0f} % of the places are "
        f"on the playing area of {width:g} × {length:g} m"
    )
    if not others:
        remedy = "name the table, the unit, the origin and the axis of x as they are in the file"
    else:
        # Of two units that fit, the places of a whole game fill the table in the right one.
        best = min(
            others,
            key=lambda frame: (_changes(frame, header.frame), -_fit(frame, places, size)[1]),
        )
        remedy = (
            f"give {_words(best, header.frame)}, in which they fit, if this is the file's frame"
        )
        if best.x != header.frame.x:
            remedy += (
                "; the tracks cannot show whether y points to the left or to the right of x: "
                "compare with the picture (mirrored)"
            )
    raise InputError("mismatch", name, fault, remedy)


def leave_out_far_places(
    rows: Rows, header: TracksHeader, locate: Locate, findings: list[Finding]
) -> None:
    """Set samples far off the table to "not visible"."""
    size = header.table_size
    if size is None:
        return
    width, length = size
    with np.errstate(invalid="ignore"):
        far = (
            (rows.x < -BEYOND)
            | (rows.x > width + BEYOND)
            | (rows.y < -BEYOND)
            | (rows.y > length + BEYOND)
        ) & rows.visible
    if far.any():
        lines = [int(line) for line in rows.line[far]]
        findings.append(
            Finding(
                "repair",
                "outside-table",
                locate(lines),
                f"a place more than {BEYOND:g} m beyond the rails",
                "kept as a sample in which the ball was not seen",
                len(lines),
            )
        )
        rows.visible[far] = False
        rows.x[far] = rows.y[far] = np.nan


def check_clock(speeds: NDArray[np.float64], step: float, header: TracksHeader, name: str) -> None:
    """Refuse times with which no ball, or every ball, would be too fast.

    Args:
        speeds: Between samples, m/s, of all balls.
        step: Median time between samples of a moving ball, s.
        header: The clock.
        name: The file, for the message.

    Raises:
        InputError: The unit of time is wrong; the message names a unit that fits.
    """
    if not speeds.size:
        return
    # Some jumps of a bad tracker do not come from the clock.
    fast = float(np.quantile(speeds, 0.98))
    if _LEAST_SPEED <= fast <= MOST_SPEED:
        return
    if fast < _LEAST_SPEED and step < 0.5:
        # Short steps: slow balls, and not seconds for milliseconds.
        return
    fits = [
        unit
        for unit, seconds in TIME_UNITS.items()
        if unit != header.time_unit and _USUAL[0] <= fast * header.seconds / seconds <= _USUAL[1]
    ]
    fault = (
        f"with times in {header.time_unit}, samples are {step:.3g} s apart and balls move at up to "
        f"{fast:.3g} m/s"
    )
    if header.time_unit == "s" and abs(step - round(step)) < 1e-6 and round(step) >= 1:
        remedy = "if they are numbers of pictures, give the time unit frame and the rate"
        if fits:
            remedy += f"; else the time unit {fits[0]}"
    elif fits:
        remedy = f"give the time unit {fits[0]} (time_unit, --time-unit)"
    else:
        remedy = "give the unit of the times (s, ms, us or frame) and that of the places"
    raise InputError("mismatch", name, fault, remedy)


def _frames(own: FileFrame, places: NDArray[np.float64]) -> list[FileFrame]:
    negative = (places < 0.0).mean(axis=0)
    found = []
    for unit, origin, x, mirrored in product(UNITS, ORIGINS, AXES, (False, True)):
        # The tracks cannot tell mirrored frames apart, except by the sign of a corner's y.
        if mirrored != own.mirrored or (origin == "centre") != bool((negative > 0.1).any()):
            continue
        found.append(FileFrame(unit=unit, origin=origin, x=x, mirrored=mirrored))  # type: ignore[arg-type]
    return found


def _fit(
    frame: FileFrame, places: NDArray[np.float64], size: tuple[float, float]
) -> tuple[float, float]:
    """Share of the places on the table, and the larger share of its sides that they fill."""
    table = frame.to_table(places, size)
    sides = np.array(size)
    inside = ((table > -BEYOND) & (table < sides + BEYOND)).all(axis=1)
    strict = ((table > _INSET) & (table < sides - _INSET)).all(axis=1)
    if inside.mean() < _MOST_INSIDE:
        return float(inside.mean()), 0.0
    spread = (np.quantile(table, 0.99, axis=0) - np.quantile(table, 0.01, axis=0)) / sides
    return float(strict.mean()), float(spread.max())


def _fits(fit: tuple[float, float], *, small: bool) -> bool:
    inside, spread = fit
    return inside >= _MOST_INSIDE and (small or spread >= _LEAST_SPREAD)


def _changes(frame: FileFrame, own: FileFrame) -> int:
    return sum(getattr(frame, key) != getattr(own, key) for key in ("unit", "origin", "x"))


def _all_words(frame: FileFrame) -> str:
    return f"unit={frame.unit}, origin={frame.origin}, x={frame.x}"


def _words(frame: FileFrame, other: FileFrame) -> str:
    """What the frame has that the other one has not."""
    words = [
        f"{key}={getattr(frame, key)}"
        for key in ("unit", "origin", "x")
        if getattr(frame, key) != getattr(other, key)
    ]
    return ", ".join(words)

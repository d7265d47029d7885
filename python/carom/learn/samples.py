"""Rows of samples, from a file of any kind, made into shots; bad rows are left out or refused."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from carom.errors import InputError
from carom.lazy import np
from carom.learn.findings import Finding, listed
from carom.learn.tracks import TrackedBall, TrackedShot

if TYPE_CHECKING:
    from numpy.typing import NDArray

# Largest share of the rows that may be left out; more of them are a fault of the whole file.
_MOST_LEFT_OUT = 0.05
# This many may always be left out, so that a short file may have a bad row too.
_ALWAYS_LEFT_OUT = 3
# If at least this number of samples before a step back in time, and after it, share a span of
# time, they are two recordings, and not rows out of order.
_RESTART = 4
# A file in which more than this share of the steps goes back in time was sorted by something
# else.
_UNSORTED = 0.02


@dataclass(frozen=True, slots=True)
class Rows:
    """Samples in the order of the file; all arrays have the shape (n,).

    Attributes:
        shot: Index of the shot's name.
        shots: The shots' names, in order of appearance.
        ball: Index of the ball's id.
        balls: The balls' ids, in order of appearance.
        t: s.
        x: In the table's frame, m; NaN where the ball was not seen.
        y: The same.
        sigma: m; None without this column.
        visible: Whether the ball was seen.
        line: The line of the file, or the number of the row from 1.
    """

    shot: NDArray[np.int64]
    shots: list[str]
    ball: NDArray[np.int64]
    balls: list[str]
    t: NDArray[np.float64]
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    sigma: NDArray[np.float64] | None
    visible: NDArray[np.bool_]
    line: NDArray[np.int64]


Locate = Callable[[list[int]], str]


def check_left_out(count: int, total: int, findings: Sequence[Finding], name: str) -> None:
    """Refuse a file of which too many rows had to be left out.

    Raises:
        InputError: More than a twentieth, and more than three; the message is that of the most
            frequent fault.
    """
    if count <= _most_left_out(total):
        return
    worst = max(
        (finding for finding in findings if finding.level == "repair"),
        key=lambda finding: finding.count,
    )
    raise InputError(
        "syntax",
        worst.place,
        f"{worst.fault}; {count} of {total} rows of {name} cannot be used",
        "mend the file, or name its columns, delimiter and units",
    )


def _most_left_out(total: int) -> float:
    return max(_ALWAYS_LEFT_OUT, _MOST_LEFT_OUT * total)


def shots_of(rows: Rows, locate: Locate, findings: list[Finding]) -> list[TrackedShot]:
    """The shots of rows, each ball's samples in order of time.

    Args:
        rows: The samples.
        locate: Gives the place of some lines, for messages.
        findings: What is repaired is added to them.

    Raises:
        InputError: The clock of a ball starts again within a shot.
    """
    key = rows.shot * len(rows.balls) + rows.ball
    order = np.argsort(key, kind="stable")
    starts = np.flatnonzero(np.r_[True, np.diff(key[order]) != 0]) if len(order) else np.array([])
    ends = np.r_[starts[1:], len(order)] if len(order) else starts
    made: dict[int, dict[str, TrackedBall]] = {}
    double: list[int] = []
    clash: list[int] = []
    unsorted: list[int] = []
    for start, end in zip(starts, ends, strict=True):
        own = order[start:end]
        shot, ball = int(rows.shot[own[0]]), rows.balls[int(rows.ball[own[0]])]
        where = f"shot {rows.shots[shot]}, ball {ball}"
        own = _sorted(rows, own, where, locate, unsorted)
        own = _distinct(rows, own, double, clash)
        sigma = None if rows.sigma is None else _sigmas(rows.sigma[own])
        made.setdefault(shot, {})[ball] = TrackedBall(
            rows.t[own], np.column_stack((rows.x[own], rows.y[own])), sigma, rows.visible[own]
        )
    for lines, kind, fault, remedy in (
        (unsorted, "unsorted", "the time goes back", "sorted by time"),
        (double, "duplicate-row", "the same sample again", "left out"),
        (clash, "two-places", "a second place of the ball at the same time", "left out"),
    ):
        if lines:
            if kind == "two-places" and len(lines) > _most_left_out(rows.t.size):
                raise InputError(
                    "duplicate",
                    locate(sorted(lines)),
                    fault,
                    "give every ball of a shot its own name",
                )
            findings.append(
                Finding("repair", kind, locate(sorted(lines)), fault, remedy, len(lines))
            )
    # Balls in the order in which they first appear in the file, the same in every shot.
    rank = {ball: index for index, ball in enumerate(rows.balls)}
    return [
        TrackedShot(rows.shots[shot], dict(sorted(of.items(), key=lambda item: rank[item[0]])))
        for shot, of in sorted(made.items())
    ]


def _sigmas(values: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """The standard deviations of a ball; a missing one is the median of the others."""
    known = np.isfinite(values) & (values > 0.0)
    if not known.any():
        return None
    return np.where(known, values, np.median(values[known]))


def _sorted(
    rows: Rows, own: NDArray[np.int64], where: str, locate: Locate, unsorted: list[int]
) -> NDArray[np.int64]:
    times = rows.t[own]
    back = np.flatnonzero(np.diff(times) < 0.0) + 1
    if not back.size:
        return own
    if back.size <= max(3.0, _UNSORTED * times.size):
        ends = np.r_[back[1:], times.size]
        for index, end in zip(back, ends, strict=True):
            before, after = times[:index], times[index:end]
            twice = (before >= after.min()) & (before <= after.max())
            if twice.sum() >= _RESTART and (after <= before.max()).sum() >= _RESTART:
                raise InputError(
                    "conflict",
                    locate([int(rows.line[own[index]])]),
                    f"{where}: the time starts again at {times[index]:g} s after "
                    f"{before.max():g} s",
                    "give the second shot, or the second ball, a name of its own",
                )
    unsorted.extend(int(line) for line in rows.line[own[back]])
    sorted_rows: NDArray[np.int64] = own[np.argsort(times, kind="stable")]
    return sorted_rows


def _distinct(
    rows: Rows, own: NDArray[np.int64], double: list[int], clash: list[int]
) -> NDArray[np.int64]:
    """Rows without a second sample of the same time; one in which the ball was seen comes first."""
    times = rows.t[own]
    if (np.diff(times) > 0.0).all():
        return own
    own = own[np.lexsort((~rows.visible[own], rows.t[own]))]
    keep = np.ones(own.size, dtype=np.bool_)
    last = 0
    for index in range(1, own.size):
        if rows.t[own[index]] > rows.t[own[last]]:
            last = index
            continue
        keep[index] = False
        a, b = own[last], own[index]
        unseen = not rows.visible[b]
        same = unseen or (rows.x[a] == rows.x[b] and rows.y[a] == rows.y[b])
        (double if same else clash).append(int(rows.line[b]))
    kept: NDArray[np.int64] = own[keep]
    return kept


def locator(name: str, word: str = "line") -> Locate:
    """A function that gives the place of some lines of a file."""

    def locate(lines: list[int]) -> str:
        return f"{name}, {listed(lines).replace('line', word, 1)}"

    return locate

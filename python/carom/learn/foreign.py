"""Tracks in the files of other programs: systems of pooltool, and shots of tailuge/billiards.

Facts about the formats are from public files: pooltool 0.6 saves each ball's ``history``, its
states (rvw, s, t) at all events, and ``history_cts``, those at even times, if it was computed.
tailuge/billiards has a list of shots with ``shotID`` or ``id`` and ``balls``, each with lists
``t``, ``x`` and ``y``.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from carom.convert import _pooltool_table
from carom.convert._msgpack import unpack
from carom.convert._place import Place
from carom.errors import InputError
from carom.lazy import np
from carom.learn.findings import Finding
from carom.learn.header import FileFrame, TracksHeader

if TYPE_CHECKING:
    from numpy.typing import NDArray

_POCKETED = 4
#: Samples per second of a pooltool system without a continuous history, Hz.
RATE = 100.0
# Radius and table of the three-cushion shots of tailuge/billiards; the file has neither.
_BALL, _TABLE = 0.03075, "carom-10ft"


class ForeignTracks(NamedTuple):
    """What a file of another program has.

    Attributes:
        header: What the file says, or what was assumed, about the table.
        samples: Shot, ball, and the arrays t, x, y in the file's frame.
        findings: What was assumed.
    """

    header: TracksHeader
    samples: list[tuple[str, str, Any, Any, Any]]
    findings: list[Finding]


def foreign(data: bytes, name: str, rate: float | None) -> ForeignTracks:
    """Read JSON or MessagePack of another program.

    Args:
        data: The content of the file.
        name: Its name, for messages.
        rate: Samples per second of a pooltool history, Hz; None for the usual one.

    Raises:
        InputError: It is none of these files.
    """
    try:
        tree = json.loads(data) if data.lstrip()[:1] in (b"{", b"[") else unpack(data)
    except json.JSONDecodeError as error:
        raise InputError(
            "syntax",
            name,
            f"not JSON: {error.msg} (line {error.lineno}, column {error.colno})",
            "copy or write the file again",
            {"line": error.lineno, "column": error.colno},
        ) from None
    except (ValueError, RecursionError) as error:
        if isinstance(error, InputError):
            raise error.inside(name, ": ") from None
        raise InputError(
            "syntax", name, f"not JSON ({error})", "copy or write the file again"
        ) from None
    try:
        if isinstance(tree, list):
            return _tailuge(tree, name)
        if isinstance(tree, Mapping) and ("multisystem" in tree or "balls" in tree):
            return _pooltool(tree, name, rate or RATE)
    except InputError as error:
        raise error.inside(name, ": ") from None
    raise InputError(
        "format",
        name,
        "it is not a file of tracks that carom reads",
        "give CSV, Parquet, a system of pooltool, or shots of tailuge/billiards (docs/tracks.md)",
    )


def _tailuge(tree: list[Any], name: str) -> ForeignTracks:
    samples: list[tuple[str, str, Any, Any, Any]] = []
    for index, entry in enumerate(Place(tree).items()):
        shot = Place(entry, f"[{index}]")
        given = shot.get("shotID") or shot.get("id")
        title = str(index if given is None else given.value)
        for ball, at in shot["balls"].members():
            columns = [at[key].items() for key in ("t", "x", "y")]
            lengths = [len(column) for column in columns]
            if len(set(lengths)) != 1:
                raise at.refuse(
                    "wrong-count",
                    f"has {lengths[0]} times, {lengths[1]} x and {lengths[2]} y",
                    "write as many of each",
                )
            t, x, y = (list(column) for column in columns)
            samples.append((title, ball, t, x, y))
    flat = [value for _, _, _, x, y in samples for value in (*x, *y)]
    numbers = np.array([v for v in flat if isinstance(v, int | float)], dtype=np.float64)
    centred = numbers.size > 0 and float((numbers < -_BALL).mean()) > 0.01
    header = TracksHeader(
        table=_TABLE,
        radius=_BALL,
        frame=FileFrame(origin="centre" if centred else "corner", x="length"),
    )
    origin = "the centre of the table" if centred else "a corner"
    assumed = Finding(
        "note",
        "assumed",
        name,
        "shots of tailuge/billiards name neither table nor frame",
        f"taken as metres from {origin} along the length of {_TABLE}",
    )
    return ForeignTracks(header, samples, [assumed])


def _pooltool(tree: Mapping[str, Any], name: str, rate: float) -> ForeignTracks:
    systems = [Place(tree)]
    if "multisystem" in tree:
        items = Place(tree)["multisystem"].items()
        systems = [Place(item, f"multisystem[{i}]") for i, item in enumerate(items)]
    samples: list[tuple[str, str, Any, Any, Any]] = []
    table: Any = None
    radius = 0.0
    notes: list[str] = []
    exact = False
    for index, system in enumerate(systems):
        own, _ = _pooltool_table.table(system["table"], notes)
        if index and own != table:
            raise system["table"].refuse(
                "mismatch", "is not that of the first system", "read each table's file by itself"
            )
        table = own
        for ball, at in system["balls"].members():
            radius = at["params"]["R"].number()
            t, r, was_exact = _history(at, rate)
            exact |= was_exact
            samples.append((str(index + 1), ball, t, r[:, 0], r[:, 1]))
    findings = []
    if exact:
        findings.append(
            Finding(
                "note",
                "sampled",
                name,
                "the system has no continuous history",
                f"sampled at {rate:g} Hz between its events",
            )
        )
    header = TracksHeader(table=table, radius=radius, rate=rate if exact else None)
    return ForeignTracks(header, samples, findings)


def _history(at: Place, rate: float) -> tuple[NDArray[np.float64], NDArray[np.float64], bool]:
    """Times and places of a ball; whether they were computed between its events."""
    continuous = _states(at.get("history_cts"))
    states = continuous or _states(at.get("history"))
    if not states:
        raise at.refuse("missing", "has no history", "simulate the system before it is saved")
    times = np.array([time for time, _, _, _ in states])
    places = np.array([place for _, place, _, _ in states])
    velocities = np.array([velocity for _, _, velocity, _ in states])
    pocketed = np.array([motion == _POCKETED for _, _, _, motion in states])
    if continuous:
        keep = ~pocketed & np.r_[True, np.diff(times) > 0.0]
        return times[keep], places[keep], False
    end = times[pocketed][0] if pocketed.any() else times[-1]
    wanted = np.arange(0.0, end + 1e-12, 1.0 / rate)
    wanted = wanted[wanted < end] if pocketed.any() else wanted
    return wanted, _between(wanted, times, places, velocities), True


def _between(
    wanted: NDArray[np.float64],
    times: NDArray[np.float64],
    places: NDArray[np.float64],
    velocities: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Places between events: the quadratic through both places with the velocity of the first.

    Every motion between two events has a constant acceleration.
    """
    # The last of the states at one time is that after its events.
    index = np.searchsorted(times, wanted, side="right") - 1
    after = np.minimum(index + 1, len(times) - 1)
    # The place of an event is the same before and after it.
    span = times[after] - times[index]
    since = (wanted - times[index])[:, None]
    whole = np.where(span > 0.0, span, 1.0)[:, None]
    drift = places[index] + velocities[index] * since
    rest = places[after] - places[index] - velocities[index] * whole
    bent = drift + rest * (since / whole) ** 2
    return np.where((span > 0.0)[:, None], bent, places[index])


def _states(
    at: Place | None,
) -> list[tuple[float, Sequence[float], Sequence[float], float]]:
    """Time, place, velocity and motion of each state of a history; empty without one."""
    if at is None:
        return []
    history = at["states"] if isinstance(at.value, Mapping) else at
    if not history.value:
        return []
    items = history.items()
    if isinstance(items[0], Mapping):
        entries = [history[i] for i in range(len(items))]
        rows = [(e["rvw"], e["s"].number(), e["t"].number()) for e in entries]
    else:
        # MessagePack has three arrays: rvw, s, t.
        motions, times = history[1].items(), history[2].items()
        if not len(history[0].items()) == len(motions) == len(times):
            raise history.refuse("wrong-count", "has arrays of different lengths")
        rows = [
            (history[0][i], history[1][i].number(), history[2][i].number())
            for i in range(len(times))
        ]
    return [(t, rvw[0].vector()[:2], rvw[1].vector()[:2], s) for rvw, s, t in rows]

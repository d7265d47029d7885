"""A tracked shot cut into contacts and free runs."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING

from carom.arguments import instance
from carom.lazy import np
from carom.learn.contacts import Contact, Found, contacts_of
from carom.learn.findings import Finding
from carom.learn.header import TracksHeader
from carom.learn.kinks import Path, path_of
from carom.learn.noise_of_track import noise_of, sigma_of
from carom.learn.tracks import TrackedShot

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Vector = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Run:
    """The free motion of one ball between two contacts.

    Attributes:
        ball: The ball.
        first: Its first sample, an index into the samples in which the ball was seen.
        last: Its last sample.
        start: When it begins, s: at a contact, at the strike, or at its first sample.
        end: When it ends, s: at a contact, at rest, or at its last sample.
        before: Index of the contact at its start; None if there is none.
        after: Index of the contact at its end; None if there is none.
        stops: Whether the ball comes to rest in it.
    """

    ball: str
    first: int
    last: int
    start: float
    end: float
    before: int | None
    after: int | None
    stops: bool


@dataclass(frozen=True, slots=True)
class Segments:
    """What was found in a tracked shot.

    Attributes:
        runs: The free motions, in order of their start.
        contacts: The contacts, in order of time.
        struck: The ball that moved first; None if none moves.
        start: When it started, s; the strike on the clock of the tracks.
        start_sigma: Its standard deviation, s; infinite if the ball moves in its first sample.
        sigma: Median standard deviation of a coordinate of each ball, m.
        findings: What could not be explained.
    """

    runs: tuple[Run, ...]
    contacts: tuple[Contact, ...]
    struck: str | None
    start: float
    start_sigma: float
    sigma: Mapping[str, float]
    findings: tuple[Finding, ...]


def segment(shot: TrackedShot, header: TracksHeader) -> Segments:
    """Find the contacts and the free runs of a tracked shot.

    Each ball's track is cut where its velocity changes. A cut at a rail or at another ball is a
    contact with it. Its time is where the motions before and after it meet; so a ball that was
    stored only after it had moved starts when its path leaves its place of rest.

    Args:
        shot: The shot.
        header: Its tracks' header, with the table and the radius of the balls; without them no
            contact has a cause.

    Raises:
        InputError: An argument has a wrong type.
    """
    instance("shot", shot, TrackedShot, "tracks[0]")
    instance("header", header, TracksHeader, "tracks.header")
    return segments_of(shot, header, paths_of(shot, header))


def paths_of(shot: TrackedShot, header: TracksHeader) -> dict[str, Path]:
    """The paths of the balls that were seen at least twice."""
    seen = {ball: track for ball, track in shot.balls.items() if track.visible.sum() >= 2}
    known = header.sigma
    if known is None:
        # A ball that moved too little to tell has the errors of the others.
        found = [value for value in map(noise_of, seen.values()) if value is not None]
        known = float(np.median(found)) if found else None
    return {ball: path_of(ball, track.seen, sigma_of(track, known)) for ball, track in seen.items()}


def segments_of(shot: TrackedShot, header: TracksHeader, paths: Mapping[str, Path]) -> Segments:
    """As ``segment``, of paths that are known already."""
    struck, start, start_sigma = _struck(paths)
    found = contacts_of(paths, header, struck, start)
    contacts = found.contacts
    runs = [run for path in paths.values() for run in _runs(path, found)]
    runs.sort(key=lambda run: (run.start, run.ball))
    sigma = {ball: float(np.median(path.sigma)) for ball, path in paths.items()}
    return Segments(
        tuple(runs),
        tuple(contacts),
        struck,
        start,
        start_sigma,
        MappingProxyType(sigma),
        tuple(_unknown(shot.name, contacts)),
    )


def _unknown(shot: str, contacts: list[Contact]) -> list[Finding]:
    return [
        Finding(
            "warning",
            "unknown-contact",
            f"shot {shot}, ball {contact.balls[0]}, {contact.time:.3f} s",
            f"the velocity changes by {contact.change:.2f} m/s away from rails and balls",
            "look for samples that are missing or wrong, or for a hand on the table",
        )
        for contact in contacts
        if not contact.is_known
    ]


def _struck(paths: Mapping[str, Path]) -> tuple[str | None, float, float]:
    """The ball that moves first, when, and the standard deviation of the time."""
    starts = []
    for ball, path in paths.items():
        if not all(path.rests) and not path.rests[0]:
            starts.append((float(path.track.time[0]), math.inf, ball))
        starts += [(k.time, k.sigma, ball) for k in path.kinks if k.starts][:1]
    if not starts:
        return None, math.nan, math.inf
    time, sigma, ball = min(starts)
    return ball, time, sigma


def _runs(path: Path, found: Found) -> list[Run]:
    """The free motions of a ball; a kink without a cause does not end one."""
    track = path.track
    kinks = [
        kink
        for kink in path.kinks
        if kink.starts or {(kink.ball, kink.last)} & (found.before.keys() | found.after.keys())
    ]
    firsts = [0, *(kink.next for kink in kinks)]
    lasts = [*(kink.last for kink in kinks), len(track) - 1]
    runs = []
    for number, (first, last) in enumerate(zip(firsts, lasts, strict=True)):
        moving = [
            piece
            for piece, rests in zip(path.pieces, path.rests, strict=True)
            if piece[0] >= first and piece[1] <= last and not rests
        ]
        if not moving:
            continue
        # The rest at the end, if the ball stops, is not part of the run.
        stops = moving[-1][1] < last
        before = after = None
        start, end = float(track.time[moving[0][0]]), float(track.time[moving[-1][1]])
        if number:
            kink = kinks[number - 1]
            before = found.before.get((path.ball, kink.last))
            start = kink.time if before is None else found.contacts[before].time
        if not stops and number < len(kinks):
            kink = kinks[number]
            after = found.after.get((path.ball, kink.last))
            end = kink.time if after is None else found.contacts[after].time
        runs.append(Run(path.ball, moving[0][0], moving[-1][1], start, end, before, after, stops))
    return runs

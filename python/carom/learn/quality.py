"""How good tracks are, shot by shot, and what in them contradicts the header."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

from carom.arguments import instance
from carom.columns import lines
from carom.lazy import np
from carom.learn.findings import Finding
from carom.learn.header import TracksHeader
from carom.learn.kinks import Path
from carom.learn.rails import cushions_of
from carom.learn.recordings import moving_spans
from carom.learn.segment import Segments, paths_of, segments_of
from carom.learn.tracks import TrackedShot, Tracks

if TYPE_CHECKING:
    from numpy.typing import NDArray

# Contacts of two balls from which a radius is estimated; fewer tell nothing.
_LEAST_CONTACTS = 5
# Standard deviation of the places of these contacts, m.
_PRECISE = 0.003
# Difference of the radius from the header's that is reported, as a share of it: a ball of another
# game differs by 7 % at least.
_RADIUS_SHARE = 0.04
# Distance of a rail from its place in the header that is reported, m, and the contacts it needs.
_RAIL_OFF = 0.006
_RAIL_CONTACTS = 6
# Deceleration of rolling balls, m/s²: that of fast and of slow cloths, with room. The square root
# of its ratio to the usual one is the factor by which a clock would be wrong.
_SLOWEST, _FASTEST, _USUAL = 0.02, 0.35, 0.08
_LEAST_ROLLS = 5
# Difference of the measured rate from the header's that is reported, as a share.
_RATE_SHARE = 0.04
# A gap in which a moving ball is not seen counts from this, s.
_GAP = 0.15
# Grades: noise, m; unknown contacts and gaps per shot.
_NOISY, _TOO_NOISY = 0.004, 0.012
_PARTS_OF_A_SHOT = 3


@dataclass(frozen=True, slots=True)
class ShotQuality:
    """How good the tracks of a shot are.

    Attributes:
        name: The shot.
        grade: ``"good"``, ``"usable"`` or ``"bad"``.
        balls: Number of balls.
        samples: Number of samples in which a ball was seen.
        duration: From the first sample to the last, s.
        moving: Time from the first motion to the last, s.
        rate: Samples per second of moving balls, Hz; 0 if none moves.
        gaps: Times at which a moving ball was not seen for 0.15 s or more.
        longest_gap: The longest of them, s; 0 without one.
        sigma: Standard deviation of a coordinate, of the worst ball, m.
        contacts: Contacts whose cause is known.
        unknown_contacts: Changes of velocity without a cause.
        struck: The ball that moved first; None if none moves.
        reasons: Why the grade is not good.
    """

    name: str
    grade: str
    balls: int
    samples: int
    duration: float
    moving: float
    rate: float
    gaps: int
    longest_gap: float
    sigma: float
    contacts: int
    unknown_contacts: int
    struck: str | None
    reasons: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class TracksReport:
    """What ``check`` found; ``print`` it.

    Attributes:
        header: The header of the tracks.
        shots: The quality of each shot.
        findings: What the reader and the check found.
        radius: Radius of the balls from their contacts, m; None if there are too few.
        rolling_deceleration: Of rolling balls, median, m/s²; None if too few roll.
        sigma: Standard deviation of a coordinate, median over the balls, m.
    """

    header: TracksHeader
    shots: tuple[ShotQuality, ...]
    findings: tuple[Finding, ...]
    radius: float | None
    rolling_deceleration: float | None
    sigma: float

    def to_dict(self) -> dict[str, Any]:
        """Plain values."""
        return {
            "header": self.header.to_dict(),
            "radius": self.radius,
            "rolling_deceleration": self.rolling_deceleration,
            "sigma": self.sigma,
            "findings": [asdict(finding) for finding in self.findings],
            "shots": [asdict(shot) for shot in self.shots],
        }

    def __str__(self) -> str:
        header = self.header
        samples = sum(shot.samples for shot in self.shots)
        table = header.table if isinstance(header.table, str) else "a table of its own"
        grades = [shot.grade for shot in self.shots]
        counts = ", ".join(f"{grades.count(grade)} {grade}" for grade in ("good", "usable", "bad"))
        count = len(self.shots)
        top = [
            f"{count} shot{'s' * (count != 1)}, {samples} samples on "
            f"{'an unknown table' if header.table is None else table}: {counts}",
            f"noise {1e3 * self.sigma:.2f} mm per coordinate",
        ]
        if self.radius is not None:
            known = "" if header.radius is None else f" (header: {1e3 * header.radius:.2f} mm)"
            top.append(f"radius of the balls from contacts {1e3 * self.radius:.2f} mm{known}")
        if self.rolling_deceleration is not None:
            top.append(f"rolling balls slow down by {self.rolling_deceleration:.3f} m/s²")
        words = {"note": "note", "repair": "repaired", "warning": "warning"}
        found = [f"{words[finding.level]}: {finding}" for finding in self.findings]
        return "\n".join([*top, *found, "", *_table(self.shots)])


def _table(shots: tuple[ShotQuality, ...]) -> list[str]:
    head = (
        "shot",
        "balls",
        "samples",
        "s",
        "moving s",
        "Hz",
        "gaps",
        "longest s",
        "noise mm",
        "contacts",
        "unknown",
        "struck",
        "quality",
    )
    rows = [
        (
            shot.name,
            str(shot.balls),
            str(shot.samples),
            f"{shot.duration:.1f}",
            f"{shot.moving:.1f}",
            f"{shot.rate:.0f}",
            str(shot.gaps),
            f"{shot.longest_gap:.2f}",
            f"{1e3 * shot.sigma:.2f}",
            str(shot.contacts),
            str(shot.unknown_contacts),
            shot.struck or "–",
            ": ".join(filter(None, (shot.grade, ", ".join(shot.reasons)))),
        )
        for shot in shots
    ]
    return lines([head, *rows], right_aligned=range(1, 11))


def check(tracks: Tracks) -> TracksReport:
    """Check tracks: the quality of each shot, and what contradicts the header.

    Args:
        tracks: Tracks, such as ``read_tracks`` gives them.

    Raises:
        InputError: It is another object.
    """
    instance("tracks", tracks, Tracks, "learn.read_tracks(...)")
    header = tracks.header
    findings = list(tracks.findings)
    qualities = []
    distances: list[float] = []
    decelerations: list[float] = []
    offsets: dict[str, list[float]] = {}
    sigmas: list[float] = []
    for shot in tracks:
        paths = paths_of(shot, header)
        segments = segments_of(shot, header, paths)
        findings += segments.findings
        qualities.append(_quality(shot, segments))
        distances += _contact_distances(paths)
        decelerations += _decelerations(paths)
        _add_offsets(paths, header, offsets)
        sigmas += [segments.sigma[ball] for ball in {run.ball for run in segments.runs}]
    radius = None
    if len(distances) >= _LEAST_CONTACTS:
        radius = 0.5 * float(np.median(distances))
    rolling = float(np.median(decelerations)) if len(decelerations) >= _LEAST_ROLLS else None
    findings += _whole(tracks, qualities, radius, rolling, offsets)
    return TracksReport(
        header,
        tuple(qualities),
        tuple(findings),
        radius,
        rolling,
        float(np.median(sigmas)) if sigmas else math.nan,
    )


def _whole(
    tracks: Tracks,
    qualities: list[ShotQuality],
    radius: float | None,
    rolling: float | None,
    offsets: Mapping[str, list[float]],
) -> list[Finding]:
    """What the shots together tell of the header."""
    header = tracks.header
    found: list[Finding] = []

    def warn(kind: str, fault: str, remedy: str) -> None:
        found.append(Finding("warning", kind, "all shots", fault, remedy))

    if all(quality.struck is None for quality in qualities):
        warn("no-motion", "no ball moves", "check the times and the unit of the places")
    elif len(qualities) == 1:
        found.append(
            Finding(
                "note",
                "one-shot",
                "all shots",
                "there is only one shot",
                "a table needs about ten, and a player more",
            )
        )
    if radius is not None and header.radius is not None:
        share = radius / header.radius
        if abs(share - 1.0) > _RADIUS_SHARE:
            warn(
                "wrong-radius",
                f"balls meet at a distance of {2e3 * radius:.1f} mm, but the header has a radius "
                f"of {1e3 * header.radius:.2f} mm",
                f"give radius={radius:.5f}, or mend the scale of the places",
            )
    if rolling is not None and not _SLOWEST <= rolling <= _FASTEST:
        factor = math.sqrt(rolling / _USUAL) if rolling > 0.0 else 0.0
        warn(
            "wrong-clock",
            f"rolling balls slow down by {rolling:.3f} m/s², where cloth gives {_SLOWEST:g} to "
            f"{_FASTEST:g}",
            f"check the rate and the unit of time; times {factor:.2g} times as long would be usual"
            if factor
            else "check the times",
        )
    rates = [quality.rate for quality in qualities if quality.rate]
    if header.rate is not None and rates and header.least_move is None:
        rate = float(np.median(rates))
        if abs(rate / header.rate - 1.0) > _RATE_SHARE:
            warn(
                "wrong-rate",
                f"moving balls have {rate:.1f} samples per second, and the header {header.rate:g}",
                "mend the rate, or the unit of the times",
            )
    for rail, values in sorted(offsets.items()):
        off = float(np.median(values))
        if len(values) >= _RAIL_CONTACTS and abs(off) > _RAIL_OFF:
            way = "outside" if off < 0.0 else "inside"
            warn(
                "rail-off",
                f"balls turn back {1e3 * abs(off):.0f} mm {way} the {rail} rail of the header",
                "mend the origin, the scale, the table or the radius",
            )
    return found


def _quality(shot: TrackedShot, segments: Segments) -> ShotQuality:
    spans = moving_spans(shot)
    moving = spans[-1][1] - spans[0][0] if spans else 0.0
    steps, gaps = _steps_and_gaps(shot, segments)
    rate = 1.0 / float(np.median(steps)) if steps.size else 0.0
    moved = {run.ball for run in segments.runs}
    sigma = max((segments.sigma[ball] for ball in moved), default=math.nan)
    unknown = sum(not contact.is_known for contact in segments.contacts)
    reasons: list[str] = []
    bad = False
    if segments.struck is None:
        reasons.append("no ball moves")
        bad = True
    if len(spans) > 1:
        reasons.append(f"{len(spans)} motions with rests between them: cut it into shots")
    if sigma > _NOISY:
        reasons.append(f"noise of {1e3 * sigma:.1f} mm")
        bad |= sigma > _TOO_NOISY
    if gaps.size:
        reasons.append(f"{gaps.size} gap{'s' * (gaps.size != 1)}")
    if unknown:
        reasons.append(f"{unknown} unknown contact{'s' * (unknown != 1)}")
        bad |= unknown >= _PARTS_OF_A_SHOT
    grade = "bad" if bad else "usable" if reasons else "good"
    return ShotQuality(
        name=shot.name,
        grade=grade,
        balls=len(shot.balls),
        samples=sum(int(ball.visible.sum()) for ball in shot.balls.values()),
        duration=shot.end - shot.start,
        moving=moving,
        rate=rate,
        gaps=int(gaps.size),
        longest_gap=float(gaps.max()) if gaps.size else 0.0,
        sigma=sigma,
        contacts=len(segments.contacts) - unknown,
        unknown_contacts=unknown,
        struck=segments.struck,
        reasons=tuple(reasons),
    )


def _steps_and_gaps(
    shot: TrackedShot, segments: Segments
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Times between samples of moving balls, s, and those that are gaps.

    Under a sampling rule a slow ball has long steps; a step in which it moved far is a gap.
    """
    steps, gaps = [np.empty(0)], [np.empty(0)]
    for run in segments.runs:
        ball = shot.balls[run.ball].seen
        own = slice(run.first, run.last + 1)
        step = np.diff(ball.time[own])
        way = np.hypot(*np.diff(ball.position[own], axis=0).T)
        usual = float(np.median(way)) if way.size else 0.0
        steps.append(step)
        gaps.append(step[(step >= _GAP) & (way > 3.0 * usual)])
    return np.concatenate(steps), np.concatenate(gaps)


def _contact_distances(paths: Mapping[str, Path]) -> list[float]:
    """Distances of two balls whose velocities change oppositely at one time, m."""
    kinks = sorted((k for path in paths.values() for k in path.kinks), key=lambda k: k.time)
    found = []
    for i, a in enumerate(kinks):
        for b in kinks[i + 1 :]:
            if b.time - a.time > 0.01 + 3.0 * math.hypot(a.sigma, b.sigma):
                break
            if a.ball == b.ball or not (a.meets and b.meets):
                continue
            line = b.place - a.place
            distance = float(np.hypot(*line))
            # Only clear contacts: precise ones, in which the balls push each other apart.
            if distance < 0.2 and max(a.place_sigma, b.place_sigma) < _PRECISE:
                along = min(-_share(a.change, line), _share(b.change, line))
                if along > 0.9:
                    found.append(distance)
    return found


def _share(change: NDArray[np.float64], line: NDArray[np.float64]) -> float:
    """The cosine of the angle between a change of velocity and a line."""
    return float(change @ line) / float(np.hypot(*change) * np.hypot(*line))


def _decelerations(paths: Mapping[str, Path]) -> list[float]:
    """Decelerations of balls that roll: in long pieces at a low speed, m/s²."""
    found = []
    for path in paths.values():
        for (first, last), rests in zip(path.pieces, path.rests, strict=True):
            time = path.track.time
            if rests or last - first < 8 or time[last] - time[first] < 0.6:
                continue
            motion = path.motion(float(time[last]), before=True)
            speed = float(np.hypot(*motion.velocity(float(time[last]))))
            if 0.1 < speed < 1.0:
                along = motion.velocity(float(time[last])) / speed
                found.append(-2.0 * float(motion.values[2] @ along))
    return found


def _add_offsets(
    paths: Mapping[str, Path], header: TracksHeader, offsets: dict[str, list[float]]
) -> None:
    """Distances from the noses of kinks that are rebounds, m; negative beyond them."""
    noses = [cushion for cushion in cushions_of(header) if cushion.part == "nose"]
    for path in paths.values():
        for kink in path.kinks:
            size = float(np.hypot(*kink.change))
            if not kink.meets or kink.starts or size < 0.2:
                continue
            for nose in noses:
                distance, away = nose.contact(kink.place)
                turns = float(kink.incoming @ away) < 0.0 < float(kink.outgoing @ away)
                if abs(distance) < 0.06 and turns and float(kink.change @ away) > 0.9 * size:
                    offsets.setdefault(nose.rail, []).append(distance)

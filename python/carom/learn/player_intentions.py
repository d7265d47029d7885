"""What a player may have intended with a strike: the strikes near it that score."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Self

from carom import _core
from carom.arguments import whole
from carom.errors import InputError
from carom.lazy import np
from carom.learn.player_errors import SCALE, PlayedStrike
from carom.sweeps.play import RowArguments

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Ints = NDArray[np.int64]

#: Azimuths that are tried, on either side of the played one, and their distance, rad.
REACH, GRID = math.radians(3.0), math.radians(0.05)
#: How far speed (logarithm), elevation (rad), side and height (m) vary about the played strike
#: while a window of azimuths is followed.
BOX = (0.15, math.radians(1.5), 0.003, 0.003)
#: Strikes within this box for which the azimuths are swept.
STYLES = 64
#: The window of an intention is seen for at least this share of them.
SEEN = 0.3
#: Largest number of windows of one kind, such as a ball and a pocket.
WINDOWS = 3
#: A window belongs to an intention if its middle is this close to the line of the others, rad.
NEAR = math.radians(0.4)
#: What the player intends of speed, elevation, side and height is unknown: its standard deviation,
#: in units of the scale of an error.
FLAT = 30.0
#: Largest tip offset, ball radii.
OFFSET = 0.5
#: The columns of a strike that are not its azimuth.
STYLE = (0, 2, 3, 4)
GOALS = ("pot", "carom")


@dataclass(frozen=True, slots=True, eq=False)
class Intentions:
    """Strikes that may have been intended.

    Attributes:
        vectors: As ``PlayedStrike.vector``, shape (j, 5).
        covariances: What each leaves open, shape (j, 5, 5).
        weights: Their probabilities a priori, shape (j,); the sum is 1.
        windows: Width of the azimuths that score, rad, shape (j,).
        log_background: Logarithm of the density of strikes with other intentions, in the units of
            the vector; None for a density that suits a known intention.
    """

    vectors: Floats
    covariances: Floats
    weights: Floats
    windows: Floats
    log_background: float | None = None

    @classmethod
    def known(cls, vector: Floats) -> Self:
        """One intention that is known, shape (5,)."""
        return cls(vector[None], np.zeros((1, 5, 5)), np.ones(1), np.zeros(1))

    def nearest(self, played: Floats) -> Self:
        """The one whose azimuth is nearest to the played strike's."""
        away = np.abs(np.remainder(played[1] - self.vectors[:, 1] + np.pi, 2 * np.pi) - np.pi)
        at = slice(int(away.argmin()), int(away.argmin()) + 1)
        one = np.minimum(self.weights[at], 1.0)
        alone = np.where(one > 1e-6, 1.0, one)
        return replace(
            self,
            vectors=self.vectors[at],
            covariances=self.covariances[at],
            weights=alone,
            windows=self.windows[at],
        )

    def anywhere(self) -> Self:
        """The same, aimed with equal probability anywhere in its window, not at the middle."""
        wider = self.covariances.copy()
        wider[:, 1, 1] += self.windows**2 / 12.0
        return replace(self, covariances=wider)

    def by_window(self) -> Self:
        """The same, with probabilities in proportion to the windows."""
        if not self.windows.any():
            return self
        return replace(self, weights=self.windows / self.windows.sum())

    def with_background(self, factor: float) -> Self:
        """The same with another density of the background."""
        if self.log_background is None:
            return self
        return replace(self, log_background=self.log_background + math.log(factor))


def find_intentions(
    strike: PlayedStrike,
    *,
    goal: str | None = None,
    balls: Sequence[str] | None = None,
    seed: int = 0,
) -> Intentions:
    """The intentions that a strike may have had: the middles of the azimuths that score.

    For 64 strikes about the played one, which differ in speed, elevation and tip offset, all
    azimuths within 3° are played. An interval of azimuths that score in the same way, such as by
    the same ball in the same pocket, is a window. Its middle is followed as a linear function of
    speed, elevation, side and height, which are themselves taken as unknown: a match does not tell
    with which speed and spin a player wanted to score.

    Args:
        strike: The played strike. Its shot has the balls as they lay.
        goal: ``"pot"``: a ball falls and the struck ball stays on the table. ``"carom"``: the
            struck ball touches three cushions before the second ball. None is the first on a table
            with pockets, and the second on others.
        balls: The balls that may be potted; None is all but the struck one.
        seed: Seed of the strikes that are tried.

    Returns:
        The intentions; without any that scores, one of negligible weight.

    Raises:
        InputError: The goal or a ball is unknown.
    """
    chosen = goal or ("pot" if strike.shot.geometry()["pockets"] else "carom")
    if chosen not in GOALS:
        raise InputError(
            "unknown-name", "goal", f"there is no {chosen!r}", f"write one of {', '.join(GOALS)}"
        )
    styles = _styles(strike, seed)
    azimuth = strike.vector[1] + np.arange(-REACH, REACH + GRID / 2.0, GRID)
    ways = _ways(strike, styles, azimuth, chosen, balls)
    found = []
    for way in np.unique(ways[ways >= 0]).tolist():
        found += _families(styles - strike.vector[[*STYLE]], azimuth, ways == way)
    return _intentions_of(strike, found)


def _styles(strike: PlayedStrike, seed: int) -> Floats:
    """Speed (logarithm), elevation, side and height about the played strike, shape (n, 4)."""
    random = np.random.default_rng((whole("seed", seed), 0x1A7E))
    moves = random.uniform(-1.0, 1.0, (STYLES, 4)) * BOX
    moves[0] = 0.0
    styles: Floats = strike.vector[[*STYLE]] + moves
    styles[:, 1] = np.abs(styles[:, 1])
    return styles


def _ways(
    strike: PlayedStrike,
    styles: Floats,
    azimuth: Floats,
    goal: str,
    balls: Sequence[str] | None,
) -> Ints:
    """In which way each strike scores, shape (styles, azimuths); −1 if it does not."""
    shot = strike.shot
    count, size = len(styles), len(azimuth)
    each = np.repeat(styles, size, axis=0)
    struck = shot.strike.ball if shot.strike is not None else None
    cue = shot.ids.index(struck) if struck in shot.ids else 0
    radius = float(shot.radius[cue])
    columns = [
        ("speed", np.exp(each[:, 0])),
        ("azimuth_deg", np.degrees(np.tile(azimuth, count))),
        ("elevation_deg", np.degrees(each[:, 1])),
        ("side", each[:, 2] / radius),
        ("height", each[:, 3] / radius),
    ]
    rows = len(each)
    arguments = RowArguments(
        [shot._core], np.zeros(rows, np.int32), [], columns, None, 0, np.zeros(rows, np.int64)
    )
    found = _core.play_rows(arguments, len(shot.ids), goal == "carom", None)
    if goal == "carom":
        score = found["rails_before_second_ball"] >= 3
        ways = np.where(score, found["first_contact"], -1)
    else:
        ways = _pots(shot.ids, cue, balls, found["pocket"])
    out: Ints = ways.astype(np.int64).reshape(count, size)
    offset = np.hypot(styles[:, 2], styles[:, 3]) / radius
    out[offset > OFFSET] = -1
    return out


def _pots(ids: list[str], cue: int, balls: Sequence[str] | None, pocket: NDArray[np.int8]) -> Ints:
    """The ball and the pocket of each row as one number; −1 without a pot."""
    for ball in balls or ():
        if ball not in ids:
            raise InputError(
                "unknown-ball", "balls", f"there is no {ball!r}", f"write one of {', '.join(ids)}"
            )
    wanted = [i for i in range(len(ids)) if i != cue and (balls is None or ids[i] in balls)]
    way = np.full(len(pocket), -1, dtype=np.int64)
    for index in wanted:
        falls = (pocket[:, index] >= 0) & (pocket[:, cue] == -1) & (way < 0)
        way[falls] = index * 128 + pocket[falls, index].astype(np.int64)
    return way


@dataclass(frozen=True, slots=True)
class _Family:
    """Windows of neighbouring strikes: the middle is a linear function of the style.

    Attributes:
        middle: At the played style, rad.
        slope: By speed (logarithm), elevation, side and height, shape (4,).
        scatter: Standard deviation of the middles about the line, rad.
        width: Mean width, rad.
    """

    middle: float
    slope: Floats
    scatter: float
    width: float


def _families(moves: Floats, azimuth: Floats, scores: NDArray[np.bool_]) -> list[_Family]:
    """The windows of one way to score, followed over the styles."""
    edges = np.diff(np.pad(scores, ((0, 0), (1, 1))).astype(np.int8), axis=1)
    style, start = np.nonzero(edges == 1)
    _, end = np.nonzero(edges == -1)
    # A window that is cut off by the reach has an unknown middle.
    inside = (start > 0) & (end < len(azimuth))
    style, start, end = style[inside], start[inside], end[inside]
    middle = (azimuth[start] + azimuth[end - 1]) / 2.0
    width: Floats = ((end - start) * GRID).astype(np.float64)
    families: list[_Family] = []
    while len(middle) and len(families) < WINDOWS:
        one, taken = _family(moves[style], middle, width)
        if one is None:
            break
        if len(np.unique(style[taken])) >= SEEN * len(moves):
            families.append(one)
        style, middle, width = style[~taken], middle[~taken], width[~taken]
    return families


def _family(
    moves: Floats, middle: Floats, width: Floats
) -> tuple[_Family | None, NDArray[np.bool_]]:
    """A line through as many middles as possible, and which of them belong to it."""
    design = np.column_stack((np.ones(len(middle)), moves))
    line: Floats = np.zeros(5)
    # The widest windows are those that a player is most likely to follow.
    line[0] = np.median(middle[width >= np.quantile(width, 0.75)])
    near = np.ones(len(middle), dtype=np.bool_)
    for reach in (4.0, 2.0, 1.0, 1.0):
        near = np.abs(middle - design @ line) < reach * NEAR
        if near.sum() < 10:
            return None, near
        line = np.linalg.lstsq(design[near], middle[near], rcond=None)[0].astype(np.float64)
    rest = middle[near] - design[near] @ line
    scatter = float(np.sqrt((rest @ rest) / (near.sum() - 5)))
    return _Family(float(line[0]), line[1:], scatter, float(width[near].mean())), near


def _intentions_of(strike: PlayedStrike, families: list[_Family]) -> Intentions:
    scale = np.array(SCALE)
    style = np.array(STYLE)
    flat = FLAT * scale[style]
    density = -2.0 * math.log(2.0 * math.pi) - np.log(flat).sum() - math.log(2.0 * math.pi)
    if not families:
        wide = np.diag((FLAT * scale) ** 2)
        return Intentions(
            strike.vector[None], wide[None], np.array([1e-12]), np.zeros(1), float(density)
        )
    vectors = np.tile(strike.vector, (len(families), 1))
    covariances = np.zeros((len(families), 5, 5))
    for row, family in enumerate(families):
        vectors[row, 1] = family.middle
        lead = np.zeros((5, 4))
        lead[style, np.arange(4)] = 1.0
        lead[1] = family.slope
        covariances[row] = (lead * flat**2) @ lead.T
        covariances[row, 1, 1] += family.scatter**2 + GRID**2 / 6.0
    weights = np.full(len(families), 1.0 / len(families))
    windows = np.array([family.width for family in families])
    return Intentions(vectors, covariances, weights, windows, float(density))

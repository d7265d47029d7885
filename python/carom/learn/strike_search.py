"""The strike of a filmed shot: what the cue did, from what the balls did."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from carom.candidates import Candidates
from carom.lazy import np
from carom.learn import levenberg
from carom.learn.intended_strikes import IntendedStrike
from carom.learn.observation import Observation, first_move
from carom.learn.table_model import Frame
from carom.learn.tracks import TrackedBall
from carom.shot import Shot
from carom.tracks import BallTracks, track_residuals

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

#: The numbers of a strike, in the order of a vector: the strike's own, and the time of the strike
#: on the clock of the tracks, s.
NAMES = ("azimuth", "speed", "side", "height", "elevation", "clock")
#: A useful step of each.
STEPS = (0.01, 0.05, 0.08, 0.08, 0.03, 0.008)
#: Largest distance of the tip from the centre, in radii, that a search looks at.
LARGEST_OFFSET = 0.6
#: The same of the elevation, rad, and of the speed, m/s.
LARGEST_ELEVATION = 0.9
LARGEST_SPEED = 12.0
#: The elevation, the height and the side of a strike trade off. Among strikes that explain a shot
#: equally well the one nearest to the elevation of a plain stroke, rad, is taken: a radian away
#: costs as much as an error of 0.05 m in one coordinate of one picture.
PLAIN_ELEVATION = 0.05
PLAIN_WEIGHT = 0.05
#: Standard deviation of the starts about an intended strike if it is not known: azimuth (rad),
#: speed (m/s), side, height (ball radii), elevation (rad). That of a weak player; the first start
#: is the intended strike itself.
NEAR = (0.01, 0.2, 0.1, 0.1, 0.03)
#: A number of a strike that is one standard deviation from the intended one costs as much as this
#: error, m, in one coordinate of one picture: the standard deviation of model minus track at first.
INTENDED_WEIGHT = 0.004
#: Balls that begin to move so soon after the struck one, s, met it at once.
AT_ONCE = 0.15
#: Time over which a velocity after such a contact is taken, s.
FIRST_PICTURES = 0.07
#: Errors of an azimuth, rad, and of a speed, as a share, that come from so few pictures.
AZIMUTH_ERROR = 0.05
SPEED_ERROR = 0.1
#: A useful step of a place of rest, m, if it is free.
REST_STEP = 0.001
#: A place of rest that is one standard deviation away costs as much as this error, m, in one
#: coordinate of one picture. It is that of ``SCALE``, so that it pays only if it helps for long.
REST_WEIGHT = 0.03
#: The model has left the track where it is farther from it than this, m.
APART = 0.08
#: The first horizon of a search, s, and its growth.
FIRST_HORIZON = 0.8
GROWTH = 1.5
#: Least number of strikes that are kept while the horizon grows.
FEWEST = 6
#: Scale of the robust loss while the horizon grows, m.
SCALE = 0.03


class StrikeProblem:
    """Residuals of strikes of one shot on one table.

    Args:
        observed: What was seen.
        shot: The balls as they lay.
        frame: Where the tracks lie on the table.
        rest: Standard deviation of the places where the balls lay, m; they are then part of a
            vector, behind the numbers of the strike, as displacements in x and y of each ball. None
            takes the places as they were seen.
        intended: The intended strike, if it is known.
    """

    def __init__(
        self,
        observed: Observation,
        shot: Shot,
        frame: Frame,
        rest: float | None = None,
        intended: IntendedStrike | None = None,
    ) -> None:
        self.intended = intended
        self.observed = observed
        self.shot = shot
        self.frame = frame
        self.rest = rest
        self.places = np.array([ball["position"][:2] for ball in shot.to_dict()["balls"]])

    @property
    def steps(self) -> Floats:
        """A useful step of each number of a vector."""
        rest = [] if self.rest is None else [REST_STEP] * self.places.size
        return np.array([*STEPS, *rest])

    def residuals(self, horizon: float) -> Callable[[Floats], Floats]:
        """The function from vectors, (n, p), to model minus track, m, (n, m), up to a time.

        The last columns are the prior's. A vector of the strike's numbers alone takes the balls
        where they were seen.
        """
        tracks = self.observed.until(horizon)

        def at(vectors: Floats) -> Floats:
            strike, moved = np.split(vectors, [len(STEPS)], axis=1)
            places = self.places + moved.reshape(len(moved), -1, 2) if moved.size else None
            found = residuals(self.shot, strike, tracks, self.frame, places)
            low, high = self.observed.strike_time
            clock = strike[:, -1]
            found[(clock < low) | (clock > high)] = np.nan
            tilt = PLAIN_WEIGHT * (np.abs(strike[:, 4:5]) - PLAIN_ELEVATION)
            away = moved * (REST_WEIGHT / self.rest) if self.rest else moved
            return np.concatenate((found, self._from_intended(strike), tilt, away), axis=1)

        return at

    def _from_intended(self, strike: Floats) -> Floats:
        """How far strikes, (n, 6), are from the intended one, as errors of a coordinate, m."""
        if self.intended is None:
            return strike[:, :0]
        apart = strike[:, :5] - self.intended.vector
        apart[:, 0] = np.remainder(apart[:, 0] + np.pi, 2.0 * np.pi) - np.pi
        apart[:, 4] = np.abs(strike[:, 4]) - self.intended.vector[4]
        return INTENDED_WEIGHT * apart / self.intended.sigma

    def starts(self, count: int, random: np.random.Generator) -> Floats:
        """Strikes at which a search begins, shape (starts, 6).

        They are near the intended one. If that is not known, the azimuth and the speed are those
        that the first pictures show, and the tip's offset and the elevation are drawn. There are
        ``count`` starts for each way to read the first pictures (``begins``).
        """
        clock = np.mean(self.observed.strike_time)
        if self.intended is not None:
            own = self.intended
            near = np.minimum(own.sigma, NEAR) * random.standard_normal((count, len(NEAR)))
            near[0] = 0.0
            near += own.vector
            near[:, 1] = np.maximum(near[:, 1], 0.1 * own.vector[1])
            offset = np.hypot(near[:, 2], near[:, 3])
            near[:, 2:4] *= np.minimum(1.0, 0.95 * LARGEST_OFFSET / np.maximum(offset, 1e-9))[
                :, None
            ]
            return np.column_stack((near, np.full(count, clock)))
        begins = self.begins()
        chosen = np.arange(count * len(begins)) % len(begins)
        azimuth, speed = np.array(begins)[chosen].T
        # The mean motion of a ball that meets nothing is known well, the others roughly.
        rough = chosen > 0
        count = chosen.size
        azimuth = azimuth + rough * AZIMUTH_ERROR * random.standard_normal(count)
        speed = speed * np.exp(rough * SPEED_ERROR * random.standard_normal(count))
        radius = 0.5 * np.sqrt(random.random(count))
        angle = 2.0 * np.pi * random.random(count)
        return np.column_stack(
            (
                azimuth,
                speed,
                radius * np.cos(angle),
                radius * np.sin(angle),
                0.02 + 0.12 * random.random(count),
                np.full(count, clock),
            )
        )

    def begins(self) -> list[tuple[float, float]]:
        """Azimuths, rad, and speeds of the cue, m/s, that the first pictures show.

        The first are those of the mean motion. They are wrong where the struck ball meets a ball or
        a rail at once. Then there are those of the momentum of both balls after their contact, and
        those of the first step.
        """
        samples = self.observed.samples[self.observed.struck]
        rest = samples.position[0]
        start = samples.time[0] + self.observed.first_move
        moved = int(np.searchsorted(samples.time, start - 1e-9))
        end = np.searchsorted(samples.time, samples.time[moved] + 0.09)
        last = int(np.clip(end, moved + 1, len(samples) - 1))
        begins: list[tuple[float, float]] = []

        def add(way: Floats, speed: float) -> None:
            azimuth = math.atan2(way[1], way[0]) + self.frame.rotation
            # A cue gives a ball about 1.3 times its own speed.
            speed = max(speed, 0.1) / 1.3
            if all(
                abs(math.remainder(azimuth - other, 2.0 * math.pi)) > AZIMUTH_ERROR
                or abs(speed / known - 1.0) > 2.0 * SPEED_ERROR
                for other, known in begins
            ):
                begins.append((azimuth, speed))

        step = samples.position[last] - samples.position[moved]
        speed = math.hypot(*step) / (samples.time[last] - samples.time[moved])
        add(samples.position[last] - rest, speed)
        for name, ball in self.observed.samples.items():
            when = None if name == self.observed.struck else first_move(ball)
            if when is not None and when < start + AT_ONCE:
                both = _velocity(samples, when) + _velocity(ball, when)
                if np.isfinite(both).all():
                    speed = math.hypot(*both)
                    add(both, speed)
        add(samples.position[moved] - rest, speed)
        return begins


def _velocity(ball: TrackedBall, start: float) -> Floats:
    """Mean velocity in the first pictures from a time on, m/s, shape (2,); NaN if there is one."""
    chosen = (ball.time >= start - 1e-9) & (ball.time < start + FIRST_PICTURES)
    if chosen.sum() < 2:
        return np.full(2, np.nan)
    velocity: Floats = np.polyfit(ball.time[chosen] - start, ball.position[chosen], 1)[0]
    return velocity


def residuals(
    shots: Shot | list[Shot],
    vectors: Floats,
    tracks: BallTracks,
    frame: Frame | list[Frame],
    places: Floats | None = None,
) -> Floats:
    """Model minus track, m, for strikes of one shot or of one shot each.

    Args:
        shots: The balls as they lay; a list has one for each vector.
        vectors: Shape (n, 6): ``NAMES``.
        tracks: What was seen.
        frame: Where the tracks lie on the table; a list has one for each vector.
        places: Where the balls lay, m, shape (n, balls, 2); None is where the shots have them.

    Returns:
        Shape (n, m); NaN for a strike that cannot be.
    """
    azimuth, speed, side, height, elevation, clock = vectors.T
    tilt = np.abs(elevation)
    possible = (
        (side * side + height * height < LARGEST_OFFSET**2)
        & (speed > 0.02)
        & (speed < LARGEST_SPEED)
        & (tilt < LARGEST_ELEVATION)
    )
    strike = {
        "azimuth": azimuth,
        "speed": np.where(possible, speed, np.nan),
        "side": side,
        "height": height,
        "elevation": tilt,
    }
    frames = frame if isinstance(frame, list) else [frame]
    found = track_residuals(
        Candidates(shots, strike=strike, position=places),
        tracks,
        clock=clock,
        offset=np.array([one.offset for one in frames]),
        rotation=np.array([one.rotation for one in frames]),
        threads=1,  # the shots are what is shared among threads
    )
    assert found.residual is not None  # they were asked for
    return found.residual.reshape(len(vectors), -1)


def search(problem: StrikeProblem, starts: int, seed: int, keep: int = 4) -> tuple[Floats, Floats]:
    """The best strikes of a shot from many starts: vectors, (n, p), and sums of squares, m².

    The horizon grows: after a contact the sum of squares has many narrow minima, which only a start
    that is already near can find.
    """
    end = problem.observed.end
    random = np.random.default_rng((seed, 0x5712))
    vectors = problem.starts(starts, random)
    steps = np.array(STEPS)
    begin = problem.observed.first_move
    horizon = min(begin + FIRST_HORIZON, end)
    vectors, cost = levenberg.refine(
        problem.residuals(horizon), vectors, steps, iterations=6, scale=0.02
    )
    # The first pictures do not tell where the balls lay.
    steps = problem.steps
    vectors = np.pad(vectors, ((0, 0), (0, steps.size - len(STEPS))))
    while horizon < end:
        share = FIRST_HORIZON / (horizon - begin)
        vectors = _distinct(vectors, cost, steps, max(FEWEST, int(starts * share)))
        horizon = min(begin + (horizon - begin) * GROWTH, end)
        vectors, cost = levenberg.refine(
            problem.residuals(horizon), vectors, steps, iterations=8, scale=SCALE
        )
    return settle(problem, _distinct(vectors, cost, steps, keep))


def settle(problem: StrikeProblem, strikes: Floats) -> tuple[Floats, Floats]:
    """Strikes at their nearest minima over the whole time, the best first, as ``search``.

    Args:
        problem: The shot.
        strikes: Where they begin, shape (n, p) or (p,); places of rest that are missing are those
            that were seen.
    """
    steps, vectors = problem.steps, np.atleast_2d(strikes)
    vectors = np.pad(vectors, ((0, 0), (0, steps.size - vectors.shape[1])))
    end = problem.observed.end
    vectors, cost = levenberg.refine(problem.residuals(end), vectors, steps, iterations=15)
    order = np.argsort(cost, kind="stable")
    order = order[np.isfinite(cost[order])]
    return vectors[order], cost[order]


def _distinct(vectors: Floats, cost: Floats, steps: Floats, count: int) -> Floats:
    """The best vectors that are not the same minimum as a better one."""
    chosen: list[Floats] = []
    for index in np.argsort(cost, kind="stable"):
        if not np.isfinite(cost[index]) or len(chosen) == count:
            break
        scaled = vectors[index] / steps
        if all(((scaled - other) ** 2).sum() > 0.05 for other in chosen):
            chosen.append(scaled)
    kept: Floats = np.array(chosen).reshape(-1, steps.size) * steps
    return kept


def leaves(errors: Floats, time: Floats) -> float:
    """The first time at which the model has left the track, s; infinite if it never has.

    Args:
        errors: Model minus track, m, shape (n, 2).
        time: Of each, s, shape (n,).
    """
    return float(time[np.hypot(*errors.T) > APART].min(initial=np.inf))


def root_mean_square(found: Floats) -> float:
    """Root mean square distance, m, of residuals in x and y, shape (n, 2)."""
    return float(np.sqrt(np.mean((found * found).sum(axis=1))))

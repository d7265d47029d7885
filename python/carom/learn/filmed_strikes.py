"""The strikes of filmed shots on a learned table, as shots that replay what was filmed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from carom._core import MOST_SAMPLES
from carom.arguments import cores, flat, number, whole
from carom.errors import InputError
from carom.lazy import np
from carom.learn.fit_table import fit_error
from carom.learn.intended_strikes import IntendedStrike, intended_strikes
from carom.learn.observation import Observation, observe
from carom.learn.posterior import LearnedNumbers
from carom.learn.strike_posterior import strike_samples
from carom.learn.strike_search import STEPS, StrikeProblem, search, settle
from carom.learn.table_model import POLICIES, Frame, TableModel
from carom.learn.tracks import TrackedShot, Tracks
from carom.noise import Noise
from carom.progress import progress_bar
from carom.shot import Shot
from carom.threads import in_order

if TYPE_CHECKING:
    from numpy.typing import NDArray

#: Largest standard deviation of a place of rest, m: half a ball.
LARGEST_REST = 0.03
#: A root mean square distance from the track, m, that the strike does not explain, and how many
#: times as many starts the second search has.
UNEXPLAINED = 0.05
LONGER = 5


@dataclass(frozen=True, slots=True, eq=False)
class FilmedStrike:
    """The strike that explains a filmed shot best.

    Attributes:
        name: The shot's name in the tracks.
        shot: The shot with this strike; ``shot.simulate()`` replays what was filmed, and
            ``shot.track`` has what the camera saw.
        clock: Time of the strike after the first picture, s.
        rmse: Root mean square distance of model and track over all balls and the whole time, m.
        rmse_3s: The same for the first three seconds after the ball moves.
        samples: Draws from the posterior of the strike, shape (200, 6), with the columns of
            ``others``; see ``carom.learn.strike_posterior``.
        others: Further strikes that explain it, from the second best on: shape (n, 6), the columns
            azimuth (rad), speed (m/s), side, height (ball radii), elevation (rad) and clock (s).
    """

    name: str
    shot: Shot
    clock: float
    rmse: float
    rmse_3s: float
    samples: NDArray[np.float64] = field(repr=False)
    others: NDArray[np.float64] = field(repr=False)

    def to_dict(self) -> dict[str, Any]:
        """Plain values; the shot is that of a shot file."""
        return {
            "name": self.name,
            "clock": self.clock,
            "rmse": self.rmse,
            "rmse_3s": self.rmse_3s,
            "shot": self.shot.to_dict(),
        }


def strikes(
    tracks: Tracks,
    learned: LearnedNumbers | None = None,
    *,
    table: str | Mapping[str, Any] | None = None,
    physics: str | Mapping[str, Any] | None = None,
    rest: float | None = None,
    intended: Shot | Mapping[str, Shot] | None = None,
    noise: Noise | None = None,
    begin: Mapping[str, NDArray[np.float64]] | None = None,
    starts: int = 40,
    seed: int = 0,
    threads: int | None = None,
    progress: bool = False,
) -> list[FilmedStrike]:
    """Find the strike of every filmed shot.

    Args:
        tracks: The filmed shots.
        learned: The table, as ``carom.learn.table`` found it.
        table: Without ``learned``: the table as a shot file has it; None is that of the tracks.
        physics: Without ``learned``: its physics; None is the one that belongs to the table.
        rest: Standard deviation of the places where the balls lay, m, such as 0.0015: they are then
            found with the strike, and the shot has the balls there. None takes the places that were
            seen.
        intended: The intended shot, if all are repetitions of it, or one by the name of each shot
            that has one: the search begins near it.
        noise: Errors of the played strikes about the intended ones; None if they are unknown.
        begin: Strikes that are known already, by the name of the shot, such as
            ``learned.strikes``, shape (6,): each moves to its nearest minimum, which takes a
            fraction of a search. Shots without one are searched.
        starts: Starts of the search for each strike. A shot that stays 5 cm from its track is
            searched again, with five times as many.
        seed: Seed of the starts, and of the samples.
        threads: Number of threads; None for all cores. The result does not depend on it.
        progress: Whether to show the progress on stderr.

    Returns:
        The strikes in the order of the shots. A shot for which none was found is missing.

    Raises:
        InputError: There is no table, a shot has no motion, ``rest`` is out of range, an intended
            shot has no strike or no film, there is a noise without an intention, or a strike of
            ``begin`` is not six finite numbers.
    """
    whole("starts", starts, low=4)
    if rest is not None:
        rest = number("rest", rest)
        if not 0.0 < rest <= LARGEST_REST:
            raise InputError(
                "out-of-range",
                "rest",
                f"{rest:g} m is not the error of a place where a ball lay",
                f"give metres above 0, up to {LARGEST_REST:g}, such as 0.0015",
            )
    if learned is None:
        model = TableModel.of(tracks.header, table, physics, ())
        vector = model.start
    else:
        model, vector = learned.model, learned.mean

    meant = intended_strikes(tracks, intended, noise)
    starting = {name: _strike(name, strike) for name, strike in (begin or {}).items()}

    def find(known: tuple[TrackedShot, IntendedStrike | None]) -> FilmedStrike | None:
        tracked, own = known
        observed = observe(tracked)
        shot, frame = model.shot(observed, vector)
        problem = StrikeProblem(observed, shot, frame, rest, own)
        if tracked.name in starting:
            vectors, _ = settle(problem, starting[tracked.name])
        else:
            vectors = _searched(problem, starts, seed)
        if not len(vectors):
            return None
        track = _track(tracked, frame, model.size(vector), clock=vectors[0, len(STEPS) - 1])
        return _filmed(observed, problem, vectors, seed, track)

    found = []
    with progress_bar(len(tracks), show=progress, what="strikes") as done:
        for one in in_order(find, list(zip(tracks, meant, strict=True)), cores(threads)):
            if one is not None:
                found.append(one)
            done(1)
    return found


def _searched(problem: StrikeProblem, starts: int, seed: int) -> NDArray[np.float64]:
    """The best strikes of a shot; one that they do not explain gets a second, longer search."""
    first, cost = search(problem, starts, seed)
    if len(first) and fit_error(problem, first[0])[0] < UNEXPLAINED:
        return first
    second, cost_of_second = search(problem, LONGER * starts, seed + 1)
    if len(second) and (not len(first) or cost_of_second[0] < cost[0]):
        return second
    return first


def _strike(name: str, strike: NDArray[np.float64]) -> NDArray[np.float64]:
    """The numbers of a strike, shape (6,)."""
    place = f"begin[{name!r}]"
    found = flat(place, strike)
    if found.size != len(STEPS):
        fault = f"found {found.size} numbers"
        remedy = "give azimuth, speed, side, height, elevation and clock, as learned.strikes"
        raise InputError("wrong-count", place, fault, remedy)
    return found


def _track(
    tracked: TrackedShot, frame: Frame, size: tuple[float, float], clock: float
) -> list[dict[str, Any]]:
    """What the camera saw, as the ``track`` of a shot file.

    Args:
        tracked: The filmed shot.
        frame: Where its places lie on the table.
        size: Width and length of the table, m.
        clock: Time of the strike after the first picture, s.
    """
    entries = []
    for name, ball in tracked.balls.items():
        seen = ball.seen
        if not len(seen):
            continue
        # Two samples of one microsecond would not be in the order of time.
        times, chosen = np.unique(np.round(seen.time - tracked.start - clock, 6), return_index=True)
        places = np.round(frame.to_table(seen.position[chosen], size), 5)
        samples = np.column_stack((times, places))
        # Of a film with more pictures every second, third or further one.
        entries.append({"ball": name, "samples": samples[:: -(-len(samples) // MOST_SAMPLES)]})
    return entries


def _filmed(
    observed: Observation,
    problem: StrikeProblem,
    vectors: NDArray[np.float64],
    seed: int,
    track: list[dict[str, Any]],
) -> FilmedStrike:
    azimuth, speed, side, height, elevation, clock = vectors[0, : len(STEPS)].tolist()
    file = problem.shot.to_dict()
    for ball, moved in zip(file["balls"], vectors[0, len(STEPS) :].reshape(-1, 2), strict=False):
        ball["position"] = [*(np.array(ball["position"][:2]) + moved), *ball["position"][2:]]
    file["strike"] = {
        **POLICIES,
        "ball": observed.struck,
        "speed": speed,
        "azimuth": azimuth,
        "elevation": abs(elevation),
        "side": side,
        "height": height,
    }
    file["track"] = track
    rmse, early = fit_error(problem, vectors[0])
    samples = strike_samples(problem, vectors[0], seed)
    others = vectors[1:, : len(STEPS)]
    return FilmedStrike(observed.name, Shot.from_dict(file), clock, rmse, early, samples, others)

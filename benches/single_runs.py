"""How near a learned table comes to the motion of single balls.

    python benches/single_runs.py TRACKS --table NAME --radius M

The table is learned from every second shot of a film, then from the others. Each time the runs of
single balls are taken from the shots that it was learned from (train) and from the others
(validation), and only their start states are fitted: place, velocity and spin. There are two kinds
of runs. One kind, ``free``, is the free motion between two contacts, with rails or balls, or to
rest. The other, ``over_rails``, goes on over rails, to the next contact with another ball; it is
listed by the number of rails too. A run has at least ten samples, and none of a ball at rest: they
would lower the error.

The error of a run is the root mean square distance of model and samples. Quantiles are 5, 25, 50,
75, 90 and 95 %, in mm. The result is stored in ``benches/results/single_runs.json``; of the film it
has nothing else.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise
from pathlib import Path
from typing import Any

import carom
import numpy as np
from carom import learn
from carom.bench import report
from carom.files import write_whole
from carom.learn import levenberg
from carom.progress import progress_bar
from carom.threads import in_order
from numpy.typing import NDArray

STORED = Path(__file__).parent / "results" / "single_runs.json"
KINDS = ("over_rails", "free")
QUANTILES = (5, 25, 50, 75, 90, 95)
#: Runs over this number of rails and more are listed together.
MOST = 4
#: Fewest samples of a run.
FEWEST = 10
#: A useful step of each number of a start state: x, y (m), velocity (m/s), velocity of the contact
#: point against the cloth (m/s), spin about the vertical times the radius (m/s).
STEPS = np.array((0.001, 0.001, 0.02, 0.02, 0.1, 0.1, 0.1))
#: Starts of a search, how many states are kept while the horizon grows, the first horizon (s), its
#: growth, and the scale of the robust loss (m).
STARTS, KEPT, FIRST_HORIZON, GROWTH, SCALE = 32, 12, 0.3, 1.4, 0.03
#: The velocity at the start is first taken from so much of the run, s, at least from four samples.
NEAR = 0.1

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class SingleRun:
    """The motion of one ball on its own.

    Attributes:
        time: Of its samples, s since the first, shape (n,).
        place: Their places, m, in the frame of the tracks, shape (n, 2).
        rails: Number of rails that it meets.
    """

    time: Floats
    place: Floats
    rails: int


def main() -> int:
    """Measures, prints and stores."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tracks", type=Path)
    parser.add_argument("--table", required=True)
    parser.add_argument("--radius", type=float, required=True)
    options = parser.parse_args()
    tracks = learn.read_tracks(options.tracks, table=options.table, radius=options.radius)
    errors: dict[str, dict[str, list[tuple[int, float]]]] = {
        part: {kind: [] for kind in KINDS} for part in ("train", "validation")
    }
    for fold in range(2):
        fitted, held = tracks[1 - fold :: 2], tracks[fold::2]
        table = learn.table(fitted, progress=sys.stderr.isatty())
        for part, shots in (("train", fitted), ("validation", held)):
            for kind in KINDS:
                errors[part][kind] += errors_of(shots, table, kind)
    result = report.where() | {
        "shots": len(tracks),
        "quantiles": QUANTILES,
        **{part: {k: summary(v) for k, v in kinds.items()} for part, kinds in errors.items()},
    }
    text = json.dumps(result, indent=1)
    print(text)
    write_whole(STORED, text + "\n")
    return 0


def errors_of(
    tracks: learn.Tracks, table: learn.LearnedNumbers, kind: str
) -> list[tuple[int, float]]:
    """The rails and the error of every run, m; infinite where no start state gives the run."""
    runs = [run for shot in tracks for run in runs_of(shot, tracks.header, kind)]
    found = []
    with progress_bar(len(runs), show=sys.stderr.isatty(), what=f"runs {kind}") as done:
        for error in in_order(lambda run: fit_error(run, table), runs, 2):
            found.append((runs[len(found)].rails, error))
            done(1)
    return found


def runs_of(shot: learn.TrackedShot, header: learn.TracksHeader, kind: str) -> Iterator[SingleRun]:
    """The runs of the balls of a shot that have enough samples."""
    shown = learn.segment(shot, header)
    by_ball = sorted(shown.runs, key=lambda run: (run.ball, run.start))
    for ball, runs in groupby(by_ball, key=lambda run: run.ball):
        seen = shot.balls[ball].seen
        over_rails = kind == "over_rails"
        touched = [one.time for one in shown.contacts if len(one.balls) > 1 and ball in one.balls]
        for first, last, rails in spans(list(runs), shown.contacts, over_rails=over_rails):
            for one in parts(seen.time, first, last, touched):
                if one.stop - one.start >= FEWEST:
                    time = seen.time[one] - seen.time[one.start]
                    met = sum(seen.time[one.start] < at < seen.time[one.stop - 1] for at in rails)
                    yield SingleRun(time, seen.position[one], met)


def spans(
    runs: Sequence[learn.Run], contacts: Sequence[learn.Contact], *, over_rails: bool
) -> Iterator[tuple[int, int, list[float]]]:
    """The first and the last sample of each run of one ball, and when it meets rails, s."""
    first: int | None = None
    rails: list[float] = []
    for run, following in zip(runs, [*runs[1:], None], strict=True):
        first = run.first if first is None else first
        if (
            over_rails
            and following is not None
            and run.after is not None
            and run.after == following.before
            and contacts[run.after].rail is not None
        ):
            rails = [*rails, contacts[run.after].time]
            continue
        yield first, run.last, rails
        first, rails = None, []


def parts(time: Floats, first: int, last: int, touched: Sequence[float]) -> Iterator[slice]:
    """A run cut at contacts with other balls that were too light to cut the ball's own track."""
    cuts = [int(np.searchsorted(time, at)) for at in touched]
    ends = [first, *(cut for cut in cuts if first < cut <= last), last + 1]
    yield from (slice(start, stop) for start, stop in pairwise(ends))


def fit_error(run: SingleRun, table: learn.LearnedNumbers) -> float:
    """Root mean square distance of a run and the best motion from any start state, m.

    The horizon grows: behind a rail the sum of squares has many minima, which only a start that is
    already near can find. Before it the spin about the vertical is unknown, so starts that differ
    in it are kept.
    """
    problem = RunProblem(run, table)
    states, end = problem.starts(), float(run.time[-1])
    horizon = min(FIRST_HORIZON, end)
    while True:
        at = problem.residuals(horizon)
        states, cost = levenberg.refine(at, states, STEPS, iterations=8, scale=SCALE)
        if horizon >= end:
            break
        states = distinct(states, cost)
        horizon = min(GROWTH * horizon, end)
    _, cost = levenberg.refine(at, distinct(states, cost), STEPS, iterations=30)
    return float(np.sqrt(cost.min() / run.time.size))


def distinct(states: Floats, cost: Floats) -> Floats:
    """The best states, at most KEPT, that are not the same minimum as a better one."""
    chosen: list[Floats] = []
    for index in np.argsort(cost, kind="stable")[: len(states)]:
        scaled = states[index] / STEPS
        if all(((scaled - other) ** 2).sum() > 0.1 for other in chosen):
            chosen.append(scaled)
        if len(chosen) == KEPT:
            break
    found: Floats = np.array(chosen) * STEPS
    return found


class RunProblem:
    """Residuals of start states of one ball on a table."""

    def __init__(self, run: SingleRun, table: learn.LearnedNumbers) -> None:
        self.run = run
        self.table = table
        self.frame = table.frame
        size = table.model.size(table.mean)
        self.place = self.frame.to_table(run.place, size)
        ball: dict[str, Any] = {"id": "1", "position": [size[0] / 2.0, size[1] / 2.0]}
        if table.model.radius is not None:
            ball["radius"] = table.model.radius
        self.shot = carom.Shot(table.table, [ball], physics=table.physics)
        self.radius = float(self.shot.radius[0])

    def starts(self) -> Floats:
        """States at which a search begins, shape (STARTS, 7): the first one rolls."""
        random = np.random.default_rng(0)
        count = max(4, int(np.searchsorted(self.run.time, NEAR)))
        time, place = self.run.time[:count], self.place[:count]
        velocity = np.polyfit(time, place, 1)[0]
        speed = float(np.hypot(*velocity))
        states = np.zeros((STARTS, STEPS.size))
        states[:, :2] = self.place[0]
        states[:, 2:4] = velocity
        states[1:, 4:] = speed * random.uniform(-1.0, 1.0, (STARTS - 1, 3))
        return states

    def residuals(self, horizon: float) -> Callable[[Floats], Floats]:
        """The function from states, (n, 7), to model minus track, m, (n, m), up to a time."""
        count = int(np.searchsorted(self.run.time, horizon, side="right"))
        tracks = carom.BallTracks({"1": (self.run.time[:count], self.run.place[:count])})

        def at(states: Floats) -> Floats:
            x, y, vx, vy, slip_x, slip_y, spin = states.T
            # The contact point moves with v + ω × (−R ẑ).
            spins = np.column_stack((slip_y - vy, vx - slip_x, spin)) / self.radius
            # A ball that leaves a rail may be seen in its nose.
            places = np.column_stack((x, y))
            found = carom.track_residuals(
                carom.Candidates(
                    self.shot,
                    position=self.table.model.inside(places, self.table.mean)[:, None],
                    velocity=np.column_stack((vx, vy))[:, None],
                    angular_velocity=spins[:, None],
                ),
                tracks,
                offset=np.array(self.frame.offset),
                rotation=self.frame.rotation,
                threads=1,
            )
            assert found.residual is not None  # they were asked for
            return found.residual.reshape(len(states), -1)

        return at


def summary(rows: Sequence[tuple[int, float]]) -> dict[str, Any]:
    """The number of runs, and quantiles of their errors, mm; also by rails, if some meet one."""
    found = 1000.0 * np.percentile([error for _, error in rows], QUANTILES)
    own = {"runs": len(rows), "mm": [float(f"{value:.3g}") for value in found]}
    if not any(rails for rails, _ in rows):
        return own
    parts = [[(0, e) for rails, e in rows if min(rails, MOST) == k] for k in range(MOST + 1)]
    return own | {"by_rails": [summary(part) for part in parts if part]}


if __name__ == "__main__":
    sys.exit(main())

"""Learning a table: physics, table and frame from filmed shots."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from carom.errors import InputError
from carom.lazy import np
from carom.learn import levenberg
from carom.learn.intended_strikes import IntendedStrike
from carom.learn.kept_work import KeptWork
from carom.learn.observation import Observation
from carom.learn.strike_search import (
    STEPS,
    StrikeProblem,
    leaves,
    residuals,
    root_mean_square,
    search,
)
from carom.learn.table_model import TableModel
from carom.threads import in_order

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

#: A shot that is on the track for less, s, does not count.
LEAST_HORIZON = 0.8
#: The same if its strike is known apart from the film: then it tells of the table from the start.
LEAST_KNOWN = 0.1
#: The strike that fits a whole shot best may leave the track in its first pictures. Then those that
#: fit this much of its beginning, s, are tried.
BEGINNINGS = (0.8, 1.6, 3.2)
#: Standard deviation of model minus track, m: at the strike, and its growth a second. The error of
#: a model grows with every contact, and contacts come at a steady pace.
SIGMA = (0.004, 0.004)
#: A residual that is larger, in standard deviations, counts less.
ROBUST = 2.0
#: The steps of an iteration, in units of a parameter's step, at most.
REACH = 2.0
#: Below this largest step, in the same unit, the numbers have settled.
SETTLED = 0.02
#: Most steps of a round.
ITERATIONS = 8
#: Rounds in which every strike is searched. In the others one that stays on its track to the end is
#: kept: the numbers move little then.
SEARCHED = 2
#: Share of the curvature that damps a step.
DAMPING = 0.002
#: Curvature of the weak prior about the start, in units of a parameter's step. It moves only
#: numbers that the shots do not tell.
PRIOR = 0.1


class UnexplainedError(InputError):
    """No shot stays on its track for long enough to count."""


@dataclass(frozen=True, slots=True, eq=False)
class FittedTable:
    """Where a fit ended.

    Attributes:
        vector: The numbers, shape (p,).
        curvatures: The curvature that each used shot adds, in steps, shape (n, p, p).
        gradients: The same of the gradient, shape (n, p).
        strikes: The strike of every shot, shape (6,), as ``strike_search.NAMES``; None where none
            was found.
    """

    vector: Floats
    curvatures: Floats
    gradients: Floats
    strikes: tuple[Floats | None, ...]


@dataclass(frozen=True, slots=True)
class _Part:
    """What one shot says about the free numbers, its strike eliminated.

    Attributes:
        curvature: Shape (p, p), in units of the parameters' steps.
        gradient: Shape (p,).
        vector: The strike.
    """

    curvature: Floats
    gradient: Floats
    vector: Floats


def fit(
    observed: Sequence[Observation],
    model: TableModel,
    *,
    rounds: int,
    starts: int,
    seed: int,
    threads: int,
    done: Callable[[int], object],
    kept: KeptWork | None = None,
    intended: Sequence[IntendedStrike | None] | None = None,
) -> FittedTable:
    """Fit the free numbers of a table, as ``carom.learn.table`` describes.

    Args:
        observed: What was seen of each shot.
        model: The table.
        rounds: How often strikes and numbers alternate.
        starts: Starts of each search for a strike.
        seed: Seed of the starts.
        threads: Number of threads.
        done: Called with the number of strikes that were found.
        kept: Has the rounds of a fit that was stopped, and gets each that ends.
        intended: The intended strike of each shot, where it is known.
    """
    meant = [None] * len(observed) if intended is None else intended
    joint = _Joint(observed, model, meant, starts, seed, threads)
    for index in range(rounds):
        name = f"round {index + 1}"
        if kept is not None and (state := kept.get(name)) is not None:
            joint.restore(state)
            done(len(observed))
            continue
        joint.search_strikes(index, done)
        joint.settle()
        if kept is not None:
            kept.put(name, joint.state())
    return joint.result()


class _Joint:
    """Strikes and free numbers on the way to their best values."""

    def __init__(
        self,
        observed: Sequence[Observation],
        model: TableModel,
        intended: Sequence[IntendedStrike | None],
        starts: int,
        seed: int,
        threads: int,
    ) -> None:
        self.observed = observed
        self.model = model
        self.intended = intended
        self.starts = starts
        self.seed = seed
        self.threads = threads
        self.vector = model.start
        self.strikes: list[Floats | None] = [None] * len(observed)

    def state(self) -> dict[str, Any]:
        """Numbers and strikes as values of JSON."""
        strikes = [None if strike is None else strike.tolist() for strike in self.strikes]
        return {"vector": self.vector.tolist(), "strikes": strikes}

    def restore(self, state: dict[str, Any]) -> None:
        """Goes on from a state."""
        self.vector = np.array(state["vector"])
        self.strikes = [None if strike is None else np.array(strike) for strike in state["strikes"]]

    def problem(self, index: int) -> StrikeProblem:
        shot, frame = self.model.shot(self.observed[index], self.vector)
        return StrikeProblem(self.observed[index], shot, frame, intended=self.intended[index])

    def search_strikes(self, turn: int, done: Callable[[int], object]) -> None:
        """Looks for a better strike of every shot."""

        def better(index: int) -> Floats | None:
            problem, old = self.problem(index), self.strikes[index]
            end = self.observed[index].end
            if old is not None:
                at = problem.residuals(end)
                again, cost_again = levenberg.refine(at, old[None], problem.steps, iterations=12)
                kept: Floats = again[0]
                if turn >= SEARCHED and self.horizon(index, kept) >= end:
                    return kept
            found, cost = search(problem, self.starts, self.seed + 1000 * turn + index)
            if old is not None:
                found, cost = np.concatenate((again, found)), np.append(cost_again, cost)
            return found[cost.argmin()] if np.isfinite(cost).any() else old

        strikes = []
        for strike in in_order(better, range(len(self.observed)), self.threads):
            strikes.append(strike)
            done(1)
        self.strikes = strikes

    def settle(self) -> None:
        """Takes steps of the free numbers until they change little."""
        for _ in range(ITERATIONS):
            parts = self.parts()
            used = [part for part in parts if part is not None]
            if not used:
                raise UnexplainedError(
                    "wrong-count",
                    "tracks",
                    "no shot could be explained for as long as 0.8 s",
                    "check the table, the radius, the unit and the axes (carom learn check)",
                )
            away = (self.vector - self.model.start) / self.model.steps
            curvature = sum(part.curvature for part in used) + PRIOR * np.eye(away.size)
            gradient = sum(part.gradient for part in used) + PRIOR * away
            damping = np.diag(np.diag(curvature) * DAMPING)
            step = np.linalg.solve(curvature + damping, gradient)
            self.strikes = [
                strike if part is None else part.vector
                for strike, part in zip(self.strikes, parts, strict=True)
            ]
            move = np.clip(step, -REACH, REACH) * self.model.steps
            self.vector = self.model.clip(self.vector - move)
            self.strikes = [*in_order(self.followed, range(len(parts)), self.threads)]
            if np.abs(step).max() < SETTLED:
                break

    def followed(self, index: int) -> Floats | None:
        """A strike at its minimum under the new numbers."""
        start = self.strikes[index]
        if start is None:
            return None
        problem = self.problem(index)
        at = problem.residuals(self.observed[index].end)
        found, cost = levenberg.refine(at, start[None], problem.steps, iterations=6, scale=0.05)
        return found[0] if np.isfinite(cost[0]) else start

    def parts(self) -> list[_Part | None]:
        """What every shot says about the free numbers."""
        return [*in_order(self.part, range(len(self.observed)), self.threads)]

    def horizon(self, index: int, vector: Floats) -> float:
        """The time up to which a shot counts, s: until the model leaves the track.

        Beyond it they are on different ways, and derivatives there say nothing about the numbers.
        """
        observed = self.observed[index]
        found = self.problem(index).residuals(observed.end)(vector[None])[0]
        if not np.isfinite(found).all():
            return 0.0
        time = observed.until(observed.end).time
        return min(leaves(found[: 2 * time.size].reshape(-1, 2), time), observed.end)

    def on_track(self, index: int, vector: Floats) -> tuple[float, Floats]:
        """The strike near another one that stays on the track longest, with how long it does, s."""
        problem, first = self.problem(index), self.observed[index].first_move
        steps, found = np.array(STEPS), []
        for seconds in BEGINNINGS:
            at = problem.residuals(first + seconds)
            refined, _ = levenberg.refine(at, vector[None], steps, iterations=8, scale=0.03)
            found.append((self.horizon(index, refined[0]), refined[0]))
        return max(found, key=lambda one: one[0])

    def part(self, index: int) -> _Part | None:
        """What a shot says about the free numbers; None if it leaves the track too early."""
        vector = self.strikes[index]
        if vector is None:
            return None
        observed, model = self.observed[index], self.model
        meant = self.intended[index]
        is_known = meant is not None and np.isfinite(meant.sigma).all()
        least = observed.first_move + (LEAST_KNOWN if is_known else LEAST_HORIZON)
        horizon = self.horizon(index, vector)
        if horizon < least:
            horizon, vector = self.on_track(index, vector)
        if horizon < least:
            return None
        problem = self.problem(index)
        at = problem.residuals(horizon)
        refined, _ = levenberg.refine(at, vector[None], np.array(STEPS), iterations=8, scale=0.03)
        vector = refined[0]
        here, by_strike = levenberg.derivatives(at, vector[None], np.array(STEPS))
        tracks = observed.until(horizon)
        length = levenberg.STEP * 20.0
        ahead = self.vector + length * model.steps
        # A number at its upper bound takes the step down: no shot has a restitution above 1.
        step = np.where(model.clip(ahead) < ahead, -length, length)
        changed = self.vector + np.diag(step * model.steps)
        shots, frames = zip(*(model.shot(observed, row) for row in changed), strict=True)
        repeated = np.repeat(vector[None], len(shots), axis=0)
        found = residuals([*shots], repeated, tracks, [*frames])
        size = found.shape[1]
        here, by_strike = here[0, :size], by_strike[0, :, :size]
        slopes = np.concatenate((by_strike, (found - here) / step[:, None]))
        if not np.isfinite(slopes).all():
            return None
        sigma = np.repeat(SIGMA[0] + SIGMA[1] * tracks.time, 2)
        weight = levenberg.weights(here / sigma, ROBUST) / sigma**2
        normal = (slopes * weight) @ slopes.T
        gradient = (slopes * weight) @ here
        count = len(STEPS)
        if meant is not None:
            # What is known of the strike apart from the film, in steps.
            known = (np.array(STEPS[:5]) / meant.sigma) ** 2
            normal[range(5), range(5)] += known
            gradient[:5] += known * (vector[:5] - meant.vector) / STEPS[:5]
        strike = normal[:count, :count]
        strike = strike + np.diag(1e-3 * np.diag(strike) + 1e-3)
        eliminate = np.linalg.solve(strike, normal[:count, count:]).T
        curvature = normal[count:, count:] - eliminate @ normal[:count, count:]
        return _Part(curvature, gradient[count:] - eliminate @ gradient[:count], vector)

    def result(self) -> FittedTable:
        """Numbers and strikes as they are now."""
        used = [part for part in self.parts() if part is not None]
        return FittedTable(
            self.vector,
            np.array([part.curvature for part in used]),
            np.array([part.gradient for part in used]),
            tuple(self.strikes),
        )


def fit_error(problem: StrikeProblem, vector: Floats) -> tuple[float, float]:
    """Root mean square distance of model and track, m: over the whole time, and the first 3 s."""
    end = problem.observed.end
    time = problem.observed.until(end).time
    found = problem.residuals(end)(vector[None])[0, : 2 * time.size].reshape(-1, 2)
    early = found[time <= problem.observed.first_move + 3.0]
    return root_mean_square(found), root_mean_square(early)

"""Models of rails and of two balls, compared by shots that they were not fitted to."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Callable, Iterable, Mapping
from copy import deepcopy
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from carom import _core
from carom.arguments import cores, whole
from carom.errors import InputError
from carom.lazy import np
from carom.learn.fit_table import ROBUST, SIGMA, UnexplainedError, fit
from carom.learn.intended_strikes import IntendedStrike, intended_strikes
from carom.learn.kept_work import KeptWork
from carom.learn.observation import Observation, observe
from carom.learn.strike_search import StrikeProblem, search
from carom.learn.table_model import TableModel
from carom.learn.tracks import Tracks
from carom.noise import Noise
from carom.progress import progress_bar
from carom.shot import Shot
from carom.threads import in_order

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

#: Parts of the shots; each is held out once.
FOLDS = 2
#: Error of a shot that a model does not explain, m, and its time, s.
_WORST = 1.0
_WORST_TIME = 5.0


@dataclass(frozen=True, slots=True)
class ModelScore:
    """How well a model foretells shots that it was not fitted to.

    Attributes:
        model: Its name: that of the rails and that of two balls.
        score: Mean log density of a coordinate of a ball in a picture, in nats; higher is better.
        standard_error: Standard error of its difference from the best score, from the differences
            of the shots; 0 for the best.
    """

    model: str
    score: float
    standard_error: float


def compare_models(
    tracks: Tracks,
    *,
    table: str | Mapping[str, Any] | None = None,
    physics: str | Mapping[str, Any] | None = None,
    free: Iterable[str] | None = None,
    models: Iterable[tuple[str, str]] | None = None,
    intended: Shot | Mapping[str, Shot] | None = None,
    noise: Noise | None = None,
    rounds: int = 3,
    starts: int = 40,
    seed: int = 0,
    threads: int | None = None,
    progress: bool = False,
    keep: str | os.PathLike[str] | None = None,
) -> list[ModelScore]:
    """Compare models of the rails and of two balls by the shots that are held out.

    Each model is fitted twice, each time to every second shot. The shots that it was not fitted to
    get their strikes, and the score is the log density of what was filmed. The errors have the
    density that belongs to the loss of the fit: Student's t with three degrees of freedom, wider by
    4 mm each second. A shot that a model does not explain counts as if a ball were 1 m away at 5 s.

    Args:
        tracks: The filmed shots.
        table: As for ``carom.learn.table``.
        physics: The same; its numbers are those from which each fit begins.
        free: The numbers to learn; None for all that the table and each model have.
        models: Names of the rails' and the balls' model. None for each model of the rails with the
            balls' model of ``physics``, and each model of the balls with the rails' model of it.
        intended: As for ``carom.learn.table``; the strikes of the shots that are held out are
            searched near it too.
        noise: The same. It has no part in the score, which is that of what was filmed.
        rounds: As for ``carom.learn.table``.
        starts: The same.
        seed: The same.
        threads: The same.
        progress: Whether to show the progress on stderr.
        keep: A file that keeps every finished part, so that a comparison that was stopped goes on.

    Returns:
        The scores, the best first.

    Raises:
        InputError: There is no table, a name is unknown, there are fewer than four shots, an
            intended shot has no strike or no film, or there is a noise without an intention.
    """
    whole("starts", starts, low=4)
    if len(tracks) < 2 * FOLDS:
        raise InputError(
            "wrong-count",
            "tracks",
            f"there are {len(tracks)} shots",
            f"give at least {2 * FOLDS}: each half of them is fitted and judged by the other",
        )
    free = None if free is None else [*free]
    base = TableModel.of(tracks.header, table, physics, free)
    pairs = [*(_usual(base) if models is None else models)]
    shots = [
        _Filmed(observe(shot), own)
        for shot, own in zip(tracks, intended_strikes(tracks, intended, noise), strict=True)
    ]
    observed = [shot.observed for shot in shots]
    known = [None if shot.intended is None else shot.intended.to_list() for shot in shots]
    question = ["compare", *base.identity, free, rounds, starts, seed, known]
    kept = KeptWork(keep, question, observed)
    scores = {}
    # Each shot is fitted in one half, and judged once.
    count = (rounds + 1) * len(observed) * len(pairs)
    with progress_bar(count, show=progress, what="strikes") as done:
        for rails, balls in pairs:
            name = f"{rails}, {balls}"
            found = kept.get(name)
            if found is None:
                named = _with_models(base.physics, rails, balls)
                model = TableModel.of(tracks.header, table, named, free)
                found = _held_out(shots, model, rounds, starts, seed, cores(threads), done)
                kept.put(name, found)
            else:
                done((rounds + 1) * len(observed))
            scores[name] = np.array(found)
    best = max(scores.values(), key=lambda one: float(one.mean()))
    listed = [
        ModelScore(
            name,
            float(one.mean()),
            float((one - best).std(ddof=1)) / math.sqrt(one.size),
        )
        for name, one in scores.items()
    ]
    return sorted(listed, key=lambda one: -one.score)


def _usual(base: TableModel) -> list[tuple[str, str]]:
    """Each model of the rails with the balls' own, and each of the balls with the rails' own."""
    parts = json.loads(_core.schema("shot"))["$defs"]["physics"]["oneOf"][1]["properties"]
    rails = parts["cushion"]["properties"]["model"]["enum"]
    balls = parts["ball_ball"]["properties"]["model"]["enum"]
    own = (base.cushion_model, base.ball_model)
    usual = [own, *((one, own[1]) for one in rails), *((own[0], one) for one in balls)]
    return [*dict.fromkeys(usual)]


def _with_models(physics: Mapping[str, Any], rails: str, balls: str) -> dict[str, Any]:
    """Physics with other models, and with the numbers that it gives."""
    named = deepcopy(dict(physics))
    for part, model in (("cushion", rails), ("ball_ball", balls)):
        named[part] = {**named.get(part, {}), "model": model}
    return named


@dataclass(frozen=True, slots=True, eq=False)
class _Filmed:
    """A filmed shot, and its strike as it was intended, if that is known."""

    observed: Observation
    intended: IntendedStrike | None


def _held_out(
    shots: list[_Filmed],
    model: TableModel,
    rounds: int,
    starts: int,
    seed: int,
    threads: int,
    done: Callable[[int], object],
) -> list[float]:
    """The score of each shot under the table that the shots of the other half tell."""
    scores = [0.0] * len(shots)
    for fold in range(FOLDS):
        learned_from = [one for i, one in enumerate(shots) if i % FOLDS != fold]
        try:
            found = fit(
                [one.observed for one in learned_from],
                model,
                rounds=rounds,
                starts=starts,
                seed=seed,
                threads=threads,
                done=done,
                intended=[one.intended for one in learned_from],
            )
        except UnexplainedError:
            scores[fold::FOLDS] = [_worst()] * len(shots[fold::FOLDS])
            continue

        def score(one: _Filmed, vector: Floats = found.vector) -> float:
            shot, frame = model.shot(one.observed, vector)
            problem = StrikeProblem(one.observed, shot, frame, intended=one.intended)
            strikes, _ = search(problem, starts, seed)
            return _log_density(problem, strikes[0]) if len(strikes) else _worst()

        for index, value in enumerate(in_order(score, shots[fold::FOLDS], threads)):
            scores[FOLDS * index + fold] = value
            done(1)
    return scores


def _log_density(problem: StrikeProblem, strike: Floats) -> float:
    """Mean log density of the coordinates of a shot."""
    time = problem.observed.until(problem.observed.end).time
    found = problem.residuals(problem.observed.end)(strike[None])[0, : 2 * time.size]
    return float(np.mean(_student(found, np.repeat(SIGMA[0] + SIGMA[1] * time, 2))))


def _student(errors: Floats, sigma: Floats) -> Floats:
    """Log density of Student's t whose maximum-likelihood fit has the fit's loss.

    The loss c² ln(1 + (r/cσ)²) is twice the negative logarithm of (1 + (r/cσ)²)^(−c²/2): with the
    c = 2 of ``ROBUST`` that of ν = c² − 1 degrees of freedom and the scale cσ/√ν.
    """
    freedom = ROBUST**2 - 1.0
    scale = ROBUST * sigma / math.sqrt(freedom)
    constant = (
        math.lgamma((freedom + 1.0) / 2.0)
        - math.lgamma(freedom / 2.0)
        - 0.5 * math.log(freedom * math.pi)
    )
    density: Floats = (
        constant - np.log(scale) - 0.5 * (freedom + 1.0) * np.log1p((errors / scale) ** 2 / freedom)
    )
    return density


def _worst() -> float:
    sigma = np.array([SIGMA[0] + SIGMA[1] * _WORST_TIME])
    return float(_student(np.array([_WORST]), sigma)[0])

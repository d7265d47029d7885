"""Learning a table: physics, table and frame from filmed shots, with a report."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from carom.arguments import cores
from carom.learn.fit_table import fit
from carom.learn.intended_strikes import intended_strikes
from carom.learn.kept_work import KeptWork
from carom.learn.observation import observe
from carom.learn.posterior import LearnedNumbers
from carom.learn.report_data import fit_report
from carom.learn.report_page import write_report
from carom.learn.table_model import TableModel
from carom.learn.tracks import Tracks
from carom.noise import Noise
from carom.progress import progress_bar
from carom.shot import Shot


class Posterior(LearnedNumbers):
    """What was learned about a table from filmed shots, with a report about it."""

    __slots__ = ()

    def report(self, path: str | os.PathLike[str], tracks: Tracks, **options: Any) -> None:
        """Write a page about the table and the filmed shots: one HTML file.

        Args:
            path: The file.
            tracks: The shots from which the table was learned.
            options: Those of ``carom.learn.fit_report``, such as ``found``.

        Raises:
            OSError: The file cannot be written.
        """
        write_report(fit_report(tracks, self, **options), path, title="Learned table")


def table(
    tracks: Tracks,
    *,
    table: str | Mapping[str, Any] | None = None,
    physics: str | Mapping[str, Any] | None = None,
    free: Iterable[str] | None = None,
    intended: Shot | Mapping[str, Shot] | None = None,
    noise: Noise | None = None,
    rounds: int = 3,
    starts: int = 40,
    seed: int = 0,
    threads: int | None = None,
    progress: bool = False,
    keep: str | os.PathLike[str] | None = None,
) -> Posterior:
    """Learn the physics of a table, its nose lines and the frame of the camera from filmed shots.

    Two steps alternate. First a search finds the strike that explains each shot best. Then the free
    numbers take Gauss–Newton steps on all shots together, where the strikes of the
    shots are eliminated (variable projection, Golub & Pereyra 1973): a change of the physics comes
    with the change of every strike that belongs to it. A shot counts up to the time at which its
    model leaves the track by more than 8 cm.

    Args:
        tracks: The filmed shots.
        table: The table as a shot file has it; None is that of the tracks' header.
        physics: The models, and the numbers that are not learned, as a shot file has them; None is
            the physics that belongs to the table.
        free: Names of the numbers to learn (``carom.learn.PARAMETERS``); None for all that the
            table and the models have.
        intended: The intended shot, if all are repetitions of it, or one by the name of each shot
            that has one, such as those that the sensors of a robot measured: the search for a
            strike then begins near it.
        noise: Errors of the played strikes about the intended ones, or of the sensors. The better
            the strikes are known, the more the films tell of the table. None if they are unknown.
        rounds: How often the two steps alternate.
        starts: Starts of the search for a strike.
        seed: Seed of the starts.
        threads: Number of threads; None for all cores.
        progress: Whether to show the progress on stderr.
        keep: A file that keeps every finished round: a fit of the same shots with the same options
            goes on from it.

    Returns:
        The numbers with their uncertainty.

    Raises:
        InputError: There is no table, a name is unknown, too few shots can be used, an intended
            shot has no strike or no film, there is a noise without an intention, or ``keep`` has
            the rounds of another fit.
        OSError: ``keep`` cannot be read or written.
    """
    model = TableModel.of(tracks.header, table, physics, free)
    observed = [observe(shot) for shot in tracks]
    meant = intended_strikes(tracks, intended, noise)
    known = [None if one is None else one.to_list() for one in meant]
    question = ["table", *model.identity, starts, seed, known]
    kept = KeptWork(keep, question, observed)
    with progress_bar(rounds * len(observed), show=progress, what="strikes") as done:
        found = fit(
            observed,
            model,
            rounds=rounds,
            starts=starts,
            seed=seed,
            threads=cores(threads),
            done=done,
            kept=kept,
            intended=meant,
        )
    strikes = {
        one.name: strike
        for one, strike in zip(observed, found.strikes, strict=True)
        if strike is not None
    }
    learned = Posterior.of(model, found.vector, found.curvatures, found.gradients)
    return replace(learned, strikes=strikes)

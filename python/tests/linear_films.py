"""Shots whose samples depend on the numbers linearly: what a posterior must do is known there."""

from __future__ import annotations

import numpy as np
from carom import learn
from carom.learn.table_model import TableModel


def learned(
    random: np.random.Generator, model: TableModel, shots: int, samples: int
) -> learn.Posterior:
    """The posterior of a film whose truth is ``model.start``; samples of a shot share an error."""
    size = model.start.size
    slopes = random.standard_normal((shots, samples, size)) + random.standard_normal(
        (shots, 1, size)
    )
    errors = random.standard_normal((shots, 1)) + 0.2 * random.standard_normal((shots, samples))
    curvatures = slopes.transpose(0, 2, 1) @ slopes
    step = np.linalg.solve(curvatures.sum(axis=0), np.einsum("nks,nk->s", slopes, errors))
    gradients = np.einsum("nks,nk->ns", slopes, slopes @ step - errors)
    return learn.Posterior.of(model, model.start + step * model.steps, curvatures, gradients)

"""What ``info`` reports."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from carom import _core
from carom.shot import Shot
from carom.trace import Trace

_WORDS = _core.foul_words()

# The texts of every set of fouls that has occurred, by its bits.
_texts = np.empty(1 << len(_WORDS), dtype=object)
_texts[0] = ()
_is_known = np.zeros(1 << len(_WORDS), dtype=bool)
_is_known[0] = True


def fouls_of(bits: int) -> tuple[str, ...]:
    """The fouls of a shot in words."""
    if not _is_known[bits]:
        words = tuple(word for place, word in enumerate(_WORDS) if bits >> place & 1)
        _texts[bits], _is_known[bits] = words, True
    return _texts[bits]  # type: ignore[no-any-return]


def all_fouls(bits: NDArray[np.uint16]) -> NDArray[Any]:
    """The fouls of many shots: an array of tuples."""
    for new in np.unique(bits[~_is_known[bits]]):
        fouls_of(int(new))
    return _texts[bits]


def traces(core: _core.VectorEnv, index: int) -> tuple[Trace, ...]:
    """The shots of the last step: the agent's, then the opponent's."""
    return tuple(Shot._wrap(shot).simulate() for shot in core.shots(index))


def all_traces(core: _core.VectorEnv, count: int) -> NDArray[Any]:
    """Likewise for all environments: an array of tuples."""
    out = np.empty(count, dtype=object)
    for index in range(count):
        out[index] = traces(core, index)
    return out


def drawn(core: _core.VectorEnv, paths: tuple[str, ...]) -> dict[str, NDArray[np.float64]]:
    """The variables of the episodes, one array for each."""
    return dict(zip(paths, core.drawn().T.copy(), strict=True))

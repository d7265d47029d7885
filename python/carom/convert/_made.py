"""The result of a conversion."""

from __future__ import annotations

from typing import Any, NamedTuple

from carom import _core
from carom.arguments import number
from carom.shot import Shot

# Largest overlap of balls and cushions that an import removes, m: a tenth of a millimetre. Other
# programs leave up to 0.014 mm; a larger overlap is not rounding.
TOLERANCE = 1e-4


class Converted(NamedTuple):
    """A converted shot of another engine.

    Attributes:
        shot: The shot.
        left_out: What could not be converted or had to be assumed, one sentence each.
    """

    shot: Shot
    left_out: list[str]


def made(file: dict[str, Any], notes: list[str], tolerance: float) -> Converted:
    """The shot of a file whose balls may overlap by the rounding of another program.

    Raises:
        InputError: Balls overlap by more than the tolerance, or the engine rejects the shot.
    """
    parted, moved = _core.repaired(file, number("tolerance", tolerance))
    if moved:
        balls = ", ".join(f"{ball} ({dx:+.1e}, {dy:+.1e})" for ball, (dx, dy) in moved)
        notes.append(f"Balls that overlapped were moved apart, x and y in m: {balls}.")
    return Converted(Shot.from_dict(parted), notes)

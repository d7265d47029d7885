"""The result of a conversion."""

from __future__ import annotations

from typing import NamedTuple

from carom.shot import Shot


class Converted(NamedTuple):
    """A converted shot of another engine.

    Attributes:
        shot: The shot.
        left_out: What could not be converted or had to be assumed, one sentence each.
    """

    shot: Shot
    left_out: list[str]

"""What an import gives back."""

from __future__ import annotations

from typing import NamedTuple

from carom.shot import Shot


class Converted(NamedTuple):
    """A shot of another engine.

    Attributes:
        shot: The shot.
        left_out: What could not be carried over, or had to be assumed, each in a sentence.
    """

    shot: Shot
    left_out: list[str]

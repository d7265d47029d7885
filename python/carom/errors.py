"""Every error of ours.

``CaromError`` is the base; what the user can put right is an ``InputError``, which is also a
``ValueError``.
"""

from __future__ import annotations

from typing import Any


class CaromError(Exception):
    """Base of every error that carom raises on purpose."""


class InputError(CaromError, ValueError):
    """Bad input: the message names the place, what is wrong there and what would be right."""


class PageError(CaromError):
    """The page that ``carom play`` opens is not built; the message says how to build it."""


class EventCapError(CaromError):
    """A shot reached its cap of events (``max_events``) before it ended.

    Attributes:
        shot: The shot file (``carom-shot/1``) as a dict, ready to be run again or reported.
    """

    def __init__(self, message: str, shot: dict[str, Any]) -> None:
        super().__init__(message, shot)
        self.shot = shot

    def __str__(self) -> str:
        return str(self.args[0])

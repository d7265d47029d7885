"""The exceptions that carom raises.

``CaromError`` is the base class. Errors that the user can correct are ``InputError``, which is also
a ``ValueError``.
"""

from __future__ import annotations

from typing import Any


class CaromError(Exception):
    """Base class of the exceptions that carom raises."""


class InputError(CaromError, ValueError):
    """Bad input. The message names the place, the fault and the remedy."""


class PageError(CaromError):
    """The page that ``carom play`` opens has not been built; the message gives the remedy."""


class EventCapError(CaromError):
    """A shot reached its largest number of events (``max_events``) before it ended.

    Attributes:
        shot: The shot file (``carom-shot/1``) as a dict, for a bug report.
    """

    def __init__(self, message: str, shot: dict[str, Any]) -> None:
        super().__init__(message, shot)
        self.shot = shot

    def __str__(self) -> str:
        return str(self.args[0])

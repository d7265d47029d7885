"""The exceptions that carom raises.

``CaromError`` is the base class. Errors that the user can correct are ``InputError``, which is also
a ``ValueError``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

if TYPE_CHECKING:
    from collections.abc import Callable

    import carom


class CaromError(Exception):
    """Base class of the exceptions that carom raises."""


class InputError(CaromError, ValueError):
    """Bad input. The message names the place, the fault and the remedy."""


class AngleWarning(UserWarning):
    """An angle in radians is so large that it was probably meant in degrees.

    Filter it as any warning: ``warnings.simplefilter("error", carom.AngleWarning)``.
    """


class PageError(CaromError):
    """The page that ``carom play`` opens has not been built; the message gives the remedy."""


class EventCapError(CaromError):
    """A shot reached its largest number of events (``max_events``) before it ended.

    Attributes:
        shot: The shot file (``carom-shot/1``) as a dict, for a bug report.
    """

    # carom/shot.py sets it, because this module must not import the layers above it.
    _trace_of: ClassVar[Callable[[dict[str, Any]], carom.Trace]]

    def __init__(self, message: str, shot: dict[str, Any]) -> None:
        Exception.__init__(self, message, shot)
        self.shot = shot

    @property
    def trace(self) -> carom.Trace:
        """The trace up to the cap; its ``end`` is ``"cap"``. The shot is simulated again for it."""
        return EventCapError._trace_of(self.shot)

    def __str__(self) -> str:
        return str(self.args[0])


class EndlessMotionError(EventCapError, InputError):
    """A shot reached ``max_events`` because no friction stops its balls between the rails.

    It is bad input: give the shot an end time, ``until``.
    """

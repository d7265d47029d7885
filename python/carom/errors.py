"""The exceptions that carom raises.

``CaromError`` is the base class. Errors that the user can correct are ``InputError``, which is also
a ``ValueError``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    import carom


class CaromError(Exception):
    """Base class of the exceptions that carom raises."""


class InputError(CaromError, ValueError):
    """Bad input. The message names the place, the fault and the remedy.

    Attributes:
        kind: What kind of fault it is, such as ``"out-of-range"``; docs/errors.md lists the kinds.
            They stay from version to version.
        place: Path in the input or name of the argument, such as ``"balls[3].position"``; empty if
            there is none.
        fault: What is wrong.
        remedy: What to do about it; empty if ``fault`` says so already.
        details: Values of which ``fault`` speaks, such as the id of a ball.
    """

    def __init__(
        self,
        kind: str,
        place: str,
        fault: str,
        remedy: str = "",
        details: Mapping[str, str | float] | None = None,
    ) -> None:
        super().__init__(_sentence(place, fault, remedy))
        self.kind = kind
        self.place = place
        self.fault = fault
        self.remedy = remedy
        self.details = dict(details or {})

    def at(self, place: str, remedy: str | None = None) -> InputError:
        """The same error at another place, with another remedy if one is given."""
        remedy = self.remedy if remedy is None else remedy
        return InputError(self.kind, place, self.fault, remedy, self.details)

    def inside(self, place: str, separator: str = ".") -> InputError:
        """The same error with its place inside another one."""
        whole = place + separator + self.place if self.place else place
        return self.at(whole)

    def __reduce__(self) -> tuple[Any, ...]:
        return InputError, (self.kind, self.place, self.fault, self.remedy, self.details)


def _sentence(place: str, fault: str, remedy: str) -> str:
    where = f"{place}: " if place else ""
    return f"{where}{fault}; {remedy}" if remedy else where + fault


class AngleWarning(UserWarning):
    """An angle in radians is so large that it was probably meant in degrees.

    Filter it as any warning: ``warnings.simplefilter("error", carom.AngleWarning)``.
    """


class PageError(CaromError):
    """The page that ``carom play`` opens has not been built; the message gives the remedy."""


class EventCapError(CaromError):
    """A shot reached its largest number of events (``max_events``) before it ended.

    Attributes:
        kind: ``"too-many-events"``, or ``"endless-motion"`` if no friction stops its balls.
        place: The key of the shot file that can mend it.
        fault: What happened.
        remedy: What to do about it.
        shot: The shot file (``carom-shot/1``) as a dict, for a bug report.
    """

    kind: str = "too-many-events"

    # carom/shot.py sets it, because this module must not import the layers above it.
    _trace_of: ClassVar[Callable[[dict[str, Any]], carom.Trace]]

    def __init__(self, place: str, fault: str, remedy: str, shot: dict[str, Any]) -> None:
        Exception.__init__(self, _sentence(place, fault, remedy), shot)
        self.place = place
        self.fault = fault
        self.remedy = remedy
        self.details: dict[str, str | float] = {}
        self.shot = shot

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.place, self.fault, self.remedy, self.shot)

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

    kind = "endless-motion"

"""What a player announces before a shot, and the whole play in the form that Rust reads."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Self

from carom.arguments import instance, text


@dataclass(frozen=True)
class Call:
    """What a player announces before a shot.

    Build one with ``Call.pocket("3", "top-left")``, ``Call.on("blue")``, ``Call.safety()`` or
    ``Call.push_out()``. Pass ``None`` for no call.

    Attributes:
        kind: ``pocket``, ``on``, ``safety`` or ``push-out``.
        ball: The ball that is called or nominated.
        into: The pocket that is called.

    Raises:
        InputError: A value is not a text.
    """

    kind: str
    ball: str | None = None
    into: str | None = None

    def __post_init__(self) -> None:
        text("call.kind", self.kind, '"pocket"')
        if self.ball is not None:
            text("call.ball", self.ball, "its id")
        if self.into is not None:
            text("call.pocket", self.into, "its name")

    @classmethod
    def pocket(cls, ball: str, pocket: str) -> Self:
        """Call a ball and its pocket."""
        return cls("pocket", ball, pocket)

    @classmethod
    def on(cls, ball: str) -> Self:
        """Nominate a ball in snooker: a colour, or the free ball."""
        return cls("on", ball)

    @classmethod
    def safety(cls) -> Self:
        """Call a safety: the other player shoots next, whatever falls."""
        return cls("safety")

    @classmethod
    def push_out(cls) -> Self:
        """Call a push-out, after a legal break of nine-ball or ten-ball."""
        return cls("push-out")


@dataclass(frozen=True, slots=True)
class PlayArguments:
    """A play in the form that Rust reads, by attribute.

    Attributes:
        strike: Speed, azimuth, elevation (None is the default one), side, height.
        policy: ``obstruction`` and ``miscue`` of the strike.
        cue_ball: Where the cue ball is placed first (x, y in m); None if it is not in hand.
        call: Kind, ball and pocket.
        cling: The contacts that cling, as a shot file has them; None for none.
    """

    strike: tuple[float, float, float | None, float, float]
    policy: tuple[str, str]
    cue_ball: tuple[float, ...] | None
    call: tuple[str, str | None, str | None]
    cling: Mapping[str, Any] | None = None


def fields_of(call: Call | None) -> tuple[str, str | None, str | None]:
    """Kind, ball and pocket, in the form that Rust accepts.

    Raises:
        InputError: It is neither None nor a ``carom.Call``.
    """
    if call is None:
        return "nothing", None, None
    instance("call", call, Call, 'carom.Call.pocket("1", "left")')
    return call.kind, call.ball, call.into

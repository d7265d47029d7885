"""What a player announces before a shot, and the whole play in the form that Rust reads."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Self

from carom import _core
from carom.arguments import instance, text
from carom.errors import InputError

# The kinds of calls with their further values.
_PARTS: dict[str, tuple[str, ...]] = {
    "nothing": (),
    "pocket": ("ball", "into"),
    "on": ("ball",),
    "safety": (),
    "push-out": (),
}


@dataclass(frozen=True)
class Call:
    """What a player announces before a shot.

    Build one with ``Call.pocket("3", "top-left")``, ``Call.on("blue")``, ``Call.safety()`` or
    ``Call.push_out()``. No call is ``None``, or ``Call("nothing")``: ``request.calls`` names it so.

    Attributes:
        kind: ``pocket``, ``on``, ``safety``, ``push-out`` or ``nothing``.
        ball: The ball that is called or nominated; None for other kinds.
        into: The pocket that is called; None for other kinds.

    Raises:
        InputError: There is no such kind, or its ball or pocket is missing or not a text.
    """

    kind: str
    ball: str | None = None
    into: str | None = None

    def __post_init__(self) -> None:
        if text("call.kind", self.kind, '"pocket"') not in _PARTS:
            _core.unknown_word(self.kind, "call.kind", "call", list(_PARTS))
        for name, such_as in (("ball", "its id"), ("into", "the pocket's name")):
            value = getattr(self, name)
            if name in _PARTS[self.kind]:
                text(f"call.{name}", value, such_as)
            elif value is not None:
                raise InputError(
                    "conflict", f"call.{name}", f'a call of "{self.kind}" has none', "leave it out"
                )

    def to_dict(self) -> dict[str, str]:
        """Plain values, for JSON, without those that this kind does not have."""
        parts = {"kind": self.kind, "ball": self.ball, "into": self.into}
        return {key: value for key, value in parts.items() if value is not None}

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


# Not frozen: that takes longer to make, and every shot of a player makes one.
@dataclass(slots=True)
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


def read_call(call: Call | Mapping[str, Any] | None) -> Call | None:
    """A call, also from a dict with its attributes; None if nothing is called.

    Raises:
        InputError: It is neither of these, or a key is unknown.
    """
    if call is None:
        return None
    if isinstance(call, Mapping):
        _core.check_keys(call, "call", ["kind", "ball", "into"])
        if "kind" not in call:
            raise InputError(
                "missing", "call.kind", "is missing", 'write one of request.calls, such as "pocket"'
            )
        call = Call(**call)
    return None if instance("call", call, Call, _EXAMPLE).kind == "nothing" else call


_EXAMPLE = 'carom.Call.pocket("1", "left")'


def fields_of(call: Call | Mapping[str, Any] | None) -> tuple[str, str | None, str | None]:
    """Kind, ball and pocket, in the form that Rust accepts.

    Raises:
        InputError: As for ``read_call``.
    """
    found = read_call(call)
    return ("nothing", None, None) if found is None else (found.kind, found.ball, found.into)

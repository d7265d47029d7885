"""The break that both players of a match are given."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from carom import _core
from carom.arguments import numbers
from carom.batch import own_strike
from carom.build import Physics, Strike, Table
from carom.call import Call
from carom.errors import InputError
from carom.player import Play
from carom.racks import break_shot
from carom.rules import Frame


def preset_break(game: str, table: Any, preset: str) -> Play:
    """The break of a preset as a play.

    Args:
        game: The game.
        table: The name of the table; the game's own if None.
        preset: One of ``carom.break_presets()`` for the game.

    Raises:
        InputError: There is no such preset for the game, or the table has no name.
    """
    if table is not None and not isinstance(table, str):
        raise InputError(
            "unsupported",
            "same_break",
            "a preset needs a table with a name",
            'write a play: {"strike": {"speed": 10, "azimuth_deg": 90}, "cue_ball": [0.6, 0.5]}',
        )
    shot = break_shot(game, table=table, preset=preset)
    file = shot.to_dict()
    (x, y, *_), *_ = (b["position"] for b in file["balls"] if b["id"] == file["strike"]["ball"])
    request = Frame(game, table=table).request
    # Straight pool opens with a safety; in three-cushion the cue ball stays where it lies.
    return Play(
        Strike(*own_strike(shot._core)),
        cue_ball=(x, y) if request.in_hand else None,
        call=Call("safety") if preset == "safety" else None,
    )


def read_break(value: Any, game: str, table: Any) -> Play:
    """The break of a tournament's file: the name of a preset, or a play as plain values.

    Args:
        value: A name; or an object with ``strike`` (as in a shot file), and if they exist
            ``cue_ball`` (x and y, m) and ``call`` (``kind``, ``ball``, ``into``).
        game: The game.
        table: The table; the game's own if None.

    Raises:
        InputError: A value is missing, unknown or of a wrong type; the place is inside
            ``same_break``.
    """
    if isinstance(value, str):
        return preset_break(game, table, value)
    try:
        _core.check_keys(value, "", ("strike", "cue_ball", "call"))
        if "strike" not in value:
            raise InputError(
                "missing", "strike", "it is missing", 'write {"speed": 10, "azimuth_deg": 90}'
            )
        place, call = value.get("cue_ball"), value.get("call")
        if call is not None:
            _core.check_keys(call, "call", ("kind", "ball", "into"))
        x_and_y = None if place is None else tuple(numbers("cue_ball", place, 2))
        return Play(
            Strike.from_dict(value["strike"]),
            cue_ball=None if x_and_y is None else (x_and_y[0], x_and_y[1]),
            call=None if call is None else Call(**{"kind": "nothing", **call}),
        )
    except InputError as error:
        raise error.inside("same_break") from None


def recorded_break(
    play: Play,
    game: str,
    table: Table | str | Mapping[str, Any] | None,
    physics: Physics | str | Mapping[str, Any] | None,
) -> dict[str, Any]:
    """A break in the form of a record of a match; with the default elevation if it has none.

    Raises:
        InputError: It is not a play, or cannot be played; the place is inside ``same_break``.
    """
    if not isinstance(play, Play):
        raise InputError(
            "wrong-type", "same_break", f"found a {type(play).__name__}", "give carom.Play(...)"
        )
    if play.strike.elevation is None:
        try:
            shot = play.shot(Frame(game, table=table, physics=physics))
        except InputError as error:
            raise error.inside("same_break") from None
        play = replace(play, strike=replace(play.strike, elevation=shot.elevation))
    written = play.to_dict()
    if play.call is not None:
        call = {"kind": play.call.kind, "ball": play.call.ball, "pocket": play.call.into}
        written["call"] = {key: value for key, value in call.items() if value is not None}
    return written

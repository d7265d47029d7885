"""Reference data of the engine: the tables' presets and the schemas of its files."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Literal, NamedTuple

from carom import _core
from carom.arguments import text as checked
from carom.errors import InputError


class Options(NamedTuple):
    """The options of a frame, which its players agree on.

    Attributes:
        points: Points that win games whose ``scoring`` is ``target``.
        miss: Whether a foul and a miss is called in snooker.
        patience: Number of shots in a row without progress that make a stalemate.
    """

    points: int
    miss: bool
    patience: int


#: The options of a frame that has no others.
DEFAULT_OPTIONS = Options(**_core.default_options())


def tables() -> list[dict[str, Any]]:
    """All presets of tables, with dimensions, cushions and pockets, m.

    ``name`` has no date if the values are the newest; ``dated_name`` names them for ever. Older
    editions follow the newest ones. Batch results number the pockets in the order given here.
    """
    return _core.tables()


def game_facts() -> list[dict[str, Any]]:
    """The facts of every game.

    Each has ``name``; ``table``, on which it is played by default; ``players``, 1 or 2; ``balls``,
    their number with the cue balls; ``own_cue_balls``, whether each player has one; ``objective``:
    ``any-ball``, ``lowest-first``, ``groups``, ``reds-and-colors`` or ``caroms``;
    ``deciding_ball``, the number of the ball that decides the game, or None; ``scoring``:
    ``last-ball``, ``points`` (those at the end decide; ``maximum`` is the largest break without
    fouls) or ``target`` (a number of points wins; ``usual_points``); ``opening``: ``break``,
    ``safety`` or ``carom``; ``lag``, whether the players lag for the break; and ``miss``, whether a
    foul may also be a miss.
    """
    return _core.game_facts()


def rule_sets() -> list[str]:
    """The names of the games, for ``Frame``, ``break_shot`` and ``carom.env``."""
    return [facts["name"] for facts in game_facts()]


def points_help() -> str:
    """The games that a number of points wins, for a help text."""
    names = [facts["name"] for facts in game_facts() if facts["scoring"] == "target"]
    return f"Points that win {', '.join(names[:-1])} and {names[-1]}."


def physics() -> list[dict[str, Any]]:
    """All presets of physics with their values, and the source of every value.

    Each has ``name``, ``dated_name``, ``parameters`` (a list of ``key``, ``value``, ``unit``,
    ``evidence``, ``source``) and ``physics``, the same values as a shot file has them.
    ``evidence`` is ``measured``, ``fit``, ``specified`` (a rule book, a convention, a published
    model) or ``estimate``. Older editions follow the newest ones.
    """
    return _core.physics()


# The schemas that are files of this package; the engine has the others.
_OF_DATA = ("sweep", "tournament", "tracks", "drill", "player")


def schema(
    kind: Literal[
        "shot",
        "trace",
        "play",
        "sweep",
        "tournament",
        "arena",
        "tracks",
        "study",
        "drill",
        "player",
    ] = "shot",
) -> dict[str, Any]:
    """The JSON Schema of a shot file, a trace, a play, or another kind of file.

    ``sweep`` is that of a sweep's spec, ``tournament`` that of a tournament's file, ``tracks`` that
    of the header of tracks, and ``study`` that of a study, which refers to those of a shot file and
    a drill; ``drill`` is that of a drill, and ``player`` that of a learned player.
    ``arena`` is that of the messages between a referee and a program, ``carom-arena/1``: its
    ``$defs`` have one for each message.

    ``Frame.answer_schema`` gives that of the answers to a frame's present request.

    Raises:
        InputError: There is no schema of that name.
    """
    if checked("kind", kind, '"shot"') in _OF_DATA:
        path = Path(__file__).with_name("data") / f"carom-{kind}-1.json"
        text = path.read_text(encoding="utf-8")
    elif kind in ("shot", "trace", "play", "arena", "study"):
        text = _core.schema(kind)
    else:
        raise InputError(
            "unknown-name",
            "kind",
            f'there is no schema "{kind}"',
            'write "shot", "trace", "play", "sweep", "tournament", "arena", "tracks", "study", '
            '"drill" or "player"',
        )
    result: dict[str, Any] = json.loads(text)
    return result

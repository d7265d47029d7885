"""``carom arena check``: a player in situations of every kind."""

from __future__ import annotations

import sys
from typing import Annotated

import typer

import carom
from carom.arena.named_players import named_player
from carom.arena.player_check import CLOCK
from carom.cli.options import Json
from carom.cli.output import emit_answer, say


def check(
    player: Annotated[
        str,
        typer.Argument(
            metavar="PLAYER",
            help="A name, such as carom:200; a file and a class of your own in it, such as "
            "mine.py:Mine; or exec: and the command of a program.",
        ),
    ],
    clock: Annotated[float, typer.Option(help="Clock of the player in each situation, s.")] = CLOCK,
    json: Json = False,
) -> None:
    """Ask a player in situations of every kind; print a verdict for each.

    The exit status is 2 if an answer was refused or missing.
    """
    report = carom.arena.check(
        named_player("player", player), clock=clock, progress=sys.stderr.isatty()
    )
    emit_answer(report, json=json)
    if report.log:
        say(f"the exceptions of the player:\n{report.log}")
    if not report.passed:
        raise typer.Exit(2)

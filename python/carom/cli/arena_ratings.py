"""``carom arena ratings``: the ratings of a tournament's players."""

from __future__ import annotations

import csv
import io
import json as js
from pathlib import Path
from typing import Annotated

import typer

import carom
from carom.arena.bradley_terry import RatingTable
from carom.cli.options import Json, Level
from carom.cli.output import emit
from carom.errors import InputError


def ratings(
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="The folder of a tournament.")],
    level: Level = 0.95,
    json: Json = False,
    as_csv: Annotated[bool, typer.Option("--csv", help="Print the tables as CSV.")] = False,
) -> None:
    """Print the ratings of a tournament, a table for each condition.

    The tournament may go on meanwhile.
    """
    if json and as_csv:
        raise InputError("conflict", "--csv", "--json is given too", "give one of them")
    tables = carom.arena.ratings(folder, level=level)
    if json:
        emit(js.dumps([table.to_dict() for table in tables]))
    elif as_csv:
        emit(_csv(tables))
    else:
        emit("\n\n".join(map(str, tables)) or "no frame was played yet")


def _csv(tables: tuple[RatingTable, ...]) -> str:
    text = io.StringIO()
    out = csv.writer(text, lineterminator="\n")
    heads = ("condition", "player", "elo", "low", "high", "frames", "share")
    out.writerow((*heads, "adjusted_share", "adjusted_low", "adjusted_high"))
    for table in tables:
        for row in table.players:
            numbers = (row.elo, row.low, row.high, row.frames, row.share)
            adjusted = row.adjusted
            corrected = (
                ("", "", "") if adjusted is None else (adjusted.share, *adjusted.share_interval)
            )
            out.writerow((table.condition, row.player, *numbers, *corrected))
    return text.getvalue().rstrip("\n")

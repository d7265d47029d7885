"""Strikes of a film in a folder, as ``carom learn strikes`` writes it, and the players of shots."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from carom import _core
from carom.errors import InputError
from carom.files import read_text, shown
from carom.installed import ENGINE
from carom.learn.filmed_strikes import FilmedStrike
from carom.learn.player_errors import PlayedStrike
from carom.shot import Shot

#: The file of a folder that lists its strikes.
INDEX = "strikes.json"
FORMAT = "carom-strikes/1"


def index_of(strikes: Sequence[FilmedStrike], files: Sequence[str]) -> dict[str, Any]:
    """``carom-strikes/1``: the names, files and posterior samples of some strikes."""
    rows = []
    for strike, file in zip(strikes, files, strict=True):
        row: dict[str, Any] = {
            "name": strike.name,
            "file": file,
            "clock": strike.clock,
            "rmse": strike.rmse,
            "rmse_3s": strike.rmse_3s,
        }
        samples = getattr(strike, "samples", None)
        if samples is not None:
            row["samples"] = [[float(f"{x:.7g}") for x in sample] for sample in samples.tolist()]
        rows.append(row)
    return {"format": FORMAT, "engine": ENGINE, "strikes": rows}


def read_strikes(folder: str | os.PathLike[str], *, exact: bool = False) -> list[PlayedStrike]:
    """The strikes of a folder.

    Args:
        folder: A folder that ``carom learn strikes`` wrote; with ``exact`` one of shot files.
        exact: Whether the strikes are known exactly; the names are then those of the files.

    Raises:
        OSError: A file cannot be read.
        InputError: The folder has no list of its strikes, or a strike has no samples.
    """
    place = Path(folder)
    if exact:
        files = sorted(file for file in place.glob("*.json") if file.name != INDEX)
        return [PlayedStrike.exact(file.stem, Shot.load(file)) for file in files]
    index = place / INDEX
    if not index.is_file():
        raise InputError(
            "missing",
            shown(place),
            f"it has no {INDEX}, so the errors of measurement are unknown",
            "find the strikes again with carom learn strikes, or say that they are known exactly "
            "(--exact)",
        )
    file = _core.read_json(read_text(index), shown(index))
    if not isinstance(file, dict) or file.get("format") != FORMAT:
        raise InputError("format", shown(index), "it is not a list of strikes", f"write {FORMAT!r}")
    found = []
    for number, row in enumerate(file.get("strikes", [])):
        try:
            name, shot, samples = row["name"], row["file"], row["samples"]
        except (KeyError, TypeError):
            raise InputError(
                "missing",
                f"{shown(index)}: strikes[{number}]",
                "it needs name, file and samples",
                "find the strikes again with carom learn strikes",
            ) from None
        found.append(PlayedStrike.of_samples(str(name), Shot.load(place / str(shot)), samples))
    return found


def read_players(path: str | os.PathLike[str]) -> dict[str, str]:
    """The player of each shot: CSV with the columns shot and player, or JSON {shot: player}.

    Raises:
        OSError: The file cannot be read.
        InputError: It is neither.
    """
    text = read_text(path)
    if str(path).endswith(".json"):
        file = _core.read_json(text, shown(path))
        if not isinstance(file, dict) or not all(isinstance(v, str) for v in file.values()):
            raise InputError(
                "wrong-type", shown(path), "it is not a player for each shot", 'write {"1": "Ann"}'
            )
        return file
    rows = csv.DictReader(io.StringIO(text), skipinitialspace=True)
    if not {"shot", "player"} <= set(rows.fieldnames or ()):
        raise InputError(
            "missing",
            shown(path),
            f"its columns are {', '.join(rows.fieldnames or ())}",
            "name them shot and player",
        )
    return {row["shot"]: row["player"] for row in rows}

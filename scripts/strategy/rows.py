"""What is stored of an experiment while it is played: a file with one JSON object a line."""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any


def read_rows(path: Path) -> list[dict[str, Any]]:
    """The rows so far; none without the file, whose folder is made."""
    path.parent.mkdir(parents=True, exist_ok=True)
    return list(map(json.loads, path.read_text("utf-8").splitlines())) if path.exists() else []


def write_rows(path: Path, rows: Iterable[dict[str, Any]]) -> None:
    """Replaces the rows."""
    path.write_text("".join(json.dumps(row) + "\n" for row in rows), encoding="utf-8")


def add_rows(path: Path, rows: Iterable[dict[str, Any]]) -> None:
    """Adds rows at the end."""
    with path.open("a", encoding="utf-8") as file:
        file.writelines(json.dumps(row) + "\n" for row in rows)

"""Results of a long fit in a file, so that one that was stopped goes on."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from carom import __version__
from carom.errors import InputError
from carom.files import read_text, shown, write_whole
from carom.installed import ENGINE
from carom.learn.observation import Observation

FORMAT = "carom-fit/1"


class KeptWork:
    """Named results of a fit. Each is in the file as soon as it is there.

    Args:
        path: The file; None keeps the results in memory alone.
        question: What is fitted and how: values of JSON.
        observed: What was seen.

    Raises:
        InputError: The file has the work of another fit, or of other shots.
        OSError: The file cannot be read.
    """

    def __init__(
        self,
        path: str | os.PathLike[str] | None,
        question: Any,
        observed: Sequence[Observation],
    ) -> None:
        self.path = None if path is None else Path(path)
        self.key = _key(question, observed)
        self.results: dict[str, Any] = {}
        if self.path is not None and self.path.exists():
            self.results = self._read(self.path)

    def get(self, name: str) -> Any:
        """A result; None if it is not there."""
        return self.results.get(name)

    def put(self, name: str, result: Any) -> None:
        """Keep a result, a value of JSON.

        Raises:
            OSError: The file cannot be written.
        """
        self.results[name] = result
        if self.path is not None:
            file = {"format": FORMAT, "engine": ENGINE, "key": self.key, "results": self.results}
            write_whole(self.path, json.dumps(file) + "\n")

    def _read(self, path: Path) -> dict[str, Any]:
        remedy = "delete it, or name another file"
        try:
            file = json.loads(read_text(path))
            results, key = file["results"], file["key"]
        except (ValueError, KeyError, TypeError):
            raise InputError("syntax", shown(path), "it is not the work of a fit", remedy) from None
        if key != self.key or not isinstance(results, dict):
            fault = "it has the work of a fit with other shots, other options or another carom"
            raise InputError("wrong-state", shown(path), fault, remedy)
        return results


def _key(question: Any, observed: Sequence[Observation]) -> str:
    """A hash of what a fit depends on."""
    digest = hashlib.sha256(json.dumps([__version__, question], sort_keys=True).encode())
    for shot in observed:
        digest.update(json.dumps([shot.name, shot.struck, shot.first_move, shot.rest]).encode())
        for ball, places in shot.position.items():
            digest.update(ball.encode())
            digest.update(places.tobytes())
    return digest.hexdigest()

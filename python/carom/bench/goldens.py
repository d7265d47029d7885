"""Whether a stored result is older than the engine's present results.

A result that depends on the engine's physics is stored with the hashes of the example shots
(``goldens/shots.json``). If one of these hashes has changed since, the engine gives other results,
and what is stored has to be made again. A shot that is only added changes nothing.
"""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from carom.bench import report

if TYPE_CHECKING:
    from collections.abc import Mapping

#: The key of a stored result under which its hashes are.
KEY = "goldens"


def hashes() -> dict[str, str]:
    """The hash of each example shot, by its name.

    Raises:
        FileNotFoundError: The package is not installed from a checkout, and the working directory
            is not in one.
    """
    root = report.checkout()
    if root is None:
        raise FileNotFoundError("no checkout of carom: run this in its root, which has goldens/")
    shots = json.loads((root / "goldens" / "shots.json").read_text(encoding="utf-8"))
    return {name: shot["hash"] for name, shot in shots.items()}


def stamp(command: str) -> dict[str, Any]:
    """What a stored result begins with: its command, commit, date and the hashes of the goldens."""
    measured = report.where()
    return {
        "command": command,
        "commit": measured["commit"],
        "date": measured["date"][:10],
        KEY: hashes(),
    }


def changed(stored: Mapping[str, Any], now: Mapping[str, str] | None = None) -> list[str]:
    """The example shots whose hashes differ from those of a stored result, or that are gone.

    Args:
        stored: A stored result.
        now: The hashes to compare with; by default those of the checkout.

    Raises:
        ValueError: The stored result has no hashes.
    """
    then = stored.get(KEY)
    if not then:
        raise ValueError(f"the stored result has no hashes under {KEY!r}: make it again")
    today = hashes() if now is None else now
    return sorted(name for name, hash_ in then.items() if today.get(name) != hash_)

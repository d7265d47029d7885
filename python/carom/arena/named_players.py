"""Players of one's own in a file: ``FILE.py:NAME``."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from carom.arena.contestants import is_program, program
from carom.arena.player_files import load_file
from carom.errors import InputError
from carom.files import shown

# Between the file and the name in it.
_SEPARATOR = ".py:"


def named_player(argument: str, word: str, folder: Path = Path()) -> Any:
    """The player that an argument names.

    Args:
        argument: The name of the argument, for the error message.
        word: The name of a built-in player; a program, ``exec:COMMAND``; or ``FILE.py:NAME``,
            where NAME is a class with a method ``choose``, a function without arguments that makes
            a player, or a player.
        folder: The folder to which FILE.py, and the files among the words of COMMAND, are relative.

    Returns:
        The name of a built-in player, a program as a contestant, or what the file has under NAME.

    Raises:
        InputError: There is no such file or program, it does not run, or it has no such name.
    """
    if is_program(word):
        return program(argument, word, folder)
    if word.endswith(".py"):
        raise InputError(
            "missing", argument, f"{word} names no class", f"write {word}:NAME, such as {word}:Mine"
        )
    file, separator, name = word.rpartition(_SEPARATOR)
    if not separator:
        return word
    path = folder / (file + ".py")
    module = load_file(argument, path)
    found = getattr(module, name, None)
    if found is None:
        classes = [
            key
            for key, value in vars(module).items()
            if isinstance(value, type) and callable(getattr(value, "choose", None))
        ]
        remedy = f"write one of {', '.join(classes)}" if classes else _CLASS
        raise InputError("unknown-name", argument, f"{shown(path)} has no {name!r}", remedy)
    if isinstance(found, str) or not (callable(found) or callable(getattr(found, "choose", None))):
        raise InputError(
            "wrong-type", argument, f"{name} in {shown(path)} is a {type(found).__name__}", _CLASS
        )
    return found


_CLASS = "write a class with a method choose(self, situation)"

"""Players of one's own on the command line: ``FILE.py:NAME``."""

from __future__ import annotations

import sys
from importlib import util
from pathlib import Path
from types import ModuleType
from typing import Any

from carom.errors import InputError
from carom.files import shown

# Between the file and the name in it.
_SEPARATOR = ".py:"


def named_player(argument: str, word: str) -> Any:
    """The player that an argument names.

    Args:
        argument: The name of the argument, for the error message.
        word: The name of a built-in player; or ``FILE.py:NAME``, where NAME is a class with a
            method ``choose``, a function without arguments that makes a player, or a player.

    Returns:
        The name of a built-in player, or what the file has under NAME.

    Raises:
        InputError: There is no such file, it does not run, or it has no such name.
    """
    if word.endswith(".py"):
        raise InputError(
            "missing", argument, f"{word} names no class", f"write {word}:NAME, such as {word}:Mine"
        )
    file, separator, name = word.rpartition(_SEPARATOR)
    if not separator:
        return word
    path = Path(file + ".py")
    module = _loaded(argument, path)
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


def _loaded(argument: str, path: Path) -> ModuleType:
    """The module of a file. It can import the modules beside it, as a program can."""
    if not path.is_file():
        raise InputError(
            "missing", argument, f"there is no file {shown(path)}", "check the path of the file"
        )
    # A name of its own, so that a file called like a module of another library hides nothing.
    key = f"carom_player_{path.stem}"
    spec = util.spec_from_file_location(key, path)
    assert spec is not None
    assert spec.loader is not None
    module = util.module_from_spec(spec)
    sys.modules[key] = module
    sys.path.insert(0, str(path.resolve().parent))
    try:
        spec.loader.exec_module(module)
    except Exception as error:
        line = f"{type(error).__name__}: {error}"
        raise InputError(
            "syntax",
            argument,
            f"{shown(path)} does not run ({line})",
            f"run python {shown(path)} for its traceback",
        ) from error
    return module

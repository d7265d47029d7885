"""Files with players of one's own."""

from __future__ import annotations

import sys
from importlib import util
from pathlib import Path
from types import ModuleType

from carom.errors import InputError
from carom.files import shown

#: The files that were loaded, by the names of their modules. A process that unpickles a player of
#: such a file has to load it first.
FILES: dict[str, Path] = {}
# When each of these files was changed last, ns.
_CHANGED: dict[str, int] = {}


def load_file(argument: str, path: Path) -> ModuleType:
    """The module of a file. It can import the modules beside it, as a program can.

    Args:
        argument: The name of the argument that names the file, for the error message.
        path: The file.

    Raises:
        InputError: There is no such file, or it does not run.
    """
    if not path.is_file():
        raise InputError(
            "missing", argument, f"there is no file {shown(path)}", "check the path of the file"
        )
    resolved = path.resolve()
    key, changed = _module_name(resolved), resolved.stat().st_mtime_ns
    if _CHANGED.get(key) == changed:
        # Two players of one file are in one module, so that both can be pickled.
        return sys.modules[key]
    spec = util.spec_from_file_location(key, path)
    assert spec is not None
    assert spec.loader is not None
    module = util.module_from_spec(spec)
    sys.modules[key] = module
    sys.path.insert(0, str(resolved.parent))
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
    FILES[key], _CHANGED[key] = resolved, changed
    return module


def _module_name(path: Path) -> str:
    """The name of the module of a file.

    It differs from the names of other libraries' modules, and from those of files in other folders
    that are called like this one: an old and a new version of a player can meet.
    """
    stem, number = f"carom_player_{path.stem}", 1
    key = stem
    while FILES.get(key, path) != path:
        number += 1
        key = f"{stem}_{number}"
    return key

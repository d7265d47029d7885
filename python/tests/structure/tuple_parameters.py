"""Finds the functions of Rust that have a parameter in a tuple.

A tuple hides the names of what is passed, and the number of parameters. Run as a program, it prints
them.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]

_BLANKED = re.compile(r"""//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])'""", re.DOTALL)
# A tuple or a reference to one; `()` and a parenthesis around one type are none.
_TUPLE = re.compile(r"(?:mut )?(?:\w+|\(.*\)) ?: ?(?:&(?:'\w+ )?(?:mut )?)?\(.*,.*\)$")


def functions(root: Path = ROOT) -> list[str]:
    """The place and the name of each such function of the crates."""
    return [
        f"{path.relative_to(root)}:{line} {name}"
        for path in sorted(root.glob("crates/*/src/**/*.rs"))
        for line, name, parameters in _functions(path.read_text(encoding="utf-8"))
        if any(_TUPLE.match(" ".join(parameter.split())) for parameter in parameters)
    ]


def _functions(text: str) -> Iterator[tuple[int, str, list[str]]]:
    """The line, the name and the parameters of each function."""
    text = _BLANKED.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)
    for match in re.finditer(r"\bfn (\w+)", text):
        start = match.end()
        if text[start] == "<":
            start = _end(text, start)
        if text[start] == "(":
            inside = text[start + 1 : _end(text, start) - 1]
            yield text.count("\n", 0, match.start()) + 1, match[1], _split(inside)


def _end(text: str, start: int) -> int:
    """The place after the bracket that closes the one at ``start``."""
    return next(at for at, depth in _depths(text, start) if depth == 0) + 1


def _split(inside: str) -> list[str]:
    commas = [at for at, depth in _depths(inside, 0) if depth == 0 and inside[at] == ","]
    return [inside[a + 1 : b] for a, b in zip([-1, *commas], [*commas, len(inside)], strict=True)]


def _depths(text: str, start: int) -> Iterator[tuple[int, int]]:
    """The places from ``start`` on, and how many brackets are open behind each."""
    depth = 0
    for at in range(start, len(text)):
        is_arrow = text[at] == ">" and text[at - 1] in "-="
        depth += (text[at] in "([{<") - (text[at] in ")]}>" and not is_arrow)
        yield at, depth


if __name__ == "__main__":
    sys.stdout.writelines(f"{found}\n" for found in functions())

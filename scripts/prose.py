"""Finds phrases that this project avoids in its prose.

It searches Markdown, comments, docstrings and strings in the code for the patterns of
scripts/prose.toml. CONTRIBUTING.md has the rules of style. The exit status is 1 if a phrase
is found.

usage: python scripts/prose.py [FILE ...]   (without files: everything that git tracks)
"""

from __future__ import annotations

import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from pygments.lexers import get_lexer_for_filename
from pygments.token import Comment, String
from pygments.util import ClassNotFound

ROOT = Path(__file__).resolve().parent.parent
# Files with prose; other files hold data.
SUFFIXES = {".md", ".rs", ".py", ".pyi", ".ts", ".js", ".css", ".html", ".sh", ".toml"}
NAMES = {"Makefile"}
# Files that quote the phrases, or that others wrote.
EXCLUDED = {"scripts/prose.toml", "CONTRIBUTING.md", "LICENSE-THIRD-PARTY"}

_FENCE = re.compile(r"^(```|~~~).*?^\1", re.MULTILINE | re.DOTALL)
_CODE = re.compile(r"`[^`\n]*`")
_MARKER = re.compile(r"^\s*(?:///?!?|//!|/\*+|\*/?|#+!?)(?!\[)", re.MULTILINE)


@dataclass(frozen=True)
class Phrase:
    """A pattern and what to write instead."""

    pattern: re.Pattern[str]
    instead: str


def phrases() -> list[Phrase]:
    """The phrases of scripts/prose.toml; a space in a pattern matches a line break too."""
    table = tomllib.loads((ROOT / "scripts/prose.toml").read_text(encoding="utf-8"))
    return [
        Phrase(re.compile(p["pattern"].replace(" ", r"\s+"), re.IGNORECASE), p["instead"])
        for p in table["phrase"]
    ]


def passages(file: str, text: str) -> Iterator[tuple[int, str]]:
    """The prose of a file: the line on which each passage begins, and the passage.

    Code is blanked out, and line breaks are kept, so that a match has a line.
    """
    if file.endswith(".md"):
        yield 1, _without_code(text)
        return
    try:
        lexer = get_lexer_for_filename(file, stripnl=False, ensurenl=False)
    except ClassNotFound:
        return
    start, passage = 0, ""
    for offset, kind, value in lexer.get_tokens_unprocessed(text):
        if (kind in Comment and kind not in Comment.Preproc) or kind in String:
            if not passage:
                start = offset
            passage += value
        elif value.strip():
            if passage:
                yield text.count("\n", 0, start) + 1, _without_markers(passage)
            passage = ""
        elif passage:
            passage += value
    if passage:
        yield text.count("\n", 0, start) + 1, _without_markers(passage)


def _without_code(text: str) -> str:
    text = _FENCE.sub(lambda m: "\n" * m.group().count("\n"), text)
    return _CODE.sub("`", text)


def _without_markers(text: str) -> str:
    return _without_code(_MARKER.sub("", text))


def findings(file: str, text: str, known: list[Phrase]) -> Iterator[str]:
    """One line for each phrase found: place, phrase, remedy."""
    for first, passage in passages(file, text):
        for phrase in known:
            for match in phrase.pattern.finditer(passage):
                line = first + passage.count("\n", 0, match.start())
                found = " ".join(match.group().split())
                yield f"{file}:{line}: “{found}”: {phrase.instead}"


def tracked() -> list[str]:
    """The files with prose that git tracks."""
    listed = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, check=True, capture_output=True, text=True
    ).stdout.splitlines()
    return [
        f
        for f in listed
        if f not in EXCLUDED and (Path(f).suffix in SUFFIXES or Path(f).name in NAMES)
    ]


def main() -> int:
    """Prints every phrase that is found, and their number."""
    files = sys.argv[1:] or tracked()
    known = phrases()
    found = 0
    for file in files:
        path = ROOT / file
        # Git tracks a link to a folder as a file; the folder's own files are listed elsewhere.
        if not path.is_file():
            continue
        for line in findings(file, path.read_text(encoding="utf-8"), known):
            print(line)
            found += 1
    if found:
        print(f"{found} phrases to rewrite; see CONTRIBUTING.md, Plain English.", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

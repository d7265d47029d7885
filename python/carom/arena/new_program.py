"""The template of a program that plays, in four languages."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from carom.errors import InputError
from carom.files import shown


@dataclass(frozen=True, slots=True)
class Template:
    """A language of the template.

    Attributes:
        file: The program's file.
        build: The command that builds it; empty if none is needed.
        command: The command that runs it.
    """

    file: str
    build: str
    command: str


TEMPLATES = {
    "python": Template("player.py", "", "python3 player.py"),
    "cpp": Template("player.cpp", "g++ -O2 -std=c++20 -o player player.cpp", "./player"),
    "node": Template("player.mjs", "", "node player.mjs"),
    "rust": Template("player.rs", "rustc --edition 2021 -O player.rs", "./player"),
}

_FILES = Path(__file__).parents[1] / "data" / "arena"


def new_program(folder: Path, language: str) -> list[Path]:
    """Write a program that plays, and a README of how to run it, into a new folder.

    Returns:
        The files.

    Raises:
        InputError: There is no template in this language, or the folder exists and is not empty.
        OSError: The files cannot be written.
    """
    template = TEMPLATES.get(language)
    if template is None:
        raise InputError(
            "unknown-name",
            "language",
            f"there is no template in {language!r}",
            f"write one of {', '.join(TEMPLATES)}",
        )
    if folder.exists() and any(folder.iterdir()):
        raise InputError(
            "conflict", "folder", f"{shown(folder)} is not empty", "give the name of a new folder"
        )
    folder.mkdir(parents=True, exist_ok=True)
    program, readme = folder / template.file, folder / "README.md"
    program.write_bytes((_FILES / template.file).read_bytes())
    readme.write_text(_readme(template), encoding="utf-8")
    return [program, readme]


def _readme(template: Template) -> str:
    player = f'exec:"{template.command}"' if " " in template.command else f"exec:{template.command}"
    build = f"Build it first:\n\n    {template.build}\n\n" if template.build else ""
    return f"""# A player for carom's arena

`{template.file}` speaks carom-arena/1, one line of JSON for each message. It pots the easiest
ball, aimed at the ghost ball. Make it better: the function that answers a shot is the place to
begin.

{build}Ask it in situations of every kind:

    carom arena check {player}

Let it play, here and then in the page:

    carom match {player} level-1 --game nine-ball --pairs 5 --out match

`carom schema arena` prints the JSON Schema of all messages. The page "The protocol of programs" of
carom's documentation explains them.
"""

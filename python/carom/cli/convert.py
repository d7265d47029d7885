"""``carom import``: shots of other engines."""

from __future__ import annotations

import json as js
from enum import StrEnum
from typing import Annotated

import typer

import carom
from carom.cli.output import emit, file_name, read_bytes, say
from carom.convert._fastfiz_log import LOG_WORDS
from carom.errors import InputError
from carom.files import refuse_other_encoding


class Format(StrEnum):
    """The engine that wrote the file."""

    POOLTOOL = "pooltool"
    FASTFIZ = "fastfiz"


def import_(
    file: Annotated[str, typer.Argument(metavar="FILE", help="The file; - is stdin.")],
    format_: Annotated[
        Format | None,
        typer.Option(
            "--format", help="The engine that wrote the file; default: recognised from the file."
        ),
    ] = None,
    strike: Annotated[
        str | None,
        typer.Option(
            metavar='"A B THETA PHI V"',
            help="The strike for a FastFiz table state, which has none: mm, mm, degrees, degrees, "
            "m/s.",
        ),
    ] = None,
    index: Annotated[
        int | None, typer.Option(min=0, help="Which state of a FastFiz log, from 0.")
    ] = None,
    all_: Annotated[
        bool,
        typer.Option("--all", help="Every state of a FastFiz log, a shot file on each line."),
    ] = False,
    tolerance: Annotated[
        float,
        typer.Option(metavar="M", help="Largest overlap of balls and cushions that is removed, m."),
    ] = 1e-4,
) -> None:
    """Print a pooltool system, a FastFiz table state or a state of its log as a shot file.

    Messages on stderr name what the shot file cannot hold.
    """
    if all_ and (index is not None or strike is not None):
        option = "--index" if index is not None else "--strike"
        raise InputError(
            "conflict", option, "--all takes every state with its shot", "leave it out"
        )
    data = read_bytes(file)
    refuse_other_encoding(data, file_name(file))
    try:
        if all_:
            log = carom.convert.fastfiz_log(_text(data), tolerance=tolerance)
        else:
            log = [_convert(data, format_, strike, (index, tolerance))]
    except InputError as error:
        # The converters have only the bytes of the file.
        if error.place:
            raise
        raise error.at(file_name(file)) from None
    # A sentence that holds for every state is printed once.
    for sentence in dict.fromkeys(sentence for made in log for sentence in made.left_out):
        say(sentence)
    for made in log:
        emit(js.dumps(made.shot.to_dict()) if all_ else made.shot.to_json())


def _convert(
    data: bytes,
    format_: Format | None,
    strike: str | None,
    options: tuple[int | None, float],
) -> carom.convert.Converted:
    index, tolerance = options
    if format_ is None:
        format_ = _recognised(data)
    if format_ is Format.POOLTOOL:
        if strike is not None:
            raise InputError(
                "conflict",
                "--strike",
                "a pooltool system has its own strike",
                "leave the option out",
            )
        if index is not None:
            raise InputError(
                "conflict", "--index", "a pooltool file has one system", "leave the option out"
            )
        return carom.convert.pooltool(data, tolerance=tolerance)
    given = None if strike is None else _numbers(strike)
    return carom.convert.fastfiz(_text(data), given, index=index or 0, tolerance=tolerance)


def _recognised(data: bytes) -> Format:
    """The engine that wrote the file.

    Raises:
        InputError: It is none that carom knows.
    """
    start = data.lstrip(b"\xef\xbb\xbf \t\r\n")[:64]
    # A table state begins with its number of balls, a line of a log with a word in capitals.
    word = start.split(maxsplit=1)[:1]
    if start[:1].isdigit() or (word and word[0].decode("latin-1") in LOG_WORDS):
        return Format.FASTFIZ
    # JSON, or MessagePack, whose first byte is that of a map.
    if start[:1] in (b"{", b"[", b"\xde", b"\xdf") or b"\x80" <= start[:1] <= b"\x8f":
        return Format.POOLTOOL
    raise InputError(
        "format",
        "",
        "the file is not one that carom imports",
        "give a system that pooltool saved, or a table state or a log of FastFiz (docs/import.md)",
    )


def _text(data: bytes) -> str:
    try:
        return data.decode("ascii")
    except UnicodeDecodeError:
        raise InputError(
            "format",
            "FILE",
            "not ASCII text, but a FastFiz table state is a list of numbers",
            "give --format pooltool if pooltool wrote it",
        ) from None


def _numbers(words: str) -> list[float]:
    try:
        return [float(word) for word in words.replace(",", " ").split()]
    except ValueError:
        raise InputError(
            "wrong-type",
            "--strike",
            f"{words!r} is not a list of numbers",
            "write five: A B THETA PHI V",
        ) from None

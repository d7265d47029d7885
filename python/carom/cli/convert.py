"""``carom import``: shots of other engines."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated

import typer

import carom
from carom.cli.output import emit, file_name, read_bytes, say
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
) -> None:
    """Print a pooltool system or a FastFiz table state as a shot file.

    Messages on stderr name what the shot file cannot hold.
    """
    data = read_bytes(file)
    refuse_other_encoding(data, file_name(file))
    try:
        made = _convert(data, format_, strike)
    except InputError as error:
        # The converters have only the bytes of the file.
        text = str(error)
        if not text.startswith("the file "):
            raise
        raise InputError(text.replace("the file", f"{file_name(file)}: the file", 1)) from None
    for sentence in made.left_out:
        say(sentence)
    emit(made.shot.to_json())


def _convert(data: bytes, format_: Format | None, strike: str | None) -> carom.convert.Converted:
    if format_ is None:
        # A table state begins with its number of balls; a system with a brace, or it is not text.
        format_ = Format.FASTFIZ if data.lstrip()[:1].isdigit() else Format.POOLTOOL
    if format_ is Format.POOLTOOL:
        if strike is not None:
            raise InputError("--strike: a pooltool system has its own strike; leave the option out")
        return carom.convert.pooltool(data)
    return carom.convert.fastfiz(_text(data), None if strike is None else _numbers(strike))


def _text(data: bytes) -> str:
    try:
        return data.decode("ascii")
    except UnicodeDecodeError:
        raise InputError(
            "FILE: not ASCII text, but a FastFiz table state is a list of numbers; "
            "give --format pooltool if pooltool wrote it"
        ) from None


def _numbers(words: str) -> list[float]:
    try:
        return [float(word) for word in words.replace(",", " ").split()]
    except ValueError:
        raise InputError(
            f"--strike: {words!r} is not a list of numbers; write five: A B THETA PHI V"
        ) from None

"""``carom arena bridge``: a FastFiz client plays a match."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

import carom
from carom.arena.bridge import PORT, Bridge
from carom.arena.named_players import named_player
from carom.cli.options import Json, NoiseName, named_noise
from carom.cli.output import emit_answer, keep_sockets, say
from carom.convert._fastfiz_game import TABLE


def bridge(
    opponent: Annotated[
        str, typer.Argument(metavar="PLAYER", help="The other player, as for carom match.")
    ],
    out: Annotated[Path, typer.Option("--out", metavar="DIR", help="Folder for the match.")],
    port: Annotated[
        int, typer.Option(min=0, max=65535, help="Port on this machine; 0 chooses a free one.")
    ] = PORT,
    pairs: Annotated[int, typer.Option(min=1, help="Number of pairs of frames.")] = 10,
    noise: NoiseName = "olympiad",
    clock: Annotated[
        float, typer.Option(metavar="SECONDS", help="Time of a frame and player.")
    ] = 600.0,
    secret: Annotated[
        str | None,
        typer.Option(
            metavar="DIGITS",
            help="64 hexadecimal digits that determine racks and errors, to repeat a match.",
        ),
    ] = None,
    json: Json = False,
) -> None:
    """Let a client of FastFiz's tournament server play eight-ball against a player of carom.

    The command prints the endpoint for the client on stderr, and the match begins when the client
    has registered.
    """
    keep_sockets()
    errors = named_noise(noise)
    rival = named_player("PLAYER", opponent)
    with Bridge(port) as server:
        say(f"waiting for a client at {server.url}")
        say(f"{server.wait_for_client()} has registered; the match begins")
        result = carom.play_match(
            server,
            rival,
            table=TABLE,
            out=out,
            pairs=pairs,
            noise=errors,
            clock=clock,
            secret=secret,
            progress=sys.stderr.isatty(),
        )
    emit_answer(result, json=json)

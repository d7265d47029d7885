"""``carom think``: the best plays of a position."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated

import typer

from carom import Frame, Noise, Perception, Player, Shot, _core
from carom.cli.options import (
    NOISES,
    Cling,
    Draws,
    Json,
    LearnedTable,
    Png,
    Seed,
    Sight,
    Svg,
    draw,
    learned_of,
    named_noise,
    noise_of,
    title_of,
)
from carom.cli.output import emit_answer, file_name, format_of, read
from carom.errors import InputError
from carom.lazy import LazyModule
from carom.plan.drawn_tables import on_learned_table

if TYPE_CHECKING:
    from pathlib import Path

    from carom.picture import plays as plays_picture
    from carom.plan import TablePosterior
else:
    # Matplotlib takes half a second to load.
    plays_picture = LazyModule("carom.picture.plays")


def think(
    file: Annotated[
        str,
        typer.Argument(
            metavar="FILE", help="A shot file, or the record of a frame (Frame.record); - is stdin."
        ),
    ],
    game: Annotated[
        str | None,
        typer.Option(
            help="The game, for a shot file; the shot's strike is not used. A record has its game."
        ),
    ] = None,
    player: Annotated[
        str, typer.Option(metavar="NAME", help="The player, such as carom or carom:2000.")
    ] = "carom",
    noise: Annotated[
        str | None,
        typer.Option(
            metavar="NAME",
            help=f"{NOISES} Default: that of a level, else olympiad.",
        ),
    ] = None,
    opponent_noise: Annotated[
        str | None,
        typer.Option(
            metavar="NAME", help="The opponent's noise, as --noise; default: that of the player."
        ),
    ] = None,
    cling: Cling = 0.0,
    perception: Sight = 0.0,
    simulations: Annotated[
        int | None,
        typer.Option(
            metavar="N",
            help="Largest number of simulated shots; default: 20000, or no limit with --time or "
            "--rounds.",
        ),
    ] = None,
    time: Annotated[
        float | None,
        typer.Option(
            metavar="SECONDS",
            help="No round of the search begins that would probably end later.",
        ),
    ] = None,
    rounds: Annotated[
        int | None,
        typer.Option(metavar="N", help="Largest number of rounds; repeats a search with --time."),
    ] = None,
    plays: Annotated[int, typer.Option(min=1, help="Largest number of plays printed.")] = 5,
    learned: LearnedTable = None,
    draws: Draws = 32,
    seed: Seed = 0,
    threads: Annotated[
        int | None, typer.Option(min=1, help="Number of threads; default: one per core.")
    ] = None,
    json: Json = False,
    svg: Svg = None,
    png: Png = None,
) -> None:
    """Print the best plays of a position, with the chances of winning.

    If the frame requests a choice, print the best choice. Ctrl-C ends the search after its present
    round; the result so far is printed.
    """
    posterior = learned_of(learned)
    frame = _frame(read(file), file_name(file), game, posterior)
    thinker = Player(
        player,
        noise=None if noise is None else named_noise(noise),
        perception=Perception(perception),
        simulations=simulations,
        time=time,
        rounds=rounds,
        seed=seed,
        threads=threads,
    )
    own = replace(thinker.noise, cling_probability=cling) if cling else thinker.noise
    opponent = None if opponent_noise is None else _opponent(opponent_noise, cling)
    if frame.request.kind == "choice":
        _refuse_picture(svg, png)
        decision = thinker.choose(frame, noise=own, opponent_noise=opponent)
        emit_answer(decision, json=json)
        return
    analysis = thinker.explain(
        frame, plays, noise=own, opponent_noise=opponent, posterior=posterior, draws=draws
    )
    title = frame.game if file == "-" else title_of(file)
    # The answer first: it is not lost if the picture cannot be written.
    emit_answer(analysis, json=json)
    draw(lambda: plays_picture.draw(analysis, title=title), svg=svg, png=png)


def _opponent(name: str, cling: float) -> Noise:
    try:
        return noise_of(name, cling)
    except InputError as error:
        raise error.inside("--opponent-noise", ": ") from None


def _frame(text: str, name: str, game: str | None, posterior: TablePosterior | None) -> Frame:
    """The frame of a record, or the frame of the game that begins with the balls of a shot file.

    The latter is on the learned table, if there is one.
    """
    file = _core.read_json(text, name)
    kind = format_of(file)
    if kind.startswith("carom-frame"):
        if game is not None:
            raise InputError(
                "conflict", "--game", "the record of a frame has its game", "leave the option out"
            )
        return Frame.replay(file)
    if not kind.startswith("carom-shot"):
        raise InputError(
            "format",
            f"{name}: format",
            f"found {file.get('format')!r}",
            "give a shot (carom-shot/1) or the record of a frame (carom-frame/1)",
        )
    shot = Shot.from_dict(file)
    if game is None:
        raise InputError(
            "missing", "--game", "a shot file has no game", "give one, such as --game eight-ball"
        )
    return Frame.of_shot(game, shot if posterior is None else on_learned_table(shot, posterior))


def _refuse_picture(svg: Path | None, png: Path | None) -> None:
    for option, path in (("--svg", svg), ("--png", png)):
        if path is not None:
            raise InputError(
                "wrong-state",
                option,
                "the frame requests a choice, and there is no play to draw",
                "leave the option out",
            )

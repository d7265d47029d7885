"""``carom arena``: programs that play against each other, and tools for their authors."""

from __future__ import annotations

import typer

from carom.cli import (
    arena_bridge,
    arena_check,
    arena_ladder,
    arena_new,
    arena_ratings,
    arena_report,
    arena_run,
)

arena = typer.Typer(
    help="Programs that play, tournaments, their ratings and reports, and checks of programs.",
    no_args_is_help=True,
)
arena.command("run")(arena_run.run)
arena.command("ratings")(arena_ratings.ratings)
arena.command("ladder")(arena_ladder.ladder)
arena.command("bridge")(arena_bridge.bridge)
arena.command("report")(arena_report.report)
arena.command("check")(arena_check.check)
arena.command("new")(arena_new.new)

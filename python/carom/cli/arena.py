"""``carom arena``: programs that play against each other."""

from __future__ import annotations

import typer

from carom.cli import arena_bridge, arena_ladder, arena_ratings, arena_report, arena_run

arena = typer.Typer(
    help="Programs that play, tournaments, their ratings and reports.", no_args_is_help=True
)
arena.command("run")(arena_run.run)
arena.command("ratings")(arena_ratings.ratings)
arena.command("ladder")(arena_ladder.ladder)
arena.command("bridge")(arena_bridge.bridge)
arena.command("report")(arena_report.report)

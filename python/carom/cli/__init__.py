"""The command ``carom``: data to stdout, talk to stderr; exit 0, 2 (bad input), 1 (our bug)."""

from carom.cli.main import main

__all__ = ["main"]

"""The command ``carom``: data to stdout, talk to stderr; exit 0, 2 (bad input), 1 (our bug)."""

from __future__ import annotations

import sys
from typing import NoReturn

# What a shell says of a program that Ctrl-C ended: 128 and the signal's number.
INTERRUPTED = 130


def main() -> NoReturn:
    """Run the command line and exit the process."""
    try:
        # Here, so that Ctrl-C is heard while the rest is imported.
        from carom.cli.main import run
    except KeyboardInterrupt:
        sys.exit(INTERRUPTED)
    run()


__all__ = ["main"]

"""The command ``carom``: data to stdout, messages to stderr; exit 0, 2 (bad input), 1 (our bug)."""

from __future__ import annotations

import sys
from typing import NoReturn

# The exit code of a program that Ctrl-C ended: 128 plus the signal's number.
INTERRUPTED = 130


def main() -> NoReturn:
    """Run the command line and exit the process."""
    try:
        # Imported here, so that Ctrl-C is handled while the rest is imported.
        from carom.cli.main import run
    except KeyboardInterrupt:
        sys.exit(INTERRUPTED)
    run()


__all__ = ["main"]

"""The directive ``carom-help``: the command's help text, taken when the page is built."""

import os
import subprocess
import sys

from docutils import nodes
from docutils.parsers.rst import Directive

# Narrow enough for the page, and the same on every machine.
PLAIN = {"NO_COLOR": "1", "COLUMNS": "88", "TERMINAL_WIDTH": "88"}


class CaromHelp(Directive):
    """``carom ARGUMENTS --help``, as a block."""

    optional_arguments = 1
    final_argument_whitespace = True

    def run(self) -> list[nodes.Node]:
        words = self.arguments[0].split() if self.arguments else []
        output = subprocess.run(
            [sys.executable, "-m", "carom", *words, "--help"],
            check=True,
            capture_output=True,
            text=True,
            env=os.environ | PLAIN,
        ).stdout
        text = output.replace("python -m carom", "carom").strip("\n")
        return [nodes.literal_block(text, text, language="text")]


def setup(app):
    app.add_directive("carom-help", CaromHelp)
    return {"parallel_read_safe": True, "parallel_write_safe": True}

"""Old spellings on the command line: each still works, and one line on stderr names the new one."""

from __future__ import annotations

from typing import Any, ClassVar

from typer.core import TyperCommand, TyperGroup

from carom.cli.output import say


def warn(old: str, new: str) -> None:
    """Print to stderr that ``old`` is now called ``new``."""
    say(f"{old} is now {new}; the old spelling still works")


def command(**flags: str) -> type[TyperCommand]:
    """A command that accepts old flags, for ``app.command(..., cls=command(angle="angle-deg"))``.

    Args:
        flags: ``old="new"``, both without the leading dashes; ``_`` in an old name stands for
            ``-``.
    """
    renamed = {f"--{old.replace('_', '-')}": f"--{new}" for old, new in flags.items()}

    class Command(TyperCommand):
        def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
            return super().parse_args(ctx, _modern(args, renamed))

    return Command


def group(**commands: str) -> type[TyperGroup]:
    """A group that accepts old names of its commands, given as ``old="new"``."""

    class Group(TyperGroup):
        renamed: ClassVar[dict[str, str]] = commands

        def get_command(self, ctx: Any, cmd_name: str) -> Any:
            new = self.renamed.get(cmd_name)
            if new is not None:
                warn(f"carom {ctx.info_name} {cmd_name}", f"carom {ctx.info_name} {new}")
            return super().get_command(ctx, new or cmd_name)

    return Group


def _modern(args: list[str], renamed: dict[str, str]) -> list[str]:
    """The arguments with every old flag replaced; arguments after ``--`` are not flags."""
    end = args.index("--") if "--" in args else len(args)
    found = []
    for arg in args[:end]:
        old, equals, value = arg.partition("=")
        if old in renamed:
            warn(old, renamed[old])
        found.append(renamed.get(old, old) + equals + value)
    return found + args[end:]

"""The commands, and the exit codes of their errors."""

from __future__ import annotations

import io
import os
import platform
import signal
import sys
import traceback
import warnings
from typing import NoReturn

import typer

from carom import __version__
from carom.cli import (
    INTERRUPTED,
    arena,
    convert,
    diagram,
    drills,
    engine,
    learn,
    match,
    plan,
    play,
    reference,
    renamed,
    shots,
    study,
    sweep,
    think,
)
from carom.cli.output import emit, say, say_json
from carom.errors import EventCapError, InputError, PageError
from carom.files import shown
from carom.installed import build_info
from carom.streams import STDOUT, whole

# The engine's own cap, which no shot should reach. A lower cap was set by the user.
DEFAULT_EVENT_CAP = 100_000

app = typer.Typer(
    name="carom",
    help="The billiards engine: exact, deterministic, and fast enough to think with.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)
app.command("shot")(shots.shot)
app.command("break")(shots.break_)
app.command("play")(play.play)
app.command("evaluate")(plan.evaluate)
app.command("solve", cls=renamed.command(elevation="elevation-deg", of_a_way="per-route"))(
    plan.solve
)
app.command("think")(think.think)
app.command("diagram")(diagram.diagram)
app.add_typer(study.study, name="study")
app.command("drill")(drills.drill)
app.command("puzzle")(drills.puzzle_command)
app.command("match")(match.match)
app.add_typer(arena.arena, name="arena")
app.add_typer(plan.maps, name="map")
app.add_typer(plan.stats, name="stats")
app.command("sweep")(sweep.sweep)
app.add_typer(learn.learn, name="learn")
app.command("replay")(engine.replay)
app.command("validate")(engine.validate)
app.command("bench")(engine.bench)
app.command("import")(convert.import_)
app.command("tables")(reference.tables)
app.command("physics")(reference.physics)
app.command("schema")(reference.schema)


@app.callback(invoke_without_command=True)
def _options(
    context: typer.Context,
    version: bool = typer.Option(False, "--version", help="Print the version."),
    verbose: bool = typer.Option(
        False, "--verbose", help="With --version: also of the results, and how carom was built."
    ),
) -> None:
    if version:
        emit(_described() if verbose else f"carom {__version__}")
        raise typer.Exit
    if verbose:
        raise typer.BadParameter("it needs --version; write carom --version --verbose", context)
    if context.invoked_subcommand is None:
        context.fail("Missing command.")


def _described() -> str:
    """What ``carom.build_info`` says, a line for each fact."""
    info = build_info()
    facts = {
        "results": f"version {info['results']}",
        "commit": info["commit"] or "not recorded",
        "features": ", ".join(info["features"]),
        "vectors": info["vectors"],
        "page": "included" if info["page"] else "not built",
        "extras": ", ".join(info["extras"]) or "none",
        "python": platform.python_version(),
    }
    width = max(map(len, facts))
    return "\n".join([info["engine"], *(f"  {key:{width}}  {facts[key]}" for key in facts)])


def run() -> NoReturn:
    """Run the command line and exit the process."""
    if hasattr(signal, "SIGPIPE"):
        # `carom shot ... | head` ends quietly, like every filter.
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    for stream in (sys.stdout, sys.stderr):
        # A terminal that cannot print → prints ? instead of failing.
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")
    if sys.stdout is not None:
        sys.stdout = whole(sys.stdout, STDOUT)
    warnings.showwarning = _show_warning
    sys.exit(_run())


def _show_warning(message: Warning | str, *_where: object, **_more: object) -> None:
    """Print a warning as a sentence. Where in carom's code it arose is of no use to its reader."""
    say(str(message))


def _run() -> int:
    try:
        code = _call()
        if sys.stdout is not None:
            # Help texts are printed without a flush.
            sys.stdout.flush()
    except (InputError, PageError) as error:
        say(str(error))
        return 2
    except EventCapError as error:
        say(str(error))
        say_json(error.shot)
        return 2 if error.shot.get("max_events", DEFAULT_EVENT_CAP) < DEFAULT_EVENT_CAP else 1
    except OSError as error:
        if error.errno is None:
            return _our_bug()
        if error.filename == STDOUT:
            say(f"{STDOUT}: {error.strerror}; check where the output is redirected")
            # Otherwise Python would write the rest again at exit, and fail with code 120.
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        elif error.filename:
            say(f"{shown(error.filename)}: {error.strerror}; check the path")
        else:
            say(f"the system reports: {error.strerror}; check its disks, network and limits")
        return 2
    except KeyboardInterrupt:
        return INTERRUPTED
    except BaseException:  # noqa: BLE001 -- a panic in Rust is not an Exception
        return _our_bug()
    return code


def _call() -> int:
    try:
        app(standalone_mode=True)
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else 0
    return 0


def _our_bug() -> int:
    say("this is a bug in carom, not in your input; please report it with the lines below and with")
    say(f"the shot file to the project's issues (carom {__version__}).")
    traceback.print_exc()
    return 1

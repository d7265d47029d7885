"""Progress bars on stderr."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from typing import TYPE_CHECKING

from carom.lazy import LazyModule
from carom.threads import startable

if TYPE_CHECKING:
    import rich.console as rich_console
    import rich.progress as rich_progress
else:
    rich_console = LazyModule("rich.console")
    rich_progress = LazyModule("rich.progress")


@contextmanager
def progress_bar(
    count: int, *, show: bool, what: str = "shots"
) -> Iterator[Callable[[int], object]]:
    """A bar on stderr.

    Args:
        count: Number of items.
        show: Whether there is a bar at all.
        what: The items' name, in the plural.

    Yields:
        A function that adds to the number of items done.
    """
    if not show:
        yield lambda _: None
        return
    # The bar moves in a thread of its own, or else whenever items are done.
    has_thread = startable(1) == 1
    with rich_progress.Progress(
        rich_progress.TextColumn(what),
        rich_progress.BarColumn(),
        rich_progress.MofNCompleteColumn(),
        rich_progress.TimeRemainingColumn(),
        console=rich_console.Console(stderr=True),
        auto_refresh=has_thread,
    ) as bar:
        task = bar.add_task(what, total=count)
        yield lambda done: bar.update(task, advance=done, refresh=not has_thread)


@contextmanager
def stage_bars(names: Sequence[str], *, show: bool) -> Iterator[Callable[[int, int, int], None]]:
    """A bar on stderr for each stage of a task in Rust.

    Args:
        names: What each stage works on.
        show: Whether there are bars at all.

    Yields:
        A function of the stage's number, of the items done in it, and of all its items.
    """
    with ExitStack() as bars:
        stage_now, done_before = -1, 0

        def nothing(_: int) -> object:
            return None

        advance: Callable[[int], object] = nothing

        def report(stage: int, done: int, count: int) -> None:
            nonlocal stage_now, done_before, advance
            if not show:
                return
            if stage != stage_now:
                bars.close()
                bar = progress_bar(count, show=True, what=names[stage])
                stage_now, done_before, advance = stage, 0, bars.enter_context(bar)
            advance(done - done_before)
            done_before = done

        yield report

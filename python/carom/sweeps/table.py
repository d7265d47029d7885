"""A sweep: a table of shots whose rows are functions of its spec and the row's number."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Self

from carom import _core
from carom.arguments import cores, instance, truth, whole
from carom.arguments import text as checked_text
from carom.errors import InputError
from carom.files import checked_path, read_text, shown
from carom.lazy import pa
from carom.shot import Shot
from carom.sweeps import on_ray
from carom.sweeps.parts import play_rows
from carom.sweeps.play import RowPlayer
from carom.sweeps.run import run
from carom.sweeps.spec import Spec, load

if TYPE_CHECKING:
    from carom.sweeps.report import Report

# Largest number of rows in memory at once: at about a hundred bytes a row, ten gigabytes. A typing
# error in a spec would otherwise fill the memory; a folder takes any number of rows.
MOST_ROWS_IN_MEMORY = 10**8


class Sweep:
    """A table of shots: parameters and outcomes.

    Row i is a function of the spec and of i alone. It has the same bits for any number of threads,
    on any machine, in parts of any size, and in any order of the rows.
    """

    __slots__ = ("_player", "spec")
    spec: Spec

    def __init__(self, spec: Spec) -> None:
        self.spec = instance("spec", spec, Spec, "Sweep.from_dict({...}).spec")
        self._player = RowPlayer(spec)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read a spec file, ``carom-sweep/1``.

        Paths of shot files in the spec are relative to the folder of the spec.

        Raises:
            OSError: A file cannot be read.
            InputError: The spec is invalid; the message names the place.
        """
        place = checked_path("path", path, "sweep.json")
        return cls._read(read_text(place), shown(place), place.parent)

    @classmethod
    def from_json(cls, text: str, *, folder: str | os.PathLike[str] = ".") -> Self:
        """Read a spec from JSON text.

        Paths of shot files in the spec are relative to ``folder``.

        Raises:
            OSError: A file cannot be read.
            InputError: The spec is invalid; the message names the place.
        """
        return cls._read(checked_text("text", text), None, folder)

    @classmethod
    def _read(cls, text: str, file: str | None, folder: str | os.PathLike[str]) -> Self:
        """Read a spec from JSON text; the error of a syntax fault names the file of the text."""
        return cls.from_dict(_core.read_json(text, file), folder=folder)

    @classmethod
    def from_dict(cls, spec: Mapping[str, Any], *, folder: str | os.PathLike[str] = ".") -> Self:
        """Read a spec from a dict with the file's keys; ``shots`` may also hold ``carom.Shot``.

        Raises:
            OSError: A file cannot be read.
            InputError: The spec is invalid; the message names the place.
        """
        return cls(load(spec, checked_path("folder", folder, "specs")))

    def to_dict(self) -> dict[str, Any]:
        """The complete spec: shots in full, every default written out."""
        return dict(self.spec.file)

    def to_json(self) -> str:
        """The complete spec as JSON text."""
        return self.spec.to_json()

    @property
    def sha256(self) -> str:
        """Hash of ``to_dict()``; it identifies the table."""
        return self.spec.sha256

    def __len__(self) -> int:
        return self.spec.rows

    @property
    def schema(self) -> pa.Schema:
        """The table's columns; the metadata of each describes it."""
        return self._player.schema

    def parameters(self, start: int = 0, stop: int | None = None) -> pa.RecordBatch:
        """The parameters of the rows from ``start`` up to ``stop``, without outcomes.

        Raises:
            InputError: The sweep has no such rows, or they do not fit into memory.
        """
        return self._player.parameters(*self._range(start, stop))

    def play(self, batch: pa.RecordBatch) -> pa.RecordBatch:
        """Simulate rows of parameters; return the same rows with their outcomes.

        This is a pure function. It computes every row of every sweep, here and on a cluster.

        Raises:
            InputError: ``batch`` is not a batch of rows as ``parameters`` returns it.
        """
        return self._player.play(batch)

    def table(
        self,
        start: int = 0,
        stop: int | None = None,
        *,
        threads: int | None = None,
        device: str = "cpu",
    ) -> pa.Table:
        """The rows from ``start`` up to ``stop``, in memory. Ctrl-C stops it.

        Raises:
            InputError: The sweep has no such rows, or they do not fit into memory; or ``device``
                cannot be used.
        """
        return play_rows(self._player.on(device), *self._range(start, stop), threads=cores(threads))

    def shot(self, row: int) -> Shot:
        """The shot of one row, to look at or to simulate with a trace.

        With noise its strike is the one after the noise. It simulates to the bits of the row.

        Raises:
            InputError: The sweep has no such row, or the row cannot be simulated.
        """
        return Shot._wrap(self._player.shot(whole("row", row, len(self))))

    def run(
        self,
        out: str | os.PathLike[str],
        *,
        threads: int | None = None,
        part_rows: int | None = None,
        ray: bool | str = False,
        device: str = "cpu",
        progress: bool = False,
    ) -> Report:
        """Write the whole table into a folder as Parquet; continue where an earlier run stopped.

        Parts that the folder already holds are compared with their checksums first.

        Args:
            out: The folder. It is created if it does not exist.
            threads: Number of threads; None means one per core. Results do not depend on it.
            part_rows: Rows of one file; None chooses a number that depends on the sweep only.
            ray: Simulate on Ray: True starts Ray on this machine, an address joins a running
                cluster. All machines of a cluster must see the folder.
            device: ``"cpu"``, ``"cuda"`` or ``"cuda:1"``; see ``carom.device``. On Ray each task
                has a card of its own, which is ``"cuda"`` there. Columns of contacts need
                ``"cpu"``.
            progress: Show a progress bar on stderr.

        Raises:
            InputError: The folder holds another sweep, a sweep of another version of carom or a
                damaged part; no row can be simulated; or ``device`` cannot be used.
        """
        if not isinstance(ray, str):
            ray = truth("ray", ray)
        return run(
            self._player.on(device),
            checked_path("out", out, "out"),
            threads=threads,
            part_rows=part_rows,
            ray=ray,
            progress=truth("progress", progress),
        )

    def dataset(self) -> Any:
        """The table as a ``ray.data.Dataset``, in order; rows are simulated when they are read."""
        return on_ray.dataset(self._player)

    def _range(self, start: int, stop: int | None) -> tuple[int, int]:
        rows = len(self)
        end = rows if stop is None else whole("stop", stop, rows + 1)
        start = whole("start", start, rows + 1)
        if start > end:
            raise InputError(
                "out-of-range", "start", f"{start} is greater than stop, {end}", "give start ≤ stop"
            )
        if end - start > MOST_ROWS_IN_MEMORY:
            raise InputError(
                "out-of-range",
                "stop",
                f"rows {start} to {end} are too many for memory",
                f"take at most {MOST_ROWS_IN_MEMORY} rows at once, or write them to a folder with "
                "Sweep.run",
            )
        return start, end

    def __reduce__(self) -> tuple[Any, tuple[dict[str, Any]]]:
        return (Sweep.from_dict, (self.spec.file,))

    def __repr__(self) -> str:
        return f"<carom.Sweep: {len(self)} rows, {self.sha256[:12]}>"


def sweep(
    spec: Sweep | Mapping[str, Any] | str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    threads: int | None = None,
    part_rows: int | None = None,
    ray: bool | str = False,
    device: str = "cpu",
    progress: bool = False,
) -> Report:
    """Simulate a sweep into a folder: ``Sweep.run`` of a sweep, a spec or a spec file's path."""
    found = _sweep_of(spec)
    return found.run(
        out, threads=threads, part_rows=part_rows, ray=ray, device=device, progress=progress
    )


def _sweep_of(spec: Any) -> Sweep:
    if isinstance(spec, Sweep):
        return spec
    if isinstance(spec, Mapping):
        return Sweep.from_dict(spec)
    if isinstance(spec, str | os.PathLike):
        return Sweep.load(spec)
    found = type(spec).__name__
    raise InputError(
        "wrong-type", "spec", f"found a {found}", "give a Sweep, a dict, or the path of a file"
    )

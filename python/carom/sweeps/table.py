"""A sweep: a table of shots whose rows are functions of its spec and their number."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

from carom.arguments import cores, whole
from carom.errors import InputError
from carom.shot import read_text

if TYPE_CHECKING:
    import pyarrow as pa

    from carom.shot import Shot
    from carom.sweeps.report import Report
    from carom.sweeps.spec import Spec

# All else of the package is imported where it is needed: `import carom` shall be quick.


class Sweep:
    """A table of shots: parameters, and what comes of them.

    Row i is a function of the spec and of i alone: the same bits whatever the threads, the machine,
    the parts, or the order in which rows are played.
    """

    __slots__ = ("_player", "spec")
    spec: Spec

    def __init__(self, spec: Spec) -> None:
        from carom.sweeps.play import Player

        self.spec = spec
        self._player = Player(spec)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read a spec, ``carom-sweep/1``. Names of shot files start from its folder.

        Raises:
            OSError: A file cannot be read.
            InputError: It is no valid spec; the message names the place.
        """
        return cls.from_json(read_text(path), folder=Path(path).parent)

    @classmethod
    def from_json(cls, text: str, *, folder: str | os.PathLike[str] = ".") -> Self:
        """Read a spec from JSON text. Names of shot files start from ``folder``.

        Raises:
            OSError: A file cannot be read.
            InputError: It is no valid spec.
        """
        from carom.sweeps.read import parse

        return cls.from_dict(parse(text), folder=folder)

    @classmethod
    def from_dict(cls, spec: Mapping[str, Any], *, folder: str | os.PathLike[str] = ".") -> Self:
        """Read a spec from a dict as the file has it; ``shots`` may hold ``carom.Shot`` as well.

        Raises:
            OSError: A file cannot be read.
            InputError: It is no valid spec.
        """
        from carom.sweeps.spec import load

        return cls(load(spec, Path(folder)))

    def to_dict(self) -> dict[str, Any]:
        """The spec with everything that it is made of: shots in full, nothing left to defaults."""
        return dict(self.spec.file)

    def to_json(self) -> str:
        """The same as text."""
        return json.dumps(self.spec.file, ensure_ascii=False)

    @property
    def sha256(self) -> str:
        """Hash of ``to_dict()``: it names the table."""
        return self.spec.sha256

    def __len__(self) -> int:
        return self.spec.rows

    @property
    def schema(self) -> pa.Schema:
        """Columns of the table, with what they are in their metadata."""
        return self._player.schema

    def parameters(self, start: int = 0, stop: int | None = None) -> pa.RecordBatch:
        """Rows ``start`` up to ``stop``, parameters only.

        Raises:
            InputError: There are no such rows.
        """
        return self._player.parameters(*self._range(start, stop))

    def play(self, batch: pa.RecordBatch) -> pa.RecordBatch:
        """What comes of rows of parameters: the same rows with their outcomes.

        A pure function, by which every row of every sweep is made, here and on a cluster.
        """
        return self._player.play(batch)

    def table(
        self, start: int = 0, stop: int | None = None, *, threads: int | None = None
    ) -> pa.Table:
        """Rows ``start`` up to ``stop``, in memory.

        Raises:
            InputError: There are no such rows.
        """
        from carom.sweeps.parts import play_rows

        return play_rows(self, *self._range(start, stop), threads=cores(threads))

    def shot(self, row: int) -> Shot:
        """The shot that a row is, to be looked at or simulated with a trace.

        With noise its strike is the one that came out. Its angles are the degrees that a file can
        hold, which moves some by one rounding.

        Raises:
            InputError: There is no such row, or it cannot be played.
        """
        from carom.shot import Shot

        self._range(row, row + 1)
        return Shot._wrap(self._player.shot(row))

    def run(
        self,
        out: str | os.PathLike[str],
        *,
        threads: int | None = None,
        part_rows: int | None = None,
        ray: bool | str = False,
        progress: bool = False,
    ) -> Report:
        """Write the whole table into a folder, as Parquet; go on where an earlier call has ended.

        Args:
            out: The folder; made if it is not there.
            threads: How many; None is one per core. Results do not depend on it.
            part_rows: Rows of a file; None is a number that depends on the sweep alone.
            ray: Play on Ray: True starts it here, an address joins a running cluster, whose
                machines must all see the folder.
            progress: Show a progress bar on stderr.

        Raises:
            InputError: The folder has another sweep in it, or one of another version, or no row
                can be played.
        """
        from carom.sweeps.run import run

        return run(
            self, Path(out), threads=threads, part_rows=part_rows, ray=ray, progress=progress
        )

    def dataset(self) -> Any:
        """The table as a ``ray.data.Dataset``, in order, played when it is read."""
        from carom.sweeps.on_ray import dataset

        return dataset(self)

    def _range(self, start: int, stop: int | None) -> tuple[int, int]:
        end = len(self) if stop is None else whole("stop", stop)
        start = whole("start", start)
        if not 0 <= start <= end <= len(self):
            raise InputError(f"rows {start} to {end}: the sweep has rows 0 to {len(self)}")
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
    progress: bool = False,
) -> Report:
    """Play a sweep into a folder: ``Sweep.run`` of a spec, or of its file's name."""
    found = _sweep_of(spec)
    return found.run(out, threads=threads, part_rows=part_rows, ray=ray, progress=progress)


def _sweep_of(spec: Any) -> Sweep:
    if isinstance(spec, Sweep):
        return spec
    if isinstance(spec, Mapping):
        return Sweep.from_dict(spec)
    if isinstance(spec, str | os.PathLike):
        return Sweep.load(spec)
    found = type(spec).__name__
    raise InputError(f"spec: found a {found}; give a Sweep, a dict, or the name of a file")

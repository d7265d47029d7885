"""Rows of a sweep: their parameters, computed from the row number, and their outcomes."""

from __future__ import annotations

import math
from copy import copy
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeAlias

from carom import _core
from carom.device import opened
from carom.errors import InputError
from carom.lazy import np, pa
from carom.sweeps import spec as specs
from carom.sweeps.columns import OUTCOMES, PER_BALL, PLAYED, REFEREE
from carom.sweeps.spec import Draw, Grid, Parameter, Spec

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from carom.noise import Noise

    Indices: TypeAlias = NDArray[np.int64]

# Rows per call into Rust; Python sees Ctrl-C between two calls. A few tens of milliseconds.
CHUNK = 16_384
# Rows, spread over the whole sweep, that are tried before a run begins.
PROBES = 64


@dataclass(frozen=True, slots=True)
class RowArguments:
    """The parameters of rows in the form that Rust reads, by attribute.

    Attributes:
        layouts: All layouts.
        layout: The index of each row's layout, shape (n,).
        columns: Paths, each with numbers or with choices and indices.
        strike: Keys of a strike, each with numbers of shape (n,).
        noise: The execution noise, if any.
        seed: Seed of the noise.
        noise_index: The index of each row's noise, shape (n,).
    """

    layouts: list[_core.Shot]
    layout: NDArray[np.int32]
    columns: list[tuple[str, Any]]
    strike: list[tuple[str, NDArray[np.float64]]]
    noise: Noise | None
    seed: int
    noise_index: Indices


class RowPlayer:
    """Computes and simulates the rows of a spec."""

    # Where the rows are simulated.
    device = "cpu"

    def __init__(self, spec: Spec) -> None:
        self.spec = spec
        self.balls = spec.balls
        self.layouts = [shot._core for shot in spec.layouts]
        self.ids = list(dict.fromkeys(ball for shot in spec.layouts for ball in shot.ids))
        # Index into `ids` for each layout and ball; −1 where the layout has fewer balls.
        self.id_of = np.full((len(spec.layouts), self.balls), -1, dtype=np.int16)
        for row, shot in zip(self.id_of, spec.layouts, strict=True):
            row[: len(shot.ids)] = [self.ids.index(ball) for ball in shot.ids]
        # The layouts' own strikes, with angles in degrees.
        files = [shot.to_dict().get("strike", {}) for shot in spec.layouts]
        self.own = np.array([_own_strike(strike) for strike in files])
        self.parameter_schema = pa.schema(self._parameter_fields())
        self.schema = pa.schema([*self._parameter_fields(), *self._outcome_fields()])

    def on(self, device: str) -> RowPlayer:
        """The same rows, simulated on ``device``.

        Raises:
            InputError: The device cannot be used, or a column needs more than it computes.
        """
        if device == "cpu":
            return self
        needed = [column for column in self.spec.columns if column in REFEREE]
        if needed:
            raise InputError(
                "unsupported",
                "device",
                f"a device does not compute the columns {', '.join(needed)}",
                'leave them out of the sweep\'s columns, or use device="cpu"',
            )
        # Open it before anything is written.
        opened(device)
        player = copy(self)
        player.device = device
        return player

    def parameters(self, start: int, stop: int) -> pa.RecordBatch:
        """The numbers and parameters of the rows from ``start`` up to ``stop``."""
        spec = self.spec
        row = np.arange(start, stop, dtype=np.int64)
        point, variant = np.divmod(row, spec.variants)
        cell, sample = np.divmod(point, spec.samples)
        columns: dict[str, pa.Array] = {}
        for grid in reversed(spec.grids):
            cell, step = np.divmod(cell, grid.count)
            columns[grid.name] = self._grid_column(grid, step)
        columns |= self._drawn_columns(sample if spec.paired else point)
        columns |= {
            "row": pa.array(row),
            "layout": pa.array(cell.astype(np.int32)),
            "sample": pa.array(sample),
            "variant": pa.array(variant),
        }
        arrays = [columns[name] for name in self.parameter_schema.names]
        return pa.RecordBatch.from_arrays(arrays, schema=self.parameter_schema)

    def play(self, batch: pa.RecordBatch) -> pa.RecordBatch:
        """The rows of ``batch`` with their outcomes.

        Raises:
            InputError: ``batch`` has other columns than ``parameters`` returns.
        """
        if not isinstance(batch, pa.RecordBatch):
            kind = type(batch).__name__
            remedy = "give a pyarrow.RecordBatch, for example sweep.parameters(0, 10)"
            raise InputError("wrong-type", "batch", f"found a {kind}", remedy)
        batch = self._checked(batch)
        if len(batch) <= CHUNK:
            return self._play(batch)
        pieces = [self._play(batch.slice(start, CHUNK)) for start in range(0, len(batch), CHUNK)]
        (whole,) = pa.Table.from_batches(pieces).combine_chunks().to_batches()
        return whole

    def _play(self, batch: pa.RecordBatch) -> pa.RecordBatch:
        rows = self._rows(batch)
        with_referee = not set(REFEREE).isdisjoint(self.spec.columns)
        found = _core.play_rows(rows, self.balls, with_referee, opened(self.device))
        return self._with_outcomes(batch, _numpy(batch["layout"]), found)

    def shot(self, row: int) -> _core.Shot:
        """The shot of a row.

        Raises:
            InputError: It cannot be simulated.
        """
        return _core.row_shot(self._rows(self.parameters(row, row + 1)))

    def _checked(self, batch: pa.RecordBatch) -> pa.RecordBatch:
        """The batch with the types of the parameters; one made elsewhere may have others."""
        schema = self.parameter_schema
        if batch.schema.names != schema.names:
            wanted, given = ", ".join(schema.names), ", ".join(batch.schema.names)
            raise InputError("wrong-count", "batch", f"its columns are {given}", f"give {wanted}")
        columns = []
        for field in schema:
            column = batch[field.name]
            if not pa.types.is_dictionary(field.type) and column.type != field.type:
                try:
                    column = column.cast(field.type)
                except (pa.ArrowInvalid, pa.ArrowNotImplementedError):
                    what = f"{field.name} has the type {column.type}"
                    raise InputError("wrong-type", "batch", what, f"give {field.type}") from None
            if field.name in ("row", "layout") and column.null_count:
                raise InputError(
                    "missing", "batch", f"{field.name} has nulls", "give whole numbers"
                )
            columns.append(column)
        checked = pa.RecordBatch.from_arrays(columns, names=schema.names)
        layout = _numpy(checked["layout"])
        if len(layout) and not (layout.min() >= 0 and layout.max() < len(self.layouts)):
            raise InputError(
                "out-of-range",
                "batch",
                "layout is out of range",
                f"give whole numbers from 0 to {len(self.layouts) - 1}",
            )
        return checked

    def _rows(self, batch: pa.RecordBatch) -> RowArguments:
        """Rows of parameters in the form that Rust accepts."""
        spec = self.spec
        layout = _numpy(batch["layout"])
        strike, columns = [], []
        for parameter in spec.parameters:
            key = parameter.path.removeprefix("strike.")
            column = batch[parameter.name]
            if key in specs.STRIKE and parameter.kind == "number":
                numbers = _numpy(column)
                if parameter.relative:
                    numbers = self.own[layout, specs.STRIKE.index(key)] + numbers
                strike.append((key, numbers))
            else:
                columns.append((parameter.path, _values(parameter, column)))
        row = _numpy(batch["row"])
        index = row % (spec.samples * spec.variants) if spec.paired else row
        return RowArguments(self.layouts, layout, columns, strike, spec.noise, spec.seed, index)

    def check(self) -> None:
        """Try some rows and reject the sweep if none of them can be simulated.

        Raises:
            InputError: None can; the message has the first row's error.
        """
        last = self.spec.rows - 1
        rows = sorted({last * i // max(PROBES - 1, 1) for i in range(PROBES)})
        first = None
        for row in rows:
            error = self.play(self.parameters(row, row + 1))["error"][0].as_py()
            if error is None:
                return
            first = first or error
        fault = f"no row can be simulated ({len(rows)} were tried)"
        raise InputError("no-play", "", fault, f"the first row: {first}")

    def __reduce__(self) -> tuple[type[RowPlayer], tuple[Spec]]:
        return (RowPlayer, (self.spec,))

    def _parameter_fields(self) -> list[pa.Field]:
        spec = self.spec
        fields = [_field("row", pa.int64(), "number of the row")]
        fields.append(_field("layout", pa.int32(), "index of the layout in the spec's shots"))
        if spec.draws:
            fields.append(_field("sample", pa.int64(), "number of the draw"))
        if spec.noise is not None:
            fields.append(_field("variant", pa.int64(), "number of the variant of the noise"))
        return fields + [
            _field(
                p.name,
                _type(p),
                f"{p.path}, added to the layout's own value" if p.relative else p.path,
            )
            for p in spec.parameters
        ]

    def _outcome_fields(self) -> list[pa.Field]:
        fields = [_field(name, self._outcome_type(name), OUTCOMES[name]) for name in self.columns]
        return [
            *fields,
            _field("error", pa.string(), "why the row could not be simulated; null if it was"),
        ]

    @property
    def columns(self) -> list[str]:
        """The names of the outcome columns."""
        return [n for n in self.spec.columns if n not in PLAYED or self.spec.noise is not None]

    def _outcome_type(self, name: str) -> pa.DataType:
        match name:
            case "events":
                return pa.int32()
            case "pocket":
                return pa.list_(pa.int8(), self.balls)
            case "end_x" | "end_y" | "end_z":
                return pa.list_(pa.float64(), self.balls)
            case "first_contact":
                return pa.dictionary(pa.int16(), pa.string())
            case "scratch":
                return pa.bool_()
        return pa.int16() if name in REFEREE else pa.float64()

    def _grid_column(self, grid: Grid, step: Indices) -> pa.Array:
        if grid.steps is not None:
            start, stop, count = grid.steps
            along = start + (stop - start) * (step / max(count - 1, 1))
            return pa.array(np.where(step == count - 1, stop if count > 1 else start, along))
        return self._listed(grid, step)

    def _listed(self, parameter: Parameter, index: Indices) -> pa.Array:
        """The values at these indices of the parameter's own list."""
        match parameter.kind:
            case "number":
                return pa.array(np.array(parameter.values)[index])
            case "list":
                return _lists(np.array(parameter.values)[index])
        texts = [specs.as_text(value) for value in parameter.values]
        return pa.DictionaryArray.from_arrays(pa.array(index.astype(np.int32)), pa.array(texts))

    def _drawn_columns(self, index: Indices) -> dict[str, pa.Array]:
        draws = self.spec.draws
        if not draws:
            return {}
        points = _core.points(
            self.spec.sequence, self.spec.seed, index, sum(draw.width for draw in draws)
        )
        columns, at = {}, 0
        for draw in draws:
            share = points[:, at : at + draw.width]
            at += draw.width
            columns[draw.name] = self._drawn_column(draw, share)
        return columns

    def _drawn_column(self, draw: Draw, share: NDArray[np.float64]) -> pa.Array:
        if draw.distribution == "choice":
            index = (share[:, 0] * len(draw.values)).astype(np.int64)
            return self._listed(draw, index)
        found = _core.quantiles(draw.distribution, list(draw.a), list(draw.b), share)
        return _lists(found) if draw.kind == "list" else pa.array(found[:, 0])

    def _with_outcomes(
        self, batch: pa.RecordBatch, layout: NDArray[np.int32], found: dict[str, Any]
    ) -> pa.RecordBatch:
        errors: dict[int, str] = found["errors"]
        failed = np.zeros(len(layout), dtype=np.bool_)
        failed[list(errors)] = True
        arrays = [batch[name] for name in self.parameter_schema.names]
        arrays += [self._outcome(name, found, layout, failed) for name in self.columns]
        texts = pa.nulls(len(layout), pa.string())
        if errors:
            texts = pa.array([errors.get(i) for i in range(len(layout))], pa.string())
        return pa.RecordBatch.from_arrays([*arrays, texts], schema=self.schema)

    def _outcome(
        self,
        name: str,
        found: dict[str, Any],
        layout: NDArray[np.int32],
        failed: NDArray[np.bool_],
    ) -> pa.Array:
        if name in PER_BALL:
            values: NDArray[Any] = found[name]
            # Layouts with fewer balls than the largest have no values for the rest.
            missing = (self.id_of < 0)[layout] if (self.id_of < 0).any() else None
            return _lists(values, missing, failed)
        if name in ("cue_end_x", "cue_end_y"):
            cue = found["cue_ball"]
            values = found[name.removeprefix("cue_")][np.arange(len(cue)), cue]
            return pa.array(values, mask=failed | (cue < 0))
        if name == "first_contact":
            ball = found[name]
            ids = self.id_of[layout, ball]
            index = pa.array(ids, mask=failed | (ball < 0))
            return pa.DictionaryArray.from_arrays(index, pa.array(self.ids))
        values = found[name]
        if name in PLAYED:
            # A row whose strike fails still has the strike that was drawn, unless the strike
            # before the noise was already invalid.
            return pa.array(values, mask=np.isnan(values))
        missing = failed | (values < 0) if name == "rails_before_second_ball" else failed
        return pa.array(values, mask=missing)


def _own_strike(file: dict[str, Any]) -> list[float]:
    """The numbers of a shot file's ``strike`` in the order of ``specs.STRIKE``."""

    def number(key: str) -> float:
        radians = file.get(key.removesuffix("_deg"))
        if key.endswith("_deg") and radians is not None:
            return _degrees(radians)
        return float(file.get(key, 0.0))

    return [number(key) for key in specs.STRIKE]


def _degrees(radians: float) -> float:
    """Degrees that Rust converts back to the same bits, where such a number exists."""
    near = radians / specs.RADIANS
    around = (near, math.nextafter(near, -math.inf), math.nextafter(near, math.inf))
    return next((turn for turn in around if turn * specs.RADIANS == radians), near)


def _field(name: str, kind: pa.DataType, meaning: str) -> pa.Field:
    return pa.field(name, kind, metadata={"is": meaning})


def _type(parameter: Parameter) -> pa.DataType:
    match parameter.kind:
        case "number":
            return pa.float64()
        case "list":
            return pa.list_(pa.float64(), parameter.width)
    return pa.dictionary(pa.int32(), pa.string())


def _lists(
    values: NDArray[Any],
    missing: NDArray[np.bool_] | None = None,
    failed: NDArray[np.bool_] | None = None,
) -> pa.Array:
    """Lists from shape (n, size); ``failed`` lists and ``missing`` items are null."""
    items = pa.array(values.ravel(), mask=None if missing is None else missing.ravel())
    mask = pa.array(failed) if failed is not None and failed.any() else None
    return pa.FixedSizeListArray.from_arrays(items, values.shape[1], mask=mask)


def _numpy(column: pa.Array) -> NDArray[Any]:
    found: NDArray[Any] = column.to_numpy(zero_copy_only=False)
    return np.ascontiguousarray(found)


def _values(parameter: Parameter, column: pa.Array) -> Any:
    """A column in the form that Rust accepts: an array, or choices and indices."""
    match parameter.kind:
        case "number":
            return _numpy(column)
        case "list":
            return _numpy(column.flatten()).reshape(len(column), -1)
    # A batch that was made elsewhere may have its own dictionary, or none.
    if not pa.types.is_dictionary(column.type):
        column = column.dictionary_encode()
    by_text = {specs.as_text(value): value for value in parameter.values}
    texts = column.dictionary.to_pylist()
    for text in texts:
        if text not in by_text:
            known = ", ".join(by_text)
            raise InputError(
                "unknown-name", "batch", f"{parameter.name} has {text!r}", f"give one of {known}"
            )
    choices = [by_text[text] for text in texts]
    return choices, _numpy(column.indices.cast(pa.int32()))

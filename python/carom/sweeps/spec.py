"""The spec of a sweep, ``carom-sweep/1``, read and checked."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from carom import _core
from carom.arguments import warn_of_degrees
from carom.errors import InputError
from carom.noise import Noise
from carom.shot import Shot
from carom.sweeps import dated
from carom.sweeps.columns import CHOSEN, OUTCOMES

FORMAT = "carom-sweep/1"
# The numbers of a strike; varying them is fast, because the shot file is not read again.
STRIKE = ("speed", "azimuth_deg", "elevation_deg", "side", "height")

_KEYS = (
    "format",
    "shots",
    "vary",
    "samples",
    "sequence",
    "seed",
    "noise",
    "variants",
    "paired",
    "columns",
)
_STEPS = ("from", "to", "count")
_OPTIONS = ("name", "relative")
_DISTRIBUTIONS = ("uniform", "log_uniform", "normal")
_WAYS = "grid, from + to + count, uniform, log_uniform, normal, choice"
# The keys of `noise`; older spellings in the second list.
_NOISE = (
    "speed",
    "azimuth_deg",
    "elevation_deg",
    "side_m",
    "height_m",
    "cling_probability",
    "cling_friction",
    "speed_relative",
)
_NOISE_ROWS = ("covariance", "bias", "samples")
_OLD_SIGMAS = {"side": "side_m", "height": "height_m"}
# Most steps of one grid; more of them are a typing error.
_MOST_STEPS = 10**12
# Names that no parameter may have, because every table has these columns.
_TAKEN = ("row", "layout", "sample", "variant", "error")

# Largest whole number that both Python and Rust count with.
_LARGEST = (1 << 63) - 1

Kind = Literal["number", "list", "choice"]


@dataclass(frozen=True, slots=True)
class _Varied:
    """A parameter that varies.

    Attributes:
        path: Its path in the shot file.
        name: Name of its column.
        kind: Kind of its values.
        relative: Whether a value is added to the layout's own number; only for a strike's numbers.
    """

    path: str
    name: str
    kind: Kind
    relative: bool


@dataclass(frozen=True, slots=True)
class Grid(_Varied):
    """A parameter that takes each value of a list or of a range.

    Attributes:
        values: The values; empty if there are ``steps``.
        steps: From, to, count: ``count`` evenly spaced values, both ends included.
    """

    values: tuple[Any, ...] = ()
    steps: tuple[float, float, int] | None = None

    @property
    def count(self) -> int:
        """Number of values."""
        return len(self.values) if self.steps is None else self.steps[2]

    @property
    def width(self) -> int:
        """Length of a value that is a list; else 1."""
        return len(self.values[0]) if self.kind == "list" else 1


@dataclass(frozen=True, slots=True)
class Draw(_Varied):
    """A parameter that is drawn at random.

    Attributes:
        distribution: ``uniform``, ``log_uniform``, ``normal``, or ``choice``.
        a: First parameter of the distribution (from, or mean), for each number of a list.
        b: Second parameter (to, or σ), likewise.
        values: The values of a ``choice``.
    """

    distribution: str
    a: tuple[float, ...] = ()
    b: tuple[float, ...] = ()
    values: tuple[Any, ...] = ()

    @property
    def width(self) -> int:
        """Number of uniform random numbers that one value needs."""
        return max(len(self.a), 1)


Parameter = Grid | Draw


@dataclass(frozen=True, slots=True)
class Spec:
    """The definition of a sweep: rows in C order of layout, grids as written, sample, variant.

    Attributes:
        layouts: The shots that the parameters are written into.
        parameters: The parameters that vary, in the order in which they are written.
        samples: Draws at every point of the grids.
        sequence: ``random`` or ``even``.
        seed: Seed of all random numbers.
        noise: Execution noise of every strike, if any.
        variants: How often each strike is simulated, each time with other noise.
        paired: Whether all points of the grids and all layouts have the same draws and noise.
        columns: The outcomes that the table has.
        file: The complete spec: shots in full, every default written out, presets with dated
            names.
        undated: The same with the names of presets as they were given. Older folders store it.
    """

    layouts: tuple[Shot, ...]
    parameters: tuple[Parameter, ...]
    samples: int
    sequence: str
    seed: int
    noise: Noise | None
    variants: int
    paired: bool
    columns: tuple[str, ...]
    file: dict[str, Any] = field(repr=False, compare=False)
    undated: dict[str, Any] = field(repr=False, compare=False)

    @property
    def grids(self) -> tuple[Grid, ...]:
        """The parameters with a list or a range of values."""
        return tuple(p for p in self.parameters if isinstance(p, Grid))

    @property
    def draws(self) -> tuple[Draw, ...]:
        """The parameters that are drawn."""
        return tuple(p for p in self.parameters if isinstance(p, Draw))

    @property
    def rows(self) -> int:
        """Number of rows of the table."""
        count = len(self.layouts) * self.samples * self.variants
        for grid in self.grids:
            count *= grid.count
        return count

    @property
    def balls(self) -> int:
        """Number of balls of the largest layout."""
        return max(map(len, (shot.ids for shot in self.layouts)))

    def to_json(self) -> str:
        """The complete spec as JSON text."""
        return json.dumps(self.file, ensure_ascii=False)

    @property
    def sha256(self) -> str:
        """Hash of the complete spec as JSON text without blanks, 64 hex digits."""
        return _digest(self.file)

    @property
    def undated_sha256(self) -> str:
        """Hash of ``undated``, which identifies the table in older folders."""
        return _digest(self.undated)


def _digest(file: dict[str, Any]) -> str:
    text = json.dumps(file, ensure_ascii=False, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()


def load(file: Mapping[str, Any], folder: Path) -> Spec:
    """Read a spec; paths of shot files in it are relative to ``folder``.

    Raises:
        InputError: The spec is invalid; the message names the place.
        OSError: A shot file cannot be read.
    """
    plain = _plain(file)
    # This check comes first: in a file of another format every key would be unknown.
    if isinstance(plain, Mapping) and plain.get("format") != FORMAT:
        _core.wrong_type(plain.get("format"), "format", f'"{FORMAT}", and a shot under `shots`')
    if not isinstance(plain, Mapping):
        _core.wrong_type(plain, "the spec", "an object {...}")
    _core.check_keys(dict.fromkeys(plain), "", _KEYS)
    found = dict(plain)
    if "shots" not in found:
        raise InputError(
            "missing",
            "shots",
            "the key is missing",
            "write a shot, the name of its file, or a list",
        )
    layouts = _layouts(found["shots"], folder)
    given = found.get("vary", {})
    vary = dated.vary(given)
    parameters = _parameters(vary)
    seed = _core.read_whole(found.get("seed", 0), "seed", 0, _LARGEST)
    samples = _samples(found, parameters)
    sequence = found.get("sequence", "random")
    if sequence not in ("random", "even"):
        if not isinstance(sequence, str):
            _core.wrong_type(sequence, "sequence", "a text")
        _core.unknown_word(sequence, "sequence", "sequence", ("random", "even"))
    noise = None if found.get("noise") is None else _noise(found["noise"])
    variants = _core.read_whole(found.get("variants", 1), "variants", 1, _LARGEST)
    if noise is None and variants > 1:
        raise InputError(
            "conflict", "variants", "without noise all variants would be equal", "write `noise`"
        )
    paired = found.get("paired", False)
    if not isinstance(paired, bool):
        _core.wrong_type(paired, "paired", "true or false")
    _check_strikes(layouts, parameters, noise)
    columns = _columns(found.get("columns"))
    whole = {
        "format": FORMAT,
        # A default elevation stays the default, so that it follows the parameters.
        "shots": dated.shots(tuple(shot._core for shot in layouts), vary),
        "vary": vary,
        "samples": samples,
        "sequence": sequence,
        "seed": seed,
        "noise": found.get("noise"),
        "variants": variants,
        "paired": paired,
        "columns": list(columns),
    }
    undated_shots = [shot._core.to_object(elevation=False) for shot in layouts]
    undated = whole | {"shots": undated_shots, "vary": given}
    spec = Spec(
        layouts,
        parameters,
        samples,
        sequence,
        seed,
        noise,
        variants,
        paired,
        columns,
        whole,
        undated,
    )
    if spec.rows > _LARGEST:
        what = f"the table would have {spec.rows} rows"
        remedy = f"vary fewer parameters or take fewer steps (at most {_LARGEST} rows)"
        raise InputError("out-of-range", "vary", what, remedy)
    return spec


def _fields(place: str, value: Any, known: tuple[str, ...]) -> dict[str, Any]:
    """The fields of an object without unknown keys."""
    _core.check_keys(value, place, known)
    return dict(value)


def _numbers(place: str, value: Any) -> tuple[float, ...]:
    """One finite number, or a list of them."""
    if isinstance(value, list | tuple):
        if not value:
            raise InputError(
                "wrong-count", place, "found an empty list", "write at least one number"
            )
        return tuple(_core.read_number(x, f"{place}[{i}]") for i, x in enumerate(value))
    return (_core.read_number(value, place),)


def _plain(file: Any) -> Any:
    """The spec in plain dicts, lists, strings and numbers, except for shots that are objects."""
    if not isinstance(file, Mapping):
        return _core.plain(file)
    found: dict[str, Any] = {}
    for key, value in file.items():
        if isinstance(value, Shot):
            found[key] = value
        elif key == "shots" and isinstance(value, list | tuple):
            found[key] = [item if isinstance(item, Shot) else _core.plain(item) for item in value]
        else:
            found |= _core.plain({key: value})
    return found


def _layouts(value: Any, folder: Path) -> tuple[Shot, ...]:
    if isinstance(value, list | tuple):
        if not value:
            raise InputError("wrong-count", "shots", "the list is empty", "write at least one shot")
        items = [(f"shots[{i}]", item) for i, item in enumerate(value)]
    else:
        items = [("shots", value)]
    found: list[Shot] = []
    for place, item in items:
        try:
            found += _shots(place, item, folder)
        except InputError as error:
            if error.place.startswith(place):
                raise
            raise error.inside(place, ": ") from None
    return tuple(found)


def _shots(place: str, item: Any, folder: Path) -> list[Shot]:
    if isinstance(item, Shot):
        return [item]
    if isinstance(item, str):
        if "*" not in item:
            return [Shot.load(folder / item)]
        names = sorted(folder.glob(item))
        if not names:
            raise InputError(
                "unknown-name",
                place,
                f'no file matches "{item}"',
                f"give a path relative to {folder}",
            )
        return [Shot.load(name) for name in names]
    if isinstance(item, Mapping):
        return [Shot.from_dict(item)]
    return _core.wrong_type(item, place, "a shot or the path of its file")


def _parameters(vary: Any) -> tuple[Parameter, ...]:
    if not isinstance(vary, Mapping):
        _core.wrong_type(vary, "vary", "an object: {path: how, ...}")
    found: list[Parameter] = []
    for path, how in vary.items():
        place = f"vary.{path}"
        if not isinstance(path, str):
            raise InputError(
                "wrong-type", place, "the path is not a string", "write one such as strike.speed"
            )
        _check_path(place, path)
        parameter = _parameter(place, path, how)
        for other in found:
            if other.name == parameter.name:
                raise InputError(
                    "duplicate",
                    place,
                    f'its column would be "{other.name}", like that of {other.path}',
                    'give it another "name"',
                )
            if re.match(re.escape(path) + r"[.\[]", other.path):
                raise InputError(
                    "conflict", place, f"it would overwrite {other.path}", "write it before that"
                )
        found.append(parameter)
    return tuple(found)


def _check_path(place: str, path: str) -> None:
    head = re.split(r"[.\[]", path)[0]
    tops = ("table", "physics", "balls", "strike", "until", "max_events")
    if head not in tops:
        _core.unknown_word(head, place, "key of a shot file", tops)
    if path == "balls" or re.fullmatch(r"balls[.\[][^.\[]+\]?(\.id)?", path):
        raise InputError(
            "conflict",
            place,
            "the ids of the balls cannot vary",
            "write the layouts in `shots`, or vary balls.ID.position",
        )


def _parameter(place: str, path: str, how: Any) -> Parameter:
    found = _fields(place, how, ("grid", *_STEPS, *_DISTRIBUTIONS, "choice", *_OPTIONS))
    relative = found.pop("relative", False)
    if not isinstance(relative, bool):
        _core.wrong_type(relative, f"{place}.relative", "true or false")
    name = found.pop("name", None)
    if name is None:
        name = column_name(path) + ("_offset" if relative else "")
    if not isinstance(name, str) or not re.fullmatch(r"[A-Za-z]\w*", name, re.ASCII):
        _core.wrong_type(name, f"{place}.name", "letters, digits and _")
    if name in (*_TAKEN, *OUTCOMES):
        raise InputError(
            "duplicate", place, f'the table already has a column "{name}"', 'give it another "name"'
        )
    parameter = _how(place, path, name, relative, found)
    if relative and (path.removeprefix("strike.") not in STRIKE or parameter.kind != "number"):
        what = "only a strike's numbers can vary relative to the layout's own"
        raise InputError(
            "conflict", f"{place}.relative", what, f"write strike.{', strike.'.join(STRIKE)}"
        )
    if path == "strike.azimuth" and parameter.kind == "number":
        warn_of_degrees(place, _largest(parameter))
    return parameter


def _largest(parameter: Parameter) -> list[float]:
    """Numbers that bound those of a parameter; of a normal distribution its mean."""
    if isinstance(parameter, Grid):
        return list(parameter.values if parameter.steps is None else parameter.steps[:2])
    if parameter.distribution == "normal":
        return list(parameter.a)
    return [*parameter.a, *parameter.b, *parameter.values]


def _how(place: str, path: str, name: str, relative: bool, found: dict[str, Any]) -> Parameter:
    if set(found) == set(_STEPS):
        ends = (
            _core.read_number(found["from"], f"{place}.from"),
            _core.read_number(found["to"], f"{place}.to"),
        )
        count = _core.read_whole(found["count"], f"{place}.count", 1, _MOST_STEPS)
        return Grid(path, name, "number", relative, steps=(*ends, count))
    if len(found) != 1 or not set(found).isdisjoint(_STEPS):
        raise InputError(
            "wrong-count", place, "not exactly one way to vary it", f"write one of {_WAYS}"
        )
    ((way, value),) = found.items()
    at = f"{place}.{way}"
    if way in ("grid", "choice"):
        kind, values = _values(at, value)
        if way == "grid":
            return Grid(path, name, kind, relative, values)
        return Draw(path, name, kind, relative, way, values=values)
    kind, a, b = _drawn(at, way, value)
    return Draw(path, name, kind, relative, way, a, b)


def _drawn(place: str, way: str, value: Any) -> tuple[Kind, tuple[float, ...], tuple[float, ...]]:
    meaning = "[mean, sigma]" if way == "normal" else "[from, to]"
    if not isinstance(value, list | tuple) or len(value) != 2:
        _core.wrong_type(value, place, meaning)
    a, b = (_numbers(f"{place}[{i}]", x) for i, x in enumerate(value))
    kind: Kind = "list" if isinstance(value[0], list | tuple) else "number"
    if way == "normal" and not isinstance(value[1], list | tuple):
        b = b * len(a)
    if len(a) != len(b):
        raise InputError(
            "wrong-count",
            place,
            f"found {len(a)} and {len(b)} numbers",
            "write two lists of one length",
        )
    for i, (low, high) in enumerate(zip(a, b, strict=True)):
        at = f"{place}[1]" if kind == "number" else f"{place}[1][{i}]"
        if way == "normal" and high < 0:
            raise InputError(
                "out-of-range", at, f"{high!r} is not a standard deviation", "write a number ≥ 0"
            )
        if way != "normal" and high < low:
            raise InputError(
                "out-of-range",
                at,
                f"{high!r} is less than {low!r}",
                "write the smaller number first",
            )
        if way == "log_uniform" and low <= 0:
            raise InputError(
                "out-of-range", f"{place}[0]", f"{low!r} has no logarithm", "write a number > 0"
            )
    return kind, a, b


def _values(place: str, value: Any) -> tuple[Kind, tuple[Any, ...]]:
    if not isinstance(value, list | tuple) or not value:
        _core.wrong_type(value, place, "a list of values")
    values = tuple(value)
    if all(_is_number(x) for x in values):
        return "number", tuple(_core.read_number(x, f"{place}[{i}]") for i, x in enumerate(values))
    rows = [x for x in values if isinstance(x, list | tuple) and x and all(map(_is_number, x))]
    if len(rows) == len(values) and len({len(row) for row in rows}) == 1:
        return "list", tuple(_numbers(f"{place}[{i}]", x) for i, x in enumerate(values))
    texts = [as_text(x) for x in values]
    if len(set(texts)) < len(texts):
        raise InputError("duplicate", place, "a value occurs twice", "keep one of them")
    return "choice", values


def _is_number(x: Any) -> bool:
    return isinstance(x, int | float) and not isinstance(x, bool)


def as_text(value: Any) -> str:
    """A value of a choice as text: a string unchanged, anything else as JSON."""
    return value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)


def column_name(path: str) -> str:
    """A parameter's column: its path, with ``_`` for everything but letters and digits."""
    return re.sub(r"\W+", "_", path.removeprefix("strike."), flags=re.ASCII).strip("_")


def _samples(found: Mapping[str, Any], parameters: tuple[Parameter, ...]) -> int:
    drawn = [p.path for p in parameters if isinstance(p, Draw)]
    samples = _core.read_whole(found.get("samples", 1), "samples", 1, _LARGEST)
    if drawn and "samples" not in found:
        raise InputError(
            "missing", "samples", f"the key is missing, and {drawn[0]} is drawn", "write a number"
        )
    if not drawn and samples > 1:
        raise InputError(
            "conflict", "samples", "nothing is drawn", "leave it out, or draw a parameter in `vary`"
        )
    return samples


def _noise(written: Any) -> Noise:
    if isinstance(written, str):
        return Noise.preset(written)
    given = _fields("noise", written, (*_NOISE, *_OLD_SIGMAS, *_NOISE_ROWS))
    numbers: dict[str, Any] = {}
    rows = {key: given[key] for key in _NOISE_ROWS if key in given}
    for key, value in given.items():
        if key in rows:
            continue
        x = _core.read_number(value, f"noise.{key}")
        new = _OLD_SIGMAS.get(key, key)
        if new != key and new in given:
            raise InputError(
                "duplicate", f"noise.{key}", f"{new} gives the same number", f"keep only {new}"
            )
        numbers[new.removesuffix("_deg")] = x * RADIANS if key.endswith("_deg") else x
    return Noise(**numbers, **rows)


# One degree, rad.
RADIANS = 0.017453292519943295


def _check_strikes(
    layouts: tuple[Shot, ...], parameters: tuple[Parameter, ...], noise: Noise | None
) -> None:
    struck = [p.path for p in parameters if p.path.startswith("strike.")]
    if not struck and noise is None:
        return
    for i, shot in enumerate(layouts):
        if shot.azimuth is None:
            what = f"the shot has no strike, but {struck[0] if struck else 'noise'} needs one"
            raise InputError("no-strike", f"shots[{i}]", what, "add a strike to the shot")


def _columns(value: Any) -> tuple[str, ...]:
    if value is None:
        return CHOSEN
    if not isinstance(value, list | tuple):
        _core.wrong_type(value, "columns", "a list of names")
    for i, name in enumerate(value):
        if not isinstance(name, str):
            _core.wrong_type(name, f"columns[{i}]", "a name")
        if name not in OUTCOMES:
            _core.unknown_word(name, f"columns[{i}]", "outcome", tuple(OUTCOMES))
    return tuple(name for name in OUTCOMES if name in value)

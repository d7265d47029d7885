"""The spec of a sweep, ``carom-sweep/1``, read and checked."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from carom.errors import InputError
from carom.noise import Noise
from carom.shot import Shot
from carom.sweeps import read
from carom.sweeps.columns import CHOSEN, OUTCOMES

FORMAT = "carom-sweep/1"
# The numbers of a strike; they vary without a shot being made anew.
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
_SIGMAS = {
    "speed": "speed",
    "azimuth_deg": "azimuth",
    "elevation_deg": "elevation",
    "side": "side",
    "height": "height",
}
# Nobody means to write a table of which one grid alone has more steps.
_MOST_STEPS = 10**12
# Columns of every row, which no parameter may be called.
_TAKEN = ("row", "layout", "sample", "variant", "error")

Kind = Literal["number", "list", "choice"]


@dataclass(frozen=True, slots=True)
class _Varied:
    """What varies.

    Attributes:
        path: Where it stands in the shot file.
        name: Of its column.
        kind: What a value is.
        relative: Whether a value is added to the layout's own number, which is one of a strike.
    """

    path: str
    name: str
    kind: Kind
    relative: bool


@dataclass(frozen=True, slots=True)
class Grid(_Varied):
    """A parameter that takes each of some values.

    Attributes:
        values: All of them; empty where they are ``steps``.
        steps: From, to, count: as many values, evenly spaced, both ends included.
    """

    values: tuple[Any, ...] = ()
    steps: tuple[float, float, int] | None = None

    @property
    def count(self) -> int:
        """How many values."""
        return len(self.values) if self.steps is None else self.steps[2]

    @property
    def width(self) -> int:
        """Numbers in a list."""
        return len(self.values[0]) if self.kind == "list" else 1


@dataclass(frozen=True, slots=True)
class Draw(_Varied):
    """A parameter that is drawn.

    Attributes:
        distribution: ``uniform``, ``log_uniform``, ``normal``, or ``choice``.
        a: First parameter of the distribution (from, mean), for each number of a list.
        b: Second (to, σ).
        values: What is chosen from.
    """

    distribution: str
    a: tuple[float, ...] = ()
    b: tuple[float, ...] = ()
    values: tuple[Any, ...] = ()

    @property
    def width(self) -> int:
        """Numbers in a list; uniform numbers that a value takes."""
        return max(len(self.a), 1)


Parameter = Grid | Draw


@dataclass(frozen=True, slots=True)
class Spec:
    """What a sweep is: rows in C order of layout, grids as written, sample, variant.

    Attributes:
        layouts: The shots that everything is put into.
        parameters: What varies, in the order in which it is put in.
        samples: Draws at every point of the grids.
        sequence: ``random`` or ``even``.
        seed: Of all random numbers.
        noise: With which every strike is played, if any.
        variants: How often, each with other errors.
        paired: Whether every point of the grids and every layout sees the same draws and errors.
        columns: Which outcomes are kept.
        file: The spec with everything that it is made of: shots in full, nothing left to defaults.
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

    @property
    def grids(self) -> tuple[Grid, ...]:
        """What takes each of some values."""
        return tuple(p for p in self.parameters if isinstance(p, Grid))

    @property
    def draws(self) -> tuple[Draw, ...]:
        """What is drawn."""
        return tuple(p for p in self.parameters if isinstance(p, Draw))

    @property
    def rows(self) -> int:
        """Rows of the table."""
        count = len(self.layouts) * self.samples * self.variants
        for grid in self.grids:
            count *= grid.count
        return count

    @property
    def balls(self) -> int:
        """Balls of the largest layout."""
        return max(map(len, (shot.ids for shot in self.layouts)))

    @property
    def sha256(self) -> str:
        """Of the spec's JSON text without blanks, in the order in which it is kept: 64 digits."""
        text = json.dumps(self.file, ensure_ascii=False, separators=(",", ":"))
        return hashlib.sha256(text.encode()).hexdigest()


def load(file: Mapping[str, Any], folder: Path) -> Spec:
    """Read a spec; the names of shot files in it start from ``folder``.

    Raises:
        InputError: Something in it does not make sense; the message names the place.
        OSError: A shot file cannot be read.
    """
    plain = read.plain(file)
    # First, since of another file every key is unknown.
    if isinstance(plain, Mapping) and plain.get("format") != FORMAT:
        what = f"found {read.describe(plain.get('format'))}"
        read.refuse("format", what, f'write "{FORMAT}", and a shot under `shots`')
    found = read.fields("", plain, _KEYS)
    if "shots" not in found:
        read.refuse("shots", "the key is missing", "write a shot, the name of its file, or a list")
    layouts = _layouts(found["shots"], folder)
    parameters = _parameters(found.get("vary", {}))
    seed = read.whole("seed", found.get("seed", 0), 0)
    samples = _samples(found, parameters)
    sequence = found.get("sequence", "random")
    if sequence not in ("random", "even"):
        remedy = read.nearest(str(sequence), ("random", "even"))
        read.refuse("sequence", f"there is no sequence {sequence!r}", remedy)
    noise = None if found.get("noise") is None else _noise(found["noise"])
    variants = read.whole("variants", found.get("variants", 1), 1)
    if noise is None and variants > 1:
        read.refuse("variants", "without noise all of them would be the same", "write `noise`")
    paired = found.get("paired", False)
    if not isinstance(paired, bool):
        read.refuse("paired", f"found {read.describe(paired)}", "write true or false")
    _check_strikes(layouts, parameters, noise)
    columns = _columns(found.get("columns"))
    whole = {
        "format": FORMAT,
        "shots": [shot.to_dict() for shot in layouts],
        "vary": found.get("vary", {}),
        "samples": samples,
        "sequence": sequence,
        "seed": seed,
        "noise": found.get("noise"),
        "variants": variants,
        "paired": paired,
        "columns": list(columns),
    }
    spec = Spec(
        layouts, parameters, samples, sequence, seed, noise, variants, paired, columns, whole
    )
    if spec.rows > read.LARGEST_WHOLE:
        read.refuse("vary", f"the table would have {spec.rows} rows", "vary less, or more coarsely")
    return spec


def _layouts(value: Any, folder: Path) -> tuple[Shot, ...]:
    if isinstance(value, list | tuple):
        if not value:
            read.refuse("shots", "the list is empty", "write at least one shot")
        items = [(f"shots[{i}]", item) for i, item in enumerate(value)]
    else:
        items = [("shots", value)]
    found: list[Shot] = []
    for place, item in items:
        try:
            found += _shots(place, item, folder)
        except InputError as error:
            if str(error).startswith(place):
                raise
            raise InputError(f"{place}: {error}") from None
    return tuple(found)


def _shots(place: str, item: Any, folder: Path) -> list[Shot]:
    if isinstance(item, Shot):
        return [item]
    if isinstance(item, str):
        if "*" not in item:
            return [Shot.load(folder / item)]
        names = sorted(folder.glob(item))
        if not names:
            read.refuse(place, f'no file is called "{item}"', f"names start from {folder}")
        return [Shot.load(name) for name in names]
    if isinstance(item, Mapping):
        return [Shot.from_dict(item)]
    return read.refuse(place, f"found {read.describe(item)}", "write a shot or its file's name")


def _parameters(vary: Any) -> tuple[Parameter, ...]:
    if not isinstance(vary, Mapping):
        read.refuse("vary", f"found {read.describe(vary)}", "write an object: {path: how, ...}")
    found: list[Parameter] = []
    for path, how in vary.items():
        place = f"vary.{path}"
        if not isinstance(path, str):
            read.refuse(place, "the path is no text", "write one such as strike.speed")
        _check_path(place, path)
        parameter = _parameter(place, path, how)
        for other in found:
            if other.name == parameter.name:
                read.refuse(
                    place,
                    f'its column would be "{other.name}", as that of {other.path}',
                    'give it another "name"',
                )
            if re.match(re.escape(path) + r"[.\[]", other.path):
                read.refuse(place, f"it would overwrite {other.path}", "write it before that")
        found.append(parameter)
    return tuple(found)


def _check_path(place: str, path: str) -> None:
    head = re.split(r"[.\[]", path)[0]
    tops = ("table", "physics", "balls", "strike", "max_events")
    if head not in tops:
        read.refuse(place, "no such path in a shot file", read.nearest(head, tops))
    if path == "balls" or re.fullmatch(r"balls[.\[][^.\[]+\]?(\.id)?", path):
        read.refuse(
            place,
            "which balls there are does not vary",
            "write the layouts in `shots`, or vary balls.ID.position",
        )


def _parameter(place: str, path: str, how: Any) -> Parameter:
    found = read.fields(place, how, ("grid", *_STEPS, *_DISTRIBUTIONS, "choice", *_OPTIONS))
    relative = found.pop("relative", False)
    if not isinstance(relative, bool):
        read.refuse(f"{place}.relative", f"found {read.describe(relative)}", "write true or false")
    name = found.pop("name", None) or column_name(path) + ("_offset" if relative else "")
    if not isinstance(name, str) or not re.fullmatch(r"[A-Za-z]\w*", name, re.ASCII):
        read.refuse(f"{place}.name", f"found {read.describe(name)}", "write letters, digits and _")
    if name in (*_TAKEN, *OUTCOMES):
        read.refuse(place, f'a column "{name}" is there already', 'give it another "name"')
    parameter = _how(place, path, name, relative, found)
    if relative and (path.removeprefix("strike.") not in STRIKE or parameter.kind != "number"):
        what = "only numbers of a strike vary about the layout's own"
        read.refuse(f"{place}.relative", what, f"write strike.{', strike.'.join(STRIKE)}")
    return parameter


def _how(place: str, path: str, name: str, relative: bool, found: dict[str, Any]) -> Parameter:
    if set(found) == set(_STEPS):
        ends = read.number(f"{place}.from", found["from"]), read.number(f"{place}.to", found["to"])
        count = read.whole(f"{place}.count", found["count"], 1, _MOST_STEPS)
        return Grid(path, name, "number", relative, steps=(*ends, count))
    if len(found) != 1 or not set(found).isdisjoint(_STEPS):
        read.refuse(place, "it does not say in which one way this varies", f"write one of {_WAYS}")
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
        read.refuse(place, f"found {read.describe(value)}", f"write {meaning}")
    a, b = (read.numbers(f"{place}[{i}]", x) for i, x in enumerate(value))
    kind: Kind = "list" if isinstance(value[0], list | tuple) else "number"
    if way == "normal" and not isinstance(value[1], list | tuple):
        b = b * len(a)
    if len(a) != len(b):
        read.refuse(place, f"found {len(a)} and {len(b)} numbers", "write as many of either")
    for i, (low, high) in enumerate(zip(a, b, strict=True)):
        at = f"{place}[1]" if kind == "number" else f"{place}[1][{i}]"
        if way == "normal" and high < 0:
            read.refuse(at, f"{high!r} is no standard deviation", "write a number ≥ 0")
        if way != "normal" and high < low:
            read.refuse(at, f"{high!r} is less than {low!r}", "write the smaller one first")
        if way == "log_uniform" and low <= 0:
            read.refuse(f"{place}[0]", f"{low!r} has no logarithm", "write a number > 0")
    return kind, a, b


def _values(place: str, value: Any) -> tuple[Kind, tuple[Any, ...]]:
    if not isinstance(value, list | tuple) or not value:
        read.refuse(place, f"found {read.describe(value)}", "write a list of values")
    values = tuple(value)
    if all(_is_number(x) for x in values):
        return "number", tuple(read.number(f"{place}[{i}]", x) for i, x in enumerate(values))
    rows = [x for x in values if isinstance(x, list | tuple) and x and all(map(_is_number, x))]
    if len(rows) == len(values) and len({len(row) for row in rows}) == 1:
        return "list", tuple(read.numbers(f"{place}[{i}]", x) for i, x in enumerate(values))
    texts = [as_text(x) for x in values]
    if len(set(texts)) < len(texts):
        read.refuse(place, "a value stands there twice", "keep one of them")
    return "choice", values


def _is_number(x: Any) -> bool:
    return isinstance(x, int | float) and not isinstance(x, bool)


def as_text(value: Any) -> str:
    """A value of a choice in its column: a text as it is, all else as JSON."""
    return value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)


def column_name(path: str) -> str:
    """What a parameter's column is called: its path, ``_`` for what is no letter or digit."""
    return re.sub(r"\W+", "_", path.removeprefix("strike."), flags=re.ASCII).strip("_")


def _samples(found: Mapping[str, Any], parameters: tuple[Parameter, ...]) -> int:
    drawn = [p.path for p in parameters if isinstance(p, Draw)]
    samples = read.whole("samples", found.get("samples", 1), 1)
    if drawn and "samples" not in found:
        read.refuse("samples", f"the key is missing, and {drawn[0]} is drawn", "say how often")
    if not drawn and samples > 1:
        read.refuse("samples", "nothing is drawn", "leave it out, or draw something in `vary`")
    return samples


def _noise(value: Any) -> Noise:
    if isinstance(value, str):
        return Noise.preset(value)
    sigmas = read.fields("noise", value, tuple(_SIGMAS))
    turned = {}
    for key, sigma in sigmas.items():
        x = read.number(f"noise.{key}", sigma)
        turned[_SIGMAS[key]] = x * RADIANS if key.endswith("_deg") else x
    return Noise(**turned)


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
            what = f"the shot has no strike, and {struck[0] if struck else 'noise'} is of one"
            read.refuse(f"shots[{i}]", what, "give it one")


def _columns(value: Any) -> tuple[str, ...]:
    if value is None:
        return CHOSEN
    if not isinstance(value, list | tuple):
        read.refuse("columns", f"found {read.describe(value)}", "write a list of names")
    for i, name in enumerate(value):
        if name not in OUTCOMES:
            remedy = read.nearest(str(name), tuple(OUTCOMES))
            read.refuse(f"columns[{i}]", f"there is no outcome {name!r}", remedy)
    return tuple(name for name in OUTCOMES if name in value)

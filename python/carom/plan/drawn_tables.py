"""A shot on the tables that agree with what was learned about one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol, Self

from carom import _core
from carom.arguments import whole
from carom.build import Layout
from carom.errors import InputError
from carom.plan.lookup import core_of

if TYPE_CHECKING:
    import carom

# Balls that overlap each other or a cushion by at most this on a drawn table are moved apart, m.
# Nose lines that were learned from a film differ by millimetres; a ball that is deeper in a rail
# contradicts this draw, which is left out.
_REPAIRED = 0.005
_NO_ROOM = ("overlap", "in-cushion")
# Most drawn tables, as in Rust.
_MOST_TABLES = 1000


class PossibleTable(Protocol):
    """A table that may be the true one: ``table`` and ``physics`` as a shot file has them."""

    @property
    def table(self) -> Mapping[str, Any]:
        """The table."""

    @property
    def physics(self) -> Mapping[str, Any]:
        """The physics."""


class TablePosterior(Protocol):
    """What is known about a table, such as a ``carom.learn.Posterior``.

    ``table`` and ``physics`` are the most probable ones.
    """

    @property
    def table(self) -> Mapping[str, Any]:
        """The table on which shots are planned."""

    @property
    def physics(self) -> Mapping[str, Any]:
        """The physics with which shots are planned."""

    def draw(self, count: int, seed: int = 0, /) -> Sequence[PossibleTable]:
        """Tables that may be the true one."""


@dataclass(frozen=True, slots=True)
class ListedTables:
    """Tables of a list, of which each may be the true one, such as those of a ``learned.json``.

    JavaScript takes the tables from the file in this way, so that its chances are those of a
    ``ListedTables`` to the bit.

    Attributes:
        table: The most probable table.
        physics: Its physics.
        tables: ``table`` and ``physics`` of each drawn table.
    """

    table: Mapping[str, Any]
    physics: Mapping[str, Any]
    tables: tuple[_ListedTable, ...]

    @classmethod
    def from_dict(cls, file: Mapping[str, Any]) -> Self:
        """The keys ``table``, ``physics`` and ``draws`` of ``carom-learned/1``.

        Raises:
            InputError: A key is missing, or has a wrong type.
        """
        remedy = "write the file with carom learn table, or with Posterior.save"
        for key in ("table", "physics", "draws"):
            if not isinstance(file, Mapping) or key not in file:
                raise InputError("missing", key, "the key is missing", remedy)
        rows = file["draws"]
        if not isinstance(rows, Sequence) or isinstance(rows, str) or not rows:
            raise InputError("wrong-type", "draws", "it is not a list of tables", remedy)
        for index, row in enumerate(rows):
            if not isinstance(row, Mapping) or not {"table", "physics"} <= row.keys():
                fault = "it has no table and physics"
                raise InputError("wrong-type", f"draws[{index}]", fault, remedy)
        listed = tuple(_ListedTable(row["table"], row["physics"]) for row in rows)
        return cls(file["table"], file["physics"], listed)

    def draw(self, count: int, seed: int = 0, /) -> list[_ListedTable]:
        """The ``count`` tables from number ``seed``·``count`` on, around the list.

        Raises:
            InputError: The list is shorter.
        """
        size = len(self.tables)
        if count > size:
            fault = f"{count} tables are more than the {size} of the file"
            remedy = "give fewer draws, or write the file with Posterior.save(path, draws=...)"
            raise InputError("out-of-range", "draws", fault, remedy)
        return [self.tables[(seed * count + index) % size] for index in range(count)]


@dataclass(frozen=True, slots=True)
class _ListedTable:
    """A table of a list, with its physics."""

    table: Mapping[str, Any]
    physics: Mapping[str, Any]


def on_drawn_tables(
    shot: carom.Shot,
    posterior: TablePosterior | None,
    draws: int,
    n: int,
    seed: int,
    frame: carom.Frame | None = None,
) -> tuple[carom.Shot, list[_core.Shot]]:
    """The shot on the learned table, and on ``draws`` tables that may be the true one.

    Without a posterior they are the shot itself and none. Balls that overlap on a table are moved
    apart by up to 5 mm. A table on which they overlap by more is left out: they could not lie
    there. At least half of the tables, and two, must remain.

    Args:
        shot: The balls and the strike.
        posterior: What is known about the table; None if it is that of the shot.
        draws: Number of drawn tables.
        n: Number of variants, of which every table needs one.
        seed: Seed of the drawn tables.
        frame: The frame that requests the shot, if there is one.

    Raises:
        InputError: A number is out of range, the posterior is none, balls have no room on most of
            the tables, or the table of the frame is not the learned one.
    """
    core_of(shot)
    count = whole("draws", draws, _MOST_TABLES + 1, low=2)
    if posterior is None:
        return shot, []
    if n < count:
        raise InputError(
            "out-of-range",
            "n",
            f"{n} variants are fewer than {count} drawn tables",
            "give more variants, or fewer draws",
        )
    planned = on_learned_table(shot, posterior)
    if frame is not None and planned != shot:
        raise InputError(
            "mismatch",
            "frame",
            "its table and physics are not those of the posterior",
            "make it with table=posterior.table and physics=posterior.physics",
        )
    drawn: list[_core.Shot] = []
    refused: list[InputError] = []
    for index, one in enumerate(posterior.draw(count, seed)):
        try:
            drawn.append(core_of(_moved(shot, one, f"draws[{index}]", own_elevation=False)))
        except InputError as error:
            if error.kind not in _NO_ROOM:
                raise
            refused.append(error)
    # A few draws are far out; if most have no room, the posterior is of another table.
    if len(drawn) < max(2, count / 2):
        raise refused[0]
    return planned, drawn


def on_learned_table(shot: carom.Shot, posterior: TablePosterior) -> carom.Shot:
    """The shot with the learned table and physics in place of its own.

    Raises:
        InputError: The posterior is none, balls overlap on its table by more than 5 mm, or the
            strike cannot be played there.
    """
    if not all(hasattr(posterior, name) for name in ("table", "physics", "draw")):
        raise InputError(
            "wrong-type",
            "posterior",
            f"found {type(posterior).__name__}",
            'give carom.learn.Posterior.load("learned.json"), or an object with table, physics and '
            "draw",
        )
    return _moved(shot, posterior, "posterior", own_elevation=True)


def _moved(shot: carom.Shot, onto: PossibleTable, place: str, *, own_elevation: bool) -> carom.Shot:
    """The shot with another table and physics.

    Without its own elevation it has the default one there: then only its struck ball matters.
    """
    file = shot.to_dict() | {"table": dict(onto.table), "physics": dict(onto.physics)}
    if "strike" in file and (shot.has_default_elevation or not own_elevation):
        for key in ("elevation", "elevation_deg"):
            file["strike"].pop(key, None)
    try:
        layout, _ = Layout(tuple(file["balls"])).repaired(
            _REPAIRED, table=file["table"], physics=file["physics"]
        )
        return shot._wrap(_core.Shot.from_object(file | {"balls": list(layout.balls)}))
    except InputError as error:
        raise error.inside(place, ": ") from None

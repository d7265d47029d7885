"""Many variants of shots: each with its own physics, strike and start states."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from carom import _core
from carom.arguments import angles, array, core, whole
from carom.batch import VARIABLES
from carom.errors import InputError
from carom.lazy import np
from carom.shot import Shot

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

# The keys of ``strike``; an angle may be in radians or in degrees.
_STRIKE = (*VARIABLES, "azimuth_deg", "elevation_deg")
# The parts of a start state.
_PARTS = ("position", "velocity", "angular_velocity")
# The most candidates of one object: their numbers would take some gigabytes.
_MOST = 10**7


class Candidates:
    """Variants of one shot, or of several, for batches of states and residuals.

    Arguments that are None keep the values of the shot. The shapes of the others, without their
    own last axes, broadcast against each other as NumPy's arrays do; a list of n shots has the
    shape (n,). The candidates are flat, in C order of the broadcast shape. So with speeds of shape
    (100, 1) and 20 shots there are 2000 candidates, and number 20·i + j has speed i and shot j::

        carom.Candidates(shot, physics={"cloth.sliding_friction": [0.17, 0.18, 0.19]})

    A candidate is checked as a shot file when it is used. If it is refused, for a number out of
    range or balls that overlap, the result has NaN in its row and its error in ``errors``; the
    other candidates are not concerned.

    Args:
        shots: A shot, or a list of shots. For candidates with different tables, models or whole
            physics, give a list of shots that have them.
        strike: What differs in the strike of the shot's struck ball: arrays of shape (...) for any
            of ``speed`` (m/s), ``azimuth``, ``elevation`` (rad), ``azimuth_deg``,
            ``elevation_deg``, ``side`` and ``height`` (ball radii). If the elevation was omitted in
            the shot and is omitted here, it is the default elevation of each candidate.
        physics: What differs in the physics: arrays of shape (...) by the keys of a shot file, such
            as ``cloth.sliding_friction``, ``ball_ball.restitution``, ``cushion.restitution.b``. The
            key of a formula, such as ``cushion.restitution``, makes the coefficient constant. The
            speed bands of the shot's cloth are ``cloth.rolling_friction[0].friction`` and
            ``cloth.rolling_friction[0].up_to``.
        position: Centres at the start of all balls, m, shape (..., n_balls, 2) or (..., n_balls,
            3). Without the third component it is the shot's own.
        velocity: Velocities, m/s, of the same shapes.
        angular_velocity: Spins, rad/s, shape (..., n_balls, 3).

    Start states may be those of balls in motion, also in flight (z above the radius): the state in
    the middle of a shot is a start like any other. How a ball moves follows from the numbers, as in
    a shot file. Only a ball at rest can be struck: shots for other states have no strike.

    Raises:
        InputError: A key does not exist, shapes do not fit, a strike or start states are given for
            shots without a strike or with different numbers of balls, or there are too many
            candidates.
    """

    __slots__ = ("_core", "_shots", "shape")

    #: The shape that the arguments broadcast to; the candidates are flat, in C order.
    shape: tuple[int, ...]

    def __init__(
        self,
        shots: Shot | Sequence[Shot],
        *,
        strike: Mapping[str, ArrayLike] | None = None,
        physics: Mapping[str, ArrayLike] | None = None,
        position: ArrayLike | None = None,
        velocity: ArrayLike | None = None,
        angular_velocity: ArrayLike | None = None,
    ) -> None:
        several, self._shots = _shots_of(shots)
        places = np.arange(len(self._shots), dtype=np.uint32) if several else np.uint32(0)
        struck, own_elevation = _strikes(strike, self._shots, several=several)
        numbers = _numbers(physics)
        states = _states((position, velocity, angular_velocity), self._shots, several=several)
        shapes = {
            **({"shots": (len(self._shots),)} if several else {}),
            **({} if struck is None else {"strike": struck.shape[:-1]}),
            **{f"physics.{key}": values.shape for key, values in numbers.items()},
            **{name: values.shape[:-2] for name, values in (states or {}).items()},
        }
        self.shape = broadcast(shapes)
        count = math.prod(self.shape)
        if count > _MOST:
            raise InputError(
                "out-of-range", "", f"{count} candidates are too many", f"give at most {_MOST}"
            )
        values = np.empty((count, len(numbers)))
        for column, given in enumerate(numbers.values()):
            values[:, column] = np.broadcast_to(given, self.shape).ravel()
        self._core = _core.Candidates(
            self._shots,
            np.ascontiguousarray(np.broadcast_to(places, self.shape).ravel()),
            list(numbers),
            values,
            None if states is None else self._flat_states(states),
            None if struck is None else (rows(struck, self.shape), own_elevation),
        )

    def _flat_states(
        self, states: Mapping[str, NDArray[np.float64]]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
        flat = []
        for name in _PARTS:
            given = states[name]
            full = np.broadcast_to(given, (*self.shape, *given.shape[-2:]))
            flat.append(np.ascontiguousarray(full.reshape(-1, *given.shape[-2:])))
        position, velocity, angular_velocity = flat
        return position, velocity, angular_velocity

    def __len__(self) -> int:
        return len(self._core)

    def __bool__(self) -> bool:
        return True

    @property
    def shots(self) -> list[Shot]:
        """The shots that the candidates are variants of."""
        return [Shot._wrap(shot) for shot in self._shots]

    @property
    def ids(self) -> list[str]:
        """The ids of the balls of the shot; of the first one with the most balls, if several."""
        return max(self._shots, key=len).ids if self._shots else []

    def shot(self, index: int) -> Shot:
        """Candidate ``index`` as a shot, which simulates to the bits of the candidate.

        Raises:
            InputError: There is no such candidate, or it is refused.
        """
        return Shot._wrap(self._core.shot(whole("index", index, len(self))))

    def __repr__(self) -> str:
        shots = "1 shot" if len(self._shots) == 1 else f"{len(self._shots)} shots"
        return f"<carom.Candidates: {len(self)} of {shots}>"


def candidates_of(value: Candidates | Shot | Iterable[Shot]) -> Candidates:
    """Candidates, or a shot or a list of shots as candidates."""
    return value if isinstance(value, Candidates) else Candidates(value)  # type: ignore[arg-type]


def broadcast(shapes: Mapping[str, tuple[int, ...]]) -> tuple[int, ...]:
    """The shape that the shapes of named arguments broadcast to."""
    if not any(shapes.values()):
        return ()
    try:
        return np.broadcast_shapes(*shapes.values())
    except ValueError:
        listed = ", ".join(f"{name} {shape}" for name, shape in shapes.items() if shape)
        raise InputError(
            "wrong-count", "", f"shapes do not broadcast: {listed}", "make them agree"
        ) from None


def rows(values: NDArray[np.float64], shape: tuple[int, ...]) -> NDArray[np.float64]:
    """Values of shape (..., n), broadcast to the candidates of a shape: (n_candidates, n)."""
    width = values.shape[-1]
    return np.ascontiguousarray(np.broadcast_to(values, (*shape, width)).reshape(-1, width))


def _shots_of(shots: Any) -> tuple[bool, list[_core.Shot]]:
    """Whether the shots are an axis, and the shots."""
    if isinstance(shots, Shot):
        return False, [shots._core]
    if isinstance(shots, str | bytes | Mapping) or not isinstance(shots, Iterable):
        raise InputError(
            "wrong-type",
            "shots",
            f"found a {type(shots).__name__}",
            "give a carom.Shot or a list of them",
        )
    return True, [
        core(f"shots[{index}]", shot, _core.Shot, "carom.Shot.from_dict(...)")
        for index, shot in enumerate(shots)
    ]


def _strikes(
    strike: Mapping[str, ArrayLike] | None, shots: list[_core.Shot], *, several: bool
) -> tuple[NDArray[np.float64] | None, bool]:
    """Speed, azimuth, elevation, side, height: (..., 5); and whether elevations are the shots'."""
    if strike is None:
        return None, False
    if not isinstance(strike, Mapping):
        _core.wrong_type(strike, "strike", '{"speed": [1.0, 2.0]}')
    _core.check_keys(strike, "strike", list(_STRIKE))
    for index, shot in enumerate(shots):
        if shot.strike is None:
            place = f"shots[{index}].strike" if several else "strike"
            raise InputError("no-strike", place, "the shot has no strike to vary", "give it one")
    given: dict[str, Any] = {
        name: angles(f"strike.{name}", strike.get(name), strike.get(f"{name}_deg"))
        for name in ("azimuth", "elevation")
    }
    for name in ("speed", "side", "height"):
        value = strike.get(name)
        given[name] = None if value is None else array(f"strike.{name}", value)
    own = np.array([shot.strike for shot in shots]).reshape(-1, len(VARIABLES))
    columns = []
    for column, name in enumerate(VARIABLES):
        kept = own[:, column] if several else own[0, column]
        columns.append(np.asarray(kept if given[name] is None else given[name], dtype=np.float64))
    shape = broadcast(
        {f"strike.{name}": column.shape for name, column in zip(VARIABLES, columns, strict=True)}
    )
    struck = np.stack([np.broadcast_to(column, shape) for column in columns], axis=-1)
    return struck, given["elevation"] is None


def _numbers(physics: Mapping[str, ArrayLike] | None) -> dict[str, NDArray[np.float64]]:
    """The values of the physics that differ, by key."""
    if physics is None:
        return {}
    if not isinstance(physics, Mapping):
        _core.wrong_type(physics, "physics", '{"cloth.sliding_friction": [0.17, 0.18]}')
    return {str(key): array(f"physics.{key}", values) for key, values in physics.items()}


def _states(
    given: tuple[ArrayLike | None, ArrayLike | None, ArrayLike | None],
    shots: list[_core.Shot],
    *,
    several: bool,
) -> dict[str, NDArray[np.float64]] | None:
    """The parts of the start states, each (..., n_balls, 3); None if all are the shots' own."""
    if all(part is None for part in given):
        return None
    counts = {len(shot) for shot in shots}
    if len(counts) != 1:
        raise InputError(
            "wrong-count",
            next(name for name, part in zip(_PARTS, given, strict=True) if part is not None),
            f"the shots have {', '.join(map(str, sorted(counts)))} balls",
            "make candidates of the shots of each number of balls",
        )
    (balls,) = counts
    own = [np.array(part) for part in zip(*map(_core.start_states, shots), strict=True)]
    found = {}
    for name, part, every in zip(_PARTS, given, own, strict=True):
        kept = every if several else every[0]
        found[name] = kept if part is None else _vectors(name, part, kept, balls)
    return found


def _vectors(
    name: str, value: ArrayLike, own: NDArray[np.float64], balls: int
) -> NDArray[np.float64]:
    """A vector for each ball, (..., n_balls, 3); without a third component it is the shot's own."""
    found = array(name, value)
    widths = (3,) if name == "angular_velocity" else (2, 3)
    if found.ndim < 2 or found.shape[-2] != balls or found.shape[-1] not in widths:
        wanted = " or ".join(f"(..., {balls}, {width})" for width in widths)
        raise InputError(
            "wrong-count",
            name,
            f"found the shape {found.shape}",
            f"give an array of shape {wanted}",
        )
    if found.shape[-1] == 3:
        return found
    shape = np.broadcast_shapes(found.shape[:-1], own.shape[:-1])
    flat = np.broadcast_to(found, (*shape, 2))
    height = np.broadcast_to(own[..., 2:], (*shape, 1))
    return np.concatenate([flat, height], axis=-1)

"""Which strike to play: searched everywhere, refined, ranked by its chance under noise."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from carom import _core
from carom.arguments import instance, number, numbers, text, thread_count, whole
from carom.batch import VARIABLES, progress_bar
from carom.errors import InputError
from carom.noise import Noise, Perception
from carom.plan import Chance, ball_and_pocket, errs

if TYPE_CHECKING:
    from carom.shot import Shot

# Beyond these nobody waits for the answer.
_MOST_SAMPLES = 10**7
_MOST_VARIANTS = 10**7
_MOST_WANTED = 10_000


@dataclass(frozen=True, slots=True)
class Solution:
    """A strike that does what is wanted when it is hit exactly.

    Attributes:
        shot: The shot with this strike: the very one that was judged, ready to simulate.
        speed: The cue's speed, m/s.
        azimuth: The cue's direction, rad.
        elevation: Butt raised above horizontal, rad.
        side: Contact point right of centre, ball radii.
        height: Contact point above centre, ball radii.
        kind: What players call the way: ``direct``, or those of ``jump``, ``massé``, ``kick``,
            ``carom``, ``combination``, ``kiss``, ``bank`` that apply, joined by ``+``.
        way: Its steps in words: rails and balls from the cue on, and which resting balls it leads
            over (``jump``) or on a curve around (``massé``).
        cue_ball_end: Where it leaves the cue ball, m.
        chance: How likely it does what is wanted under the noise.
    """

    shot: Shot
    speed: float
    azimuth: float
    elevation: float
    side: float
    height: float
    kind: str
    way: str
    cue_ball_end: tuple[float, float]
    chance: Chance

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        return {
            "kind": self.kind,
            "way": self.way,
            "chance": float(self.chance),
            "low": self.chance.low,
            "high": self.chance.high,
            "cue_ball_end": list(self.cue_ball_end),
            "strike": self.shot.to_dict()["strike"],
        }

    def __str__(self) -> str:
        return (
            f"{self.chance}  {self.kind}: {self.way or '-'}; {self.speed:.2f} m/s, "
            f"azimuth {math.degrees(self.azimuth) % 360:.2f}°, side {signed(self.side)}, "
            f"height {signed(self.height)}, elevation {math.degrees(self.elevation):.1f}°"
        )


def solve(
    shot: Shot,
    *,
    pot: str | tuple[str, str] | None,
    leave: tuple[Sequence[float], float] | None,
    first: str | None,
    noise: Noise | None,
    perception: Perception | None,
    wanted: int,
    of_a_way: int,
    n: int,
    precision: float | None,
    speed: tuple[float, float],
    offset: float,
    elevation: float | None,
    samples: int,
    seed: int,
    level: float,
    threads: int | None,
    progress: bool,
) -> list[Solution]:
    """``Shot.solve``."""
    n = whole("n", n, _MOST_VARIANTS + 1, low=1)
    sampling = errs(noise, perception, seed, n, precision, level)
    counts = (
        whole("samples", samples, _MOST_SAMPLES + 1),
        whole("wanted", wanted, _MOST_WANTED + 1, low=1),
        whole("of_a_way", of_a_way, _MOST_WANTED + 1, low=1),
    )
    with _stages(show=progress) as tell:
        found = _core.solve(
            shot._core,
            None if pot is None else target(shot, pot),
            None if leave is None else _disc(leave),
            None if first is None else ball_index(shot, first),
            (
                (*numbers("speed", speed, 2), number("offset", offset)),
                None if elevation is None else number("elevation", elevation),
            ),
            counts,
            sampling,
            thread_count(threads),
            tell,
        )
    return [_solution(shot, row) for row in found]


def signed(offset: float) -> str:
    """With its sign, to a hundredth; what is rounded to nothing has a plus."""
    return f"{round(offset, 2) + 0.0:+.2f}"


@contextmanager
def _stages(*, show: bool) -> Iterator[Callable[[str, int, int], None]]:
    """A bar on stderr for each stage of a search."""
    with ExitStack() as bars:
        told: dict[str, tuple[Callable[[int], object], int]] = {}

        def tell(stage: str, done: int, count: int) -> None:
            if stage not in told:
                bars.close()
                bar = progress_bar(count, show=show, what=f"{stage} strikes")
                told[stage] = bars.enter_context(bar), 0
            advance, before = told[stage]
            advance(done - before)
            told[stage] = advance, done

        yield tell


def target(shot: Shot, pot: str | tuple[str, str]) -> tuple[int, int | None]:
    """Ball and pocket by index; no pocket where any will do.

    Raises:
        InputError: There is no such ball or pocket.
    """
    ball, pocket = ball_and_pocket("pot", pot)
    return ball_index(shot, ball), None if pocket is None else pocket_index(shot, pocket)


def ball_index(shot: Shot, ball: str) -> int:
    """The place of a ball in the shot.

    Raises:
        InputError: There is no such ball.
    """
    ids = a_shot(shot).ids
    if text("ball", ball, "its id") not in ids:
        raise InputError(f"ball: there is no {ball!r}; there are: {', '.join(ids)}")
    return ids.index(ball)


def a_shot(shot: Any) -> Shot:
    """``shot``, if it is one.

    Raises:
        InputError: It is something else.
    """
    from carom.shot import Shot

    return instance("shot", shot, Shot, "carom.Shot.from_dict(...)")


def pocket_index(shot: Shot, pocket: str) -> int:
    """The place of a pocket in the table's list.

    Raises:
        InputError: There is no such pocket.
    """
    names = [p["name"] for p in a_shot(shot).geometry()["pockets"]]
    if text("pocket", pocket, "its name") not in names:
        known = ", ".join(names) or "none on this table"
        raise InputError(f"pocket: there is no {pocket!r}; there are: {known}")
    return names.index(pocket)


def _disc(leave: tuple[Sequence[float], float]) -> tuple[tuple[float, float], float]:
    try:
        center, radius = leave
    except (TypeError, ValueError):
        raise InputError(f"leave: {leave!r} is no disc; give ((x, y), radius) in m") from None
    x, y = numbers("leave[0]", center, 2)
    return (x, y), number("leave[1]", radius)


def _solution(shot: Shot, row: Any) -> Solution:
    strike, kind, way, end, met, variants, (low, high) = row
    named = dict(zip(VARIABLES, strike, strict=True))
    return Solution(
        shot=shot.with_strike(**named),
        **named,
        kind=kind,
        way=way,
        cue_ball_end=(end[0], end[1]),
        chance=Chance(met, variants, low, high),
    )

"""Strikes that reach a goal: searched, refined, and ranked by their chance under noise."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from carom import _core
from carom.arguments import angles, number, numbers, thread_count, warn_of_degrees, whole
from carom.batch import VARIABLES
from carom.deprecated import renamed_arguments, renamed_attribute
from carom.errors import InputError
from carom.noise import Noise, Perception
from carom.plan.chance import Chance
from carom.plan.drawn_tables import on_drawn_tables
from carom.plan.lookup import ball_index, core_of, target
from carom.plan.options import Goal, Sampling, Search
from carom.progress import stage_bars

if TYPE_CHECKING:
    import carom
    from carom.plan.drawn_tables import TablePosterior


@dataclass(frozen=True, slots=True)
class Solution:
    """A strike that reaches the goal when it is hit exactly.

    Under a noise with a mean error it is the strike to intend: it reaches the goal when it is hit
    with that error alone.

    Attributes:
        shot: The shot with this strike, ready to simulate.
        speed: The cue's speed, m/s.
        azimuth: The cue's direction, rad.
        elevation: Butt raised above horizontal, rad.
        side: Contact point right of centre, ball radii.
        height: Contact point above centre, ball radii.
        kind: The players' name for the route: ``direct``, or those of ``jump``, ``massé``,
            ``kick``, ``carom``, ``combination``, ``kiss`` and ``bank`` that apply, joined by
            ``+``.
        route: The rails and balls from the cue to the target, in words. ``over`` and ``around``
            name resting balls that a ball jumps over or curves around.
        cue_ball_end: Where the cue ball ends, m.
        chance: The chance that the goal is reached under the noise; with a posterior, over the
            drawn tables.
    """

    shot: carom.Shot
    speed: float
    azimuth: float
    elevation: float
    side: float
    height: float
    kind: str
    route: str
    cue_ball_end: tuple[float, float]
    chance: Chance

    way = renamed_attribute("way", "route")

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON; ``way`` is the old name of ``route``."""
        return {
            "kind": self.kind,
            "route": self.route,
            "way": self.route,
            "chance": float(self.chance),
            "low": self.chance.low,
            "high": self.chance.high,
            **({"spread": self.chance.spread} if self.chance.by_table else {}),
            "cue_ball_end": list(self.cue_ball_end),
            "strike": self.shot.to_dict()["strike"],
        }

    def __str__(self) -> str:
        return (
            f"{self.chance}  {self.kind}: {self.route or '-'}; {self.speed:.2f} m/s, "
            f"azimuth {math.degrees(self.azimuth) % 360:.2f}°, side {signed(self.side)}, "
            f"height {signed(self.height)}, elevation {math.degrees(self.elevation):.1f}°"
        )


@renamed_arguments(of_a_way="per_route")
def solve(
    shot: carom.Shot,
    *,
    pot: str | tuple[str, str] | None = None,
    leave: tuple[Sequence[float], float] | None = None,
    first: str | None = None,
    noise: Noise | None = None,
    perception: Perception | None = None,
    wanted: int = 10,
    per_route: int = 3,
    n: int = 1000,
    precision: float | None = None,
    speed: tuple[float, float] = (0.5, 7.0),
    offset: float = 0.45,
    elevation: float | tuple[float, float] | None = None,
    azimuth: tuple[float, float] | None = None,
    azimuth_deg: tuple[float, float] | None = None,
    butt: tuple[Sequence[float], Sequence[float]] | None = None,
    samples: int = 4096,
    posterior: TablePosterior | None = None,
    draws: int = 32,
    seed: int = 0,
    level: float = 0.95,
    threads: int | None = None,
    progress: bool = False,
) -> list[Solution]:
    """The strikes that reach a goal, the most probable first.

    The goal consists of ``pot``, ``leave`` and ``first``. All that are given must be reached, and
    the cue ball must stay on the table. The search plays every direction that geometry proposes
    (ghost balls, mirror images, the sides of other balls) and strikes spread over the whole range.
    On every route it refines the best strikes until they reach the goal exactly, and ranks them by
    their chance. Of the shot's own strike it uses only the struck ball and the elevation; if the
    shot omits it, every strike has its own default elevation. It raises the cue over obstacles, and
    with ``elevation`` also to jump over balls or to curve around them.

    Args:
        shot: Table, balls and the struck ball.
        pot: A ball that falls, or ``(ball, pocket)``.
        leave: ``((x, y), radius)``: the cue ball comes to rest with its centre in this disc, m.
        first: The ball that the cue ball touches before any other.
        noise: Errors of the strike, for the ranking; the Olympiad's if None.
        perception: Errors of the perceived positions, for the ranking.
        wanted: Largest number of strikes.
        per_route: Largest number of them over the same cushions and balls.
        n: Largest number of variants behind each chance.
        precision: Stop counting a chance when half the width of its interval is at most this;
            checked after every 128 variants. None plays all ``n``.
        speed: Least and greatest speed of the cue, m/s.
        offset: Largest tip offset, ball radii; at most 95 % of the miscue limit is used.
        elevation: Largest elevation, rad, for jumps and massés, which are tried in addition to
            strikes at the shot's elevation. None tries only the latter. A pair, the least and the
            greatest, is a limit of every strike: one that would be lower is raised.
        azimuth: First and last azimuth, rad, counter-clockwise, to which the cue can turn:
            ``(-0.2, 0.2)`` and ``(6.08, 0.2)`` are the same range. None is every azimuth.
        azimuth_deg: The same in degrees, in place of ``azimuth``.
        butt: Two opposite corners ``((x, y), (x, y))`` of the rectangle, m, in which the end of the
            butt must be, 1.47 m behind the tip (``Shot.cue_pose``). None has no limit.
        samples: Number of strikes spread over the whole range.
        posterior: What is known about the table, as in ``Shot.evaluate``. The search
            plans on the learned table in place of the shot's; the strikes are ranked by their
            chances over the drawn tables.
        draws: Number of tables that may be the true one, from 2 to 1000.
        seed: Seed of the random numbers.
        level: Confidence level of the intervals, in (0, 1).
        threads: Number of threads; None is one per core. The result does not depend on it.
        progress: Show a progress bar on stderr.

    Raises:
        InputError: The goal is empty, there is no such ball or pocket, the shot has no strike, a
            number is out of range or is not a range, or balls have no room on most drawn tables.
    """
    core_of(shot)
    degrees = None if azimuth_deg is None else numbers("azimuth_deg", azimuth_deg, 2)
    turns = angles("azimuth", azimuth, degrees)
    if degrees is None:
        warn_of_degrees("azimuth", turns)
    goal = Goal(
        None if pot is None else target(shot, pot),
        None if leave is None else _disc(leave),
        None if first is None else ball_index(shot, first),
    )
    reach: tuple[float, ...] | None = None
    highest: float | None = None
    if elevation is None or isinstance(elevation, int | float):
        highest = elevation
    else:
        reach = numbers("elevation", elevation, 2)
        highest = reach[1]
    search = Search(
        speed,
        offset,
        highest,
        samples,
        wanted,
        per_route,
        azimuth_reach=turns,
        elevation_reach=reach,
        butt=butt,
    )
    sampling = Sampling(noise, perception, seed, whole("n", n, low=1), precision, level)
    shot, tables = on_drawn_tables(shot, posterior, draws, sampling.n, sampling.seed)
    with stage_bars([f"{name} strikes" for name in _core.stages()], show=progress) as report:
        found = _core.solve(
            core_of(shot), goal, search, sampling, tables, thread_count(threads), report
        )
    return [_solution(shot, fields) for fields in found]


def signed(offset: float) -> str:
    """A tip offset with its sign, to a hundredth; zero has a plus."""
    return f"{round(offset, 2) + 0.0:+.2f}"


def _disc(leave: tuple[Sequence[float], float]) -> tuple[tuple[float, float], float]:
    try:
        center, radius = leave
    except (TypeError, ValueError):
        raise InputError(
            "wrong-type", "leave", f"{leave!r} is not a disc", "give ((x, y), radius) in m"
        ) from None
    x, y = numbers("leave[0]", center, 2)
    return (x, y), number("leave[1]", radius)


def _solution(shot: carom.Shot, fields: dict[str, Any]) -> Solution:
    strike = dict(zip(VARIABLES, fields["strike"], strict=True))
    x, y = fields["cue_ball_end"]
    return Solution(
        shot=shot.with_strike(**strike),
        **strike,
        kind=fields["kind"],
        route=fields["route"],
        cue_ball_end=(x, y),
        chance=Chance(
            fields["met"],
            fields["variants"],
            fields["low"],
            fields["high"],
            tuple(fields["by_table"]),
        ),
    )

"""Questions about a shot: what are the chances when a player means this strike?"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import astuple, dataclass
from typing import TYPE_CHECKING, Any

from carom import _core
from carom.arguments import instance, number, text, thread_count, whole
from carom.batch import progress_bar
from carom.errors import InputError
from carom.noise import Noise, Perception, position_of, sigmas_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from carom.rules import Call, Frame
    from carom.shot import Shot

# Most variants of one question: beyond it no interval gets shorter that anyone could use.
_MOST = 10**9


@dataclass(frozen=True, slots=True)
class Chance:
    """A probability that was counted, with its confidence interval.

    Attributes:
        count: How often it happened,
        trials: of how many times.
        low: Lower end of the Wilson interval,
        high: and its upper end.
    """

    count: int
    trials: int
    low: float
    high: float

    @property
    def probability(self) -> float:
        """The share of the trials in which it happened; NaN without trials."""
        return self.count / self.trials if self.trials else float("nan")

    @property
    def half_width(self) -> float:
        """Half the interval's width."""
        return (self.high - self.low) / 2

    def __float__(self) -> float:
        return self.probability

    def __str__(self) -> str:
        return f"{100 * self.probability:.1f} % ({100 * self.low:.1f} to {100 * self.high:.1f})"

    @classmethod
    def of(cls, count: int, trials: int, level: float) -> Chance:
        """The chance of what happened ``count`` times, at a confidence ``level``."""
        return cls(count, trials, *_core.wilson(count, trials, level))


@dataclass(frozen=True, slots=True, eq=False)
class Evaluation:
    """What came of a shot's variants; ``print`` it for a table.

    Attributes:
        shot: The shot as it was meant.
        noise: How far its strike strayed.
        perception: How far from where they were seen the balls lay.
        seed: Which random numbers.
        n: Variants played.
        level: Confidence of all intervals.
        pockets: The pockets' names; columns of ``potted``.
        potted: How often each ball fell into each pocket, int64 of shape (n_balls, n_pockets).
        off_table: How often each ball left the table, int64 of shape (n_balls,).
        failed: Variants that could not be played, such as miscues; nothing falls in them.
        first_failure: Why the first of them could not; None without.
        legal_count: How often the shot was legal; None without a frame.
        turn_kept_count: How often the player shoots again or has won; None without a frame.
        at_rest: How often each ball came to rest on the table, int64 of shape (n_balls,).
        end_mean: Where it then lies on average, m, shape (n_balls, 2).
        end_covariance: Covariance of that, m², shape (n_balls, 2, 2).
        cue_ball: Index of the cue ball.
        cue_ball_ends: Where the cue ball came to rest in each variant, m, shape (n, 2); NaN where
            it fell, left the table, or the variant failed.
    """

    shot: Shot
    noise: Noise
    perception: Perception
    seed: int
    n: int
    level: float
    pockets: tuple[str, ...]
    potted: NDArray[np.int64]
    off_table: NDArray[np.int64]
    failed: int
    first_failure: str | None
    legal_count: int | None
    turn_kept_count: int | None
    at_rest: NDArray[np.int64]
    end_mean: NDArray[np.float64]
    end_covariance: NDArray[np.float64]
    cue_ball: int
    cue_ball_ends: NDArray[np.float64]

    def chance(self, count: int) -> Chance:
        """The chance of something that happened in ``count`` of the variants."""
        return Chance.of(int(count), self.n, self.level)

    def pot(self, ball: str) -> Chance:
        """The chance that a ball falls, into whichever pocket.

        Raises:
            InputError: There is no such ball.
        """
        return self.chance(self.potted[self._ball(ball)].sum())

    def pocket(self, ball: str, pocket: str) -> Chance:
        """The chance that a ball falls into that pocket.

        Raises:
            InputError: There is no such ball or pocket.
        """
        if pocket not in self.pockets:
            known = ", ".join(self.pockets) or "none on this table"
            raise InputError(f"pocket: there is no {pocket!r}; there are: {known}")
        return self.chance(self.potted[self._ball(ball), self.pockets.index(pocket)])

    def leaves_table(self, ball: str) -> Chance:
        """The chance that a ball leaves the table.

        Raises:
            InputError: There is no such ball.
        """
        return self.chance(self.off_table[self._ball(ball)])

    @property
    def scratch(self) -> Chance:
        """The chance that the cue ball falls."""
        return self.chance(self.potted[self.cue_ball].sum())

    @property
    def failure(self) -> Chance:
        """The chance that the strike cannot be played, such as a miscue."""
        return self.chance(self.failed)

    @property
    def legal(self) -> Chance | None:
        """The chance that the shot is legal; None without a frame."""
        return None if self.legal_count is None else self.chance(self.legal_count)

    @property
    def turn_kept(self) -> Chance | None:
        """The chance that the player shoots again or has won; None without a frame."""
        return None if self.turn_kept_count is None else self.chance(self.turn_kept_count)

    def chances(self) -> dict[str, Chance]:
        """All that happened at least once, in words, and what is always of interest."""
        ids = self.shot.ids
        said: dict[str, Chance] = {}
        for row, ball in enumerate(ids):
            if row == self.cue_ball:
                continue
            if self.potted[row].any():
                said[f"{ball} falls"] = self.pot(ball)
            for column, pocket in enumerate(self.pockets):
                if self.potted[row, column]:
                    said[f"{ball} into {pocket}"] = self.chance(self.potted[row, column])
        if self.pockets:
            said["scratch"] = self.scratch
        for row, ball in enumerate(ids):
            if self.off_table[row]:
                said[f"{ball} off the table"] = self.chance(self.off_table[row])
        if self.legal is not None and self.turn_kept is not None:
            said |= {"legal": self.legal, "turn kept": self.turn_kept}
        if self.failed:
            said["not to be played"] = self.failure
        return said

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON: without the cue ball's single ends."""
        return {
            "n": self.n,
            "seed": self.seed,
            "level": self.level,
            "noise": dict(zip(_SIGMAS, astuple(self.noise), strict=True)),
            "perception": {"position": self.perception.position},
            "balls": self.shot.ids,
            "pockets": list(self.pockets),
            "potted": self.potted.tolist(),
            "off_table": self.off_table.tolist(),
            "failed": self.failed,
            "first_failure": self.first_failure,
            "legal": self.legal_count,
            "turn_kept": self.turn_kept_count,
            "at_rest": self.at_rest.tolist(),
            "end_mean": or_null(self.end_mean.tolist()),
            "end_covariance": or_null(self.end_covariance.tolist()),
            "chances": {
                what: {"probability": float(c), "low": c.low, "high": c.high}
                for what, c in self.chances().items()
            },
        }

    def __str__(self) -> str:
        rows = [(what, str(chance)) for what, chance in self.chances().items()]
        x, y = self.end_mean[self.cue_ball]
        if self.at_rest[self.cue_ball] > 1:
            spread = [float(v) ** 0.5 for v in self.end_covariance[self.cue_ball].diagonal()]
            place = f"{x:.3f} ± {spread[0]:.3f}, {y:.3f} ± {spread[1]:.3f} m"
            rows.append((f"{self.shot.ids[self.cue_ball]} ends at", place))
        width = max(len(what) for what, _ in rows) if rows else 0
        title = f"{self.n} variants; intervals hold {100 * self.level:g} %"
        return "\n".join([title, *(f"  {what:<{width}}  {value}" for what, value in rows)])

    def __repr__(self) -> str:
        return f"<carom.Evaluation: {self.n} variants of {self.shot!r}>"

    def _ball(self, ball: str) -> int:
        ids = self.shot.ids
        if ball not in ids:
            raise InputError(f"ball: there is no {ball!r}; there are: {', '.join(ids)}")
        return ids.index(ball)


_SIGMAS = ("speed", "azimuth", "elevation", "side", "height")


def evaluate(
    shot: Shot,
    noise: Noise,
    n: int,
    *,
    perception: Perception | None,
    seed: int,
    precision: float | None,
    watch: str | tuple[str, str] | None,
    frame: Frame | None,
    call: Call | None,
    level: float,
    threads: int | None,
    progress: bool,
) -> Evaluation:
    """``Shot.evaluate``."""
    sigmas, position = sigmas_of(noise), position_of(perception)
    seed, n = whole("seed", seed), whole("n", n, _MOST + 1)
    wanted = None
    if precision is not None:
        pair = None if watch is None else ball_and_pocket("watch", watch)
        wanted = (number("precision", precision), pair)
    elif watch is not None:
        raise InputError("watch: nothing is to be watched without a precision; give one too")
    referee = _referee(frame, call)
    with so_far(n, show=progress) as tell:
        found = _core.evaluate(
            shot._core,
            sigmas,
            position,
            seed,
            n,
            number("level", level),
            wanted,
            referee,
            thread_count(threads),
            tell,
        )
    pockets = tuple(pocket["name"] for pocket in shot.geometry()["pockets"])
    return Evaluation(
        shot=shot,
        noise=noise,
        perception=Perception(position),
        seed=seed,
        level=float(level),
        pockets=pockets,
        **found,
    )


def _referee(
    frame: Frame | None, call: Call | None
) -> tuple[_core.Frame, tuple[str, str | None, str | None]] | None:
    """The frame that rules, and what is announced to it."""
    from carom.rules import Frame, said

    if frame is None:
        if call is not None:
            raise InputError("call: there is no game to announce it in; give its frame too")
        return None
    return instance("frame", frame, Frame, "carom.Frame.of_shot(...)")._core, said(call)


def ball_and_pocket(name: str, value: Any) -> tuple[str, str | None]:
    """A ball's id, and a pocket's name where one is given."""
    if isinstance(value, tuple | list) and len(value) == 2:
        ball, pocket = value
        return text(f"{name}[0]", ball, "a ball's id"), text(
            f"{name}[1]", pocket, "a pocket's name"
        )
    return text(name, value, "a ball's id, or give (ball, pocket)"), None


@contextmanager
def so_far(count: int, *, show: bool, what: str = "shots") -> Iterator[Callable[[int], None]]:
    """A bar on stderr; what it yields is told how many are done."""
    with progress_bar(count, show=show, what=what) as advance:
        told = 0

        def tell(done: int) -> None:
            nonlocal told
            advance(done - told)
            told = done

        yield tell


def errs(
    noise: Noise | None,
    perception: Perception | None,
    seed: int,
    n: int,
    precision: float | None,
    level: float,
) -> tuple[tuple[float, ...], float, int, int, float | None, float]:
    """How a player errs and how well a chance is to be known, as Rust takes it."""
    half_width = None if precision is None else number("precision", precision)
    return (
        sigmas_of(noise),
        position_of(perception),
        whole("seed", seed),
        n,
        half_width,
        number("level", level),
    )


def or_null(value: Any) -> Any:
    """The same with None for NaN, which JSON has not."""
    if isinstance(value, list):
        return [or_null(item) for item in value]
    return None if isinstance(value, float) and math.isnan(value) else value

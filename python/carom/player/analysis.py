"""The best plays of a position, with their chances."""

from __future__ import annotations

import math
from dataclasses import dataclass
from html import escape
from typing import Any, Self

from carom import columns
from carom.carom_route import CaromRoute
from carom.plan import Evaluation
from carom.plan.chance import Chance, chances_to_dict, or_null
from carom.player import words
from carom.player.decision import Play
from carom.player.thinking import Thinking
from carom.rules import Frame
from carom.shot import Shot

# Kinds of play that are named with the first ball of the play without errors.
_OFF_A_BALL = ("safety",)
# Confidence level of the chances.
_LEVEL = 0.95


@dataclass(frozen=True, slots=True)
class Leave:
    """Where the cue ball comes to rest under the player's errors.

    Attributes:
        count: Number of samples in which it stayed on the table.
        mean: Mean place (x, y), m; NaN without samples.
        covariance: Covariance of the place, m², as rows; NaN for fewer than two samples.
    """

    count: int
    mean: tuple[float, float]
    covariance: tuple[tuple[float, float], tuple[float, float]]

    @classmethod
    def _read(cls, fields: dict[str, Any]) -> Self:
        """The place from its values in Rust."""
        x, y = fields["mean"]
        (xx, xy), (yx, yy) = fields["covariance"]
        return cls(fields["count"], (x, y), ((xx, xy), (yx, yy)))

    @classmethod
    def of(cls, found: Evaluation) -> Self:
        """The place of the cue ball in the variants of an evaluation."""
        ball = found.cue_ball
        (xx, xy), (yx, yy) = found.end_covariance[ball].tolist()
        x, y = found.end_mean[ball].tolist()
        return cls(int(found.at_rest[ball]), (x, y), ((xx, xy), (yx, yy)))

    @property
    def spread(self) -> float:
        """Root mean square distance from the mean place, m; NaN for fewer than two samples."""
        return math.sqrt(self.covariance[0][0] + self.covariance[1][1])

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        covariance = [list(row) for row in self.covariance]
        return {
            "count": self.count,
            "mean": or_null(list(self.mean)),
            "covariance": or_null(covariance),
            "spread": or_null(self.spread),
        }

    def __str__(self) -> str:
        if not self.count:
            return "not on the table"
        spread = f" ± {self.spread:.2f}" if self.count > 1 else ""
        return f"{words.place(self.mean)}{spread} m"


@dataclass(frozen=True, slots=True)
class Recommendation:
    """One of the best plays, with its chances.

    All chances are counted with errors of the strike that took no part in the choice.

    Attributes:
        play: The play, as it is intended.
        shot: The shot of the play without errors, ready to simulate.
        kind: What the strike does without errors: ``direct``, ``bank``, ``kick`` or
            ``combination`` for a pot, and ``indirect`` for one on another way, such as off a
            further ball; ``safety``, ``carom``, ``break`` or ``push-out``.
        legs: The balls on the way to the pocket, the cue ball first, each with the number of
            cushions that it meets; empty for an indirect pot and without a pot.
        route: The route of a carom without errors; None for another play. The caroms of an
            analysis have one pattern each.
        ball: The ball that is to fall; None if none is.
        pocket: The pocket it is to fall into; None if none is.
        win_chance: The estimated probability that the player wins the frame.
        error: Standard error of ``win_chance``, from the samples and the drawn tables alone.
        kept: The chance that the player has the turn again or has won.
        foul: The chance of a foul.
        win_if_kept: ``win_chance`` over the samples in which the turn is kept; None without such.
        win_if_missed: The same over the other samples.
        leave: Where the cue ball comes to rest.
    """

    play: Play
    shot: Shot
    kind: str
    legs: tuple[tuple[str, int], ...]
    route: CaromRoute | None
    ball: str | None
    pocket: str | None
    win_chance: float
    error: float
    kept: Chance
    foul: Chance
    win_if_kept: float | None
    win_if_missed: float | None
    leave: Leave

    @classmethod
    def _read(cls, fields: dict[str, Any], frame: Frame) -> Self:
        """The play from its values in Rust."""
        play = Play._read(fields["play"])
        ball, pocket = fields["pot"] or (None, None)
        return cls(
            play=play,
            shot=play.shot(frame),
            kind=fields["kind"],
            legs=tuple((ball, cushions) for ball, cushions in fields["legs"]),
            route=CaromRoute._read(fields["route"]),
            ball=ball,
            pocket=pocket,
            win_chance=fields["win"],
            error=fields["error"],
            kept=_chance(fields["kept"]),
            foul=_chance(fields["foul"]),
            win_if_kept=fields["win_if_kept"],
            win_if_missed=fields["win_if_missed"],
            leave=Leave._read(fields["leave"]),
        )

    @property
    def aim(self) -> str:
        """What is played, in words, such as ``bank: 3 off 1 cushion into top-left``."""
        if self.route is not None:
            return f"{self.route.name}: {self.route}"
        if self.ball is None or self.pocket is None:
            return f"{self.kind}{self._off_ball()}" if self.kind in _OFF_A_BALL else self.kind
        return words.pot(self.kind, self.ball, self.pocket, self.legs)

    def _off_ball(self) -> str:
        first = self.shot.simulate().outcome.first_contact
        return "" if first is None else f" off {first}"

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        chances = {"kept": self.kept, "foul": self.foul}
        return {
            "aim": self.aim,
            "kind": self.kind,
            "ball": self.ball,
            "pocket": self.pocket,
            "legs": [list(leg) for leg in self.legs],
            "route": self.route,
            "play": self.play.to_dict(),
            "win_chance": self.win_chance,
            "error": self.error,
            "samples": self.kept.trials,
            **chances_to_dict(chances),
            "win_if_kept": self.win_if_kept,
            "win_if_missed": self.win_if_missed,
            "leave": self.leave.to_dict(),
        }

    def __str__(self) -> str:
        strike = self.play.strike
        how = words.strike(strike.speed, strike.side, strike.height, strike.elevation or 0.0)
        place = self.play.cue_ball
        system = self.route and self.route.system
        return (
            f"{self.aim}, {how}"
            + (f"; {system}" if system else "")
            + ("" if place is None else f", cue ball at {words.place(place)} m")
        )


def _chance(counted: tuple[int, int]) -> Chance:
    met, samples = counted
    return Chance.of(met, samples, _LEVEL)


_HEADINGS = ("", "win", "turn kept", "foul", "if kept", "if missed", "cue ball left at", "play")
# Columns of numbers, which are aligned to the right.
_RIGHT = range(6)


@dataclass(frozen=True, slots=True)
class Analysis:
    """The best plays of a position, the best first; ``print`` it for a table.

    Attributes:
        frame: The frame, before the play.
        plays: The plays.
        thinking: The errors, the seed and the budget of the search.
        simulations: Number of simulated shots.
        rounds: Number of rounds of the search.
        interrupted: Whether Ctrl-C or ``Player.stop`` ended the search.
    """

    frame: Frame
    plays: tuple[Recommendation, ...]
    thinking: Thinking
    simulations: int
    rounds: int
    interrupted: bool

    @classmethod
    def _read(cls, fields: dict[str, Any], frame: Frame, thinking: Thinking) -> Self:
        """The analysis from its values in Rust; ``frame`` is not changed afterwards."""
        plays = tuple(Recommendation._read(play, frame) for play in fields["plays"])
        return cls(**{**fields, "plays": plays}, frame=frame, thinking=thinking)

    @property
    def best(self) -> Recommendation | None:
        """The best play; None if none was found."""
        return self.plays[0] if self.plays else None

    @property
    def title(self) -> str:
        """The game, the player who is to shoot, and what the search has cost."""
        many = f"{self.simulations:,}".replace(",", " ")
        spent = f"{many} simulated shots in {self.rounds} round{'s' * (self.rounds != 1)}"
        stopped = ", interrupted" if self.interrupted else ""
        return f"{self.frame.game}, player {self.frame.player} to shoot; {spent}{stopped}"

    def rows(self) -> list[tuple[str, ...]]:
        """The table's rows as text: number, chances, where the cue ball is left, and the play."""
        return [
            (
                str(index + 1),
                f"{100 * play.win_chance:.1f} ± {100 * play.error:.1f} %",
                words.percent(float(play.kept)),
                words.percent(float(play.foul)),
                words.percent(play.win_if_kept),
                words.percent(play.win_if_missed),
                str(play.leave),
                str(play),
            )
            for index, play in enumerate(self.plays)
        ]

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        return {
            "game": self.frame.game,
            "player": self.frame.player,
            "thinking": self.thinking.to_dict(),
            "simulations": self.simulations,
            "rounds": self.rounds,
            "interrupted": self.interrupted,
            "plays": [play.to_dict() for play in self.plays],
        }

    def __str__(self) -> str:
        table = columns.lines([_HEADINGS, *self.rows()], right_aligned=_RIGHT)
        return "\n".join([self.title, *table])

    def _repr_html_(self) -> str:
        """The table, for notebooks."""

        def line(row: tuple[str, ...], tag: str) -> str:
            return "<tr>" + "".join(f"<{tag}>{escape(cell)}</{tag}>" for cell in row) + "</tr>"

        body = "".join(line(row, "td") for row in self.rows())
        head = line(_HEADINGS, "th")
        caption = f"<caption>{escape(self.title)}</caption>"
        return f"<table>{caption}<thead>{head}</thead><tbody>{body}</tbody></table>"

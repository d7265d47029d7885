"""A player's answer to the request of a frame."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Self

from carom.arguments import instance
from carom.batch import VARIABLES
from carom.build import Strike, like
from carom.call import Call
from carom.errors import InputError
from carom.events import Outcome
from carom.noise import Noise
from carom.plan import Solution
from carom.player import words
from carom.request import Request
from carom.rules import Frame, Ruling
from carom.shot import Shot


@dataclass(frozen=True, slots=True)
class Play:
    """A shot as the player intends it: ``frame.play(play.strike, ...)`` has these arguments.

    Attributes:
        strike: The strike of the cue ball, with its elevation.
        cue_ball: Where the cue ball is placed first (x, y in m), if it is in hand.
        call: What the player announces.
    """

    strike: Strike
    cue_ball: tuple[float, float] | None = None
    call: Call | None = None

    @classmethod
    def _read(cls, fields: dict[str, Any]) -> Self:
        """The play from its values in Rust."""
        speed, azimuth, elevation, side, height = fields["strike"]
        kind, ball, pocket = fields["call"]
        x_and_y = fields["cue_ball"]
        return cls(
            strike=like((speed, azimuth, elevation, side, height), {}),
            cue_ball=None if x_and_y is None else (x_and_y[0], x_and_y[1]),
            call=None if kind == "nothing" else Call(kind, ball, pocket),
        )

    @classmethod
    def from_solution(cls, solution: Solution, frame: Frame) -> Self:
        """The play of a solution of ``carom.solve``, with its place of the cue ball and its call.

        Where the frame has calls, the play calls what the solution does without errors: the first
        ball on that falls, or else the first ball that falls, and its pocket; a safety if none
        falls; the first ball that is hit, where a ball on is nominated.

        Args:
            solution: The solution, of a shot with the balls of the frame.
            frame: The frame that requests the shot.

        Raises:
            InputError: The frame does not request a shot, or has not the balls of the solution.
        """
        request = _frame(frame).request
        shot = instance("solution", solution, Solution, "one of carom.solve(...)").shot
        if request.kind != "shot":
            raise InputError("wrong-state", "frame", "it requests no shot", "answer its request")
        if request.cue_ball not in shot.ids:
            raise InputError(
                "mismatch",
                "solution",
                f"its shot has no ball {request.cue_ball!r}",
                "solve a shot of this frame, such as frame.shot(...)",
            )
        balls = {ball["id"]: ball["position"] for ball in shot.to_dict()["balls"]}
        x, y, *_ = balls[request.cue_ball]
        return cls(
            strike=Strike(
                solution.speed,
                solution.azimuth,
                elevation=solution.elevation,
                side=solution.side,
                height=solution.height,
            ),
            cue_ball=(x, y) if request.in_hand else None,
            call=_call_of(shot.simulate().outcome, request),
        )

    def shot(self, frame: Frame) -> Shot:
        """The shot that this play gives in ``frame``, ready to simulate.

        Raises:
            InputError: The frame does not request a shot, or does not allow this play.
        """
        return _frame(frame).shot(self.strike, cue_ball=self.cue_ball, call=self.call)

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON, in the form of a frame's record."""
        strike = {key: getattr(self.strike, key) for key in VARIABLES}
        play = {
            "strike": strike,
            "cue_ball": self.cue_ball and list(self.cue_ball),
            "call": self.call and self.call.to_dict(),
        }
        return {key: value for key, value in play.items() if value}

    def __str__(self) -> str:
        s = self.strike
        parts = [words.strike(s.speed, s.side, s.height, s.elevation or 0.0)]
        if self.call is not None:
            parts.insert(0, _call(self.call))
        if self.cue_ball is not None:
            parts.append(f"cue ball at {words.place(self.cue_ball)} m")
        return ", ".join(parts)


def _call_of(outcome: Outcome, request: Request) -> Call | None:
    """The call of a shot with this outcome."""
    if "on" in request.calls and outcome.first_contact is not None:
        return Call.on(outcome.first_contact)
    fallen = [pair for pair in outcome.pocketed if pair[0] != request.cue_ball]
    if "pocket" in request.calls and fallen:
        return Call.pocket(*next((pair for pair in fallen if pair[0] in request.on), fallen[0]))
    return Call.safety() if "safety" in request.calls else None


def _call(call: Call) -> str:
    """A call in words."""
    if call.kind == "pocket":
        return f"{call.ball} into {call.into}"
    return f"{call.ball} is on" if call.kind == "on" else call.kind


@dataclass(frozen=True, slots=True)
class Decision:
    """A player's decision. ``apply`` gives it to the frame.

    A player of one's own makes ``Decision(carom.Play(strike))``, ``Decision(choice="play-on")``, or
    ``Decision()`` to concede; the other attributes are what a built-in player tells.

    Attributes:
        play: The shot; None if the decision is a choice or a concession.
        choice: The chosen one of ``request.choices``; None if it is a shot or a concession.
        win_chance: The probability with which the player expects to win the frame; None if the
            player does not estimate it.
        simulations: Number of simulated shots of the decision.
        rounds: Number of rounds of the search. A player with ``rounds=`` of this number and
            otherwise the same arguments decides the same, also if a clock or Ctrl-C ended the
            search.
        interrupted: Whether Ctrl-C or ``Player.stop`` ended the search.
    """

    play: Play | None = None
    choice: str | None = None
    win_chance: float | None = None
    simulations: int = 0
    rounds: int = 0
    interrupted: bool = False

    @classmethod
    def _read(cls, fields: dict[str, Any]) -> Self:
        """The decision from its values in Rust."""
        play = fields["play"]
        return cls(**{**fields, "play": None if play is None else Play._read(play)})

    @property
    def concession(self) -> bool:
        """Whether the player gives up the frame."""
        return self.play is None and self.choice is None

    def apply(
        self, frame: Frame, *, noise: Noise | None = None, seed: int | Sequence[int] = 0
    ) -> Ruling:
        """Answer the frame's request: play the shot, choose, or concede.

        Args:
            frame: The frame that the player was asked about.
            noise: Errors of the strike, as for ``Frame.play``; None for the strike as it is meant.
            seed: Seed of the errors; or two, of player 0 and of player 1.

        Raises:
            InputError: The frame does not request this, or does not allow it.
            EventCapError: As for ``Frame.play``.
        """
        frame = _frame(frame)
        if self.play is not None:
            play = self.play
            return frame.play(
                play.strike, cue_ball=play.cue_ball, call=play.call, noise=noise, seed=seed
            )
        return frame.concede() if self.choice is None else frame.choose(self.choice)

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON: ``play``, ``choice`` or ``concede``, and what it cost."""
        if self.play is not None:
            answer: dict[str, Any] = {"play": self.play.to_dict()}
        else:
            answer = {"concede": True} if self.choice is None else {"choice": self.choice}
        return answer | {
            "win_chance": self.win_chance,
            "simulations": self.simulations,
            "rounds": self.rounds,
            "interrupted": self.interrupted,
        }

    def __str__(self) -> str:
        answer = "concede" if self.play is None else str(self.play)
        if self.choice is not None:
            answer = self.choice
        if self.win_chance is not None:
            answer += f"; wins {words.percent(self.win_chance)}"
        return f"{answer}; interrupted" if self.interrupted else answer


def _frame(frame: Frame) -> Frame:
    return instance("frame", frame, Frame, 'carom.Frame("nine-ball")')

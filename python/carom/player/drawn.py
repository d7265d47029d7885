"""What may follow a play, and the plays that pot a ball, under a player's errors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from carom import _core
from carom.arguments import instance, numbers, thread_count, whole
from carom.build import Strike, like
from carom.noise import Noise, Perception, noise_or_default, perception_or_none
from carom.plan.chance import Chance
from carom.player import words
from carom.player.decision import Play
from carom.rules import Frame, Ruling, play_arguments

# Most successors of one call: each takes a few kilobytes.
_MOST = 10**6
# Most strikes of one pot. The race between them begins with about a dozen.
_MOST_EACH = 100
# Confidence level of the chances.
_LEVEL = 0.95


@dataclass(frozen=True, slots=True)
class Successor:
    """A frame that may follow a play.

    Attributes:
        frame: The frame after the play. It has no record, and not the seed of the racks to come.
        ruling: The referee's ruling, without a trace.
        strike: The strike as it was executed.
    """

    frame: Frame
    ruling: Ruling
    strike: Strike


def successors(
    frame: Frame,
    play: Play,
    noise: Noise | None = None,
    n: int = 100,
    seed: int = 0,
    *,
    first: int = 0,
    perception: Perception | None = None,
    threads: int | None = None,
) -> list[Successor]:
    """The frames that may follow a play whose strike is executed with errors.

    The variants are those of ``carom.evaluate`` with the same noise, perception and seed. The frame
    is not changed.

    Args:
        frame: The frame that requests the shot.
        play: The play as it is intended.
        noise: Errors of the strike; the Olympiad's if None.
        n: Number of variants.
        seed: Seed of the errors.
        first: Number of the first variant.
        perception: Errors of the perceived positions; none if None.
        threads: Number of threads; None is one per core. The result does not depend on it.

    Raises:
        InputError: The frame does not allow the play, a number is out of range, or a variant cannot
            be played.
        EventCapError: A shot reached its largest number of events.
    """
    frame = instance("frame", frame, Frame, "situation.frame")
    play = instance("play", play, Play, "carom.Play(carom.Strike(2.0, 1.57))")
    first = whole("first", first, 1 << 63)
    drawn = _core.successors(
        frame._core,
        play_arguments(play.strike, play.cue_ball, play.call),
        noise_or_default(noise),
        perception_or_none(perception),
        whole("seed", seed),
        first,
        whole("n", n, _MOST + 1),
        thread_count(threads),
    )
    return [
        Successor(Frame._seen(after), Ruling._read(ruling), like(tuple(strike), {}))
        for after, ruling, strike in drawn
    ]


@dataclass(frozen=True, slots=True)
class PotPlay:
    """A play that pots a ball without errors, and its chance with them.

    Attributes:
        play: The play, as it is intended: a player may return it.
        kind: What it does without errors: ``direct``, ``bank``, ``kick`` or ``combination``; or
            ``indirect`` for another way.
        ball: The ball that falls.
        pocket: The pocket into which it falls.
        legs: The balls on the way to the pocket, the cue ball first, each with the number of
            cushions that it meets; empty for an indirect pot.
        chance: The chance that the ball falls into the pocket in a legal shot, counted with errors
            that took no part in the choice of the strike.
    """

    play: Play
    kind: str
    ball: str
    pocket: str
    legs: tuple[tuple[str, int], ...]
    chance: Chance

    @classmethod
    def _read(cls, fields: Mapping[str, Any]) -> PotPlay:
        """The play from its values in Rust."""
        met, count = fields["made"]
        return cls(
            play=Play._read(fields["play"]),
            kind=fields["kind"],
            ball=fields["ball"],
            pocket=fields["pocket"],
            legs=tuple((ball, cushions) for ball, cushions in fields["legs"]),
            chance=Chance.of(met, count, _LEVEL),
        )

    @property
    def aim(self) -> str:
        """What is played, in words, such as ``bank: 3 off 1 cushion into top-left``."""
        return words.pot(self.kind, self.ball, self.pocket, self.legs)

    def __str__(self) -> str:
        s = self.play.strike
        how = words.strike(s.speed, s.side, s.height, s.elevation or 0.0)
        place = self.play.cue_ball
        where = "" if place is None else f", cue ball at {words.place(place)} m"
        return f"{self.chance}  {self.aim}, {how}{where}"


def pots(
    frame: Frame,
    noise: Noise | None = None,
    n: int = 200,
    seed: int = 0,
    *,
    cue_ball: Sequence[float] | None = None,
    each: int = 1,
    perception: Perception | None = None,
    threads: int | None = None,
) -> list[PotPlay]:
    """The pots of a position, the most probable first: what a player may try, with its chance.

    For every ball, pocket and kind of line (direct, bank, kick, combination) that geometry finds,
    the strike is aimed by simulation at several speeds and heights, and the one that pots the ball
    most often under the errors is listed. Where the cue ball comes to rest is not looked at: with
    ``each`` there are more strikes to choose from. Games without pockets, and positions in which no
    ball can be potted, have an empty list.

    Args:
        frame: The frame, which requests a shot.
        noise: Errors of the player's strikes; the Olympiad's if None.
        n: Number of drawn errors behind each chance. They are the variants of ``carom.evaluate``
            with the same seed.
        seed: Seed of the errors.
        cue_ball: Where the cue ball in hand is placed (x, y in m); None for several places from
            which balls can be potted.
        each: Number of strikes for each ball, pocket and kind.
        perception: Errors of the perceived positions; none if None.
        threads: Number of threads; None is one per core. The result does not depend on it.

    Raises:
        InputError: The frame does not request a shot, the cue ball must not stand there, or a
            number is out of range.
        EventCapError: A shot reached its largest number of events.
    """
    found = _core.pots(
        instance("frame", frame, Frame, "situation.frame")._core,
        noise_or_default(noise),
        perception_or_none(perception),
        whole("seed", seed),
        None if cue_ball is None else numbers("cue_ball", cue_ball, 2),
        whole("each", each, _MOST_EACH + 1, low=1),
        whole("n", n, _MOST + 1, low=1),
        thread_count(threads),
    )
    return [PotPlay._read(fields) for fields in found]

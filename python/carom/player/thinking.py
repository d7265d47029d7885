"""What a player knows of the errors, and what a decision may cost."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

from carom.arguments import number, whole
from carom.errors import InputError
from carom.noise import Noise, Perception, noise_or_default, perception_or_none

# Simulated shots of a decision if no budget is given: about half a second of one core in the middle
# of a frame, and a few seconds for a break.
USUAL_SIMULATIONS = 20_000
# Largest number of simulated shots of a decision. Their samples take up to 10 GB.
MOST_SIMULATIONS = 10**8


@dataclass(frozen=True, slots=True)
class Thinking:
    """The options of a decision; the bindings read them by attribute.

    Attributes:
        noise: Errors of the player's strikes; the Olympiad's if None.
        opponent_noise: Errors of the opponent's strikes; the player's own if None.
        perception: Errors of the positions that the player sees; none if None.
        seed: Seed of the random numbers.
        simulations: Largest number of simulated shots.
        rounds: Largest number of rounds of the search; None if only the others limit them.
        time: Wall-clock time, s; None if only the others limit the search.

    Raises:
        InputError: A value has the wrong type or is out of range.
    """

    noise: Noise | None = None
    opponent_noise: Noise | None = None
    perception: Perception | None = None
    seed: int = 0
    simulations: int = USUAL_SIMULATIONS
    rounds: int | None = None
    time: float | None = None

    def __post_init__(self) -> None:
        noise = noise_or_default(self.noise)
        opponent = noise if self.opponent_noise is None else self.opponent_noise
        rounds, time = self.rounds, self.time
        checked = {
            "noise": noise,
            "opponent_noise": noise_or_default(opponent, "opponent_noise"),
            "perception": perception_or_none(self.perception),
            "seed": whole("seed", self.seed),
            "simulations": whole("simulations", self.simulations, MOST_SIMULATIONS + 1, low=1),
            "rounds": None if rounds is None else whole("rounds", rounds, 1 << 32, low=1),
            "time": None if time is None else seconds("time", time),
        }
        for name, value in checked.items():
            object.__setattr__(self, name, value)

    def to_dict(self) -> dict[str, Any]:
        """Plain values, for JSON."""
        return asdict(self)


def seconds(name: str, value: float) -> float:
    """A time above 0, s. The error calls the argument ``name``.

    Raises:
        InputError: It is not a number, not finite or not above 0.
    """
    found = number(name, value)
    # NaN is not above 0 either.
    if not 0 < found < float("inf"):
        raise InputError(
            "out-of-range", name, f"{value!r} is out of range", "give a number of seconds above 0"
        )
    return found

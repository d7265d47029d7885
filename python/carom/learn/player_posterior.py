"""What was learned about a player: the errors of the strikes as a noise, with their uncertainty."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Self

from carom import _core
from carom.arguments import number, text, whole
from carom.errors import InputError
from carom.files import read_text, shown, write_whole
from carom.installed import ENGINE
from carom.lazy import np
from carom.learn import player_file
from carom.learn.player_chances import PlayerChances, chances_of
from carom.learn.player_errors import NUMBERS, UNITS
from carom.learn.player_file import FORMAT
from carom.noise import Noise

if TYPE_CHECKING:
    from numpy.typing import NDArray

    import carom

    Floats = NDArray[np.float64]

#: The largest σ and mean error that a ``Noise`` takes: m/s, rad, rad, m, m.
LARGEST = (15.0, 3.14, 3.14, 0.01, 0.01)
#: The strikes tell a σ if they say as much as this many strikes that are known exactly.
TOLD = 5.0
#: The answer depends on a choice about the intentions if it moves a σ by this factor.
MOVED = 1.25


@dataclass(frozen=True, slots=True)
class Choice:
    """The answer under one choice about what the player intends.

    Attributes:
        name: The choice.
        sigma: Lower end, median and upper end of 90 % of each σ, in the order of ``NUMBERS``.
    """

    name: str
    sigma: tuple[tuple[float, float, float], ...]


@dataclass(frozen=True, slots=True, eq=False)
class PlayerPosterior:
    """The errors of a player, by draws from their posterior.

    The error of the speed is a share of the intended speed; a noise has it in m/s, so a noise
    belongs to an intended speed.

    Attributes:
        name: The player.
        shots: Number of strikes.
        speed: The intended speed to which the noises belong, m/s.
        bias: Mean errors: speed (share), azimuth, elevation (rad), side, height (m); shape (n, 5).
        covariance: Their covariances, shape (n, 5, 5).
        measured: Standard deviation of the measurement of a strike, its median, shape (5,).
        information: Number of exactly known strikes that would tell as much of each σ, shape (5,).
        background: Share of the strikes that have another intention, or were not measured as their
            samples say.
        choices: The answers under other choices about the intentions; empty if they are known.
    """

    name: str
    shots: int
    speed: float
    bias: Floats
    covariance: Floats
    measured: Floats
    information: Floats
    background: float
    choices: tuple[Choice, ...] = ()

    def at(self, speed: float) -> Self:
        """The same player at another intended speed, m/s.

        Raises:
            InputError: It is not a positive speed.
        """
        return replace(self, speed=_speed(speed))

    @property
    def sigma(self) -> Floats:
        """Standard deviations, shape (n, 5), in the units of ``bias``."""
        found: Floats = np.sqrt(np.einsum("nkk->nk", self.covariance))
        return found

    @property
    def noise(self) -> Noise:
        """The player as one noise: median σ, mean correlations and mean bias."""
        sigma = np.median(self.sigma, axis=0)
        apart = self.covariance / (self.sigma[:, :, None] * self.sigma[:, None, :])
        return self._noise(self.bias.mean(axis=0), apart.mean(axis=0) * np.outer(sigma, sigma))

    def draw(self, count: int, seed: int = 0) -> list[Noise]:
        """Noises that agree with the strikes: draws from the posterior, equally likely."""
        random = np.random.default_rng(whole("seed", seed))
        chosen = random.permutation(len(self.bias))
        rows = [int(chosen[i % len(chosen)]) for i in range(whole("count", count))]
        return [self._noise(self.bias[row], self.covariance[row]) for row in rows]

    def _noise(self, bias: Floats, covariance: Floats) -> Noise:
        """A noise at the player's speed; what exceeds the limits of a noise is moved to them."""
        unit = np.array((self.speed, 1.0, 1.0, 1.0, 1.0))
        largest = np.array(LARGEST)
        sigma = np.sqrt(np.diag(covariance)) * unit
        unit *= np.minimum(1.0, largest / sigma)
        spread = covariance * np.outer(unit, unit)
        mean = np.clip(bias * np.array((self.speed, 1.0, 1.0, 1.0, 1.0)), -largest, largest)
        return Noise(covariance=(spread + spread.T) / 2.0, bias=mean.tolist())

    def interval(self, name: str) -> tuple[float, float]:
        """The interval of 90 % of a σ, in the units of ``bias``.

        Raises:
            InputError: There is no such number.
        """
        low, high = np.quantile(self.sigma[:, self._index(name)], (0.05, 0.95))
        return float(low), float(high)

    def evaluate(
        self,
        shot: carom.Shot | Sequence[carom.Shot],
        n: int = 1000,
        *,
        draws: int = 50,
        seed: int = 0,
        frame: carom.Frame | None = None,
        threads: int | None = None,
    ) -> PlayerChances:
        """The chances of a shot, with intervals that include what is not known of the player.

        Every draw of the posterior is a noise, under which the shot's variants are counted.

        Args:
            shot: The intended shot. Several shots, such as one on each drawn table, take turns.
            n: Number of variants for each draw. Counting adds at most 0.8/√n to the half width of
                an interval.
            draws: Number of draws.
            seed: Seed of the draws and the variants.
            frame: The game, for the chances that the shot is legal and that the turn is kept.
            threads: Number of threads; None is one per core.

        Raises:
            InputError: A shot has no strike, or a number is out of range.
        """

        def draw(speed: float) -> list[Noise]:
            return self.at(speed).draw(draws, seed)

        return chances_of(draw, shot, n, draws, seed, frame, threads)

    def unknown(self) -> list[str]:
        """What the strikes do not tell, and how the answer depends on the intentions."""
        sentences = []
        for index, name in enumerate(NUMBERS):
            if self.information[index] < TOLD:
                unit, factor = UNITS[name]
                _, high = self.interval(name)
                sentences.append(
                    f"{name}: these strikes say as much as {self.information[index]:.1f} exact "
                    f"ones. The σ is probably below {factor * high:.3g} {unit}; its lower end is "
                    "that of the prior."
                )
        if self.background > 0.1:
            sentences.append(
                f"{100.0 * self.background:.0f} % of the strikes fit none of the intentions, or "
                "were not measured as their samples say."
            )
        return sentences + self._dependence()

    def _dependence(self) -> list[str]:
        """How far the answer depends on the choices about the intentions, in sentences."""
        if not self.choices:
            return []
        sentences = []
        for index, name in enumerate(NUMBERS):
            if self.information[index] < TOLD:
                continue
            unit, factor = UNITS[name]
            rows = [(choice.name, *choice.sigma[index]) for choice in self.choices]
            least = min(rows, key=lambda row: row[2])
            most = max(rows, key=lambda row: row[2])
            low = factor * min(row[1] for row in rows)
            high = factor * max(row[3] for row in rows)
            ratio = most[2] / least[2]
            how = "depends on" if ratio > MOVED else "hardly depends on"
            sentences.append(
                f"{name}: the σ {how} what the player is taken to intend: {factor * least[2]:.3g} "
                f"{unit} with {least[0]}, {factor * most[2]:.3g} {unit} with {most[0]}. All "
                f"intervals together: {low:.3g} to {high:.3g} {unit}."
            )
        return sentences

    def summary(self) -> str:
        """A table of the σ with their intervals, and what the strikes do not tell."""
        lines = [
            f"{self.name}: {self.shots} strikes; σ with intervals of 90 %, and mean error.",
            "",
        ]
        sigma, bias = np.median(self.sigma, axis=0), self.bias.mean(axis=0)
        for index, name in enumerate(NUMBERS):
            unit, factor = UNITS[name]
            low, high = self.interval(name)
            lines.append(
                f"{name:9}  {factor * sigma[index]:7.3f}  [{factor * low:.3f}, {factor * high:.3f}]"
                f" {unit}, mean {factor * bias[index]:+.3f}, measured to "
                f"{factor * self.measured[index]:.3f}"
            )
        if sentences := self.unknown():
            lines += ["", *sentences]
        return "\n".join(lines)

    def _index(self, name: str) -> int:
        if name not in NUMBERS:
            raise InputError(
                "unknown-name",
                "name",
                f"there is no {name!r}",
                f"write one of {', '.join(NUMBERS)}",
            )
        return NUMBERS.index(name)

    def to_dict(self) -> dict[str, Any]:
        """``carom-player/1``: the player as a noise, and the draws, rounded to six digits."""
        below = np.tril_indices(5)
        return {
            "format": FORMAT,
            "engine": ENGINE,
            "name": self.name,
            "shots": self.shots,
            "speed": self.speed,
            "noise": self.noise.to_dict(),
            "measured": self.measured.tolist(),
            "information": self.information.tolist(),
            "background": self.background,
            "choices": [
                {"name": choice.name, "sigma": [list(row) for row in choice.sigma]}
                for choice in self.choices
            ],
            "draws": {
                "bias": [_rounded(row) for row in self.bias],
                "covariance": [_rounded(matrix[below]) for matrix in self.covariance],
            },
        }

    def to_json(self) -> str:
        """The same as text."""
        return json.dumps(self.to_dict(), ensure_ascii=False)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write ``carom-player/1`` as JSON."""
        write_whole(path, self.to_json() + "\n")

    @classmethod
    def from_dict(cls, file: Mapping[str, Any]) -> Self:
        """Read ``carom-player/1``. Unknown keys are ignored.

        Raises:
            InputError: A key is missing, a value is wrong, or a covariance is not positive
                definite; the place is the key.
        """
        if (given := player_file.value_of(file, "format")) != FORMAT:
            raise InputError("format", "format", f"it is {given!r}", f"give a file with {FORMAT!r}")
        # The noise follows from the draws, but other programs read it alone.
        Noise.from_dict(player_file.value_of(file, "noise"))
        draws = player_file.value_of(file, "draws")
        part = {key: player_file.value_of(draws, key, "draws") for key in ("bias", "covariance")}
        bias = player_file.rows("draws.bias", part["bias"], 5)
        lower = player_file.rows("draws.covariance", part["covariance"], 15)
        if len(bias) != len(lower):
            raise InputError(
                "wrong-count",
                "draws",
                f"{len(bias)} mean errors and {len(lower)} covariances do not fit",
                player_file.REMEDY,
            )
        values = {
            key: player_file.value_of(file, key)
            for key in ("name", "shots", "speed", "measured", "information", "background")
        }
        listed = player_file.choices("choices", player_file.value_of(file, "choices"))
        return cls(
            name=text("name", values["name"]),
            shots=whole("shots", values["shots"], low=1),
            speed=_speed(values["speed"]),
            bias=bias,
            covariance=player_file.covariances("draws.covariance", lower),
            measured=player_file.vector("measured", values["measured"]),
            information=player_file.vector("information", values["information"]),
            background=player_file.within("background", values["background"], 0.0, 1.0),
            choices=tuple(Choice(name, sigma) for name, sigma in listed),
        )

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read ``carom-player/1`` from a file.

        Raises:
            OSError: The file cannot be read.
            InputError: It is not one that ``save`` wrote; the place is the file and the key.
        """
        file = _core.read_json(read_text(path), shown(path))
        try:
            return cls.from_dict(file)
        except InputError as error:
            raise error.inside(shown(path), ": ") from None


def _speed(value: Any) -> float:
    """An intended speed, m/s."""
    speed = number("speed", value)
    if not 0.0 < speed <= 50.0:
        raise InputError(
            "out-of-range", "speed", f"{speed:g} is out of range", "give a number in (0, 50]"
        )
    return speed


def _rounded(values: Floats) -> list[float]:
    return [float(f"{value:.6g}") for value in values.tolist()]

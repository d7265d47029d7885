"""Learning a player's errors from strikes as they were played."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from carom.arguments import whole
from carom.errors import InputError
from carom.lazy import np
from carom.learn import player_sampler as sampler
from carom.learn.filmed_strikes import FilmedStrike
from carom.learn.player_errors import EXACT, SCALE, PlayedStrike, difference, vector_of
from carom.learn.player_intentions import Intentions, find_intentions
from carom.learn.player_posterior import Choice, PlayerPosterior
from carom.progress import progress_bar
from carom.shot import Shot

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

#: Chains that begin apart. They must agree before the draws are taken.
CHAINS = 4
#: Iterations before the first draw, and between the draws of a chain.
BURN, EVERY = 300, 2
#: The chains agree if the ratio of Gelman & Rubin (1992) of every log σ is below this.
AGREED = 1.1
#: If they do not agree, the draws are spaced twice as far, this often at most.
DOUBLINGS = 3
#: Draws behind the answer under another choice about the intentions.
CHOICE_DRAWS = 200
#: Density of the background of strikes with a known intention: uniform in the speed over a factor
#: e³, all azimuths, 50° of elevation, and a square of 40 mm for the tip.
BACKGROUND_BOX = (3.0, 2.0 * math.pi, math.radians(50.0), 0.04, 0.04)

Strikes = Iterable[FilmedStrike | PlayedStrike | Shot]
Intended = Shot | Mapping[str, Shot | Intentions | None] | None


def player(
    strikes: Strikes,
    intended: Intended = None,
    *,
    name: str = "player",
    draws: int = 1000,
    seed: int = 0,
    progress: bool = False,
) -> PlayerPosterior:
    """Learn the errors of one player.

    Args:
        strikes: Strikes as they were played: those that ``carom.learn.strikes`` found, or
            ``PlayedStrike``. Shots are strikes that are known exactly.
        intended: The shot with the intended strike, if all strikes are repetitions of it; or one
            for each shot by its name. None takes the strikes that score and are near the played
            one, as ``carom.learn.find_intentions`` gives them, also as the intention of one shot.
        name: The player's name.
        draws: Number of draws from the posterior.
        seed: Seed of the random numbers.
        progress: Whether to show the progress on stderr.

    Returns:
        The errors with their uncertainty.

    Raises:
        InputError: There are fewer than two strikes, a strike has no samples, or an intention is
            missing.
    """
    played = _played(strikes)
    by_shot = {strike.name: name for strike in played}
    return players(played, intended, by_shot, draws=draws, seed=seed, progress=progress)[name]


def players(
    strikes: Strikes,
    intended: Intended,
    by_shot: Mapping[str, str],
    *,
    pooled: bool = True,
    draws: int = 1000,
    seed: int = 0,
    progress: bool = False,
) -> dict[str, PlayerPosterior]:
    """Learn the errors of several players of one population.

    The players' covariances have a common scale, and their spread about it is learned too: a player
    with few strikes is taken to be like the others.

    Args:
        strikes: As for ``player``.
        intended: As for ``player``.
        by_shot: The player of each shot, by the shot's name. Other shots are not used.
        pooled: Whether the players have something in common; without it each is learned alone.
        draws: Number of draws from the posterior.
        seed: Seed of the random numbers.
        progress: Whether to show the progress on stderr.

    Returns:
        The players by name.

    Raises:
        InputError: As for ``player``.
    """
    whole("draws", draws, low=20)
    played = [strike for strike in _played(strikes) if strike.name in by_shot]
    names = sorted({by_shot[strike.name] for strike in played})
    played.sort(key=lambda strike: by_shot[strike.name])
    index = np.array([names.index(by_shot[strike.name]) for strike in played], dtype=np.int64)
    counts = np.bincount(index, minlength=max(len(names), 1))
    if counts.min() < 2:
        raise InputError(
            "wrong-count",
            "strikes",
            f"{names[int(counts.argmin())] if names else 'the player'} has {counts.min()}",
            "give at least two strikes of every player",
        )
    with progress_bar(len(played), show=progress, what="intentions") as done:
        meant = [_intentions(strike, intended, seed, done) for strike in played]
    fit = _Fit(played, meant, index, names, pooled)
    found = fit.posteriors(draws, seed, progress)
    if any(one.log_background is not None for one in meant):
        choices = _choices(fit, min(draws, CHOICE_DRAWS), seed, found)
        found = {name: replace(one, choices=choices[name]) for name, one in found.items()}
    return found


def _played(strikes: Strikes) -> list[PlayedStrike]:
    played = [
        PlayedStrike.of(strike, str(number)) for number, strike in enumerate(strikes, start=1)
    ]
    seen: set[str] = set()
    for strike in played:
        if strike.name in seen:
            raise InputError(
                "duplicate", "strikes", f"two are called {strike.name!r}", "give each its own name"
            )
        seen.add(strike.name)
    return played


def _intentions(
    strike: PlayedStrike, intended: Intended, seed: int, done: Callable[[int], object]
) -> Intentions:
    done(1)
    if isinstance(intended, Mapping) and strike.name not in intended:
        raise InputError(
            "missing",
            "intended",
            f"shot {strike.name} has no intention",
            "give one for every shot, or None where it is unknown",
        )
    one = intended[strike.name] if isinstance(intended, Mapping) else intended
    if one is None:
        return find_intentions(strike, seed=seed)
    return Intentions.known(vector_of(one)) if isinstance(one, Shot) else one


class _Fit:
    """Strikes of players with their possible intentions."""

    def __init__(
        self,
        played: list[PlayedStrike],
        meant: list[Intentions],
        index: NDArray[np.int64],
        names: list[str],
        pooled: bool,
    ) -> None:
        self.played = played
        self.meant = meant
        self.index = index
        self.names = names
        self.pooled = pooled

    def with_intentions(self, meant: list[Intentions]) -> _Fit:
        return _Fit(self.played, meant, self.index, self.names, self.pooled)

    def data(self) -> sampler.Data:
        """The strikes of all chains, in units of the prior's scale."""
        scale = np.array(SCALE)
        most = max(len(one.weights) for one in self.meant)
        count = len(self.played)
        errors = np.zeros((count, most, 5))
        weights = np.full((count, most), -np.inf)
        measured = np.broadcast_to(np.eye(5), (count, most, 5, 5)).copy()
        background = np.full(count, -np.log(np.array(BACKGROUND_BOX) / scale).sum())
        for row, (strike, meant) in enumerate(zip(self.played, self.meant, strict=True)):
            size = len(meant.weights)
            errors[row, :size] = difference(strike.vector, meant.vectors) / scale
            own = strike.covariance + meant.covariances
            measured[row, :size] = _at_least_exact(own / np.outer(scale, scale))
            weights[row, :size] = np.log(meant.weights)
            if meant.log_background is not None:
                background[row] = meant.log_background + np.log(scale).sum()
        players = len(self.names)
        chain = np.arange(CHAINS)
        group = np.zeros(players, np.int64) if self.pooled else np.arange(players)
        return sampler.Data(
            errors=np.tile(errors, (CHAINS, 1, 1)),
            log_weights=np.tile(weights, (CHAINS, 1)),
            measured=np.tile(measured, (CHAINS, 1, 1, 1)),
            player=(self.index + players * chain[:, None]).ravel(),
            population=(group + (group.max() + 1) * chain[:, None]).ravel(),
            log_background=np.tile(background, CHAINS),
        )

    def posteriors(
        self, draws: int, seed: int, progress: bool = False, doublings: int = DOUBLINGS
    ) -> dict[str, PlayerPosterior]:
        """The players, by draws of chains that agree, or that were spaced out as often as asked."""
        random = np.random.default_rng((whole("seed", seed), 0x91A7))
        data, players = self.data(), len(self.names)
        count = -(-draws // CHAINS)
        chain = sampler.Chain(data, random)
        with progress_bar(doublings + 1, show=progress, what="draws") as done:
            chain.run(BURN)
            for doubling in range(doublings + 1):
                found = chain.draw(count, EVERY << doubling)
                done(1)
                sigma = np.sqrt(np.einsum("dpkk->dpk", found.covariance))
                if _ratio(np.log(sigma).reshape(count, CHAINS, -1)).max() < AGREED:
                    break
        bias = found.bias.reshape(count * CHAINS, players, 5) * SCALE
        covariance = found.covariance.reshape(count * CHAINS, players, 5, 5)
        covariance = covariance * np.outer(SCALE, SCALE)
        background = found.background.reshape(-1, players).mean(axis=0)
        return {
            name: self._posterior(i, bias[:, i], covariance[:, i], float(background[i]))
            for i, name in enumerate(self.names)
        }

    def _posterior(
        self, player: int, bias: Floats, covariance: Floats, background: float
    ) -> PlayerPosterior:
        own = np.flatnonzero(self.index == player)
        speeds = [math.exp(self.played[i].vector[0]) for i in own]
        errors = np.array([np.diag(self.played[i].covariance) for i in own])
        return PlayerPosterior(
            name=self.names[player],
            shots=len(own),
            speed=float(np.median(speeds)),
            bias=bias,
            covariance=covariance,
            measured=np.sqrt(np.median(errors, axis=0)),
            information=self._information(own, np.median(covariance, axis=0)),
            background=background,
        )

    def _information(self, own: NDArray[np.int64], covariance: Floats) -> Floats:
        """How many exactly known strikes would say as much about each σ, shape (5,).

        A normal variable with the variance σ² + r² says (σ²/(σ² + r²))² times as much about log σ
        as one with the variance σ². Of several intentions the most probable a priori counts.
        """
        scale = np.outer(SCALE, SCALE)
        total = np.zeros(5)
        for i in own:
            meant = self.meant[i]
            rest = meant.covariances[int(meant.weights.argmax())] + self.played[i].covariance
            precision = np.linalg.inv((covariance + rest) / scale + np.eye(5) * EXACT**2)
            share = np.diag(precision) * np.diag(covariance / scale)
            total += np.minimum(share, 1.0) ** 2
        return total


def _at_least_exact(covariances: Floats) -> Floats:
    """Covariances, shape (..., 5, 5), with no direction that is more exact than ``EXACT``."""
    values, vectors = np.linalg.eigh(covariances)
    wide = np.maximum(values, 0.0) + EXACT**2
    found: Floats = (vectors * wide[..., None, :]) @ np.swapaxes(vectors, -1, -2)
    return found


def _choices(
    fit: _Fit, draws: int, seed: int, main: dict[str, PlayerPosterior]
) -> dict[str, tuple[Choice, ...]]:
    """The answers under other choices about the intentions, by player."""
    others = {
        "the nearest intention only": [
            meant.nearest(strike.vector)
            for strike, meant in zip(fit.played, fit.meant, strict=True)
        ],
        "aims anywhere in the window": [meant.anywhere() for meant in fit.meant],
        "intentions weighted by their windows": [meant.by_window() for meant in fit.meant],
        "a background 10 times as dense": [meant.with_background(10.0) for meant in fit.meant],
        "a background a tenth as dense": [meant.with_background(0.1) for meant in fit.meant],
    }
    ways = {"all intentions": main}
    for way, meant in others.items():
        ways[way] = fit.with_intentions(meant).posteriors(draws, seed, doublings=1)
    return {
        name: tuple(Choice(way, _quantiles(found[name].sigma)) for way, found in ways.items())
        for name in fit.names
    }


def _quantiles(sigma: Floats) -> tuple[tuple[float, float, float], ...]:
    found = np.quantile(sigma, (0.05, 0.5, 0.95), axis=0).T.tolist()
    return tuple((low, middle, high) for low, middle, high in found)


def _ratio(values: Floats) -> Floats:
    """The potential scale reduction of chains, (draws, chains, m): Gelman & Rubin (1992)."""
    count = len(values)
    within = values.var(axis=0, ddof=1).mean(axis=0)
    between = values.mean(axis=0).var(axis=0, ddof=1)
    ratio: Floats = np.sqrt((count - 1) / count + between / np.maximum(within, 1e-300))
    return ratio

"""What was learned about a table: numbers with their uncertainty."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Self

from carom import _core
from carom.arguments import whole
from carom.errors import InputError
from carom.files import read_text, shown, write_whole
from carom.installed import ENGINE
from carom.lazy import np
from carom.learn.table_model import Frame, TableModel

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

FORMAT = "carom-learned/1"
#: Drawn tables of a file: three times as many as a question takes by default, so that a count that
#: ranks plays and one that is stated have tables of their own.
DRAWS = 96
#: The most of them.
MOST_DRAWS = 3000
#: Standard deviation of the weak prior, in steps of a parameter.
PRIOR_STEPS = 10.0
#: A number whose uncertainty is this share of its prior's is one that the tracks do not tell.
UNKNOWN = 0.5
#: A direction of numbers is one that the tracks do not tell apart above this correlation.
TOGETHER = 0.95
#: Quantile of the normal distribution for a two-sided interval of 90 %.
NORMAL_90 = 1.6448536269514722
#: How many times as wide an interval is as the scatter of the shots says. Films whose rails follow
#: another model than the fit's then cover the truth as often as they should
#: (``benches/table_coverage.py``, docs/learn-table.md). Such an error is the same in every shot, so
#: the scatter does not have it. Draws have the scatter alone: what a wrong model learns predicts
#: its table better than it tells the true numbers.
MODEL_ERROR = 1.5


@dataclass(frozen=True, slots=True)
class LearnedTable:
    """A table as shot files have it, and where the tracks lie on it.

    Attributes:
        table: The table.
        physics: The physics.
        frame: The frame of the tracks.
    """

    table: dict[str, Any]
    physics: dict[str, Any]
    frame: Frame


@dataclass(frozen=True, slots=True, eq=False)
class LearnedNumbers:
    """The free numbers of a table, jointly normal.

    Attributes:
        model: The table with its free numbers.
        mean: Their values, shape (p,).
        covariance: Shape (p, p).
        shots: Number of shots that say something about them.
        strikes: The strike of each filmed shot where the fit ended, by the shot's name: azimuth
            (rad), speed (m/s), side, height (ball radii), elevation (rad) and clock (s), shape
            (6,). A file does not have them: then it is empty.
    """

    model: TableModel
    mean: Floats
    covariance: Floats
    shots: int
    strikes: Mapping[str, Floats] = field(default_factory=dict, repr=False)

    @classmethod
    def of(cls, model: TableModel, mean: Floats, curvatures: Floats, gradients: Floats) -> Self:
        """The posterior whose covariance is the scatter of the numbers when a shot is left out.

        The errors of a model within one shot belong together: they follow from the same strike and
        the same contacts. So the shots are the independent observations. Without shot i the numbers
        move by d = (H − Hᵢ)⁻¹ gᵢ, and the covariance is (n − 1)/n · Σ d dᵀ (the jackknife of Tukey
        1958, which for clusters is CR3 of Bell & McCaffrey 2002). It does not trust the weights of
        the samples. Often few shots tell most of a number, and their scatter is known badly: then
        its standard deviation is wider by Student's t over the normal quantile. A weak prior bounds
        what the shots do not tell.

        Args:
            model: The table.
            mean: The values, shape (p,).
            curvatures: The curvature Hᵢ that each shot adds, shape (n, p, p), in steps.
            gradients: The gradient gᵢ of each shot, shape (n, p), in steps.
        """
        shots, size = gradients.shape
        total = curvatures.sum(axis=0)
        ridge = np.eye(size) * 1e-9 * (1.0 + np.trace(total))
        moves = np.linalg.solve(total - curvatures + ridge, gradients[:, :, None])[:, :, 0]
        scatter = moves.T @ moves * ((shots - 1) / shots)
        # A direction along which no shot moves the numbers has no information either.
        scatter += np.linalg.inv(total + ridge)
        wider = _student_90(_freedom(curvatures, ridge)) / NORMAL_90
        scatter *= np.outer(wider, wider)
        spread = np.linalg.inv(np.linalg.inv(scatter) + np.eye(size) / PRIOR_STEPS**2)
        covariance: Any = spread * np.outer(model.steps, model.steps)
        return cls(model, mean, covariance, shots)

    @property
    def names(self) -> list[str]:
        """Names of the numbers."""
        return self.model.names

    @property
    def sigma(self) -> Floats:
        """Standard deviation of each number."""
        deviation: Floats = np.sqrt(np.diag(self.covariance))
        return deviation

    @property
    def share_of_prior(self) -> Floats:
        """Standard deviation of each number, as a share of that of the weak prior."""
        return self.sigma / (PRIOR_STEPS * self.model.steps)

    @property
    def physics(self) -> dict[str, Any]:
        """The learned physics, as a shot file has it."""
        return self.model.parts(self.mean)[1]

    @property
    def table(self) -> dict[str, Any]:
        """The learned table, as a shot file has it."""
        return self.model.parts(self.mean)[0]

    @property
    def frame(self) -> Frame:
        """Where the tracks lie on the table."""
        return self.model.parts(self.mean)[2]

    def interval(self, name: str) -> tuple[float, float]:
        """The interval of 90 % of a number: ``MODEL_ERROR`` times as wide as its scatter.

        Raises:
            InputError: The number was not learned.
        """
        if name not in self.names:
            raise InputError(
                "unknown-name",
                "name",
                f"{name!r} was not learned",
                f"choose from {', '.join(self.names)}",
            )
        index = self.names.index(name)
        half = MODEL_ERROR * NORMAL_90 * float(self.sigma[index])
        return float(self.mean[index]) - half, float(self.mean[index]) + half

    def draw(self, count: int, seed: int = 0) -> list[LearnedTable]:
        """Tables that agree with the tracks: draws from the posterior, inside the bounds."""
        random = np.random.default_rng(whole("seed", seed))
        normal = random.standard_normal((whole("count", count), self.mean.size))
        values, vectors = np.linalg.eigh(self.covariance)
        root = vectors * np.sqrt(np.maximum(values, 0.0))
        rows = self.model.clip(self.mean + normal @ root.T)
        return [LearnedTable(*self.model.parts(row)) for row in rows]

    def unknown(self) -> list[str]:
        """What the tracks do not tell, in sentences."""
        sentences = []
        if self.shots < 2 * len(self.names):
            sentences.append(
                f"{self.shots} shots are few for {len(self.names)} numbers: the intervals are "
                "rough. Film more shots, or learn fewer numbers."
            )
        for parameter, value in zip(self.model.free, self.share_of_prior, strict=True):
            if value > UNKNOWN:
                sentences.append(
                    f"{parameter.name}: these shots do not tell the {parameter.about}."
                )
        correlation = self.covariance / np.outer(self.sigma, self.sigma)
        for i, j in zip(*np.triu_indices(len(self.names), 1), strict=True):
            if abs(correlation[i, j]) > TOGETHER:
                first, second = self.names[i], self.names[j]
                sentences.append(
                    f"{first} and {second} cannot be separated with these shots "
                    f"(correlation {correlation[i, j]:.2f})."
                )
        return sentences

    def summary(self) -> str:
        """A table of the numbers with their intervals, and what the tracks do not tell."""
        lines = [f"Learned from {self.shots} shots; intervals of 90 %.", ""]
        width = max(map(len, self.names))
        for parameter, value in zip(self.model.free, self.mean.tolist(), strict=True):
            low, high = self.interval(parameter.name)
            unit = f" {parameter.unit}" if parameter.unit else ""
            lines.append(f"{parameter.name:{width}}  {value:9.5f}  [{low:.5f}, {high:.5f}]{unit}")
        if sentences := self.unknown():
            lines += ["", *sentences]
        return "\n".join(lines)

    def to_dict(self, *, draws: int = DRAWS) -> dict[str, Any]:
        """``carom-learned/1``: physics, table, frame, posterior and ``draws`` tables drawn from it.

        The drawn tables are for JavaScript; ``carom.plan.ListedTables`` reads them.

        Raises:
            InputError: ``draws`` is out of range.
        """
        frame = self.frame
        drawn = self.draw(whole("draws", draws, MOST_DRAWS + 1))
        return {
            "format": FORMAT,
            "engine": ENGINE,
            "physics": self.physics,
            "table": self.table,
            "frame": {"offset": [*frame.offset], "rotation": frame.rotation},
            "posterior": {
                "names": self.names,
                "mean": self.mean.tolist(),
                "covariance": self.covariance.tolist(),
                "shots": self.shots,
                "base": {
                    "table": self.model.table,
                    "physics": self.model.physics,
                    "radius": self.model.radius,
                },
            },
            "draws": [{"table": one.table, "physics": one.physics} for one in drawn],
        }

    def to_json(self, *, draws: int = DRAWS) -> str:
        """The same as text, with each drawn table in a line of its own."""
        file = self.to_dict(draws=draws)
        rows = ",\n".join(f"  {json.dumps(row)}" for row in file.pop("draws"))
        head = json.dumps(file, indent=1, ensure_ascii=False).removesuffix("\n}")
        return f'{head},\n "draws": [\n{rows}\n ]\n}}'

    def save(self, path: str | os.PathLike[str], *, draws: int = DRAWS) -> None:
        """Write ``carom-learned/1`` as JSON, with ``draws`` drawn tables.

        Raises:
            OSError: The file cannot be written.
            InputError: ``draws`` is out of range.
        """
        write_whole(path, self.to_json(draws=draws) + "\n")

    @classmethod
    def from_dict(cls, file: Mapping[str, Any]) -> Self:
        """Read ``carom-learned/1``.

        Raises:
            InputError: A key is missing, or a shape does not fit.
        """
        if file.get("format") != FORMAT:
            raise InputError(
                "format", "format", f"it is {file.get('format')!r}", f"write {FORMAT!r}"
            )
        try:
            part = file["posterior"]
            base = part["base"]
            model = TableModel(base["table"], base["physics"], part["names"], base["radius"])
            mean = np.array(part["mean"], dtype=np.float64)
            covariance = np.array(part["covariance"], dtype=np.float64)
            shots = int(part["shots"])
        except (KeyError, TypeError, ValueError) as error:
            raise InputError(
                "missing",
                "posterior",
                f"it cannot be read ({error})",
                "write it with Posterior.save",
            ) from None
        if mean.shape != (len(model.names),) or covariance.shape != (mean.size, mean.size):
            raise InputError(
                "wrong-count",
                "posterior",
                f"{len(model.names)} names, a mean of shape {mean.shape} and a covariance of shape "
                f"{covariance.shape} do not fit",
                "write it with Posterior.save",
            )
        return cls(model, mean, covariance, shots)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read ``carom-learned/1`` from a file.

        Raises:
            OSError: The file cannot be read.
            InputError: It is not one that ``save`` wrote.
        """
        file = _core.read_json(read_text(path), shown(path))
        return cls.from_dict(file)


def _freedom(curvatures: Floats, ridge: Floats) -> Floats:
    """Degrees of freedom of the scatter of each number, shape (p,), at least 1.

    Satterthwaite's, after Bell & McCaffrey 2002, section 4: if gᵢ has the covariance Hᵢ before the
    fit, the moves dᵢ of a number have the covariance Ω, and ν = (tr Ω)² / tr Ω².
    """
    total = curvatures.sum(axis=0) + ridge
    inverse = np.linalg.inv(total)
    # The column k belongs to the number k: Ω = diag(aᵢ·Hᵢaᵢ) − aᵢ·Hᵢ H⁻¹ Hⱼ aⱼ.
    ways = np.linalg.inv(total - curvatures)
    pushes = curvatures @ ways
    own = np.einsum("nik,nik->kn", ways, pushes)
    omega = -np.einsum("nik,mik->knm", pushes, inverse @ pushes)
    index = np.arange(own.shape[1])
    omega[:, index, index] += own
    trace = np.einsum("knn->k", omega)
    squares = np.maximum(np.square(omega).sum(axis=(1, 2)), np.finfo(float).tiny)
    freedom: Floats = np.maximum(trace**2 / squares, 1.0)
    return freedom


def _student_90(freedom: Floats) -> Floats:
    """Quantiles of Student's t for two-sided intervals of 90 %.

    Their expansion about the normal quantile: Abramowitz & Stegun 1964, 26.7.5. With one degree of
    freedom it is 5 % below the quantile, with two 0.3 %.
    """
    z = NORMAL_90
    found: Floats = (
        z
        + (z**3 + z) / (4.0 * freedom)
        + (5.0 * z**5 + 16.0 * z**3 + 3.0 * z) / (96.0 * freedom**2)
        + (3.0 * z**7 + 19.0 * z**5 + 17.0 * z**3 - 15.0 * z) / (384.0 * freedom**3)
        + (79.0 * z**9 + 776.0 * z**7 + 1482.0 * z**5 - 1920.0 * z**3 - 945.0 * z)
        / (92160.0 * freedom**4)
    )
    return found

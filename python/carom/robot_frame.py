"""A robot's frame: its calibration from pairs of points, cue motions in it, and their errors."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple, Self

from carom import _core
from carom.arguments import core, number, numbers, whole
from carom.batch import own_strike
from carom.build import Strike
from carom.errors import InputError
from carom.lazy import np
from carom.noise import Noise
from carom.point_pairs import (
    best_rotation,
    check_count,
    check_fit,
    check_spread,
    finite,
    mirrored,
    pairs_of_points,
    points,
    positive,
    turn,
    unit_covariance,
    unit_vector,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike, NDArray

    import carom

    Array = NDArray[np.float64]

# Largest deviation of a rotation matrix from orthogonal: rounding of seven digits is accepted.
_ORTHOGONAL = 1e-6
# Steps of numerical derivatives: rotation (rad), displacement (m), relative scale. Errors of
# rounding and of curvature are then below 1e-8.
_STEPS = (1e-5,) * 3 + (1e-6,) * 3 + (1e-5,)
# Least elevation at which the derivatives are taken, rad: above the steps, which would otherwise
# let a level cue point up.
_LEAST_ELEVATION = 1e-4
# Upward component of a direction that counts as rounding. A robot's angles have errors above 1e-6.
_ROUNDING = 1e-12


class CueCommand(NamedTuple):
    """A motion of the cue in a robot's frame.

    Attributes:
        tip: Where the tip touches the ball, on the cue's axis, x, y, z, m.
        start: Where the tip is before it, ``run_up`` behind ``tip`` on the same axis, m.
        direction: Direction in which the cue moves, a unit vector.
        speed: The cue's speed at contact, m/s.
        clearance: How much the cue may move across its axis until it touches a ball or a rail, m,
            as in ``carom.CuePose``; None if nothing is there.
        nearest: The ball or the rail of the clearance.
    """

    tip: tuple[float, float, float]
    start: tuple[float, float, float]
    direction: tuple[float, float, float]
    speed: float
    clearance: float | None
    nearest: str | None


@dataclass(frozen=True, slots=True, eq=False)
class RobotFrame:
    """Where the table is in a robot's frame: robot = scale · rotation · table + offset.

    ``RobotFrame.fit`` estimates it from points seen in both frames. The seven errors of a
    calibration are a small rotation about the robot's axes (rad), a displacement of ``centre``
    (m), and a relative error of the scale.

    Attributes:
        rotation: From the table's axes to the robot's, shape (3, 3), orthogonal, determinant 1.
            Its last column is the table's upward direction in the robot's frame.
        offset: The table's origin in the robot's frame, m, shape (3,).
        scale: The robot's metres for one metre of the table.
        covariance: Of the seven errors, shape (7, 7); zeros for a known frame.
        centre: Point of the table's frame about which the errors rotate, m, shape (3,).
        residuals: Seen minus fitted points in the robot's frame, m, shape (n_points, 3); None if
            the frame was not fitted.

    Raises:
        InputError: The rotation is none, or mirrors; an array has a wrong shape or a number that
            is not finite; the covariance is not symmetric or not positive semidefinite.
    """

    rotation: Array
    offset: Array
    scale: float = 1.0
    covariance: Array = field(default_factory=lambda: np.zeros((7, 7)), kw_only=True)
    centre: Array = field(default_factory=lambda: np.zeros(3), kw_only=True)
    residuals: Array | None = field(default=None, kw_only=True, repr=False)

    def __post_init__(self) -> None:
        rotation = finite("rotation", self.rotation, (3, 3))
        if np.abs(rotation @ rotation.T - np.eye(3)).max() > _ORTHOGONAL:
            fault, remedy = "the rows are not unit vectors at right angles", "give a rotation"
            raise InputError("out-of-range", "rotation", fault, remedy)
        if np.linalg.det(rotation) < 0:
            raise mirrored("rotation", "its determinant is −1")
        scale = positive("scale", self.scale)
        matrix = finite("covariance", self.covariance, (7, 7))
        size = np.abs(matrix).max()
        if np.abs(matrix - matrix.T).max() > 1e-9 * size or (
            np.linalg.eigvalsh(matrix).min() < -1e-9 * size
        ):
            fault = "not symmetric and positive semidefinite"
            raise InputError("out-of-range", "covariance", fault, "give a covariance matrix")
        offset, centre = (finite(n, getattr(self, n), (3,)) for n in ("offset", "centre"))
        values = (rotation, offset, scale, matrix, centre)
        names = ("rotation", "offset", "scale", "covariance", "centre")
        for name, value in zip(names, values, strict=True):
            object.__setattr__(self, name, value)

    @classmethod
    def fit(
        cls,
        table: ArrayLike,
        robot: ArrayLike,
        *,
        sigma: float | None = None,
        scale: bool = False,
        vertical: Sequence[float] | None = None,
    ) -> Self:
        """The frame that fits pairs of points best by least squares.

        The rotation is that of Kabsch (*A solution for the best rotation to relate two sets of
        vectors*, 1976), the scale that of Umeyama (*Least-squares estimation of transformation
        parameters between two point patterns*, 1991, eq. 41 and 42). The covariance is that of
        linear least squares with equal, independent errors of all coordinates.

        Points in one plane, such as balls on the cloth, do not show whether a frame is mirrored.
        Give ``vertical`` then, or check that ``rotation[:, 2]`` is upward in the robot's frame.

        Args:
            table: Points in the table's frame, m, shape (n_points, 3): at least three that are not
                on a line, or two with ``vertical``.
            robot: The same points in the robot's frame, m, in the same order.
            sigma: Standard deviation of one coordinate of a pair, m: that of the robot's and the
                table's measurement together. None estimates it from the residuals, which is rough
                for few points: with three points it has 3 degrees of freedom.
            scale: Fit the scale, too; otherwise it is 1.
            vertical: The table's upward direction in the robot's frame, of any length, if it is
                known exactly. Only the rotation about it is then fitted.

        Raises:
            InputError: The arrays are not pairs of points, or too few; they are on a line; the
                units differ; a frame is mirrored; the pairs do not fit.
        """
        seen, places = pairs_of_points(table, robot)
        up = None if vertical is None else unit_vector("vertical", vertical)
        check_count(len(seen), up)
        center, image = seen.mean(axis=0), places.mean(axis=0)
        x, y = seen - center, places - image
        check_spread(x, y, up)
        rotation = best_rotation(x, y, up)
        check_fit(x, y, up, rotation)
        turned = x @ rotation.T
        factor = float((turned * y).sum() / (x * x).sum()) if scale else 1.0
        arms = factor * turned
        residuals = y - arms
        unknowns = 3 + (3 if up is None else 1) + bool(scale)
        if sigma is None:
            variance = float((residuals**2).sum()) / (3 * len(x) - unknowns)
        else:
            variance = positive("sigma", sigma) ** 2
        return cls(
            rotation,
            image - factor * rotation @ center,
            factor,
            covariance=variance * unit_covariance(arms, up, fits_scale=scale),
            centre=center,
            residuals=residuals,
        )

    @property
    def deviations(self) -> Array:
        """Standard deviations of the seven errors: three of rad, three of m, one relative."""
        deviations: Array = np.sqrt(np.diagonal(self.covariance).clip(min=0.0))
        return deviations

    def to_robot(self, positions: ArrayLike) -> Array:
        """Points of the table's frame in the robot's, m, shape (..., 3)."""
        turned: Array = self.scale * points("positions", positions) @ self.rotation.T
        return turned + self.offset

    def to_table(self, positions: ArrayLike) -> Array:
        """Points of the robot's frame in the table's, m, shape (..., 3)."""
        back: Array = (points("positions", positions) - self.offset) @ self.rotation / self.scale
        return back

    def command(self, shot: carom.Shot, run_up: float = 0.1) -> CueCommand:
        """The motion of the cue for the shot's strike, in the robot's frame.

        Args:
            shot: The shot with its strike.
            run_up: Distance of the tip from its place at contact when the motion begins, m of the
                robot's frame.

        Raises:
            InputError: The shot has no strike, or the distance is negative or not finite.
        """
        core("shot", shot, _core.Shot, "carom.Shot.from_dict(...)")
        back = number("run_up", run_up)
        if not (np.isfinite(back) and back >= 0):
            fault, remedy = f"{back:g} m is out of range", "give a distance of 0 or more, in metres"
            raise InputError("out-of-range", "run_up", fault, remedy)
        pose = shot.cue_pose()
        speed = own_strike(shot._core)[0]
        tip = self.to_robot(pose.tip)
        direction = self.rotation @ pose.direction
        clear = None if pose.clearance is None else float(self.scale * pose.clearance)
        triples = (_triple(tip), _triple(tip - back * direction), _triple(direction))
        return CueCommand(*triples, self.scale * speed, clear, pose.nearest)

    def strike(
        self,
        shot: carom.Shot,
        tip: Sequence[float],
        direction: Sequence[float],
        speed: float,
        *,
        ball: str = "cue",
    ) -> Strike:
        """The strike of a cue whose motion was measured in the robot's frame.

        Args:
            shot: The shot with the ball; its own strike is not used.
            tip: A point on the cue's axis, m: the tip, also before it touches the ball.
            direction: Direction in which the cue moves, of any length.
            speed: The cue's speed, m/s of the robot's frame.
            ball: Id of the struck ball.

        Raises:
            InputError: As ``Strike.from_pose``.
        """
        point = self.to_table(numbers("tip", tip, 3))
        along = np.asarray(numbers("direction", direction, 3)) @ self.rotation
        # Rounding of the rotation may lift a level direction, which would be refused.
        if 0 < along[2] <= _ROUNDING * np.linalg.norm(along):
            along[2] = 0.0
        pace = number("speed", speed) / self.scale
        return Strike.from_pose(shot, _triple(point), _triple(along), pace, ball=ball)

    def draw(self, n: int, *, seed: int = 0) -> list[Self]:
        """Frames where the true one may be, with normal errors of the covariance.

        Args:
            n: Number of frames.
            seed: Seed of NumPy's generator.
        """
        rng = np.random.default_rng(whole("seed", seed))
        count = whole("n", n)
        errors = rng.multivariate_normal(np.zeros(7), self.covariance, size=count, method="eigh")
        return [self._moved(each) for each in errors]

    def noise(self, shot: carom.Shot) -> Noise:
        """The errors of the strike that the uncertainty of the calibration causes.

        The robot plays the command of this frame, and the true frame differs by the seven errors.
        The covariance of executed minus intended is J C Jᵀ: C is ``covariance``, J has numerical
        derivatives of command and ``strike``. It is linear in the errors of the calibration.

        The error of one calibration is the same in every shot until the next calibration. A
        chance with this noise is a chance over what is not known about the frame. Add the robot's
        own errors to it: ``robot + frame.noise(shot)``.

        Raises:
            InputError: The shot has no strike.
        """
        struck = shot.strike
        raised = max(shot.elevation or 0.0, _LEAST_ELEVATION)
        if struck is None:
            raise InputError("no-strike", "strike", "the shot has no strike", "give it one")
        command = self.command(shot.with_strike(elevation=raised), 0.0)
        jacobian = np.zeros((5, 7))
        for k, step in enumerate(_STEPS):
            change = np.zeros(7)
            change[k] = step
            high, low = (
                self._moved(e)._executed(shot, command, struck.ball) for e in (change, -change)
            )
            difference = high - low
            difference[1] = (difference[1] + np.pi) % (2 * np.pi) - np.pi
            jacobian[:, k] = difference / (2 * step)
        jacobian[3:] *= shot.radius[shot.ids.index(struck.ball)]
        covariance = jacobian @ self.covariance @ jacobian.T
        return Noise(covariance=(covariance + covariance.T) / 2)

    def _executed(self, shot: carom.Shot, command: CueCommand, ball: str) -> Array:
        """Speed, azimuth, elevation, side, height of the strike by this command."""
        found = self.strike(shot, command.tip, command.direction, command.speed, ball=ball)
        values = (found.speed, found.azimuth, found.elevation, found.side, found.height)
        return np.array(values, dtype=float)

    def _moved(self, errors: Array) -> Self:
        """This frame with the seven errors, without uncertainty."""
        rotation = turn(errors[:3]) @ self.rotation
        scale = self.scale * (1 + errors[6])
        offset = self.to_robot(self.centre) + errors[3:6] - scale * rotation @ self.centre
        return type(self)(rotation, offset, float(scale))


def _triple(values: Array) -> tuple[float, float, float]:
    x, y, z = values.tolist()
    return (x, y, z)

"""An environment for learners that is built on pooltool, with as little overhead as possible.

It has the layouts, the kind of action and the size of errors of ``carom/EightBall-v6`` with
``aim="relative"``, and the balls stay where they come to rest from shot to shot. It has no referee:
any ball may be hit first, nothing is called, and an episode ends when the eight or the last of the
other balls is pocketed. A shot is therefore simulated once, where ours is simulated twice if a ball
falls.
"""

from __future__ import annotations

import math
import time
from typing import Any

import carom
import numpy as np
from carom.bench.peer import Pooltool
from numpy.typing import NDArray

Array = NDArray[Any]

#: pooltool's default table, by our name.
TABLE = "showood-7ft"
#: The state of a ball in a pocket.
POCKETED = 4
#: Largest tip offset, radii: nine tenths of the miscue limit of 0.5, as in our actions.
OFFSET_USED = 0.45
#: Least and largest speed of an action, m/s, and the least speed after an error.
SPEED = (0.2, 8.0, 0.01)


class EightBall:
    """One environment.

    Args:
        layouts: Observations of ``carom/EightBall-v6`` on the same table. The episodes begin with
            them, one after the other.
        noise: Errors of every strike.
        seed: Seed of the errors.

    Raises:
        ImportError: pooltool is not installed, or its version is not that of the comparison.
    """

    def __init__(self, layouts: Array, noise: carom.Noise, seed: int) -> None:
        self.version = Pooltool().version
        import pooltool
        from pooltool.physics.engine import PhysicsEngine
        from pooltool.physics.resolve.resolver import default_resolver

        self._pt = pooltool
        self._engine = PhysicsEngine(resolver=default_resolver())
        self._table = pooltool.Table.default()
        self._half = 0.5 * np.array([self._table.w, self._table.l])
        self._layouts = layouts
        self._next = 0
        self._noise = noise
        self._random = np.random.default_rng(seed)
        self.reset()

    def reset(self) -> Array:
        """Begins the next episode and returns its observation."""
        row = self._layouts[self._next % len(self._layouts)]
        self._next += 1
        self._balls = {}
        for index, (x, y, on_table, _) in enumerate(row[:64].reshape(16, 4).tolist()):
            if on_table:
                name = str(index) if index else "cue"
                place = self._half * (np.array([x, y]) + 1)
                self._balls[name] = self._pt.Ball.create(name, xy=place)
        self.system = self._pt.System(
            cue=self._pt.Cue(cue_ball_id="cue"), table=self._table, balls=self._balls
        )
        return self.observe()

    def step(self, action: Array) -> tuple[Array, float, bool]:
        """Plays a shot: observation, balls pocketed less scratches, whether the episode is over."""
        self.system.reset_history()
        self.system.strike(**self._strike(action))
        before = self._down()
        self._pt.simulate(self.system, engine=self._engine, inplace=True)
        down = self._down()
        potted = len(down) - len(before)
        if "cue" in down:
            potted -= 2
            self._respot()
        over = "8" in down or len(down) >= len(self._balls) - 1
        return self.reset() if over else self.observe(), float(potted), over

    def observe(self) -> Array:
        """Position and presence of every ball, in the form of our observations."""
        row = np.zeros((16, 4), dtype=np.float32)
        for name, ball in self._balls.items():
            if ball.state.s != POCKETED:
                at = ball.state.rvw[0, :2] / self._half - 1
                row[0 if name == "cue" else int(name)] = (*at, 1.0, float(name != "cue"))
        return row.reshape(-1)

    def _down(self) -> set[str]:
        return {name for name, ball in self._balls.items() if ball.state.s == POCKETED}

    def _strike(self, action: Array) -> dict[str, float]:
        """The strike of an action: speed in m/s, angles in degrees, offsets in radii."""
        radius = self._balls["cue"].params.R
        cue = self._balls["cue"].state.rvw[0, :2]
        others = [
            ball.state.rvw[0, :2] - cue
            for name, ball in self._balls.items()
            if name != "cue" and ball.state.s != POCKETED
        ]
        way = min(others, key=lambda way: math.hypot(*way))
        across = max(-1.0, min(1.0, action[0] * 2 * radius / math.hypot(*way)))
        slow, fast, least = SPEED
        error, noise = self._random.standard_normal(5), self._noise
        out = max(1.0, math.hypot(action[2], action[3])) / OFFSET_USED
        speed = slow + (0.5 * (action[1] + 1)) ** 2 * (fast - slow) + noise.speed * error[0]
        azimuth = math.atan2(way[1], way[0]) + math.asin(across) + noise.azimuth * error[1]
        return {
            "V0": max(least, speed),
            "phi": math.degrees(azimuth),
            "theta": math.degrees(abs(noise.elevation * error[2])),
            # Positive to the left in pooltool.
            "a": -(action[2] / out + noise.side_m / radius * error[3]),
            "b": action[3] / out + noise.height_m / radius * error[4],
        }

    def _respot(self) -> None:
        """Puts the cue ball on the first free place on the head string."""
        ball = self._balls["cue"]
        lie = [b.state.rvw[0, :2] for name, b in self._balls.items() if name != "cue"]
        for x in np.linspace(0.1, 1.9, 50) * self._half[0]:
            place = np.array([x, 0.5 * self._half[1]])
            if all(math.hypot(*(place - other)) > 2.01 * ball.params.R for other in lie):
                break
        ball.state.rvw[:] = 0.0
        ball.state.rvw[0] = (*place, ball.params.R)
        ball.state.s = 0


def timed(environment: EightBall, actions: Array) -> list[float]:
    """Processor time of a step, s, for each of the actions, shape (n, 5 or more)."""
    taken = []
    for action in actions.tolist():
        start = time.process_time()
        environment.step(action)
        taken.append(time.process_time() - start)
    return taken

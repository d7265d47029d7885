"""A robot that watches, learns, plans and commands, on a simulated table: three-cushion.

    python examples/robot_loop.py [--learn 50] [--shots 100] [--seed 1]

The robot sees the balls with a camera, and moves a cue in a frame that it has calibrated; sensors
measure how the cue moved. The true table has other numbers than the preset, and the true cue has
errors that depend on each other and have a mean. From its first shots, in any direction, the
robot learns the table by their films and its own errors by the motions of the cue. From then on it
plays, and states the chance of every shot before it does. The last line compares the chances with
the results.
"""

from __future__ import annotations

import argparse
from dataclasses import replace
from typing import Any, NamedTuple

import carom
import numpy as np
from carom import learn
from carom.learn.table_model import TableModel

GAME, TABLE, RATE = "three-cushion", "carom-10ft", 50.0
SEEN = 0.0003  # error of the place of a ball at rest, m: a standard deviation, as all of these
FILMED = 0.001  # of a ball in one picture, m
MARKED = 0.0005  # of a mark of the table in the robot's frame, m
SENSED = (1e-4, 2e-4, 3e-3)  # of the tip, m, the direction, rad, and the speed of the cue, a share
FREE = (
    *("rolling.a", "cloth.sliding_friction", "ball_ball.restitution", "cushion.restitution.a"),
    *("cushion.friction.a", "table.length", "table.width", "frame.x", "frame.y"),
)


class CueMotion(NamedTuple):
    """How the cue moved, in the robot's frame: as a command has it."""

    tip: Any
    direction: Any
    speed: float


class Played(NamedTuple):
    """What the robot keeps of a shot."""

    seen: dict[str, np.ndarray]
    asked: CueMotion
    moved: CueMotion
    film: learn.TrackedShot


def frame_of(shot: carom.Shot) -> carom.Frame:
    """The game from there; a cue ball that touches a ball is played as it lies."""
    frame = carom.Frame.of_shot(GAME, shot)
    if frame.request.kind == "choice":
        frame.choose("play-on")
    return frame


class World:
    """The true table, cue and camera, which the robot does not know."""

    marks = np.array([(0.1, 0.2, 0.03), (1.3, 0.3, 0.03), (0.7, 2.5, 0.03), (1.2, 1.9, 0.3)])

    def __init__(self, seed: int, cushions: str = "han-2005") -> None:
        self.rng = np.random.default_rng(seed)
        model = TableModel(TABLE, {"base": "carom", "cushion": {"model": cushions}}, FREE)
        # Two steps of a number are what tables differ by.
        vector = model.clip(model.start + 2.0 * model.steps * self.rng.normal(size=len(FREE)))
        self.table, self.physics, self.camera = model.parts(vector)
        sigma = np.array([0.02, 0.002, 0.004, 0.0005, 0.0005])
        spread = np.diag(sigma**2)
        spread[1, 3] = spread[3, 1] = 0.5 * sigma[1] * sigma[3]  # the tip moves as the cue turns
        bias = (sigma * self.rng.normal(size=5)).tolist()
        self.cue = carom.Noise(covariance=spread, bias=bias, speed_relative=0.02)
        turn = np.array([(0, 1, 0), (-1, 0, 0), (0, 0, 1)])
        self.frame = carom.RobotFrame(turn, np.array([2.0, -1.0, 0.8]))
        self.balls: dict[str, Any] = {"cue": (0.5, 0.7), "yellow": (0.9, 2.0), "red": (0.4, 1.6)}

    def marks_measured(self) -> np.ndarray:
        """The marks of the table in the robot's frame, m."""
        return self.frame.to_robot(self.marks) + self.rng.normal(0, MARKED, self.marks.shape)

    def balls_seen(self) -> dict[str, np.ndarray]:
        """The balls in the camera's frame, m."""
        error = np.array(self.camera.offset) + self.rng.normal(0, SEEN, (3, 2))
        return {ball: np.array(self.balls[ball]) - error[i] for i, ball in enumerate(self.balls)}

    def play(self, asked: CueMotion, name: str) -> tuple[CueMotion, learn.TrackedShot, bool]:
        """The motion of the cue as it was measured, the film, and whether the shot scored."""
        lying = carom.Shot(self.table, self.balls, carom.Strike(1.0, 0.0), physics=self.physics)
        frame = frame_of(lying)
        seeds = self.rng.integers(2**31, size=2).tolist()
        # A cue beside the ball that the camera saw may miscue.
        strike = replace(self.frame.strike(lying, *asked), miscue="report")
        ruling = frame.play(strike, noise=self.cue, seed=seeds[0])
        shot, self.balls = ruling.trace.shot, frame.balls
        film = learn.synthetic(
            shot,
            rate=RATE,
            sigma=FILMED,
            clock_offset=0.3,
            offset=self.camera.offset,
            names=[name],
            seed=seeds[1],
        )
        true, random = self.frame.command(shot), self.rng.normal
        moved = CueMotion(
            np.array(true.tip) + random(0, SENSED[0], 3),
            np.array(true.direction) + np.array((*random(0, SENSED[1], 2), 0.0)),
            true.speed * (1 + random(0, SENSED[2])),
        )
        return moved, film.tracks[0], ruling.legal and frame.player == 0


class Robot:
    """What the robot has: its calibration, its shots, and what it learned from them."""

    def __init__(self, marks: np.ndarray, measured: np.ndarray, simulations: int) -> None:
        self.frame = carom.RobotFrame.fit(marks, measured, sigma=MARKED, vertical=(0, 0, 1))
        self.shots: dict[str, Played] = {}
        self.table: learn.Posterior | None = None
        self.errors: learn.PlayerPosterior | None = None
        self.rng = np.random.default_rng(0)
        self.sight = carom.Perception(SEEN)
        self.player = carom.Player(perception=self.sight, simulations=simulations)

    def lying(self, seen: dict[str, np.ndarray]) -> carom.Shot:
        """The balls on the table, as far as the robot knows it."""
        if self.table is None:
            table, physics = {"base": TABLE}, {"base": "carom"}
        else:
            table, physics = self.table.table, self.table.physics
            size = self.table.model.size(self.table.mean)
            seen = {ball: self.table.frame.to_table(place, size) for ball, place in seen.items()}
        layout, _ = carom.Layout.at(seen).repaired(0.01, table=table, physics=physics)
        return carom.Shot(table, layout, carom.Strike(1.0, 0.0), physics=physics)

    def probe(self, seen: dict[str, np.ndarray]) -> carom.Shot:
        """A shot from which to learn: in any direction, at a moderate speed."""
        speed, azimuth, side, height = self.rng.uniform((1, 0, -0.3, -0.2), (4, 6.28, 0.3, 0.3))
        return self.lying(seen).with_strike(speed=speed, azimuth=azimuth, side=side, height=height)

    def plan(self, seen: dict[str, np.ndarray]) -> tuple[carom.Shot, float]:
        """The best shot, and the chance that it scores."""
        assert self.errors is not None
        frame = frame_of(self.lying(seen))
        noise = self.errors.at(3.0).noise + self.beside(None)
        best = self.player.explain(frame, 1, noise=noise, posterior=self.table).best
        assert best is not None
        # Neither the table, nor the errors, nor the calibration is known exactly.
        other, made = self.frame.noise(best.shot) + self.beside(best.shot.azimuth), []
        for seed, noise in enumerate(self.errors.at(best.shot.speed or 3.0).draw(16)):
            chances = best.shot.evaluate(
                noise + other,
                128,
                seed,
                perception=self.sight,
                frame=frame,
                posterior=self.table,
                draws=4,
            )
            made.append(float(chances.turn_kept or 0.0))
        return best.shot, float(np.mean(made))

    def beside(self, azimuth: float | None) -> carom.Noise:
        """The error of the tip beside the ball: the cue goes to the ball where it is seen.

        A camera that is off is off for all balls, and by other lengths along and across the table.
        Only the part across the cue, which points to `azimuth` (rad), moves the tip; None: the
        mean of all directions.
        """
        assert self.table is not None
        off = self.table.covariance[-2:, -2:]  # of frame.x and frame.y, m²
        if azimuth is None:
            squared = 0.5 * np.trace(off)
        else:
            across = np.array((-np.sin(azimuth), np.cos(azimuth)))
            squared = across @ off @ across
        return carom.Noise(side_m=float(np.sqrt(SEEN**2 + squared)))

    def strike(self, shot: Played, motion: CueMotion) -> carom.Shot:
        """The strike of a cue's motion on the balls of a shot."""
        lying = self.lying(shot.seen)
        strike = self.frame.strike(lying, *motion)
        return carom.Shot(lying.table, lying.balls, strike, physics=lying.physics)

    def strikes(self, part: str) -> dict[str, carom.Shot]:
        """The strikes by the motions `asked` or `moved`, without those beyond the miscue limit."""
        found = {}
        for name, shot in self.shots.items():
            try:
                found[name] = self.strike(shot, getattr(shot, part))
            except carom.InputError as error:
                if error.kind != "miscue":
                    raise
        return found

    def learn(self) -> None:
        """Learns the table from the films, and its errors from the motions of the cue."""
        header = learn.TracksHeader(table=TABLE, sigma=FILMED, rate=RATE)
        tracks = learn.Tracks(header, tuple(shot.film for shot in self.shots.values()))
        near = self.strikes("moved")
        sensors = carom.Noise(
            azimuth=SENSED[1],
            elevation=SENSED[1],
            side_m=0.001,  # the offset of the camera moves all balls
            height_m=SENSED[0],
            speed_relative=SENSED[2],
        )
        self.table = learn.table(
            tracks, free=FREE, intended=near, noise=sensors, rounds=4, starts=4
        )
        # On the table as it is known now.
        meant = self.strikes("asked")
        played = [
            learn.PlayedStrike.exact(name, shot)
            for name, shot in self.strikes("moved").items()
            if name in meant
        ]
        self.errors = learn.player(played, meant, draws=400)


def play(world: World, robot: Robot) -> tuple[float | None, bool]:
    """Plays a shot. Returns the stated chance, None while the robot learns, and the result."""
    seen, chance = world.balls_seen(), None
    if robot.errors is None:
        shot = robot.probe(seen)
    else:
        shot, chance = robot.plan(seen)
    command = robot.frame.command(shot)
    asked = CueMotion(command.tip, command.direction, command.speed)
    name = str(len(robot.shots))
    moved, film, scored = world.play(asked, name)
    robot.shots[name] = Played(seen, asked, moved, film)
    return chance, scored


def main() -> None:
    """Learns, plays and compares."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--learn", type=int, default=50, help="shots before the robot learns")
    parser.add_argument("--shots", type=int, default=100, help="shots after it")
    parser.add_argument("--simulations", type=int, default=2000, help="of a decision")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    world = World(options.seed)
    robot = Robot(world.marks, world.marks_measured(), options.simulations)
    for _ in range(options.learn):
        play(world, robot)
    robot.learn()
    print(robot.table.summary(), robot.errors.summary(), sep="\n\n")
    results = [play(world, robot) for _ in range(options.shots)]
    stated, made = np.mean(results, axis=0)
    print(f"stated {stated:.1%}, made {made:.1%} of {len(results)} shots")


if __name__ == "__main__":
    main()

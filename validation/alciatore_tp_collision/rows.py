"""Ball against ball: 90° and 30° rules, throw, transfer (technical proofs 3.1–3.3, A.5–A.28)."""

import math

from carom.validation.lab import (
    JSON,
    MPH,
    TP_FRICTION,
    TP_RADIUS,
    TP_SPEEDS,
    Event,
    Run,
    ball,
    degrees_between,
    maximum,
    simulate,
    touching,
    tp_physics,
)
from carom.validation.row import Kind, absolute, relative, row

#: The cue ball moves along +y; positive cuts send the object ball to the left.
AIM = math.pi / 2


def impact(
    cut: float,
    speed: float = 1.0,
    *,
    roll: float = 0.0,
    english: float = 0.0,
    restitution: float = 1.0,
    friction: float | JSON = 0.0,
) -> Run:
    """A cue ball meets an object ball at cut angle `cut` (rad).

    `roll` is the cue ball's topspin in units of natural roll, `english` its Rω_z/v.
    """
    spin = (-roll * speed / TP_RADIUS, 0.0, english * speed / TP_RADIUS)
    law: JSON = {"model": "frictional", "restitution": restitution, "friction": friction}
    return simulate(
        ball(velocity=(0.0, speed, 0.0), spin=spin),
        ball("object", touching(cut, TP_RADIUS)),
        physics=tp_physics(ball_ball=law),
    )


def hit(run: Run) -> Event:
    return run.first("ball-collision")


def throw(run: Run, cut: float) -> float:
    """Degrees between the object ball's direction and the line of centres; > 0 towards the aim."""
    return degrees_between(AIM + cut, hit(run).after["object"].heading)


def deflection(run: Run) -> float:
    """Degrees between the cue ball's initial and final directions."""
    return degrees_between(AIM, run.rolling("cue").after["cue"].heading)


def rolled_speeds(run: Run) -> tuple[float, float]:
    """Speeds of the object ball and the cue ball when they start to roll, m/s."""
    object_ball = run.rolling("object").after["object"].speed
    return object_ball, run.rolling("cue").after["cue"].speed


def cut_of_fraction(fraction: float) -> float:
    """The cut angle at which `fraction` of the object ball is covered."""
    return math.asin(1.0 - fraction)


@row(
    "BB1",
    "Stun, no friction, e = 1: separation of 90°, speeds v cos φ and v sin φ",
    unit="°, v",
    source="TP 3.1, 3.2",
    kind=Kind.FORMULA,
    reference={
        "separation at 10°": 90.0,
        "separation at 30°": 90.0,
        "separation at 75°": 90.0,
        "half ball, cue ball's speed": 0.5,
        "half ball, object ball's speed": math.cos(math.pi / 6),
        "75°, cue ball's speed": math.sin(math.radians(75.0)),
        "75°, object ball's speed": math.cos(math.radians(75.0)),
    },
    # Relative to 90° and to 1.
    tolerance=relative(1e-9),
)
def bb1() -> list[float]:
    def after(cut: float) -> Event:
        law: JSON = {"model": "elastic", "restitution": 1.0}
        return hit(
            simulate(
                ball(velocity=(0.0, 1.0, 0.0)),
                ball("object", touching(cut, TP_RADIUS)),
                physics=tp_physics(ball_ball=law),
            )
        )

    hits = [after(math.radians(d)) for d in (10.0, 30.0, 75.0)]
    separations = [degrees_between(h.after["object"].heading, h.after["cue"].heading) for h in hits]
    speeds = [h.after[b].speed for h in hits[1:] for b in ("cue", "object")]
    return separations + speeds


@row(
    "BB2",
    "30° rule: final deflection of a rolling cue ball, e = 1, no friction",
    unit="°",
    source="TP 3.3",
    kind=Kind.PUBLISHED,
    reference={
        "¼ ball": 27.267,
        "½ ball": 33.670,
        "¾ ball": 27.626,
        "largest": 33.749,
        "at cut": 28.126,
    },
    tolerance=absolute(1e-3),
)
def bb2() -> list[float]:
    fractions = [deflection(impact(cut_of_fraction(f), roll=1.0)) for f in (0.25, 0.5, 0.75)]
    at, largest = maximum(lambda cut: deflection(impact(cut, roll=1.0)), 0.2, 0.9)
    return [*fractions, largest, math.degrees(at)]


@row(
    "BB3",
    "Stun at 30°: cue ball off the tangent line, object ball's throw, separation",
    unit="°",
    source="TP A.5",
    kind=Kind.PUBLISHED,
    reference={
        "θ1, e .94 μ .06": 3.307,
        "θ2, e .94 μ .06": 3.434,
        "separation, e .94 μ .06": 83.259,
        "separation, e .94 μ 0": 87.025,
        "separation, e 1 μ .06": 86.566,
    },
    tolerance=absolute(1e-3),
)
def bb3() -> list[float]:
    cut = math.radians(30.0)

    def separation(run: Run) -> float:
        after = hit(run).after
        return degrees_between(after["object"].heading, after["cue"].heading)

    both = impact(cut, restitution=0.94, friction=0.06)
    tangent = AIM + cut - math.pi / 2
    return [
        degrees_between(hit(both).after["cue"].heading, tangent),
        throw(both, cut),
        separation(both),
        separation(impact(cut, restitution=0.94)),
        separation(impact(cut, friction=0.06)),
    ]


@row(
    "BB5",
    "Rolling cue ball, half ball: final deflection with friction and restitution",
    unit="°",
    source="TP A.6",
    kind=Kind.PUBLISHED,
    reference={"e 1, μ .06": 35.907, "e .94, μ 0": 31.988, "e .94, μ .06": 34.026},
    tolerance=absolute(2e-3),
)
def bb5() -> list[float]:
    cut = math.radians(30.0)
    return [
        deflection(impact(cut, roll=1.0, restitution=e, friction=mu))
        for e, mu in ((1.0, 0.06), (0.94, 0.0), (0.94, 0.06))
    ]


def stun_throw(cut_degrees: float, speed: float) -> float:
    cut = math.radians(cut_degrees)
    return throw(impact(cut, speed, friction=TP_FRICTION), cut)


@row(
    "BB7",
    "Throw of a stun shot with friction that decreases with slip speed",
    unit="°",
    source="TP A.14 (formula)",
    kind=Kind.FORMULA,
    reference={
        "10°, slow": 1.443,
        "10°, medium": 1.443,
        "10°, fast": 1.443,
        "30°, slow": 4.715,
        "30°, medium": 3.549,
        "30°, fast": 1.697,
        "45°, slow": 4.945,
        "45°, medium": 2.773,
        "45°, fast": 1.127,
        "60°, slow": 4.621,
        "60°, medium": 2.318,
        "60°, fast": 0.894,
    },
    tolerance=absolute(2e-3),
)
def bb7() -> list[float]:
    return [stun_throw(d, v) for d in (10.0, 30.0, 45.0, 60.0) for v in TP_SPEEDS.values()]


@row(
    "BB8",
    "Largest throw of a stun shot, and the cut at which it occurs",
    unit="°",
    source="TP A.14 (plots)",
    kind=Kind.FORMULA,
    reference={
        "slow": 5.302,
        "slow, at cut": 33.0,
        "medium": 3.876,
        "medium, at cut": 25.4,
        "fast": 2.698,
        "fast, at cut": 18.26,
    },
    # The cut is given to a tenth of a degree for slow and medium shots.
    tolerance=(
        *(absolute(0.005), absolute(0.05)),
        *(absolute(0.005), absolute(0.05)),
        *(absolute(0.005), absolute(0.005)),
    ),
)
def bb8() -> list[float]:
    found = []
    for v in TP_SPEEDS.values():
        at, largest = maximum(lambda d, v=v: stun_throw(d, v), 5.0, 60.0)  # type: ignore[misc]
        found += [largest, at]
    return found


@row(
    "BB10",
    "Throw by sidespin alone: straight hit, english 25, 50, 100 %",
    unit="°",
    source="TP A.14, A.27 (formula)",
    kind=Kind.FORMULA,
    reference={
        "25 %, slow": 2.556,
        "25 %, medium": 2.556,
        "25 %, fast": 2.556,
        "50 %, slow": 5.102,
        "50 %, medium": 3.053,
        "50 %, fast": 1.307,
        "100 %, slow": 3.933,
        "100 %, medium": 1.568,
        "100 %, fast": 0.658,
    },
    tolerance=absolute(2e-3),
)
def bb10() -> list[float]:
    return [
        # English to the right (ω_z > 0) throws the object ball to the left.
        -throw(impact(0.0, v, english=1.25 * share, friction=TP_FRICTION), 0.0)
        for share in (0.25, 0.5, 1.0)
        for v in TP_SPEEDS.values()
    ]


@row(
    "BB11",
    "2 mph at 30°: throw of stun and of roll or draw; swerve of the object ball after it",
    unit="°",
    source="TP A.24",
    kind=Kind.PUBLISHED,
    reference={
        "throw, stun": 4.366,
        "throw, roll": 1.454,
        "throw, draw": 1.454,
        "swerve, roll": -0.067,
        "swerve, draw": 0.061,
    },
    tolerance=absolute(2e-3),
)
def bb11() -> list[float]:
    cut = math.radians(30.0)
    runs = [impact(cut, 2 * MPH, roll=k, friction=TP_FRICTION) for k in (0.0, 1.0, -1.0)]

    def swerve(run: Run) -> float:
        first = hit(run).after["object"].heading
        return degrees_between(run.rolling("object").after["object"].heading, first)

    return [*(throw(r, cut) for r in runs), swerve(runs[1]), swerve(runs[2])]


@row(
    "BB13",
    "Spin that a straight stop shot with 50 % english transfers to the object ball",
    unit="%",
    source="TP A.27 (5/14 = 35.71 % at most)",
    kind=Kind.FORMULA,
    reference={"slow": 35.7, "medium": 21.3, "fast": 9.1},
    tolerance=absolute(0.1),
)
def bb13() -> list[float]:
    found = []
    for v in TP_SPEEDS.values():
        event = hit(impact(0.0, v, english=0.625, friction=TP_FRICTION))
        given, had = event.after["object"].spin[2], event.before["cue"].spin[2]
        found.append(-100.0 * float(given / had))
    return found


@row(
    "BB15",
    "Rolling cue ball, e = 1, no friction: speeds when both balls roll",
    unit="%, %, %, %, –, °",
    source="TP A.16",
    kind=Kind.PUBLISHED,
    reference={
        "half ball, object ball": 61.859,
        "half ball, cue ball": 55.787,
        "full, object ball": 71.429,
        "full, cue ball": 28.571,
        "full, distance ratio": 6.25,
        "equal speeds at cut": 33.211,
    },
    tolerance=absolute(5e-3),
)
def bb15() -> list[float]:
    def speeds(cut: float) -> tuple[float, float]:
        return rolled_speeds(impact(cut, roll=1.0))

    def difference(cut: float) -> float:
        object_ball, cue_ball = speeds(cut)
        return object_ball - cue_ball

    half = speeds(math.radians(30.0))
    full = speeds(0.0)
    low, high = 0.3, 0.9
    while high - low > 1e-7:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if difference(middle) > 0.0 else (low, middle)
    run = impact(0.0, roll=1.0)
    # Distances that the balls roll after sliding.
    rolled = {
        b: float(run.final[b].position[1] - run.rolling(b).after[b].position[1])
        for b in ("object", "cue")
    }
    return [
        *(100 * s for s in half),
        *(100 * s for s in full),
        rolled["object"] / rolled["cue"],
        math.degrees(0.5 * (low + high)),
    ]


FROZEN_CUTS = (8, 20, 34, 46, 57, 67, 77)
FROZEN_ANGLES = (13, 34, 50, 61, 70, 78, 87)
#: Radius of the preset's balls, m.
PRESET_RADIUS = 0.028575


def frozen(cut_degrees: float, speed: float = 1.0, model: str | None = None) -> float:
    """Direction of a cue ball that is struck while frozen to the object ball, ° off the centres.

    `model` is the model of the strike, by default that of the preset `pool`.
    """
    cut = math.radians(cut_degrees)
    run = simulate(
        ball(),
        ball("object", touching(cut, PRESET_RADIUS)),
        physics="pool" if model is None else {"base": "pool", "cue": {"model": model}},
        strike={"ball": "cue", "speed": speed, "azimuth_deg": 90.0, "elevation_deg": 0.0},
    )
    impact = next(event for event in run.events if "object" in event.after)
    return degrees_between(AIM + cut, impact.after["cue"].heading)


@row(
    "BB28",
    "Cue ball frozen to the object ball: the cue ball's direction, from the line of centres",
    unit="°",
    source="TP A.15",
    kind=Kind.MEASURED,
    reference={
        f"aim {cut}° off the centres": float(angle)
        for cut, angle in zip(FROZEN_CUTS, FROZEN_ANGLES, strict=True)
    },
    tolerance=absolute(4.0),
    held=True,
    uses_preset=True,
    note="Tip and both balls are in contact together. Nothing was fitted to these angles. With the "
    "model `sequential`, in which the tip's contact ends before the balls collide, the cue ball "
    "leaves at 78° to 90°.",
)
def bb28() -> list[float]:
    return [frozen(cut) for cut in FROZEN_CUTS]


@row(
    "BB29",
    "The same against the formula tan θ = 2 tan φ, cue at 1 and 3 m/s",
    unit="°",
    source="TP A.15",
    kind=Kind.FORMULA,
    reference={
        f"{cut}°, {speed:g} m/s": math.degrees(math.atan(2.0 * math.tan(math.radians(cut))))
        for speed in (1.0, 3.0)
        for cut in FROZEN_CUTS
    },
    tolerance=absolute(2.0),
    uses_preset=True,
    note="The formula has neither friction nor losses; the preset has both.",
)
def bb29() -> list[float]:
    return [frozen(cut, speed) for speed in (1.0, 3.0) for cut in FROZEN_CUTS]

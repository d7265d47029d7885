"""The engine compared event by event with two oracles, which share no code with it.

`stepping` integrates the force laws through time; `precise` solves event times with 50 digits. Both
take over the engine's states after each event, so that each event is compared separately; for a
few events they also run alone. The oracles take the geometry of tables with pockets and the state
after a strike from the engine; `oracles/__init__.py` lists the models that they cover.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import carom
import pytest

from oracles import laws
from oracles.compare import follow
from oracles.precise import Precise
from oracles.shots import (
    PHYSICS,
    RECTANGLE,
    flight_at_a_pocket,
    random_flight,
    random_shot,
    random_stroke,
)
from oracles.stepping import Stepping
from oracles.world import geometry_of, start_of, state_of, world_of

if TYPE_CHECKING:
    from collections.abc import Callable

JSON = dict[str, Any]

#: Accuracy of the integrator at each event, m, m/s, s (its tolerance is 1e-13 per step).
STEPPED = 1e-10
#: Accuracy of doubles at each event against 50 digits: a few roundings, more at grazing contacts.
EXACT = 1e-13
#: The same after a few events without resynchronisation, because a shot magnifies differences.
ALONE = 1e-8

UNBOUNDED: JSON = {"cloth": "unbounded"}
ELASTIC: JSON = {"model": "elastic", "restitution": 0.95}
REFLECTING: JSON = {"model": "restitution", "restitution": 0.8}
#: All models of two balls, from the schema of shot files; the integral `mathavan-2014` has tests of
#: its own.
BALL_MODELS = [
    name
    for name in carom.schema("shot")["$defs"]["physics"]["oneOf"][1]["properties"]["ball_ball"][
        "properties"
    ]["model"]["enum"]
    if name != "mathavan-2014"
]


def play(shot: JSON) -> list[JSON]:
    events: list[JSON] = carom.Shot.from_dict(shot).simulate().to_dict()["events"]
    return events


def struck(events: list[JSON]) -> JSON | None:
    """The strike, which the oracles do not simulate."""
    return next((e for e in events if e["type"] == "cue-strike"), None)


@pytest.mark.parametrize("seed", range(8))
def test_integrating_the_force_laws_gives_the_engines_events(seed: int) -> None:
    shot = random_shot(seed, balls=6)
    world = world_of(shot)
    worst = follow(Stepping(world, start_of(shot)), world, play(shot), resync=True)
    assert worst.events > 5
    assert worst.largest < STEPPED, worst


def pocket_table(name: str) -> JSON:
    return next(table for table in carom.tables() if table["name"] == name)


#: Shots with contacts at points and facings, or with pocketed balls, or both.
AMONG_JAWS = [
    *(("wpa-9ft", seed) for seed in (8, 15, 17, 45, 47, 49)),
    *(("snooker-12ft", seed) for seed in (5, 9, 33, 57)),
]


@pytest.mark.parametrize(("name", "seed"), AMONG_JAWS)
def test_integration_gives_the_engines_events_at_jaws_and_pockets(name: str, seed: int) -> None:
    table = pocket_table(name)
    shot = random_shot(seed, 6, table=name, size=tuple(table["size"]))
    events = play(shot)
    assert any(e.get("part") in ("point", "facing") or "pocket" in e for e in events)
    world = world_of(shot, geometry_of(table))
    worst = follow(Stepping(world, start_of(shot)), world, events, resync=True)
    assert worst.largest < STEPPED, worst


@pytest.mark.parametrize("make", [random_flight, random_stroke])
@pytest.mark.parametrize("seed", range(6))
def test_integration_gives_the_engines_events_of_flying_balls(
    seed: int, make: Callable[..., JSON]
) -> None:
    shot = make(seed, balls=5)
    events = play(shot)
    assert any(e["type"] == "slate-collision" for e in events)
    world = world_of(shot)
    start = start_of(shot, struck(events))
    worst = follow(Stepping(world, start), world, events, resync=True)
    assert worst.largest < STEPPED, worst


CUE: JSON = PHYSICS["cue"]
#: Tips with a restitution (Leckie & Greenspan) and an efficiency (TP A.30), and squirt (TP A.31).
CUES: dict[str, JSON] = {
    "leckie and greenspan": CUE,
    "squirt": {**CUE, "end_mass": 0.006},
    "efficiency": {k: v for k, v in CUE.items() if k != "tip_restitution"}
    | {"end_mass": 0.004, "tip_efficiency": 0.95},
}


@pytest.mark.parametrize("cue", CUES)
@pytest.mark.parametrize("seed", range(20))
def test_a_strike_with_an_elevated_cue_follows_the_published_equations(seed: int, cue: str) -> None:
    shot = random_stroke(seed, balls=2, cue=CUES[cue])
    played = struck(play(shot))
    assert played is not None
    (state,) = map(state_of, played["after"])
    ball = shot["balls"][0]
    x, y = ball["position"]
    zero = (0.0, 0.0, 0.0)
    rest = laws.Body(ball["mass"], ball["radius"], (x, y, ball["radius"]), zero, zero)
    body = laws.strike(shot["physics"]["cue"], shot["strike"], rest)
    assert state.velocity == pytest.approx(body.velocity, abs=EXACT)
    assert state.spin == pytest.approx(body.spin, abs=EXACT / ball["radius"])


#: Flights at pockets: over the lip, against points, facings and liners, on the rails' tops.
FLYING_AMONG_JAWS = [
    *(("wpa-9ft", seed) for seed in range(7)),
    *(("snooker-12ft", seed) for seed in range(3)),
]


@pytest.mark.parametrize(("name", "seed"), FLYING_AMONG_JAWS)
def test_integration_gives_the_engines_events_of_flights_at_pockets(name: str, seed: int) -> None:
    table = pocket_table(name)
    shot = flight_at_a_pocket(seed, table)
    events = play(shot)
    world = world_of(shot, geometry_of(table))
    worst = follow(Stepping(world, start_of(shot)), world, events, resync=True)
    assert worst.largest < STEPPED, worst


@pytest.mark.parametrize("seed", range(6))
def test_integration_alone_gives_the_first_events(seed: int) -> None:
    shot = random_shot(seed, balls=6)
    world = world_of(shot)
    worst = follow(Stepping(world, start_of(shot)), world, play(shot), resync=False, limit=6)
    assert worst.largest < ALONE, worst


#: The resistance grows with speed, falls with it, and has a band that ends near rest.
BANDS: dict[str, list[JSON]] = {
    "growing": [
        {"up_to": 0.1, "friction": 0.006},
        {"up_to": 0.4, "friction": 0.01},
        {"friction": 0.02},
    ],
    "falling": [{"up_to": 0.15, "friction": 0.03}, {"friction": 0.008}],
    "near rest": [{"up_to": 0.01, "friction": 0.02}, {"friction": 0.01}],
}


@pytest.mark.parametrize("bands", BANDS)
@pytest.mark.parametrize("seed", range(4))
def test_both_oracles_give_the_engines_events_in_bands_of_speed(seed: int, bands: str) -> None:
    cloth = {**PHYSICS["cloth"], "rolling_friction": BANDS[bands]}
    shot = random_shot(seed, balls=4, cloth=cloth)
    world, events = world_of(shot), play(shot)
    rolls_on = [e for e in events if e.get("from") == e.get("to") == "rolling"]
    assert rolls_on
    worst = follow(Precise(world, start_of(shot)), world, events, resync=True)
    assert worst.largest < EXACT, worst
    worst = follow(Stepping(world, start_of(shot)), world, events, resync=True)
    assert worst.largest < STEPPED, worst


#: Restitution that falls with speed from above its upper limit to its lower one, and friction that
#: grows, or falls to 0, with the angle. The balls meet the rails at up to 5 m/s.
FITS: dict[str, JSON] = {
    "falling": {
        "restitution": {"a": 1.0, "b": -0.15, "c": 0.0, "lowest": 0.6, "highest": 0.92},
        "friction": {"a": 0.1, "b": 0.15},
    },
    "rising": {
        "restitution": {"a": 0.4, "b": 0.15, "c": -0.01, "lowest": 0.5, "highest": 0.75},
        "friction": {"a": 0.2, "b": -0.3},
    },
}
RAILS: dict[str, JSON] = {
    "restitution": {},
    "factors": {"tangential_factor": 0.9, "spin_factor": 0.3},
    "han-2005": {},
    "stronge": {"frequency_ratio": 1.53},
}
#: These shots reach both limits and the range between them, and no ball is pressed on a rail.
FITTED_SEEDS = (2, 5)


@pytest.mark.parametrize("model", RAILS)
@pytest.mark.parametrize("fit", FITS)
@pytest.mark.parametrize("seed", FITTED_SEEDS)
def test_both_oracles_give_the_engines_events_between_fitted_rails(
    seed: int, fit: str, model: str
) -> None:
    cushion = {"model": model, **RAILS[model], **FITS[fit]}
    shot = random_shot(seed, balls=4, cushion=cushion)
    world, events = world_of(shot), play(shot)
    assert any(e["type"] == "rail-collision" for e in events)
    worst = follow(Precise(world, start_of(shot)), world, events, resync=True)
    assert worst.largest < EXACT, worst
    worst = follow(Stepping(world, start_of(shot)), world, events, resync=True)
    assert worst.largest < STEPPED, worst


def test_the_fitted_rails_are_met_at_both_limits_and_between_them() -> None:
    for fit in FITS.values():
        law = fit["restitution"]
        found = set()
        for seed in FITTED_SEEDS:
            for e in play(random_shot(seed, balls=4, cushion={"model": "han-2005", **fit})):
                if e["type"] == "rail-collision":
                    v = e["before"][0]["velocity"]
                    speed = abs(v[0] if e["rail"] in ("left", "right") else v[1])
                    value = law["a"] + law["b"] * speed + law["c"] * speed**2
                    found.add((value > law["lowest"]) + (value > law["highest"]))
        assert found == {0, 1, 2}


@pytest.mark.parametrize("model", BALL_MODELS)
@pytest.mark.parametrize("cling", [{"contacts": [0, 2]}, {"contacts": [1], "friction": 0.35}])
@pytest.mark.parametrize("seed", [0, 5])
def test_both_oracles_give_the_engines_events_with_clings(
    seed: int, cling: JSON, model: str
) -> None:
    ball_ball = {**PHYSICS["ball_ball"], "model": model, "frequency_ratio": 1.7}
    shot = {**random_shot(seed, balls=6, ball_ball=ball_ball), "cling": cling}
    world, events = world_of(shot), play(shot)
    assert sum(e["type"] == "ball-collision" for e in events) > 2
    worst = follow(Precise(world, start_of(shot)), world, events, resync=True)
    assert worst.largest < EXACT, worst
    worst = follow(Stepping(world, start_of(shot)), world, events, resync=True)
    assert worst.largest < STEPPED, worst


#: On the cloth, thrown or dropped, and struck by an elevated cue.
EXACT_SHOTS = [
    *((random_shot, seed) for seed in range(8)),
    *((random_flight, seed) for seed in range(4)),
    *((random_stroke, seed) for seed in range(4)),
]


@pytest.mark.parametrize(("make", "seed"), EXACT_SHOTS)
@pytest.mark.parametrize(
    ("table", "physics"),
    [
        (RECTANGLE, {}),
        (RECTANGLE, {"ball_ball": ELASTIC, "cushion": REFLECTING}),
        (UNBOUNDED, {}),
    ],
    ids=["friction and han-2005", "elastic and restitution", "unbounded"],
)
def test_fifty_digits_give_the_engines_events(
    seed: int, table: JSON, physics: JSON, make: Callable[..., JSON]
) -> None:
    shot = make(seed, balls=4, table=table, **physics)
    world = world_of(shot)
    events = play(shot)
    start = start_of(shot, struck(events))
    worst = follow(Precise(world, start), world, events, resync=True)
    assert worst.events > 1
    assert worst.largest < EXACT, worst

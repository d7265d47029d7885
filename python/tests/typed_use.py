"""What a type checker knows of carom. mypy reads this file (pyproject.toml); a test runs it.

Each ``type: ignore`` marks an error that mypy must find: without the error it reports the comment.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal, assert_type

import carom
import carom.env
from carom.events import BallState, Outcome, TraceEvent
from carom.request import CallKind, Foul, GameState, Region, Request


def of_a_trace(trace: carom.Trace) -> None:
    """Events and outcome."""
    assert_type(trace.outcome, Outcome)
    assert_type(trace.outcome.first_contact, str | None)
    assert_type(trace.outcome.pocketed, list[list[str]])
    assert_type(trace.outcome["events"], Any)
    assert_type(trace.events, list[TraceEvent])
    event = trace.events[0]
    assert_type(event.time, float)
    assert_type(event.before[0], BallState)
    assert_type(event.before[0].position, list[float])
    if event.type == "cue-strike":
        assert_type(event.tip_contacts, int)
        try:
            _ = event.rail  # type: ignore[attr-defined]
        except AttributeError:
            return
    raise AssertionError("an event without a rail has one")


def of_transitions(trace: carom.Trace) -> list[str]:
    """Events of one kind, by their type."""
    return [f"{e.from_} {e.to}" for e in trace.events if e.type == "motion-transition"]


def of_a_frame(frame: carom.Frame) -> None:
    """The request, the state and the ruling."""
    request = frame.request
    assert_type(request, Request)
    assert_type(request.winner, Literal[0, 1] | None)
    assert_type(request.in_hand, Region | None)
    assert_type(request.on[0], str)
    assert_type(frame.state, GameState)
    assert_type(frame.winner, int | None)
    if request.kind == "shot":
        assert_type(request.cue_ball, str)
        assert_type(request.player, Literal[0, 1])
        kind: CallKind = request.calls[0]
        assert kind == "nothing"
    try:
        _ = request.kid  # type: ignore[union-attr]
    except AttributeError:
        return
    raise AssertionError("a misspelled attribute exists")


def of_a_ruling(ruling: carom.Ruling) -> None:
    """Its fouls and its trace."""
    for foul in ruling.fouls:
        assert_type(foul, Foul)
        assert_type(foul.rule, str)
    assert_type(ruling.trace, carom.Trace | None)


def of_a_shot(shot: carom.Shot) -> None:
    """Its parts, and its questions, which are methods."""
    assert_type(shot.strike, carom.Strike | None)
    assert_type(shot.table, carom.Table)
    assert_type(shot.balls[0].id, str)
    assert_type(shot.batch(azimuth=[1.0]), carom.BatchResult)
    assert_type(shot.evaluate(carom.Noise.preset("club"), n=10), carom.Evaluation)
    try:
        _ = shot.spped  # type: ignore[attr-defined]
        shot.batch(azimut=1.0)  # type: ignore[call-arg]
    except AttributeError:
        return
    raise AssertionError("a misspelled attribute exists")


def of_environments() -> None:
    """The settings of each kind are keywords with types, and no others are."""
    carom.env.CaromEnv("nine-ball", aim="relative", opponent="level-2", seat="random", balls=(2, 4))
    carom.env.CaromEnv("nine-ball", opponent=lambda rows: rows, speed=(0.5, 4.0), threads=None)
    carom.env.CaromVectorEnv("potting", 2, autoreset_mode="disabled", table=["wpa-9ft", None])
    settings: carom.env.Settings = {"noise": carom.Noise.preset("club"), "patience": 20}
    carom.env.CaromVectorEnv("nine-ball", **settings)
    carom.env.aec("nine-ball", rewards=carom.env.Rewards(win=1.0), max_episode_steps=5)
    wrong: list[Callable[[], object]] = [
        lambda: carom.env.CaromEnv("potting", elevation=0.1),  # type: ignore[call-arg]
        lambda: carom.env.CaromEnv("potting", aim="straight"),  # type: ignore[arg-type]
        lambda: carom.env.CaromVectorEnv("potting", patience=2.5),  # type: ignore[arg-type]
        lambda: carom.env.aec("nine-ball", opponent="random"),  # type: ignore[call-arg]
    ]
    for make in wrong:
        try:
            make()
        except carom.InputError:
            continue
        raise AssertionError("a wrong setting is accepted")

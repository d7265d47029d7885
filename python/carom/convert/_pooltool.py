"""Systems of pooltool, in the format that ``System.save`` of pooltool 0.6 writes."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import Any

from carom.convert._made import TOLERANCE, Converted, made
from carom.convert._msgpack import unpack
from carom.convert._place import Place
from carom.convert._pooltool_table import table
from carom.errors import InputError
from carom.files import checked_path, refuse_other_encoding, shown

_POCKETED = 4
# A ball whose height differs from its radius by less than this is on the cloth, m.
_ON_CLOTH = 1e-9
# The fields of BallParams other than a ball's own mass and radius.
_SHARED = ("u_s", "u_r", "u_sp_proportionality", "e_b", "e_c", "f_c", "g")


def pooltool(
    source: str | os.PathLike[str] | bytes | Mapping[str, Any], *, tolerance: float = TOLERANCE
) -> Converted:
    """Convert a pooltool system to a shot.

    A simulated system gives the shot from its start.

    Args:
        source: Path of a file that ``System.save`` wrote (JSON or MessagePack), its bytes, or its
            content as a dict.
        tolerance: Largest overlap of balls and cushions that is removed (``Layout.repaired``), m;
            ``left_out`` lists the balls that moved.

    Raises:
        OSError: The file cannot be read.
        InputError: It is not a system of pooltool 0.6, the engine rejects the shot, or msgpack is
            needed and not installed (``pip install 'carom[import]'``).
    """
    tree = _tree(source)
    system = Place(tree)
    if isinstance(tree, Mapping) and "multisystem" in tree:
        raise system.refuse("format", "is a MultiSystem", "save one of its systems by itself")
    notes: list[str] = []
    where, kind = table(system["table"], notes)
    balls = _balls(system["balls"], notes)
    moves = any("velocity" in ball or "angular_velocity" in ball for ball in balls)
    file: dict[str, Any] = {
        "format": "carom-shot/1",
        "table": where,
        "physics": _physics(system, kind, notes),
        "balls": balls,
    }
    strike = _strike(system["cue"], moves, notes)
    if strike is not None:
        file["strike"] = strike
    return made(file, notes, tolerance)


def _tree(source: Any) -> Any:
    """The tree of a file, of bytes or of a dict."""
    if isinstance(source, Mapping):
        return source
    if isinstance(source, bytes):
        return _decode(source)
    if isinstance(source, str | os.PathLike):
        path = checked_path("source", source, "shot.msgpack")
        data = path.read_bytes()
        refuse_other_encoding(data, shown(path))
        return _decode(data)
    kind = type(source).__name__
    raise InputError(
        "wrong-type", "source", f"found a {kind}", "give a file's path, its bytes, or a dict"
    )


def _decode(data: bytes) -> Any:
    if not data.lstrip().startswith((b"{", b"[")):
        return unpack(data)
    try:
        return json.loads(data)
    except json.JSONDecodeError as error:
        raise InputError(
            "syntax",
            "",
            f"the file is not JSON: {error.msg} (line {error.lineno}, column {error.colno})",
            "give a system that pooltool saved",
            {"line": error.lineno, "column": error.colno},
        ) from None
    except ValueError as error:
        raise InputError(
            "syntax", "", f"the file is not JSON ({error})", "give a system that pooltool saved"
        ) from None
    except RecursionError:
        raise InputError(
            "syntax", "", "the file is nested too deeply", "give a system that pooltool saved"
        ) from None


def _balls(at: Place, notes: list[str]) -> list[dict[str, Any]]:
    placed, pocketed, simulated = [], [], False
    for name, ball in at.members():
        state, was_simulated = _first_state(ball)
        simulated |= was_simulated
        if state[1] == _POCKETED:
            pocketed.append(name)
            continue
        params = ball["params"]
        radius = params["R"].number()
        position, velocity, spin = (Place(v, f"{ball.path}.state.rvw").vector() for v in state[0])
        if abs(position[2] - radius) <= _ON_CLOTH:
            del position[2]
        entry: dict[str, Any] = {"id": name, "position": position}
        if any(velocity):
            entry["velocity"] = velocity
        if any(spin):
            entry["angular_velocity"] = spin
        placed.append(entry | {"mass": params["m"].number(), "radius": radius})
    if simulated:
        notes.append("The system had been simulated: the shot is the one from its start.")
    if pocketed:
        notes.append(f"Pocketed balls were left out: {', '.join(pocketed)}.")
    return placed


def _first_state(ball: Place) -> tuple[Any, bool]:
    """The initial rows of ``rvw`` and ``s``, and whether they come from a history.

    A history is a list of states in JSON, and a list of three arrays (rvw, s, t) in MessagePack.
    """
    history = ball.get("history")
    if history is not None and isinstance(history.value, Mapping):
        history = history["states"]
    if history is None or not history.value:
        now = ball["state"]
        return (now["rvw"].items(), now["s"].number()), False
    if isinstance(history[0].value, Mapping):
        return (history[0]["rvw"].items(), history[0]["s"].number()), True
    return (history[0][0].items(), history[1][0].number()), True


def _physics(system: Place, base: str, notes: list[str]) -> dict[str, Any]:
    balls = dict(system["balls"].members())
    struck = system["cue"]["cue_ball_id"].text()
    if struck not in balls:
        raise system["cue"].refuse(
            "unknown-ball",
            f'cue_ball_id is "{struck}", but there is no such ball',
            "write the id of a ball",
        )
    params = balls[struck]["params"]
    p = {key: params[key].number() for key in ("m", "R", *_SHARED)}
    others = [
        name
        for name, ball in balls.items()
        if any(ball["params"][key].number() != p[key] for key in _SHARED)
    ]
    if others:
        notes.append(
            f"All balls have the cue ball's frictions, restitutions and gravity; those of "
            f"{', '.join(others)} differed."
        )
    notes.append(
        "A system does not name the models that simulated it; pooltool 0.6.0's default models "
        "were assumed (they do not use its u_b)."
    )
    notes.append(
        "pooltool 0.6.0 keeps balls on the cloth; the walls of pockets, and balls that climb or "
        "jump, follow this engine's preset."
    )
    specs = system["cue"]["specs"]
    surface = {"restitution": p["e_c"], "friction": p["f_c"]}
    return {
        "base": base,
        "gravity": p["g"],
        "ball": {"mass": p["m"], "radius": p["R"]},
        "cloth": {
            "sliding_friction": p["u_s"],
            "rolling_friction": p["u_r"],
            # dω_z/dt = −5·u_sp·g/(2R) with u_sp = u_sp_proportionality·R.
            "spin_deceleration": 2.5 * p["u_sp_proportionality"] * p["g"],
        },
        "ball_ball": {
            "model": "frictional",
            "restitution": p["e_b"],
            "friction": {"a": 0.009951, "b": 0.108, "c": 1.088},
        },
        "cushion": {"model": "stronge", **surface, "frequency_ratio": 1.8},
        "facing": surface,
        # pooltool drops the downward part of a strike with a raised cue.
        "slate": {"restitution": 0.0, "friction": 0.0},
        "cue": {
            "mass": specs["M"].number(),
            "end_mass": specs["end_mass"].number(),
            "tip_radius": specs["tip_radius"].number(),
            "tip_restitution": 1.0,
        },
    }


def _strike(cue: Place, moves: bool, notes: list[str]) -> dict[str, Any] | None:
    speed = cue["V0"].number()
    if moves:
        notes.append("Balls move already, so pooltool would not strike: the shot has no strike.")
        return None
    if speed == 0.0:
        notes.append("The cue's speed V0 is 0: the shot has no strike.")
        return None
    return {
        "ball": cue["cue_ball_id"].text(),
        "speed": speed,
        "azimuth_deg": cue["phi"].number(),
        "elevation_deg": cue["theta"].number(),
        # a = +1 is the leftmost point.
        "side": -cue["a"].number(),
        "height": cue["b"].number(),
        # pooltool has no miscues.
        "miscue": "report",
    }

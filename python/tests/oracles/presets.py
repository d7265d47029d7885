"""The physics presets, copied from their published sources.

The engine is given a preset's name and the oracles these numbers, so that a preset that changes
without a reason is found. The sources are in `crates/carom/src/physics/presets.rs`.
"""

from __future__ import annotations

from typing import Any

JSON = dict[str, Any]

#: How the tip's restitution falls off the centre.
LOSS: JSON = {"tip_off_centre_loss": 5.388423}

POOL: JSON = {
    "gravity": 9.80665,
    "ball": {"mass": 0.170097, "radius": 0.028575},
    "cloth": {"sliding_friction": 0.2, "rolling_friction": 0.01, "spin_deceleration": 10.0},
    "ball_ball": {
        "model": "compliant",
        "restitution": 0.95,
        "friction": {"a": 0.0, "b": 0.115, "c": 0.41},
        "frequency_ratio": 1.7,
    },
    "cushion": {"model": "stronge", "restitution": 0.9, "friction": 0.175, "frequency_ratio": 1.8},
    "facing": {"restitution": 0.7, "friction": 0.25},
    "liner": {"restitution": 0.35, "friction": 0.15},
    "slate": {"restitution": 0.5, "friction": 0.2},
    "cue": {"mass": 0.567, "end_mass": 0.00567, "tip_restitution": 0.73, **LOSS},
}

SNOOKER: JSON = {
    **POOL,
    "ball": {"mass": 0.1406, "radius": 0.02625},
    "cloth": {"sliding_friction": 0.212, "rolling_friction": 0.0128, "spin_deceleration": 22.0},
    "ball_ball": {**POOL["ball_ball"], "restitution": 0.89, "friction": 0.05},
    "cushion": {
        "model": "stronge",
        "restitution": {"a": 1.24, "b": -0.132, "c": 0.0066},
        "friction": 0.38,
        "frequency_ratio": 1.7,
    },
    "cue": {"mass": 0.48, "end_mass": 0.0047, "tip_restitution": 0.73, **LOSS},
}

ENGLISH: JSON = {
    **SNOOKER,
    "ball": {"mass": 0.116, "radius": 0.0254},
    "ball_ball": POOL["ball_ball"],
    "cue": {**SNOOKER["cue"], "end_mass": 0.0039},
}

CAROM: JSON = {
    **POOL,
    "ball": {"mass": 0.210, "radius": 0.03075},
    "cloth": {"sliding_friction": 0.2, "rolling_friction": 0.0045, "spin_deceleration": 3.9},
    "ball_ball": {**POOL["ball_ball"], "restitution": 0.98},
    "cue": {"mass": 0.51, "end_mass": 0.007, "tip_restitution": 0.73, **LOSS},
}

POOLFIZ: JSON = {
    **POOL,
    "gravity": 9.81,
    "ball": {"mass": 0.16301, "radius": 0.028575},
    "cloth": {
        "sliding_friction": 0.2,
        "rolling_friction": 0.015,
        # Leckie & Greenspan 2005: 5 μ_sp g / 2R with μ_sp = 0.044.
        "spin_deceleration": 2.5 * 0.044 * 9.81 / 0.028575,
    },
    "ball_ball": {"model": "frictional", "restitution": 1.0, "friction": 0.01},
    "cushion": {
        "model": "factors",
        "restitution": 0.6,
        "tangential_factor": 0.9,
        "spin_factor": 0.1,
    },
    "facing": {"restitution": 0.6, "friction": 0.0},
    "slate": {"restitution": 0.0, "friction": 0.0},
    "cue": {"mass": 0.6, "end_mass": 0.0, "tip_restitution": 1.0},
}

IDEAL: JSON = {
    **POOL,
    "ball_ball": {"model": "elastic", "restitution": 1.0},
    "cushion": {"model": "restitution", "restitution": 1.0},
    "facing": {"restitution": 1.0, "friction": 0.0},
    "liner": {"restitution": 0.35, "friction": 0.0},
    "slate": {"restitution": 0.5, "friction": 0.0},
    "cue": {"mass": 0.567, "end_mass": 0.0, "tip_restitution": 1.0},
}

PRESETS: dict[str, JSON] = {
    "pool": POOL,
    "snooker": SNOOKER,
    "english": ENGLISH,
    "carom": CAROM,
    "poolfiz": POOLFIZ,
    "ideal": IDEAL,
}

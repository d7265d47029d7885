"""The physics presets, copied from their published sources.

The engine is given a preset's name and the oracles these numbers, so that a preset that changes
without a reason is found. The sources are in `crates/carom/src/physics/presets.rs`.
"""

from __future__ import annotations

from typing import Any

JSON = dict[str, Any]

#: How the tip's restitution falls off the centre.
LOSS: JSON = {"tip_off_centre_loss": 5.388423}

POOL_2026_11: JSON = {
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

SNOOKER_2026_11: JSON = {
    **POOL_2026_11,
    "ball": {"mass": 0.1406, "radius": 0.02625},
    "cloth": {"sliding_friction": 0.212, "rolling_friction": 0.0128, "spin_deceleration": 22.0},
    "ball_ball": {**POOL_2026_11["ball_ball"], "restitution": 0.89, "friction": 0.05},
    "cushion": {
        "model": "stronge",
        "restitution": {"a": 1.24, "b": -0.132, "c": 0.0066},
        "friction": 0.38,
        "frequency_ratio": 1.7,
    },
    "cue": {"mass": 0.48, "end_mass": 0.0047, "tip_restitution": 0.73, **LOSS},
}

ENGLISH_2026_11: JSON = {
    **SNOOKER_2026_11,
    "ball": {"mass": 0.116, "radius": 0.0254},
    "ball_ball": POOL_2026_11["ball_ball"],
    "cue": {**SNOOKER_2026_11["cue"], "end_mass": 0.0039},
}

CAROM_2026_11: JSON = {
    **POOL_2026_11,
    "ball": {"mass": 0.210, "radius": 0.03075},
    "cloth": {"sliding_friction": 0.2, "rolling_friction": 0.0045, "spin_deceleration": 3.9},
    "ball_ball": {**POOL_2026_11["ball_ball"], "restitution": 0.98},
    "cue": {"mass": 0.51, "end_mass": 0.007, "tip_restitution": 0.73, **LOSS},
}

POOLFIZ: JSON = {
    **POOL_2026_11,
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
    **POOL_2026_11,
    "ball_ball": {"model": "elastic", "restitution": 1.0},
    "cushion": {"model": "restitution", "restitution": 1.0},
    "facing": {"restitution": 1.0, "friction": 0.0},
    "liner": {"restitution": 0.35, "friction": 0.0},
    "slate": {"restitution": 0.5, "friction": 0.0},
    "cue": {"mass": 0.567, "end_mass": 0.0, "tip_restitution": 1.0},
}

#: Friction of used pool balls.
USED: JSON = {"a": 0.0, "b": 0.0942, "c": 0.344}

POOL: JSON = {
    **POOL_2026_11,
    "ball_ball": {**POOL_2026_11["ball_ball"], "friction": USED},
    "cushion": {
        "model": "stronge",
        "restitution": {"a": 1.04, "b": -0.05, "c": 0.0, "lowest": 0.5},
        "friction": 0.225,
        "frequency_ratio": 1.53,
    },
}

SNOOKER: JSON = {
    **SNOOKER_2026_11,
    "ball_ball": {
        **POOL["ball_ball"],
        "restitution": 0.921,
        "friction": {"a": 0.0, "b": 0.0508, "c": 0.344},
    },
    "cushion": {
        "model": "stronge",
        "restitution": {"a": 0.978, "b": 0.0596, "c": -0.02743, "lowest": 0.851},
        "friction": 0.38,
        "frequency_ratio": 1.7,
    },
}

#: Bands of speed of the tracked match's 0.0410 + 0.0142 v m/s².
HEATED_CLOTH: list[JSON] = [
    {"up_to": 0.28378243558108807, "friction": 0.004452647461077105},
    {"up_to": 0.4952810068290303, "friction": 0.004757125884432819},
    {"up_to": 0.779485577398366, "friction": 0.00511633508028676},
    {"up_to": 1.150281069509329, "friction": 0.005590920081083174},
    {"up_to": 1.6263191091959844, "friction": 0.006204445341562901},
    {"up_to": 2.232160281319124, "friction": 0.0069881917222841955},
    {"friction": 0.007983247533537964},
]

CAROM: JSON = {
    **CAROM_2026_11,
    "cloth": {
        "sliding_friction": 0.178,
        "rolling_friction": HEATED_CLOTH,
        "spin_deceleration": 3.6,
    },
    "ball_ball": {**POOL["ball_ball"], "restitution": 0.92},
    "cushion": {
        "model": "han-2005",
        "restitution": {"a": 0.915, "b": -0.034, "c": -0.005, "lowest": 0.5},
        "friction": {"a": 0.240, "b": 0.034},
    },
}


def variant(section: str, **changed: Any) -> JSON:
    """The preset `pool` with other values of one section."""
    return {**POOL, section: {**POOL[section], **changed}}


def cloth(sliding: float, rolling: float, spin: float) -> JSON:
    """The preset `pool` on another cloth."""
    return variant(
        "cloth", sliding_friction=sliding, rolling_friction=rolling, spin_deceleration=spin
    )


PRESETS: dict[str, JSON] = {
    "pool": POOL,
    "pool-new-cloth": cloth(0.15, 0.0075, 5.0),
    "pool-worn-cloth": cloth(0.275, 0.015, 15.0),
    "pool-clean-balls": variant("ball_ball", friction={"a": 0.0, "b": 0.0701, "c": 0.344}),
    "pool-dirty-balls": variant("ball_ball", friction={"a": 0.0, "b": 0.1393, "c": 0.455}),
    "pool-gold-crown": variant("cushion", friction=0.274),
    "pool-valley": variant("cushion", friction=0.208),
    "snooker": SNOOKER,
    "english": {**ENGLISH_2026_11, "ball_ball": POOL["ball_ball"], "cushion": SNOOKER["cushion"]},
    "carom": CAROM,
    "poolfiz": POOLFIZ,
    "ideal": IDEAL,
    "pool-2026-11": POOL_2026_11,
    "snooker-2026-11": SNOOKER_2026_11,
    "english-2026-11": ENGLISH_2026_11,
    "carom-2026-11": CAROM_2026_11,
}

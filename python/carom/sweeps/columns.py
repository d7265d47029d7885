"""The outcome columns of a row, and their meanings."""

from __future__ import annotations

# The strike after the noise; these columns exist only with noise.
PLAYED = (
    "played_speed",
    "played_azimuth_deg",
    "played_elevation_deg",
    "played_side",
    "played_height",
)

# Column → meaning. "per ball": a list of fixed size in the order of the shot's balls.
OUTCOMES = {
    "events": "number of events",
    "duration": "time of the last event, s",
    "pocket": "per ball: index of its pocket, in the order of `carom tables`; −1 on the table, "
    "−2 off it",
    "end_x": "per ball: x of its centre at the end, m",
    "end_y": "per ball: y of its centre at the end, m",
    "end_z": "per ball: z of its centre at the end, m",
    "cue_end_x": "x of the cue ball's centre at the end, m",
    "cue_end_y": "y of the cue ball's centre at the end, m",
    "first_contact": "id of the ball that the cue ball touched first; null if none",
    "scratch": "whether the cue ball was pocketed",
    "rails_before_contact": "cushions that the cue ball touched before its first contact",
    "rails_after_contact": "touches of any ball with a cushion after the first contact",
    "driven_to_rail": "balls driven to a rail",
    "balls_touched": "different balls that the cue ball touched",
    "rails_before_second_ball": "cushions that the cue ball touched before the second ball; "
    "null if it touched fewer than two balls",
    "jumped": "pairs of balls where one flew over the other",
    "hanging": "balls that hang over the edge of a pocket",
    **dict.fromkeys(PLAYED, "the strike after the noise, in the units of a shot file"),
}

# What a referee needs; recording any of these makes a shot slower.
REFEREE = (
    "first_contact",
    "scratch",
    "rails_before_contact",
    "rails_after_contact",
    "driven_to_rail",
    "balls_touched",
    "rails_before_second_ball",
    "jumped",
    "hanging",
)

PER_BALL = ("pocket", "end_x", "end_y", "end_z")

# The columns of a spec without `columns`.
CHOSEN = tuple(name for name in OUTCOMES if name not in ("end_z", "cue_end_x", "cue_end_y"))

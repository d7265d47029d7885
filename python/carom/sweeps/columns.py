"""The outcomes that a row can have: their columns, and what they mean."""

from __future__ import annotations

# Played strikes are there only with noise.
PLAYED = (
    "played_speed",
    "played_azimuth_deg",
    "played_elevation_deg",
    "played_side",
    "played_height",
)

# Column → what it is. "per ball": a list of fixed size in the order of the shot's balls.
OUTCOMES = {
    "events": "number of events",
    "duration": "time of the last event, s",
    "pocket": "per ball: the pocket it fell into, in the order of `carom tables`; −1 on the table, "
    "−2 off it",
    "end_x": "per ball: where its centre ended, m",
    "end_y": "per ball: the same, along the table's length",
    "end_z": "per ball: the same, above the slate",
    "cue_end_x": "where the cue ball's centre ended, m",
    "cue_end_y": "the same, along the table's length",
    "first_contact": "id of the ball that the cue ball touched first; null if none",
    "scratch": "whether the cue ball fell",
    "rails_before_contact": "cushions that the cue ball touched before its first contact",
    "rails_after_contact": "touches of any ball with a cushion after the first contact",
    "driven_to_rail": "balls driven to a rail",
    "balls_touched": "different balls that the cue ball touched",
    "rails_before_second_ball": "cushions that the cue ball touched before the second of them; "
    "null if it touched fewer",
    "jumped": "pairs of balls of which one flew over the other",
    "hanging": "balls that hang over the edge of a pocket",
    **dict.fromkeys(PLAYED, "the strike that came out of the noise, as in a shot file"),
}

# What a referee needs: asking for any of these makes a shot cost more.
FACTS = (
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

# What is kept if the spec does not say.
CHOSEN = tuple(name for name in OUTCOMES if name not in ("end_z", "cue_end_x", "cue_end_y"))

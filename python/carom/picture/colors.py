"""Colours of the table, of the balls as they are sold, and of paths, visible on the cloth."""

from __future__ import annotations

from dataclasses import dataclass

CLOTH = "#17594a"
CUSHION = "#0f4438"
CUSHION_EDGE = "#2c7a68"
RAIL = "#4a2f1f"
RAIL_EDGE = "#33200f"
DIAMOND = "#efe6d2"
TIP = "#3d6ea5"
SHAFT = "#d9b36c"
HOLE = "#0b0b0b"
HOLE_EDGE = "#8a8d8f"
SLATE = "#5c666b"
WALL = "#0d3029"
PAPER = "#fbfaf6"
INK = "#23272b"
FAINT_INK = "#767b80"
IVORY = "#f6f1e3"


@dataclass(frozen=True, slots=True)
class Palette:
    """The colours of a table."""

    cloth: str = CLOTH
    cushion: str = CUSHION
    cushion_edge: str = CUSHION_EDGE
    rail: str = RAIL
    rail_edge: str = RAIL_EDGE
    diamond: str = DIAMOND
    hole: str = HOLE
    hole_edge: str = HOLE_EDGE
    line: str = "white"
    """Lines on the cloth."""


FELT = Palette()
# For paper: light surfaces and grey lines, which a printer without colours shows as well.
LIGHT = Palette(
    cloth="#ffffff",
    cushion="#f1f1f1",
    cushion_edge="#8a8a8a",
    rail="#e3e3e3",
    rail_edge="#6a6a6a",
    diamond="#333333",
    hole="#c9c9c9",
    hole_edge="#6a6a6a",
    line="black",
)


@dataclass(frozen=True, slots=True)
class Look:
    """How one ball is drawn."""

    body: str
    path: str
    striped: bool = False
    label: str = ""


# (body, path): the path is lighter where the body would be too dark on the cloth.
_POOL = {
    1: ("#f2b90f", "#ffd23f"),
    2: ("#1d4fae", "#7fb2ff"),
    3: ("#c9281e", "#ff6a5c"),
    4: ("#56308f", "#c2a0ff"),
    5: ("#e8701a", "#ff9d4d"),
    6: ("#12723f", "#63d897"),
    7: ("#7a2323", "#d98b80"),
    8: ("#17181a", "#050505"),
}
_NAMED = {
    "cue": (IVORY, "#ffffff"),
    "white": (IVORY, "#ffffff"),
    "spotted": (IVORY, "#d9d4c4"),
    "red": ("#c9281e", "#ff6a5c"),
    "yellow": ("#f2b90f", "#ffd23f"),
    "green": ("#12723f", "#63d897"),
    "brown": ("#6b3f1d", "#cf9a68"),
    "blue": ("#1d4fae", "#7fb2ff"),
    "pink": ("#ee8fa5", "#ffb9c8"),
    "black": ("#17181a", "#050505"),
    "orange": ("#e8701a", "#ff9d4d"),
    "purple": ("#56308f", "#c2a0ff"),
}
_OTHERS = ("#7fb2ff", "#ffd23f", "#ff6a5c", "#c2a0ff", "#ff9d4d", "#63d897", "#d98b80", "#8fe3e8")


def look(ball_id: str, index: int) -> Look:
    """The look of a ball from its id: a pool ball's number, a colour's name, or another name.

    Args:
        ball_id: The ball's id; ``"9"``, ``"cue"``, ``"red-4"`` and ``"red4"`` have a look.
        index: Its index in the shot; balls with other names get colours in this order.
    """
    if ball_id.isdecimal() and 1 <= int(ball_id) <= 15:
        number = int(ball_id)
        body, path = _POOL[number if number <= 8 else number - 8]
        return Look(body, path, striped=number > 8, label=str(number))
    name = ball_id.lower().rstrip("0123456789").rstrip("-_ ")
    if name in _NAMED:
        return Look(*_NAMED[name])
    body = _OTHERS[index % len(_OTHERS)]
    return Look(body, body, label=ball_id[:2])

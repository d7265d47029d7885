"""Printed sheets of a drill: a diagram of every step, with its goal, for A4 and letter paper."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from carom.drills import Drill, DrillStep, areas_of
from carom.picture import diagram
from carom.picture.shown import Shown
from carom.shot import Shot

if TYPE_CHECKING:
    import os
    from collections.abc import Mapping

    from matplotlib.figure import Figure

    from carom.picture.diagram import Paper

# Diagrams on a page by the number of steps; more continue on further pages.
PER_PAGE = (1, 2, 4, 6)
# Distance of a pocket from the ring around it, m.
RING = 0.025
# Corners of the outline of a D, which is drawn as an area.
CORNERS = 24


def draw(drill: Drill, *, paper: Paper = "a4") -> list[Figure]:
    """Draw the pages of a drill's sheet.

    Args:
        drill: The drill.
        paper: ``a4`` or ``letter``.

    Returns:
        The pages, Matplotlib figures.

    Raises:
        InputError: ``paper`` is another one.
    """
    shown = _shown(drill)
    return diagram.draw(shown, paper=paper, per_page=_per_page(len(shown)))


def save(drill: Drill, path: str | os.PathLike[str], *, paper: Paper = "a4") -> None:
    """Write the pages of a drill's sheet to a file, as ``carom.picture.diagram.save``.

    Args:
        drill: The drill.
        path: The file: ``.pdf``, or ``.svg`` or ``.png`` if there is one page.
        paper: ``a4`` or ``letter``.

    Raises:
        InputError: As for ``draw``; or the ending is another one, or only a PDF has enough pages.
        OSError: The file cannot be written; a file that was there before is unchanged.
    """
    shown = _shown(drill)
    diagram.save(shown, path, paper=paper, per_page=_per_page(len(shown)))


def _per_page(count: int) -> int:
    return next((each for each in PER_PAGE if each >= count), PER_PAGE[-1])


def _shown(drill: Drill) -> list[Shown]:
    """A diagram for each step, with its goal below it."""
    return [Shown(_layout(step), drill.name, text=step.words()) for step in drill.steps]


def _layout(step: DrillStep) -> Shot:
    """The balls at rest, with the areas and the pockets of the goal drawn as marks."""
    file = step.shot.to_dict()
    del file["strike"]
    geometry = step.shot.geometry()
    marks: list[dict[str, Any]] = []
    for name, area in areas_of(step):
        marks += _area_marks(name, area, geometry)
    wanted = {need.get("pocket") for need in step.goal.get("needs", [])}
    for pocket in geometry["pockets"]:
        if pocket["name"] in wanted:
            ring = {"center": pocket["center"], "radius": pocket["radius"] + RING}
            marks.append({"kind": "circle", "color": "red", **ring})
    return Shot.from_dict({**file, "marks": marks} if marks else file)


def _area_marks(
    name: str, area: Mapping[str, Any], geometry: Mapping[str, Any]
) -> list[dict[str, Any]]:
    """The outline of an area, and the points of a zone."""
    color = "yellow" if name == "hand" else "blue"
    outline: list[list[float]]
    if "center" in area:
        center, radius = area["center"], area["radius"]
        marks = [{"kind": "circle", "color": color, "center": center, "radius": radius}]
        at = [center[0], center[1] + 0.7 * radius]
    else:
        if "from" in area:
            (left, low), (right, high) = area["from"], area["to"]
            outline = [[left, low], [right, low], [right, high], [left, high]]
            at = [right - 0.06, high - 0.06]
        elif "outline" in area:
            outline = area["outline"]
            at = [sum(axis) / len(outline) for axis in zip(*outline, strict=True)]
        else:
            outline, at = _d(geometry)
        marks = [{"kind": "area", "color": color, "outline": outline}]
    if name.isdigit():
        marks.append({"kind": "label", "color": color, "at": at, "text": name})
    return marks


def _d(geometry: Mapping[str, Any]) -> tuple[list[list[float]], list[float]]:
    """The outline of the D, and its middle."""
    line, radius = geometry["markings"]["head_string"], geometry["markings"]["d_radius"]
    middle = 0.5 * geometry["size"][0]
    angles = [math.pi * (1 + k / CORNERS) for k in range(CORNERS + 1)]
    around = [[middle + radius * math.cos(a), line + radius * math.sin(a)] for a in angles]
    return around, [middle, line - 0.5 * radius]

"""The contact of two bodies with a normal and a tangential spring (Stronge 2000, section 5.1).

Normal: the relative speed is w cos ωt until compression ends and e w cos(ωt/e + π/2 (1 − 1/e))
after it, so that the normal force in units of its maximum is the sine of the same angle.

Tangential: a spring between the body's surface and the contact point, which holds while the
spring's force is at most μ times the normal force, and slides otherwise.

There is no analysis of cases as in the book. Each stretch of holding or sliding has a closed form;
the end of each stretch is the first root of its condition, whatever comes next.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from mpmath import findroot, mp, mpf

Number = Any

#: Ratio of the inverse masses of two solid spheres, or of a sphere and a wall: tangential / normal.
RATIO = mpf(7) / 2
#: Samples of a condition over the rest of the contact; between two of them it has at most one root.
LOOKS = 400
#: Part of a contact, of either phase, in which a new condition is not yet looked at.
JUST_NOW = 1e-9


@dataclass(frozen=True)
class Stretch:
    """A part of the contact: `slides` is 0 while the contact point holds, else the slip's sign."""

    start: Number
    slip: Number
    force: Number
    slides: int


class Springs:
    """A contact in the units of its normal spring: time 1/ω, speed w, force the largest one."""

    def __init__(self, e: Number, friction: Number, frequency_ratio: Number, fn: Any = mp) -> None:
        self.e, self.friction, self.omega, self.fn = e, friction, frequency_ratio, fn
        self.half = fn.pi / 2
        self.ends = self.half * (1 + e)

    def normal(self, t: Number) -> tuple[Number, Number, Number]:
        """The normal force, its rate and its integral from the start of the contact."""
        fn = self.fn
        if t <= self.half:
            return fn.sin(t), fn.cos(t), 1 - fn.cos(t)
        angle = t / self.e + self.half * (1 - 1 / self.e)
        return fn.sin(angle), fn.cos(angle) / self.e, 1 - self.e * fn.cos(angle)

    def at(self, s: Stretch, t: Number) -> tuple[Number, Number]:
        """Slip speed and the tangential spring's force, `t` after the start of the contact."""
        if s.slides:
            force, _, impulse = self.normal(t)
            before = self.normal(s.start)[2]
            friction = s.slides * self.friction
            return s.slip - RATIO * friction * (impulse - before), friction * force
        # v' = −(7/2) F and F' = (ω²/(7/2)) v.
        w, since = self.omega, t - s.start
        cos, sin = self.fn.cos(w * since), self.fn.sin(w * since)
        force = s.force * cos + s.slip * w / RATIO * sin
        return s.slip * cos - s.force * RATIO / w * sin, force

    def margin(self, s: Stretch, t: Number) -> Number:
        """Positive while the stretch lasts."""
        slip, held = self.at(s, t)
        force, rate, _ = self.normal(t)
        if s.slides:
            # The surface moves ahead of the spring's end.
            return s.slides * slip - self.friction * rate * RATIO / self.omega**2
        return self.friction * force - abs(held)


def final_slip(
    approach: Number, slip: Number, e: Number, friction: Number, frequency_ratio: Number
) -> Number:
    """The slip speed after the contact, along the initial slip; negative if it has turned back."""
    if friction * approach == 0:
        return slip
    exact = Springs(mpf(e), mpf(friction), mpf(frequency_ratio))
    rough = Springs(float(e), float(friction), float(frequency_ratio), math)
    first = mpf(slip) / approach
    zero = mpf(0)
    s = Stretch(zero, first, zero, 1)
    if exact.margin(s, zero) < 0:
        s = Stretch(zero, first, zero, 0)
    while True:
        end = _end(exact, rough, s)
        if end is None:
            return approach * exact.at(s, exact.ends)[0]
        slip_now, force = exact.at(s, end)
        slides = 0 if s.slides else int(mp.sign(force))
        s = Stretch(end, slip_now, force, slides)


def _end(exact: Springs, rough: Springs, s: Stretch) -> Number | None:
    """The end of a stretch; None if it lasts until the contact's end."""
    start, ends = float(s.start), float(exact.ends)
    floats = Stretch(start, float(s.slip), float(s.force), s.slides)
    first = start + JUST_NOW * (ends - start)
    times = [first + (ends - first) * k / LOOKS for k in range(LOOKS + 1)]
    for a, b in pairwise(times):
        if rough.margin(floats, b) < 0:
            if exact.margin(s, mpf(a)) <= 0:
                raise NotImplementedError("a stretch that ends as it begins")
            bracket = (mpf(a), mpf(b))
            return findroot(lambda t: exact.margin(s, t), bracket, solver="anderson")
    return None

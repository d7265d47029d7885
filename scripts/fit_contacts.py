"""Fits rails and ball surfaces to published measurements, and writes scripts/contact_fits.json.

    python scripts/fit_contacts.py            # all fits, in a few minutes
    python scripts/fit_contacts.py surfaces   # one group of them

Every fit has its readings, the parameters that were free, the seed of the search, the resulting
parameters and the residual of each reading. The readings are those of the validation rows. The
search is differential evolution (Storn & Price 1997) for the least largest residual, in units of
the reading's tolerance. Where no parameters meet every reading, it is for the fewest readings
outside. The parameters are rounded afterwards, and the residuals are those of the rounded
parameters. `python/tests/test_contact_fits.py` computes them again.
"""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

import carom
import numpy as np
from carom.validation.alciatore_throw_tests.rows import CUTS, bb23, bb25, throw
from carom.validation.alciatore_tp_rail.rows import (
    AIMS,
    NINE_FEET,
    SEVEN_FEET,
    bank,
    cu_16,
)
from carom.validation.lab import FOOT, JSON, TP_SPEEDS, ball, simulate
from carom.validation.mathavan_2009.rows import INCIDENT, bb20, film, rebound_speed
from carom.validation.mathavan_2014.rows import SHOTS, rolled_out
from scipy.optimize import brentq, differential_evolution

RESULTS = Path(__file__).with_suffix("").with_name("contact_fits.json")
SEED = 1
#: Share of the tolerance that counts as within it, so that rounded parameters stay within.
WITH_MARGIN = 0.99

Residuals = Callable[..., Sequence[float]]


def main(wanted: list[str]) -> int:
    """Makes the fits of the groups in `wanted`, or all, and writes them."""
    groups = {
        "surfaces": surfaces,
        "snooker": snooker,
        "banks": banks,
        "film": film_rails,
        "tracked": tracked,
    }
    for name in wanted or groups:
        fitted = groups[name]()
        results = json.loads(RESULTS.read_text(encoding="utf-8")) if RESULTS.exists() else {}
        results = {key: fitted if key == name else results.get(key, {}) for key in groups}
        text = json.dumps(results, indent=2, ensure_ascii=False)
        RESULTS.write_text(text + "\n", encoding="utf-8")
        print(name, file=sys.stderr)
    return 0


def search(
    residuals: Residuals,
    bounds: Sequence[tuple[float, float]],
    tolerance: Sequence[float] | float,
    generations: int = 60,
) -> list[float]:
    """The parameters with the least largest residual, in units of `tolerance`."""

    def largest(parameters: Sequence[float]) -> float:
        off = np.abs(np.asarray(residuals(*parameters))) / tolerance
        # A little of the mean square: otherwise all parameters with the same worst reading are
        # equally good.
        return float(off.max() + 0.01 * math.sqrt((off**2).mean()))

    return evolve(largest, bounds, generations)


def search_fewest(
    residuals: Residuals,
    bounds: Sequence[tuple[float, float]],
    tolerance: Sequence[float] | float,
    generations: int = 60,
) -> list[float]:
    """The parameters with the fewest residuals outside `tolerance`, and then the least rms."""

    def outside(parameters: Sequence[float]) -> float:
        off = np.abs(np.asarray(residuals(*parameters))) / tolerance
        return float((off > WITH_MARGIN).sum() + 0.1 * math.sqrt((off**2).mean()))

    return evolve(outside, bounds, generations)


def evolve(
    cost: Callable[[Sequence[float]], float],
    bounds: Sequence[tuple[float, float]],
    generations: int,
) -> list[float]:
    """The parameters of least `cost`."""
    found = differential_evolution(
        cost, bounds, rng=SEED, maxiter=generations, popsize=10, tol=1e-7, polish=False
    )
    return [float(x) for x in found.x]


def summary(
    labels: Sequence[str], residuals: Sequence[float], tolerance: Sequence[float] | float
) -> JSON:
    """The residuals by reading, with their size."""
    off = np.asarray(residuals, dtype=float)
    within = np.abs(off) <= tolerance
    return {
        "residuals": {k: round(float(x), 4) for k, x in zip(labels, off, strict=True)},
        "largest": round(float(np.abs(off).max()), 4),
        "rms": round(float(math.sqrt((off**2).mean())), 4),
        "outside": [k for k, ok in zip(labels, within, strict=True) if not ok],
    }


# Ball surfaces.

#: Reading error of throw in the figures, °.
THROW_TOLERANCE = 0.5
SPEEDS_2014 = tuple(v * FOOT for v in (2.8, 3.55, 4.5, 7.2, 10.7))
#: Restitution of the preset `pool`: with it the object ball of a cut φ has (1 + e)/2·cos φ of the
#: cue ball's speed.
POOL_RESTITUTION = 0.95
#: Alciatore, Throw follow-up I: throw at 45°, slow, °.
CLEANER, USED, ALCOHOL, CHALKED = 3.6, 4.9, 11.0, 11.6


def with_friction(friction: JSON | float | str) -> JSON:
    """The preset `pool` with this friction of the balls."""
    return {"base": "pool", "ball_ball": {"friction": friction}}


def law(a: float, b: float, c: float) -> JSON:
    """μ(s) = a + b·exp(−c·s)."""
    return {"a": a, "b": b, "c": c}


def residuals_2014(friction: JSON | float | str) -> list[float]:
    """Throw minus measured throw of BB23, °."""
    to_object = 0.5 * (1 + POOL_RESTITUTION) * math.cos(math.radians(30.0))
    physics = with_friction(friction)
    readings = zip(SPEEDS_2014, bb23.reference.values(), strict=True)
    return [throw(30.0, v / to_object, physics) - float(x) for v, x in readings]


def residuals_2006(friction: JSON | float | str) -> list[float]:
    """Throw minus measured throw of BB25, °."""
    physics = with_friction(friction)
    ours = [throw(cut, v, physics) for cut in CUTS for v in TP_SPEEDS.values()]
    return [x - float(y) for x, y in zip(ours, bb25.reference.values(), strict=True)]


def at_45_slow(friction: JSON | float | str) -> float:
    """Throw in the test of surface treatments (BB27), °."""
    return throw(45.0, TP_SPEEDS["slow"], with_friction(friction))


def surfaces() -> JSON:
    """The frictions `clean`, `used`, `dirty`, and that of a chalked contact."""
    bounds = [(0.0, 0.06), (0.0, 0.3), (0.0, 3.0)]
    fitted = {}
    tests = (
        ("dirty", search, residuals_2014, bb23, "BB23: Throw follow-up II (2014), 30° stun"),
        ("used", search_fewest, residuals_2006, bb25, "BB25: Billiards Digest, Sept 2006, stun"),
    )
    for name, find, residuals, row, source in tests:
        found = find(lambda *p, of=residuals: of(law(*p)), bounds, THROW_TOLERANCE, 120)
        friction = law(round(found[0], 4), round(found[1], 4), round(found[2], 3))
        fitted[name] = {
            "source": source,
            "unit": "°",
            "tolerance": THROW_TOLERANCE,
            "free": "a, b, c",
            "seed": SEED,
            "friction": friction,
            "at 45° slow": round(at_45_slow(friction), 4),
            **summary(list(row.reference), residuals(friction), THROW_TOLERANCE),
        }
    used = fitted["used"]["friction"]
    factor = brentq(
        lambda k: at_45_slow({**used, "a": k * used["a"], "b": k * used["b"]}) - CLEANER, 0.3, 1.0
    )
    clean = law(round(factor * used["a"], 4), round(factor * used["b"], 4), used["c"])
    fitted["clean"] = {
        "source": "BB27: Throw follow-up I, ball cleaner, 45° slow",
        "unit": "°",
        "tolerance": THROW_TOLERANCE,
        "free": "a factor of the friction `used`",
        "factor": round(factor, 4),
        "friction": clean,
        **summary(["45°, slow"], [at_45_slow(clean) - CLEANER], THROW_TOLERANCE),
    }
    for name, measured in (("alcohol", ALCOHOL), ("chalked", CHALKED)):
        mu = round(brentq(lambda m, x=measured: at_45_slow(m) - x, 0.1, 0.3), 3)
        fitted[name] = {
            "source": f"BB27: Throw follow-up I, {name}, 45° slow",
            "unit": "°",
            "tolerance": THROW_TOLERANCE,
            "free": "a constant friction",
            "friction": mu,
            **summary(["45°, slow"], [at_45_slow(mu) - measured], THROW_TOLERANCE),
        }
    fitted["used"]["cannot fit"] = cannot_fit_2006()
    return fitted


def cannot_fit_2006() -> JSON:
    """Why no friction that falls with the slip speed is within 0.5° of all of BB25.

    In the cut of 45° the balls slip all the time, so the throw is atan μ. The slip is slower at
    30° than at 45°, so a falling μ is at least as large there.
    """
    slow = float(bb25.reference["45°, slow"]) - THROW_TOLERANCE
    least = math.tan(math.radians(slow))
    at_30 = throw(30.0, TP_SPEEDS["slow"], with_friction(least))
    most = float(bb25.reference["30°, slow"]) + THROW_TOLERANCE
    return {
        "45°, slow: least friction for its least throw": round(least, 5),
        "30°, slow: throw with it, °": round(at_30, 4),
        "30°, slow: largest throw within the tolerance, °": most,
    }


# Snooker balls.


def snooker_physics(friction: JSON | float, restitution: float) -> JSON:
    """The preset `snooker` with these balls."""
    return {
        "base": "snooker",
        "ball_ball": {"restitution": restitution, "friction": friction},
    }


def residuals_snooker(friction: JSON | float, restitution: float) -> list[float]:
    """Ours minus the film's speeds (m/s) and direction (°) of BB20."""
    physics = snooker_physics(friction, restitution)
    ours = [x for shot in SHOTS for x in rolled_out(physics, *shot)[:3]]
    return [x - float(y) for x, y in zip(ours, bb20.reference.values(), strict=True)]


def snooker() -> JSON:
    """Balls of snooker: restitution, and the friction `used` times a factor, fitted to BB20."""
    used = json.loads(RESULTS.read_text(encoding="utf-8"))["surfaces"]["used"]["friction"]
    tolerance = np.tile([0.03, 0.03, 1.5], 3)

    def friction(factor: float) -> JSON:
        return {**used, "a": round(factor * used["a"], 4), "b": round(factor * used["b"], 4)}

    def of(e: float, factor: float) -> list[float]:
        return residuals_snooker(friction(factor), e)

    e, factor = search(of, [(0.85, 1.0), (0.2, 2.0)], tolerance, 40)
    e, factor = round(e, 3), round(factor, 3)
    labels = list(bb20.reference)
    return {
        "film": {
            "source": "BB20: Mathavan, Jackson & Parkin 2009, three rolling shots",
            "unit": "m/s, m/s, °",
            "tolerance": [0.03, 0.03, 1.5],
            "free": "restitution, a factor of the friction `used`",
            "seed": SEED,
            "restitution": e,
            "factor": factor,
            "friction": friction(factor),
            **summary(labels, of(e, factor), tolerance),
        },
        "speed-dependent throw at the film's restitution": {
            "restitution": 0.89,
            "friction": used,
            **summary(labels, residuals_snooker(used, 0.89), tolerance),
        },
        "preset": {
            "restitution": 0.89,
            "friction": 0.05,
            **summary(labels, residuals_snooker(0.05, 0.89), tolerance),
        },
    }


# Rails of three pool tables.

BANK_TOLERANCE = 0.3
TABLES = {
    "Olhausen 9 ft": NINE_FEET,
    "Gold Crown 9 ft": NINE_FEET,
    "Valley 7 ft": SEVEN_FEET,
}
#: Place of a bank that does not arrive at all, diamonds.
NO_BANK = 10.0


def bank_physics(cushion: JSON) -> JSON:
    """The preset `pool` with this cushion."""
    return {"base": "pool", "cushion": cushion}


def residuals_banks(table: str, cushion: JSON) -> list[float]:
    """Ours minus the measured start of each bank of CU-16, diamonds."""
    name, size = TABLES[table]

    def ours(aim: float) -> float:
        try:
            return bank(aim, name, size, bank_physics(cushion))
        except ValueError:
            # No start between the aim and the eighth sight leads to the corner.
            return NO_BANK

    return [ours(aim) - float(cu_16.reference[f"{table}, aim {aim:g}"]) for aim in AIMS]


def stronge(e: JSON | float, mu: float, ratio: float) -> JSON:
    """A cushion of the model `stronge`."""
    return {
        "model": "stronge",
        "restitution": e,
        "friction": mu,
        "frequency_ratio": ratio,
    }


#: Slope of the restitution, per m/s. The banks meet the rail at 3.4 to 5.3 m/s, which is too narrow
#: a range to fit it. It is about that of Mathavan's film from 1 to 3.5 m/s (0.95 to 0.80, CU-8) and
#: of the tracked three-cushion match (−0.034 − 2·0.005 V, −0.05 at 2 m/s).
SLOPE = -0.05


def falling(at_4: float) -> JSON:
    """A restitution with the slope of `SLOPE`, `at_4` at 4 m/s."""
    return {"a": round(at_4 - 4.0 * SLOPE, 4), "b": SLOPE, "c": 0.0}


def banks() -> JSON:
    """CU-16: rails that differ in their friction alone, and rails of their own."""
    results: JSON = {}
    ratio_bounds, e_bounds, mu_bounds = (1.4, 1.8), (0.75, 0.95), (0.12, 0.35)

    def together(ratio: float, at_4: float, *mus: float) -> list[float]:
        pairs = zip(TABLES, mus, strict=True)
        return [x for t, mu in pairs for x in residuals_banks(t, stronge(falling(at_4), mu, ratio))]

    found = search(together, [ratio_bounds, e_bounds, *[mu_bounds] * 3], BANK_TOLERANCE, 25)
    ratio, at_4, mus = round(found[0], 2), round(found[1], 2), [round(x, 3) for x in found[2:]]
    for table, mu in zip(TABLES, mus, strict=True):
        cushion = stronge(falling(at_4), mu, ratio)
        results[table] = bank_result(table, cushion, "frequency_ratio, a: shared; friction: own")
    for table in TABLES:
        found = search(
            lambda e, mu, t=table: residuals_banks(t, stronge(e, mu, 1.8)),
            [(0.7, 1.0), mu_bounds],
            BANK_TOLERANCE,
            20,
        )
        cushion = stronge(round(found[0], 3), round(found[1], 3), 1.8)
        results[f"{table}, constant restitution"] = bank_result(
            table, cushion, "restitution, friction"
        )
    return results


def bank_result(table: str, cushion: JSON, free: str) -> JSON:
    """The result of one table's fit."""
    labels = [f"aim {aim:g}" for aim in AIMS]
    return {
        "source": "CU-16: TP B.28, fast sliding banks, 12 mph",
        "unit": "diamonds",
        "tolerance": BANK_TOLERANCE,
        "free": free,
        "seed": SEED,
        "cushion": cushion,
        **summary(labels, residuals_banks(table, cushion), BANK_TOLERANCE),
    }


# Rails of a film and of a tracked match.

FILM_TOLERANCE = 0.05
#: Residual of parameters that give no restitution at any speed, m/s.
NO_REBOUND = 4.0
#: The normal speeds of the film's 31 shots, m/s: its range, evenly.
FILM_SPEEDS = (0.28, *INCIDENT)


def residuals_film(cushion: JSON) -> list[float]:
    """Ours minus the film's speed after a perpendicular, rolling impact (CU-8), m/s."""
    physics = {"base": "snooker", "cushion": cushion}
    return [rebound_speed(x, physics) - film(x) for x in FILM_SPEEDS]


def polynomial(a: float, b: float, c: float) -> JSON:
    """A fitted restitution that does not fall below its value at the film's fastest shot."""
    a, b, c, fastest = round(a, 4), round(b, 4), round(c, 5), FILM_SPEEDS[-1]
    lowest = round(min(max(a + b * fastest + c * fastest**2, 0.0), 1.0), 3)
    return {"a": a, "b": b, "c": c, "lowest": lowest, "highest": 1.0}


def film_rails() -> JSON:
    """Mathavan's snooker rail by model, and the rails of the tracked match as they were learned."""
    results: JSON = {}
    cases: dict[str, tuple[JSON, list[tuple[float, float]]]] = {
        # The model `restitution` gives the film's ratio itself: e = y/x at every speed.
        "restitution": ({}, [(0.5, 1.2), (-0.3, 0.6), (-0.2, 0.1)]),
        "han-2005": ({"friction": 0.2}, [(0.5, 1.6), (-0.4, 0.6), (-0.2, 0.1)]),
        "mathavan-2010": ({"friction": 0.14}, [(0.5, 1.6), (-0.4, 0.6), (-0.2, 0.1)]),
        "stronge": (
            {"friction": 0.38, "frequency_ratio": 1.7},
            [(0.5, 1.6), (-0.4, 0.6), (-0.2, 0.1)],
        ),
    }
    for model, (other, bounds) in cases.items():

        def cushion(*abc: float, m: str = model, o: JSON = other) -> JSON:
            return {"model": m, "restitution": polynomial(*abc), **o}

        def of(*abc: float, make: Callable[..., JSON] = cushion) -> list[float]:
            try:
                return residuals_film(make(*abc))
            except carom.InputError:
                # No restitution at any speed.
                return [NO_REBOUND] * len(FILM_SPEEDS)

        found = search(of, bounds, FILM_TOLERANCE, 25)
        fitted = cushion(*found)
        results[model] = {
            "source": "CU-8: Mathavan, Jackson & Parkin 2009, Fig. 9, 31 shots, 0.28 to 3.5 m/s",
            "unit": "m/s",
            "tolerance": FILM_TOLERANCE,
            "free": "a, b, c",
            "seed": SEED,
            "cushion": fitted,
            **summary([f"{x:g} m/s" for x in FILM_SPEEDS], residuals_film(fitted), FILM_TOLERANCE),
        }
    return results


# Rails of a tracked three-cushion match.

#: Laws that were learned from the tracks of a match on a heated 10-ft table. This project does not
#: have the tracks, so they are not fitted here.
TRACKED: dict[str, JSON] = {
    "han-2005": {
        "model": "han-2005",
        "restitution": {"a": 0.915, "b": -0.034, "c": -0.005, "lowest": 0.0, "highest": 1.0},
        "friction": {"a": 0.240, "b": 0.034},
    },
    "stronge": {
        "model": "stronge",
        "restitution": {"a": 0.824, "b": -0.020, "c": -0.005, "lowest": 0.0, "highest": 1.0},
        "friction": 0.250,
        "frequency_ratio": 2.0,
    },
}
#: Ratios of the normal speeds after and before, seen in 337 rebounds of that match: speed (m/s) and
#: incidence (°) from and to, and the range of the ratio.
SEEN = (
    ((0.15, 0.5), (50.0, 75.0), (0.53, 0.56)),
    ((0.5, 3.5), (0.0, 25.0), (0.56, 0.68)),
)


def normal_ratio(cushion: JSON, speed: float, incidence_deg: float) -> float:
    """Normal speed when a ball rolls again after a carom rail, over that before."""
    incidence = math.radians(incidence_deg)
    across, into = speed * math.sin(incidence), speed * math.cos(incidence)
    radius, width = 0.03075, 1.42
    run = simulate(
        ball(
            position=(width - radius - 1e-4, 1.0),
            velocity=(into, across, 0.0),
            spin=(-across / radius, into / radius, 0.0),
            radius=radius,
        ),
        physics={"base": "carom", "cushion": cushion},
        table="carom-10ft",
    )
    before = run.first("rail-collision")
    after = next(
        event.after["cue"]
        for event in run.events
        if event.time > before.time and event.after["cue"].motion == "rolling"
    )
    return float(-after.velocity[0] / before.before["cue"].velocity[0])


def tracked() -> JSON:
    """The learned laws, and the normal ratios that they give in the two ranges of the tracks."""
    results: JSON = {}
    for name, cushion in TRACKED.items():
        ranges = []
        for speeds, angles, seen in SEEN:
            grid = [
                normal_ratio(cushion, float(v), float(g))
                for v in np.linspace(*speeds, 8)
                for g in np.linspace(*angles, 6)
            ]
            ranges.append(
                {
                    "speed, m/s": list(speeds),
                    "incidence, °": list(angles),
                    "seen": list(seen),
                    "rolling ball": [round(min(grid), 3), round(max(grid), 3)],
                }
            )
        results[name] = {
            "source": "tracks of a three-cushion match on a heated table, 337 rebounds",
            "free": "learned outside of this project",
            "cushion": cushion,
            "normal ratio": ranges,
        }
    return results


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))

"""Taylor series of polynomial differential equations, in fixed-point arithmetic of any precision.

The right-hand sides are written with `+`, `-`, `*` and `reciprocal`; each step computes the Taylor
coefficients of the solution by the recurrences of these operations (Moore 1966). The step size
follows Jorba & Zou 2005.
"""

from __future__ import annotations

from operator import mul
from typing import TYPE_CHECKING, Any

from mpmath import mp, mpf

if TYPE_CHECKING:
    from collections.abc import Sequence

Number = Any


class Series:
    """One quantity of a system: its Taylor coefficients × 2^bits, lowest order first."""

    def __init__(self, system: System, needs: Sequence[Series] = ()) -> None:
        self.system, self.needs = system, needs
        self.c: list[int] = []

    def extend(self, k: int) -> None:
        """Appends the coefficient of order k."""
        raise NotImplementedError

    def __add__(self, other: Series | Number) -> Series:
        if isinstance(other, Series):
            return linear(self.system, [(self, mpf(1)), (other, mpf(1))], mpf(0))
        return linear(self.system, [(self, mpf(1))], other) if other != 0 else self

    __radd__ = __add__

    def __sub__(self, other: Series | Number) -> Series:
        return self + (-1 * other)

    def __rsub__(self, other: Series | Number) -> Series:
        return (-1 * self) + other

    def __mul__(self, other: Series | Number) -> Any:
        if isinstance(other, Series):
            return Product(self, other)
        return linear(self.system, [(self, mpf(other))], mpf(0)) if other != 0 else mpf(0)

    __rmul__ = __mul__


class State(Series):
    """A dependent variable; `rate` is its derivative."""

    rate: Series

    def __init__(self, system: System, value: Number) -> None:
        super().__init__(system)
        self.value = system.fixed(value)


class Linear(Series):
    """Σ factor × term + constant."""

    def __init__(self, system: System, terms: dict[Series, Number], constant: Number) -> None:
        super().__init__(system, list(terms))
        self.terms, self.constant = terms, constant
        self.factors = [system.fixed(factor) for factor in terms.values()]
        self.fixed_constant = system.fixed(constant)

    def extend(self, k: int) -> None:
        total = 0
        for term, factor in zip(self.needs, self.factors, strict=True):
            total += term.c[k] * factor
        total >>= self.system.bits
        self.c.append(total + self.fixed_constant if k == 0 else total)


def linear(system: System, terms: Sequence[tuple[Series, Number]], constant: Number) -> Linear:
    """Σ factor × term + constant, with the sums among the terms expanded."""
    total: dict[Series, Number] = {}
    for term, factor in terms:
        parts = {term: mpf(1)}
        if isinstance(term, Linear):
            parts = term.terms
            constant += factor * term.constant
        for part, share in parts.items():
            total[part] = total.get(part, mpf(0)) + factor * share
    return Linear(system, total, constant)


class Product(Series):
    """a × b."""

    def __init__(self, a: Series, b: Series) -> None:
        super().__init__(a.system, (a, b))
        self.a, self.b = a, b

    def extend(self, k: int) -> None:
        self.c.append(sum(map(mul, self.a.c, self.b.c[k::-1])) >> self.system.bits)


class Reciprocal(Series):
    """1 / a."""

    def __init__(self, a: Series) -> None:
        super().__init__(a.system, (a,))
        self.a = a

    def extend(self, k: int) -> None:
        bits = self.system.bits
        if k == 0:
            self.c.append((1 << 2 * bits) // self.a.c[0])
            return
        carried = sum(map(mul, self.a.c[1:], self.c[k - 1 :: -1]))
        self.c.append(-carried // self.a.c[0])


def reciprocal(a: Series | Number) -> Any:
    """1 / a, for a series or a number."""
    return Reciprocal(a) if isinstance(a, Series) else 1 / a


class System:
    """Differential equations whose solution is known to about `digits` digits after each step."""

    def __init__(self, digits: int) -> None:
        #: More than twice the digits are not needed: coefficients × step^k fall to 10^-digits.
        self.bits = int(digits * 3.33) + 64
        self.order = int(digits * 1.16) + 2
        self.tolerance = mpf(10) ** -digits
        self.states: list[State] = []
        self.tape: list[Series] = []
        #: The unit of the independent variable: about the length of the next step.
        self.unit = mpf("0.1")

    def fixed(self, x: Number) -> int:
        return int(mp.floor(mp.ldexp(x, self.bits)))

    def number(self, x: int) -> Number:
        return mp.ldexp(mpf(x), -self.bits)

    def state(self, value: Number) -> State:
        found = State(self, value)
        self.states.append(found)
        return found

    def constant(self, value: Number) -> Series:
        return Linear(self, {}, value)

    def close(self, further: Sequence[Series] = ()) -> None:
        """Ends the description: orders what the rates and the `further` quantities need."""
        ordered: dict[Series, None] = {}

        def visit(node: Series) -> None:
            if node in ordered or isinstance(node, State):
                return
            for need in node.needs:
                visit(need)
            ordered[node] = None

        for node in (*(state.rate for state in self.states), *further):
            visit(node)
        self.tape = list(ordered)

    def expand(self) -> Number:
        """Computes the series at the present values. Returns the step that they allow, in units."""
        unit = self.fixed(self.unit)
        for node in self.tape:
            node.c = []
        for state in self.states:
            state.c = [state.value]
        for k in range(self.order):
            for node in self.tape:
                node.extend(k)
            for state in self.states:
                state.c.append((state.rate.c[k] * unit >> self.bits) // (k + 1))
        allowed = mpf(2)
        for n in (self.order - 1, self.order):
            largest = max(abs(state.c[n]) for state in self.states)
            if largest > 0:
                fits = (self.tolerance / self.number(largest)) ** (mpf(1) / n)
                allowed = min(allowed, fits)
        return allowed

    def at(self, series: Series, t: Number) -> Number:
        """The value of a series after t units."""
        step, total = self.fixed(t), 0
        for c in reversed(series.c):
            total = (total * step >> self.bits) + c
        return self.number(total)

    def advance(self, t: Number) -> None:
        """Takes a step of t units."""
        for state in self.states:
            state.value = self.fixed(self.at(state, t))
        self.unit *= t

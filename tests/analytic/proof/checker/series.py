"""Taylor series of a motion over τ = t/2^scale, whose coefficients are intervals that are found order by order."""
from __future__ import annotations

from collections.abc import Callable
from operator import mul

import intervals
from intervals import ZERO, Real, Unproved

COARSE = 64  # bits of magnitudes, which are rounded upwards


class Expansion:
    """Series in the order in which they depend on each other, and states whose rates are among them."""

    def __init__(self, scale: int):
        self.scale = scale
        self.series: list[Series] = []
        self.rates: list[tuple[Series, Series]] = []
        self.exact_zeros: set[tuple[Series, int]] = set()

    def state(self, start: Real) -> Series:
        """A series whose coefficients but the first come from its rate, which `rates` gives."""
        return Series(self, [start], None)

    def time(self, offset: Real) -> Series:
        return Series(self, [offset, Real(shifted(1 << intervals.BITS, self.scale), 1)], None)

    def expand(self, terms: int) -> None:
        """States go on by the rule xₙ₊₁ = 2^scale ẋₙ/(n + 1)."""
        for order in range(terms):
            for series in self.series:
                series.find(order)
            for state, rate in self.rates:
                if (state, order + 1) in self.exact_zeros:
                    state.append(ZERO)
                    continue
                above = rate.coefficient(order)
                middle, radius = shifted(above.m, self.scale), shifted(above.r, self.scale)
                state.append(Real(middle // (order + 1), radius // (order + 1) + 3))


def shifted(number: int, places: int) -> int:
    return number << places if places >= 0 else (number >> -places) + (1 if number > 0 else 0)


class Series:
    """Coefficients: middles m, radii r, and upper bounds s of their magnitudes in 2^-COARSE."""

    def __init__(self, expansion: Expansion, given: list[Real], rule: Callable[[int], Real] | None):
        self.expansion, self.rule = expansion, rule
        self.m: list[int] = []
        self.r: list[int] = []
        self.s: list[int] = []
        for coefficient in given:
            self.append(coefficient)
        expansion.series.append(self)

    def append(self, coefficient: Real) -> None:
        self.m.append(coefficient.m)
        self.r.append(coefficient.r)
        self.s.append((coefficient.size >> (intervals.BITS - COARSE)) + 1)

    def find(self, order: int) -> None:
        if len(self.m) <= order:
            self.append(self.rule(order) if self.rule else ZERO)

    def coefficient(self, order: int) -> Real:
        return Real(self.m[order], self.r[order])

    def made(self, rule: Callable[[int], Real]) -> Series:
        series = Series(self.expansion, [], rule)
        series.find(0)
        return series

    def of(self, other: Series | Real) -> Series:
        return other if isinstance(other, Series) else Series(self.expansion, [other], None)

    def __add__(self, other: Series | Real) -> Series:
        other = self.of(other)
        return self.made(lambda n: self.coefficient(n) + other.coefficient(n))

    __radd__ = __add__

    def __sub__(self, other: Series | Real) -> Series:
        other = self.of(other)
        return self.made(lambda n: self.coefficient(n) - other.coefficient(n))

    def __rsub__(self, other: Real) -> Series:
        return self.of(other) - self

    def __rtruediv__(self, other: Real) -> Series:
        return self.of(other) / self

    def __mul__(self, other: Series | Real) -> Series:
        if isinstance(other, Real):
            return self.made(lambda n: self.coefficient(n) * other)
        return self.made(lambda n: convolution(self, other, 0, n))

    __rmul__ = __mul__

    def __truediv__(self, other: Series | Real) -> Series:
        """q b = a, so that bₒqₙ = aₙ − Σ qₘ bₙ₋ₘ."""
        if isinstance(other, Real):
            return self.made(lambda n: self.coefficient(n) / other)
        quotient = Series(self.expansion, [], None)
        quotient.rule = lambda n: (self.coefficient(n) - convolution(quotient, other, 0, n - 1, n)) / other.coefficient(0)
        quotient.find(0)
        return quotient


def convolution(a: Series, b: Series, first: int, last: int, order: int | None = None) -> Real:
    """Σ aₘ bₙ₋ₘ, m from first to last; n is the last but where it is said."""
    if last < first:
        return ZERO
    n = last if order is None else order
    backwards = slice(n - last, n - first + 1)
    along = slice(first, last + 1)
    other, radii, sizes = b.m[backwards][::-1], b.r[backwards][::-1], b.s[backwards][::-1]
    middle = sum(map(mul, a.m[along], other)) >> intervals.BITS
    spread = sum(map(mul, a.s[along], radii)) + sum(map(mul, a.r[along], sizes))
    return Real(middle, (spread >> COARSE) + 2)


def sine_cosine(angle: Series, rate: Series | Real) -> tuple[Series, Series]:
    """Of an angle whose rate over t is another series: n sₙ = 2^scale Σ cₘ ωₙ₋₁₋ₘ, n cₙ = −2^scale Σ sₘ ωₙ₋₁₋ₘ."""
    expansion = angle.expansion
    rate = angle.of(rate)
    start = intervals.sine_cosine(angle.coefficient(0))
    sine, cosine = (Series(expansion, [value], None) for value in start)

    def turned(other: Series, n: int) -> Real:
        product = convolution(other, rate, 0, n - 1)
        return Real(shifted(product.m, expansion.scale) // n, shifted(product.r, expansion.scale) // n + 3)

    sine.rule = lambda n: turned(cosine, n)
    cosine.rule = lambda n: -turned(sine, n)
    return sine, cosine


def combination(terms: list[tuple[Real, Series]], constant: Real) -> Series:
    """A sum of series times numbers, and a number."""
    expansion = terms[0][1].expansion
    numbers = [number for number, _ in terms]
    middles, radii = [number.m for number in numbers], [number.r for number in numbers]
    sizes = [(number.size >> (intervals.BITS - COARSE)) + 1 for number in numbers]
    parts = [series for _, series in terms]

    def rule(n: int) -> Real:
        middle = sum(map(mul, middles, [part.m[n] for part in parts])) >> intervals.BITS
        spread = sum(map(mul, sizes, [part.r[n] for part in parts]))
        spread += sum(map(mul, radii, [part.s[n] for part in parts]))
        found = Real(middle, (spread >> COARSE) + 2)
        return found + constant if n == 0 else found

    series = Series(expansion, [], rule)
    series.find(0)
    return series


class Polynomial:
    """Coefficients over τ from an order on, and what they leave out at 0 ≤ τ ≤ 1: of the value and of the slope."""

    def __init__(self, coefficients: list[Real], left_out: int, slope_left_out: int):
        self.coefficients = coefficients
        self.left_out, self.slope_left_out = left_out, slope_left_out

    def value(self, tau: Real) -> Real:
        return horner(self.coefficients, tau).plus_minus(self.left_out)

    def slope(self, tau: Real) -> Real:
        """Over τ."""
        derived = [Real(n * c.m, n * c.r) for n, c in enumerate(self.coefficients)][1:]
        return horner(derived, tau).plus_minus(self.slope_left_out)

    def positive_in(self, lower: Real, upper: Real) -> bool:
        """Whether it is positive between two exact times: by the mean value form, or where it rises or falls, at an end."""
        cell = intervals.hull(lower, upper)
        slope = self.slope(cell)
        middle = Real(cell.m, 0)
        if (self.value(middle) + slope * Real(0, cell.r)).positive():
            return True
        if slope.positive():
            return self.value(lower).positive()
        return slope.negative() and self.value(upper).positive()


def horner(coefficients: list[Real], tau: Real) -> Real:
    """Σ cₙ τⁿ."""
    m, r, size, bits = 0, 0, abs(tau.m) + tau.r, intervals.BITS
    for coefficient in reversed(coefficients):
        r = ((abs(m) * tau.r + r * size) >> bits) + 2 + coefficient.r
        m = (m * tau.m >> bits) + coefficient.m
    return Real(m, r)


def remainder(bound: int, share: Real, terms: int, zeros: int, tau: Real) -> tuple[int, int]:
    """Bounds of Σ from K on of bound (share)ⁿ τ^-zeros and of its slope at τ: K x^K/(1 − x)² is above Σ n xⁿ from K on."""
    rest = intervals.one() - share
    if not rest.positive():
        raise Unproved("a step does not end in its disc")
    whole = Real(0, bound) * intervals.power(share, terms) / intervals.power(tau, zeros)
    return (whole / rest).size, (whole * Real.of(terms) / (rest * rest * tau)).size

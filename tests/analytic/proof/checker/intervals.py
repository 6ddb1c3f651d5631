"""Intervals in whole numbers of 2^-BITS: a middle and a radius that holds all rounding, of real and of complex numbers.

An operation encloses what members give. Nothing here is rounded by the machine: all are Python's integers.
"""
from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from math import atan2, isqrt


class Unproved(Exception):
    """A claim that is not shown to be true."""


BITS = 512


def set_bits(bits: int) -> None:
    """Sets the scale of all numbers; those made before have no meaning after it."""
    global BITS
    BITS = bits


def scaled(number: int | Fraction) -> tuple[int, int]:
    """The nearest whole number of 2^-BITS below, and by how much it may be off."""
    fraction = Fraction(number)
    whole, rest = divmod(fraction.numerator << BITS, fraction.denominator)
    return whole, 1 if rest else 0


class Real:
    """All numbers within a radius r of a middle m, both in 2^-BITS."""
    __slots__ = ("m", "r")

    def __init__(self, m: int, r: int):
        self.m, self.r = m, r

    @classmethod
    def of(cls, number: int | Fraction) -> Real:
        return cls(*scaled(number))

    @classmethod
    def between(cls, lower: int, upper: int) -> Real:
        """From one whole number of 2^-BITS to another."""
        middle = (lower + upper) >> 1
        return cls(middle, max(upper - middle, middle - lower))

    @property
    def lower(self) -> int:
        return self.m - self.r

    @property
    def upper(self) -> int:
        return self.m + self.r

    @property
    def size(self) -> int:
        """No member is larger, either way."""
        return abs(self.m) + self.r

    def positive(self) -> bool:
        return self.m > self.r

    def negative(self) -> bool:
        return -self.m > self.r

    def __neg__(self) -> Real:
        return Real(-self.m, self.r)

    def __add__(self, other: Real) -> Real:
        return Real(self.m + other.m, self.r + other.r) if isinstance(other, Real) else NotImplemented

    def __sub__(self, other: Real) -> Real:
        return Real(self.m - other.m, self.r + other.r) if isinstance(other, Real) else NotImplemented

    def __mul__(self, other: Real) -> Real:
        if not isinstance(other, Real):
            return NotImplemented
        spread = abs(self.m) * other.r + self.r * (abs(other.m) + other.r)
        return Real(self.m * other.m >> BITS, (spread >> BITS) + 2)

    def __truediv__(self, other: Real) -> Real:
        """|a/b − m/n| ≤ (r + |m/n| s)/(|n| − s) where a is within r of m, b within s of n."""
        if not isinstance(other, Real):
            return NotImplemented
        least = abs(other.m) - other.r
        if least <= 0:
            raise Unproved("a divisor may be zero")
        quotient = (self.m << BITS) // other.m
        return Real(quotient, ((self.r << BITS) + (abs(quotient) + 1) * other.r) // least + 2)

    def plus_minus(self, radius: int) -> Real:
        """With all within so many 2^-BITS."""
        return Real(self.m, self.r + radius)


ZERO = Real(0, 0)


def one() -> Real:
    return Real(1 << BITS, 0)


def hull(a: Real, b: Real) -> Real:
    return Real.between(min(a.lower, b.lower), max(a.upper, b.upper))


def common(a: Real, b: Real) -> Real:
    """What is in both."""
    lower, upper = max(a.lower, b.lower), min(a.upper, b.upper)
    if lower > upper:
        raise Unproved("two enclosures of one number have nothing in common")
    return Real.between(lower, upper)


def root(a: Real) -> Real:
    if a.lower < 0:
        raise Unproved("a root of what may be negative")
    return Real.between(isqrt(a.lower << BITS), isqrt(a.upper << BITS) + 1)


def power(base: Real, exponent: int) -> Real:
    result = one()
    for digit in bin(exponent)[2:]:
        result = result * result
        if digit == "1":
            result = result * base
    return result


def halved(a: Real, times: int) -> Real:
    return Real(a.m >> times, (a.r >> times) + 2)


def exponential_parts(x: Real, sign: int) -> tuple[Real, Real]:
    """The odd and the even part of the series of sin and cos (sign −1), or sinh and cosh (1), for |x| ≤ 1/16.

    Each term is at most 1/16 of the one before, so that those left out add up to less than twice the first of them.
    """
    odd, even, term, order = ZERO, ZERO, one(), 0
    while term.size > 8:
        if order % 2 == 0:
            even = even + term
        else:
            odd = odd + term
        order += 1
        term = term * x
        term = Real(term.m // order, term.r // order + 2)
        if order % 2 == 0 and sign < 0:
            term = -term
        if order > 2 * BITS:
            raise Unproved("a series does not end")
    return odd.plus_minus(2 * term.size), even.plus_minus(2 * term.size)


def sine_cosine(angle: Real) -> tuple[Real, Real]:
    """Both of the middle m by half angles; |sin(m + d) − sin m| ≤ |sin m| d²/2 + |cos m| |d|, and likewise of the cosine."""
    if angle.r >> (BITS - 8):
        return wide_sine_cosine(angle)
    halvings = max(0, angle.m.bit_length() - BITS + 4)
    sine, cosine = exponential_parts(halved(Real(angle.m, 0), halvings), -1)
    for _ in range(halvings):
        sine, cosine = sine * cosine + sine * cosine, one() - (sine * sine + sine * sine)
    first, second = Real(0, angle.r), Real(0, (angle.r * angle.r >> BITS) + 1)
    return (sine.plus_minus((sine * second).size + (cosine * first).size),
            cosine.plus_minus((cosine * second).size + (sine * first).size))


def wide_sine_cosine(angle: Real) -> tuple[Real, Real]:
    """Both by their values at the ends: over less than 3 rad each has one extremum at most, where the other changes sign."""
    if 2 * angle.r >= 3 << BITS:
        return Real(0, 1 << BITS), Real(0, 1 << BITS)
    (first, start), (last, end) = sine_cosine(Real(angle.lower, 0)), sine_cosine(Real(angle.upper, 0))
    return with_extremum(first, last, start, end), with_extremum(start, end, -first, -last)


def with_extremum(first: Real, last: Real, slope: Real, last_slope: Real) -> Real:
    """The hull of a sine's values at both ends, and of 1 or −1 where its slope may change sign between them."""
    ends, unit = hull(first, last), one()
    if slope.positive() and last_slope.positive() or slope.negative() and last_slope.negative():
        return ends
    if slope.positive() and last_slope.negative():
        return hull(ends, unit)
    return hull(ends, -unit) if slope.negative() and last_slope.positive() else Real(0, unit.m)


def largest_hyperbolic(size: int) -> tuple[int, int]:
    """Bounds of sinh and cosh of all up to a size."""
    halvings = max(0, size.bit_length() - BITS + 4)
    sine, cosine = exponential_parts(halved(Real(size, 0), halvings), 1)
    for _ in range(halvings):
        sine, cosine = sine * cosine + sine * cosine, one() + (sine * sine + sine * sine)
    return sine.upper, cosine.upper


def arctangent(y: Fraction, x: Fraction) -> Real:
    """The angle of a point with x > 0, by a sign change of y cos φ − x sin φ around the machine's own."""
    guess = Fraction(atan2(y, x))
    for _ in range(12):
        sine, cosine = sine_cosine(Real.of(guess))
        slip = (Real.of(y) * cosine - Real.of(x) * sine) / (Real.of(y) * sine + Real.of(x) * cosine)
        step = Fraction(slip.m, 1 << BITS)
        guess = Fraction(round((guess + step) * (1 << BITS)), 1 << BITS)
    near = Fraction(1, 1 << (BITS - 40))
    for side in (-1, 1):
        sine, cosine = sine_cosine(Real.of(guess + side * near))
        if not (Real.of(-side * y) * cosine + Real.of(side * x) * sine).positive():
            raise Unproved("an arc tangent")
    return Real.of(guess).plus_minus(1 << 40)


def half_turn() -> Real:
    """π."""
    return half_turn_at(BITS)


@lru_cache
def half_turn_at(bits: int) -> Real:
    """Four times the angle of (1, 1), at the present scale, which is part of what is remembered."""
    quarter = arctangent(Fraction(1), Fraction(1))
    return Real(4 * quarter.m, 4 * quarter.r)


class Complex:
    """A rectangle."""
    __slots__ = ("re", "im")

    def __init__(self, re: Real, im: Real = ZERO):
        self.re, self.im = re, im

    @classmethod
    def disc(cls, centre: Real, radius: Real) -> Complex:
        """Around all |z − c| ≤ radius."""
        return cls(centre.plus_minus(radius.upper), Real(0, radius.upper))

    def __add__(self, other: Complex | Real) -> Complex:
        other = as_complex(other)
        return Complex(self.re + other.re, self.im + other.im)

    __radd__ = __add__

    def __sub__(self, other: Complex | Real) -> Complex:
        other = as_complex(other)
        return Complex(self.re - other.re, self.im - other.im)

    def __rsub__(self, other: Real) -> Complex:
        return Complex(other) - self

    def __rtruediv__(self, other: Real) -> Complex:
        return Complex(other) / self

    def __mul__(self, other: Complex | Real) -> Complex:
        if isinstance(other, Real):
            return Complex(self.re * other, self.im * other)
        return Complex(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)

    __rmul__ = __mul__

    def __truediv__(self, other: Complex | Real) -> Complex:
        if isinstance(other, Real):
            return Complex(self.re / other, self.im / other)
        square = other.re * other.re + other.im * other.im
        if not square.positive():
            raise Unproved("a divisor may be zero")
        above = self * Complex(other.re, -other.im)
        return Complex(above.re / square, above.im / square)

    @property
    def size(self) -> int:
        square = self.re.size * self.re.size + self.im.size * self.im.size
        return isqrt(square) + 1


def as_complex(number: Complex | Real) -> Complex:
    return number if isinstance(number, Complex) else Complex(number)


def complex_sine_cosine(angle: Complex) -> tuple[Complex, Complex]:
    """sin(x + iy) = sin x cosh y + i cos x sinh y, cos(x + iy) = cos x cosh y − i sin x sinh y."""
    sine, cosine = sine_cosine(angle.re)
    sinh, cosh = largest_hyperbolic(angle.im.size)
    across, along = Real(0, sinh), Real.between(1 << BITS, cosh)
    return Complex(sine * along, cosine * across), Complex(cosine * along, -(sine * across))

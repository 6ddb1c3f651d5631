"""Mechanics of a stack in a pattern: rigid groups of blocks that turn about pivots.

A place is Σ a eₓ + b e_y over groups, with exact a and b: eₓ = (cos θ, −sin θ) and e_y = (sin θ, cos θ) of a group that has
turned by θ, clockwise. Its velocity is Σ ω (b eₓ − a e_y), its acceleration Σ α (b eₓ − a e_y) − ω² (a eₓ + b e_y). Group 0 is
what stays with the ground.
"""
from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any, NamedTuple

import intervals
import series
from intervals import ZERO, Complex, Real
from scene import Scene

Number = Any  # Real, Complex or Series
Place = dict[int, tuple[Fraction, Fraction]]
Pattern = tuple[int, ...]


def shifted(place: Place, group: int, along: Fraction, across: Fraction) -> Place:
    a, b = place.get(group, (Fraction(0), Fraction(0)))
    return place | {group: (a + along, b + across)}


def between(place: Place, other: Place) -> Place:
    for group, (a, b) in other.items():
        place = shifted(place, group, -a, -b)
    return place


class Chain:
    """Exact numbers of a pattern. SI units."""

    def __init__(self, scene: Scene, pattern: Pattern):
        self.scene, self.pattern = scene, pattern
        self.group_of: list[int] = []
        self.centres: list[Place] = []
        self.corners: list[tuple[Place, Place]] = []  # right and left end of each interface
        foot: Place = {}
        below = 0
        for k, block in enumerate(scene.blocks):
            half = half_width(scene, k)
            group = max(self.group_of, default=0) + 1 if pattern[k] else below
            if pattern[k]:
                foot = shifted(shifted(foot, below, pattern[k] * half, Fraction(0)), group, -pattern[k] * half, Fraction(0))
            self.group_of.append(group)
            self.corners.append((shifted(foot, group, half, Fraction(0)), shifted(foot, group, -half, Fraction(0))))
            self.centres.append(shifted(foot, group, block.centre_x, block.centre_y))
            foot, below = shifted(foot, group, Fraction(0), block.height), group
        self.groups = below
        self.moments: dict[tuple[int, int], Moment] = {}
        self.mass = [[self.mass_terms(g, h) for h in range(below + 1)] for g in range(below + 1)]
        self.force = [[self.force_terms(g, h) for h in range(below + 1)] for g in range(below + 1)]

    def pairs(self, g: int, h: int) -> list[tuple[Fraction, tuple[Fraction, Fraction], tuple[Fraction, Fraction]]]:
        none = (Fraction(0), Fraction(0))
        return [(block.mass, place.get(g, none), place.get(h, none))
                for block, place in zip(self.scene.blocks, self.centres, strict=True)]

    def mass_terms(self, g: int, h: int) -> tuple[Fraction, Fraction]:
        """Factors of cos(θₕ − θ₉) and sin(θₕ − θ₉) in Σ m V₉·Vₕ, with the inertia of a group."""
        along = sum(m * (b * d + a * c) for m, (a, b), (c, d) in self.pairs(g, h))
        across = sum(m * (a * d - b * c) for m, (a, b), (c, d) in self.pairs(g, h))
        own = sum(block.inertia for k, block in enumerate(self.scene.blocks) if g == h == self.group_of[k])
        return Fraction(along + own), Fraction(across)

    def mass_parts(self, directions: Directions, g: int, h: int) -> list[tuple[Fraction, Number]]:
        """What an entry of the mass matrix is the sum of."""
        return [(factor, directions.product(g, h)[part]) for part, factor in enumerate(self.mass[g][h]) if part == 0 or g != h]

    def force_terms(self, g: int, h: int) -> tuple[Fraction, Fraction]:
        """Of Σ m V₉·(what ω²ₕ is taken times)."""
        along = sum(m * (b * c - a * d) for m, (a, b), (c, d) in self.pairs(g, h))
        across = sum(m * (b * d + a * c) for m, (a, b), (c, d) in self.pairs(g, h))
        return Fraction(along), Fraction(across)

    def moment(self, k: int, end: int) -> Moment:
        if (k, end) not in self.moments:
            self.moments[k, end] = self.moment_terms(k, end)
        return self.moments[k, end]

    def moment_terms(self, k: int, end: int) -> Moment:
        """Of what the blocks above interface k need about an end, 0 right, 1 left."""
        turning: dict[tuple[int, int], tuple[Fraction, Fraction]] = {}
        square: dict[tuple[int, int], tuple[Fraction, Fraction]] = {}
        body: dict[int, tuple[Fraction, Fraction]] = {}
        inertia: dict[int, Fraction] = {}

        def add(table: Any, key: Any, along: Fraction, across: Fraction) -> None:
            before = table.get(key, (Fraction(0), Fraction(0)))
            table[key] = before[0] + along, before[1] + across

        for j in range(k, len(self.pattern)):
            block = self.scene.blocks[j]
            inertia[self.group_of[j]] = inertia.get(self.group_of[j], Fraction(0)) + block.inertia
            for g, (a, b) in between(self.centres[j], self.corners[k][end]).items():
                add(body, g, block.mass * a, block.mass * b)
                for h, (c, d) in self.centres[j].items():
                    add(turning, (g, h), block.mass * (a * c + b * d), block.mass * (a * d - b * c))
                    add(square, (g, h), block.mass * (a * d - b * c), -block.mass * (a * c + b * d))
        return Moment(turning, square, body, inertia)


class Moment(NamedTuple):
    turning: dict[tuple[int, int], tuple[Fraction, Fraction]]  # factors of α cos and α sin
    square: dict[tuple[int, int], tuple[Fraction, Fraction]]  # of ω² cos and ω² sin
    body: dict[int, tuple[Fraction, Fraction]]  # mass times place
    inertia: dict[int, Fraction]


def half_width(scene: Scene, k: int) -> Fraction:
    """Of the interface under a block."""
    return min(block.width for block in scene.blocks[max(k - 1, 0):k + 1]) / 2


def real(number: Fraction) -> Real:
    return real_at(number, intervals.BITS)


@lru_cache(maxsize=4096)
def real_at(number: Fraction, bits: int) -> Real:
    """Of the present scale, which is part of what is remembered."""
    return Real.of(number)


def combine(terms: list[tuple[Fraction, Number]]) -> Number:
    """Σ of exact factors times numbers."""
    terms = [(factor, number) for factor, number in terms if factor]
    moving = [(real(factor), number) for factor, number in terms if isinstance(number, series.Series)]
    total: Number = ZERO
    for factor, number in terms:
        if not isinstance(number, series.Series):
            total = as_like(number, total) + number * real(factor)
    return series.combination(moving, total) if moving else total


def as_like(number: Number, total: Number) -> Number:
    return Complex(total) if isinstance(number, Complex) and isinstance(total, Real) else total


@dataclass
class Directions:
    """sin and cos of each group's angle, group 0 first, and of their differences."""
    sine: list[Number]
    cosine: list[Number]

    def along(self, g: int, h: int) -> Number:
        return self.product(g, h)[0]

    def across(self, g: int, h: int) -> Number:
        return self.product(g, h)[1]

    def __post_init__(self) -> None:
        self.known: dict[tuple[int, int], tuple[Number, Number]] = {}

    def product(self, g: int, h: int) -> tuple[Number, Number]:
        """cos(θₕ − θ₉) and sin(θₕ − θ₉)."""
        if g == h:
            return intervals.one(), ZERO
        if g == 0 or h == 0:
            return (self.cosine[h], self.sine[h]) if g == 0 else (self.cosine[g], self.sine[g] * -intervals.one())
        if (g, h) not in self.known:
            self.known[g, h] = (self.cosine[g] * self.cosine[h] + self.sine[g] * self.sine[h],
                                self.sine[h] * self.cosine[g] - self.cosine[h] * self.sine[g])
        return self.known[g, h]


def sine_cosine(angle: Number, rate: Number) -> tuple[Number, Number]:
    if isinstance(angle, series.Series):
        return series.sine_cosine(angle, rate)
    return intervals.complex_sine_cosine(angle) if isinstance(angle, Complex) else intervals.sine_cosine(angle)


def directions_of(angles: list[Number], rates: list[Number]) -> Directions:
    """Of absolute angles of groups 1 and on."""
    sines, cosines = [ZERO], [intervals.one()]
    for angle, rate in zip(angles, rates, strict=True):
        sine, cosine = sine_cosine(angle, rate)
        sines.append(sine)
        cosines.append(cosine)
    return Directions(sines, cosines)


def summed(relative: list[Number]) -> list[Number]:
    sums: list[Number] = []
    for number in relative:
        sums.append(sums[-1] + number if sums else number)
    return sums


class Forces:
    """Accelerations and margins at a state: relative angles and rates of open interfaces, from the ground up."""

    def __init__(self, chain: Chain, angles: list[Number], rates: list[Number], body: tuple[Number, Number]):
        self.chain, self.body = chain, body
        self.omega = [ZERO, *summed(rates)]
        self.directions = directions_of(summed(angles), self.omega[1:])
        self.squares = [ZERO] + [rate * rate for rate in self.omega[1:]]
        self.across = [self.body_terms(g) for g in range(chain.groups + 1)]
        self.products: dict[tuple[str, int, int, int], Number] = {}
        self.alpha: list[Number] = [ZERO]
        self.alpha += solve(self.mass_matrix(), [self.force(g) for g in range(1, chain.groups + 1)])

    def body_terms(self, g: int) -> tuple[Number, Number]:
        """eₓ·b and e_y·b."""
        (x, y), sine, cosine = self.body, self.directions.sine[g], self.directions.cosine[g]
        if g == 0:
            return x, y
        return x * cosine - y * sine, x * sine + y * cosine

    def times(self, what: str, h: int, g: int, part: int) -> Number:
        """α or ω² of group h times cos or sin of θₕ − θ₉."""
        if (what, h, g, part) not in self.products:
            factor = (self.alpha if what == "alpha" else self.squares)[h]
            self.products[what, h, g, part] = factor if g == h else self.directions.product(g, h)[part] * factor
        return self.products[what, h, g, part]

    def mass_matrix(self) -> list[list[Number]]:
        groups = range(1, self.chain.groups + 1)
        return [[combine(self.chain.mass_parts(self.directions, g, h)) for h in groups] for g in groups]

    def force(self, g: int) -> Number:
        terms = [(factor, self.times("square", h, g, part)) for h in range(1, self.chain.groups + 1) if h != g
                 for part, factor in enumerate(self.chain.force[g][h])]
        along, across = self.across[g]
        pairs = self.chain.pairs(g, g)
        return combine([*terms, (Fraction(sum(m * b for m, (_, b), _ in pairs)), along),
                        (Fraction(-sum(m * a for m, (a, _), _ in pairs)), across)])

    def margin(self, k: int, side: int) -> Number:
        """How far the pressure of a closed interface is from its right end (1) or left one (−1), times the force: N·m."""
        moment = self.chain.moment(k, 0 if side > 0 else 1)
        terms = [(factor, self.alpha[h]) for h, factor in moment.inertia.items() if h]
        for what, table in (("alpha", moment.turning), ("square", moment.square)):
            for (g, h), factors in table.items():
                terms += [(factor, self.times(what, h, g, part)) for part, factor in enumerate(factors)
                          if h and (part == 0 or g != h)]
        for g, (a, b) in moment.body.items():
            terms += [(a, self.across[g][1]), (-b, self.across[g][0])]
        return combine([(side * factor, number) for factor, number in terms])

    def relative(self) -> list[Number]:
        """Accelerations of open interfaces, from the ground up."""
        return [high - low if g else high for g, (high, low) in enumerate(zip(self.alpha[1:], self.alpha, strict=False))]


def solve(matrix: list[list[Number]], right: list[Number]) -> list[Number]:
    """By elimination."""
    size = len(right)
    matrix, right = [list(row) for row in matrix], list(right)
    for i in range(size):
        for j in range(i + 1, size):
            factor = matrix[j][i] / matrix[i][i]
            for column in range(i + 1, size):
                matrix[j][column] = matrix[j][column] - factor * matrix[i][column]
            right[j] = right[j] - factor * right[i]
    solution: list[Number] = [ZERO] * size
    for i in reversed(range(size)):
        rest = right[i]
        for column in range(i + 1, size):
            rest = rest - matrix[i][column] * solution[column]
        solution[i] = rest / matrix[i][i]
    return solution

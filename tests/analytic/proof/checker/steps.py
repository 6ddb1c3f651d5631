"""Stretches of smooth motion: enclosure, guards, and the event that ends them."""
from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from math import ceil, log2
from typing import Any

import intervals
from chain import Chain, Forces, Pattern, half_width, real, summed
from ground import body_force
from intervals import ZERO, Complex, Real, Unproved, common, hull
from scene import Scene
from series import Expansion, Polynomial, Series, remainder

Claim = dict[str, Any]
SIDES = {1: "R", -1: "L", 0: "C"}


@dataclass
class State:
    """A set of states at an instant within an interval, SI units; angles and rates are relative, 0 of closed interfaces.

    zeros: the orders to which angles of open interfaces are exactly zero now.
    """
    pattern: Pattern
    angles: list[Real]
    rates: list[Real]
    zeros: list[int]
    time: Real
    piece: int = 0

    def open(self) -> list[int]:
        return [k for k, side in enumerate(self.pattern) if side]


def exact(text: str) -> Fraction:
    """A claim's "mantissa*2^exponent"."""
    mantissa, exponent = text.split("*2^")
    return int(mantissa) * Fraction(2) ** int(exponent)


def require(holds: bool, claim: str) -> None:
    if not holds:
        raise Unproved(claim)


class Mechanics:
    """A scene with what is remembered of its patterns."""

    def __init__(self, scene: Scene):
        self.scene, self.pieces = scene, scene.pieces()
        self.chains: dict[Pattern, Chain] = {}
        self.toppling = [toppling_angle(scene, k) for k in range(len(scene.blocks))]

    def chain(self, pattern: Pattern) -> Chain:
        if pattern not in self.chains:
            self.chains[pattern] = Chain(self.scene, pattern)
        return self.chains[pattern]

    def offset(self, state: State) -> Real:
        return state.time - real(self.pieces[state.piece][0])

    def left(self, state: State) -> Real:
        return real(self.pieces[state.piece][1]) - state.time

    def forces(self, state: State, pattern: Pattern, angles: list[Any], rates: list[Any], time: Any) -> Forces:
        """Angles and rates of the pattern's open interfaces; the time is since the ground's piece began."""
        body = body_force(self.scene, self.pieces[state.piece][0], time)
        return Forces(self.chain(pattern), angles, rates, body)


def toppling_angle(scene: Scene, k: int) -> Real:
    """Halfway between a block on its side and its balance uphill, which is 0.02 before that side at most."""
    block, half = scene.blocks[k], half_width(scene, k)
    on_side = intervals.half_turn() / real(Fraction(2))
    balance = larger(*(intervals.arctangent(half + side * block.centre_x, block.centre_y) for side in (1, -1)))
    if scene.inclination:
        latest = on_side - real(Fraction("0.02"))
        uphill = balance + real(abs(scene.inclination))
        balance = larger(balance, -larger(-uphill, -latest))
    return (balance + on_side) / real(Fraction(2))


def larger(a: Real, b: Real) -> Real:
    return Real.between(max(a.lower, b.lower), max(a.upper, b.upper))


@dataclass
class Guard:
    """A series that is positive until it ends a step, times a sign; its bound on the disc, and a number that is added."""
    kind: str
    interface: int
    side: int
    series: Series
    sign: int
    zeros: int
    bound: int
    constant: Real = ZERO


class Step:
    def __init__(self, mechanics: Mechanics, state: State, claim: Claim):
        self.mechanics, self.state, self.claim = mechanics, state, claim
        self.radius = real(exact(claim["radius"]))
        require(self.radius.positive(), "a radius is positive")
        self.angle_reach = [real(exact(text)) for text in claim["angle_reach"]]
        self.rate_reach = [real(exact(text)) for text in claim["rate_reach"]]
        require(len(self.angle_reach) == len(self.rate_reach) == len(state.pattern), "a reach for each interface")
        self.enclose()
        self.end = self.claimed_end()
        require(self.end.positive(), "a step goes forwards")
        self.scale = self.end.upper.bit_length() - intervals.BITS
        self.expand()

    def claimed_end(self) -> Real:
        """The latest time that the step has to be known to, s."""
        if "event" in self.claim:
            return real(exact(self.claim["event"]["interval"][1]))
        return real(exact(self.claim["length"])) if "length" in self.claim else self.mechanics.left(self.state)

    def enclose(self) -> None:
        """Picard's test on the disc of complex times: R sup|f| stays below the reach. Margins' bounds there follow."""
        state, pattern = self.state, self.state.pattern
        angles = [Complex.disc(state.angles[k], self.angle_reach[k]) for k in state.open()]
        rates = [Complex.disc(state.rates[k], self.rate_reach[k]) for k in state.open()]
        time = Complex.disc(self.mechanics.offset(state), self.radius)
        forces = self.mechanics.forces(state, pattern, angles, rates, time)
        for place, k in enumerate(state.open()):
            for change, reach in ((rates[place], self.angle_reach[k]), (forces.relative()[place], self.rate_reach[k])):
                needed = Real(0, change.size) * self.radius
                require(needed.size < reach.lower, f"the disc's motion of interface {k + 1} stays within its reach")
        self.bounds = {(k, side): forces.margin(k, side).size for k, open_side in enumerate(pattern) if not open_side
                       for side in (1, -1)}

    def expand(self) -> None:
        state, expansion = self.state, Expansion(self.scale)
        ratio = log2(float(Fraction(self.radius.m, self.end.upper)))
        require(ratio >= 1, "a step is at most half its disc")
        self.terms = max(8, ceil(intervals.BITS / ratio) + 6)
        self.angles = [expansion.state(state.angles[k]) for k in state.open()]
        self.rates = [expansion.state(state.rates[k]) for k in state.open()]
        time = expansion.time(self.mechanics.offset(state))
        forces = self.mechanics.forces(state, state.pattern, self.angles, self.rates, time)
        for angle, rate, acceleration, k in zip(self.angles, self.rates, forces.relative(), state.open(), strict=True):
            expansion.rates += [(angle, rate), (rate, rate.of(acceleration))]
            if state.zeros[k] == 3:
                expansion.exact_zeros.add((rate, 1))
        self.guards = [*self.guards_of_interfaces(forces), *self.guards_of_toppling()]
        expansion.expand(self.terms)

    def guards_of_interfaces(self, forces: Forces) -> list[Guard]:
        guards, state = [], self.state
        for place, k in enumerate(state.open()):
            bound = state.angles[k].size + self.angle_reach[k].size
            guards.append(Guard("impact", k, state.pattern[k], self.angles[place], state.pattern[k], state.zeros[k], bound))
        for (k, side), bound in self.bounds.items():
            margin = forces.margin(k, side)
            if isinstance(margin, Series):
                guards.append(Guard("opening", k, side, margin, 1, 0, bound))
            else:
                require(margin.positive(), f"a margin of interface {k + 1} is positive for ever")
        return guards

    def guards_of_toppling(self) -> list[Guard]:
        groups = self.mechanics.chain(self.state.pattern).group_of
        theta = [None, *summed(self.angles)]
        bounds = [0] + summed([self.state.angles[k].size + self.angle_reach[k].size for k in self.state.open()])
        return [Guard("topple", k, side, theta[group], -side, 0, bounds[group] + limit.size, limit)
                for k, (group, limit) in enumerate(zip(groups, self.mechanics.toppling, strict=True)) if group
                for side in (1, -1)]

    def tau(self, time: Fraction | Real) -> Real:
        number = real(time) if isinstance(time, Fraction) else time
        return Real(number.m << -self.scale, number.r << -self.scale) if self.scale < 0 else intervals.halved(number, self.scale)

    def polynomial(self, guard: Guard) -> Polynomial:
        coefficients = [Real(guard.sign * m, r) for m, r in zip(guard.series.m, guard.series.r, strict=True)][:self.terms]
        coefficients[0] = coefficients[0] + guard.constant
        end = Real(self.end.upper, 0)
        left_out, slope = remainder(guard.bound, end / self.radius, self.terms, guard.zeros, self.tau(end))
        return Polynomial(coefficients[guard.zeros:], left_out, slope)

    def check_guards(self) -> Real | None:
        """Every guard is positive up to the end, or the claimed event's up to it. The event's time since the start, s."""
        cells = {(cell["kind"], cell["interface"] - 1, cell["side"]): cell["ends"] for cell in self.claim.get("cells", [])}
        event, found = self.claim.get("event"), None
        for guard in self.guards:
            polynomial = self.polynomial(guard)
            ends = [exact(text) for text in cells.get((guard.kind, guard.interface, guard.side), [])]
            last = Real(self.end.upper, 0)
            if event and (event["kind"], event["interface"] - 1, event["side"]) == (guard.kind, guard.interface, guard.side):
                found = self.crossing(polynomial, [exact(text) for text in event["interval"]])
                last = real(exact(event["interval"][0]))
            points = [ZERO, *(self.tau(end) for end in ends), self.tau(last)]
            for lower, upper in zip(points, points[1:], strict=False):
                require(lower.upper <= upper.lower, "cells are in order")
                require(polynomial.positive_in(lower, upper),
                        f"{guard.kind} of interface {guard.interface + 1} on side {SIDES[guard.side]} is before the claimed end")
        require(event is None or found is not None, "an event is of a guard")
        return found

    def crossing(self, polynomial: Polynomial, bracket: list[Fraction]) -> Real:
        """Its only zero in a bracket, s, by the signs at both ends and that of the slope; Newton's method makes it narrow."""
        lower, upper = (self.tau(end) for end in bracket)
        require(bracket[0] < bracket[1] and lower.positive(), "a bracket has a width, after the step's start")
        require(polynomial.value(lower).positive(), "the guard is positive before its bracket")
        require(polynomial.value(upper).negative(), "the guard is negative after its bracket")
        zero = hull(lower, upper)
        require(polynomial.slope(zero).negative(), "the guard falls in its bracket")
        for _ in range(2):
            centre = Real(zero.m, 0)
            zero = common(zero, centre - polynomial.value(centre) / polynomial.slope(zero))
        return intervals.halved(zero, -self.scale) if self.scale < 0 else Real(zero.m << self.scale, zero.r << self.scale)

    def at(self, time: Real) -> State:
        """The state so many seconds later, in the same pattern."""
        angles, rates = list(self.state.angles), list(self.state.rates)
        share = Real(self.end.upper, 0) / self.radius
        tau = self.tau(time)
        for place, k in enumerate(self.state.open()):
            for values, expanded, reach in ((angles, self.angles, self.angle_reach), (rates, self.rates, self.rate_reach)):
                left_out, _ = remainder(reach[k].size, share, self.terms, 0, intervals.one())
                coefficients = [expanded[place].coefficient(n) for n in range(self.terms)]
                values[k] = Polynomial(coefficients, left_out, 0).value(tau)
        return replace(self.state, angles=angles, rates=rates, zeros=[0] * len(angles), time=self.state.time + time)


def check_step(mechanics: Mechanics, state: State, claim: Claim) -> State:
    """The state where the claimed step ends: at its event, after its length, or with the ground's piece."""
    step = Step(mechanics, state, claim)
    event = step.check_guards()
    left = mechanics.left(state)
    if event is not None:
        require((left - event).positive(), "an event is before the ground's piece ends")
        return step.at(event)
    if "length" in claim:
        length = real(exact(claim["length"]))
        require((left - length).positive(), "a step ends before the ground's piece")
        return step.at(length)
    return replace(step.at(left), time=real(mechanics.pieces[state.piece][1]), piece=state.piece + 1)

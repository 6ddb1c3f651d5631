"""Infinitely many impacts of one interface in a finite time, by a box that nothing leaves (accumulation.hpp has the lemma)."""
from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction

import intervals
from chain import Chain, combine, directions_of, real, solve, summed
from decisions import check_impact
from intervals import ZERO, Real, hull, root
from steps import Claim, Mechanics, State, exact, require


@dataclass
class Flight:
    """Bounds in the box while the interface is on one side."""
    back: Real  # how strongly it is brought back, rad/s²
    share: Real  # what an impact leaves of its speed
    stretch: Real  # of speeds at both ends of a flight
    gain: list[int]  # of others' rates
    thrown: list[int]
    drift: list[Real]
    coupling: list[Real]
    variation: list[int]


class Box:
    def __init__(self, mechanics: Mechanics, state: State, k: int, claim: Claim):
        self.mechanics, self.state, self.k = mechanics, state, k
        self.duration, self.speed, self.reach = (real(exact(claim[key])) for key in ("duration", "speed", "reach"))
        self.angles = [real(exact(text)) for text in claim["angles"]]
        self.rates = [real(exact(text)) for text in claim["rates"]]
        require(len(self.angles) == len(self.rates) == len(state.pattern), "a size of the box for each interface")
        self.others = [j for j in state.open() if j != k]
        self.trials = claim["impacts"]

    def flight(self, side: int, trial: Claim) -> Flight:
        state, k = self.state, self.k
        pattern = tuple(side if j == k else old for j, old in enumerate(state.pattern))
        angles = [angle.plus_minus(self.angles[j].upper) if j in self.others else angle for j, angle in enumerate(state.angles)]
        rates = [rate.plus_minus(self.rates[j].upper) if j in self.others else rate for j, rate in enumerate(state.rates)]
        angles[k], rates[k] = Real(0, self.reach.upper), Real(0, self.speed.upper)
        for j in self.others:
            require(Real(pattern[j] * angles[j].m, angles[j].r).positive(), "no other interface closes in the box")
        self.stand(pattern, angles)
        offset = self.mechanics.offset(state)
        forces = self.mechanics.forces(state, pattern, [angles[j] for j in state.open()], [rates[j] for j in state.open()],
                                       hull(offset, offset + self.duration))
        relative = dict(zip(state.open(), forces.relative(), strict=True))
        back = Real(-side * relative[k].m, relative[k].r)
        require(back.positive(), "a flight comes back")
        for j, old in enumerate(pattern):
            holds = bool(old) or forces.margin(j, 1).positive() and forces.margin(j, -1).positive()
            require(holds, "no other interface opens in the box")
        angles[k] = ZERO
        outcome = check_impact(self.mechanics, pattern, k, angles, trial)
        other = tuple(-old if j == k else old for j, old in enumerate(pattern))
        require(outcome.pattern == other, "an impact throws its interface alone")
        thrown = outcome.rates()
        spread = Real(back.upper, 0) / Real(back.lower, 0)
        now = [ZERO if j == k else angle for j, angle in enumerate(state.angles)]
        angles[k] = Real(0, self.reach.upper)
        coupling, varied = self.coupling(pattern, now), self.coupling(pattern, angles)
        return Flight(back, Real(-side * thrown[k].m, thrown[k].r), hull(root(intervals.one() / spread), root(spread)),
                      [relative[j].size for j in self.others], [thrown[j].size for j in self.others],
                      [relative[j] + c * relative[k] for j, c in zip(self.others, coupling, strict=True)], coupling,
                      [(c - d).size for c, d in zip(coupling, varied, strict=True)])

    def stand(self, pattern: tuple[int, ...], angles: list[Real]) -> None:
        """No block topples in the box."""
        theta = [ZERO, *summed([angles[j] for j in self.state.open()])]
        groups = self.mechanics.chain(pattern).group_of
        for group, limit in zip(groups, self.mechanics.toppling, strict=True):
            require(theta[group].size < limit.lower, "no block topples in the box")

    def coupling(self, pattern: tuple[int, ...], angles: list[Real]) -> list[Real]:
        """Rates of the others that have the momenta of a unit rate of k."""
        if not self.others:
            return []
        opened = self.state.open()
        matrix = relative_masses(self.mechanics.chain(pattern), [angles[j] for j in opened])
        places = [opened.index(j) for j in self.others]
        own = opened.index(self.k)
        return solve([[matrix[i][j] for j in places] for i in places], [matrix[i][own] for i in places])


def relative_masses(chain: Chain, angles: list[Real]) -> list[list[Real]]:
    """The mass matrix of relative angles: sums over all groups above both."""
    directions = directions_of(summed(angles), angles)
    groups = range(1, chain.groups + 1)
    absolute = [[combine(chain.mass_parts(directions, g, h)) for h in groups] for g in groups]
    size = len(absolute)
    total = [[ZERO] * size for _ in range(size)]
    for i in range(size):
        for j in range(size):
            for g in range(i, size):
                for h in range(j, size):
                    total[i][j] = total[i][j] + absolute[g][h]
    return total


def accumulated(mechanics: Mechanics, state: State, claim: Claim) -> State:
    k = claim["interface"] - 1
    require(k in state.open() and state.zeros[k] == 1, "the interface has left an impact")
    box = Box(mechanics, state, k, claim)
    speed = Real(state.pattern[k] * state.rates[k].m, state.rates[k].r)
    require(speed.positive(), "it leaves at a speed")
    sides = state.pattern[k], -state.pattern[k]
    first, second = (box.flight(side, trial) for side, trial in zip(sides, box.trials, strict=True))
    q, p = first.share * first.stretch, second.share * second.stretch
    rest = intervals.one() - q * p
    require(rest.positive(), "impacts fade")
    two = real(Fraction(2))
    duration = two * speed * (intervals.one() / first.back + q / second.back) / rest
    pair = speed * (intervals.one() + first.stretch + q * (intervals.one() + second.stretch))
    speeds = pair / rest
    least = Real(min(first.back.lower, second.back.lower), 0)
    require(duration.size < box.duration.lower, "flights end within the box's time")
    require(pair.size < box.speed.lower, "no flight is faster than the box")
    require((pair * pair / (two * least)).size < box.reach.lower, "no flight goes farther than the box")
    require((mechanics.left(state) - box.duration).positive(), "an accumulation is before the ground's piece ends")
    return ended(box, first, second, duration, speeds)


def ended(box: Box, first: Flight, second: Flight, duration: Real, speeds: Real) -> State:
    state, k = box.state, box.k
    angles, rates = list(state.angles), list(state.rates)
    for place, j in enumerate(box.others):
        gain = Real(0, max(first.gain[place], second.gain[place])) * duration
        thrown = Real(0, max(first.thrown[place], second.thrown[place])) * speeds
        changes = gain.size + thrown.size
        require(changes < box.rates[j].lower, "no other rate leaves the box")
        travelled = Real(0, state.rates[j].size + changes) * duration
        require(travelled.size < box.angles[j].lower, "no other angle leaves the box")
        start = state.rates[j] + first.coupling[place] * state.rates[k]
        varies = (Real(0, max(first.variation[place], second.variation[place])) * speeds).size
        end = start + hull(first.drift[place], second.drift[place]) * duration
        rates[j] = end.plus_minus(varies)
        angles[j] = state.angles[j] + hull(start, end).plus_minus(varies) * duration
    angles[k] = rates[k] = ZERO
    pattern = tuple(0 if j == k else old for j, old in enumerate(state.pattern))
    return replace(state, pattern=pattern, angles=angles, rates=rates, zeros=[0] * len(pattern), time=state.time + duration)

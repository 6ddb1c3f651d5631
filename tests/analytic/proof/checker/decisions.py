"""Which pattern follows an impact or an opening at once: the claimed one holds its inequalities, each other violates one."""
from __future__ import annotations

from dataclasses import replace
from itertools import product
from typing import Any

import intervals
from chain import Chain, Directions, Pattern, combine, directions_of, real, solve, summed
from intervals import ZERO, Real, Unproved
from steps import Claim, Mechanics, State, require

Vector = tuple[Real, Real]


def pattern_of(letters: str) -> Pattern:
    sides = {"R": 1, "L": -1, "C": 0}
    require(all(letter in sides for letter in letters), "a pattern has letters R, L and C")
    return tuple(sides[letter] for letter in letters)


def candidates(pattern: Pattern, touching: list[int]) -> set[Pattern]:
    """All patterns in which these interfaces are left, closed or right."""
    return {tuple(choice) for choice in product(*((-1, 0, 1) if k in touching else (side,) for k, side in enumerate(pattern)))}


class Impact:
    """What an impact at unit closing speed makes of velocities in each pattern; places and velocities of blocks are vectors."""

    def __init__(self, mechanics: Mechanics, before: Pattern, hit: int, angles: list[Real], rates: list[Real] | None = None):
        self.mechanics, self.before, self.hit, self.angles = mechanics, before, hit, angles
        self.touching = [k for k, side in enumerate(before) if k == hit or not side]
        if rates is None:
            rates = [ZERO] * len(before)
            rates[hit] = Real(-before[hit] * intervals.one().m, 0)
        chain = mechanics.chain(before)
        omega = [ZERO, *summed([rates[k] for k, side in enumerate(before) if side])]
        moved = motions(chain, self.directions(before))
        self.spins = [omega[group] for group in chain.group_of]
        self.velocities = [dotted(omega, blocks) for blocks in moved]

    def directions(self, pattern: Pattern) -> Directions:
        angles = [self.angles[k] for k, side in enumerate(pattern) if side]
        return directions_of(summed(angles), angles)

    def after(self, pattern: Pattern) -> Outcome:
        return Outcome(self, pattern)


class Outcome:
    def __init__(self, impact: Impact, pattern: Pattern):
        self.impact, self.pattern = impact, pattern
        self.blocks = impact.mechanics.scene.blocks
        self.chain = impact.mechanics.chain(pattern)
        self.directions = impact.directions(pattern)
        moved = motions(self.chain, self.directions)
        groups = range(1, self.chain.groups + 1)
        momenta = [total([real(block.mass) * dot(moved[k][g], impact.velocities[k]) for k, block in enumerate(self.blocks)]
                         + [real(block.inertia) * impact.spins[k] for k, block in enumerate(self.blocks)
                            if self.chain.group_of[k] == g]) for g in groups]
        matrix = [[combine(self.chain.mass_parts(self.directions, g, h)) for h in groups] for g in groups]
        self.omega = [ZERO, *solve(matrix, momenta)]
        self.jumps = [(new[0] - old[0], new[1] - old[1])
                      for new, old in zip((dotted(self.omega, one) for one in moved), impact.velocities, strict=True)]

    def rates(self) -> list[Real]:
        """Of relative angles."""
        groups = self.chain.group_of
        return [self.omega[groups[k]] - (self.omega[groups[k - 1]] if k else ZERO) if side else ZERO
                for k, side in enumerate(self.pattern)]

    def condition(self, name: str, k: int) -> Real:
        """A number that has to be > 0."""
        if name == "opens":
            return Real(self.pattern[k] * self.rates()[k].m, self.rates()[k].r)
        if name == "pushes":
            return dot(self.normal(k), self.impulse(k))
        require(name in ("right", "left"), f"a condition is not {name}")
        return self.moment(k, name == "right")

    def impulse(self, k: int) -> Vector:
        """That the interface transmits, N·s."""
        above = [(real(block.mass), jump) for block, jump in zip(self.blocks[k:], self.jumps[k:], strict=True)]
        return total([mass * x for mass, (x, _) in above]), total([mass * y for mass, (_, y) in above])

    def normal(self, k: int) -> Vector:
        """Across the face of the lower block, or of the upper one where it overhangs."""
        if k == 0:
            return ZERO, intervals.one()
        overhangs = self.blocks[k - 1].width < self.blocks[k].width
        group = self.chain.group_of[k if overhangs else k - 1]
        return self.directions.sine[group], self.directions.cosine[group]

    def moment(self, k: int, right: bool) -> Real:
        """Of the impulses on all above about an end of the interface, positive where pressure is inside."""
        corner = place(self.chain.corners[k][0 if right else 1], self.directions)
        parts = []
        for j in range(k, len(self.blocks)):
            x, y = place(self.chain.centres[j], self.directions)
            jump_x, jump_y = self.jumps[j]
            parts.append(real(self.blocks[j].mass) * ((y - corner[1]) * jump_x - (x - corner[0]) * jump_y))
            parts.append(real(self.blocks[j].inertia) * (self.omega[self.chain.group_of[j]] - self.impact.spins[j]))
        return total(parts) if right else -total(parts)

    def conditions(self, kinematic_alone: bool) -> list[tuple[str, int]]:
        opens = [("opens", k) for k in self.impact.touching if self.pattern[k]]
        if kinematic_alone:
            return opens
        ends = [(name, k) for k, side in enumerate(self.pattern) if not side for name in ("right", "left")]
        return [*opens, *(("pushes", k) for k in range(len(self.pattern))), *ends]


def motions(chain: Chain, directions: Directions) -> list[dict[int, Vector]]:
    """The velocity of each block's centre of mass at unit rate of each group: b eₓ − a e_y."""
    result = []
    for centre in chain.centres:
        moved = {g: (ZERO, ZERO) for g in range(1, chain.groups + 1)}
        for g, (a, b) in centre.items():
            if g:
                sine, cosine = directions.sine[g], directions.cosine[g]
                moved[g] = (real(b) * cosine - real(a) * sine, -(real(b) * sine) - real(a) * cosine)
        result.append(moved)
    return result


def place(where: Any, directions: Directions) -> Vector:
    return (total([real(a) * directions.cosine[g] + real(b) * directions.sine[g] for g, (a, b) in where.items()]),
            total([real(b) * directions.cosine[g] - real(a) * directions.sine[g] for g, (a, b) in where.items()]))


def dotted(omega: list[Real], moved: dict[int, Vector]) -> Vector:
    return total([omega[g] * x for g, (x, _) in moved.items()]), total([omega[g] * y for g, (_, y) in moved.items()])


def dot(a: Vector, b: Vector) -> Real:
    return a[0] * b[0] + a[1] * b[1]


def total(parts: list[Real]) -> Real:
    return Real(sum(part.m for part in parts), sum(part.r for part in parts))


def check_impact(mechanics: Mechanics, before: Pattern, hit: int, angles: list[Real], claim: Claim) -> Outcome:
    """The claimed pattern of an impact at unit speed. Law `consistent` falls back on the paper's order where none holds."""
    impact = Impact(mechanics, before, hit, angles)
    pattern = pattern_of(claim["pattern"])
    tried = [(pattern_of(one["pattern"]), one["violates"], one["interface"] - 1) for one in claim["tried"]]
    require(all(0 <= k < len(before) for _, _, k in tried), "an interface is one of the stack's")
    wanted = set() if mechanics.scene.paper else candidates(before, impact.touching)
    outcome = impact.after(pattern)
    chosen_now = bool(wanted) and len(tried) == len(wanted) - 1
    if wanted:
        first, tried = tried[:len(wanted) - chosen_now], tried[len(wanted) - chosen_now:]
        violate(impact, first, False)
        require({one for one, _, _ in first} == wanted - ({pattern} if chosen_now else set()) and pattern in wanted,
                "every candidate is tried once")
    if not chosen_now:
        order = paper_trials(before, hit, impact.touching)
        violate(impact, tried, True)
        require(len(tried) < 3 and [one for one, _, _ in tried] == order[:len(tried)] and pattern == order[len(tried)],
                "the paper's order is kept")
    if chosen_now or len(tried) < 2:
        hold(outcome, outcome.conditions(not chosen_now))
    return outcome


def paper_trials(before: Pattern, hit: int, touching: list[int]) -> list[Pattern]:
    """Open, joined, closed."""
    def changed(side_of_others: int, side: int) -> Pattern:
        return tuple(side if k == hit else side_of_others if k in touching else old for k, old in enumerate(before))
    other = -before[hit]
    return [changed(other, other), changed(0, other), changed(0, 0)]


def violate(impact: Impact, tried: list[tuple[Pattern, str, int]], kinematic_alone: bool) -> None:
    for pattern, name, k in tried:
        outcome = impact.after(pattern)
        require((name, k) in outcome.conditions(kinematic_alone), "a violated condition is one of the pattern's")
        require(outcome.condition(name, k).negative(), f"pattern {pattern} violates {name} of interface {k + 1}")


def hold(outcome: Outcome, conditions: list[tuple[str, int]]) -> None:
    for name, k in conditions:
        require(outcome.condition(name, k).positive(), f"pattern {outcome.pattern} holds {name} of interface {k + 1}")


def impacted(mechanics: Mechanics, state: State, hit: int, claim: Claim) -> State:
    """Rates after an impact are those of motions without closing, which go on, and closing speed times those at unit speed.

    That is a lemma: the whole impact, found at once, has to give rates that are not others.
    """
    side = state.pattern[hit]
    speed = Real(-side * state.rates[hit].m, state.rates[hit].r)
    require(speed.positive(), "an interface closes at a speed")
    angles, rates = list(state.angles), list(state.rates)
    angles[hit] = ZERO
    outcome = check_impact(mechanics, state.pattern, hit, angles, claim)
    rates[hit] = ZERO
    rates = [rate + speed * unit if new else ZERO
             for rate, unit, new in zip(rates, outcome.rates(), outcome.pattern, strict=True)]
    whole = Impact(mechanics, state.pattern, hit, angles, list(state.rates)).after(outcome.pattern).rates()
    for one, other in zip(rates, whole, strict=True):
        intervals.common(one, other)
    touching = [k == hit or not old for k, old in enumerate(state.pattern)]
    zeros = [1 if new and touches else 0 for new, touches in zip(outcome.pattern, touching, strict=True)]
    return replace(state, pattern=outcome.pattern, angles=angles, rates=rates, zeros=zeros)


def opened_at_once(mechanics: Mechanics, state: State, claim: Claim) -> State:
    """What opens where margins are not positive: the one pattern whose accelerations open it and whose margins hold."""
    closed = [k for k, side in enumerate(state.pattern) if not side]
    pattern = pattern_of(claim["pattern"])
    tried = [(pattern_of(one["pattern"]), one["violates"], one["interface"] - 1) for one in claim["tried"]]
    require({one for one, _, _ in tried} == candidates(state.pattern, closed) - {pattern}
            and pattern in candidates(state.pattern, closed) and pattern != state.pattern, "every candidate is tried once")

    def conditions(candidate: Pattern) -> dict[tuple[str, int], Real]:
        forces = mechanics.forces(state, candidate, [state.angles[k] for k, side in enumerate(candidate) if side],
                                  [state.rates[k] for k, side in enumerate(candidate) if side], mechanics.offset(state))
        relative = dict(zip((k for k, side in enumerate(candidate) if side), forces.relative(), strict=True))
        opens = {("opens", k): Real(candidate[k] * relative[k].m, relative[k].r) for k in closed if candidate[k]}
        return opens | {(name, k): forces.margin(k, side) for k in closed if not candidate[k]
                        for name, side in (("right", 1), ("left", -1))}

    for candidate, name, k in tried:
        found = conditions(candidate)
        if (name, k) not in found or not found[name, k].negative():
            raise Unproved(f"pattern {candidate} violates {name} of interface {k + 1}")
    require(all(value.positive() for value in conditions(pattern).values()), f"pattern {pattern} holds all conditions")
    zeros = [2 if new != old else zero for new, old, zero in zip(pattern, state.pattern, state.zeros, strict=True)]
    return replace(state, pattern=pattern, zeros=zeros)

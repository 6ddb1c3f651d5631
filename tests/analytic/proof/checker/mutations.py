"""Claims that are changed so that they are not true any more."""
from __future__ import annotations

import copy
import random
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

from check import Checker
from intervals import Unproved
from steps import Claim, exact

Choice = random.Random


def text(number: Fraction) -> str:
    """As certificates write it. Precondition: the denominator is a power of two."""
    return f"{number.numerator}*2^{1 - number.denominator.bit_length()}"


def scaled(claim: Claim, key: Any, factor: Fraction) -> None:
    claim[key] = text(exact(claim[key]) * factor)


def move_bracket(claim: Claim, choice: Choice) -> None:
    """By its own width, so that the crossing is not inside of it."""
    lower, upper = (exact(end) for end in claim["event"]["interval"])
    width = (upper - lower) * choice.choice((1, -1))
    claim["event"]["interval"] = [text(lower + width), text(upper + width)]


def turn_event(claim: Claim, choice: Choice) -> None:
    """To a guard that is positive there, or that does not exist."""
    claim["event"]["side"] = -claim["event"]["side"]


def leave_out_event(claim: Claim, choice: Choice) -> None:
    claim["length"] = text(exact(claim.pop("event")["interval"][1]) * Fraction(9, 8))


def widen_radius(claim: Claim, choice: Choice) -> None:
    scaled(claim, "radius", Fraction(2))


def shrink_reach(claim: Claim, choice: Choice) -> None:
    reaches = claim[choice.choice(("angle_reach", "rate_reach"))]
    scaled(reaches, choice.choice([k for k, reach in enumerate(reaches) if exact(reach)]), Fraction(1, 1024))


def exchange_pattern(claim: Claim, choice: Choice) -> None:
    """With another one in which one interface is otherwise; where it was tried, the other one takes its place."""
    before, k = claim["pattern"], choice.randrange(len(claim["pattern"]))
    letter = choice.choice([letter for letter in "RLC" if letter != before[k]])
    claim["pattern"] = before[:k] + letter + before[k + 1:]
    for one in claim["tried"]:
        if one["pattern"] == claim["pattern"]:
            one["pattern"] = before


def forget_trial(claim: Claim, choice: Choice) -> None:
    claim["tried"].pop(choice.randrange(len(claim["tried"])))


def shrink_box(claim: Claim, choice: Choice) -> None:
    scaled(claim, choice.choice(("duration", "speed", "reach")), Fraction(1, 2))


def move_interface(claim: Claim, choice: Choice) -> None:
    claim["interface"] += choice.choice((1, -1))


MUTATIONS: dict[Callable[[Claim, Choice], None], Callable[[Claim], bool]] = {
    move_bracket: lambda claim: "event" in claim,
    turn_event: lambda claim: "event" in claim,
    leave_out_event: lambda claim: "event" in claim,
    widen_radius: lambda claim: claim["kind"] == "step" and moves(claim),
    shrink_reach: lambda claim: claim["kind"] == "step" and moves(claim),
    exchange_pattern: lambda claim: claim["kind"] == "impact",
    forget_trial: lambda claim: bool(claim.get("tried")),
    shrink_box: lambda claim: claim["kind"] == "accumulation",
    move_interface: lambda claim: claim["kind"] in ("impact", "accumulation"),
}


def moves(claim: Claim) -> bool:
    return any(exact(reach) for reach in claim["rate_reach"])


class Replay:
    """A certificate that is accepted, with the state before each claim: what follows from a change is checked from there."""

    def __init__(self, checker: Checker, claims: list[Claim]):
        self.checker, self.claims, self.before = checker, claims, []
        for claim in claims:
            self.before.append((checker.state, checker.hit, checker.over, list(checker.events)))
            checker.check(claim)

    def refusal(self, place: int, claim: Claim) -> str | None:
        """Why a claim in the place of another one, or what follows it, is not shown."""
        self.checker.state, self.checker.hit, self.checker.over, events = self.before[place]
        self.checker.events = list(events)
        try:
            for one in [claim, *self.claims[place + 1:]]:
                self.checker.check(one)
        except Unproved as refused:
            return str(refused)
        return None

    def mutations(self, count: int, seed: int) -> Iterator[tuple[str, int, str | None]]:
        """So many: the name, the claim's place, and why it is refused. Each kind comes as often as the others."""
        choice = random.Random(seed)
        for number in range(count):
            kinds = [kind for kind in MUTATIONS if any(map(MUTATIONS[kind], self.claims))]
            mutate = kinds[number % len(kinds)]
            place = choice.choice([place for place, claim in enumerate(self.claims) if MUTATIONS[mutate](claim)])
            claim = copy.deepcopy(self.claims[place])
            mutate(claim, choice)
            yield mutate.__name__, place, self.refusal(place, claim)

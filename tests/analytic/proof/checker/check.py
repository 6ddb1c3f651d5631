#!/usr/bin/env python3
"""check.py CERTIFICATE [--scene FILE] [--table CSV]: accepts a proof's certificate, or says which claim is not shown.

It searches for nothing and shares nothing with the prover: from the scene's numbers it follows the motion by its own intervals,
and shows every claim on the way: that discs enclose, guards keep their signs, brackets have one crossing, patterns are the only
ones, and boxes of accumulations hold. With a table, also that its bounds hold what is found.
"""
from __future__ import annotations

import argparse
import csv
import json
import sys
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path

import intervals
from accumulations import accumulated
from chain import Pattern, real, summed
from decisions import impacted, opened_at_once
from ground import still
from intervals import ZERO, Real, Unproved
from scene import Scene, read_scene
from steps import SIDES, Claim, Mechanics, State, check_step, require


@dataclass
class Event:
    kind: str
    interface: int
    before: Pattern
    state: State


class Checker:
    """Follows a scene from claim to claim."""

    def __init__(self, scene: Scene, bits: int):
        intervals.set_bits(bits)
        self.mechanics = Mechanics(scene)
        self.state = start(scene)
        self.hit: int | None = None  # an interface that has closed, and whose impact is not claimed yet
        self.over = False
        self.events: list[Event] = []

    def check(self, claim: Claim) -> None:
        """@raises Unproved"""
        kind = claim["kind"]
        require(not self.over, "nothing follows the end")
        require((kind == "impact") == (self.hit is not None), "an impact follows a closing, and nothing else does")
        handlers = {"step": self.step, "impact": self.impact, "opening at once": self.open_at_once,
                    "accumulation": self.accumulate, "end": self.end}
        require(kind in handlers, f"a claim is not of kind {kind}")
        handlers[kind](claim)

    def step(self, claim: Claim) -> None:
        require(self.state.piece < len(self.mechanics.pieces), "a step is before the scene's end")
        before = self.state.pattern
        self.state = check_step(self.mechanics, self.state, claim)
        event = claim.get("event")
        if event is None:
            return
        k = event["interface"] - 1
        if event["kind"] == "impact":
            self.hit = k
            return
        if event["kind"] == "opening":
            self.state = opened(self.state, k, event["side"])
        self.events.append(Event(event["kind"], k, before, self.state))

    def impact(self, claim: Claim) -> None:
        require(claim["interface"] - 1 == self.hit, "the impact is of the interface that has closed")
        before = self.state.pattern
        hit, self.hit = claim["interface"] - 1, None
        self.state = impacted(self.mechanics, self.state, hit, claim)
        self.events.append(Event("impact", hit, before, self.state))

    def open_at_once(self, claim: Claim) -> None:
        before = self.state.pattern
        self.state = opened_at_once(self.mechanics, self.state, claim)
        first = min(k for k, side in enumerate(before) if side != self.state.pattern[k])
        require(claim["interface"] - 1 == first, "an opening is of the lowest interface that opens")
        self.events.append(Event("opening", first, before, self.state))

    def accumulate(self, claim: Claim) -> None:
        before = self.state.pattern
        self.state = accumulated(self.mechanics, self.state, claim)
        kind = "closure" if any(self.state.pattern) else "rest"
        self.events.append(Event(kind, claim["interface"] - 1, before, self.state))

    def end(self, claim: Claim) -> None:
        """Rest for ever, toppling and the scene's end are claims; another end says why the prover went no further."""
        why, pieces = claim["why"], self.mechanics.pieces
        self.over = True
        if why == "the end of the scene":
            require(self.state.piece == len(pieces), "the scene has ended")
        elif why == "a block topples":
            require(bool(self.events) and self.events[-1].kind == "topple", "a block has toppled")
        elif why == "the stack rests for ever":
            require(self.state.piece == len(pieces) - 1 and still(self.mechanics.scene, pieces[-1][0]), "the ground is still")
            require(not any(self.state.pattern), "every interface is closed")
            forces = self.mechanics.forces(self.state, self.state.pattern, [], [], self.mechanics.offset(self.state))
            for k in range(len(self.state.pattern)):
                for side in (1, -1):
                    require(forces.margin(k, side).positive(), f"interface {k + 1} stays closed")


def opened(state: State, k: int, side: int) -> State:
    """A margin that falls strictly through zero leaves angle, rate and acceleration exactly zero."""
    pattern = tuple(side if j == k else old for j, old in enumerate(state.pattern))
    return replace(state, pattern=pattern, zeros=[3 if j == k else 0 for j in range(len(pattern))])


def start(scene: Scene) -> State:
    """Of a scene's absolute angles and rates."""
    angles = [own - below for own, below in zip(scene.angles, [Fraction(0), *scene.angles], strict=False)]
    rates = [own - below for own, below in zip(scene.velocities, [Fraction(0), *scene.velocities], strict=False)]
    pattern = tuple(sign(angle) or sign(rate) for angle, rate in zip(angles, rates, strict=True))
    zeros = [1 if side and not angle else 0 for side, angle in zip(pattern, angles, strict=True)]
    return State(pattern, [real(angle) for angle in angles], [real(rate) for rate in rates], zeros, ZERO)


def sign(number: Fraction) -> int:
    return (number > 0) - (number < 0)


def check_table(events: list[Event], file: Path) -> None:
    """Each row's bounds hold the event that is found; impacts are left out of a table in the last microsecond of chatter."""
    with open(file, newline="") as lines:
        rows = list(csv.reader(lines))[1:]
    rest = iter(events)
    for row in rows:
        event = next(rest, None)
        while event is not None and row[0] in ("closure", "rest") and event.kind == "impact":
            late = within(event.state.time, Fraction(row[4]) - Fraction(1, 10**6), Fraction(row[5]))
            require(late, "what a table leaves out is chatter of its last microsecond")
            event = next(rest, None)
        require(event is not None, "a table has no more events than are proved")
        found = [event.kind, str(event.interface + 1), letters(event.before), letters(event.state.pattern)]
        require(row[:4] == found, f"the event {found} is the table's {row[:4]}")
        for place, value in enumerate([event.state.time, *absolute(event.state)]):
            lower, upper = row[4 + 2 * place:6 + 2 * place]
            require(within(value, Fraction(lower), Fraction(upper)), f"bounds hold number {place} of {row[:5]}")
    require(next(rest, None) is None, "a table has all events that are proved")


def letters(pattern: Pattern) -> str:
    return "".join(SIDES[side] for side in pattern)


def absolute(state: State) -> list[Real]:
    return summed([angle if side else ZERO for side, angle in zip(state.pattern, state.angles, strict=True)])


def within(number: Real, lower: Fraction, upper: Fraction) -> bool:
    scale = 1 << intervals.BITS
    return lower * scale <= number.lower and number.upper <= upper * scale


def bits_for(certificate: Claim) -> int:
    """So many more than the prover's that its own intervals are well inside of the claimed ones."""
    return certificate["bits"] * 5 // 4 + 128


def accept(certificate: Claim, scene: Scene) -> Checker:
    """Checks all claims. @raises Unproved with the claim's number"""
    checker = Checker(scene, bits_for(certificate))
    for number, claim in enumerate(certificate["inferences"], 1):
        try:
            checker.check(claim)
        except (Unproved, LookupError, ValueError, TypeError, ArithmeticError) as refused:
            raise Unproved(f"claim {number}, {claim.get('kind')}: it is not shown that {refused}") from refused
    require(checker.over, "a certificate says how it ends")
    return checker


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("certificate", type=Path)
    parser.add_argument("--scene", type=Path, help="the scene's file; left out: the one that the certificate names")
    parser.add_argument("--table", type=Path, help="a proved table, whose bounds are checked too")
    arguments = parser.parse_args()
    certificate = json.loads(arguments.certificate.read_text())
    try:
        scene = read_scene(arguments.scene or Path(certificate["scene"]), certificate["duration"])
        checker = accept(certificate, scene)
        if arguments.table:
            check_table(checker.events, arguments.table)
    except Unproved as refused:
        print(f"refused: {refused}")
        return 1
    print(f"accepted: {len(certificate['inferences'])} claims, {len(checker.events)} events")
    return 0


if __name__ == "__main__":
    sys.exit(main())

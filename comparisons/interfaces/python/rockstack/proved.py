"""Events whose times are certain."""
from __future__ import annotations

import csv
import math
from fractions import Fraction

import numpy as np

from rockstack import _core
from rockstack.arguments import checked
from rockstack.keys import shipped
from rockstack.tables import Table


class Proved(Table):
    """Events of a scene, each with intervals that hold its time and angles with mathematical certainty.

    kind: "opening", "impact", "closure", "rest" or "topple", (events,). interface: from 1 at the ground, (events,). from, to:
    patterns before and after, a letter an interface, R open on its right end, L on its left, C closed, (events,). time:
    lower and upper bound, s, (events, 2). angles: those of absolute angles after it, rad, clockwise positive, (events, blocks, 2).
    Doubles are rounded outwards, so that they too hold what is proved. time_text, angles_text: the bounds as they are
    proved, decimal texts with 30 places, of the same shapes; `fractions.Fraction` reads them exactly.
    """


@checked
def proved(name: str) -> Proved:
    """The proved events of a scene, by its name: `rockstack.shipped("proved")` has all. Raises InputError for other names.

    Source: interval arithmetic on the scene's decimal numbers, laws `paper` and `consistent`; tests/analytic/proof has method,
    lemmas and a checker. Impacts of the last microsecond before a closure or rest are left out.
    """
    names = shipped("proved")
    if name not in names:
        raise _core.InputError(f"name = {name}: must be {' or '.join(names)}")
    with open(_core.shipped("canon/proved") / f"{name}.csv", newline="") as file:
        rows = list(csv.reader(file))[1:]
    bounds = np.array([row[4:] for row in rows]).reshape(len(rows), -1, 2)
    doubles = np.array([[_outward(*pair) for pair in row] for row in bounds.tolist()])
    texts = {key: np.array([row[place] for row in rows]) for place, key in ((0, "kind"), (2, "from"), (3, "to"))}
    return Proved({"kind": texts["kind"], "interface": np.array([int(row[1]) for row in rows]), "from": texts["from"],
                   "to": texts["to"], "time": doubles[:, 0], "angles": doubles[:, 1:],
                   "time_text": bounds[:, 0], "angles_text": bounds[:, 1:]})


def _outward(lower: str, upper: str) -> tuple[float, float]:
    """The nearest doubles that are not above the lower text and not below the upper one."""
    low, high = float(lower), float(upper)
    return (math.nextafter(low, -math.inf) if Fraction(low) > Fraction(lower) else low,
            math.nextafter(high, math.inf) if Fraction(high) < Fraction(upper) else high)

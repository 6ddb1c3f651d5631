"""What engines tell of the forces in their contacts."""
import csv
from pathlib import Path

RESULTS = Path(__file__).resolve().parents[2] / "build/results/forces/checks.csv"

CHECKS = {"RestingBlockPressesWithItsWeight": "at rest", "BlockOnASlopePressesByItsTilt": "on 20°",
          "SlidingBlockRubsByItsFriction": "sliding", "PivotBearsATurningBlock": "turning", "ForcesAreWhatMovesTheBlocks": "rocking"}


def forces():
    """mean force of one block's interface less the closed form, % of the weight, at 1 ms; rocking: largest difference of two blocks' forces in a step
    from the momentum that they gain, % of weight and force; by `rockstack check-engine --check NAME --out build/results/forces` with its last five checks"""
    rows = {}
    told = set()
    with open(RESULTS, newline="") as file:
        for row in csv.DictReader(file):
            key = (row["engine"], row["settings"])
            if "tells no forces" not in row["what"]:
                told.add(key)
            rows.setdefault(key, {})[row["check"]] = row["value"]
    yield ("solver", "set", *CHECKS.values())
    for key, values in rows.items():
        if key in told:
            yield (*key, *(percent(values[check]) for check in CHECKS))


def percent(value):
    number = float(value) if value else float("nan")
    return f"{100 * number:.2g}" if number < float("inf") else "topples"

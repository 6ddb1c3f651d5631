"""What `rockstack canon` says of all engines, in one table of its results."""
import csv
from pathlib import Path

RESULTS = Path(__file__).resolve().parents[2] / "build/results/canon/canon.csv"


def canon():
    """in how many of sixteen scenes a solver follows the law, by the verdicts of `rockstack canon --out build/results/canon`"""
    verdicts = {}
    with open(RESULTS, newline="") as file:
        for row in csv.DictReader(file):
            solver = verdicts.setdefault(f"{row['engine']}:{row['solver']}", {"default": {}, "tuned": {}})
            solver[row["settings"]][row["scene"]] = row["verdict"]
    yield ("solver", "follows by default", "follows tuned", "cannot tell tuned", "scatters tuned", "another law tuned in")
    for solver, sets in verdicts.items():
        tuned = list(sets["tuned"].values())
        yield (solver, *(sum(verdict in ("agrees", "converges") for verdict in sets[name].values()) for name in ("default", "tuned")),
               tuned.count("cannot tell"), tuned.count("scatters"), "; ".join(scene for scene, verdict in sets["tuned"].items() if verdict == "another law"))

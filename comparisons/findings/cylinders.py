"""Round columns: what `rockstack round` says of thresholds, and engines beside it."""
import json
import subprocess
import tempfile
from pathlib import Path

PROGRAM = Path(__file__).resolve().parents[2] / "build/rockstack"


def answer(column, *words, **changes):
    """round.json of a cylinder with some keys changed."""
    settings = [part for key, value in changes.items() for part in ("--set", f"{key.replace('__', '.')}={value}")]
    with tempfile.TemporaryDirectory() as folder:
        command = [PROGRAM, "round", column, *settings, *words, "--json", "--out", Path(folder) / "results"]
        return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def thresholds():
    """least pulse in g that topples a round column, one sine of that period, held in a plane and in space with a share of it sideways, a fifth of the period later; rolling without slip or loss; 8 s. Both derivations give eight digits of those at 1e-2."""
    yield "r × 2h (m)", "period (s)", "plane", "share 1e-6", "1e-2", "0.3", "unsafe by"
    for radius, height in ((0.25, 2.0), (0.25, 1.0), (0.5, 4.0)):
        slope = 2 * radius / height
        for period in (0.5, 0.8, 1.2):
            def least(share, equations="angles"):
                return answer("pulse", "--threshold", f"ground.scale={1.04 * slope}:{8 * slope}", "--values", "28", duration=8, radius=radius, height=height, equations=equations,
                              ground__x__period=period, ground__y__period=period, ground__y__start=period / 5, ground__y__amplitude=share * 9.81)

            found = [least(share) for share in (1e-6, 1e-2, 0.3)]
            spaces = [one["space"] for one in found]
            plane = found[0]["plane"]
            if abs(least(1e-2, "axis")["space"] - spaces[1]) > 1e-8:
                raise ValueError(f"derivations differ: {radius} m, {period} s")
            yield (f"{radius} × {height:g}", period, f"{plane:.5f}", *(f"{space:.5f}" for space in spaces), f"{1 - min(spaces) / plane:.0%}")

"""What npm's engines converge to: for each a table of the same small scenes, with its defaults and tuned."""
import csv
import re
from pathlib import Path
from statistics import median

import numpy as np

import rockstack
from friction import landing, left
from replicates import measured, number, solvers

STEPS = (1e-3, 3e-4, 1e-4)  # s
SQUAT = [{"width": 2.0, "height": 1.0, "density": 2500.0}]


def flat(duration, **more):
    """A flat block on the ground under Coulomb's law, μ = 0.4."""
    return rockstack.Scene(duration=duration, law="unilateral", blocks=SQUAT, contact={"friction": 0.4}, **more)


def released():
    """A block of slenderness 0.197 that is released at half of that and meets the ground after 0.49 s."""
    return rockstack.Scene(duration=0.7, blocks=[{"width": 0.4, "height": 2.0, "density": 2500.0}], initial={"angles": [0.0987]})


def landing_time(motion):
    """When the block passes zero, s; inf where it has not by the end."""
    angles = motion.angles[:, 0]
    after = int(np.argmax(angles < 0))
    if not after:
        return np.inf
    share = angles[after - 1] / (angles[after - 1] - angles[after])
    return motion.times[after - 1] + share * (motion.times[after] - motion.times[after - 1])


def lateness(motion, _step):
    exact = rockstack.solve(motion.scene, times=np.arange(0, 0.7, 1e-4))
    return 1e3 * (landing_time(motion) - landing_time(exact))


def rise(motion, _step):
    """How far a block rises again at most once it falls, mm."""
    gap = motion.gaps[:, 0]
    falling = gap[int(np.argmax(gap)):]
    return 1e3 * (falling - np.minimum.accumulate(falling)).max()


def falling():
    """The ground falls away for 0.1 s at 2 m/s² more than gravity, and comes back."""
    return flat(0.6, ground={"vertical": {"pulse": "rectangle", "amplitude": -11.81, "period": 0.2}})


# What is measured, its exact value, the scene (of the step, s), and the number.
QUANTITIES = (
    ("angular velocity after an impact at μ = 0.3; before it 1 (rad/s)", "0.613", lambda dt: landing(0.3, duration=60 * dt), left),
    ("angle after 0.2 s of sliding and rocking (mrad)", "28.4",
     lambda _: rockstack.Scene.read("canon/slide-rock").replace({"duration": 0.2}), lambda motion, _: -1e3 * motion.angles[-1, 0]),
    ("distance that a block slides from 0.5 m/s at μ = 0.4 (mm)", "31.9", lambda _: flat(0.3, initial={"angles": [0.0], "slip_velocities": [0.5]}),
     lambda motion, _: 1e3 * motion.slips[-1, 0]),
    ("lateness of a rocking block at its landing; below 0 it is early (ms)", "0", lambda _: released(), lateness),
    ("rise after a flat landing without restitution (mm)", "0", lambda _: falling(), rise),
    ("creep in 1 s on a slope that holds (mm)", "0",
     lambda _: rockstack.Scene.read("canon/held-on-slope").replace({"duration": 1.0}), lambda motion, _: 1e3 * abs(motion.slips[-1, 0])),
    ("largest overlap of a column at rest for 0.3 s (mm)", "0",
     lambda _: rockstack.Scene.read("canon/rest").replace({"duration": 0.3}), lambda motion, _: 1e3 * max(0.0, -motion.gaps.min())),
)

HEADINGS = ("ω after an impact (rad/s)", "angle of sliding and rocking (mrad)", "slide (mm)", "lateness (ms)", "rise (mm)", "creep (mm/s)", "overlap (mm)")


def table(name, solver=""):
    """The generator of the table of an engine, or of one of its solvers."""
    def converges():
        names = [one for one in solvers(name) if one.endswith(solver)]
        several = len(names) > 1
        yield "what", "exact", *["solver"] * several, "set", *(f"step {1e3 * dt:g} ms" for dt in STEPS)
        for what, exact, scene, measure in QUANTITIES:
            for one in names:
                for settings in ("default", "tuned"):
                    yield what, exact, *[one.split(":")[1]] * several, settings, *(
                        number(median(measured(scene(dt), one, dt, measure, settings=settings))) for dt in STEPS)

    converges.__doc__ = f"what {name}{solver} makes of scenes that no set is tuned on; medians of 5 replicates."
    return converges


FOLDER = Path(__file__).resolve().parents[2] / "engines" / "web"
# Of three solvers that give nearly the same, one.
SOLVERS = {"mujoco-js": ":newton"}
TABLES = {name: table(name, SOLVERS.get(name, "")) for name in
          sorted(worker.parent.name for worker in FOLDER.glob("*/worker.mjs"))}
FILES = {name: FOLDER / name / "findings.csv" for name in TABLES} | {name: FOLDER / f"{name}.csv" for name in ("limits", "packages")}


def limits():
    """what engines of npm make of scenes that no set is tuned on, at a step of 0.1 ms; each engine's file has three steps."""
    yield "engine", "set", *HEADINGS
    yield "exact", "", *(exact for _, exact, *_ in QUANTITIES)
    for name in TABLES:
        with open(FILES[name]) as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        for one in dict.fromkeys((row.get("solver", ""), row["set"]) for row in rows):
            own = [row for row in rows if (row.get("solver", ""), row["set"]) == one]
            yield " ".join(filter(None, (name, one[0]))), one[1], *(row["step 0.1 ms"] for row in own)


def listed_checks(engine, solver, settings):
    """How many checks of check-engine limits.txt lists for a set of an engine's solver."""
    checks = set()
    for file in (FOLDER.parent / "conformance" / "limits.txt", *FOLDER.glob("*/limits.txt")):
        for paragraph in file.read_text().split("\n\n"):
            lines = [line for line in paragraph.splitlines() if line and not line.startswith("#")]
            if not lines:
                continue
            names = [part.split() for part in lines[0].split("|")]
            if all("*" in known or one in known for one, known in zip((engine, solver, settings), names)):
                checks |= set(" ".join(lines[2:]).split())
    return len(checks)


def packages():
    """packages of npm's engines as they tell of themselves, and how many checks limits.txt lists for each set."""
    yield "engine", "package", "precision", "licence", "listed checks by default", "listed checks tuned"
    for one in sorted((one for one in rockstack.engines() if one["name"] in TABLES), key=lambda one: one["name"]):
        name, solver = one["name"], one["solver"]
        module = re.search("module: '(.*)'", (FOLDER / name / "worker.mjs").read_text()).group(1)
        version, _, more = one["version"].partition(" of npm, ")
        inside = [part for part in more.split(", ") if part[-1].isdigit()]
        title = " ".join([f"[`{name}`]({name}/page.md)", *[solver] * (len(solvers(name)) > 1)])
        package = " ".join([module, version, *(f"({part})" for part in inside)])
        yield (title, package, more.split(", ")[-1].removesuffix(" precision"), one["licence"].replace(",", ";"),
               *(listed_checks(name, solver, settings) for settings in ("default", "tuned")))

"""When blocks land in engines."""
import numpy as np

import rockstack
from replicates import measured, middle, number, solvers

SLENDER = {"width": 0.5, "height": 2.5, "density": 2500.0}


def one_block(duration):
    return rockstack.Scene(duration=duration, blocks=[SLENDER], initial={"angles": [0.1]})


def paper(duration):
    return rockstack.Scene.read("spanos-free-rocking").replace({"duration": duration, "law": "consistent"})


def landing_time(scene):
    events = rockstack.solve(scene, interval=None).events
    return events["time"][(events["kind"] == "impact") & (events["interface"] == 1)][0]


def lead(motion, step):
    """By how many steps the lowest block comes upright after the exact one; between two samples by a straight line."""
    angle = motion.angles[:, 0]
    after = int(np.argmax(angle <= 0))
    if after == 0:
        return np.nan
    time = motion.times[after - 1] + step * angle[after - 1] / (angle[after - 1] - angle[after])
    return (time - landing_time(motion.scene)) / step


def started_back():
    """when the block first lands, in steps, engine less exact, at rest and with a start at ω = −α dt/2 and at +α dt/2, where α is the first angular acceleration; one block of 0.5 m × 2.5 m from 0.1 rad, tuned sets; medians of 5 replicates."""
    yield "solver", "start", "10 ms", "1 ms", "0.1 ms"
    scene = one_block(0.9)
    scene = scene.replace({"duration": landing_time(scene) + 0.04})
    moment = 1e-5  # s: the first acceleration hardly changes within it
    acceleration = rockstack.solve(scene, times=[moment]).velocities[0, 0] / moment
    for solver in ("ode:step", "bullet:sequential-impulse", "dart:pgs"):
        for name, share in (("at rest", 0.0), ("half a step back", -0.5), ("half a step ahead", 0.5)):
            yield solver, name, *(
                middle(scene.replace({"initial.velocities": [share * dt * acceleration]}), solver, dt,
                       lambda motion, step: lead(rest_of(motion, scene), step), digits=2) for dt in (1e-2, 1e-3, 1e-4))


class rest_of:
    """A motion beside the exact one of another scene."""

    def __init__(self, motion, scene):
        self.times, self.angles, self.scene = motion.times, motion.angles, scene


DROPPED = {"width": 1.0, "height": 0.5, "density": 2500.0}
SLIDES_BACK = (0.4, 0.5, -2.0)


def dropped(angle, friction, along=0.0, height=0.2, thrown=0.0, restitution=0.8):
    """A block that falls by `height`, m, and moves along the ground and down, m/s."""
    landing = (np.sqrt(thrown**2 + 2 * 9.81 * height) - thrown) / 9.81
    return rockstack.Scene(duration=landing + 0.09, law="unilateral", blocks=[DROPPED], contact={"friction": friction, "restitution": restitution},
                           initial={"angles": [angle], "gaps": [height], "slip_velocities": [along], "gap_velocities": [-thrown]})


def kept(motion, step):
    """What the lowest corner keeps of its speed across the ground, from the block's rates a step before it lands and three steps
    after it first rises, each with the fall between; 0 where it does not about when it lands."""
    times, y, angle = motion.times, motion.places[:, 0, 1], motion.angles[:, 0]
    side = np.sign(angle[0]) or 1.0
    height = y - DROPPED["height"] / 2 * np.cos(angle) - side * DROPPED["width"] / 2 * np.sin(angle)
    landing = times[-1] - 0.09
    middle_of_step = times[:-1] + step / 2
    about = abs(middle_of_step - landing) < max(min(0.02, landing / 2), 4 * step)
    rising = np.flatnonzero((np.diff(height) > 1e-3 * step) & about)
    if len(rising) == 0:
        return 0.0
    first = rising[0]
    lever = DROPPED["height"] / 2 * np.sin(angle[first]) - side * DROPPED["width"] / 2 * np.cos(angle[first])

    def speed(at):
        return (np.diff(y)[at] + lever * np.diff(angle)[at]) / step + 9.81 * (middle_of_step[at] - times[first])

    before = np.flatnonzero(middle_of_step < min(landing, times[first]) - step)[-1]
    return -speed(first + 3) / speed(before)


def row(values):
    values = sorted(values)
    if np.isnan(values).any():
        return "no run"
    return number(values[0]) if len(values) == 1 else f"{number(values[2])} ({number(values[0])} to {number(values[4])})"


def newton():
    """what a point keeps of its speed across the ground at a coefficient of restitution of 0.8, exactly and in engines that have one: one block of 1 m × 0.5 m that falls by 0.2 m on a corner without friction, with a friction of 0.5, and with that at −2 m/s along the ground, where Poisson's law has 0.423; tuned sets, 0.1 ms; median, and least to largest, of 5 replicates."""
    yield "solver", "corner", "friction", "slides back"
    scenes = [dropped(*one) for one in ((0.4, 0.0), (0.4, 0.5), SLIDES_BACK)]
    yield "exact", *(row([kept(at_steps(scene, 1e-4), 1e-4)]) for scene in scenes)
    for solver in solvers():
        cells = [row(measured(scene, solver, 1e-4, kept)) for scene in scenes]
        if set(cells) != {"no run"}:
            yield solver, *cells


def landed(motion, step):
    """What the centre, the slower and the faster corner have of the speed of a landing that is flat or all but flat, across the ground,
    three steps after the centre first rises, each with the fall between."""
    times, y, angle = motion.times, motion.places[:, 0, 1], motion.angles[:, 0]
    landing = times[-1] - 0.09
    first = np.flatnonzero((np.diff(y) > 1e-3 * step) & (abs(times[:-1] - landing) < 0.02))
    at = first[0] + 3 if len(first) else int((landing + 0.01) / step)
    down = 9.81 * landing
    since = 0.0 if not len(first) else 3 * step
    centre = ((y[at + 1] - y[at]) / step + 9.81 * since) / down
    turn = DROPPED["width"] / 2 * abs(angle[at + 1] - angle[at]) / step / down
    return np.array([centre, centre - turn, centre + turn])


TILTS = {"flat": 0.0, "tilted": 1e-9}


def flat_landing():
    """what centre and corners keep of the speed of a landing: one block of 1 m × 0.5 m, e = 0.8, μ = 0.5, falls by 0.2 m, flat or tilted by 1e-9 rad; branch: of 5 replicates, within a tenth of what the exact ones are apart; last, the centre from 1e-3 rad; tuned sets, 0.1 ms; medians."""
    step = 1e-4
    yield "solver", "centre", "slower corner", "faster corner", "branch", "centre from 1e-3 rad"
    apart = dropped(1e-3, 0.5)
    branches = {name: landed(at_steps(dropped(tilt, 0.5), step), step) for name, tilt in TILTS.items()}
    for name, values in branches.items():
        yield f"exact: {name}", *map(number, values), name, number(landed(at_steps(apart, step), step)[0])
    near = 0.1 * np.linalg.norm(branches["flat"][1:] - branches["tilted"][1:])

    def branch(values):
        return next((name for name, exact in branches.items() if np.linalg.norm((values - exact)[1:]) < near), "neither")

    for solver in solvers():
        runs = np.array([np.broadcast_to(one, 3) for one in measured(dropped(0.0, 0.5), solver, step, landed)])
        if np.isnan(runs).any():
            continue
        found = [branch(one) for one in runs]
        told = " ".join(f"{name} {found.count(name)}" for name in (*branches, "neither") if name in found)
        yield solver, *map(number, np.median(runs, axis=0)), told, number(
            np.median([np.broadcast_to(one, 3)[0] for one in measured(apart, solver, step, landed)]))


def at_steps(scene, step):
    return rockstack.solve(scene, times=np.append(np.arange(0, scene.duration - step / 2, step), scene.duration))


def bounce_law():
    """what a corner keeps of its speed across the ground where friction ends its slide within the impact: one block of 1 m × 0.5 m that falls by 0.2 m, −2 m/s along the ground, e = 0.8; exactly by Newton's and Poisson's law, and in engines; median, and least to largest, of 5 replicates."""
    steps = (1e-2, 1e-3, 1e-4)
    yield "solver", "set", "10 ms", "1 ms", "0.1 ms"
    scene = dropped(*SLIDES_BACK)
    for law in ("newton", "poisson"):
        exact = scene.replace({"contact.restitution_law": law})
        yield "exact", law, *(row([kept(at_steps(exact, step), step)]) for step in steps)
    for solver in solvers():
        for settings in ("default", "tuned"):
            cells = [row(measured(scene, solver, step, kept, settings=settings)) for step in steps]
            if set(cells) != {"no run"}:
                yield solver, settings, *cells


# What a solver calls its coefficient and the speed below which nothing bounces, the latter's default where it has one, and
# its unit in the tuned set, both m/s.
THRESHOLDS = {"bullet:sequential-impulse": ("restitution", "restitutionVelocityThreshold", 0.2, 1.0), "ode:step": ("bounce", "bounce_vel", 0.2, 1.0),
              "box2d:sequential-impulse": ("restitution", "restitutionThreshold", 1.0, 0.02), "planck:sequential-impulse": ("restitution", "velocityThreshold", 1.0, 0.02),
              "jolt:sequential-impulse": ("restitution", "mMinVelocityForRestitution", 1.0, 1.0), "physx:pgs": ("restitution", "bounceThresholdVelocity", 2.0, 1.0)}


def bounce_threshold():
    """what a block keeps that lands flat at half and at twice a threshold, at a coefficient of restitution of 0.8; with the engine's own threshold, of ODE, which has none by default, with one of 0.2 m/s, and, nothing else changed, with one of 1e-6 m/s; tuned sets; median, and least to largest, of 5 replicates."""
    yield "solver", "threshold (m/s)", "lands at (m/s)", "1 ms", "0.3 ms", "0.1 ms"
    for solver, (coefficient, threshold, own, unit) in THRESHOLDS.items():
        for value in (own, 1e-6):
            for speed in (own / 2, 2 * own):
                fall = speed**2 / 4 / 9.81  # half of the energy; the throw has the other
                scene = dropped(0.0, 0.5, 0.0, fall, speed / np.sqrt(2), 0.0)
                yield solver, number(value), number(speed), *(
                    row(measured(scene, solver, step, kept, settings="tuned", parameters={coefficient: 0.8, threshold: value / unit}))
                    for step in (1e-3, 3e-4, 1e-4))

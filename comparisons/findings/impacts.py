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


def dropped(angle, friction, along=0.0):
    """A block that falls by 0.2 m and moves along the ground, m/s."""
    return rockstack.Scene(duration=0.25, law="unilateral", blocks=[DROPPED], contact={"friction": friction, "restitution": 0.8},
                           initial={"angles": [angle], "gaps": [0.2], "slip_velocities": [along]})


def kept(motion, step):
    """What the lowest corner keeps of its speed across the ground: of the fall's last step before it lands, on the third to fifth
    step after it first rises; nan where it does not within 20 ms."""
    y, angle = motion.places[:, 0, 1], motion.angles[:, 0]
    side = np.sign(angle[0]) or 1.0
    height = y - DROPPED["height"] / 2 * np.cos(angle) - side * DROPPED["width"] / 2 * np.sin(angle)
    landing = np.sqrt(2 * 0.2 / 9.81)
    speed, middle_of_step = np.diff(height) / step, motion.times[:-1] + step / 2
    before = np.flatnonzero(middle_of_step < landing - step)[-1]
    rising = np.flatnonzero((speed > 0) & (middle_of_step > landing - step) & (middle_of_step < landing + 0.02))
    if len(rising) == 0:
        return np.nan
    return -speed[rising[0] + 3] / speed[before]


def row(values):
    values = sorted(values)
    if np.isnan(values).any():
        return "no run"
    return number(values[0]) if len(values) == 1 else f"{number(values[2])} ({number(values[0])} to {number(values[4])})"


def newton():
    """what a point keeps of its speed across the ground at a coefficient of restitution of 0.8, exactly and in engines that have one: one block of 1 m × 0.5 m that falls by 0.2 m, flat, on a corner without friction, with a friction of 0.5, and with that at −2 m/s along the ground, where Poisson's law has 0.438; tuned sets, 0.1 ms; median, and least to largest, of 5 replicates."""
    yield "solver", "flat", "corner", "friction", "slides back"
    scenes = [dropped(angle, friction, along) for angle, friction, along in ((0.0, 0.5, 0.0), (0.4, 0.0, 0.0), (0.4, 0.5, 0.0), (0.4, 0.5, -2.0))]
    times = np.arange(0, 0.25, 1e-4)
    yield "exact", *(row([kept(rockstack.solve(scene, times=times), 1e-4)]) for scene in scenes)
    for solver in solvers():
        cells = [row(measured(scene, solver, 1e-4, kept)) for scene in scenes]
        if set(cells) != {"no run"}:
            yield solver, *cells

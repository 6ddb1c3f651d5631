"""When blocks land in engines."""
import numpy as np

import rockstack
from replicates import middle

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

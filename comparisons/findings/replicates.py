"""Replicates: runs of an engine at nearby steps of nearly the same scene."""
from concurrent.futures import ThreadPoolExecutor
from statistics import median

import numpy as np

import rockstack

WIDTH = 0.03  # steps are spread by as much, either way


def replicates(scene, dt, count=5):
    """Scenes whose angles and slips differ in the sixth digit, each with its step, s. Blocks that fly differ by amounts, since a factor
    leaves a flat landing flat."""
    for number in range(count):
        share = 2 * number / (count - 1) - 1
        start = scene.to_dict().get("initial", {})
        changed = {f"initial.{key}": [value * (1 + 1e-6 * share) for value in start[key]]
                   for key in ("angles", "slip_velocities") if key in start}
        if any(start.get("gaps", ())):
            changed["initial.angles"] = [angle + 1e-6 * share for angle in changed["initial.angles"]]
        yield scene.replace(changed) if changed else scene, dt * (1 + WIDTH * share)


def measured(scene, engine, dt, measure, count=5, **options):
    """measure(motion, step) of each replicate, nan where a run is not done. options are those of simulate()."""
    def run(one):
        try:
            return measure(rockstack.simulate(one[0], engine, one[1], **options), one[1])
        except rockstack.EngineError:
            return np.nan

    with ThreadPoolExecutor(2) as pool:
        return list(pool.map(run, replicates(scene, dt, count)))


def middle(*arguments, digits=3, factor=1, **options):
    """The median of measured(), as a text with so many significant digits."""
    return number(factor * median(measured(*arguments, **options)), digits)


def number(value, digits=3):
    if np.isnan(value):
        return "no run"
    text = f"{value:.{digits}g}"
    return f"{value:.0f}" if "e+" in text else text


def rates(motion, step):
    """Of the lowest block's centre between samples, m/s: shape (steps, 2). In semi-implicit Euler those at the end of each step."""
    return np.diff(motion.places[:, 0], axis=0) / step


def solvers(*engines):
    """The names of all solvers of these engines; without arguments of every engine in double precision ."""
    return [f"{one['name']}:{one['solver']}" for one in rockstack.engines()
            if one["name"] in engines or (not engines and one["name"] != "bullet-single")]


def largest_error(motion, _step):
    """The largest difference of any angle from the exact motion, rad; π where a block has toppled."""
    if motion.times[-1] < motion.scene.duration - 0.02:
        return np.pi
    return np.abs(motion.angles - rockstack.solve(motion.scene, times=motion.times).angles).max()

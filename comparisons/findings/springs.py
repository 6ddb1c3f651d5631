"""What soft contacts do in engines."""
import numpy as np

import rockstack
from impacts import landing_time, one_block, paper
from replicates import largest_error, middle, number, replicates


def fixed_springs():
    """largest angle between a step and a quarter of it in mrad, one slender block, 1.5 s; medians of 5 replicates. k = 2e6 N/m and c = 8e3 N s/m a
    point, or erp = 0.2 and cfm = 1e-4, which are the same at 1 ms."""
    yield "solver", "set", "contact", "4 to 1 ms", "1 to 0.25 ms", "0.25 to 0.0625 ms"
    contacts = {"fixed k and c": {"contactStiffness": 2e6, "contactDamping": 8e3}, "fixed erp and cfm": {"erp": 0.2, "cfm": 1e-4}}
    for settings in ("default", "tuned"):
        for name, contact in contacts.items():
            yield "ode:step", settings, name, *(number(1e3 * between(dt, {**contact, "unitMass": 0.0}, settings), 2)
                                                for dt in (4e-3, 1e-3, 2.5e-4))


def between(dt, parameters, settings):
    """The median over replicates of the largest angle between steps of dt and dt/4, rad."""
    gaps = []
    for scene, step in replicates(one_block(1.5), dt):
        coarse, fine = (rockstack.simulate(scene, "ode:step", one, settings=settings, parameters=parameters)
                        for one in (step, step / 4))
        gaps.append(np.abs(np.interp(fine.times, coarse.times, coarse.angles[:, 0]) - fine.angles[:, 0]).max())
    return float(np.median(gaps))


def restitution():
    """largest angle in mrad between a coefficient of restitution of one half and none, 2 s, of one block from an angle, and of the paper's two; medians of 5 replicates."""
    yield "solver", "set", "blocks", "2 ms", "1 ms", "0.5 ms"
    starts = ((0.3, 3.0, 0.03), (0.5, 2.5, 0.05), (0.5, 2.5, 0.1), (1.0, 3.0, 0.16), (1.0, 2.0, 0.23), (1.25, 1.25, 0.3))
    scenes = {f"{width:g} m × {height:g} m from {angle:g} rad": rockstack.Scene(
        duration=2.0, blocks=[{"width": width, "height": height, "density": 2500.0}], initial={"angles": [angle]}) for width, height, angle in starts}
    scenes["two blocks"] = paper(2.0)
    for solver, keys in (("ode:step", {"bounce": 0.5}),
                         ("bullet:sequential-impulse", {"restitution": 0.5, "restitutionVelocityThreshold": 0.0})):
        for settings in ("default", "tuned"):
            for name, scene in scenes.items():
                row = []
                for dt in (2e-3, 1e-3, 5e-4):
                    gaps = []
                    for one, step in replicates(scene, dt):
                        without, half = (rockstack.simulate(one, solver, step, settings=settings, parameters=parameters).angles
                                         for parameters in ({}, keys))
                        length = min(len(without), len(half))
                        gaps.append(np.abs(without[:length] - half[:length]).max())
                    row.append(number(1e3 * float(np.median(gaps)), 2))
                yield solver, settings, name, *row


def point_springs():
    """largest angle from the exact motion on rigid contacts in mrad, one slender block, 1.5 s, splitImpulse = 0, a damping ratio of a half; medians of 5
    replicates."""
    yield "solver", "set", "k (N/m)", "2 ms", "1 ms", "0.5 ms"
    for solver in ("ode:step", "bullet:sequential-impulse", "bullet:mlcp-dantzig", "bullet:mlcp-pgs"):
        for settings in ("default", "tuned"):
            for stiffness in (1e6, 1e8, 1e10):
                parameters = {"contactStiffness": stiffness, "contactDamping": 40 * stiffness ** 0.5, "unitMass": 0.0}
                if solver.startswith("bullet"):
                    parameters["splitImpulse"] = 0.0
                yield solver, settings, f"{stiffness:.0e}", *(
                    middle(one_block(1.5), solver, dt, largest_error, digits=2, factor=1e3, settings=settings,
                           parameters=parameters) for dt in (2e-3, 1e-3, 5e-4))


def half_a_step_apart():
    """largest rise of kinetic and potential energy, % of what tips the block, from positions and velocities of one sample, and with positions half
    a step on (Chipmunk) or back (Bullet); one slender block, tuned sets; medians of 5 replicates."""
    yield "solver", "until", "positions", "4 ms", "1 ms", "0.25 ms"
    rocking = one_block(1.5).replace({"law": "unilateral", "contact.friction": 10.0})
    for solver, share in (("chipmunk:sequential-impulse", 0.5), ("bullet:sequential-impulse", -0.5)):
        for until, duration in (("just before it lands", landing_time(one_block(1.5)) - 0.02), ("1.5 s", 1.5)):
            for name, moved in (("of the sample", 0.0), ("half a step apart", share)):
                yield solver, until, name, *(middle(rocking.replace({"duration": duration}), solver, dt,
                                                    lambda motion, step: 100 * rise(motion, moved, step), digits=2,
                                                    bodies=True) for dt in (4e-3, 1e-3, 2.5e-4))


def rise(motion, share, step):
    """The largest rise of energy over its least value before, as a share of what tips the block; positions moved on by a share of
    a step."""
    half_width, half_height, weight = 0.25, 1.25, 0.5 * 2.5 * 2500 * 9.81
    moved = share * step * np.gradient(motion.places[:, 0, 1], step)
    energy = motion.energy + weight * moved
    tipping = weight * (np.hypot(half_width, half_height) - half_height)
    return (energy - np.minimum.accumulate(energy)).max() / tipping

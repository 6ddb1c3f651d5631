"""By which law blocks rub in engines."""
import numpy as np

import rockstack
from replicates import middle, number, rates, solvers

G = 9.81  # m/s²


def landing(friction, slip=0.0, duration=0.01, height=2.0):
    """A block with a width of 1 m that is about to land at 1 rad/s, all but without weight."""
    return rockstack.Scene(duration=duration, gravity=1e-9, law="unilateral",
                           blocks=[{"width": 1.0, "height": height, "density": 500.0}],
                           initial={"angles": [1e-9], "velocities": [-1.0], "slip_velocities": [slip]},
                           contact={"friction": friction})


def left(motion, _step):
    """Of the angular velocity, rad/s."""
    return -motion.velocities[-1, 0]


def one_impact():
    """angular velocity that is left of 1 rad/s, h/b = 2, μ = 0.3; medians of 5 replicates. Coulomb's law leaves 0.613, limits by normal forces without friction 0.531."""
    yield "solver", "set", "1 ms", "0.1 ms", "0.01 ms"
    for solver in solvers():
        if solver.startswith(("mujoco", "simbody")):  # an impact on springs goes on for longer than 60 steps
            continue
        for settings in ("default", "tuned"):
            yield solver, settings, *(middle(landing(0.3, duration=60 * dt), solver, dt, left, settings=settings)
                                      for dt in (1e-3, 1e-4, 1e-5))


def rapier_impact():
    """angular velocity that is left of 1 rad/s by an impact in Rapier, and by its law while blocks slip: the corner's impulse N₀(1 + 2q), q = 3μr/(4 + r²), of a block with h/b = r; tuned set; medians of 5 replicates."""
    yield "h/b", "μ", "1 ms", "0.1 ms", "N₀(1 + 2q)", "Coulomb's law"
    for r in (1.5, 2.0, 3.0, 4.0):
        for friction in (0.1, 0.3, 0.5):
            q, sticks = 3 * friction * r / (4 + r * r), friction >= 3 * r / (1 + 4 * r * r)
            slips = (r * r - 2 + 3 * friction * r) / (4 + r * r - 3 * friction * r)
            yield f"{r:g}", f"{friction:g}", *(
                middle(landing(friction, duration=40 * dt, height=r), "rapier:sequential-impulse", dt, left) for dt in (1e-3, 1e-4)), (
                "" if sticks else number(1 - 6 * (1 - friction * r) / (4 + r * r) * (1 + 2 * q))), number(1 - 1.5 / (1 + r * r) if sticks else slips)


def sticking_impact():
    """angular velocity that is left of 1 rad/s, h/b = 2, ODE; medians of 5 replicates. Above μ = 0.48 Coulomb's law leaves 0.7."""
    yield "solver", "set", "μ", "1 ms", "0.1 ms", "0.01 ms"
    for solver in solvers("ode"):
        for settings, changes in (("default", {}), ("tuned", {}), ("tuned", {"cfm": 1e-12})):
            for friction in (0.5, 0.6):
                yield solver, settings + "+cfm=1e-12" * bool(changes), friction, *(
                    middle(landing(friction, duration=60 * dt), solver, dt, left, digits=4, settings=settings, parameters=changes)
                    for dt in (1e-3, 1e-4, 1e-5))


def slide_and_rock():
    """angle after 0.2 s in mrad, h/b = 2, μ = 0.6, ground that accelerates by g; medians of 5 replicates. Coulomb's law gives 28.4."""
    yield "solver", "set", "4 ms", "1 ms", "0.25 ms"
    scene = rockstack.Scene.read("canon/slide-rock").replace({"duration": 0.2})

    def angle(motion, _):
        return -1e3 * motion.angles[-1, 0]

    for solver in solvers():
        for settings in ("default", "tuned"):
            yield solver, settings, *(middle(scene, solver, dt, angle, settings=settings) for dt in (4e-3, 1e-3, 2.5e-4))


def hop():
    """height of the first hop in mm, a flat block pushed off at 2 m/s, μ = 0.4; medians of 5 replicates. Coulomb's block stays."""
    yield "solver", "set", "4 ms", "1 ms", "0.25 ms", "0.1 ms"
    scene = rockstack.Scene(duration=0.2, law="unilateral", blocks=[{"width": 4.0, "height": 0.5, "mass": 1000.0}],
                            initial={"angles": [0.0], "slip_velocities": [2.0]}, contact={"friction": 0.4})
    for solver in solvers("mujoco"):
        for settings, changes in (("default", {}), ("tuned", {}), ("tuned", {"solref_timeconst": 1e-6})):
            name = settings + "+two steps" * bool(changes)
            yield solver, name, *(middle(scene, solver, dt, lambda motion, _: 1e3 * motion.gaps.max(), settings=settings,
                                         parameters=changes) for dt in (4e-3, 1e-3, 2.5e-4, 1e-4))


def sliding_stop():
    """how far short of v²/(2μg) a block stops, in steps times v; v = 0.5 m/s, μ = 0.4; medians of 5 replicates."""
    yield "solver", "set", "4 ms", "1 ms", "0.25 ms"
    scene = rockstack.Scene(duration=0.3, law="unilateral", blocks=[{"width": 2.0, "height": 1.0, "density": 2500.0}],
                            initial={"angles": [0.0], "slip_velocities": [0.5]}, contact={"friction": 0.4})

    def short(motion, step):
        return (0.25 / (2 * 0.4 * G) - motion.slips[-1, 0]) / (step * 0.5)

    for solver in solvers():
        for settings in ("default", "tuned"):
            yield solver, settings, *(middle(scene, solver, dt, short, digits=2, settings=settings)
                                      for dt in (4e-3, 1e-3, 2.5e-4))


def braking():
    """speed that a flat landing and five steps after it take, over that of Coulomb's law; μ = 0.4; medians of 5 replicates."""
    yield "solver", "set", "4 ms", "2 ms", "1 ms", "0.5 ms", "0.1 ms"
    scene = rockstack.Scene(duration=0.5, law="unilateral", blocks=[{"width": 2.0, "height": 1.0, "density": 2500.0}],
                            contact={"friction": 0.4},
                            ground={"horizontal": {"pulse": "rectangle", "amplitude": -5.0, "period": 0.2},
                                    "vertical": {"pulse": "rectangle", "amplitude": -11.81, "period": 0.2}})

    def taken(motion, step):
        along, up = rates(motion, step).T
        landing = np.flatnonzero((up[:-1] < -0.5) & (up[1:] > up[:-1]))[0]
        return (along[landing] - along[landing + 6]) / (0.4 * (-up[landing] + 6 * G * step))

    for solver in solvers("bullet", "ode"):
        if solver == "bullet:mlcp-lemke":  # its friction is no coefficient
            continue
        for settings, warm in (("default", {}), ("tuned", {}), ("tuned", {"warmstartingFactor": 0.0})):
            if warm and solver not in ("bullet:sequential-impulse", "bullet:nncg"):
                continue
            yield solver, settings + "+warmstartingFactor=0" * bool(warm), *(
                middle(scene, solver, dt, taken, settings=settings, parameters=warm)
                for dt in (4e-3, 2e-3, 1e-3, 5e-4, 1e-4))


def braking_shapes():
    """speed that a flat landing and five steps after it take, over that of the exact motion, by the coefficient of friction; tuned sequential impulse, 1 ms; medians of 5 replicates."""
    coefficients = (0.1, 0.25, 0.3, 0.4, 0.5, 0.6)
    yield "block (m)", "lands at (m/s)", "warmstartingFactor", *(f"μ = {friction:g}" for friction in coefficients)
    for width, height in ((4.0, 1.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.5, 1.5)):
        for speed in (1.0, 2.0):
            for warm in (0.85, 0.0):
                yield f"{width:g} × {height:g}", f"{speed:g}", f"{warm:g}", *(
                    middle(thrown(width, height, speed, friction), "bullet:sequential-impulse", 1e-3, over_exact,
                           parameters={"warmstartingFactor": warm}) for friction in coefficients)


def thrown(width, height, speed, friction):
    """A block that comes down flat, and slides at 3 m/s."""
    return rockstack.Scene(duration=0.025, law="unilateral", blocks=[{"width": width, "height": height, "density": 2500.0}],
                           contact={"friction": friction},
                           initial={"angles": [0.0], "gaps": [0.0073 * speed], "slip_velocities": [3.0], "gap_velocities": [-speed]})


def taken(motion, step):
    """The speed along the ground from before the landing to six steps later, m/s."""
    along, up = rates(motion, step).T
    landing = np.flatnonzero(up[1:] > up[:-1] + 0.1)[0]
    return along[landing] - along[landing + 7]


def over_exact(motion, step):
    exact = rockstack.solve(motion.scene, times=motion.times)
    return taken(motion, step) / taken(exact, step)


def lemke():
    """friction's impulse a step, over μ N s: a block that the ground pulls at 3 m/s² for 0.2 s, mean of the second half; medians of 5 replicates.
    Real masses, splitImpulse = 0, erp2 = 0.01, globalCfm = 1e-6, which is in neither set."""
    yield "contactBreakingThreshold", "block (kg)", "μ", "10 ms", "1 ms", "0.1 ms"
    for threshold in (0.02, 1e-5):
        for mass in (1e3, 1e5):
            for friction in (0.1, 0.3):
                scene = rockstack.Scene(duration=0.2, law="unilateral", blocks=[{"width": 4.0, "height": 0.5, "mass": mass}],
                                        contact={"friction": friction},
                                        ground={"horizontal": {"pulse": "rectangle", "amplitude": 3.0, "period": 1.0}})

                def impulse(motion, step):
                    along = rates(motion, step)[:, 0]
                    steps = len(along) // 2
                    return (3 + (along[-1] - along[-1 - steps]) / (step * steps)) * mass * step / friction

                yield threshold, f"{mass:.0f}", friction, *(
                    middle(scene, "bullet:mlcp-lemke", dt, impulse, settings="default", parameters={
                        "splitImpulse": 0.0, "erp2": 0.01, "globalCfm": 1e-6, "contactBreakingThreshold": threshold})
                    for dt in (1e-2, 1e-3, 1e-4))


def turning_friction():
    """angular velocity that is left of 1 rad/s, h/b = 2, μ = 0.2, where the landing corner slides inwards; 1 ms. An impulse in the direction of the end
    leaves 0.471; Routh's closed form 0.452, 0.433 and 0.395."""
    yield "solver", "set", "0.05 m/s", "0.1 m/s", "0.2 m/s"
    for solver in ("simbody:compliant", "siconos:nsgs", "chipmunk:sequential-impulse"):
        for settings in ("default", "tuned"):
            row = []
            for slip in (0.05, 0.1, 0.2):
                dt = 1e-3 if solver == "simbody:compliant" else 1e-5
                row.append(number(left(rockstack.simulate(landing(0.2, slip, 40 * dt), solver, dt, settings=settings), dt)))
            yield solver, settings, *row

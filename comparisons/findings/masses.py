"""What kilograms do to engines."""
import numpy as np

import rockstack
from replicates import largest_error, measured, middle


def two_blocks(base, top, **changes):
    """The paper's two blocks with these masses, kg."""
    scene = rockstack.Scene.read("spanos-free-rocking").to_dict()
    for block, mass in zip(scene["blocks"], (base, top)):
        block.pop("density", None)
        block["mass"] = mass
    scene.update(duration=1.5, law="consistent", **changes)
    return rockstack.Scene(scene)


def kilograms():
    """largest angle from the exact motion in mrad, the paper's two blocks, 1.5 s, top a hundredth of the base; medians of 5 replicates. 3142: topples."""
    yield "solver", "set", "base (kg)", "4 ms", "1 ms", "0.25 ms"
    for solver in ("bullet:nncg", "bullet:sequential-impulse"):
        for settings, changes in (("default", {}), ("tuned", {}), ("tuned", {"unitMass": 0.0})):
            if changes and solver != "bullet:nncg":
                continue
            for base in (1e-3, 1.0, 1e3, 1e6):
                yield solver, settings + "+unitMass=0" * bool(changes), f"{base:g}", *(
                    middle(two_blocks(base, base / 100), solver, dt, largest_error, digits=2, factor=1e3, settings=settings,
                           parameters=changes) for dt in (4e-3, 1e-3, 2.5e-4))


def cfm():
    """largest angle from the exact motion in mrad, the paper's two blocks, 1.5 s, erp = 0.01; medians of 5 replicates."""
    yield "solver", "set", "masses", "cfm (s/kg)", "4 ms", "1 ms", "0.25 ms"
    for solver in ("ode:step", "ode:quickstep"):
        for settings, changes in (("default", {"erp": 0.01, "cfm": 1e-10}), ("tuned", {"unitMass": 0.0, "cfm": 1e-10})):
            for factor in (1.0, 1e6):
                for share in (1.0, 1e-6):
                    parameters = {**changes, "cfm": share * changes["cfm"]}
                    yield solver, settings, f"times {factor:g}", parameters["cfm"], *(
                        middle(two_blocks(factor * 3906.25, factor * 6250), solver, dt, largest_error, digits=2, factor=1e3,
                               settings=settings, parameters=parameters) for dt in (4e-3, 1e-3, 2.5e-4))


def heavy_top():
    """of 21 replicates how many stay within 20 mrad of the exact motion for 1.5 s; a top a million times heavier than the base, erp = 0.01."""
    yield "solver", "set", "cfm (s/kg)", "contactApprox1", "friction", "10 ms", "5 ms", "2 ms"
    for solver in ("ode:step", "ode:quickstep"):
        for settings in ("default", "tuned"):
            for softness, approximation, friction in ((1e-14, 0.0, 1000.0), (1e-14, 0.0, 100.0), (1e-14, 0.0, 10.0),
                                                      (1e-14, 1.0, 1000.0), (1e-10, 0.0, 1000.0)):
                scene = two_blocks(3906.25, 3906.25e6, engine={"friction": friction})
                parameters = {"cfm": softness, "contactApprox1": approximation, "unitMass": 0.0, "erp": 0.01}
                yield solver, settings, softness, int(approximation), f"{friction:g}", *(
                    sum(error < 0.02 for error in measured(scene, solver, dt, largest_error, count=21, settings=settings,
                                                           parameters=parameters)) for dt in (1e-2, 5e-3, 2e-3))

"""Other answers: physics engines, each run in a process of its own."""
from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from rockstack import _core
from rockstack.errors import EngineError
from rockstack.scene import Scene, core_of
from rockstack.solution import Motion
from rockstack.tables import Table


class Simulation(Motion):
    """What an engine makes of a scene: a sample at the start and after each step, to the end or until a block has toppled.
    Patterns are what its angles tell; an engine reports no events."""

    __slots__ = ("engine", "warnings", "_bodies")

    def __init__(self, scene: Scene, core: _core.Motion, engine: str, warnings: int, bodies: dict[str, Any] | None):
        super().__init__(scene, core)
        self.engine = engine
        self.warnings = warnings
        """How often its solver has failed in a step and gone on."""
        self._bodies = bodies or {}

    @property
    def energy(self) -> np.ndarray | None:
        """Kinetic and potential, zero where the stack rests upright, J; shape (samples,). None unless bodies=True."""
        return self._bodies.get("energy")

    @property
    def input(self) -> np.ndarray | None:
        """Work that the ground's motion has done by then, J; shape (samples,). None unless bodies=True."""
        return self._bodies.get("input")

    @property
    def penetration(self) -> np.ndarray | None:
        """Largest depth of a block in what is below it, m; shape (samples,). None unless bodies=True."""
        return self._bodies.get("penetration")


def engines() -> list[dict[str, Any]]:
    """Those of this build and of the folders in the variable ROCKSTACK_WORKERS: name, solver, version, licence, and settings
    with name, default, tuned, least, most, whole, choices and unit."""
    return _core.engines()


def simulate(scene: Scene, engine: str | os.PathLike[str] = "bullet", dt: float = 1e-3, *, settings: str = "tuned",
             parameters: Mapping[str, float | str] | None = None, time_limit: float = 600.0,
             bodies: bool = False) -> Simulation:
    """One engine alone, in a worker process at time steps of dt (s).

    engine: "bullet", "ode:quickstep", …, or the path of a worker program, "./my_engine.py" (rockstack.Worker). settings:
    "tuned" or "default", with `parameters` changed. time_limit: wall time, s. bodies: also energies and depths.

    Raises EngineError where the run is not done, InputError for an engine, setting or value that is not there. The
    interpreter is free meanwhile, and Ctrl-C ends the worker.
    """
    changes = [f"{name}={value if isinstance(value, str) else repr(float(value))}"
               for name, value in (parameters or {}).items()]
    name = os.fspath(engine)
    motion, warnings, record, failure = _core.simulate(core_of(scene), name, settings, changes, dt, time_limit, bodies)
    if failure is not None:
        raise EngineError(failure)
    return Simulation(scene, motion, name, warnings, record)


def canon(engine: str | os.PathLike[str], *, settings: str = "tuned", scenes: Sequence[str] | None = None,
          draws: int = 5) -> Table:
    """Which law an engine's contacts follow: small scenes, most with a closed form, at steps of 8, 4, 2, 1 and 0.5 ms.

    Columns scene, verdict, reason, shape (scenes,); of the median replicate at each step, shape (scenes, 5): amounts,
    what it is off by, rad or m, and steps_off, over what the fastest motion does in a step. verdict, by a fit of error = model error + c·dtᵖ: "agrees", "converges", "another law",
    "cannot tell", "no run". draws: replicates of each step. scenes: some of the twelve by their names, as
    "rocking-impact"; None: all. engine and settings as of simulate().
    """
    answers = _core.canon(os.fspath(engine), settings, None if scenes is None else list(scenes), draws)
    return Table({name: np.array([answer[name] for answer in answers]) for name in answers[0]} if answers else {})

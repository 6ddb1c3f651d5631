"""Other answers: physics engines, each run in a process of its own."""
from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from typing import Any

import numpy as np

from rockstack import _core
from rockstack.arguments import checked
from rockstack.errors import EngineError
from rockstack.notebook import progress_bar
from rockstack.numbers import same
from rockstack.scene import Scene, scene_of
from rockstack.solution import Motion, solve
from rockstack.tables import Table
from rockstack.worker import Worker


class Simulation(Motion):
    """What an engine makes of a scene: a sample at the start and after each step, to the end or until a block has toppled.
    Patterns are what its angles tell; an engine reports no events."""

    __slots__ = ("engine", "warnings", "_bodies", "_forces")

    def __init__(self, scene: Scene, core: _core.Motion, engine: str, warnings: int, bodies: dict[str, Any] | None,
                 forces: bool):
        super().__init__(scene, core)
        self.engine = engine
        self.warnings = warnings
        """How often its solver has failed in a step and gone on."""
        self._bodies = bodies or {}
        self._forces = forces

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

    @property
    def reactions(self) -> np.ndarray | None:
        """What each interface carries, the mean of the step before, nan at the start, with the fields of Solution.reactions;
        shape (samples, blocks). None unless forces=True."""
        return self._core.reactions if self._forces else None

    def difference(self) -> np.ndarray:
        """The angles less those of the exact motion at the same times, rad; shape (samples, blocks), nan after the end of
        the exact motion."""
        exact = solve(self.scene, times=self.times).angles
        apart = np.full(self.angles.shape, np.nan)
        apart[:len(exact)] = self.angles[:len(exact)] - exact
        return apart

    def __eq__(self, other: object) -> bool:
        return super().__eq__(other) and all(same(getattr(self, name), getattr(other, name)) for name in self.__slots__)

    __hash__ = Motion.__hash__


def engines() -> list[dict[str, Any]]:
    """Those of this build and of the folders in the variable ROCKSTACK_WORKERS: name, solver, version, licence, and settings
    with name, default, tuned, least, most, whole, choices and unit."""
    return _core.engines()


@contextmanager
def programs_of(engines: Iterable[str | os.PathLike[str] | type[Worker]]) -> Iterator[list[str]]:
    """What engines are called by; classes answer as programs meanwhile."""
    with ExitStack() as stack:
        yield [str(stack.enter_context(engine.program())) if isinstance(engine, type) else os.fspath(engine)
               for engine in engines]


@checked
def simulate(scene: Scene | str | os.PathLike[str], engine: str | os.PathLike[str] | type[Worker] = "bullet", dt: float = 1e-3, *,
             settings: str = "tuned", parameters: Mapping[str, float | str] | None = None, time_limit: float = 600.0,
             bodies: bool = False, forces: bool = False) -> Simulation:
    """One engine alone, in a worker process at time steps of dt (s).

    scene: as of solve(). engine: "bullet", "ode:quickstep", …, the path of a worker program, "./my_engine.py" (rockstack.Worker), or a class
    derived from Worker, which answers in this process. settings: "tuned" or "default", with `parameters` changed.
    time_limit: wall time, s. bodies: also energies and depths. forces: `reactions` are what the engine tells of them, each
    the mean of the step before; nan at the start.

    Raises EngineError where the run is not done, InputError for an engine, setting or value that is not there. The
    interpreter is free meanwhile, and Ctrl-C ends the worker.
    """
    asked = scene_of(scene)
    changes = [f"{name}={value if isinstance(value, str) else repr(value)}" for name, value in (parameters or {}).items()]
    with programs_of([engine]) as (program,):
        motion, warnings, record, failure = _core.simulate(asked._core, program, settings, changes, dt, time_limit, bodies,
                                                            forces)
    if failure is not None:
        raise EngineError(failure)
    return Simulation(asked, motion, engine.name if isinstance(engine, type) else program, warnings, record,
                      forces)


class Canon(Table):
    """What canon() finds."""

    def plot(self, axes: Any = None) -> Any:
        """Draws how far each scene is off at steps of 4 and 1 ms by matplotlib, with its verdict. Gives the axes, which may
        be given."""
        from rockstack.figures import draw_canon

        return draw_canon(self, axes)


@checked
def canon(engine: str | os.PathLike[str] | type[Worker], *, settings: str = "tuned", scenes: Sequence[str] | None = None,
          draws: int = 5, progress: bool | None = None) -> Canon:
    """Which law an engine's contacts follow: small scenes, most with a closed form, at steps of 8, 4, 2, 1 and 0.5 ms.

    Columns scene, verdict, reason, shape (scenes,); of the median replicate at each step, shape (scenes, 5): amounts,
    what it is off by, rad or m, and steps_off, over what the fastest motion does in a step. verdict, by a fit of error = model error + c·dtᵖ: "agrees", "converges", "another law",
    "scatters", where successive samples do not share what it is off by, "cannot tell", "no run". draws: replicates of each step. scenes: some of the sixteen by their names, as
    "rocking-impact"; None: all. engine and settings as of simulate(), progress as of solve_many().
    """
    with programs_of([engine]) as (program,), progress_bar(progress, "canon") as tell:
        answers = _core.canon(program, settings, None if scenes is None else list(scenes), draws, tell)
    return Canon({name: np.array([answer[name] for answer in answers]) for name in answers[0]} if answers else {})

"""The difference: scenes on the exact solver and on engines, as a table of runs."""
from __future__ import annotations

import json
import os
import re
import shutil
import tempfile
import weakref
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from rockstack import _core
from rockstack.arguments import checked
from rockstack.engines import programs_of
from rockstack.notebook import progress_bar
from rockstack.scene import Scene
from rockstack.solution import thread_count
from rockstack.tables import Table
from rockstack.worker import Worker


class Comparison(Table):
    """The rows of comparison.csv: one run each. Numbers that do not apply are nan, texts "". meanings says what each column
    is, with its unit.

    folder: the results, as `rockstack compare` writes them; of a comparison without `out` a temporary one, which lasts as
    long as this and its copies in this process.
    """

    meanings: dict[str, str] = _core.column_meanings()

    def __init__(self, rows: list[dict[str, Any]], folder: Path, kept: _Kept | None = None):
        super().__init__({name: _column([row[name] for row in rows]) for name in (rows[0] if rows else {})})
        self.folder = folder
        self._kept = kept

    @checked
    def history(self, run: str) -> np.ndarray:
        """The samples of a run, a value of the column `run`: a structured array with time (s), theta_1, … (rad), omega_1, …
        (rad/s) and pattern; shape (samples,)."""
        return self.file(run, "history.csv")

    @checked
    def file(self, run: str, name: str) -> np.ndarray:
        """A table of a run's folder, such as "difference.csv", "events.csv" or "impacts.csv", as a structured array."""
        path = self.folder / "runs" / run / name
        if not path.is_file():
            raise _core.InputError(f"{path}: must be a file of a run")
        return np.genfromtxt(path, delimiter=",", names=True, dtype=None, encoding="utf-8")

    @checked
    def plot(self, column: str = "largest_angle_difference", axes: Any = None) -> Any:
        """Draws a column over the time step by matplotlib, a line for each scene, engine and settings. Gives the axes, which
        may be given."""
        from rockstack.figures import draw_errors

        return draw_errors(self, column, axes)

    @checked
    def plot_differences(self, scene: str | None = None, axes: Any = None) -> Any:
        """Draws the largest |angle difference| (rad) of each engine's run of a scene over time, that of the replicate with the
        median error, by matplotlib, wider for coarser steps, with a tick at each exact impact. scene: a value of the column; None: the first. Gives the axes, which may be given."""
        from rockstack.figures import draw_differences

        return draw_differences(self, scene, axes)


class _Kept:
    """A folder that goes when all have gone who share this; another process has no share."""

    def __init__(self, folder: Path):
        weakref.finalize(self, shutil.rmtree, folder, True)

    def __deepcopy__(self, memo: dict[int, Any]) -> _Kept:
        return self

    def __reduce__(self):
        return type(None), ()


def _column(cells: list[Any]) -> np.ndarray:
    """Texts where there is one, else numbers."""
    if any(isinstance(cell, str) for cell in cells):
        return np.array([cell or "" for cell in cells])
    return np.array([np.nan if cell is None else cell for cell in cells], dtype=float)


@checked
def compare(inputs: Scene | str | os.PathLike[str] | Sequence[Scene | str | os.PathLike[str]],
            out: str | os.PathLike[str] | None = None, *, engines: Sequence[str | os.PathLike[str] | type[Worker]] = (),
            dt: Sequence[float] = (), quick: bool = False, softness: bool = False, forces: bool = False,
            draws: int = 0, history_interval: float | None = None,
            trajectories: Mapping[str, str | os.PathLike[str] | Sequence[str | os.PathLike[str]]] = {}, jobs: int = 1,
            progress: bool | None = None) -> Comparison:
    """Solves scenes exactly and in engines, and measures how far each engine is off.

    inputs: scenes (Scene, file or name) or suites (file or name). engines: "ode", "bullet:nncg", "./my_engine.py" or a
    class as of simulate(); none: Bullet and ODE, each with default and tuned settings. dt: time steps, s. quick: fewer
    draws and samples. softness: splits
    differences into contact model, softness and step. forces: contact forces and impulses, too. draws: behind each number. history_interval: least
    time between samples that are kept, s. trajectories: motions of a scene that other programs have written, by names for their rows: a CSV file each,
    or several, which are replicates. jobs: runs at a time. progress: as of solve_many(). Results go to the folder `out`, where runs
    that are there already are not made again.

    Raises InputError as the program does; a run that fails says why in its row. Ctrl-C ends it after the run under way.
    """
    given = [inputs] if isinstance(inputs, (Scene, str, os.PathLike)) else list(inputs)
    asked = [(scene._core, _name(scene), scene.to_toml()) if isinstance(scene, Scene) else scene for scene in given]
    folder = Path(out) if out is not None else Path(tempfile.mkdtemp(prefix="rockstack-"))
    kept = _Kept(folder) if out is None else None
    with programs_of(engines) as names, progress_bar(progress, "compare") as tell:
        files = [(name, [os.fspath(file) for file in ([one] if isinstance(one, (str, os.PathLike)) else one)])
                 for name, one in trajectories.items()]
        choice = _core.CompareChoice(names, list(dt), quick, softness, forces, draws or None, history_interval, files)
        rows = _core.compare(asked, str(folder), choice, thread_count(jobs, "jobs"), tell)
    return Comparison(json.loads(rows), folder, kept)


def _name(scene: Scene) -> str:
    """Of a scene, as a folder has it."""
    return re.sub(r"[^A-Za-z0-9]+", "-", scene.title).strip("-").lower() or "scene"

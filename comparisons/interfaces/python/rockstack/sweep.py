"""One scene many times, values varied; and what share of runs topples."""
from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rockstack import _core
from rockstack.numbers import numbers
from rockstack.scene import Scene
from rockstack.solution import thread_count
from rockstack.tables import Table


class SweepTable(Table):
    """The runs of a sweep, one row a run in the order of the grid: samples go fastest, then the last axis.

    A column for each varied key, then peak_1, … (largest |angle| of each block, rad), peak_ratio (over slenderness, of the
    block where that is largest), toppled (number of the block, 0: none), topple_time (s), impacts, events, last_event_time
    (s), least_normal_force (N), force_friction, least_normal_impulse (N·s), impulse_friction, slip and lift (m), onset and
    motion (rest, slide, rock, slide-rock, free flight, topple or fall). What a run does not have is nan, or "" where a
    column is of texts.

    failures: why runs have no outcome, by their number from 0.
    """

    def __init__(self, columns: Mapping[str, np.ndarray], words: Mapping[str, list[str]], failures: dict[int, str]):
        super().__init__(columns)
        self._words = dict(words)
        self.failures = failures

    def __getitem__(self, name: str) -> np.ndarray:
        """A column, shape (runs,). Texts are made when asked for; codes() has the numbers that are kept of them."""
        column = super().__getitem__(name)
        if name not in self._words:
            return column
        return np.array([*self._words[name], ""])[column]

    def codes(self, name: str) -> tuple[np.ndarray, list[str]]:
        """Of a column of texts, the number of each run's in a list (-1: none), and the list."""
        return super().__getitem__(name), self._words[name]

    def to_pandas(self) -> Any:
        """A pandas.DataFrame on the same memory as far as pandas can; texts are categories."""
        import pandas

        columns = {name: pandas.Categorical.from_codes(*self.codes(name)) if name in self._words else self[name]
                   for name in self}
        return pandas.DataFrame(columns, copy=False)


def sweep(ensemble: str | os.PathLike[str] | Mapping[str, Any] | None = None, /, *, overrides: Sequence[str] = (),
          threads: int | None = None, folder: str | os.PathLike[str] = "", **keys: Any) -> SweepTable:
    """Runs an ensemble: a file, the name of one that comes with rockstack, or its keys, `rockstack.keys("ensemble")`:

    sweep(scene=scene, vary=[{"key": "ground.horizontal.peak", "values": np.linspace(1, 8, 20)},
                             {"key": "ground.horizontal.synthetic", "values": range(20)}])

    `scene` is a Scene or its table. Each table of `vary` is a direction of the grid, or is drawn with `samples` and `seed`.
    All cores work, or as many `threads`; the interpreter is free, and Ctrl-C ends the sweep. Each row is written once, where
    the table's arrays have it: a million runs take what their columns do, some 150 bytes each.

    Raises InputError as the program does; a run that fails costs its own row.
    """
    if isinstance(ensemble, (str, os.PathLike)):
        if keys:
            raise _core.InputError(f"{next(iter(keys))}: must be left out where the ensemble is a file")
        return SweepTable(*_core.sweep_file(os.fspath(ensemble), list(overrides), thread_count(threads)))
    table = {"title": "sweep", **(ensemble or {}), **keys}
    if isinstance(table.get("scene"), Scene):
        folder = folder or table["scene"]._core.folder
        table["scene"] = table["scene"].to_dict()
    return SweepTable(*_core.sweep_made(table, os.path.abspath(folder), list(overrides), thread_count(threads)))


@dataclass(frozen=True)
class Fragility:
    """What share of runs topples at each intensity, and the lognormal curve Φ(ln(x/median)/beta) of greatest likelihood.

    intensities, runs, toppled, share, lower and upper (Wilson's bounds of 95 %) have shape (levels,). median (in the
    intensity's unit) and beta are nan where there is no such curve: where one intensity parts all that topple from all
    that do not, or toppling does not grow with intensity.
    """

    intensities: np.ndarray
    runs: np.ndarray
    toppled: np.ndarray
    share: np.ndarray
    lower: np.ndarray
    upper: np.ndarray
    median: float
    beta: float

    def probability(self, intensities: ArrayLike) -> np.ndarray:
        """Of toppling, by the curve; the shape of the intensities."""
        erf = np.vectorize(math.erf, otypes=[float])
        return 0.5 * (1 + erf(np.log(numbers("intensities", intensities) / self.median) / self.beta / np.sqrt(2)))


def fragility(intensities: ArrayLike, toppled: ArrayLike) -> Fragility:
    """Of runs with intensities > 0 and whether (or which block) each toppled; both of shape (runs,). Raises InputError for
    arrays of different lengths."""
    at, hit = numbers("intensities", intensities), numbers("toppled", toppled).astype(bool)
    if at.shape != hit.shape or at.ndim != 1 or at.size == 0:
        raise _core.InputError(f"intensities and toppled: shapes {at.shape} and {hit.shape}: must be one length > 0")
    if not np.all((at > 0) & np.isfinite(at)):
        raise _core.InputError("intensities: must be finite numbers > 0")
    levels, number = np.unique(at, return_inverse=True)
    runs, count = np.bincount(number), np.bincount(number, weights=hit).astype(int)
    bounds = np.array([_core.wilson_bounds(k, n) for k, n in zip(count, runs)])
    median, beta = _core.fit_fragility(levels, runs, count) or (np.nan, np.nan)
    return Fragility(levels, runs, count, count / runs, bounds[:, 0], bounds[:, 1], median, beta)

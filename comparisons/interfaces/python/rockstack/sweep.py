"""One scene many times, values varied; and what share of runs topples."""
from __future__ import annotations

import csv
import math
import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rockstack import _core
from rockstack.arguments import Truths, checked
from rockstack.notebook import progress_bar
from rockstack.numbers import same
from rockstack.scene import Scene
from rockstack.solution import thread_count
from rockstack.tables import Table


class SweepTable(Table):
    """The runs of a sweep, one row a run in the order of the grid: samples go fastest, then the last axis.

    A column for each varied key, where summary has indices matrix (which inputs a run of a sample has: A, B, or A with
    that key's value from B), then peak_1, … (largest |angle| of each block, rad), peak_ratio (over slenderness, of the
    block where that is largest), toppled (number of the block, 0: none), topple_time (s), falling (at the end), impacts,
    events, last_event_time and rest_time (s), least_normal_force (N), force_friction, least_normal_impulse (N·s), impulse_friction,
    slip, lift, uplift and largest_slip (m), onset and motion (rest, slide, rock, slide-rock, free flight, topple or
    fall); peak_ratio, force_friction, slip, lift, uplift and largest_slip of each block too, as peak_ratio_1. What a run does not have is nan, or "" where a column is of texts.

    failures: why runs have no outcome, by their number from 0. shape: how many runs each direction of the grid has.
    dimensions: its name, that of the first key that varies along it, or "sample"; coordinates: the keys that vary along
    each.
    """

    def __init__(self, columns: Mapping[str, np.ndarray], words: Mapping[str, list[str]], failures: dict[int, str],
                 axes: Sequence[tuple[list[str], int]]):
        super().__init__(columns)
        self._words = dict(words)
        self.failures = failures
        kept = [(names, length) for names, length in axes if names or length > 1]
        self.shape = tuple(length for _, length in kept)
        self.coordinates = {names[0] if names else "sample": tuple(names) for names, _ in kept}

    @property
    def dimensions(self) -> tuple[str, ...]:
        """The names of the directions of the grid."""
        return tuple(self.coordinates)

    @checked
    def grid(self, name: str) -> np.ndarray:
        """A column by the grid's directions; of `shape`."""
        return self[name].reshape(self.shape)

    @checked
    def along(self, name: str, direction: int) -> np.ndarray:
        """A column by one direction of the grid, at the beginning of the others; shape (shape[direction],)."""
        return np.moveaxis(self.grid(name), direction, 0).reshape(self.shape[direction], -1)[:, 0]

    def to_xarray(self) -> Any:
        """An xarray.Dataset with named dimensions; keys that vary along one are its coordinates."""
        import xarray

        along = {name: dimension for dimension, names in self.coordinates.items() for name in names}
        values = {name: (along[name], self.along(name, self.dimensions.index(along[name]))) for name in along}
        return xarray.Dataset({name: (self.dimensions, self.grid(name)) for name in self if name not in along}, values)

    @checked
    def plot(self, column: str = "peak_ratio", kind: str = "lines", axes: Any = None) -> Any:
        """Draws a column over the first direction of the grid by matplotlib: "lines", one for each choice of the others in
        grey, and the median over them; or a "map" over the first two, its colours medians over the others. Runs that
        topple have no peaks. Gives the axes, which may be given."""
        from rockstack.figures import draw_sweep

        return draw_sweep(self, column, kind, axes)

    @checked
    def indices(self, outcome: str) -> SobolIndices:
        """Which drawn input decides over a column of numbers, at each point of the grid; of a sweep whose summary has
        indices. toppled and falling, a block's number, count as whether there is one."""
        if "matrix" not in self:
            raise _core.InputError("indices: must be of a sweep whose summary has indices")
        values = self.grid(outcome).astype(float)
        if outcome in ("toppled", "falling"):
            values = np.where(values > 0, 1.0, values)
        return sobol_indices(values, self._words["matrix"][2:])

    def __getitem__(self, name: str) -> np.ndarray:
        """A column, shape (runs,). Texts are made when asked for; codes() has the numbers that are kept of them."""
        column = super().__getitem__(name)
        if name not in self._words:
            return column
        return np.array([*self._words[name], ""])[column]

    @checked
    def codes(self, name: str) -> tuple[np.ndarray, list[str]]:
        """Of a column of texts, the number of each run's in a list (-1: none), and the list."""
        return super().__getitem__(name), self._words[name]

    def to_pandas(self) -> Any:
        """A pandas.DataFrame on the same memory as far as pandas can; texts are categories."""
        import pandas

        columns = {name: pandas.Categorical.from_codes(*self.codes(name)) if name in self._words else self[name]
                   for name in self}
        return pandas.DataFrame(columns, copy=False)


@checked
def sweep(ensemble: str | os.PathLike[str] | Mapping[str, Any] | None = None, /, *, overrides: Sequence[str] = (),
          threads: int | None = None, folder: str | os.PathLike[str] = "", progress: bool | None = None,
          **keys: Any) -> SweepTable:
    """Runs an ensemble: a file, the name of one that comes with rockstack, or its keys, `rockstack.keys("ensemble")`:

    sweep(scene=scene, vary=[{"key": "ground.horizontal.peak", "values": np.linspace(1, 8, 20)},
                             {"key": "ground.horizontal.synthetic", "values": range(20)}])

    `scene` is a Scene or its table. Each table of `vary` is a direction of the grid, or is drawn with `samples` and `seed`.
    summary={"indices": ["toppled"]} makes the runs that SweepTable.indices() needs.
    All cores work, or as many `threads`; the interpreter is free, and Ctrl-C ends the sweep. Each row is written once, where
    the table's arrays have it: a million runs take what their columns do, some 150 bytes each. progress: as of
    solve_many().

    Raises InputError as the program does; a run that fails costs its own row.
    """
    if isinstance(ensemble, (str, os.PathLike)):
        if keys:
            raise _core.InputError(f"{next(iter(keys))}: must be left out where the ensemble is a file")
        with progress_bar(progress, "sweep") as tell:
            return SweepTable(*_core.sweep_file(os.fspath(ensemble), list(overrides), thread_count(threads), tell))
    table: dict[str, Any] = {"title": "sweep", **(ensemble or {}), **keys}
    if isinstance(scene := table.get("scene"), Scene):
        folder = folder or scene._core.folder
        table["scene"] = scene.to_dict()
    with progress_bar(progress, "sweep") as tell:
        return SweepTable(*_core.sweep_made(table, os.path.abspath(folder), list(overrides), thread_count(threads), tell))


@checked
def read_sweep(folder: str | os.PathLike[str]) -> Table:
    """The runs in a results folder of `rockstack sweep`, from runs.npz or runs.csv: the columns that sweep.json explains, each
    of shape (runs,), numbers as float64, nan where a run has none, texts as str. failures.csv beside runs.npz, or the column
    reason of runs.csv, which is left out, says why runs failed. Raises InputError where there are neither."""
    runs = Path(folder) / "runs.npz"
    if runs.is_file():
        with np.load(runs) as columns:
            return Table({name: columns[name] for name in columns.files})
    if not runs.with_suffix(".csv").is_file():
        raise _core.InputError(f"{folder}: must be a folder of a sweep that is finished, with runs.csv or runs.npz")
    with open(runs.with_suffix(".csv"), newline="", encoding="utf-8") as stream:
        names, *rows = csv.reader(stream)
    return Table({name: _column(cells) for name, cells in zip(names, zip(*rows)) if name != "reason"})


def _column(cells: Sequence[str]) -> np.ndarray:
    """Numbers, or texts where one is none; a ' before what a spreadsheet would compute is not theirs."""
    try:
        return np.array([float(cell or "nan") for cell in cells])
    except ValueError:
        return np.array([re.sub(r"^'(?='*[-=+@\t\r])", "", cell) for cell in cells])


@dataclass(frozen=True, eq=False)
class SobolIndices:
    """Shares of an outcome's variance by the inputs that are drawn, with bounds of 95 %.

    keys: the inputs. first: the share that goes when an input alone is known; total: the share that remains while all
    others are known; first_lower, …, total_upper: their bounds. All have shape (…, inputs), nan where the outcome never
    varies. samples: of which they are, shape (…).
    """

    keys: list[str]
    first: np.ndarray
    first_lower: np.ndarray
    first_upper: np.ndarray
    total: np.ndarray
    total_lower: np.ndarray
    total_upper: np.ndarray
    samples: np.ndarray

    def __eq__(self, other: object) -> bool:
        return isinstance(other, SobolIndices) and same(vars(self), vars(other))

    def plot(self, intensities: ArrayLike | None = None, axes: Any = None) -> Any:
        """Draws both indices by matplotlib: a bar each, or, of several points of a grid, the total ones over its
        intensities. Gives the axes, which may be given."""
        from rockstack.figures import draw_indices

        return draw_indices(self, intensities, axes)


@checked
def sobol_indices(outcomes: ArrayLike, keys: Sequence[str]) -> SobolIndices:
    """First-order (Saltelli et al. 2010) and total (Jansen 1999) Sobol indices with bounds of the delta method.

    outcomes: shape (…, samples, 2 + inputs), of Saltelli's design: of inputs A, of inputs B drawn independently, and of A
    with each input in turn from B. Samples with an outcome that is not finite are left out. Raises InputError for
    another shape.
    """
    values = np.asarray(outcomes, dtype=float)
    if values.ndim < 2 or values.shape[-1] != 2 + len(keys) or not keys:
        raise _core.InputError(f"outcomes: shape {values.shape}: must be (samples, {2 + len(keys)}), of A, B and {len(keys)} inputs")
    points = values.reshape(-1, *values.shape[-2:])
    kept = np.isfinite(points).all(axis=-1)
    shares = np.array([_core.sobol_indices(point[of]) for point, of in zip(points, kept)]).reshape(*values.shape[:-2], len(keys), 6)
    first, first_lower, first_upper, total, total_lower, total_upper = np.moveaxis(shares, -1, 0).copy()
    return SobolIndices(list(keys), first, first_lower, first_upper, total, total_lower, total_upper,
                        kept.sum(axis=-1).reshape(values.shape[:-2]))


@dataclass(frozen=True)
class Threshold:
    """Where an outcome begins as a key of a scene grows, and where it ends again.

    first: the least value found at which it happens, to twelve digits; None where it happens nowhere, or at the lower end.
    ranges: neighbouring values with one outcome, rising: (from, to, whether it happens).
    """

    first: float | None
    ranges: list[tuple[float, float, bool]]


@checked
def threshold(scene: Scene, key: str, low: float, high: float, *, outcome: str = "topples", values: int = 200) -> Threshold:
    """The least value of a key, such as "ground.horizontal.scale", that topples a stack.

    outcome: "topples", "lifts", or "COLUMN>NUMBER" with a column of numbers of SweepTable, such as "peak_ratio>0.5". Toppling
    is not monotone: so many values between low and high are tried, and each change is closed in on; what is narrower than
    their distance may be missed. Raises InputError where no value has a motion.
    """
    if values < 2:
        raise _core.InputError(f"values = {values}: must be a whole number from 2")
    return Threshold(*_core.threshold(scene.to_dict(), str(scene._core.folder), f"{key}={low!r}:{high!r}", outcome, values))


@dataclass(frozen=True, eq=False)
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

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Fragility) and same(vars(self), vars(other))

    def plot(self, axes: Any = None) -> Any:
        """Draws shares with their bounds, and the curve where there is one, by matplotlib. Gives the axes, which may be
        given."""
        from rockstack.figures import draw_fragility

        return draw_fragility(self, axes)

    @checked
    def probability(self, intensities: ArrayLike) -> np.ndarray:
        """Of toppling, by the curve; the shape of the intensities."""
        erf = np.vectorize(math.erf, otypes=[float])
        return 0.5 * (1 + erf(np.log(np.asarray(intensities, dtype=float) / self.median) / self.beta / np.sqrt(2)))


@checked
def fragility(intensities: ArrayLike, toppled: Truths) -> Fragility:
    """Of runs with intensities > 0 and whether (or which block) each toppled; both of shape (runs,). Raises InputError for
    arrays of different lengths."""
    at, hit = np.asarray(intensities), np.asarray(toppled, dtype=bool)
    if at.shape != hit.shape or at.ndim != 1 or at.size == 0:
        raise _core.InputError(f"intensities and toppled: shapes {at.shape} and {hit.shape}: must be one length > 0")
    if not np.all((at > 0) & np.isfinite(at)):
        raise _core.InputError("intensities: must be finite numbers > 0")
    levels, number = np.unique(at, return_inverse=True)
    runs, count = np.bincount(number), np.bincount(number, weights=hit).astype(int)
    bounds = np.array([_core.wilson_bounds(k, n) for k, n in zip(count, runs)])
    median, beta = _core.fit_fragility(levels, runs, count) or (np.nan, np.nan)
    return Fragility(levels, runs, count, count / runs, bounds[:, 0], bounds[:, 1], median, beta)

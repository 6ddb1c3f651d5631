"""Figures of what there is, by matplotlib."""
from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from rockstack import _core
from rockstack.arguments import checked

if TYPE_CHECKING:
    from rockstack.compare import Comparison
    from rockstack.engines import Canon, Simulation
    from rockstack.solution import Solution
    from rockstack.sweep import Fragility, SobolIndices, SweepTable


@checked
def draw(results: str | os.PathLike[str], style: str = "paper", **keys: Any) -> tuple[list[Path], list[str]]:
    """Draws the figures for print of results that compare(), `rockstack solve` or `rockstack sweep` has written into a folder.

    keys: those of the table [figures], which keys("suite") explains: width in mm, font, font_size in pt, unit of angles, titles,
    figures and panels (a name or several), from_ and to in s. Gives the figures, to which .pdf, .svg, .png and .csv belong, and what was
    left out of them, with the reason.

    Raises InputError as `rockstack plot`, and where this build has no figures.
    """
    if _core.draw is None:
        raise _core.InputError("draw: must be asked of a build with ROCKSTACK_PLOTS=ON")
    asked = {name.rstrip("_"): [value] if name in ("figures", "panels") and isinstance(value, str) else value for name, value in keys.items()}
    if isinstance(asked.get("titles"), bool):
        asked["titles"] = "scene" if asked["titles"] else "none"
    return _core.draw(Path(results), {"style": style, **asked})


def _axes(axes: Any, count: int = 1) -> Any:
    """Those that are given, or new ones."""
    from matplotlib import pyplot

    if axes is None:
        axes = pyplot.subplots(1, count, figsize=(4.5 * count if count > 1 else 8, 3.2), layout="constrained")[1]
    return axes


def _legend(axes: Any) -> None:
    """Over the figure, which keeps its size."""
    axes.legend(fontsize="small").set_in_layout(False)


def _mark_impacts(axes: Any, times: Any) -> None:
    axes.plot(times, np.zeros(len(times)), "|", color="grey", transform=axes.get_xaxis_transform(), label="impacts")


def draw_motions(solution: Solution, runs: Sequence[Simulation], axes: Any) -> Any:
    axes = _axes(axes, 2 if runs else 1)
    left = axes[0] if runs else axes
    events = solution.events
    _mark_impacts(left, events["time"][events["kind"] == "impact"])
    blocks = range(solution.angles.shape[1])
    for k in blocks:
        left.plot(solution.times, solution.angles[:, k], color=f"C{k}", lw=1, label=f"block {k + 1}")
    for run, dash in zip(runs, ("--", ":", "-.") * len(runs)):
        apart = run.difference()
        for k in blocks:
            left.plot(run.times, run.angles[:, k], dash, color=f"C{k}", lw=1)
            axes[1].plot(run.times, apart[:, k], dash, color=f"C{k}", lw=1, label=f"{run.engine}, block {k + 1}")
    left.set(xlabel="time (s)", ylabel="angle (rad)")
    left.set_title(solution.scene.title, fontsize="medium", loc="left")
    _legend(left)
    if runs:
        axes[1].set(xlabel="time (s)", ylabel="difference from the exact angle (rad)")
        _legend(axes[1])
    return axes


def draw_sweep(table: SweepTable, column: str, kind: str, axes: Any) -> Any:
    if kind not in ("lines", "map") or len(table.shape) < (2 if kind == "map" else 1):
        raise _core.InputError(f"kind = {kind}: must be lines, or map of a sweep with two directions")
    axes = _axes(axes)
    values = table.grid(column).astype(float)
    if column.startswith("peak_"):
        values[table.grid("toppled") > 0] = np.inf
    names = table.dimensions
    x = _along(table, 0)
    flat = values.reshape(*table.shape[:2 if kind == "map" else 1], -1)
    middle = np.nanquantile(flat, 0.5, axis=-1, method="higher")  # of two in the middle never the mean: one may be no number
    if kind == "map":
        drawn = axes.pcolormesh(x, _along(table, 1), np.ma.masked_invalid(middle.T), shading="nearest")
        axes.figure.colorbar(drawn, ax=axes, label=column)
        axes.set(xlabel=names[0], ylabel=names[1])
        return axes
    if flat.shape[1] > 1:
        axes.plot(x, flat, color="grey", lw=0.5)
    axes.plot(x, middle, "o-" if flat.shape[1] == 1 else "-", color="black", label="median" if flat.shape[1] > 1 else None)
    axes.set(xlabel=names[0], ylabel=column)
    return axes


def _along(table: SweepTable, direction: int) -> np.ndarray:
    """The values of a direction of the grid, or numbers from 0."""
    name = table.dimensions[direction]
    if name not in table or table[name].dtype.kind == "U":
        return np.arange(table.shape[direction])
    return table.along(name, direction)


def draw_fragility(curve: Fragility, axes: Any) -> Any:
    axes = _axes(axes)
    axes.errorbar(curve.intensities, curve.share, [curve.share - curve.lower, curve.upper - curve.share], fmt="o",
                  label=f"of {curve.runs.max()} runs, with 95 % bounds")
    if np.isfinite(curve.median):
        x = np.linspace(curve.intensities[0], curve.intensities[-1], 200)
        axes.plot(x, curve.probability(x), label=f"median {curve.median:.3g}, β {curve.beta:.2g}")
    axes.set(xlabel="intensity", ylabel="probability of toppling", ylim=(-0.02, 1.02))
    _legend(axes)
    return axes


def draw_indices(indices: SobolIndices, intensities: Any, axes: Any) -> Any:
    axes = _axes(axes)
    at = np.arange(len(indices.keys))
    if indices.first.ndim == 1:
        for shift, label in ((-0.2, "first"), (0.2, "total")):
            value, lower, upper = (getattr(indices, label + end) for end in ("", "_lower", "_upper"))
            axes.bar(at + shift, value, 0.4, yerr=[value - lower, upper - value], capsize=3, label=f"{label}-order" if shift < 0 else label)
        axes.set_xticks(at, indices.keys)
    else:
        flat = [getattr(indices, "total" + end).reshape(-1, len(at)) for end in ("", "_lower", "_upper")]
        x = np.arange(len(flat[0])) if intensities is None else np.asarray(intensities)
        for i, key in enumerate(indices.keys):
            value, lower, upper = (share[:, i] for share in flat)
            axes.errorbar(x, value, [value - lower, upper - value], fmt="o-", capsize=3, label=key)
        axes.set(xlabel="intensity")
    axes.set(ylabel="share of the variance")
    _legend(axes)
    return axes


def _series(rows: Comparison, numbers: np.ndarray) -> dict[str, np.ndarray]:
    """Rows by their scene, engine and settings, as far as there are several."""
    told = [name for name in ("scene", "engine", "solver", "settings") if len(set(rows[name][numbers])) > 1] or ["engine"]
    labels = np.array([" ".join(str(rows[name][i]) for name in told) for i in numbers])
    return {label: numbers[labels == label] for label in dict.fromkeys(labels.tolist())}


def draw_errors(rows: Comparison, column: str, axes: Any) -> Any:
    axes = _axes(axes)
    made = np.flatnonzero((rows["engine"] != "exact") & np.isfinite(rows[column]))
    for label, numbers in _series(rows, made).items():
        numbers = numbers[np.argsort(rows["dt"][numbers])]
        axes.plot(rows["dt"][numbers], np.abs(rows[column][numbers]), "o-", label=label)
    axes.set(xscale="log", yscale="log", xlabel="time step (s)", ylabel=column.replace("_", " "))
    _legend(axes)
    return axes


def draw_differences(rows: Comparison, scene: str | None, axes: Any) -> Any:
    axes = _axes(axes)
    scene = scene or str(rows["scene"][0])
    done, exact = (rows["scene"] == scene) & (rows["status"] == "done"), rows["engine"] == "exact"
    for number, (label, made) in enumerate(_series(rows, np.flatnonzero(done & ~exact)).items()):
        for width, i in enumerate(made[np.argsort(rows["dt"][made])]):  # the coarser the step, the wider the line
            table = rows.file(rows["run"][i], ("shown/" if rows["shown_replicate"][i] > 0 else "") + "difference.csv")
            apart = np.max([np.abs(table[name]) for name in table.dtype.names if name.startswith("difference_")], axis=0)
            axes.plot(table["time"], apart, lw=0.6 + 0.5 * width, color=f"C{number}", label="" if width else label)
    events = np.atleast_1d(rows.file(rows["run"][np.flatnonzero(done & exact)[0]], "events.csv"))
    _mark_impacts(axes, events["time"][events["kind"] == "impact"])
    axes.set(yscale="log", xlabel="time (s)", ylabel="largest angle difference (rad)", title=scene)
    _legend(axes)
    return axes


def draw_canon(answers: Canon, axes: Any) -> Any:
    axes = _axes(axes)
    at = np.arange(answers.rows)
    axes.bar(at - 0.2, answers["steps_off"][:, 1], 0.4, label="4 ms")
    axes.bar(at + 0.2, answers["steps_off"][:, 3], 0.4, label="1 ms")
    axes.axhline(3, color="grey", ls=":", label="agrees up to here")
    axes.set(ylabel="steps off")
    axes.set_xticks(at, [f"{scene}\n{verdict}" for scene, verdict in zip(answers["scene"], answers["verdict"])])
    _legend(axes)
    return axes

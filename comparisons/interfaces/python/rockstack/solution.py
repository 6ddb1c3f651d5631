"""The exact answer: motions, and how they are solved."""
from __future__ import annotations

import json
import os
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from rockstack import _core
from rockstack.arguments import checked
from rockstack.errors import Unfinished
from rockstack.notebook import player, progress_bar
from rockstack.scene import Scene, scene_of

if TYPE_CHECKING:
    from rockstack.engines import Simulation


class Motion:
    """What blocks do in a scene, at samples. Arrays look at the motion's own numbers: they are read-only, cost nothing,
    and keep the motion for as long as they are there. Motions are equal where all that is known of them is, to the bit;
    a notebook shows one with a player."""

    __slots__ = ("scene", "_core", "__weakref__")

    def __init__(self, scene: Scene, core: _core.Motion):
        self.scene = scene
        self._core = core

    @property
    def times(self) -> np.ndarray:
        """s, ascending; shape (samples,)."""
        return self._core.times

    @property
    def angles(self) -> np.ndarray:
        """rad, clockwise positive; shape (samples, blocks)."""
        return self._core.angles

    @property
    def velocities(self) -> np.ndarray:
        """rad/s, clockwise positive; shape (samples, blocks)."""
        return self._core.velocities

    @property
    def patterns(self) -> np.ndarray:
        """The contact of all interfaces as a text: of two blocks the paper's "1a" to "4b" or "rest", else a letter an
        interface from the ground up, L, C, R or "-"; shape (samples,), empty where patterns are not known."""
        return np.array(self._core.patterns, dtype=str)

    @property
    def slips(self) -> np.ndarray | None:
        """How far each block has slipped to the right along what is below it, m; shape (samples, blocks). None under laws
        of pivots, where nothing slips."""
        return self._core.slips

    @property
    def gaps(self) -> np.ndarray | None:
        """Between each block and what is below it, m, infinite over nothing; shape (samples, blocks), or None as slips."""
        return self._core.gaps

    @property
    def places(self) -> np.ndarray | None:
        """Centres of mass from the middle of the ground's interface, x and y, m; shape (samples, blocks, 2), or None as
        slips."""
        return self._core.places

    @property
    def place_rates(self) -> np.ndarray | None:
        """Their rates, m/s; shape (samples, blocks, 2), or None as slips."""
        return self._core.place_rates

    @property
    def verdict(self) -> str:
        """The motion in a line: why it may not be valid; whether it stands, rests or topples, and how near it comes to its
        balance; of exact motions the friction that they need. Empty without samples."""
        return self._core.verdict

    def to_pandas(self) -> Any:
        """The samples as a pandas.DataFrame, which copies them: theta_1, … (rad), omega_1, … (rad/s) and pattern, by time
        (s)."""
        import pandas

        columns: dict[str, Any] = {f"{name}_{k + 1}": values[:, k] for name, values in (("theta", self.angles),
                                   ("omega", self.velocities)) for k in range(values.shape[1])}
        if len(patterns := self.patterns):
            columns["pattern"] = pandas.Categorical(patterns)
        return pandas.DataFrame(columns, index=pandas.Index(self.times, name="time"))

    def _repr_html_(self) -> str | None:
        shown = player(self) if len(self.times) else None
        return None if shown is None else shown._repr_html_()

    def __eq__(self, other: object) -> bool:
        return (isinstance(other, type(self)) and self.scene == other.scene
                and self._core.packed() == other._core.packed())

    def __hash__(self) -> int:
        return hash((self.scene, len(self.times)))

    def __reduce__(self):
        rest = {name: getattr(self, name) for name in type(self).__slots__}
        return _unpacked, (type(self), self.scene, self._core.packed()), (None, rest)

    def __repr__(self) -> str:
        return f"<rockstack.{type(self).__name__}: {len(self.times)} samples of {self.angles.shape[1]}; {self.verdict}>"


class Solution(Motion):
    """An exact motion, with its events and what it demands of the interfaces. What it comes to are attributes too: toppled,
    topple_time, peak_ratio, force_friction and all other names of `outcome`."""

    __slots__ = ()

    @property
    def outcome(self) -> dict[str, Any]:
        """What the motion comes to: the columns that a sweep has of it, by name, as in summary.json of `rockstack solve`; None
        where there is no such thing, or it is infinite."""
        return json.loads(self._core.outcome)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name == "outcome" or name not in (outcome := self.outcome):
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}", name=name, obj=self)
        return outcome[name]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.outcome]

    @property
    def events(self) -> np.ndarray:
        """A structured array, one row an event: time (s), kind, interface (from 1, the ground's; of topple the block),
        from and to (patterns), angles (rad), before and after (angular velocities, rad/s), each with shape (blocks,),
        consistency, and approach (of impacts, the speed at which the gap closes, m/s; else NaN); shape (events,)."""
        columns = self._core.event_columns
        fields: list[Any] = []
        for name, values in columns.items():
            array = columns[name] = np.asarray(values, dtype=str if isinstance(values, list) else None)
            fields.append((name, array.dtype, array.shape[1:]))
        table = np.empty(len(columns["time"]), dtype=fields)
        for name, array in columns.items():
            table[name] = array
        return table

    def events_to_pandas(self) -> Any:
        """The events as a pandas.DataFrame: time, kind, interface, from, to, consistency, approach, and theta_1, … (rad),
        omega_before_1, … and omega_after_1, … (rad/s)."""
        import pandas

        events = self.events
        columns = {name: events[name] for name in ("time", "kind", "interface", "from", "to", "consistency", "approach")}
        for stem, name in (("theta", "angles"), ("omega_before", "before"), ("omega_after", "after")):
            columns |= {f"{stem}_{k + 1}": events[name][:, k] for k in range(events[name].shape[1])}
        return pandas.DataFrame(columns)

    @checked
    def plot(self, *runs: Simulation, axes: Any = None) -> Any:
        """Draws the angles over time by matplotlib, with a tick at each impact; with runs of engines (Simulation) also
        theirs, and beside it how far they are off. Gives the axes drawn in: one, or with runs two, which `axes` may be."""
        from rockstack.figures import draw_motions

        return draw_motions(self, runs, axes)

    @property
    def demands(self) -> dict[str, np.ndarray]:
        """What each interface has to bear for laws of pivots to hold: of "forces" between impacts (N) and "impulses" of
        them (N·s), structured arrays with least_normal and its time, friction (largest tangential over normal) and its
        time, first_pull_time and first_slip_time (s, infinite where it never comes to that); shape (blocks,)."""
        return {"forces": self._core.forces, "impulses": self._core.impulses}

    @property
    def warnings(self) -> list[str]:
        """One line for each interface and way in which real blocks would leave the model; empty where it holds."""
        return self._core.warnings

    @property
    def valid(self) -> bool:
        """Whether the model holds throughout: there are no warnings."""
        return not self.warnings

    @property
    def peaks(self) -> np.ndarray:
        """Largest |angle| of each block at any time, rad; shape (blocks,)."""
        return self._core.peaks

    @property
    def uplifts(self) -> np.ndarray:
        """How far a corner of each block's lower face has come off the face below at most, m; shape (blocks,)."""
        return self._core.uplifts

    @property
    def slips_left(self) -> np.ndarray | None:
        """How far each block has slipped in the end, m; shape (blocks,), or None as slips."""
        return self._core.slips_left

    @property
    def largest_slips(self) -> np.ndarray | None:
        """Largest |slip| of each block at any time, m; shape (blocks,), or None as slips."""
        return self._core.largest_slips

    @property
    def lifts(self) -> np.ndarray | None:
        """How far each block was from what is below it at most, m; shape (blocks,), or None as slips."""
        return self._core.lifts

    @property
    def reactions(self) -> np.ndarray | None:
        """What each interface carries, as the block above feels it: a structured array with normal and tangential (N, up
        and to the right) and centre (of pressure, from the middle of the block above, m; nan where apart or at a pivot);
        shape (samples, blocks)."""
        return self._core.reactions

    @property
    def spring_energies(self) -> np.ndarray | None:
        """Of law compliant, what springs hold and what has been lost: elastic, damped, rubbed (J); shape
        (samples, blocks). Else None."""
        return self._core.spring_energies

    @property
    def grazes(self) -> list[tuple[float, str, int]]:
        """Events in doubt, which numbers cannot tell from none: time (s), kind and interface (from 1)."""
        return self._core.grazes

    @property
    def choices(self) -> list[tuple[float, str, int]]:
        """Openings that might as well have gone to the other side: time (s), kind and interface (from 1)."""
        return self._core.choices


def _unpacked(kind: type[Motion], scene: Scene, packed: bytes) -> Motion:
    motion = kind.__new__(kind)
    Motion.__init__(motion, scene, _core.Motion.unpacked(scene._core, packed))
    return motion


def _outcome(scene: Scene, core: _core.Motion | None, failure: str | None) -> Solution | Unfinished:
    solution = None if core is None else Solution(scene, core)
    return solution if failure is None and solution is not None else Unfinished(str(failure), solution)


@checked
def solve(scene: Scene | str | os.PathLike[str], *, interval: float | None = 1e-3, times: ArrayLike | None = None, tolerance: float = 0,
          integrator: str = "taylor", step: float = 2e-4) -> Solution:
    """The exact motion of a scene, or of the file or name of one, to rounding: the bits that `rockstack solve` writes.

    interval: between samples, s; None: events alone. times: when to sample instead, s, ascending, shape (samples,).
    tolerance: share of the velocity that a step may leave out; 0: rounding. integrator: "taylor", or "rk4" with the longest
    `step`, s. The interpreter is free meanwhile, and Ctrl-C ends it.

    Raises Unfinished, with the motion up to there, where it cannot be followed; InputError for what is out of range.
    """
    asked = scene_of(scene)
    outcome = _outcome(asked, *_core.solve(asked._core, _core.SolveRequest(interval, times, integrator, tolerance, step)))
    if isinstance(outcome, Unfinished):
        raise outcome
    return outcome


@checked
def solve_many(scenes: Iterable[Scene | str | os.PathLike[str]], *, interval: float | None = 1e-3, times: ArrayLike | None = None,
               tolerance: float = 0, integrator: str = "taylor", step: float = 2e-4, threads: int | None = None,
               failures: str = "raise", progress: bool | None = None) -> list[Solution | Unfinished]:
    """The motions of many scenes, each as solve() gives it to the bit, in their order; other arguments are those of solve().

    All cores work, or as many `threads`, and the interpreter is free. Without samples (interval=None) several scenes of one
    or two blocks are solved side by side. failures: "raise" raises the first Unfinished, "keep" leaves it in its place.
    progress: whether to show a bar of tqdm; None: in a notebook, where tqdm is there.
    """
    if failures not in ("raise", "keep"):
        raise _core.InputError(f"failures = {failures}: must be raise or keep")
    given = [scene_of(scene) for scene in scenes]
    request = _core.SolveRequest(interval, times, integrator, tolerance, step)
    with progress_bar(progress, "solve") as tell:
        outcomes = _core.solve_many([scene._core for scene in given], request, thread_count(threads), tell)
    results = [_outcome(scene, *outcome) for scene, outcome in zip(given, outcomes)]
    for result in results if failures == "raise" else ():
        if isinstance(result, Unfinished):
            raise result
    return results


def thread_count(threads: int | None, name: str = "threads") -> int:
    """As many as given, or one a core."""
    most = 1024  # as of the program's --threads and --jobs
    if threads is None:
        return len(os.sched_getaffinity(0))
    if not 1 <= threads <= most:
        raise _core.InputError(f"{name} = {threads}: must be from 1 to {most}")
    return threads

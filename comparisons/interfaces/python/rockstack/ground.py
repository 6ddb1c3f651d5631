"""How the ground moves, what engineers call a motion by, and its spectrum."""
from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rockstack import _core
from rockstack.arguments import checked, numbers, wrong
from rockstack.numbers import call


class GroundMotion(Mapping):
    """An acceleration of the ground along one axis, by the keys of a table [ground.horizontal].

    GroundMotion("motion.at2", scale=1.0)                                   AT2, COSMOS, ESM, K-NET, SMC, Volume 2, columns
    GroundMotion(samples=values, interval=0.005)                            straight lines between samples, m/s² and s
    GroundMotion(trace, units="cm/s2")                                      a Trace of obspy, or a Stream of one
    GroundMotion(pulse="sine", amplitude=3.0, period=0.5, cycles=2)         exact functions; an impulse is a short pulse
    GroundMotion(synthetic=1, peak=4.0, duration=20.0)                      noise through a ground layer, by its seed

    It is zero before and after. It stands for its table: `Scene(..., ground={"horizontal": motion})`. Motions are equal
    where their samples are, or the tables of pulses; repr() is what makes the same motion again. Raises InputError as
    scenes do, and for a trace that has gaps or no unit of acceleration: its own `stats.units`, or `units`.
    """

    __slots__ = ("_table", "_core")

    @checked
    def __init__(self, given: Mapping[str, Any] | str | os.PathLike[str] | Any = None, /, *, units: str | None = None,
                 **keys: Any):
        if isinstance(given, (str, os.PathLike)):
            given = {"record": os.fspath(given)}
        elif hasattr(given, "stats") or hasattr(given, "traces"):
            given, units = _of_trace(given, units), None
        if units is not None:
            raise _core.InputError("units: must be left out but of a trace, files have their own")
        if given is not None and not hasattr(type(given), "keys"):
            raise wrong("motion", given, "a mapping, a file or a trace of obspy")
        self._table = {**({} if given is None else given), **keys}
        self._core = _core.GroundMotion.made(self._table)

    @classmethod
    def _of(cls, table: Mapping[str, Any], core: _core.GroundMotion) -> GroundMotion:
        """Of a scene, whose folder is not told: its samples as they are."""
        return cls._with({"samples": core.samples, "interval": core.interval} if len(core.samples) else dict(table), core)

    @classmethod
    def _with(cls, table: dict[str, Any], core: _core.GroundMotion) -> GroundMotion:
        motion = cls.__new__(cls)
        motion._core, motion._table = core, table
        return motion

    def __reduce__(self):
        return _unpacked, (self._table, self._core.packed())

    def __getitem__(self, key: str) -> Any:
        return self._table[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._table)

    def __len__(self) -> int:
        return len(self._table)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, GroundMotion) and self._value() == other._value()

    def _value(self) -> Any:
        return (self.interval, self.samples.tobytes()) if len(self.samples) else self._table

    def __hash__(self) -> int:
        return hash((self.interval, len(self.samples), self.end))

    def __repr__(self) -> str:
        return call("GroundMotion", self._table)

    def __str__(self) -> str:
        return f"{self.source}: {self.end:g} s"

    @property
    def source(self) -> str:
        """Where it comes from."""
        return self._core.source

    @property
    def samples(self) -> np.ndarray:
        """Accelerations from t = 0, m/s², read-only; shape (samples,), empty of a pulse."""
        return self._core.samples

    @property
    def interval(self) -> float:
        """Between samples, s; 0 of a pulse."""
        return self._core.interval

    @property
    def times(self) -> np.ndarray:
        """Of the samples, s; shape (samples,)."""
        return self.interval * np.arange(len(self.samples))

    @property
    def end(self) -> float:
        """After which the ground is still, s."""
        return self._core.end

    @checked
    def acceleration(self, times: ArrayLike) -> np.ndarray:
        """At times ≥ 0 (s) of any shape, m/s²; the same shape."""
        return self._core.acceleration(np.asarray(times, dtype=float))

    @checked
    def sampled(self, interval: float) -> GroundMotion:
        """The motion by its values at 0, interval, … (s) up to its end."""
        count = int(np.floor(self.end / interval + 1e-6)) + 1 if interval > 0 and np.isfinite(self.end) else 0
        return GroundMotion(samples=self.acceleration(interval * np.arange(count)), interval=interval)

    def velocities(self) -> np.ndarray:
        """At the samples, from rest, m/s; shape (samples,)."""
        return self._core.velocities()

    def displacements(self) -> np.ndarray:
        """At the samples, from rest, m; shape (samples,)."""
        return self._core.displacements()

    def husid(self) -> np.ndarray:
        """The share of the final ∫a² dt at each sample, 0 to 1; shape (samples,)."""
        return self._core.husid()

    def measures(self) -> dict[str, Any]:
        """points, interval (s), duration (s), peak_acceleration (m/s²), peak_velocity (m/s), peak_displacement (m), each
        with value and time (s); final_velocity (m/s), final_displacement (m), arias_intensity (m/s), and
        significant_5_95 and significant_5_75 with begin, end and length (s)."""
        return self._core.measures()

    @checked
    def spectrum(self, periods: ArrayLike | None = None, damping: float = 0.05) -> tuple[np.ndarray, np.ndarray]:
        """Periods (s) and the pseudo-accelerations (m/s²) of oscillators with them, shape (periods,); without `periods`
        201 from 0.02 to 10 s. `damping` is a fraction of critical."""
        if periods is not None and np.ndim(periods) != 1:
            raise wrong("periods", periods, "an array of one dimension")
        return self._core.spectrum(None if periods is None else np.asarray(periods, dtype=float), damping)

    def without_base_line(self) -> GroundMotion:
        """The motion less the straight line whose removal leaves the least mean square of the velocity."""
        value, slope = self._core.base_line()
        return GroundMotion(samples=self.samples - (value + slope * self.times), interval=self.interval)


def _of_trace(given: Any, units: str | None) -> dict[str, Any]:
    """The table of a trace of obspy, or of a stream of one: samples, units and interval are all that is looked at."""
    traces = list(getattr(given, "traces", [given]))
    if len(traces) != 1:
        raise _core.InputError(f"motion: {len(traces)} traces: must be one, chosen and merged without gaps")
    samples, stats = numbers("trace", traces[0].data), traces[0].stats
    stated = getattr(stats, "units", None)
    factors = [_core.unit_factor(str(name)) for name in (units, stated) if name is not None]
    if not factors or None in factors or factors[0] != factors[-1]:
        raise _core.InputError(f"trace: units = {units}, its own {stated}: must be one unit of acceleration, such as m/s2, "
                               "cm/s2, gal or g")
    return {"samples": samples * factors[0], "interval": float(stats.delta)}


def _unpacked(table: dict[str, Any], packed: bytes) -> GroundMotion:
    return GroundMotion._with(table, _core.GroundMotion.unpacked(packed))

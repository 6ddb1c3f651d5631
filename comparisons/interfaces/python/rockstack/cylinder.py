"""A round column in space, as `rockstack round` has it."""
from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from rockstack import _core
from rockstack.arguments import checked
from rockstack.tables import Table


class RoundMotion(Table):
    """Samples of a cylinder that rolls on its rim: time (s), tilt and azimuth of its axis (rad), omega_tilt, omega_rim and
    omega_axis (rad/s), normal (over the weight), friction_needed, energy (J/kg). events has the same columns and event: lift,
    peak, passage, impact, rest or topple. topples: whether it falls."""

    def __init__(self, samples: Mapping[str, np.ndarray], names: list[str], events: Mapping[str, np.ndarray], topples: bool):
        super().__init__(samples)
        self.events = Table({"event": np.array(names, dtype=str), **events})
        self.topples = topples


@checked
def round_motion(cylinder: str | Mapping[str, Any], *, interval: float = 0.01) -> RoundMotion:
    """The exact motion of a cylinder: a mapping of the keys of `rockstack keys cylinder`, a file, or a name of one that comes with
    rockstack. interval: of samples, s. Raises InputError as the program does."""
    return RoundMotion(*_core.round_motion(cylinder, interval))

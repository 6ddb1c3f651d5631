"""Numbers as they are given."""
from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from rockstack import _core


def numbers(name: str, values: ArrayLike) -> np.ndarray:
    """As an array. Raises InputError where a mask hides some, as the gaps of a record."""
    if np.ma.is_masked(values):
        raise _core.InputError(f"{name}: {np.ma.count_masked(values)} of {np.size(values)} masked: must be filled first")
    return np.asarray(values, dtype=float)

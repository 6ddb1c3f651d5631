"""Values as they are compared and written."""
from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np


def same(one: Any, other: Any) -> bool:
    """Equal by value; arrays to the bit, so that what is not a number equals itself."""
    if isinstance(one, np.ndarray) and isinstance(other, np.ndarray):
        return one.dtype == other.dtype and one.shape == other.shape and one.tobytes() == other.tobytes()
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        return one.keys() == other.keys() and all(same(one[key], other[key]) for key in one)
    return bool(one == other or (one != one and other != other))


def written(value: Any) -> str:
    """As Python reads it back; of a long list the ends, which nothing takes for the whole."""
    longest = 20
    if isinstance(value, (np.ndarray, np.generic)):
        return written(value.tolist())
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{key!r}: {written(inner)}" for key, inner in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(written, value if len(value) <= longest else [*value[:3], ..., *value[-3:]])) + "]"
    if isinstance(value, float) and not math.isfinite(value):
        return f"float('{value}')"
    return "..." if value is ... else repr(value)


def call(name: str, values: Mapping[str, Any]) -> str:
    """What makes the same again: rockstack.name(key=value, …)."""
    return f"rockstack.{name}({', '.join(f'{key}={written(value)}' for key, value in values.items() if value is not None)})"

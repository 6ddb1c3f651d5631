"""Tables as columns."""
from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np


class Table(Mapping):
    """Columns by name, each an array of shape (rows,)."""

    def __init__(self, columns: Mapping[str, np.ndarray]):
        self._columns = dict(columns)

    def __getitem__(self, name: str) -> np.ndarray:
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        """How many columns."""
        return len(self._columns)

    @property
    def rows(self) -> int:
        """How many rows."""
        return len(next(iter(self._columns.values()))) if self._columns else 0

    def to_pandas(self) -> Any:
        """A pandas.DataFrame of the columns."""
        import pandas

        return pandas.DataFrame(dict(self), copy=False)

    def __repr__(self) -> str:
        return f"<rockstack.{type(self).__name__}: {self.rows} rows of {', '.join(self)}>"

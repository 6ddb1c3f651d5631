"""Tables as columns."""
from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from rockstack.numbers import same


class Table(Mapping):
    """Columns by name, each an array of shape (rows,). Tables are equal where their columns are, to the bit."""

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
        """A pandas.DataFrame of the columns; where a row has several values, they are one array in a cell."""
        import pandas

        return pandas.DataFrame({name: list(column) if column.ndim > 1 else column for name, column in self.items()}, copy=False)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Table) and same(dict(self), dict(other))

    def _repr_html_(self) -> str | None:
        """In a notebook, where pandas is there."""
        try:
            return self.to_pandas()._repr_html_()
        except ImportError:
            return None

    def __repr__(self) -> str:
        return f"<rockstack.{type(self).__name__}: {self.rows} rows of {', '.join(self)}>"

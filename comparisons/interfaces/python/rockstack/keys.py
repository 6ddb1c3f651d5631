"""What input files and their counterparts in Python may say, and what comes with rockstack."""
from __future__ import annotations

from rockstack import _core
from rockstack.arguments import checked


@checked
def keys(kind: str = "scene") -> list[dict[str, str]]:
    """Every key of a "scene", "suite" or "ensemble": table, key, unit, range, default, meaning and an example, as texts.

    `pandas.DataFrame(rockstack.keys("scene"))` shows them as a table.
    """
    tables = _core.keys()
    if kind not in tables:
        raise _core.InputError(f"kind = {kind}: must be {' or '.join(tables)}")
    return tables[kind]


@checked
def shipped(kind: str = "scenes") -> list[str]:
    """The names of the "scenes", "suites", "ensembles" or "proved" tables that come with rockstack, in order."""
    if kind == "proved":
        return _core.shipped_names("canon/proved", ".csv")
    if kind not in ("scenes", "suites", "ensembles"):
        raise _core.InputError(f"kind = {kind}: must be scenes or suites or ensembles or proved")
    return _core.shipped_names(kind)

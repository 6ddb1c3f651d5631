"""What rockstack raises."""
from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rockstack.solution import Solution


class InputError(ValueError):
    """Something given is wrong: one line with the place, the key, the value and what is allowed, as the program has it.

    The place is file and line of what was read from a file, and "scene", "motion" or "ensemble" of what was given in
    Python.
    """


class Unfinished(RuntimeError):
    """A motion that could not be followed to its end.

    solution: the motion up to there, or None where nothing of it is known.
    """

    def __init__(self, reason: str, solution: Solution | None = None):
        super().__init__(reason)
        self.solution = solution


class EngineError(RuntimeError):
    """An engine's run that ended in another way than done: its status and the reason."""

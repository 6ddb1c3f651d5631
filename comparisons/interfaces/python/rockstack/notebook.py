"""What notebooks show: how far work has come, and motions in a player."""
from __future__ import annotations

import html
import os
import sys
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from rockstack import _core
from rockstack.arguments import checked

if TYPE_CHECKING:
    from rockstack.solution import Motion


def in_notebook() -> bool:
    """Whether a notebook's kernel runs this."""
    ipython = sys.modules.get("IPython")
    return ipython is not None and type(ipython.get_ipython()).__name__ == "ZMQInteractiveShell"


@contextmanager
def progress_bar(wanted: bool | None, what: str) -> Iterator[Callable[[int, int], None] | None]:
    """To be told how much is done, of how much; None where no bar is wanted. wanted=None: in a notebook with tqdm."""
    if not (in_notebook() if wanted is None else wanted):
        yield None
        return
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # a notebook without widgets gets a bar of letters
            from tqdm.auto import tqdm
    except ImportError:
        if wanted:
            raise
        yield None
        return
    with tqdm(desc=what, delay=0.5) as bar:
        def tell(done: int, total: int) -> None:
            bar.total = total
            if done > bar.n:
                bar.update(done - bar.n)

        yield tell
        tell(bar.total or 0, bar.total)


class Player:
    """A page on which motions move; a notebook shows it."""

    def __init__(self, page: str):
        self.page = page

    @checked
    def write(self, file: str | os.PathLike[str]) -> None:
        """As a page that needs nothing beside itself."""
        Path(file).write_text(self.page, encoding="utf-8")

    def _repr_html_(self) -> str:
        return f'<iframe srcdoc="{html.escape(self.page)}" style="width: 100%; height: 46rem; border: 0"></iframe>'


@checked
def player(*motions: Motion) -> Player | None:
    """Motions with samples side by side, on the scene of the first; None of a build without figures."""
    from rockstack.solution import Solution

    if _core.player is None:
        return None
    shown = [(motion._core, getattr(motion, "engine", "exact"), isinstance(motion, Solution)) for motion in motions]
    if not shown or not all(len(motion.times) for motion in motions):
        raise _core.InputError("player: must be given motions with samples")
    return Player(_core.player(shown))

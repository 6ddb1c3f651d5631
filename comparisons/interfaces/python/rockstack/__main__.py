"""The program, as `python -m rockstack` and as the command that a wheel brings."""
from __future__ import annotations

import os
import sys
from typing import NoReturn

from rockstack import _core


def main() -> NoReturn:
    """Becomes the program, with the same arguments."""
    program = str(_core.programs() / "rockstack")
    os.execv(program, [program, *sys.argv[1:]])


if __name__ == "__main__":
    main()

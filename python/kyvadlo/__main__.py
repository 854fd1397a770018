"""``python -m kyvadlo``: the program."""
from __future__ import annotations

import os
import subprocess
import sys

from .scenes import program


def main() -> int:
    """Runs the program in the place of Python; where that cannot be, beside it."""
    command = [program(), *sys.argv[1:]]
    if os.name == "posix":
        os.execv(command[0], command)
    return subprocess.call(command)


if __name__ == "__main__":
    sys.exit(main())

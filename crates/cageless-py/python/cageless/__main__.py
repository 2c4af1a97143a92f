"""The command ``cageless``, also as ``python -m cageless``."""

import signal
import sys

from ._cageless import command


def main() -> int:
    """Run the command with the words of this program and return its exit code."""
    # Those of the command: Python would raise KeyboardInterrupt after it.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return command(["cageless", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())

"""The command ``cageless``, also as ``python -m cageless``."""

import sys

from ._cageless import command


def main() -> int:
    """Run the command with the words of this program and return its exit code."""
    return command(["cageless", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())

"""Exceptions. Their messages are those of the command ``cageless``."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .result import Result

__all__ = ["CagelessError", "ColumnError", "InputError", "UnphysicalError"]


class CagelessError(Exception):
    """Whatever goes wrong in Cageless; of no narrower kind: a full disk, say."""


class InputError(CagelessError, ValueError):
    """An input that cannot be: which key, its value, and what is allowed.

    The command ends with exit code 2.

    Attributes:
        key: Key at fault, ``section.key``, where it is one of a case or plan, else None.
        line: Line of the file, from 1, where there is one, else None.
    """

    def __init__(self, message: str, key: str | None = None, line: int | None = None) -> None:
        super().__init__(message, key, line)
        self.key = key
        self.line = line

    def __str__(self) -> str:
        return str(self.args[0])


class ColumnError(InputError, KeyError):
    """A column that a result does not have; the message lists those that it has."""


class UnphysicalError(CagelessError, ArithmeticError):
    """A run that left the physical range, or a search that did not converge.

    The command ends with exit code 3.

    Attributes:
        result: Results computed until then; of a search that has nothing to recommend, its maps.
    """

    result: Result | None = None

"""Checks of arguments, and values of NumPy as those of Python."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable
from typing import Any, ClassVar

from . import _cageless
from .errors import InputError

__all__ = ["Fixed", "background", "given", "names", "number", "plain", "refused", "span", "whole"]


def plain(value: Any) -> Any:
    """A number of NumPy as one of Python, an array as a list."""
    return value.tolist() if hasattr(value, "tolist") else value


def refused(name: str, value: Any, allowed: str) -> InputError:
    """The error of a value that is not possible."""
    return InputError(f"{name} = {value!r} is not possible: it must be {allowed}", name)


def number(name: str, value: Any) -> float:
    """A finite number."""
    found = plain(value)
    numeric = isinstance(found, (int, float)) and not isinstance(found, bool)
    if not numeric or not abs(found) <= sys.float_info.max:
        raise refused(name, found, "a finite number")
    return float(found)


def whole(name: str, value: Any, least: int = 0, most: int = 2**31 - 1) -> int:
    """A whole number."""
    found = plain(value)
    if isinstance(found, float) and found.is_integer():
        found = int(found)
    if isinstance(found, bool) or not isinstance(found, int) or not least <= found <= most:
        raise refused(name, found, f"a whole number from {least} to {most}")
    return found


def span(name: str, value: Any) -> tuple[float, float]:
    """Two numbers, from and to."""
    ends = plain(value)
    if isinstance(ends, (list, tuple)) and len(ends) == 2:
        start, end = map(plain, ends)
        if all(isinstance(one, (int, float)) and not isinstance(one, bool) for one in (start, end)):
            return (start, end)
    raise refused(name, ends, "two numbers, from and to")


def given(check: Callable[[str, Any], Any], name: str, value: Any) -> Any:
    """A value that a check passes, or None for one that is left out."""
    return None if value is None else check(name, value)


def background(threads: Any, progress: Any) -> tuple[int | None, Any]:
    """Number of threads and callback of a computation."""
    if threads is not None:
        threads = whole("threads", threads, 1, _cageless.THREADS_MAX)
    return (threads, progress)


def names(value: str | Iterable[str]) -> list[str]:
    """Names; a text is one."""
    return [value] if isinstance(value, str) else list(value)


class Fixed:
    """What has its attributes from its making on; a new one has others."""

    _instead: ClassVar[str] = "make another"

    def __setattr__(self, name: str, value: object) -> None:
        if not name.startswith("_"):
            raise AttributeError(f"{type(self).__name__}.{name} cannot be set: {self._instead}")
        super().__setattr__(name, value)

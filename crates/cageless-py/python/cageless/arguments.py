"""Checks of arguments, and values of NumPy as those of Python."""

from __future__ import annotations

import difflib
import functools
import inspect
import sys
import types
from collections.abc import Callable, Iterable, Mapping
from typing import Any, ClassVar, TypeVar

from . import _cageless
from .errors import InputError
from .units import unit

__all__ = ["Fixed", "background", "checked", "given", "names", "number", "plain", "refused", "span"]
__all__ += ["unitless", "whole"]

F = TypeVar("F", bound=Callable[..., Any])


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


def unitless(name: str, value: Any) -> None:
    """Refuses a number with a unit of its own, of pint or astropy, anywhere in the value of an argument."""
    kind = type(value)
    if hasattr(kind, "units") and hasattr(value, "magnitude") or hasattr(kind, "to_value"):
        symbol = unit(name.rpartition(".")[2])
        wanted = f"a number in {symbol}" if symbol else "a number"
        raise InputError(
            f"{name} = {value} is not possible: it must be {wanted}, without a unit of its own", name
        )
    if isinstance(value, Mapping):
        for key, inner in value.items():
            unitless(str(key), inner)
    elif isinstance(value, (list, tuple)):
        for inner in value:
            unitless(name, inner)
    elif hasattr(kind, "__dataclass_fields__"):
        unitless(name, vars(value))


def checked(function: F, owner: Callable[..., str] | None = None) -> F:
    """A function whose errors of arguments name it, as its `owner` of the first argument does, and what it
    takes."""
    signature = inspect.signature(function)
    kinds = inspect.Parameter
    takes = [
        name
        for name, each in signature.parameters.items()
        if name not in ("self", "cls") and each.kind not in (kinds.VAR_KEYWORD, kinds.VAR_POSITIONAL)
    ]

    def guarded(given: tuple[Any, ...], options: dict[str, Any]) -> Any:
        def named(error: object) -> str:
            of = owner(given[0]) if owner else "cageless."
            name = f"{of}{function.__name__}()".replace(".__init__", "")
            return f"{name}: {error}" if isinstance(error, InputError) else f"{name} {error}"

        try:
            bound = signature.bind(*given, **options)
        except TypeError as error:
            unknown = next((name for name in options if name not in signature.parameters), "")
            said = f"has no argument {unknown!r}" if unknown else f"has other arguments, {error}"
            near = difflib.get_close_matches(unknown, takes, 1)
            said = f"{said} (did you mean {near[0]}?)" if near else said
            of_key = getattr(given[0], "_hint", None) if owner and unknown else None
            hint = of_key(unknown, options[unknown]) if of_key else ""
            listed = f": it takes {', '.join(takes) or 'none'}"
            raise TypeError(named(f"{said}{hint}{listed}")) from None
        try:
            for name, value in bound.arguments.items():
                if name not in ("self", "cls"):
                    unitless(name, value)
        except InputError as error:
            raise InputError(named(error), error.key) from None
        return function(*given, **options)

    def call(*given: Any, **options: Any) -> Any:
        return guarded(given, options)

    # With the globals of the function, by which doctest finds what belongs to a module.
    made = types.FunctionType(
        call.__code__, function.__globals__, call.__name__, call.__defaults__, call.__closure__
    )
    wrapped: Any = functools.wraps(function)(made)
    return wrapped


def owner(first: Any) -> str:
    """The class of an object or class, before the name of its method."""
    return f"{(first if isinstance(first, type) else type(first)).__name__}."


class Fixed:
    """What has its attributes from its making on; a new one has others. The errors of arguments of its
    methods name method and class."""

    _instead: ClassVar[str] = "make another"

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        for name, member in list(vars(cls).items()):
            if name.startswith("_") and name != "__init__":
                continue
            if inspect.isfunction(member):
                setattr(cls, name, checked(member, owner))
            elif isinstance(member, classmethod):
                setattr(cls, name, classmethod(checked(member.__func__, owner)))

    def __setattr__(self, name: str, value: object) -> None:
        if not name.startswith("_"):
            raise AttributeError(f"{type(self).__name__}.{name} cannot be set: {self._instead}")
        super().__setattr__(name, value)

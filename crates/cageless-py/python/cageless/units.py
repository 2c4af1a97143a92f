"""Units of columns: those that are declared, else from the end of the name."""

from __future__ import annotations

import re
from functools import cache
from typing import TYPE_CHECKING

from . import _cageless

if TYPE_CHECKING:
    import pandas as pd

__all__ = ["unit", "with_units"]

STATISTIC = re.compile(r"_(min|max|mean|std|error|end)$")


@cache
def declared() -> dict[str, str]:
    """Units of results, of keys of files and of columns of tables, by name."""
    found: dict[str, str] = _cageless.units()
    return found


@cache
def endings() -> dict[str, str]:
    """Units by what a name with each ends in, the longest first."""
    symbols = sorted({*declared().values()} - {""}, key=lambda symbol: (-len(symbol), symbol))
    found: dict[str, str] = {}
    for symbol in symbols:
        name = re.sub(r"\W+", "_", symbol.replace("^", "")).strip("_").lower()
        found.setdefault(f"_{name}", symbol)
    return found


def unit(column: str) -> str:
    """Unit of a column; empty if it has none.

    Examples
    --------
    >>> unit("radial_load_n"), unit("critical_gap_deg_min"), unit("passes")
    ('N', 'deg', '')
    """
    known = declared()
    while column not in known and (shorter := STATISTIC.sub("", column)) != column:
        column = shorter
    guess = (symbol for ending, symbol in endings().items() if column.endswith(ending))
    return known[column] if column in known else next(guess, "")


def with_units(frame: pd.DataFrame, units: dict[str, str] | None = None) -> pd.DataFrame:
    """The frame, with the unit of each column in ``attrs["units"]``."""
    known = units or {}
    frame.attrs["units"] = {
        str(name): known.get(str(name), unit(str(name))) for name in frame.columns
    }
    return frame

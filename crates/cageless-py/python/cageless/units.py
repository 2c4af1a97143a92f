"""Units of columns, from their names."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import pandas as pd

__all__ = ["unit", "with_units"]

#: Symbols as in the files of Cageless, the longest first.
SYMBOLS = (
    # words: every unit of a name.
    "N s/m, rad/s, deg/s, m/s^2, kg/m^3, N/um, N s, m/s, %, rad, deg, GPa, MPa, rpm, mm, um, us, ms, Hz, "
    "kg, mm^3, N, W, J, C, m, s"
)
#: What a name ends in: its unit in lower case.
UNITS = {
    "_" + re.sub("[ /]", "_", symbol).replace("^", "").replace("%", "percent").lower(): symbol
    for symbol in SYMBOLS.split(", ")
}

STATISTIC = re.compile(r"_(min|max|mean|std|error|end|relative)$")


def unit(column: str) -> str:
    """Unit of a column; empty if its name has none.

    Examples
    --------
    >>> unit("radial_load_n"), unit("critical_gap_deg_min"), unit("torque_n_m"), unit("passes")
    ('N', 'deg', 'N m', '')
    """
    if column.endswith("_relative"):
        return ""
    while (shorter := STATISTIC.sub("", column)) != column:
        column = shorter
    if column.endswith("_n_m"):
        return "N/m" if "stiffness" in column else "N m"
    found = [symbol for ending, symbol in UNITS.items() if column.endswith(ending)]
    return found[0] if found else ""


def with_units(frame: pd.DataFrame, units: dict[str, str] | None = None) -> pd.DataFrame:
    """The frame, with the unit of each column in ``attrs["units"]``."""
    known = units or {}
    frame.attrs["units"] = {
        str(name): known.get(str(name), unit(str(name))) for name in frame.columns
    }
    return frame

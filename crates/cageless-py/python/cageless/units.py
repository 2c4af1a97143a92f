"""Units of columns, from their names."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import pandas as pd

__all__ = ["unit", "with_units"]

#: What a name ends in, the longest ending first; symbols as in the files of Cageless.
UNITS = {
    "_n_s_m": "N s/m",
    "_rad_s": "rad/s",
    "_deg_s": "deg/s",
    "_m_s2": "m/s^2",
    "_kg_m3": "kg/m^3",
    "_n_um": "N/um",
    "_n_s": "N s",
    "_m_s": "m/s",
    "_percent": "%",
    "_rad": "rad",
    "_deg": "deg",
    "_gpa": "GPa",
    "_mpa": "MPa",
    "_rpm": "rpm",
    "_mm": "mm",
    "_um": "um",
    "_us": "us",
    "_ms": "ms",
    "_hz": "Hz",
    "_kg": "kg",
    "_mm3": "mm^3",
    "_n": "N",
    "_w": "W",
    "_j": "J",
    "_m": "m",
    "_s": "s",
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

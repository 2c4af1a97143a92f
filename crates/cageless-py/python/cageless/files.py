"""Results as files for other programs."""

from __future__ import annotations

import os
import re
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _cageless
from .errors import CagelessError

if TYPE_CHECKING:
    import pandas as pd

__all__ = ["matlab", "spreadsheet", "write"]

#: Beginnings of what spreadsheets take for a formula.
FORMULA = ("=", "+", "-", "@", "\t", "\r")
#: Characters that command a terminal.
CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f]")


def write(path: str | os.PathLike[str], content: bytes) -> Path:
    """Writes a file, which takes its name when it is complete."""
    _cageless.write(os.fspath(path), content)
    return Path(path)


def spreadsheet(frame: pd.DataFrame) -> str:
    """A frame as CSV, whose texts neither a spreadsheet takes for a formula nor a terminal for a command."""

    def cell(value: Any) -> Any:
        if not isinstance(value, str):
            return value
        shown = CONTROL.sub(lambda found: f"\\u{ord(found[0]):04x}", value)
        return f"'{shown}" if value.startswith(FORMULA) else shown

    whole = frame if frame.index.names == [None] else frame.reset_index()
    texts = {str(name): column.map(cell) for name, column in whole.items() if column.dtype.kind not in "biuf"}
    return whole.assign(**texts).to_csv(index=False)


def matlab(tables: dict[str, pd.DataFrame]) -> bytes:
    """Tables as a file of MATLAB."""
    try:
        from scipy.io import savemat
    except ImportError as error:
        message = "to_mat needs SciPy, which is not installed: pip install scipy"
        raise CagelessError(message) from error
    contents: dict[str, Any] = {"units": {}}
    for name, frame in tables.items():
        known = frame.attrs.get("units", {})
        if frame.index.names != [None]:
            frame = frame.reset_index()
        columns = {str(column): cells(frame[column]) for column in frame.columns}
        contents[field(name)] = {field(column): values for column, values in columns.items()}
        contents["units"][field(name)] = {field(c): known.get(c, "") for c in columns}
    file = BytesIO()
    savemat(file, contents, long_field_names=True, oned_as="column")
    return file.getvalue()


def field(name: str) -> str:
    """A name that MATLAB takes for a field."""
    legal = re.sub(r"\W", "_", name, flags=re.ASCII)
    return legal[:63] if legal[:1].isalpha() else f"x_{legal}"[:63]


def cells(column: pd.Series[Any]) -> Any:
    """Numbers as they are, with NaN for none; everything else as cells."""
    array = column.to_numpy()
    if array.dtype.kind in "biuf":
        return array
    found = np.empty(len(array), dtype=object)
    for k, value in enumerate(array):
        missing = value is None or (isinstance(value, float) and np.isnan(value))
        found[k] = "" if missing else value if isinstance(value, np.ndarray) else str(value)
    return found

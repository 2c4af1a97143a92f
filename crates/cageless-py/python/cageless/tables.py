"""Tables of results as files for other programs."""

from __future__ import annotations

import os
import re
from abc import ABC, abstractmethod
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import folders
from .errors import CagelessError

if TYPE_CHECKING:
    import pandas as pd

__all__ = ["Tables"]


class Tables(ABC):
    """A result with tables."""

    @abstractmethod
    def _tables(self) -> dict[str, pd.DataFrame]:
        """Tables by name."""

    def to_csv(self, folder: str | os.PathLike[str]) -> list[Path]:
        """Writes every table as ``NAME.csv`` into a folder, which is created.

        Columns have their units in their names, numbers all of their digits.

        Returns
        -------
        list of Path
            The files.

        Raises
        ------
        InputError
            If the folder cannot be used.
        """
        written = []
        for name, frame in self._tables().items():
            index = frame.index.name is not None
            text = frame.to_csv(index=index)
            written.append(folders.write(folder, f"{name}.csv", text.encode()))
        return written

    def to_mat(self, path: str | os.PathLike[str]) -> Path:
        """Writes the tables as a file of MATLAB: a structure per table with a field per column,
        and ``units`` with the unit of each. Needs SciPy.

        Returns
        -------
        Path
            The file.

        Raises
        ------
        CagelessError
            If SciPy is not installed.
        InputError
            If the file cannot be written there.
        """
        try:
            from scipy.io import savemat
        except ImportError as error:
            message = "to_mat needs SciPy, which is not installed: pip install scipy"
            raise CagelessError(message) from error
        from io import BytesIO

        contents: dict[str, Any] = {"units": {}}
        for name, frame in self._tables().items():
            known = frame.attrs.get("units", {})
            if frame.index.name is not None:
                frame = frame.reset_index()
            columns = {field(column): values(frame[column]) for column in frame.columns}
            contents[field(name)] = columns
            contents["units"][field(name)] = {
                field(column): known.get(column, "") for column in frame.columns
            }
        bytes_ = BytesIO()
        savemat(bytes_, contents, long_field_names=True, oned_as="column")
        path = Path(path)
        return folders.write(path.parent, path.name, bytes_.getvalue(), create=False)


def field(name: object) -> str:
    """A name that MATLAB takes for a field."""
    legal = re.sub(r"\W", "_", str(name), flags=re.ASCII)
    return legal[:63] if legal[:1].isalpha() else f"x_{legal}"[:63]


def values(column: pd.Series[Any]) -> Any:
    """Numbers as they are, with NaN for none; everything else as cells."""
    array = column.to_numpy()
    if array.dtype.kind in "biuf":
        return array
    cells = np.empty(len(array), dtype=object)
    for k, value in enumerate(array):
        missing = value is None or (isinstance(value, float) and np.isnan(value))
        cells[k] = "" if missing else value if isinstance(value, np.ndarray) else str(value)
    return cells

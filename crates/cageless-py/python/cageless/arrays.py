"""Arrays of runs and drops by table and column."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = ["Arrays", "equal", "footer", "frozen"]

Arrays = dict[str, dict[str, npt.NDArray[Any]]]


def frozen(arrays: Arrays) -> Arrays:
    """The arrays, not for writing any more: figures would not follow."""
    for table in arrays.values():
        for array in table.values():
            array.flags.writeable = False
    return arrays


def equal(arrays: Arrays, others: Arrays) -> bool:
    """Whether all columns of the first are equal to those of the second."""
    return all(
        np.array_equal(array, others[of][name], equal_nan=True)
        for of, columns in arrays.items()
        for name, array in columns.items()
    )


def footer(summary: dict[str, Any]) -> tuple[str, str]:
    """Instructions and case of the footers of the tables."""
    case = json.dumps(summary["case"], ensure_ascii=False, separators=(",", ":"))
    return (summary["isa"], case)

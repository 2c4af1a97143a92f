"""A bearing within its tolerances."""

from __future__ import annotations

import json
import os
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _cageless, pages
from .figures import figure
from .sections import table

if TYPE_CHECKING:
    import pandas as pd
    import plotly.graph_objects as go

__all__ = ["ToleranceResult"]


class ToleranceResult:
    """Whether the verdict on a raceway holds as made; keys are those of
    ``cageless tolerance --json``."""

    def __init__(self, tolerance: _cageless.Tolerance) -> None:
        self._tolerance = tolerance

    @cached_property
    def values(self) -> dict[str, Any]:
        """All numbers."""
        found: dict[str, Any] = json.loads(self._tolerance.numbers())
        return found

    @property
    def verdict(self) -> str:
        """Verdict as drawn: ``smooth``, ``double-collision`` or ``slips``."""
        return str(self.values["nominal_verdict"])

    @property
    def critical_gap_deg(self) -> float | None:
        """Critical gap as drawn."""
        found: float | None = self.values["nominal_critical_gap_deg"]
        return found

    @property
    def _samples(self) -> dict[str, Any]:
        found: dict[str, Any] | None = self.values["samples"]
        return found or {}

    @property
    def probability(self) -> float | None:
        """Probability that the verdict holds when everything deviates at once; None without
        samples."""
        return self._samples.get("probability")

    @property
    def probability_interval(self) -> tuple[float, float] | None:
        """Its 95 % interval."""
        found = self._samples.get("probability_interval")
        return None if found is None else (found[0], found[1])

    @property
    def decides(self) -> list[str]:
        """What alone, within its range, changes the verdict; the surest to do so first."""
        rows = [row for row in self.values["influences"] if row["held"] < row["trials"]]
        rows.sort(key=lambda row: row["held"] / row["trials"])
        return [str(row["name"]) for row in rows]

    def critical_gaps_deg(self, verdict: str) -> npt.NDArray[np.float64]:
        """Critical gaps of the bearings with this verdict when everything deviates at once."""
        counts = self._samples.get("verdicts", [])
        found = [each["critical_gap_deg"] for each in counts if each["verdict"] == verdict]
        return np.array(found[0] if found else [], dtype=float)

    def data_influences(self) -> pd.DataFrame:
        """A row per influence alone at both ends of its range; ``_min`` and ``_max`` span
        these and the bearing as drawn."""
        import pandas as pd

        rows = []
        for influence in self.values["influences"]:
            row: dict[str, Any] = {}
            for key, value in influence.items():
                if key in ("critical_gap_deg", "twice_share", "slip_mean_m_s"):
                    low, high = value or (np.nan, np.nan)
                    row |= {f"{key}_min": low, f"{key}_max": high}
                elif key == "verdicts":
                    row[key] = ", ".join(value)
                else:
                    row[key] = value
            rows.append(row)
        return pd.DataFrame(rows)

    def data_verdicts(self) -> pd.DataFrame:
        """How often each verdict came out when everything deviated at once."""
        import pandas as pd

        rows = [
            {"verdict": each["verdict"], "count": each["count"]}
            for each in self._samples.get("verdicts", [])
        ]
        return pd.DataFrame(rows, columns=["verdict", "count"])

    def plot_influences(self) -> go.Figure:
        """Range of the critical gap over each influence."""
        return figure(self._tolerance.figure("influences"))

    def plot_samples(self) -> go.Figure:
        """Critical gaps of the bearings in which everything deviates, by verdict."""
        return figure(self._tolerance.figure("samples"))

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Writes the report page of ``cageless tolerance``, which works offline."""
        return pages.write(path, self._tolerance.page())

    def __repr__(self) -> str:
        if self.probability is None:
            return f"<Tolerance: {self.verdict} as drawn>"
        return f"<Tolerance: {self.verdict} holds with probability {self.probability:g}>"

    def _repr_html_(self) -> str:
        rows: list[tuple[str, object]] = [
            ("as drawn", self.verdict),
            ("critical gap, °", self.critical_gap_deg),
            ("probability that it holds", self.probability),
            ("95 % interval", self.probability_interval),
        ]
        return table(rows, "Tolerances") + str(self.data_influences().to_html())

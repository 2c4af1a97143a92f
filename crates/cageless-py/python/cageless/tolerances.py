"""A bearing within its tolerances."""

from __future__ import annotations

import json
import os
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _cageless, folders, pages
from .figures import figure
from .section import table
from .tables import Tables
from .units import with_units

if TYPE_CHECKING:
    import pandas as pd
    import plotly.graph_objects as go

__all__ = ["ToleranceResult"]


class ToleranceResult(Tables):
    """Tolerance analysis of a raceway; keys are those of ``cageless tolerance --json``."""

    def __init__(self, tolerance: _cageless.Tolerance) -> None:
        self._tolerance = tolerance

    @classmethod
    def _restored(cls, numbers: str) -> ToleranceResult:
        return cls(_cageless.Tolerance.restored(numbers))

    def __reduce__(self) -> tuple[Any, ...]:
        return (ToleranceResult._restored, (self._tolerance.numbers(),))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ToleranceResult) and self.values == other.values

    __hash__ = None  # type: ignore[assignment]

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Writes what ``cageless tolerance --out`` writes: ``tolerance.json`` and the page.
        :func:`load` reads it.

        Returns
        -------
        Path
            The folder, which is created.
        """
        folders.write(folder, "tolerance.json", self._tolerance.numbers().encode())
        return folders.write(folder, "report.html", self._tolerance.page().encode()).parent

    def _tables(self) -> dict[str, pd.DataFrame]:
        return {"influences": self.data_influences(), "verdicts": self.data_verdicts()}

    @cached_property
    def values(self) -> dict[str, Any]:
        """All results by key."""
        found: dict[str, Any] = json.loads(self._tolerance.numbers())
        return found

    @property
    def verdict(self) -> str:
        """Nominal verdict: ``smooth``, ``double-collision``, ``slips`` or ``infeasible``."""
        return str(self.values["nominal_verdict"])

    @property
    def passes(self) -> bool:
        """Whether the nominal bearing passes, and 95 % of the Monte Carlo sample."""
        return bool(self.values["passes"])

    @property
    def nominal_passes(self) -> bool:
        """Whether the nominal bearing passes."""
        return bool(self.values["nominal_passes"])

    @property
    def headline(self) -> str:
        """PASS or FAIL with the probability of passing and the reason."""
        return str(self.values["headline"])

    @property
    def critical_gap_deg(self) -> float | None:
        """Nominal critical gap."""
        found: float | None = self.values["nominal_critical_gap_deg"]
        return found

    @property
    def _samples(self) -> dict[str, Any]:
        found: dict[str, Any] | None = self.values["samples"]
        return found or {}

    @property
    def pass_probability(self) -> float | None:
        """Probability of passing in the Monte Carlo sample; None without samples."""
        return self._samples.get("pass_probability")

    @property
    def pass_probability_interval(self) -> tuple[float, float] | None:
        """95 % interval of the probability of passing."""
        found = self._samples.get("pass_probability_interval")
        return None if found is None else (found[0], found[1])

    @property
    def decides(self) -> list[str]:
        """Parameters that alone, within their tolerance, change the verdict of the nominal bearing;
        the most certain first."""
        nominal = self.nominal_passes

        def changed(row: dict[str, Any]) -> float:
            share: float = row["passed"] / row["trials"]
            return 1.0 - share if nominal else share

        rows = [row for row in self.values["influences"] if changed(row) > 0.0]
        rows.sort(key=changed, reverse=True)
        return [str(row["name"]) for row in rows]

    def critical_gaps_deg(self, verdict: str) -> npt.NDArray[np.float64]:
        """Critical gaps of the bearings with this verdict in the Monte Carlo sample."""
        counts = self._samples.get("verdicts", [])
        found = [each["critical_gap_deg"] for each in counts if each["verdict"] == verdict]
        return np.array(found[0] if found else [], dtype=float)

    def data_influences(self) -> pd.DataFrame:
        """A row per influence alone at both ends of its range; ``_min`` and ``_max`` span
        these and the nominal bearing."""
        import pandas as pd

        rows = []
        for influence in self.values["influences"]:
            row: dict[str, Any] = {}
            for key, value in influence.items():
                if key in ("critical_gap_deg", "double_collision_fraction", "slip_mean_m_s"):
                    low, high = value or (np.nan, np.nan)
                    row |= {f"{key}_min": low, f"{key}_max": high}
                elif key == "verdicts":
                    row[key] = ", ".join(value)
                else:
                    row[key] = value
            rows.append(row)
        return with_units(pd.DataFrame(rows))

    def data_verdicts(self) -> pd.DataFrame:
        """Number of each verdict in the Monte Carlo sample."""
        import pandas as pd

        rows = [
            {key: each[key] for key in ("verdict", "passes", "count")}
            for each in self._samples.get("verdicts", [])
        ]
        return with_units(pd.DataFrame(rows, columns=["verdict", "passes", "count"]))

    def plot_influences(self, *, title: str | None = None) -> go.Figure:
        """Range of the critical gap over each influence."""
        return figure(self._tolerance.figure("influences"), title)

    def plot_samples(self, *, title: str | None = None) -> go.Figure:
        """Critical gaps of the bearings in which everything deviates, by verdict."""
        return figure(self._tolerance.figure("samples"), title)

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Writes the report page of ``cageless tolerance``, which works offline."""
        return pages.write(path, self._tolerance.page())

    def __repr__(self) -> str:
        word = "PASS" if self.passes else "FAIL"
        if self.pass_probability is None:
            return f"<Tolerance: {word}, {self.verdict} nominal>"
        return (
            f"<Tolerance: {word}, passes with probability {self.pass_probability:g}, "
            f"{self.verdict} nominal>"
        )

    def _repr_html_(self) -> str:
        rows: list[tuple[str, object]] = [
            ("verdict", self.headline),
            ("nominal", self.verdict),
            ("critical gap, °", self.critical_gap_deg),
            ("probability of passing", self.pass_probability),
            ("95 % interval", self.pass_probability_interval),
        ]
        return table(rows, "Tolerances") + str(self.data_influences().to_html())

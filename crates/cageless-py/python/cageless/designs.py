"""Analyses of raceways."""

from __future__ import annotations

import json
import os
import zlib
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _cageless, folders, pages
from .figures import figure
from .section import table
from .tables import Tables
from .units import with_units

if TYPE_CHECKING:
    import pandas as pd
    import plotly.graph_objects as go

__all__ = ["Design"]


def _restored_design(values: str, report: bytes) -> Design:
    """A design from its pickle."""
    return Design._restored(values, zlib.decompress(report).decode())


@dataclass(frozen=True, repr=False)
class Design(Tables):
    """The analysis of a raceway; keys are those of ``cageless design --json``."""

    values: dict[str, Any]
    _design: _cageless.Design = field(compare=False)

    @classmethod
    def _restored(cls, values: str, report: str) -> Design:
        return cls(json.loads(values), _cageless.Design.restored(values, report))

    def __reduce__(self) -> tuple[Any, ...]:
        report = zlib.compress(self._design.report().encode(), 1)
        return (_restored_design, (self._design.numbers(), report))

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Writes what ``cageless design --out`` writes: ``design.json`` and the page.
        :func:`load` reads it.

        Returns
        -------
        Path
            The folder, which is created.
        """
        folders.write(folder, "design.json", self._design.numbers().encode())
        folders.write(folder, "report.json", self._design.report().encode())
        return folders.write(folder, "report.html", self._design.page().encode()).parent

    @property
    def verdict(self) -> str:
        """``smooth``, ``double-collision``, ``slips`` or ``infeasible``; ``not-judged`` without a
        discrete raceway."""
        return str(self.values["verdict"])

    @property
    def passes(self) -> bool | None:
        """Whether the raceways pass; None without one."""
        found: bool | None = self.values["passes"]
        return found

    @property
    def headline(self) -> str:
        """PASS or FAIL with the verdict, the criterion that decides, and its margin."""
        return str(self.values["headline"])

    @property
    def reasons(self) -> list[str]:
        """Reasons as sentences."""
        return list(self.values["reasons"])

    @property
    def warnings(self) -> list[str]:
        """Warnings, for example of a contact stress above 4.2 GPa."""
        return list(self.values["warnings"])

    @property
    def critical_gap_deg(self) -> float | None:
        """Gap below which neighbours touch in the raceway."""
        found: float | None = self.values["critical_gap_deg"]
        return found

    @property
    def beta0_deg(self) -> float | None:
        """Gap that Zhao 2022, Eq. (11) gives."""
        found: float | None = self.values["beta0_deg"]
        return found

    @property
    def recommendation(self) -> dict[str, Any] | None:
        """A raceway near the curve of Eq. (11) with its ``verdict``: recommended if it ``passes``,
        else only a starting point for a search."""
        found: dict[str, Any] | None = self.values["recommendation"]
        return found

    def data_curve(self) -> pd.DataFrame:
        """The lC–θ curve of Eq. (11)."""
        import pandas as pd

        return with_units(pd.DataFrame(self.values["curve"], dtype=float))

    def _tables(self) -> dict[str, pd.DataFrame]:
        return {"curve": self.data_curve()}

    def plot_curve(self, *, title: str | None = None) -> go.Figure:
        """θ over lC by Eq. (11), with the case's raceway and the limits."""
        return figure(self._design.figure("curve"), title)

    def plot_contact_track(self, *, title: str | None = None) -> go.Figure:
        """Contact track of the case's first raceway."""
        return figure(self._design.figure("contact_track"), title)

    def plot_surface(self, *, title: str | None = None) -> go.Figure:
        """Surface of the case's first raceway."""
        return figure(self._design.figure("surface"), title)

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Writes the report page of ``cageless design``, which works offline."""
        return pages.write(path, self._design.page())

    def __repr__(self) -> str:
        gap = self.critical_gap_deg
        shown = "" if gap is None else f", critical gap {gap:.4g}°"
        word = {True: "PASS", False: "FAIL", None: "not judged"}[self.passes]
        return f"<Design: {word}, {self.verdict}{shown}>"

    def _repr_html_(self) -> str:
        rows = [(k, v) for k, v in self.values.items() if not isinstance(v, (list, dict))]
        rows += [("reason", reason) for reason in self.reasons]
        return table(rows, "Design")

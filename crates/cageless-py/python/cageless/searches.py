"""The best raceway for a range of speeds and loads."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _cageless, folders, pages
from .errors import UnphysicalError
from .figures import figure
from .section import table
from .sections import Raceway
from .tables import Tables
from .units import with_units

if TYPE_CHECKING:
    import pandas as pd
    import plotly.graph_objects as go

    from .case import Case
    from .computations import Computations

__all__ = ["SearchMap", "SearchResult"]

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class SearchMap:
    """Raceways over lC (columns) and θ (rows) at one speed and load.

    Parameters
    ----------
    inner_speed_rpm, radial_load_n : float
        Speed and load.
    axial_span_mm, half_angle_deg : array
        lC of the columns, θ of the rows.
    critical_gap_deg, steady_gap_deg : array
        Smallest gap that the raceway guarantees, and gap in steady flow; NaN where there
        is none.
    verdict : array of str
        ``smooth``, or the short name of what excludes the raceway.
    passes : array of bool
        Whether the raceway meets every requirement.
    """

    inner_speed_rpm: float
    radial_load_n: float
    axial_span_mm: Floats
    half_angle_deg: Floats
    critical_gap_deg: Floats
    steady_gap_deg: Floats
    verdict: npt.NDArray[np.str_]
    passes: npt.NDArray[np.bool_]


class SearchResult(Tables):
    """Result of a search; keys are those of ``search`` in ``cageless design --search --json``."""

    def __init__(self, search: _cageless.Search, case: Computations) -> None:
        self._search = search
        self._case = case

    @classmethod
    def _restored(cls, case: Computations, numbers: str, refusal: str | None) -> SearchResult:
        return cls(_cageless.Search.restored(case._file, numbers, refusal), case)

    def __reduce__(self) -> tuple[Any, ...]:
        numbers, refusal = self._search.numbers(), self._search.refusal()
        return (SearchResult._restored, (self._case, numbers, refusal))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, SearchResult):
            return False
        return self._case == other._case and self.values == other.values

    __hash__ = None  # type: ignore[assignment]

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Writes the case as ``case.toml`` and the numbers as ``search.json``. :func:`load`
        reads them, and the folder of ``cageless design --search --out`` as well.

        Returns
        -------
        Path
            The folder, which is created.
        """
        values = {"refusal": self._search.refusal(), "search": self.values}
        folders.write(folder, "case.toml", self._case._file.to_toml().encode())
        text = json.dumps(values, ensure_ascii=False) + "\n"
        return folders.write(folder, "search.json", text.encode()).parent

    def _tables(self) -> dict[str, pd.DataFrame]:
        tables = {
            "structures": self.data_structures(),
            "front": self.data_front(),
            "confirmation": self.data_confirmation(),
            "rejections": self.data_rejections(),
            "placements": self.data_placements(),
        }
        maps = range(len(self.values["maps"]))
        return tables | {f"map_{k}": self.data_map(k) for k in maps}

    @cached_property
    def values(self) -> dict[str, Any]:
        """All results of the search by key."""
        found: dict[str, Any] = json.loads(self._search.numbers())
        return found

    @property
    def findings(self) -> list[str]:
        """Findings as sentences."""
        return list(self.values["findings"])

    @property
    def passes(self) -> bool | None:
        """Whether the recommended structure passes the verdict of ``design`` at every speed and
        load; None if there is none."""
        verdicts = self.values["recommended_verdicts"]
        return all(each["passes"] for each in verdicts) if verdicts else None

    @property
    def verdicts(self) -> list[dict[str, Any]]:
        """Verdict of ``design`` on the recommended structure at each speed and load: ``verdict``,
        ``passes`` and ``headline``."""
        return list(self.values["recommended_verdicts"])

    @property
    def recommended(self) -> tuple[Raceway, ...]:
        """The recommended structure; empty if there is none."""
        found = self.values["recommended"]
        if found is None:
            return ()
        size = {key: found[key] for key in ["axial_span_mm", "half_angle_deg"]}
        places = found["centre_angles_deg"]
        return tuple(Raceway(**size, centre_angle_deg=place) for place in places)

    @property
    def case(self) -> Case:
        """The case with the recommended structure, to be run.

        Raises
        ------
        UnphysicalError
            If there is nothing to recommend.
        """
        if not self.recommended:
            raise UnphysicalError(self.findings[0])
        case = self._case.with_raceways(*self.recommended)
        return case.replace({"title": f"{case.title or 'Case'}: recommended raceway"})

    @property
    def maps(self) -> list[SearchMap]:
        """Maps over lC and θ, one per operating point, then one per further speed."""
        return [
            SearchMap(
                inner_speed_rpm=each["point"]["inner_speed_rpm"],
                radial_load_n=each["point"]["radial_load_n"],
                axial_span_mm=np.array(each["axial_span_mm"], dtype=float),
                half_angle_deg=np.array(each["half_angle_deg"], dtype=float),
                critical_gap_deg=np.array(each["critical_gap_deg"], dtype=float),
                steady_gap_deg=np.array(each["steady_gap_deg"], dtype=float),
                verdict=np.array(each["verdict"], dtype=str),
                passes=np.array(each["passes"], dtype=bool),
            )
            for each in self.values["maps"]
        ]

    def _rows(self, structure: dict[str, Any]) -> list[dict[str, Any]]:
        """A row per operating point."""
        head = {k: v for k, v in structure.items() if k != "points"}
        rows = []
        for point, numbers in zip(self.values["points"], structure["points"], strict=True):
            row = head | point
            row |= {k: v for k, v in numbers.items() if k not in ("motion", "errors")}
            row |= numbers["motion"] or {}
            row |= {f"{k}_error": v for k, v in (numbers["errors"] or {}).items()}
            rows.append(row)
        return rows

    def _frame(self, structures: list[dict[str, Any]]) -> pd.DataFrame:
        import pandas as pd

        rows = [
            {"structure": k} | row
            for k, structure in enumerate(structures)
            for row in self._rows(structure)
        ]
        return with_units(pd.DataFrame(rows))

    def data_structures(self) -> pd.DataFrame:
        """Every structure that was evaluated, a row per operating point: accepted, rejected
        with its reason, or left out by the budget."""
        return self._frame(self.values["band"])

    def data_front(self) -> pd.DataFrame:
        """The Pareto front, nearest to the best in everything first."""
        return self._frame(self.values["front"])

    def data_confirmation(self) -> pd.DataFrame:
        """The recommended and the initial design, from more starts, with standard
        errors."""
        import pandas as pd

        roles = {role: self.values[role] for role in ["recommended", "own"]}
        rows = [
            {"role": role} | row
            for role, structure in roles.items()
            if structure is not None
            for row in self._rows(structure)
        ]
        return with_units(pd.DataFrame(rows))

    def data_rejections(self) -> pd.DataFrame:
        """Number of designs and map cells excluded by each reason."""
        import pandas as pd

        columns = ["reason", "meaning", "count"]
        return with_units(pd.DataFrame(self.values["rejections"], columns=columns))

    def data_placements(self) -> pd.DataFrame:
        """Places of the raceways that were tried."""
        import pandas as pd

        rows = [{k: v for k, v in p.items() if k != "best"} for p in self.values["placements"]]
        return with_units(pd.DataFrame(rows))

    def data_map(self, k: int = 0) -> pd.DataFrame:
        """Map `k` with a row per cell."""
        import pandas as pd

        found = self.maps[k]
        angle, span = np.meshgrid(found.half_angle_deg, found.axial_span_mm, indexing="ij")
        frame = pd.DataFrame(
            {
                "axial_span_mm": span.reshape(-1),
                "half_angle_deg": angle.reshape(-1),
                "critical_gap_deg": found.critical_gap_deg.reshape(-1),
                "steady_gap_deg": found.steady_gap_deg.reshape(-1),
                "verdict": found.verdict.reshape(-1),
            }
        )
        return with_units(frame)

    def plot_verdicts(self, *, title: str | None = None) -> go.Figure:
        """Feasible designs and reasons for exclusion."""
        return figure(self._search.figure("verdicts"), title)

    def plot_critical_gaps(self, *, title: str | None = None) -> go.Figure:
        """Critical gap over lC and θ."""
        return figure(self._search.figure("critical_gaps"), title)

    def plot_trade_offs(self, *, title: str | None = None) -> go.Figure:
        """Trade-offs of the Pareto front."""
        return figure(self._search.figure("trade_offs"), title)

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Writes the report page of ``cageless design --search``, which works offline. Takes
        seconds: the page has the verdict on the initial design."""
        return pages.write(path, self._search.page())

    def __repr__(self) -> str:
        if not self.recommended:
            return "<Search: nothing to recommend>"
        one = self.recommended[0]
        count = len(self.recommended)
        several = "" if count == 1 else f", {count} raceways"
        return (
            f"<Search: lC {one.axial_span_mm:.3f} mm, θ {one.half_angle_deg:.2f}°{several}; "
            f"{len(self.values['front'])} on the front>"
        )

    def _repr_html_(self) -> str:
        rows: list[tuple[str, object]] = [("", finding) for finding in self.findings]
        return table(rows, "Search") + str(self.data_front().to_html(max_rows=10))

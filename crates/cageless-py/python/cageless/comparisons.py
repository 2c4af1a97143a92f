"""Outer rings compared from the same uneven starts."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .section import table
from .tables import Tables

if TYPE_CHECKING:
    import pandas as pd

__all__ = ["RingComparison"]


@dataclass(frozen=True, repr=False)
class RingComparison(Tables):
    """A case compared with another; keys of ``values`` are those of ``cageless compare --json``."""

    values: dict[str, Any]

    @property
    def statement(self) -> str:
        """What the raceway changes significantly, and what not, in a sentence."""
        return str(self.values["statement"])

    @property
    def starts(self) -> int:
        """Uneven starts of each ring."""
        return int(self.values["starts"]["count"])

    def data_results(self) -> pd.DataFrame:
        """A row per result: means over the starts of the reference and of the case with their
        standard errors, and their difference, start by start. ``better`` is None where the
        difference is not significant, has no better direction, or where the cases differ in more
        than the raceway."""
        import pandas as pd

        def parts(prefix: str, estimate: dict[str, Any] | None) -> dict[str, float | None]:
            found = estimate or {}
            return {prefix: found.get("mean"), prefix + "_error": found.get("standard_error")}

        rows = []
        for result in self.values["results"]:
            reference, case = result["values"]
            row = {"name": result["name"], "unit": result["unit"]}
            row |= parts("reference", reference) | parts("case", case)
            row |= parts("difference", result["differences"][1])
            rows.append(row | {"better": result["better"][1]})
        return pd.DataFrame(rows).set_index("name")

    def _tables(self) -> dict[str, pd.DataFrame]:
        return {"results": self.data_results()}

    def __repr__(self) -> str:
        return f"<RingComparison from {self.starts} starts: {self.statement}>"

    def _repr_html_(self) -> str:
        return table([("statement", self.statement), ("starts", self.starts)], "Comparison")

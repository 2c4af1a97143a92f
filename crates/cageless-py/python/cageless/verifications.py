"""Numerical verification of a run."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from .section import table
from .units import with_units

if TYPE_CHECKING:
    import pandas as pd

__all__ = ["Verification"]


@dataclass(frozen=True)
class Verification:
    """Which results of a run are converged, from perturbed starts and half the step.

    ``case.run(verify=True).verification`` returns it; keys are those of ``verification`` in
    ``summary.json``.
    """

    values: dict[str, Any]
    names: list[str]
    """Keys of the verified results, in the order of tables."""

    @property
    def converged(self) -> int:
        """Number of results that change neither with the step nor with the initial state."""
        return int(self.values["converged"])

    @property
    def statistical(self) -> int:
        """Number of results that depend on the initial state but not on the step."""
        return int(self.values["statistical"])

    @property
    def step_biased(self) -> int:
        """Number of results biased by the step; a smaller step is needed for these."""
        return int(self.values["step_biased"])

    @property
    def predictability(self) -> str:
        """Lyapunov time and predictability as a sentence."""
        return str(self.values["predictability"])

    @property
    def predictability_time_s(self) -> float | None:
        """Time after which trajectories are unpredictable; None if beyond the end of the run."""
        found: float | None = self.values["predictability_time_s"]
        return found

    @property
    def divergence_time_s(self) -> float | None:
        """Lyapunov time; None if the run does not diverge."""
        found: float | None = self.values["divergence_time_s"]
        return found

    @property
    def energy_residual_relative(self) -> float:
        """Energy balance error, relative to the sum of all energy flows."""
        return float(self.values["energy_residual_relative"])

    @property
    def momentum_residual_relative(self) -> float:
        """Momentum balance error, relative to the sum of absolute impulses."""
        return float(self.values["momentum_residual_relative"])

    def verdict(self, name: str) -> str:
        """``converged``, ``statistical`` or ``step-biased``.

        Parameters
        ----------
        name : str
            One of `names`.
        """
        return str(self.values["numbers"][name]["verdict"])

    def standard_error(self, name: str) -> float:
        """Standard error of the mean over the starts, in the unit of the number."""
        return float(self.values["numbers"][name]["standard_error"])

    def distance(self, column: str) -> npt.NDArray[np.float64]:
        """Distance of the replicas from the run, ``perturbed`` starts or ``half_step``, over
        ``time_s``."""
        return np.array(self.values["distance"][column], dtype=float)

    def data_numbers(self) -> pd.DataFrame:
        """A row per result: verdict, value, mean and standard error over the starts, reason."""
        import pandas as pd

        rows = [self.values["numbers"][name] for name in self.names]
        return pd.DataFrame(rows, index=pd.Index(self.names, name="number"))

    def data_distance(self) -> pd.DataFrame:
        """Distances of the replicas from the run over time."""
        import pandas as pd

        return with_units(pd.DataFrame(self.values["distance"], dtype=float))

    def data_ledger(self) -> pd.DataFrame:
        """Errors of the energy and momentum balances, at the step and at half the step."""
        import pandas as pd

        kinds = ["energy", "momentum"]
        rows = [
            [self.values[f"{kind}_residual_relative{step}"] for step in ["", "_half_step"]]
            for kind in kinds
        ]
        columns = ["residual_relative", "residual_relative_half_step"]
        return pd.DataFrame(rows, index=pd.Index(kinds, name="balance"), columns=columns)

    def __repr__(self) -> str:
        counts = f"{self.converged} converged, {self.statistical} statistical"
        return f"<Verification: {counts}, {self.step_biased} step-biased>"

    def _repr_html_(self) -> str:
        rows: list[tuple[str, object]] = [
            ("converged", self.converged),
            ("statistical", self.statistical),
            ("step-biased", self.step_biased),
            ("predictability", self.predictability),
        ]
        shown = self.data_numbers()[["value", "unit", "verdict", "reason"]]
        return table(rows, "Numerical verification") + str(shown.to_html())

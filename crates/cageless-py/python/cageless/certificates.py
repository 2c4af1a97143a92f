"""How far the numbers of a run can be trusted."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from .sections import table

if TYPE_CHECKING:
    import pandas as pd

__all__ = ["Certificate"]


@dataclass(frozen=True)
class Certificate:
    """What a run repeated from turned starts and at half the step says of its numbers.

    ``case.run(verify=True).certificate`` has it; keys are those of ``certificate`` in
    ``summary.json``.
    """

    values: dict[str, Any]
    names: list[str]
    """Numbers that are judged, in the order of tables."""

    @property
    def converged(self) -> int:
        """How many numbers change neither with the step nor with the start."""
        return int(self.values["converged"])

    @property
    def statistical(self) -> int:
        """How many numbers change from start to start, and no more with the step."""
        return int(self.values["statistical"])

    @property
    def neither(self) -> int:
        """How many numbers the step biases: set a smaller step for these."""
        return int(self.values["neither"])

    @property
    def predictability(self) -> str:
        """How long the run itself is known, in words."""
        return str(self.values["predictability"])

    @property
    def predictability_time_s(self) -> float | None:
        """From when on no point of the run is known; None if that is beyond its end."""
        found: float | None = self.values["predictability_time_s"]
        return found

    @property
    def divergence_time_s(self) -> float | None:
        """Time in which near runs part by a factor e; None if they do not part."""
        found: float | None = self.values["divergence_time_s"]
        return found

    @property
    def energy_residual_relative(self) -> float:
        """What the energy ledger misses, relative to the energy turned over."""
        return float(self.values["energy_residual_relative"])

    @property
    def momentum_residual_relative(self) -> float:
        """Momentum without a force, relative to the sum of absolute impulses."""
        return float(self.values["momentum_residual_relative"])

    def verdict(self, name: str) -> str:
        """``converged``, ``statistical`` or ``neither``.

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
        """Distance of other runs from this one, ``near`` starts or ``half_step``, over
        ``time_s``."""
        return np.array(self.values["distance"][column], dtype=float)

    def data_numbers(self) -> pd.DataFrame:
        """A row per number: verdict, value, mean and standard error over the starts, reason."""
        import pandas as pd

        rows = [self.values["numbers"][name] for name in self.names]
        return pd.DataFrame(rows, index=pd.Index(self.names, name="number"))

    def data_distance(self) -> pd.DataFrame:
        """Distances of other runs from this one over time."""
        import pandas as pd

        return pd.DataFrame(self.values["distance"], dtype=float)

    def data_ledger(self) -> pd.DataFrame:
        """What the balances of energy and momentum miss, at the step and at half of it."""
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
        return f"<Certificate: {counts}, {self.neither} neither>"

    def _repr_html_(self) -> str:
        rows: list[tuple[str, object]] = [
            ("converged", self.converged),
            ("statistical", self.statistical),
            ("neither", self.neither),
            ("predictability", self.predictability),
        ]
        shown = self.data_numbers()[["value", "unit", "verdict", "reason"]]
        return table(rows, "Certificate") + str(shown.to_html())

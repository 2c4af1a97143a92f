"""The outer ring as files."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .section import table
from .units import with_units

if TYPE_CHECKING:
    import pandas as pd

__all__ = ["Export"]


@dataclass(frozen=True)
class Export:
    """Files of the outer ring.

    Args:
        values: For each file what ``cageless export --json`` prints.
    """

    values: list[dict[str, Any]]

    @property
    def files(self) -> list[Path]:
        """The files."""
        return [Path(each["file"]) for each in self.values]

    @property
    def formats(self) -> list[str]:
        """Kind of each file: ``step``, ``stl`` or ``csv``."""
        return [str(each["format"]) for each in self.values]

    @property
    def deviation_um(self) -> dict[str, float]:
        """Largest distance of each kind of file from the analytic surface."""
        return {each["format"]: float(each["deviation_um"]) for each in self.values}

    @property
    def volume_mm3(self) -> float:
        """Volume of the analytic solid."""
        return float(self.values[0]["volume_mm3"])

    @property
    def blend_mm(self) -> float:
        """Length of the blends at the ends of raceways; 0 for none."""
        return float(self.values[0]["blend_mm"])

    @property
    def blend_not_simulated(self) -> str | None:
        """What to set for the case to simulate the blend; ``None`` if it does or there is none."""
        return self.values[0].get("blend_not_simulated")

    @property
    def blend_deviation_um(self) -> float:
        """Largest distance between the blended surface and the one designed."""
        return float(self.values[0]["blend_deviation_um"])

    def data_files(self) -> pd.DataFrame:
        """A row per file."""
        import pandas as pd

        units = dict.fromkeys(("volume_mm3", "mesh_volume_mm3"), "mm^3")
        return with_units(pd.DataFrame(self.values).set_index("format"), units)

    def _repr_html_(self) -> str:
        rows = [(each["file"], f"{each['deviation_um']:.6f} µm") for each in self.values]
        return table([("file", "deviation from the surface"), *rows], "Outer ring")

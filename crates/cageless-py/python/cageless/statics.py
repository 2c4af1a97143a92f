"""Static equilibria."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import folders
from .figures import polar
from .section import table
from .tables import Tables
from .units import with_units

if TYPE_CHECKING:
    import pandas as pd
    import plotly.graph_objects as go

__all__ = ["Static"]

Floats = npt.NDArray[np.float64]


def shown(value: float) -> str:
    """Three decimals, without a minus before zeros."""
    return f"{round(value, 3) + 0.0:.3f}"


@dataclass(frozen=True, repr=False)
class Static(Tables):
    """A static equilibrium and the ratings of the bearing.

    Keys of ``values`` are those of ``cageless static --json``. Arrays over the balls have the
    shape (balls,), semi-axes (balls, 2), the stiffness (2, 2). Ratings and lives are indicative:
    see ``notes``.
    """

    values: dict[str, Any]

    @property
    def ring_x_um(self) -> float:
        """Centre of the inner ring."""
        return float(self.values["ring_x_um"])

    @property
    def ring_y_um(self) -> float:
        """Centre of the inner ring."""
        return float(self.values["ring_y_um"])

    @property
    def ball_angle_deg(self) -> Floats:
        """ψ of each ball."""
        return np.array(self.values["ball_angle_deg"])

    @property
    def inner_force_n(self) -> Floats:
        """Normal force of each ball at the inner raceway."""
        return np.array(self.values["inner_force_n"])

    @property
    def outer_force_n(self) -> Floats:
        """Normal force of each ball at the outer raceway."""
        return np.array(self.values["outer_force_n"])

    @property
    def inner_stress_max_gpa(self) -> float:
        """Largest contact pressure at the inner raceway."""
        return float(self.values["inner_stress_max_gpa"])

    @property
    def outer_stress_max_gpa(self) -> float:
        """Largest contact pressure at the outer raceway."""
        return float(self.values["outer_stress_max_gpa"])

    @property
    def inner_pressure_gpa(self) -> Floats:
        """Largest contact pressure of each ball at the inner raceway."""
        return np.array(self.values["inner_pressure_gpa"])

    @property
    def outer_pressure_gpa(self) -> Floats:
        """Largest contact pressure of each ball at the outer raceway; on a discrete raceway at
        one of its two contact points."""
        return np.array(self.values["outer_pressure_gpa"])

    @property
    def inner_semi_axes_mm(self) -> Floats:
        """Semi-axes of the contact ellipses at the inner raceway (balls, 2): along the rolling
        direction, across it."""
        return self._semi_axes("inner")

    @property
    def outer_semi_axes_mm(self) -> Floats:
        """Semi-axes of the contact ellipses at the outer raceway (balls, 2): along the rolling
        direction, across it."""
        return self._semi_axes("outer")

    @property
    def ball_orbit_rpm(self) -> Floats:
        """Orbital speed of each ball in rolling."""
        return np.array(self.values["ball_orbit_rpm"])

    @property
    def ball_rotation_rpm(self) -> Floats:
        """Absolute rotational speed of each ball in rolling, positive in the rolling sense."""
        return np.array(self.values["ball_rotation_rpm"])

    @property
    def stiffness_n_m(self) -> Floats | None:
        """Stiffness matrix of the bearing at its operating point (2, 2), rows x and y; None
        where nothing holds the ring in some direction."""
        xx, xy, yy = (self.values[f"stiffness_{at}_n_m"] for at in ("xx", "xy", "yy"))
        return None if xx is None else np.array([[xx, xy], [xy, yy]])

    def _semi_axes(self, raceway: str) -> Floats:
        axes = [self.values[f"{raceway}_semi_axis_{way}_mm"] for way in ("along", "across")]
        return np.array(axes).T

    @property
    def basic_dynamic_rating_n(self) -> float:
        """Basic dynamic radial load rating Cr (ISO 281)."""
        return float(self.values["basic_dynamic_rating_n"])

    @property
    def basic_static_rating_n(self) -> float:
        """Basic static radial load rating C0r (ISO 76)."""
        return float(self.values["basic_static_rating_n"])

    def _optional(self, name: str) -> float | None:
        found = self.values[name]
        return None if found is None else float(found)

    @property
    def static_safety(self) -> float | None:
        """Static safety factor s0 = C0r/Fr (ISO 76); None without radial load."""
        return self._optional("static_safety")

    @property
    def pressure_safety(self) -> float | None:
        """(4200 MPa/p)³ with the largest contact pressure p; None if no ball is loaded."""
        return self._optional("pressure_safety")

    @property
    def l10_mrev(self) -> float | None:
        """Basic rating life (ISO 281), million revolutions; None without radial load."""
        return self._optional("l10_mrev")

    @property
    def l10r_mrev(self) -> float | None:
        """Basic reference rating life (ISO/TS 16281), million revolutions: rigid rings under the
        radial load, without weight and centrifugal force; None without radial load."""
        return self._optional("l10r_mrev")

    @property
    def l10r_at_speed_mrev(self) -> float | None:
        """The reference rating life with the forces of the balls in equilibrium, weight and
        centrifugal force included; None if no ball is loaded."""
        return self._optional("l10r_at_speed_mrev")

    @property
    def l10_h(self) -> float | None:
        """Basic rating life at the speed of the case, h; None without radial load or speed."""
        return self._optional("l10_h")

    @property
    def l10r_h(self) -> float | None:
        """Basic reference rating life at the speed of the case, h."""
        return self._optional("l10r_h")

    @property
    def l10r_at_speed_h(self) -> float | None:
        """``l10r_at_speed_mrev`` at the speed of the case, h."""
        return self._optional("l10r_at_speed_h")

    @property
    def assembly(self) -> str:
        """Way of assembly, on which Cr depends: "without-slot" or "filling-slot"."""
        return str(self.values["assembly"])

    @property
    def rating_factor(self) -> float:
        """bm of ISO 281 for the way of assembly."""
        return float(self.values["rating_factor"])

    @property
    def inner_stiffness(self) -> float:
        """Contact stiffness K at the inner raceway, N·m^(−3/2)."""
        return float(self.values["inner_stiffness"])

    @property
    def outer_stiffness(self) -> float:
        """Contact stiffness K at the outer raceway, N·m^(−3/2)."""
        return float(self.values["outer_stiffness"])

    @property
    def raceway_ftf_hz(self) -> float:
        """Orbital frequency of balls that roll through the discrete raceways as well."""
        return float(self.values["raceway_ftf_hz"])

    @property
    def effective_radius_mm(self) -> Floats:
        """Effective radius r of each ball at the outer raceway."""
        return np.array(self.values["effective_radius_mm"])

    @property
    def ftf_hz(self) -> float:
        """Orbital frequency of the balls in rolling (fundamental train frequency)."""
        return float(self.values["ftf_hz"])

    @property
    def bpfo_hz(self) -> float:
        """Ball passing frequency of the outer ring."""
        return float(self.values["bpfo_hz"])

    @property
    def bpfi_hz(self) -> float:
        """Ball passing frequency of the inner ring."""
        return float(self.values["bpfi_hz"])

    @property
    def bsf_hz(self) -> float:
        """Rotational frequency of a ball in the frame of its orbit (ball spin frequency)."""
        return float(self.values["bsf_hz"])

    @property
    def speed_parameter_mm_rpm(self) -> float:
        """n·Dpw, speed of the inner ring times pitch diameter, mm/min."""
        return float(self.values["speed_parameter_mm_rpm"])

    @property
    def warnings(self) -> list[str]:
        """Warnings, for example of a contact pressure above 4.2 GPa."""
        return list(self.values["warnings"])

    @property
    def notes(self) -> list[str]:
        """What the ratings and the stiffness leave out."""
        return list(self.values["notes"])

    def data_balls(self) -> pd.DataFrame:
        """A row per ball, counted from 1."""
        import pandas as pd

        columns = [
            "ball_angle_deg",
            "inner_force_n",
            "outer_force_n",
            "effective_radius_mm",
            "inner_pressure_gpa",
            "outer_pressure_gpa",
            "ball_orbit_rpm",
            "ball_rotation_rpm",
        ]
        lists = {name: self.values[name] for name in columns}
        balls = pd.RangeIndex(1, len(self.ball_angle_deg) + 1, name="ball")
        return with_units(pd.DataFrame(lists, index=balls))

    def _tables(self) -> dict[str, pd.DataFrame]:
        return {"balls": self.data_balls()}

    def plot_loads(self, *, title: str | None = None) -> go.Figure:
        """Normal force of each ball at both raceways over ψ, 0 at the bottom.

        Parameters
        ----------
        title : str, optional
            Title above the figure.
        """
        series = {"outer raceway Fo": self.outer_force_n, "inner raceway Fi": self.inner_force_n}
        return polar(self.ball_angle_deg, series, "N", title)

    def plot_pressures(self, *, title: str | None = None) -> go.Figure:
        """Largest contact pressure of each ball at both raceways over ψ, 0 at the bottom.

        Parameters
        ----------
        title : str, optional
            Title above the figure.
        """
        series = {
            "outer raceway": self.outer_pressure_gpa,
            "inner raceway": self.inner_pressure_gpa,
        }
        return polar(self.ball_angle_deg, series, "GPa", title)

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Writes ``static.json``, as ``cageless static --out`` does. :func:`load` reads it.

        Returns
        -------
        Path
            The folder, which is created.
        """
        text = json.dumps(self.values, indent=2, ensure_ascii=False) + "\n"
        return folders.write(folder, "static.json", text.encode()).parent

    def __repr__(self) -> str:
        stress = max(self.inner_stress_max_gpa, self.outer_stress_max_gpa)
        return (
            f"<Static: ring at ({shown(self.ring_x_um)}, {shown(self.ring_y_um)}) µm, "
            f"{np.count_nonzero(self.inner_force_n)} of {len(self.inner_force_n)} balls loaded, "
            f"largest contact stress {stress:.3g} GPa>"
        )

    def _repr_html_(self) -> str:
        rows = [(k, v) for k, v in self.values.items() if not isinstance(v, list)]
        return table(rows, "Static equilibrium") + self.data_balls().to_html()

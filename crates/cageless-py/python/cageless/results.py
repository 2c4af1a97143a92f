"""Results of the computations of one case."""

from __future__ import annotations

import difflib
import json
import os
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _cageless, pages
from .verifications import Verification
from .errors import ColumnError
from .figures import figure
from .sections import table

if TYPE_CHECKING:
    import pandas as pd
    import plotly.graph_objects as go

__all__ = ["Design", "Run", "Static"]

Floats = npt.NDArray[np.float64]


class Run:
    """A simulated run.

    Arrays of the balls have the shape (times, balls), those of the ring (times,). They are
    not copies and cannot be written to. Units and meanings are those of the files of
    ``cageless run``: the tables of :meth:`data_balls` and so on are these files.
    """

    def __init__(self, run: _cageless.Run) -> None:
        self._run = run
        self._arrays = run.arrays()

    @cached_property
    def summary(self) -> dict[str, Any]:
        """``summary.json``: headline numbers, the case as run, warnings."""
        found: dict[str, Any] = json.loads(self._run.summary())
        return found

    @property
    def stopped(self) -> str | None:
        """Reason of an early stop; None if the run completed."""
        return self._run.stopped()

    @property
    def warnings(self) -> list[str]:
        """Warnings of the run."""
        return list(self.summary["warnings"])

    @cached_property
    def verification(self) -> Verification | None:
        """Numerical verification of the run; None without `verify=True`, or if it failed,
        which is a warning."""
        names = self._run.certified()
        return None if names is None else Verification(self.summary["verification"], names)

    @property
    def time_s(self) -> Floats:
        """Output times."""
        return self._arrays["ring"]["time_s"]

    @property
    def angle_rad(self) -> Floats:
        """ψ of the balls, continuous (not wrapped)."""
        return self._arrays["balls"]["angle_rad"]

    @property
    def gap_rad(self) -> Floats:
        """Gap to the ball ahead."""
        return self._arrays["balls"]["gap_rad"]

    def _column(self, of: str, column: str) -> npt.NDArray[Any]:
        columns = self._arrays[of]
        if column in columns:
            return columns[column]
        near = difflib.get_close_matches(str(column), columns, 1)
        hint = f"did you mean {near[0]}? " if near else ""
        listed = ", ".join(columns)
        raise ColumnError(f"{column!r} is not a column of {of}: {hint}its columns are {listed}")

    def balls(self, column: str) -> Floats:
        """A column of ``balls.parquet`` as (times, balls).

        Parameters
        ----------
        column : str
            ``angle_rad``, ``x_m``, ``y_m``, ``vx_m_s``, ``vy_m_s``, ``spin_rad_s``,
            ``orbit_speed_rad_s``, ``gap_rad``, ``effective_radius_m``, ``inner_force_n``,
            ``outer_force_n``, ``inner_slip_m_s`` or ``outer_slip_m_s``.

        Raises
        ------
        ColumnError
            If there is no such column; also a ``KeyError``.
        """
        return self._column("balls", column)

    def ring(self, column: str) -> Floats:
        """A column of ``ring.parquet``."""
        return self._column("ring", column)

    def collisions(self, column: str) -> npt.NDArray[Any]:
        """A column of ``collisions.parquet``."""
        return self._column("collisions", column)

    def data_balls(self) -> pd.DataFrame:
        """``balls.parquet``: a row per output time and ball."""
        import pandas as pd

        times, balls = self.angle_rad.shape
        frame = {
            "time_s": np.repeat(self.time_s, balls),
            "ball": np.tile(np.arange(1, balls + 1, dtype=np.int32), times),
        }
        # Views of arrays whose rows follow each other.
        frame |= {name: array.reshape(-1) for name, array in self._arrays["balls"].items()}
        return pd.DataFrame(frame, copy=False)

    def data_ring(self) -> pd.DataFrame:
        """``ring.parquet``: a row per output time."""
        import pandas as pd

        return pd.DataFrame(self._arrays["ring"], copy=False)

    def data_collisions(self) -> pd.DataFrame:
        """``collisions.parquet``: a row per contact of two balls."""
        import pandas as pd

        return pd.DataFrame(self._arrays["collisions"], copy=False)

    def data_summary(self) -> pd.Series[Any]:
        """The headline numbers of the summary."""
        import pandas as pd

        numbers = {k: v for k, v in self.summary.items() if isinstance(v, (int, float))}
        return pd.Series(numbers, name="summary")

    def _figure(self, name: str) -> go.Figure:
        return figure(self._run.figure(name))

    def plot_gaps(self) -> go.Figure:
        """Gaps between neighbours over time."""
        return self._figure("gaps")

    def plot_collisions(self) -> go.Figure:
        """Contacts between balls: where, when, how hard."""
        return self._figure("collisions")

    def plot_orbit_speed(self) -> go.Figure:
        """Orbital speed of the balls over ψ."""
        return self._figure("orbit_speed")

    def plot_slip(self) -> go.Figure:
        """Sliding speeds at the raceways."""
        return self._figure("slip")

    def plot_phase(self) -> go.Figure:
        """Phase portraits of a ball."""
        return self._figure("phase")

    def plot_loads(self) -> go.Figure:
        """Forces at the raceways."""
        return self._figure("loads")

    def plot_ring_orbit(self) -> go.Figure:
        """Orbit of the inner ring's centre."""
        return self._figure("ring_orbit")

    def plot_energy(self) -> go.Figure:
        """Energy balance."""
        return self._figure("energy")

    def plot_vibration(self) -> go.Figure:
        """Vibration of the outer ring, of a case with a housing."""
        return self._figure("vibration")

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Writes the report page of ``cageless run``, which works offline."""
        return pages.write(path, self._run.page())

    def __repr__(self) -> str:
        return f"<Run of {self.summary['case']['title']!r}, {self.time_s[-1]:g} s>"

    def _repr_html_(self) -> str:
        rows = [(str(name), value) for name, value in self.data_summary().items()]
        rows += [("warning", warning) for warning in self.warnings]
        found = table(rows, f"Run of {self.summary['case']['title']}")
        return found + (self.verification._repr_html_() if self.verification else "")


@dataclass(frozen=True)
class Static:
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
        return np.array(self.values["inner_semi_axes_mm"])

    @property
    def outer_semi_axes_mm(self) -> Floats:
        """Semi-axes of the contact ellipses at the outer raceway (balls, 2): along the rolling
        direction, across it."""
        return np.array(self.values["outer_semi_axes_mm"])

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
        found = self.values["stiffness_n_m"]
        return None if found is None else np.array(found)

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
        """n·dm, speed of the inner ring times pitch diameter, mm/min."""
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
        return pd.DataFrame(lists, index=balls)

    def _repr_html_(self) -> str:
        rows = [(k, v) for k, v in self.values.items() if not isinstance(v, list)]
        return table(rows, "Static equilibrium") + self.data_balls().to_html()


@dataclass(frozen=True)
class Design:
    """The analysis of a raceway; keys are those of ``cageless design --json``."""

    values: dict[str, Any]
    _design: _cageless.Design = field(repr=False, compare=False)

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

        return pd.DataFrame(self.values["curve"], dtype=float)

    def plot_curve(self) -> go.Figure:
        """θ over lC by Eq. (11), with the case's raceway and the limits."""
        return figure(self._design.figure("curve"))

    def plot_contact_track(self) -> go.Figure:
        """Contact track of the case's first raceway."""
        return figure(self._design.figure("contact_track"))

    def plot_surface(self) -> go.Figure:
        """Surface of the case's first raceway."""
        return figure(self._design.figure("surface"))

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Writes the report page of ``cageless design``, which works offline."""
        return pages.write(path, self._design.page())

    def _repr_html_(self) -> str:
        rows = [(k, v) for k, v in self.values.items() if not isinstance(v, (list, dict))]
        rows += [("reason", reason) for reason in self.reasons]
        return table(rows, "Design")

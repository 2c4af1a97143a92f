"""Runs and their results."""

from __future__ import annotations

import difflib
import json
import os
import zlib
from collections.abc import Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _cageless, folders, pages
from .arrays import Arrays, equal, footer, frozen
from .errors import ColumnError, InputError
from .figures import figure
from .section import table
from .tables import Tables
from .units import with_units
from .verifications import Verification

if TYPE_CHECKING:
    import pandas as pd
    import plotly.graph_objects as go

__all__ = ["Run"]

Floats = npt.NDArray[np.float64]


def _restored_run(
    arrays: Arrays,
    summary: str,
    report: bytes,
    stopped: str | None,
) -> Run:
    """A run from its pickle."""
    text = zlib.decompress(report).decode()
    return Run(_cageless.Run.restored(frozen(arrays), summary, text, stopped))


class Run(Tables):
    """A simulated run; two are equal if their cases and all of their results are.

    Arrays of the balls have the shape (times, balls), those of the ring (times,). They are
    not copies and cannot be written to. Units and meanings are those of the files of
    ``cageless run``: the tables of :meth:`data_balls` and so on are these files.
    """

    def __init__(self, run: _cageless.Run) -> None:
        self._run = run
        self._arrays = run.arrays()

    @classmethod
    def _load(cls, folder: Path) -> Run:
        return cls(_cageless.Run.load(os.fspath(folder)))

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Writes what ``cageless run --out`` writes: tables, ``summary.json`` and the page.
        :func:`load` reads it.

        Returns
        -------
        Path
            The folder, which is created.
        """
        path = folders.make(folder)
        self._run.save(os.fspath(path), *footer(self.summary))
        return path

    def _numbers(self) -> dict[str, Any]:
        """The summary without the time that the computation took."""
        return {name: value for name, value in self.summary.items() if name != "wall_s"}

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Run) or self._numbers() != other._numbers():
            return False
        return self.stopped == other.stopped and equal(self._arrays, other._arrays)

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        report = zlib.compress(self._run.report().encode(), 1)
        return (_restored_run, (self._arrays, self._run.summary(), report, self.stopped))

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
        return self._with_units(pd.DataFrame(frame, copy=False), "balls")

    def _with_units(self, frame: pd.DataFrame, name: str) -> pd.DataFrame:
        return with_units(frame, _cageless.run_units()[name])

    def _tables(self) -> dict[str, pd.DataFrame]:
        return {
            "balls": self.data_balls(),
            "ring": self.data_ring(),
            "collisions": self.data_collisions(),
        }

    def data_ring(self) -> pd.DataFrame:
        """``ring.parquet``: a row per output time."""
        import pandas as pd

        return self._with_units(pd.DataFrame(self._arrays["ring"], copy=False), "ring")

    def data_collisions(self) -> pd.DataFrame:
        """``collisions.parquet``: a row per contact of two balls."""
        import pandas as pd

        frame = pd.DataFrame(self._arrays["collisions"], copy=False)
        return self._with_units(frame, "collisions")

    def data_summary(self) -> pd.Series[Any]:
        """The headline numbers of the summary."""
        import pandas as pd

        found = self.summary.items()
        numbers = {k: v for k, v in found if type(v) in (int, float)}
        return pd.Series(numbers, name="summary")

    def _figure(
        self,
        name: str,
        balls: int | Sequence[int] | None,
        time_s: tuple[float, float] | None,
        title: str | None,
    ) -> go.Figure:
        chosen = [balls] if isinstance(balls, int) else balls
        if chosen is not None:
            count = self.angle_rad.shape[1]
            wrong = [ball for ball in chosen if not 1 <= ball <= count]
            if wrong or not chosen:
                given = wrong[0] if wrong else list(chosen)
                message = f"balls = {given} is not possible: it must be 1 to {count}"
                raise InputError(message, "balls")
        return figure(self._run.figure(name, chosen, time_s), title)

    def plot_gaps(
        self,
        *,
        balls: int | Sequence[int] | None = None,
        time_s: tuple[float, float] | None = None,
        title: str | None = None,
    ) -> go.Figure:
        """Gaps between neighbours over time.

        Parameters
        ----------
        balls : int or sequence of int, optional
            Balls to show, counted from 1; default: all.
        time_s : (float, float), optional
            First and last time to show; default: the whole run.
        title : str, optional
            Title above the figure.
        """
        return self._figure("gaps", balls, time_s, title)

    def plot_gap_map(
        self,
        *,
        time_s: tuple[float, float] | None = None,
        title: str | None = None,
    ) -> go.Figure:
        """Smallest gap of each pair of neighbours over time, as colours.

        Parameters
        ----------
        time_s : (float, float), optional
            First and last time to show; default: the whole run.
        title : str, optional
            Title above the figure.
        """
        return self._figure("gap_map", None, time_s, title)

    def plot_collisions(
        self,
        *,
        balls: int | Sequence[int] | None = None,
        time_s: tuple[float, float] | None = None,
        title: str | None = None,
    ) -> go.Figure:
        """Contacts between balls: where, when, how hard.

        Parameters
        ----------
        balls : int or sequence of int, optional
            Balls to show, counted from 1; default: all.
        time_s : (float, float), optional
            First and last time to show; default: the whole run.
        title : str, optional
            Title above the figure.
        """
        return self._figure("collisions", balls, time_s, title)

    def plot_orbit_speed(
        self,
        *,
        balls: int | Sequence[int] | None = None,
        time_s: tuple[float, float] | None = None,
        title: str | None = None,
    ) -> go.Figure:
        """Orbital speed of the balls over time.

        Parameters
        ----------
        balls : int or sequence of int, optional
            Balls to show, counted from 1; default: all.
        time_s : (float, float), optional
            First and last time to show; default: the whole run.
        title : str, optional
            Title above the figure.
        """
        return self._figure("orbit_speed", balls, time_s, title)

    def plot_slip(
        self,
        *,
        balls: int | Sequence[int] | None = None,
        time_s: tuple[float, float] | None = None,
        title: str | None = None,
    ) -> go.Figure:
        """Sliding speeds at the raceways.

        Parameters
        ----------
        balls : int or sequence of int, optional
            Balls to show, counted from 1; default: all.
        time_s : (float, float), optional
            First and last time to show; default: the whole run.
        title : str, optional
            Title above the figure.
        """
        return self._figure("slip", balls, time_s, title)

    def plot_phase(
        self,
        *,
        ball: int = 1,
        time_s: tuple[float, float] | None = None,
        title: str | None = None,
    ) -> go.Figure:
        """Phase portrait of a ball.

        Parameters
        ----------
        ball : int
            Ball to show, counted from 1.
        time_s : (float, float), optional
            First and last time to show; default: the whole run.
        title : str, optional
            Title above the figure.
        """
        return self._figure("phase", ball if ball != 1 else None, time_s, title)

    def plot_loads(
        self,
        *,
        ball: int = 1,
        time_s: tuple[float, float] | None = None,
        title: str | None = None,
    ) -> go.Figure:
        """Forces on a ball at the raceways over ψ.

        Parameters
        ----------
        ball : int
            Ball to show, counted from 1.
        time_s : (float, float), optional
            First and last time to show; default: the whole run.
        title : str, optional
            Title above the figure.
        """
        return self._figure("loads", ball if ball != 1 else None, time_s, title)

    def plot_load_profile(self, *, title: str | None = None) -> go.Figure:
        """Loads and pressures of all balls around the bearing, of the last orbits of the run.

        Parameters
        ----------
        title : str, optional
            Title above the figure.
        """
        return self._figure("load_profile", None, None, title)

    def plot_ring_orbit(
        self,
        *,
        time_s: tuple[float, float] | None = None,
        title: str | None = None,
    ) -> go.Figure:
        """Orbit of the inner ring's centre.

        Parameters
        ----------
        time_s : (float, float), optional
            First and last time to show; default: the whole run.
        title : str, optional
            Title above the figure.
        """
        return self._figure("ring_orbit", None, time_s, title)

    def plot_energy(self, *, title: str | None = None) -> go.Figure:
        """Energy balance of the whole run.

        Parameters
        ----------
        title : str, optional
            Title above the figure.
        """
        return self._figure("energy", None, None, title)

    def plot_vibration(
        self,
        *,
        time_s: tuple[float, float] | None = None,
        title: str | None = None,
    ) -> go.Figure:
        """Vibration of the outer ring, of a case with a housing; the spectrum is that of the whole
        run.

        Parameters
        ----------
        time_s : (float, float), optional
            First and last time to show; default: the whole run.
        title : str, optional
            Title above the figure.
        """
        return self._figure("vibration", None, time_s, title)

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

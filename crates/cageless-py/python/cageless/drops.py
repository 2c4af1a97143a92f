"""Drops of a rotor and their results."""

from __future__ import annotations

import difflib
import json
import os
import re
import zlib
from abc import ABC, abstractmethod
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _cageless, folders, pages
from .arrays import Arrays, equal, footer, frozen
from .errors import ColumnError, InputError
from .section import table
from .tables import Tables
from .units import with_units

if TYPE_CHECKING:
    import pandas as pd
    import plotly.graph_objects as go

__all__ = ["Drop"]


def _restored_drop(
    arrays: Arrays,
    summary: str,
    page: bytes,
    stopped: str | None,
) -> Drop:
    """A drop from its pickle."""
    text = zlib.decompress(page).decode()
    return Drop(_cageless.Drop.restored(frozen(arrays), summary, text, stopped))


class Studied(ABC):
    """A drop with what was asked for beside it."""

    @property
    @abstractmethod
    def summary(self) -> dict[str, Any]:
        """``summary.json``."""

    @property
    def warnings(self) -> list[str]:
        """What the numbers do not show, loads that no bearing endures, and what was asked for and
        could not be computed."""
        return list(self.summary["warnings"])

    @property
    def passes(self) -> bool | None:
        """Whether bearing and rotor keep their limits; None if the rotor has not touched."""
        found: bool | None = self.summary["passes"]
        return found

    @property
    def reasons(self) -> list[str]:
        """Every limit that is exceeded, or why the drop was not judged."""
        return list(self.summary["reasons"])

    @property
    def headline(self) -> str:
        """PASS or FAIL with its reasons."""
        return str(self.summary["headline"])

    def _repr_html_(self) -> str:
        rows = [(str(name), value) for name, value in scalars(self.summary).items()]
        rows += [("warning", warning) for warning in self.warnings]
        return table(rows, "Drop of a rotor")

    @property
    def backward_whirl_probability(self) -> float | None:
        """Fraction of the scattered drops that end in backward whirl, of several bearings in any;
        None without them."""
        found: float | None = self.summary.get("ensemble", {}).get("backward_whirl_probability")
        return found

    @property
    def backward_whirl_interval(self) -> tuple[float, float] | None:
        """95 % interval of that probability."""
        found = self.summary.get("ensemble", {}).get("backward_whirl_interval")
        return None if found is None else (found[0], found[1])


def scalars(result: dict[str, Any]) -> dict[str, Any]:
    """The scalar results of a drop."""
    return {k: v for k, v in result.items() if not isinstance(v, (list, dict))}


class Drop(Studied, Tables):
    """The drop of a rotor; two are equal if their cases and all of their results are.

    Units and meanings are those of the files of ``cageless drop``.
    """

    def __init__(self, drop: _cageless.Drop) -> None:
        self._drop = drop

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Drop) or self.summary != other.summary:
            return False
        return equal(self._arrays, other._arrays)

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        page = zlib.compress(self._drop.page().encode(), 1)
        return (_restored_drop, (self._arrays, self._drop.summary(), page, self.stopped))

    @classmethod
    def _load(cls, path: Path) -> Drop:
        return cls(_cageless.Drop.load(os.fspath(path)))

    def __repr__(self) -> str:
        return f"<Drop: {self.end_state} after {self.summary['end_s']:g} s>"

    @cached_property
    def _arrays(self) -> dict[str, dict[str, npt.NDArray[Any]]]:
        return self._drop.arrays()

    @cached_property
    def summary(self) -> dict[str, Any]:
        """``summary.json``: results, the case as run; under ``conventional``, ``ensemble`` and
        ``verification`` what was asked for beside the drop."""
        found: dict[str, Any] = json.loads(self._drop.summary())
        return found

    @property
    def stopped(self) -> str | None:
        """Reason of an early stop; None if the drop completed."""
        return self._drop.stopped()

    def _plot(self, name: str, title: str | None) -> go.Figure:
        """A figure of the page."""
        from .figures import figure

        found = re.search(f'id="{name}-spec">(.*?)</script>', self._drop.page())
        if found is None:
            raise InputError(f"the page of this drop has no figure {name!r}")
        return figure(found[1], title)

    def plot_orbit(self, *, title: str | None = None) -> go.Figure:
        """Path of the journal in the bore of the inner ring."""
        return self._plot("orbit", title)

    def plot_displacement(self, *, title: str | None = None) -> go.Figure:
        """Path of the journal from the centre of the stator, with its clearance."""
        return self._plot("displacement", title)

    def plot_forces(self, *, title: str | None = None) -> go.Figure:
        """Forces of the rotor on the inner ring and of the balls on the outer ring over time."""
        return self._plot("forces", title)

    def plot_spin_up(self, *, title: str | None = None) -> go.Figure:
        """Speeds of rotor and inner ring over time."""
        return self._plot("spin-up", title)

    def plot_whirl(self, *, title: str | None = None) -> go.Figure:
        """Whirl frequency and contact over time."""
        return self._plot("whirl", title)

    def plot_heat(self, *, title: str | None = None) -> go.Figure:
        """Heat of each interface."""
        return self._plot("heat-of-the-interfaces", title)

    @property
    def end_state(self) -> str:
        """What the rotor does at the end: ``falling``, ``settling``, ``at-rest``, ``pendulum``, ``bouncing``,
        ``forward-whirl`` or ``backward-whirl``."""
        return str(self.summary["end_state"])

    def _column(self, of: str, column: str) -> npt.NDArray[Any]:
        columns = self._arrays[of]
        if column in columns:
            return columns[column]
        near = difflib.get_close_matches(str(column), columns, 1)
        hint = f"did you mean {near[0]}? " if near else ""
        listed = ", ".join(columns)
        raise ColumnError(f"{column!r} is not a column of {of}: {hint}its columns are {listed}")

    @property
    def time_s(self) -> npt.NDArray[np.float64]:
        """Output times."""
        return self._arrays["rotor"]["time_s"]

    def rotor(self, column: str) -> npt.NDArray[np.float64]:
        """A column of ``rotor.parquet``.

        Raises
        ------
        ColumnError
            If there is no such column; also a ``KeyError``.
        """
        return self._column("rotor", column)

    def balls(self, column: str) -> npt.NDArray[np.float64]:
        """A column of ``balls.parquet`` as (times, balls)."""
        return self._column("balls", column)

    def ring(self, column: str) -> npt.NDArray[np.float64]:
        """A column of ``ring.parquet``."""
        return self._column("ring", column)

    def collisions(self, column: str) -> npt.NDArray[Any]:
        """A column of ``collisions.parquet``."""
        return self._column("collisions", column)

    def _table(self, of: str) -> pd.DataFrame:
        import pandas as pd

        return with_units(pd.DataFrame(self._arrays[of]), _cageless.run_units()[of])

    def data_rotor(self) -> pd.DataFrame:
        """``rotor.parquet``: a row per output time."""
        return self._table("rotor")

    def data_ring(self) -> pd.DataFrame:
        """``ring.parquet``: a row per output time."""
        return self._table("ring")

    def data_collisions(self) -> pd.DataFrame:
        """``collisions.parquet``: a row per contact of two balls."""
        return self._table("collisions")

    def data_balls(self) -> pd.DataFrame:
        """``balls.parquet``: a row per output time and ball."""
        import pandas as pd

        times, balls = self.balls("angle_rad").shape
        frame = {
            "time_s": np.repeat(self._arrays["ring"]["time_s"], balls),
            "ball": np.tile(np.arange(1, balls + 1, dtype=np.int32), times),
        }
        frame |= {name: array.reshape(-1) for name, array in self._arrays["balls"].items()}
        return with_units(pd.DataFrame(frame), _cageless.run_units()["balls"])

    def data_windows(self) -> pd.DataFrame:
        """Whirl of the rotor and collisions between balls, a row per 5 ms."""
        import pandas as pd

        return pd.DataFrame(self.summary["windows"])

    def data_drops(self) -> pd.DataFrame:
        """The scattered drops: what was drawn for each, and its scalar results. Empty without
        ``samples``."""
        import pandas as pd

        rows = []
        for drop in self.summary.get("ensemble", {}).get("drops", []):
            drawn = {k: v for k, v in drop.items() if k != "result"}
            rows.append(drawn | scalars(drop["result"]))
        return pd.DataFrame(rows)

    def data_verification(self) -> pd.DataFrame:
        """Judgement of each result by a verified drop. Empty without ``verify=True``."""
        import pandas as pd

        frame = pd.DataFrame(self.summary.get("verification", {}).get("numbers", []))
        return frame.set_index("name") if len(frame) else frame

    def _tables(self) -> dict[str, pd.DataFrame]:
        tables = {
            "rotor": self.data_rotor(),
            "balls": self.data_balls(),
            "ring": self.data_ring(),
            "collisions": self.data_collisions(),
            "windows": self.data_windows(),
        }
        if "ensemble" in self.summary:
            tables["drops"] = self.data_drops()
        return tables

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Writes what ``cageless drop --out`` writes: tables, ``summary.json`` and the page.
        :func:`load` reads it.

        Returns
        -------
        Path
            The folder, which is created.
        """
        path = folders.make(folder)
        self._drop.save(os.fspath(path), *footer(self.summary))
        return path

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Writes the page of ``cageless drop --out``."""
        return pages.write(path, self._drop.page())

"""Sweeps: many variants of a case, and what is to be seen in them."""

from __future__ import annotations

import json
import os
import tempfile
import zlib
from collections.abc import Callable, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _cageless, folders, pages
from .figures import figure
from .plan import Plan, read
from .section import table
from .tables import Tables
from .units import with_units

if TYPE_CHECKING:
    import pandas as pd
    import plotly.graph_objects as go
    from distributed import Client

__all__ = ["SweepReport", "SweepResult", "merge", "report", "sweep"]

NAME = "sweep.parquet"


def sweep(
    plan: Plan | str | os.PathLike[str],
    *,
    out: str | os.PathLike[str] | None = None,
    threads: int | None = None,
    shard: tuple[int, int] | None = None,
    progress: Callable[[int, int], object] | None = None,
    client: Client | None = None,
    shared: bool = False,
    task_seconds: float = 5.0,
) -> SweepResult:
    """Computes the variants of a plan.

    Nothing is lost: what was computed is kept in the folder `out`, and the same call goes
    on from there, on this machine or on a cluster. The bytes of the result are the same
    however it was computed.

    Parameters
    ----------
    plan : Plan or path
        Computations.
    out : path, optional
        Folder of the result, ``sweep.parquet``; one that is removed with the result's last
        reference if left out.
    threads : int, optional
        Threads on this machine; as many as there are cores if left out.
    shard : (int, int), optional
        Number I of N parts, from 1.
    progress : callable, optional
        Called with the variants done and their total, now and then.
    client : distributed.Client, optional
        Computes on the cluster of this client, of Dask, and shows Dask's own progress.
    shared : bool
        `out` is a folder that all workers see: they write there, and no rows travel.
    task_seconds : float
        Time that a task of the cluster should take.

    Returns
    -------
    SweepResult

    Raises
    ------
    InputError
        If `out` belongs to another plan or cannot be written to.

    Examples
    --------
    >>> import cageless
    >>> case = cageless.Case.from_toml(cageless.template())
    >>> loads = cageless.span(500.0, 3000.0, 6)
    >>> plan = cageless.Plan(case=case, compute=["static"],
    ...                      grid={"operation.radial_load_n": loads})
    >>> result = cageless.sweep(plan)
    >>> result.data_variants()["static_ring_y_um"].is_monotonic_decreasing
    True
    """
    plan = read(plan)
    temporary = tempfile.TemporaryDirectory(prefix="cageless-") if out is None else None
    folder = Path(temporary.name if temporary is not None else os.fspath(out or ""))
    if client is not None:
        from .cluster import compute

        if shard is not None:
            raise ValueError("shard goes with threads of this machine, not with a client")
        path = folder / NAME
        compute(plan, path, client, shared=shared, task_seconds=task_seconds)
    else:
        name = NAME if shard is None else "sweep.shard-{}-of-{}.parquet".format(*shard)
        path = folder / name
        plan._sweep.run(os.fspath(path), shard, threads, progress)
    return SweepResult(path, _temporary=temporary)


def merge(
    shards: Sequence[str | os.PathLike[str]], out: str | os.PathLike[str]
) -> SweepResult:
    """Joins the files of shards into ``sweep.parquet`` in the folder `out`.

    Raises
    ------
    InputError
        If a shard is missing, there twice, or of another plan, or if `out` holds the result of
        another plan.
    """
    path = Path(out) / NAME
    path.parent.mkdir(parents=True, exist_ok=True)
    _cageless.merge([os.fspath(shard) for shard in shards], os.fspath(path))
    return SweepResult(path)


def _unpickled(content: bytes) -> SweepResult:
    """A sweep from its pickle, in a folder that is removed with its last reference."""
    temporary = tempfile.TemporaryDirectory(prefix="cageless-")
    path = Path(temporary.name) / NAME
    path.write_bytes(content)
    return SweepResult(path, _temporary=temporary)


class SweepResult(Tables):
    """A finished sweep; two are equal if their files are.

    A pickle holds the whole file, so that it can be read on another machine.

    Parameters
    ----------
    path : path
        ``sweep.parquet``, or the folder with it.
    """

    def __init__(
        self,
        path: str | os.PathLike[str],
        *,
        _temporary: tempfile.TemporaryDirectory[str] | None = None,
    ) -> None:
        path = Path(path)
        self.path = path / NAME if path.is_dir() else path
        self._temporary = _temporary

    def __reduce__(self) -> tuple[Any, ...]:
        return (_unpickled, (self.path.read_bytes(),))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, SweepResult) and (
            self.path.read_bytes() == other.path.read_bytes()
        )

    __hash__ = None  # type: ignore[assignment]

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Writes a copy of the file, ``sweep.parquet``. :func:`load` reads it.

        Returns
        -------
        Path
            The folder, which is created.
        """
        return folders.write(folder, NAME, self.path.read_bytes()).parent

    def _tables(self) -> dict[str, pd.DataFrame]:
        return {"variants": self.data_variants()}

    @cached_property
    def _contents(self) -> tuple[dict[str, Any], dict[str, str], dict[str, str]]:
        return _cageless.read_table(os.fspath(self.path))

    @property
    def columns(self) -> list[str]:
        """Names of the columns."""
        return list(self._contents[0])

    @property
    def units(self) -> dict[str, str]:
        """Unit of each column; empty if there is none."""
        return self._contents[1]

    @property
    def footer(self) -> dict[str, str]:
        """``version``, ``isa``, ``seed``, ``variants``, ``plan``."""
        return self._contents[2]

    @property
    def plan(self) -> Plan:
        """The plan, from the result."""
        return Plan.from_toml(self.footer["plan"])

    def array(self, column: str) -> Any:
        """A column as an array of numpy, NaN where there is no number; texts and lists as
        a list."""
        return self._contents[0][column]

    def data_variants(self) -> pd.DataFrame:
        """A row per variant."""
        import pandas as pd

        frame = pd.DataFrame(self._contents[0], copy=False)
        frame.attrs["units"] = self.units
        return frame

    def data_failed(self) -> pd.DataFrame:
        """The variants that failed, with their reasons."""
        frame = self.data_variants()
        return frame[frame["reason"].notna()]

    def report(self, low: Sequence[str] = (), high: Sequence[str] = ()) -> SweepReport:
        """Sensitivity and best variants; see :func:`report`."""
        return report(self.path, low=low, high=high)

    def __len__(self) -> int:
        return len(self.array("variant"))

    def __repr__(self) -> str:
        return f"<Sweep of {len(self)} variants in {self.path}>"

    def _repr_html_(self) -> str:
        return str(self.data_variants().to_html(max_rows=20))


def report(
    result: SweepResult | str | os.PathLike[str],
    *,
    low: Sequence[str] = (),
    high: Sequence[str] = (),
) -> SweepReport:
    """Analyses a finished sweep, as ``cageless report`` does.

    Parameters
    ----------
    result : SweepResult or path
        The result, its file or its folder.
    low, high : sequence of str
        Columns of which less, or more, is better.

    Returns
    -------
    SweepReport
    """
    found = result if isinstance(result, SweepResult) else SweepResult(result)
    return SweepReport(_cageless.analyse(os.fspath(found.path), list(low), list(high)))


def _restored_report(numbers: bytes) -> SweepReport:
    """A report from its pickle."""
    return SweepReport(_cageless.Report.restored(zlib.decompress(numbers).decode()))


class SweepReport(Tables):
    """Report of a finished sweep."""

    def __init__(self, report: _cageless.Report) -> None:
        self._report = report

    def __reduce__(self) -> tuple[Any, ...]:
        return (_restored_report, (zlib.compress(self._report.numbers().encode(), 1),))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, SweepReport) and self.values == other.values

    __hash__ = None  # type: ignore[assignment]

    def _tables(self) -> dict[str, pd.DataFrame]:
        return {"shares": self.data_shares(), "best": self.data_best()}

    def __repr__(self) -> str:
        inputs, outputs = len(self.values["inputs"]), len(self.outputs)
        return (
            f"<SweepReport: {self.values['variants']} variants, {self.values['failed']} failed, "
            f"{outputs} outputs over {inputs} inputs>"
        )

    @cached_property
    def values(self) -> dict[str, Any]:
        """``report.json``."""
        found: dict[str, Any] = json.loads(self._report.numbers())
        return found

    @property
    def outputs(self) -> list[str]:
        """Outputs that vary."""
        return [str(output["quantity"]["name"]) for output in self.values["outputs"]]

    def data_shares(self) -> pd.DataFrame:
        """Share of the variance of each output (rows) that each input explains alone."""
        import pandas as pd

        inputs = [each["name"] for each in self.values["inputs"]]
        rows = {each["quantity"]["name"]: each["shares"] for each in self.values["outputs"]}
        frame = pd.DataFrame.from_dict(rows, orient="index", columns=inputs, dtype=float)
        # Fractions, whatever the inputs are measured in.
        return with_units(frame.rename_axis(index="output"), dict.fromkeys(inputs, ""))

    def data_best(self) -> pd.DataFrame:
        """The best variants by each output of which it can be said what is better."""
        import pandas as pd

        rows = [
            {"by": best["quantity"]["name"], "high": best["high"]}
            | {"variant": each["variant"], "value": each["value"]}
            for best in self.values["best"]
            for each in best["variants"]
        ]
        return with_units(pd.DataFrame(rows, columns=["by", "high", "variant", "value"]))

    def plot_shares(self, *, title: str | None = None) -> go.Figure:
        """Sensitivity (main effects)."""
        return figure(self._report.shares(), title)

    def plot_effects(self, output: str, *, title: str | None = None) -> go.Figure:
        """Means of an output over the inputs that explain most of it."""
        return figure(self._report.effects(output), title)

    def plot_map(self, output: str, *, title: str | None = None) -> go.Figure:
        """Mean of an output over the two inputs that explain most of it."""
        return figure(self._report.map(output), title)

    def write(self, path: str | os.PathLike[str]) -> Path:
        """Writes the report page of ``cageless report``, which works offline."""
        return pages.write(path, self._report.page())

    def _repr_html_(self) -> str:
        rows: list[tuple[str, object]] = [
            ("variants", self.values["variants"]),
            ("failed", self.values["failed"]),
        ]
        return table(rows, self.values["title"]) + str(self.data_shares().to_html())

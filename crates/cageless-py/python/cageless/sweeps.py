"""Sweeps: many variants of a case, and their analysis."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from . import _cageless
from .arguments import background, checked, refused
from .plan import Plan, read
from .results import NAME, SweepReport, SweepResult

if TYPE_CHECKING:
    from distributed import Client

__all__ = ["merge", "report", "sweep"]


@checked
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

    Args:
        plan: Computations.
        out: Folder of the result, ``sweep.parquet``; one that is removed with the result's last
            reference if left out.
        threads: Threads on this machine; as many as there are cores if left out.
        shard: Number I of N parts, from 1.
        progress: Called with the variants done and their total, now and then.
        client: Computes on the cluster of this client, of Dask, and shows Dask's own progress.
        shared: `out` is a folder that all workers see: they write there, and no rows travel.
        task_seconds: Time that a task of the cluster should take.

    Raises:
        InputError: If `out` belongs to another plan or cannot be written to.

    Examples:
        >>> import cageless
        >>> case = cageless.Case.from_toml(cageless.template())
        >>> loads = cageless.span(500.0, 3000.0, 6)
        >>> plan = cageless.Plan(case=case, compute=["static"],
        ...                      grid={"operation.radial_load_n": loads})
        >>> result = cageless.sweep(plan)
        >>> result.data_variants()["static_ring_y_um"].is_monotonic_decreasing
        True
    """
    if client is not None and not hasattr(client, "submit"):
        allowed = f"a client of Dask, distributed.Client({client!r}) say"
        raise refused("client", client, allowed)
    plan = read(plan)
    temporary = tempfile.TemporaryDirectory(prefix="cageless-") if out is None else None
    folder = Path(temporary.name if temporary is not None else os.fspath(out or ""))
    if client is not None:
        from .cluster import compute

        if shard is not None:
            raise ValueError("shard needs threads of this machine, not with a client")
        path = folder / NAME
        compute(plan, path, client, shared=shared, task_seconds=task_seconds)
    else:
        name = NAME if shard is None else "sweep.shard-{}-of-{}.parquet".format(*shard)
        path = folder / name
        tell = None if progress is None else lambda at, _: progress(*map(int, at.split()))
        plan._file.run(os.fspath(path), shard, *background(threads, tell))
    return SweepResult(path, _temporary=temporary)


@checked
def merge(
    shards: Sequence[str | os.PathLike[str]], out: str | os.PathLike[str]
) -> SweepResult:
    """Joins the files of shards into ``sweep.parquet`` in the folder `out`.

    Raises:
        InputError: If a shard is missing, there twice, or of another plan, or if `out` holds the
            result of another plan.
    """
    path = Path(out) / NAME
    path.parent.mkdir(parents=True, exist_ok=True)
    _cageless.merge([os.fspath(shard) for shard in shards], os.fspath(path))
    return SweepResult(path)


@checked
def report(
    result: SweepResult | str | os.PathLike[str],
    *,
    low: str | Sequence[str] = (),
    high: str | Sequence[str] = (),
) -> SweepReport:
    """Analyses a finished sweep, as ``cageless report`` does.

    Args:
        result: The result, its file or its folder.
        low, high: Columns of which less, or more, is better.
    """
    found = result if isinstance(result, SweepResult) else SweepResult(result)
    return found.report(low, high)

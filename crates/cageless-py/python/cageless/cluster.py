"""Sweeps on a cluster of Dask.

Dask schedules: it hands the ranges to workers, gives those of a worker that died to
others, and shows its progress. A range is a pure function of the plan, so that it does not
matter how often and where it is computed.
"""

from __future__ import annotations

import os
import tempfile
import threading
import time
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _cageless
from .errors import CagelessError

if TYPE_CHECKING:
    from distributed import Client

    from .plan import Plan

__all__ = ["compute"]

#: The first task tells how long variants take; it should not take much longer than this.
PROBE_SECONDS = 0.5
#: Tasks at most: a scheduler keeps all of them in memory.
TASKS_MAX = 100_000

_plans: dict[str, Any] = {}


def work(plan: str, start: int, end: int, part: str | None) -> tuple[int, bytes | None]:
    """Computes a range on a worker, into the file `part` or into bytes."""
    found = _plans.get(plan)
    if found is None:
        # Of the sweeps that a worker has seen, the last is enough.
        _plans.clear()
        found = _plans[plan] = _cageless.Sweep.parse(plan, "plan", ".")
    if part is not None:
        found.write_part(start, end, part)
        return start, None
    with tempfile.TemporaryDirectory(prefix="cageless-") as folder:
        path = Path(folder) / "part.parquet"
        found.write_part(start, end, os.fspath(path))
        return start, path.read_bytes()


def probe(plan: str, start: int, end: int, together: int) -> float:
    """Seconds per variant, from the first few of a range."""
    began, size, at = time.perf_counter(), together, start
    while at < end and time.perf_counter() - began < PROBE_SECONDS:
        work(plan, at, min(at + size, end), None)
        at, size = min(at + size, end), 2 * size
    return (time.perf_counter() - began) / (at - start)


def pieces(
    missing: list[tuple[int, int]], size: int
) -> Iterator[tuple[int, int]]:
    """Cuts ranges."""
    for start, end in missing:
        for at in range(start, end, size):
            yield at, min(at + size, end)


def check(client: Client) -> None:
    """Refuses workers that lack the package: none of its functions would start on them, and the
    cluster would wait for ever."""
    # A function of the standard library, which every worker has.
    found = client.run(find_spec, "cageless", on_error="return")
    lacking = [name for name, spec in found.items() if spec is None or isinstance(spec, Exception)]
    if lacking:
        listed = ", ".join(lacking[:3]) + (f" and {len(lacking) - 3} more" if len(lacking) > 3 else "")
        raise CagelessError(
            f"the package cageless is not installed on {len(lacking)} of {len(found)} workers of Dask "
            f"({listed}): pip install the same wheel there"
        )


def compute(
    plan: Plan, result: Path, client: Client, *, shared: bool, task_seconds: float
) -> None:
    """Computes what is missing of a result on the workers of a client."""
    from distributed import as_completed

    check(client)
    collection = plan._file.collect(os.fspath(result.absolute()))
    futures: list[Any] = []
    try:
        missing = collection.missing()
        if missing:
            text, together = plan.to_toml(), plan._file.together()
            # Travels once to each worker, not with each task, and again to those that come.
            known = client.submit(str, text, pure=False)
            first, last = missing[0]
            seconds = client.submit(probe, known, first, last, together, pure=False).result()
            left = sum(end - start for start, end in missing)
            size = max(task_seconds / max(seconds, 1e-9), left / TASKS_MAX)
            size = max(together, int(size) // together * together)
            for start, end in pieces(missing, size):
                part = os.fspath(collection.part(start)) if shared else None
                futures.append(client.submit(work, known, start, end, part, pure=False))
            show(futures)
            for batch in as_completed(futures, with_results=True).batches():
                for future, (start, part) in batch:
                    if part is not None:
                        collection.add(start, part)
                    # Its memory on the cluster is free again.
                    future.release()
        collection.finish()
    finally:
        client.cancel(futures)
        collection.close()


def show(futures: list[Any]) -> None:
    """Dask's progress: a widget in a notebook, a bar on a terminal."""
    import sys

    from distributed import progress
    from distributed.utils import is_kernel

    if is_kernel():
        from IPython.display import display

        display(progress(futures, notebook=True))
    elif sys.stderr.isatty():
        # On a terminal it waits for the end, which is not for the thread that collects.
        bar = threading.Thread(target=progress, args=(futures,), kwargs={"notebook": False})
        bar.daemon = True
        bar.start()

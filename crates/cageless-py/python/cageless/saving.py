"""Results from folders."""

from __future__ import annotations

import json
import os
from pathlib import Path

from .case import Case
from .errors import InputError
from .folders import read
from .designs import Design
from .drops import Drop
from .rotor_drops import RotorDrop
from .runs import Run
from .statics import Static
from .searches import SearchResult
from .sweeps import NAME as SWEEP
from .sweeps import SweepResult
from .tolerances import ToleranceResult

__all__ = ["load"]

Result = Run | Drop | RotorDrop | Static | Design | SearchResult | ToleranceResult | SweepResult

#: The file that tells which result a folder holds.
KINDS = {
    "summary.json": "run",
    SWEEP: "sweep",
    "tolerance.json": "tolerance",
    "search.json": "search",
    "design.json": "design",
    "static.json": "static",
}


def load(path: str | os.PathLike[str]) -> Result:
    """Reads a result that ``save`` wrote, or the command with ``--out``.

    Parameters
    ----------
    path : path
        The folder, or the file ``sweep.parquet``.

    Returns
    -------
    Run, Drop, RotorDrop, SweepResult, ToleranceResult, SearchResult, Design or Static
        Equal to what was saved.

    Raises
    ------
    InputError
        If there is no result, more than one, or a damaged one.

    Examples
    --------
    >>> import cageless, tempfile
    >>> case = cageless.Case.from_toml(cageless.template(), {"solver.duration_s": 0.002})
    >>> run = case.run()
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     run.save(folder) == Path(folder)
    ...     cageless.load(folder) == run
    True
    True
    """
    path = Path(path)
    if path.is_file():
        return SweepResult(path)
    found = {name: kind for name, kind in KINDS.items() if (path / name).is_file()}
    if not found:
        what = "holds no result" if path.is_dir() else "is not there"
        raise InputError(f"{path}: {what}: one of {', '.join(KINDS)} is expected in a folder")
    if (path / "bearing-1" / "summary.json").is_file():
        return RotorDrop._load(path)
    dropped = (path / "rotor.parquet").is_file()
    if "run" in found.values() and not dropped and not (path / "report.json").is_file():
        message = f"{path}: is no run that load reads"
        if (path / "bearing-1").is_dir():
            message += (
                "; of a drop into several bearings it reads what RotorDrop.save wrote, and the "
                "command writes tables as Parquet files"
            )
        raise InputError(message)
    if len(found) > 1:
        listed = ", ".join(found)
        raise InputError(f"{path}: holds several results: {listed}; take a folder for each")
    [(name, kind)] = found.items()
    if kind == "run":
        return Drop._load(path) if dropped else Run._load(path)
    if kind == "sweep":
        return SweepResult(path)
    text = read(path / name)
    try:
        values = json.loads(text)
    except ValueError as error:
        raise InputError(f"{path / name}: cannot be read: {error}") from error
    if kind == "static":
        return Static(values)
    if kind == "tolerance":
        return ToleranceResult._restored(text)
    if kind == "search":
        return _search(path, values)
    if "search" in values:
        return _search(path, {"search": values["search"], "refusal": None})
    return Design._restored(text, read(path / "report.json"))


def _search(path: Path, values: dict[str, object]) -> SearchResult:
    case = Case.from_file(path / "case.toml")
    refusal = values["refusal"]
    numbers = json.dumps(values["search"])
    return SearchResult._restored(case, numbers, None if refusal is None else str(refusal))

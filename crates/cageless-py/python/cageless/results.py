"""The kinds of results, and results from folders."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from . import _cageless, frames
from . import attributes as of
from .arguments import checked, names
from .errors import InputError, UnphysicalError
from .result import KINDS, VALUES, Result
from .sections import Raceway

if TYPE_CHECKING:
    import pandas as pd

    from .case import Case
    from .plan import Plan

__all__ = ["Design", "Drop", "RingComparison", "Run", "SearchResult", "Static", "SweepReport"]
__all__ += ["SweepResult", "ToleranceResult", "Verification", "load"]

R = TypeVar("R", bound=Result)

#: File of a sweep.
NAME = VALUES["sweep"]
#: What folders hold beside values and tables.
FILES: tuple[str, ...] = ("report.html", "report.json", "case.toml", "rotor.toml", "recommended.toml")
FILES += ("static.csv", "design.csv")


class Verification(Result):
    """Which results of a run or a drop are converged, from perturbed starts and half the step."""

    kind = "verification"

    def _headline(self) -> str:
        counts = ("converged", "statistical", "step_biased")
        known = self._known
        return ", ".join(f"{known[name]} {name.replace('_', '-')}" for name in counts if name in known)


class Run(of.RunAttributes, Result):
    """A simulated run; units and meanings are those of the files of ``cageless run``."""

    kind = "run"
    _parts = {"verification": Verification}


class Drop(of.DropAttributes, Result):
    """The drop of a rotor. Each of ``bearings`` is a drop with the results, tables and figures of that
    bearing; of an only bearing the drop has them as well. ``conventional``, ``ensemble`` and
    ``verification`` are None unless they were asked for."""

    kind = "drop"


Drop._parts = {"bearings": Drop, "conventional": Drop, "verification": Verification}


class Static(of.StaticAttributes, Result):
    """A static equilibrium and the ratings of the bearing; arrays are over the balls."""

    kind = "static"
    _shown = ("inner_pressure_max_mpa", "outer_pressure_max_mpa", "l10r_h")


class Design(of.DesignAttributes, Result):
    """The analysis of a raceway: limits, critical gap, verdict, recommendation."""

    kind = "design"

    def data_axial(self) -> pd.DataFrame:
        """Lag and contact angle with a row per axial load and tilt, of a design with ``axial``."""
        axial = self.values.get("axial")
        if axial is None:
            raise InputError("the design has no axial loads: case.design(axial=True) has")
        return frames.lists(axial)


class SearchResult(of.SearchAttributes, Result):
    """The best raceway for a range of speeds and loads."""

    kind = "search"

    @property
    def _searched(self) -> Case:
        """The case that was searched."""
        from .case import Case

        return Case.from_toml(self._core.seed()["case.toml"])

    @property
    def _chosen(self) -> dict[str, Any] | None:
        """The recommended structure: with ``benefit`` the one that helps most."""
        judged: dict[str, Any] = self.values.get("benefit") or self.values
        return judged.get("recommended")

    @property
    def _why_none(self) -> str:
        """The reason without a recommendation."""
        none = self.values["recommended"] is None
        return str(self.values["findings"][0] if none else self.values["benefit"]["answer"])

    @property
    def stopped(self) -> str | None:
        """Why nothing is recommended, with the title of the case; None if something is."""
        if self._chosen:
            return None
        title = self._searched.title
        return f"{title}: {self._why_none}" if title else self._why_none

    @property
    def passes(self) -> bool | None:
        """Whether the recommended structure passes the verdict of ``design`` at every speed and
        load; None if there is none."""
        verdicts = self.values["recommended_verdicts"]
        return all(each["passes"] for each in verdicts) if verdicts else None

    @property
    def recommended(self) -> tuple[Raceway, ...]:
        """The recommended structure; empty if there is none."""
        return self.case.raceways if self._chosen else ()

    @property
    def case(self) -> Case:
        """The case with the recommended structure, to be run; an ``UnphysicalError`` if there is none."""
        from .case import Case

        if self._chosen is None:
            raise UnphysicalError(self._why_none)
        case = Case.from_toml(self._core.seed()["recommended.toml"])
        return case.replace({"title": f"{case.title or 'Case'}: recommended raceway"})

    def data_map(self, k: int = 0) -> pd.DataFrame:
        """Map `k` over lC and θ with a row per cell."""
        return frames.cells(self.values["maps"][k])

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, SearchResult)
            and self._searched == other._searched
            and super().__eq__(other)
        )

    __hash__ = None  # type: ignore[assignment]


class ToleranceResult(of.ToleranceAttributes, Result):
    """Tolerance analysis of a raceway."""

    kind = "tolerance"

    @property
    def decides(self) -> list[str]:
        """Parameters that alone, within their tolerance, change the verdict of the nominal bearing;
        the most certain first."""
        nominal = self.values["nominal_passes"]

        def changed(row: dict[str, Any]) -> float:
            share: float = row["passed"] / row["trials"]
            return 1.0 - share if nominal else share

        rows = [row for row in self.values["influences"] if changed(row) > 0.0]
        return [str(row["name"]) for row in sorted(rows, key=changed, reverse=True)]


class RingComparison(of.ComparisonAttributes, Result):
    """Outer rings in steady operation with the same draws of balls, their differences and benefits."""

    kind = "comparison"


class SweepReport(of.AnalysisAttributes, Result):
    """The analysis of a finished sweep: sensitivity and best variants."""

    kind = "analysis"

    @property
    def outputs(self) -> list[str]:
        """Outputs that vary."""
        return [str(output["quantity"]["name"]) for output in self.values["outputs"]]

    def _headline(self) -> str:
        inputs, variants, failed = (self.values[k] for k in ("inputs", "variants", "failed"))
        return (
            f"{variants} variants, {failed} failed, "
            f"{len(self.outputs)} outputs over {len(inputs)} inputs"
        )


class SweepResult(Result):
    """A finished sweep; ``values`` are the entries of the footer of its file, in which all of it is.

    A pickle holds the whole file, so that it can be read on another machine.

    Args:
        path: ``sweep.parquet``, or the folder with it.
    """

    kind = "sweep"
    path: Path

    def __init__(
        self,
        path: str | os.PathLike[str],
        *,
        _temporary: tempfile.TemporaryDirectory[str] | None = None,
    ) -> None:
        super().__init__(None)
        path = Path(path)
        vars(self)["path"] = path / NAME if path.is_dir() else path
        self._temporary = _temporary

    @cached_property
    def _contents(self) -> tuple[dict[str, Any], dict[str, str], dict[str, str]]:
        found: tuple[dict[str, Any], dict[str, str], dict[str, str]]
        found = _cageless.read_table(os.fspath(self.path))
        return found

    @cached_property
    def values(self) -> dict[str, Any]:
        """``version``, ``isa``, ``seed``, ``variants``, ``plan``."""
        return dict(self._contents[2])

    @property
    def columns(self) -> list[str]:
        """Names of the columns."""
        return list(self._contents[0])

    @property
    def units(self) -> dict[str, str]:
        """Unit of each column; empty if there is none."""
        return self._contents[1]

    @property
    def plan(self) -> Plan:
        """The plan, from the result."""
        from .plan import Plan

        return Plan.from_toml(self.values["plan"])

    @cached_property
    def _arrays(self) -> dict[str, dict[str, Any]]:
        return {"variants": self._contents[0]}

    @property
    def _frames(self) -> frames.Frames:
        return {"variants": self.data_variants}

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

    def report(  # type: ignore[override]
        self, low: str | Sequence[str] = (), high: str | Sequence[str] = ()
    ) -> SweepReport:
        """Sensitivity and best variants; see :func:`cageless.report`."""
        path = os.fspath(self.path)
        return SweepReport(_cageless.analyse(path, names(low), names(high)))

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Writes a copy of the file, ``sweep.parquet``. :func:`load` reads it."""
        _cageless.write_folder(os.fspath(folder), {NAME: self.path.read_bytes()})
        return Path(folder)

    def __reduce__(self) -> tuple[Any, ...]:
        return (_unpickled, (self.path.read_bytes(),))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, SweepResult) and (
            self.path.read_bytes() == other.path.read_bytes()
        )

    __hash__ = None  # type: ignore[assignment]

    def __len__(self) -> int:
        return len(self.array("variant"))

    def _headline(self) -> str:
        return f"{len(self)} variants in {self.path}"

    def _repr_html_(self) -> str:
        return str(self.data_variants().to_html(max_rows=20))


def _unpickled(content: bytes) -> SweepResult:
    """A sweep from its pickle, in a folder that is removed with its last reference."""
    temporary = tempfile.TemporaryDirectory(prefix="cageless-")
    path = Path(temporary.name) / NAME
    path.write_bytes(content)
    return SweepResult(path, _temporary=temporary)


def complete(result: R) -> R:
    """The result, if the computation reached its end; else that is an ``UnphysicalError``."""
    if result.stopped is not None:
        error = UnphysicalError(result.stopped)
        error.result = result
        raise error
    return result


def read(path: Path) -> str:
    """The text of a file."""
    try:
        return path.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{path}: cannot be read: {error}") from error


@checked
def load(path: str | os.PathLike[str]) -> Any:
    """Reads a result that ``save`` wrote, or the command with ``--out``: of the kind that the folder
    holds, equal to what was saved.

    Args:
        path: The folder, or the file ``sweep.parquet``.

    Raises:
        InputError: If there is no result, more than one, or a damaged one.

    Examples:
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
    kinds = {name: kind for kind, name in VALUES.items()}
    there = [name for name in kinds if (path / name).is_file()]
    if len(there) > 1:
        # The command writes its analysis into the folder of the sweep.
        there = [name for name in there if name != VALUES["analysis"]]
    if not there:
        what = "holds no result" if path.is_dir() else "is not there"
        raise InputError(f"{path}: {what}: one of {', '.join(kinds)} is expected in a folder")
    if len(there) > 1:
        listed = ", ".join(there)
        raise InputError(f"{path}: holds several results: {listed}; take a folder for each")
    [name] = there
    if name == NAME:
        return SweepResult(path)
    text, kind = read(path / name), kinds[name]
    try:
        values = json.loads(text)
        if not isinstance(values, dict):
            raise ValueError("it is no result")
    except (ValueError, RecursionError) as error:
        raise InputError(f"{path / name}: cannot be read: {error}") from error
    files = {file: read(path / file) for file in FILES if (path / file).is_file()}
    if kind == "drop" and "report.json" in files:
        kind = "run"
    if isinstance(values.get("search"), dict):
        kind, text, files[name] = "search", json.dumps(values["search"]), text
    bearings = values.get("bearings")
    count = len(bearings) if isinstance(bearings, list) else 0
    if kind == "drop" and not count:
        why = "it lacks `bearings`: a drop of an earlier version must be computed again"
        raise InputError(f"{path / name}: cannot be read: {why}")
    tables: list[Any] = []
    if kind in ("run", "drop"):
        places = [f"bearing-{number}" for number in range(1, count + 1)] or [""]
        text, tables = _cageless.read_tables(os.fspath(path), text, places)
    return KINDS[kind](_cageless.Result(kind, text, tables, files))

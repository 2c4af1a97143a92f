"""The kinds of results, and results from folders."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from . import _cageless, frames
from .attributes import (
    AnalysisAttributes,
    ComparisonAttributes,
    DesignAttributes,
    DropAttributes,
    RunAttributes,
    SearchAttributes,
    StaticAttributes,
    ToleranceAttributes,
)
from .errors import UnphysicalError
from .result import Result
from .sections import Raceway

if TYPE_CHECKING:
    import pandas as pd

    from .case import Case
    from .plan import Plan

__all__ = [
    "Design",
    "Drop",
    "RingComparison",
    "Run",
    "SearchResult",
    "Static",
    "SweepReport",
    "SweepResult",
    "ToleranceResult",
    "Verification",
    "load",
]

R = TypeVar("R", bound=Result)

#: File of a sweep.
NAME = "sweep.parquet"


class Verification(Result):
    """Which results of a run or a drop are converged, from perturbed starts and half the step."""

    kind = "verification"

    def _headline(self) -> str:
        counts = ("converged", "statistical", "step_biased")
        return ", ".join(f"{self.values[name]} {name.replace('_', '-')}" for name in counts)


class Run(RunAttributes, Result):
    """A simulated run; units and meanings are those of the files of ``cageless run``."""

    kind = "run"
    _parts = {"verification": Verification}


class Drop(DropAttributes, Result):
    """The drop of a rotor into one bearing, or onto several: then each of ``bearings`` is a drop
    with the tables and figures of that bearing. ``conventional``, ``ensemble`` and ``verification``
    are None unless they were asked for."""

    kind = "drop"


Drop._parts = {"bearings": Drop, "conventional": Drop, "verification": Verification}


class Static(StaticAttributes, Result):
    """A static equilibrium and the ratings of the bearing; arrays are over the balls."""

    kind = "static"


class Design(DesignAttributes, Result):
    """The analysis of a raceway: limits, critical gap, verdict, recommendation."""

    kind = "design"


class SearchResult(SearchAttributes, Result):
    """The best raceway for a range of speeds and loads."""

    kind = "search"

    @property
    def passes(self) -> bool | None:
        """Whether the recommended structure passes the verdict of ``design`` at every speed and
        load; None if there is none."""
        verdicts = self.values["recommended_verdicts"]
        return all(each["passes"] for each in verdicts) if verdicts else None

    @property
    def recommended(self) -> tuple[Raceway, ...]:
        """The recommended structure; empty if there is none."""
        found = self.values["recommended"]
        if found is None:
            return ()
        size = {key: found[key] for key in ("axial_span_mm", "half_angle_deg")}
        places = found["centre_angles_deg"]
        return tuple(Raceway(**size, centre_angle_deg=place) for place in places)

    @property
    def case(self) -> Case:
        """The case with the recommended structure, to be run.

        Raises
        ------
        UnphysicalError
            If there is nothing to recommend.
        """
        from .case import Case

        if not self.recommended:
            raise UnphysicalError(self.values["findings"][0])
        case = Case.from_toml(self._core.source()).with_raceways(*self.recommended)
        return case.replace({"title": f"{case.title or 'Case'}: recommended raceway"})

    def data_map(self, k: int = 0) -> pd.DataFrame:
        """Map `k` over lC and θ with a row per cell."""
        return frames.cells(self.values["maps"][k])

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, SearchResult) or self._core.source() != other._core.source():
            return False
        return super().__eq__(other)

    __hash__ = None  # type: ignore[assignment]


class ToleranceResult(ToleranceAttributes, Result):
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


class RingComparison(ComparisonAttributes, Result):
    """Runs of two outer rings from the same uneven starts, and their differences."""

    kind = "comparison"


class SweepReport(AnalysisAttributes, Result):
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

    Parameters
    ----------
    path : path
        ``sweep.parquet``, or the folder with it.
    """

    kind = "sweep"

    def __init__(
        self,
        path: str | os.PathLike[str],
        *,
        _temporary: tempfile.TemporaryDirectory[str] | None = None,
    ) -> None:
        super().__init__(None)
        path = Path(path)
        self.path = path / NAME if path.is_dir() else path
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

    @property
    def stopped(self) -> None:
        """None: a sweep is complete when its file is there."""

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
        self, low: Sequence[str] = (), high: Sequence[str] = ()
    ) -> SweepReport:
        """Sensitivity and best variants; see :func:`cageless.report`."""
        path = os.fspath(self.path)
        return SweepReport(_cageless.analyse(path, list(low), list(high)))

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Writes a copy of the file, ``sweep.parquet``. :func:`load` reads it."""
        _cageless.make_folder(os.fspath(folder))
        _cageless.write(os.fspath(Path(folder) / NAME), self.path.read_bytes())
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


KINDS: dict[str, type[Result]] = {
    cls.kind: cls
    for cls in (
        Run,
        Drop,
        Static,
        Design,
        SearchResult,
        ToleranceResult,
        RingComparison,
        SweepReport,
    )
}


def of_core(core: Any) -> Any:
    """The result that the extension module holds."""
    return KINDS[core.kind](core)


def complete(result: R) -> R:
    """The result, if the computation reached its end.

    Raises
    ------
    UnphysicalError
        If it did not; its ``result`` is what was computed.
    """
    if result.stopped is not None:
        error = UnphysicalError(result.stopped)
        error.result = result
        raise error
    return result


def load(path: str | os.PathLike[str]) -> Any:
    """Reads a result that ``save`` wrote, or the command with ``--out``.

    Parameters
    ----------
    path : path
        The folder, or the file ``sweep.parquet``.

    Returns
    -------
    Result
        Of the kind that the folder holds, equal to what was saved.

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
    core = None if path.is_file() else _cageless.load(os.fspath(path))
    return SweepResult(path) if core is None else of_core(core)

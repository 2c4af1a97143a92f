"""Computations of a case."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _cageless, frames, sections
from .arguments import background, names, number, whole
from .document import Document, Progress
from .errors import InputError
from .exports import Export
from .results import Design, RingComparison, Run, SearchResult, Static, ToleranceResult, complete

if TYPE_CHECKING:
    import pandas as pd

    from .case import Case

__all__ = ["Measured"]

#: Formats of the outer ring.
FORMATS = {".step": "step", ".stp": "step", ".stl": "stl", ".csv": "csv"}


class Measured(NamedTuple):
    """A ring that has been measured."""

    #: The case with the raceways as measured in place of those that were designed.
    case: Any
    #: A row per raceway: points, their deviations from the fit, flank and half angle; dimensions of a slot.
    raceways: pd.DataFrame
    #: A row per dimension: drawn, measured, expanded uncertainty U (k = 2), tolerance, verdict.
    dimensions: pd.DataFrame
    #: Shift, tilt, turn about z and errors of the radii in the frame of the points, with U.
    frame: pd.DataFrame
    #: Whether all dimensions are within tolerance; ``None`` where that is not decided.
    passes: bool | None
    #: Verdict with its reason.
    headline: str
    #: Lines of the outliers in the file.
    outlier_lines: list[int]


class Computations(Document):
    """The computations of a :class:`Case`.

    Those that take long have the options ``threads``, the number of threads (default: number of
    cores), and ``progress``, called repeatedly with the name of the task and its completed
    fraction, 0 to 1. Other threads of Python go on meanwhile; Ctrl-C ends a computation. One that
    leaves the physical range raises an ``UnphysicalError``, whose ``result`` has what was computed.
    """

    @staticmethod
    def _hint(argument: str, value: object) -> str:
        """What to do with the name of a key in place of an argument."""
        for section in sections.Section.__subclasses__():
            if argument in section.__annotations__:
                key = f"{section.__name__.lower()}__{argument}"
                return f"; a key of the case is changed by replace({key}={value!r})"
        return ""

    def run(
        self,
        *,
        verify: bool = False,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Run:
        """Simulates the case.

        Args:
            verify: Verify by perturbed starts and half step (17x cost); ``verification`` of the run
                classifies the results as converged, statistical or step-biased.

        Examples:
            >>> import cageless
            >>> case = cageless.Case.from_toml(cageless.template(), {"solver.duration_s": 0.002})
            >>> run = case.run()
            >>> run.angle_rad.shape  # times × balls
            (21, 14)
            >>> case.run(verify=True).verification
            <Verification: 17 converged, 0 statistical, 0 step-biased>
        """
        return complete(Run(_cageless.run(self._file, verify, background(threads, progress))))

    def static(self) -> Static:
        """Static equilibrium: ring displacement, load of each ball, contact pressure.

        Examples:
            >>> import cageless
            >>> static = cageless.Case.from_toml(cageless.template()).static()
            >>> round(static.ring_y_um, 2)
            -13.18
        """
        return Static(_cageless.static_equilibrium(self._file))

    def design(
        self,
        *,
        axial: bool = False,
        benefit: bool = False,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Design:
        """Analyses the raceway: limits, β0, critical gap, verdict, recommendation.

        Takes seconds: the verdict rests on a run of all balls.

        Args:
            axial: Simulate in space what axial load and tilt leave of the lag, see ``data_axial``;
                takes a minute.
            benefit: Say whether the raceway helps in steady operation, against a plain ring and one ball
                fewer: ``benefit.answer``, ``benefit.comparison``; takes a minute.
        """
        asked = {name for name, wanted in [("axial", axial), ("benefit", benefit)] if wanted}
        return Design(_cageless.design(self._file, asked, None, background(threads, progress)))

    def search(
        self,
        *,
        benefit: bool = False,
        out: str | os.PathLike[str] | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
        **asked: float | str | Sequence[float] | None,
    ) -> SearchResult:
        """Searches for the best raceway, as ``cageless design --search`` does.

        Takes minutes.

        Args:
            benefit: Recommend the raceway that helps most in steady operation, or none.
            out: Folder that keeps what was computed until the search is over: after an
                interruption the same call, or the command, continues from there.
            **asked: Keys of the section ``[search]`` of a case file with their values, in place of
                those of the case: ranges of speeds and loads, of lC, θ and ψ, shapes, numbers of raceways,
                starts and runs.

        Raises:
            UnphysicalError: If no raceway meets every requirement, or with ``benefit`` none helps; its ``result`` has the maps that
                show why.

        Examples:
            >>> import cageless
            >>> case = cageless.Case.from_toml(cageless.template())
            >>> case.search(runs_max=1)
            Traceback (most recent call last):
            cageless.errors.InputError: search.runs_max = 1 is not possible: it must be a whole number, 32 or more
        """
        changes = {f"search.{key}": value for key, value in asked.items() if value is not None}
        file = (self.replace(changes) if changes else self)._file
        folder = None if out is None else os.fspath(out)
        wanted = {"search", "benefit"} if benefit else {"search"}
        found = _cageless.design(file, wanted, folder, background(threads, progress))
        return complete(SearchResult(found))

    def measure(
        self,
        points: str | os.PathLike[str],
        *,
        groove_depth_um: float | None = None,
        axial_span_um: float | None = None,
        half_angle_deg: float | None = None,
        centre_angle_deg: float | None = None,
    ) -> Measured:
        """Fits the ring to points of one that has been measured, as ``cageless measure`` does.

        Args:
            points: File with a line of x, y and z in mm for each point.
            groove_depth_um: Tolerance of the depth to either side, 2 if left out.
            axial_span_um: Tolerance of lC, 20 if left out.
            half_angle_deg: Tolerance of θ, 0.1 if left out.
            centre_angle_deg: Tolerance of the angular position, none if left out.

        Raises:
            InputError: If the case has no raceway, or the points do not give a ring.
            UnphysicalError: If the groove is plain where the case has a raceway.
        """
        tolerances = [groove_depth_um, axial_span_um, half_angle_deg, centre_angle_deg]
        file, text = self._file.measured(os.fspath(points), tolerances)
        found = json.loads(text)
        rows = [
            {"raceway": nth, **row}
            for nth, raceway in enumerate(found["raceways"], 1)
            for row in raceway.pop("dimensions")
        ]
        return Measured(
            type(self)._of(file),
            frames.frame(found["raceways"]),
            frames.frame(rows),
            frames.frame(found["frame"]),
            found["passes"],
            found["headline"],
            found["outlier_lines"],
        )

    def compare(
        self,
        reference: Case | None = None,
        *,
        remedies: bool = False,
        draws: int = 8,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> RingComparison:
        """Compares the ring with that of another case, as ``cageless compare`` does: both run in steady
        operation with the same draws of real balls.

        Args:
            reference: What to compare with; the same bearing with a conventional outer ring by
                default.
            remedies: Compare plain ring, raceway, and one and two balls fewer instead.
            draws: Draws of balls of each ring.

        Examples:
            >>> import cageless
            >>> short = {"steady.transient_orbits": 2.0, "steady.measured_orbits": 4.0}
            >>> case = cageless.Case.from_toml(cageless.template(), short)
            >>> found = case.compare(draws=2)
            >>> found.values["benefits"][1]["benefit"]
            'not-judged'
        """
        other = None if reference is None else reference._file
        asked = (other, remedies, whole("draws", draws), background(threads, progress))
        return RingComparison(_cageless.compare(self._file, *asked))

    def tolerance(
        self,
        *,
        samples: int | None = None,
        groove_depth_um: float | None = None,
        axial_span_um: float | None = None,
        half_angle_deg: float | None = None,
        contact_angle_deg: float | None = None,
        ball_grade: int | None = None,
        friction: float | None = None,
        clearance_um: float | None = None,
        speed_percent: float | None = None,
        load_percent: float | None = None,
        viscosity_percent: float | None = None,
        supply_factor: float | None = None,
        benefit: bool = False,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> ToleranceResult:
        """Probability that the raceway passes as made and run, as ``cageless tolerance`` computes
        it: within tolerances to either side of the case.

        Takes minutes: every bearing is run until it is judged.

        Args:
            samples: Monte Carlo sample size, 200 if left out; 0: one-at-a-time only.
            groove_depth_um: Depth of the raceways, 2 if left out.
            axial_span_um: lC, 20 if left out.
            half_angle_deg: θ, 0.1 if left out.
            contact_angle_deg: Contact angle of the raceway, 0.1 if left out; of a case in space.
            ball_grade: Grade of the balls by ISO 3290-1, 10 if left out; 0 for balls all equal.
            friction: μ, 0.002 if left out.
            clearance_um: Radial internal clearance Gr, 10 if left out.
            speed_percent: Speed, as a share of that of the case, 5 if left out.
            load_percent: Load, as a share of that of the case, 20 if left out.
            viscosity_percent: Viscosity of the oil, as a share of that of the case, 30 if left out; with ``[film]``.
            supply_factor: Factor of the supply of oil, 2 if left out; with ``[film]``.
            benefit: Say whether the raceway helps in steady operation, as drawn and at both ends of its
                machining tolerances: ``benefit.answer``, ``benefit.comparison``; takes a minute more.

        Raises:
            InputError: If a tolerance is not possible, or there is no discrete raceway.

        Examples:
            >>> import cageless
            >>> case = cageless.Case.from_toml(cageless.template())
            >>> case.tolerance(ball_grade=7)
            Traceback (most recent call last):
            cageless.errors.InputError: ball_grade = 7 is not possible: it must be a grade of ...
        """
        request = locals()
        for name in ("self", "benefit", "threads", "progress"):
            del request[name]
        checks = {"samples": whole, "ball_grade": whole}
        asked = {k: checks.get(k, number)(k, v) for k, v in request.items() if v is not None}
        asked["benefit"] = bool(benefit)
        found = _cageless.tolerance(self._file, json.dumps(asked), background(threads, progress))
        return ToleranceResult(found)

    def sheet(
        self,
        out: str | os.PathLike[str],
        *,
        groove_depth_um: float | None = None,
        axial_span_um: float | None = None,
        half_angle_deg: float | None = None,
        centre_angle_deg: float | None = None,
        benefit: bool = True,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Path:
        """Writes one sheet for the decision into a folder, as ``cageless sheet`` does: ``report.html``,
        the drawing of the outer ring as ``drawing.svg`` and ``drawing.pdf``, ``sheet.json``.

        Args:
            out: Folder.
            groove_depth_um: Tolerance of the depth of the raceway to either side, 2 if left out.
            axial_span_um: That of lC, 20 if left out.
            half_angle_deg: That of θ, 0.1 if left out.
            centre_angle_deg: That of the angular position ψ; none if left out.
            benefit: Say whether the raceway helps in steady operation; takes a minute.

        Returns:
            The page.

        Raises:
            InputError: If the case has no equilibrium, or a tolerance is not possible.

        Examples:
            >>> import cageless, tempfile
            >>> ring = {"bearing.outer_ring_outer_radius_mm": 31.0, "bearing.outer_ring_width_mm": 16.0}
            >>> case = cageless.Case.from_toml(cageless.template(conventional=True), ring)
            >>> with tempfile.TemporaryDirectory() as folder:
            ...     sorted(file.name for file in case.sheet(folder).parent.iterdir())
            ['drawing.pdf', 'drawing.svg', 'report.html', 'sheet.json']
        """
        given = {
            "groove_depth_um": groove_depth_um,
            "axial_span_um": axial_span_um,
            "half_angle_deg": half_angle_deg,
            "centre_angle_deg": centre_angle_deg,
        }
        tolerances = [None if value is None else number(name, value) for name, value in given.items()]
        folder = Path(out)
        work = background(threads, progress)
        _cageless.sheet(self._file, folder, tolerances, bool(benefit), work)
        return folder / "report.html"

    def export(
        self,
        out: str | os.PathLike[str],
        formats: str | Sequence[str] | None = None,
        *,
        blend_mm: float | None = None,
        tolerance_um: float | None = None,
        chord_um: float | None = None,
        spacing_mm: float | None = None,
    ) -> Export:
        """Writes the outer ring for CAD and machining, as ``cageless export`` does.

        The case needs ``bearing.outer_ring_outer_radius_mm`` and
        ``bearing.outer_ring_width_mm``.

        Args:
            out: A file, if the name ends in ``.step``, ``.stp``, ``.stl`` or ``.csv``; else a
                folder, which gets ``outer_ring.step`` and so on, and ``export.json``.
            formats: ``"step"``, ``"stl"``, ``"csv"``; what the file is called, or all three.
            blend_mm: Length of the blend between each end of a discrete raceway and the plain
                groove; 0 leaves the slope discontinuity. Default: 0.5, or a fifth of the shortest
                half raceway if that is shorter.
            tolerance_um: STEP: largest distance of the B-splines from the analytic surface.
                Default: 0.01.
            chord_um: STL: largest distance of a triangle from the analytic surface. Default: 5.
            spacing_mm: CSV: largest distance of neighbouring points. Default: 0.5.

        Raises:
            InputError: If the case lacks the outside of the ring, or an option is not possible.

        Examples:
            >>> import cageless, tempfile
            >>> ring = {"bearing.outer_ring_outer_radius_mm": 31.0, "bearing.outer_ring_width_mm": 16.0}
            >>> case = cageless.Case.from_toml(cageless.template(), ring)
            >>> with tempfile.TemporaryDirectory() as folder:
            ...     made = case.export(folder, ["step", "stl"], chord_um=10.0)
            >>> made.formats
            ['step', 'stl']
            >>> made.deviation_um["step"] < 0.01
            True
        """
        path, ending = Path(out), Path(out).suffix.lower()
        named = FORMATS.get(ending)
        marked = os.fspath(out).endswith(("/", os.sep))
        is_file = bool(ending) and not marked and not path.is_dir()
        usual = [named] if named else ["step", "stl", "csv"]
        asked = usual if formats is None else names(formats)
        if not asked:
            raise InputError("formats = [] is not possible: it must be of step, stl, csv")
        if is_file and named is None:
            raise InputError(
                f"out = {path}: the name of a file ends in .step, .stp, .stl or .csv, that of a "
                "folder has no ending, or a slash at its end"
            )
        if is_file and asked != [named]:
            other = next((name for name in asked if name != named), named)
            raise InputError(f"out = {path}: is the name of a file of format {named}, not of {other}")
        targets = [(name, path if is_file else path / f"outer_ring.{name}") for name in asked]
        options = (blend_mm, tolerance_um, chord_um, spacing_mm)
        folder = None if is_file else path
        made = _cageless.export(self._file, folder, targets, list(options))
        return Export([json.loads(text) for text in made])

"""Computations of a case."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from . import sections
from .errors import InputError
from .exports import Export
from .results import (
    Design,
    Drop,
    RingComparison,
    Run,
    SearchResult,
    Static,
    ToleranceResult,
    complete,
)

if TYPE_CHECKING:
    from .case import Case

__all__ = ["Computations"]

Progress = Callable[[str, float], object]


def refuse(method: str, unknown: Mapping[str, Any]) -> None:
    """Refuses keywords that a method does not have; keys of the case belong to ``replace``."""
    for name, value in unknown.items():
        parts = (part for part in vars(sections).values() if isinstance(part, type))
        owners = [part for part in parts if name in getattr(part, "__dataclass_fields__", {})]
        hint = ""
        if owners:
            section = owners[0].__name__.lower()
            hint = f"; a key of the case is changed by replace({section}__{name}={value!r})"
        raise TypeError(f"Case.{method}() has no argument {name!r}{hint}")


class Computations:
    """The computations of a :class:`Case`.

    Those that take long have the options ``threads``, the number of threads (default: number of
    cores), and ``progress``, called repeatedly with the name of the task and its completed
    fraction, 0 to 1. Other threads of Python go on meanwhile; Ctrl-C ends a computation.
    """

    _file: Any

    def run(
        self,
        *,
        verify: bool = False,
        threads: int | None = None,
        progress: Progress | None = None,
        **unknown: Any,
    ) -> Run:
        """Simulates the case.

        Parameters
        ----------
        verify : bool
            Verify by perturbed starts and half step (17x cost); ``verification`` of the run
            classifies the results as converged, statistical or step-biased.

        Returns
        -------
        Run

        Raises
        ------
        UnphysicalError
            If the run left the physical range; its ``result`` has what was computed.

        Examples
        --------
        >>> import cageless
        >>> case = cageless.Case.from_toml(cageless.template(), {"solver.duration_s": 0.002})
        >>> run = case.run()
        >>> run.angle_rad.shape  # times × balls
        (21, 14)
        >>> case.run(verify=True).verification
        <Verification: 13 converged, 0 statistical, 0 step-biased>
        """
        refuse("run", unknown)
        return complete(Run(self._file.run(verify, threads, progress)))

    def drop(
        self,
        *,
        compare: bool = False,
        samples: int | None = None,
        verify: bool = False,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Drop:
        """Drops the rotor of the case onto the bearing, as ``cageless drop`` does.

        Parameters
        ----------
        compare : bool
            Drop it onto the same bearing with a conventional outer ring as well.
        samples : int, optional
            Number of further drops with scattered friction, touch-down clearance, support damping, direction
            of the unbalance and arrangement of the balls.
        verify : bool
            Repeat the drop from perturbed starts and at half the step; ``data_verification()``
            classifies the results as converged, statistical or step-biased.

        Returns
        -------
        Drop

        Raises
        ------
        InputError
            If the case has no rotor.
        UnphysicalError
            If the drop left the physical range; its ``result`` has what was computed.
        """
        return complete(Drop(self._file.drop(compare, samples, verify, threads, progress)))

    def static(self) -> Static:
        """Static equilibrium: ring displacement, load of each ball, contact pressure.

        Returns
        -------
        Static

        Examples
        --------
        >>> import cageless
        >>> static = cageless.Case.from_toml(cageless.template()).static()
        >>> round(static.ring_y_um, 2)
        -13.18
        """
        return Static(self._file.static_equilibrium())

    def design(self) -> Design:
        """Analyses the raceway: limits, β0, critical gap, verdict, recommendation.

        Takes seconds: the verdict rests on a run of all balls.

        Returns
        -------
        Design

        Raises
        ------
        UnphysicalError
            If that run left the physical range.
        """
        found, stopped = self._file.design()
        if stopped is not None:
            raise stopped
        return Design(found)

    def search(
        self,
        *,
        out: str | os.PathLike[str] | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
        **asked: float | Sequence[float] | None,
    ) -> SearchResult:
        """Searches for the best raceway, as ``cageless design --search`` does.

        Takes minutes.

        Parameters
        ----------
        out : path, optional
            Folder that keeps what was computed until the search is over: after an
            interruption the same call, or the command, continues from there.
        **asked
            Keys of the section ``[search]`` of a case file with their values, in place of those of
            the case: ranges of speeds and loads, of lC, θ and ψ, numbers of raceways, starts and
            runs.

        Returns
        -------
        SearchResult

        Raises
        ------
        UnphysicalError
            If no raceway meets every requirement; its ``result`` has the maps that show why.

        Examples
        --------
        >>> import cageless
        >>> case = cageless.Case.from_toml(cageless.template())
        >>> case.search(runs_max=1)
        Traceback (most recent call last):
        cageless.errors.InputError: search.runs_max = 1 is not possible: it must be 32 or more with ...
        """
        given = {f"search.{key}": value for key, value in asked.items() if value is not None}
        case = self.replace(given) if given else self  # type: ignore[attr-defined]
        folder = None if out is None else os.fspath(out)
        return complete(SearchResult(case._file.search(folder, threads, progress)))

    def compare(
        self,
        reference: Case | None = None,
        *,
        starts: int = 8,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> RingComparison:
        """Compares the ring with that of another case, as ``cageless compare`` does: both run from
        the same uneven starts.

        Parameters
        ----------
        reference : Case, optional
            What to compare with; the same bearing with a conventional outer ring by default.
        starts : int
            Uneven starts of each ring.

        Returns
        -------
        RingComparison

        Raises
        ------
        UnphysicalError
            If a run left the physical range.

        Examples
        --------
        >>> import cageless
        >>> case = cageless.Case.from_toml(cageless.template(), {"solver.duration_s": 0.002})
        >>> results = case.compare(starts=2).data_results()
        >>> bool(results.loc["gap_deviation_deg", "case_error"] > 0.0)
        True
        """
        other = None if reference is None else reference._file
        return RingComparison(self._file.compare(other, starts, threads, progress))

    def tolerance(
        self,
        *,
        samples: int = 200,
        groove_depth_um: float = 2.0,
        axial_span_um: float = 20.0,
        half_angle_deg: float = 0.1,
        ball_grade: int = 10,
        friction: float = 0.002,
        clearance_um: float = 10.0,
        speed_percent: float = 5.0,
        load_percent: float = 20.0,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> ToleranceResult:
        """Probability that the raceway passes as made and run, as ``cageless tolerance`` computes
        it: within tolerances to either side of the case.

        Takes minutes: every bearing is run until it is judged.

        Parameters
        ----------
        samples : int
            Monte Carlo sample size; 0: one-at-a-time only.
        groove_depth_um : float
            Depth of the raceways.
        axial_span_um : float
            lC.
        half_angle_deg : float
            θ.
        ball_grade : int
            Grade of the balls by ISO 3290-1, 0 for balls all equal.
        friction : float
            μ.
        clearance_um : float
            Tolerance of the radial internal clearance Gr.
        speed_percent, load_percent : float
            Speed and load, as shares of those of the case.

        Returns
        -------
        ToleranceResult

        Raises
        ------
        InputError
            If a tolerance is not possible, or there is no discrete raceway.

        Examples
        --------
        >>> import cageless
        >>> case = cageless.Case.from_toml(cageless.template())
        >>> case.tolerance(ball_grade=7)
        Traceback (most recent call last):
        cageless.errors.InputError: ball_grade = 7 is not possible: it must be a grade of ...
        """
        deviations = {
            "groove_depth_um": float(groove_depth_um),
            "axial_span_um": float(axial_span_um),
            "half_angle_deg": float(half_angle_deg),
            "friction": float(friction),
            "clearance_um": float(clearance_um),
            "speed_percent": float(speed_percent),
            "load_percent": float(load_percent),
        }
        found = self._file.tolerance(samples, ball_grade, deviations, threads, progress)
        return ToleranceResult(found)

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

        Parameters
        ----------
        out : path
            A file, if the name ends in ``.step``, ``.stp``, ``.stl`` or ``.csv``; else a
            folder, which gets ``outer_ring.step`` and so on, and ``export.json``.
        formats : str or sequence of str, optional
            ``"step"``, ``"stl"``, ``"csv"``; what the file is called, or all three.
        blend_mm : float, optional
            Length of the blend between each end of a discrete raceway and the plain groove;
            0 leaves the slope discontinuity. Default: 0.5, or a fifth of the shortest half
            raceway if that is shorter.
        tolerance_um : float, optional
            STEP: largest distance of the B-splines from the analytic surface. Default: 0.01.
        chord_um : float, optional
            STL: largest distance of a triangle from the analytic surface. Default: 5.
        spacing_mm : float, optional
            CSV: largest distance of neighbouring points. Default: 0.5.

        Returns
        -------
        Export

        Raises
        ------
        InputError
            If the case lacks the outside of the ring, or an option is not possible.

        Examples
        --------
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
        several = [formats] if isinstance(formats, str) else formats
        names = None if several is None else list(several)
        made = self._file.export(
            os.fspath(out), names, blend_mm, tolerance_um, chord_um, spacing_mm
        )
        return Export(json.loads(made))

"""A case: one computation, complete."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from . import _cageless
from .errors import InputError, UnphysicalError
from .exports import Export
from .results import Design, Run, Static
from .searches import SearchResult
from .sections import (
    Bearing,
    Contact,
    Housing,
    Material,
    Model,
    Operation,
    Output,
    Raceway,
    Section,
    Solver,
    Start,
    table,
)
from .tolerances import ToleranceResult

__all__ = ["Case", "template"]


def template(conventional: bool = False) -> str:
    """A commented case file, that of ``cageless new``.

    Parameters
    ----------
    conventional : bool
        Leave the discrete raceway out.

    Returns
    -------
    str
        TOML.

    Examples
    --------
    >>> import cageless
    >>> cageless.Case.from_toml(cageless.template()).bearing.balls
    14
    """
    return _cageless.template(conventional)


def changes(values: Mapping[str, Any]) -> list[str]:
    """``section.key=value`` for each, as ``--set`` takes it."""
    written = {key: _cageless.to_toml({key: value}) for key, value in values.items()}
    return [f"{key}={text.split('=', 1)[1].strip()}" for key, text in written.items()]


class Case:
    """A bearing, its operation and how it is to be simulated, checked when it is made.

    Parameters
    ----------
    bearing, material, operation, contact, model, solver, output
        The sections of a case file.
    raceway : Raceway or sequence of Raceway, optional
        Discrete raceways; none for a conventional outer ring.
    start : Start, optional
        Initial state.
    housing : Housing, optional
        Support of the outer ring.
    title : str
        Free text.

    Raises
    ------
    InputError
        If the case cannot be, with the key at fault.

    Examples
    --------
    >>> from cageless import *
    >>> case = Case(
    ...     bearing=Bearing(
    ...         balls=14, ball_radius_mm=4.7625,
    ...         inner_groove_bottom_radius_mm=18.24, outer_groove_bottom_radius_mm=27.765,
    ...         outer_shoulder_radius_mm=26.0,
    ...         inner_groove_curvature_radius_mm=4.953, outer_groove_curvature_radius_mm=4.953,
    ...         inner_ring_mass_kg=0.2, inner_ring_drag_n_s_m=2000.0,
    ...     ),
    ...     raceway=Raceway(axial_span_mm=5.1, half_angle_deg=25.2),
    ...     material=Material(density_kg_m3=7850.0, youngs_modulus_gpa=206.0, poisson_ratio=0.3),
    ...     operation=Operation(inner_speed_rpm=12000.0, radial_load_n=1500.0),
    ...     contact=Contact(friction_coefficient=0.007, friction_law="smooth",
    ...                     slip_scale_m_s=0.02, damping=2.0e5),
    ...     model=Model(profile="physical"),
    ...     solver=Solver(duration_s=0.002),
    ...     output=Output(interval_us=100.0),
    ... )
    >>> case.contact.ball_restitution
    0.95
    >>> case.replace({"raceway.half_angle_deg": 500.0})
    Traceback (most recent call last):
    cageless.errors.InputError: raceway.half_angle_deg = 500.0 is not possible: ...
    """

    _file: _cageless.CaseFile
    _sections: dict[str, Any]

    def __init__(
        self,
        *,
        bearing: Bearing,
        material: Material,
        operation: Operation,
        contact: Contact,
        model: Model,
        solver: Solver,
        output: Output,
        raceway: Raceway | Sequence[Raceway] | None = None,
        start: Start | None = None,
        housing: Housing | None = None,
        title: str = "",
    ) -> None:
        several = [raceway] if isinstance(raceway, Raceway) else list(raceway or [])
        given: dict[str, Section | None] = {
            "bearing": bearing,
            "material": material,
            "operation": operation,
            "contact": contact,
            "model": model,
            "start": start,
            "solver": solver,
            "housing": housing,
            "output": output,
        }
        values: dict[str, Any] = {"title": title} if title else {}
        values |= {name: part.values() for name, part in given.items() if part is not None}
        if several:
            sections = [each.values() for each in several]
            values["raceway"] = sections[0] if len(sections) == 1 else sections
        self._take(_cageless.CaseFile.of_values(values))

    def _take(self, file: _cageless.CaseFile) -> None:
        self._file = file
        self._sections = json.loads(file.document(False))

    @classmethod
    def _of(cls, file: _cageless.CaseFile) -> Case:
        case = cls.__new__(cls)
        case._take(file)
        return case

    @classmethod
    def from_file(
        cls, path: str | os.PathLike[str], changes: Mapping[str, Any] | None = None
    ) -> Case:
        """Reads a case file.

        Parameters
        ----------
        path : path
            TOML.
        changes : mapping, optional
            Values for keys ``section.key``, as ``--set`` gives them to the command.

        Raises
        ------
        InputError
            With file and line.
        """
        return cls._of(_cageless.CaseFile.read(os.fspath(path), _changes(changes)))

    @classmethod
    def from_toml(
        cls, text: str, changes: Mapping[str, Any] | None = None, name: str = "case"
    ) -> Case:
        """Reads the text of a case file, which messages call `name`."""
        return cls._of(_cageless.CaseFile.parse(text, name, _changes(changes)))

    def replace(self, changes: Mapping[str, Any]) -> Case:
        """The case with other values.

        Parameters
        ----------
        changes : mapping
            Values for keys ``section.key``, or ``raceway.2.key`` for the second of several.

        Examples
        --------
        >>> import cageless
        >>> case = cageless.Case.from_toml(cageless.template())
        >>> case.replace({"raceway.half_angle_deg": 24.0}).raceways[0].half_angle_deg
        24.0
        """
        return Case._of(self._file.changed(_changes(changes)))

    def with_raceways(self, *raceways: Raceway) -> Case:
        """The case with these discrete raceways in place of its own; none for a conventional
        ring.

        Examples
        --------
        >>> import cageless
        >>> case = cageless.Case.from_toml(cageless.template())
        >>> case.with_raceways()
        <Case 'Zhao 2022, structure (d)': 14 balls, conventional>
        """
        values = {k: v for k, v in self._sections.items() if k != "raceway"}
        several = [each.values() for each in raceways]
        if several:
            values["raceway"] = several[0] if len(several) == 1 else several
        return Case._of(_cageless.CaseFile.of_values(values))

    def to_toml(self) -> str:
        """The case as a case file, every default filled in."""
        return self._file.to_toml()

    def _document(self) -> dict[str, Any]:
        return self._sections

    def to_dict(self) -> dict[str, Any]:
        """The case as run: every default, the stiffnesses of Hertz and the step filled in."""
        found: dict[str, Any] = json.loads(self._file.document(True))
        return found

    @property
    def title(self) -> str:
        """Free text."""
        return str(self._sections["title"])

    @property
    def defaults(self) -> list[str]:
        """Keys that took their default."""
        return self._file.defaults()

    @property
    def bearing(self) -> Bearing:
        """Rings and balls."""
        return Bearing(**self._sections["bearing"])

    @property
    def material(self) -> Material:
        """Elastic material."""
        return Material(**self._sections["material"])

    @property
    def raceways(self) -> tuple[Raceway, ...]:
        """Discrete raceways."""
        found = self._sections.get("raceway", [])
        several = found if isinstance(found, list) else [found]
        return tuple(Raceway(**each) for each in several)

    @property
    def operation(self) -> Operation:
        """Speed and load."""
        return Operation(**self._sections["operation"])

    @property
    def contact(self) -> Contact:
        """Friction, damping and stiffness."""
        return Contact(**self._sections["contact"])

    @property
    def model(self) -> Model:
        """The set of equations."""
        return Model(**self._sections["model"])

    @property
    def start(self) -> Start:
        """Initial state."""
        return Start(**self._sections["start"])

    @property
    def solver(self) -> Solver:
        """Integration."""
        return Solver(**self._sections["solver"])

    @property
    def housing(self) -> Housing | None:
        """Support of the outer ring."""
        found = self._sections.get("housing")
        return None if found is None else Housing(**found)

    @property
    def output(self) -> Output:
        """What a run leaves behind."""
        return Output(**self._sections["output"])

    @property
    def radial_clearance_um(self) -> float:
        """Ro − Ri − 2 Rw: half the radial internal clearance of ISO 5753-1."""
        return self._file.derived()["radial_clearance_um"]

    @property
    def epsilon_deg(self) -> float:
        """ε of Zhao 2022, Eq. (10): the angle of two balls in contact."""
        return self._file.derived()["epsilon_deg"]

    @property
    def uniform_gap_deg(self) -> float:
        """360°/N − ε."""
        return self._file.derived()["uniform_gap_deg"]

    def run(
        self,
        *,
        verify: bool = False,
        threads: int | None = None,
        progress: Callable[[str, float], object] | None = None,
    ) -> Run:
        """Simulates the case.

        Other threads of Python go on meanwhile; Ctrl-C ends it.

        Parameters
        ----------
        verify : bool
            Repeat the run from turned starts and at half the step, and say in the
            ``certificate`` of the run which numbers are converged, which are statistical and
            which the step biases: 17 times the work.
        threads : int, optional
            Threads that repeat the run; as many as there are cores if left out.
        progress : callable, optional
            Called while the run is repeated, now and then, with what is done and its share
            that is done, from 0 to 1.

        Returns
        -------
        Run

        Raises
        ------
        UnphysicalError
            If the run left the physical range; its ``run`` has what was computed.

        Examples
        --------
        >>> import cageless
        >>> case = cageless.Case.from_toml(cageless.template(), {"solver.duration_s": 0.002})
        >>> run = case.run()
        >>> run.angle_rad.shape  # times × balls
        (21, 14)
        >>> case.run(verify=True).certificate
        <Certificate: 13 converged, 0 statistical, 0 neither>
        """
        run = Run(self._file.run(verify, threads, progress))
        stopped = run.stopped
        if stopped is not None:
            error = UnphysicalError(stopped)
            error.run = run
            raise error
        return run

    def static(self) -> Static:
        """Static equilibrium: ring displacement, load of each ball, contact stress.

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
        return Static(json.loads(self._file.static_equilibrium()))

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
        return Design(json.loads(found.numbers()), found)

    def search(
        self,
        *,
        inner_speed_rpm: float | Sequence[float] | None = None,
        radial_load_n: float | Sequence[float] | None = None,
        axial_span_mm: float | Sequence[float] | None = None,
        half_angle_deg: float | Sequence[float] | None = None,
        centre_angle_deg: float | Sequence[float] | None = None,
        raceways_max: int | None = None,
        spread_min: float | None = None,
        starts: int | None = None,
        budget: int | None = None,
        map_speed_rpm: Sequence[float] | None = None,
        out: str | os.PathLike[str] | None = None,
        threads: int | None = None,
        progress: Callable[[str, float], object] | None = None,
    ) -> SearchResult:
        """Searches for the best raceway, as ``cageless design --search`` does.

        Takes minutes. What is left out of the first ten parameters is that of the section
        ``[search]`` of the case, or its default.

        Parameters
        ----------
        inner_speed_rpm, radial_load_n : float or (float, float), optional
            Speeds and loads that the raceway must bear, one or lowest and highest.
        axial_span_mm, half_angle_deg : float or (float, float), optional
            lC and θ to look at; all that the groove allows by default.
        centre_angle_deg : float or (float, float), optional
            ψ of the middle of one raceway, or first and last.
        raceways_max : int, optional
            Number of raceways at most.
        spread_min : float, optional
            Share of the steady gap that the raceway must guarantee.
        starts : int, optional
            Uneven starts per structure.
        budget : int, optional
            Runs of all balls at most.
        map_speed_rpm : sequence of float, optional
            Further speeds to draw maps at.
        out : path, optional
            Folder that keeps what was computed until the search is over: after an
            interruption the same call, or the command, goes on from there.
        threads : int, optional
            Threads; as many as there are cores if left out.
        progress : callable, optional
            Called now and then with what is done and its share that is done, from 0 to 1.

        Returns
        -------
        SearchResult

        Raises
        ------
        InputError
            If no raceway meets every requirement; its ``search`` has the maps that show why.

        Examples
        --------
        >>> import cageless
        >>> case = cageless.Case.from_toml(cageless.template())
        >>> case.search(budget=1)
        Traceback (most recent call last):
        cageless.errors.InputError: search.budget = 1 is not possible: it must be 2 or more: ...
        """
        asked: dict[str, Any] = {
            "inner_speed_rpm": inner_speed_rpm,
            "radial_load_n": radial_load_n,
            "axial_span_mm": axial_span_mm,
            "half_angle_deg": half_angle_deg,
            "centre_angle_deg": centre_angle_deg,
            "raceways_max": raceways_max,
            "spread_min": spread_min,
            "starts": starts,
            "budget": budget,
            "map_speed_rpm": map_speed_rpm,
        }
        given = {f"search.{key}": value for key, value in asked.items() if value is not None}
        case = self.replace(given) if given else self
        folder = None if out is None else os.fspath(out)
        found = SearchResult(case._file.search(folder, threads, progress), case)
        refusal = found._search.refusal()
        if refusal is not None:
            error = InputError(refusal)
            error.search = found
            raise error
        return found

    def tolerance(
        self,
        *,
        samples: int = 200,
        groove_depth_um: float = 2.0,
        axial_span_um: float = 20.0,
        half_angle_deg: float = 0.1,
        ball_grade: int = 10,
        friction: float = 0.002,
        clearance_um: float = 5.0,
        speed_percent: float = 5.0,
        load_percent: float = 20.0,
        threads: int | None = None,
        progress: Callable[[str, float], object] | None = None,
    ) -> ToleranceResult:
        """Says whether the verdict on the raceway holds as made and run, as
        ``cageless tolerance`` does: within tolerances to either side of the case.

        Takes minutes: every bearing is run until it is judged.

        Parameters
        ----------
        samples : int
            Bearings in which everything deviates at once; 0 for the influences alone.
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
            Radial clearance.
        speed_percent, load_percent : float
            Speed and load, as shares of those of the case.
        threads : int, optional
            Threads; as many as there are cores if left out.
        progress : callable, optional
            Called now and then with what is done and its share that is done, from 0 to 1.

        Returns
        -------
        ToleranceResult

        Raises
        ------
        InputError
            If a tolerance is not possible, or the raceway is infeasible as drawn.

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
            0 leaves the kink. Default: 0.5, or a fifth of the shortest half raceway if that
            is shorter.
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

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Case) and self._file == other._file

    def __hash__(self) -> int:
        return hash(self.to_toml())

    def __reduce__(self) -> tuple[Any, ...]:
        return (Case.from_toml, (self.to_toml(),))

    def __repr__(self) -> str:
        kind = "conventional" if not self.raceways else f"{len(self.raceways)} raceway"
        return f"<Case {self.title!r}: {self.bearing.balls} balls, {kind}>"

    def _repr_html_(self) -> str:
        rows: list[tuple[str, object]] = []
        for section, values in self.to_dict().items():
            for item in values if isinstance(values, list) else [values]:
                if isinstance(item, dict):
                    rows.extend((f"{section}.{key}", value) for key, value in item.items())
                else:
                    rows.append((section, item))
        return table(rows, self.title or "Case")


def _changes(values: Mapping[str, Any] | None) -> list[str]:
    return changes(values or {})

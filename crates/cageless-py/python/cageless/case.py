"""A case: one computation, complete."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from typing import Any

from . import _cageless
from .computations import Computations
from .errors import InputError
from .section import Section, table
from .sections import (
    Bearing,
    Contact,
    Housing,
    Material,
    Model,
    Operation,
    Output,
    Raceway,
    Rotor,
    Solver,
    Start,
    Support,
)

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


Keys = Mapping[str, Any]
"""The keys of a section with their values."""


def keys_of(section: Section | Keys) -> dict[str, Any]:
    """The keys of a section that are given, with their values."""
    return section.values() if isinstance(section, Section) else dict(section)


def dotted(values: Mapping[str, Any], section: str = "") -> dict[str, Any]:
    """Sections in sections as ``section.key``."""
    found: dict[str, Any] = {}
    for key, value in values.items():
        name = f"{section}.{key}" if section else str(key)
        inner = value.values() if isinstance(value, Section) else value
        if isinstance(inner, Mapping):
            found |= dotted(inner, name)
        else:
            found[name] = inner
    return found


def changes(values: Mapping[str, Any]) -> list[str]:
    """``section.key=value`` for each, as ``--set`` takes it."""
    written = {key: _cageless.to_toml({key: value}) for key, value in dotted(values).items()}
    return [f"{key}={text.split('=', 1)[1].strip()}" for key, text in written.items()]


#: Classes of the sections of which a case has one at most.
SECTIONS: dict[str, type[Section]] = {
    "bearing": Bearing,
    "material": Material,
    "ball_material": Material,
    "ring_material": Material,
    "operation": Operation,
    "contact": Contact,
    "model": Model,
    "start": Start,
    "solver": Solver,
    "housing": Housing,
    "rotor": Rotor,
    "support": Support,
    "output": Output,
}


class Case(Computations):
    """A bearing, its operation and how it is to be simulated, checked when it is made.

    Parameters
    ----------
    bearing : Bearing
        Rings and balls. This and every other section may be a mapping of its keys.
    operation : Operation
        Speed and load.
    ball_material, ring_material : Material, optional
        Material of the balls or of the rings, if it is not that of both.
    material, contact, model, solver, output
        Further sections of a case file. A section, or a key of it, that is left out takes the
        default of the case file: its value in :func:`template`.
    raceway : Raceway or sequence of Raceway, optional
        Discrete raceways; none for a conventional outer ring.
    start : Start, optional
        Initial state.
    housing : Housing, optional
        Support of the outer ring.
    rotor : Rotor, optional
        A rotor that falls onto the inner ring; `operation` then has neither speed nor load.
    support : Support, optional
        What carries the outer ring under a falling rotor.
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
    ...         inner_ring_mass_kg=0.2, inner_ring_damping_n_s_m=2000.0,
    ...     ),
    ...     raceway=Raceway(axial_span_mm=5.1, half_angle_deg=25.2),
    ...     operation=Operation(inner_speed_rpm=12000.0, radial_load_n=1500.0),
    ...     solver=Solver(duration_s=0.002),
    ... )
    >>> case.contact.friction_coefficient, case.operation.gravity_m_s2
    (0.007, 9.81)
    >>> case.replace({"raceway.half_angle_deg": 500.0})
    Traceback (most recent call last):
    cageless.errors.InputError: raceway.half_angle_deg = 500.0 is not possible: ...
    """

    _sections: dict[str, Any]
    bearing: Bearing
    operation: Operation
    material: Material
    ball_material: Material | None
    ring_material: Material | None
    contact: Contact
    model: Model
    solver: Solver
    output: Output
    start: Start
    housing: Housing | None
    rotor: Rotor | None
    support: Support | None

    def __init__(
        self,
        *,
        bearing: Bearing | Keys,
        operation: Operation | Keys,
        material: Material | Keys | None = None,
        ball_material: Material | Keys | None = None,
        ring_material: Material | Keys | None = None,
        contact: Contact | Keys | None = None,
        model: Model | Keys | None = None,
        solver: Solver | Keys | None = None,
        output: Output | Keys | None = None,
        raceway: Raceway | Keys | Sequence[Raceway | Keys] | None = None,
        start: Start | Keys | None = None,
        housing: Housing | Keys | None = None,
        rotor: Rotor | Keys | None = None,
        support: Support | Keys | None = None,
        title: str = "",
    ) -> None:
        several = [raceway] if isinstance(raceway, (Raceway, Mapping)) else list(raceway or [])
        own = locals()
        given: dict[str, Section | Keys | None] = {name: own[name] for name in SECTIONS}
        values: dict[str, Any] = {"title": title} if title else {}
        values |= {name: keys_of(part) for name, part in given.items() if part is not None}
        if several:
            sections = [keys_of(each) for each in several]
            values["raceway"] = sections[0] if len(sections) == 1 else sections
        self._take(_cageless.CaseFile.of_values(values))

    def _take(self, file: Any) -> None:
        self._file = file
        self._sections = json.loads(file.document(False))

    @classmethod
    def _of(cls, file: Any) -> Case:
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
            Values for keys ``section.key``, as ``--set`` gives them to the command, or
            sections in sections.

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

    @classmethod
    def from_designation(cls, designation: str, *, full_complement: bool = False) -> Case:
        """A deep groove ball bearing of ISO 15, as ``cageless new --bearing`` writes it. Number
        and diameter of the balls are as NSK, from its load ratings, where the table has them; the
        rest, speed and load are assumed, and the ring is conventional.

        Parameters
        ----------
        designation : str
            Series 60, 62, 63, 160, 68 (618) or 69 (619), bores up to 100 mm.
        full_complement : bool
            As many balls as the pitch circle holds.

        Raises
        ------
        InputError
            If the table has no such bearing.

        Examples
        --------
        >>> import cageless
        >>> cageless.Case.from_designation("6008", full_complement=True)
        <Case '6008, full complement': 21 balls, conventional>
        """
        text = _cageless.designated(designation, full_complement)
        return cls.from_toml(text, name=designation)

    def replace(self, changes: Mapping[str, Any] | None = None, /, **keywords: Any) -> Case:
        """The case with other values.

        Parameters
        ----------
        changes : mapping, optional
            Values for keys ``section.key``, or ``raceway.2.key`` for the second of several. A
            dictionary or a section is merged into that of its name: keys that it does not give
            stay as they are.
        **keywords
            The same as keywords, with two underscores for the dot: ``section__key=value``, or
            ``section={"key": value}``.

        Examples
        --------
        >>> import cageless
        >>> case = cageless.Case.from_toml(cageless.template())
        >>> case.replace({"raceway.half_angle_deg": 24.0}).raceways[0].half_angle_deg
        24.0
        >>> case.replace(raceway__half_angle_deg=24.0, title="narrow").raceways[0]
        Raceway(axial_span_mm=5.1, half_angle_deg=24.0, centre_angle_deg=0.0, depth_error_um=0.0)
        >>> other = case.replace(raceway={"half_angle_deg": 24.0}, title="narrow")
        >>> other == case.replace({"raceway": {"half_angle_deg": 24.0}, "title": "narrow"})
        True
        """
        named = {name.replace("__", "."): value for name, value in keywords.items()}
        merged = dotted(changes or {})
        for key, value in dotted(named).items():
            if key in merged:
                raise InputError(f"{key} is given twice", key)
            merged[key] = value
        return Case._of(self._file.changed(_changes(merged)))

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
    def raceways(self) -> tuple[Raceway, ...]:
        """Discrete raceways."""
        found = self._sections.get("raceway", [])
        several = found if isinstance(found, list) else [found]
        return tuple(Raceway(**each) for each in several)

    def __getattr__(self, name: str) -> Any:
        if name not in SECTIONS:
            raise AttributeError(f"Case has no {name!r}")
        found = self._sections.get(name)
        return None if found is None else SECTIONS[name](**found)

    @property
    def radial_internal_clearance_um(self) -> float:
        """Gr = 2 (Ro − Ri − 2 Rw), radial internal clearance of ISO 5753-1."""
        return self._file.derived()["radial_internal_clearance_um"]

    @property
    def epsilon_deg(self) -> float:
        """ε of Zhao 2022, Eq. (10): angular ball pitch at contact."""
        return self._file.derived()["epsilon_deg"]

    @property
    def uniform_gap_deg(self) -> float:
        """360°/N − ε."""
        return self._file.derived()["uniform_gap_deg"]

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

"""A case: one computation, complete."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from . import _cageless, sections
from .arguments import checked
from .computations import Computations
from .section import Section, table
from .sections import Limit, Raceway, Row
from .toml import toml

if TYPE_CHECKING:
    from typing_extensions import Self, Unpack

__all__ = ["Case", "template"]


@checked
def template(conventional: bool = False) -> str:
    """A commented case file, that of ``cageless new``, `conventional` without a discrete raceway.

    Examples:
        >>> import cageless
        >>> cageless.Case.from_toml(cageless.template()).bearing.balls
        14
    """
    return _cageless.template(conventional)


def keys_of(section: Section | Mapping[str, Any]) -> dict[str, Any]:
    """The keys of a section that are given, with their values."""
    return section.values() if isinstance(section, Section) else dict(section)


class Case(Computations, sections.OfCase):
    """A bearing, its operation and how it is to be simulated, checked when it is made.

    Keywords are the sections of a case file, each as its class or as a mapping of its keys:
    ``bearing`` and ``operation`` (speed and load), required; ``raceway``, the discrete raceways, one or
    several, none for a conventional outer ring; ``material`` of balls and rings, ``ball_material`` and
    ``ring_material`` where it is not that of both; ``contact``, ``model``, ``start`` (the initial state),
    ``solver``, ``output``; ``housing``, the support of the outer ring; ``fit``, from which the clearance in
    operation follows; ``lubrication``, for ratings;
    ``rotor``, which falls onto the inner ring (``operation`` then has neither speed nor load), and the
    ``support`` of the outer ring under it; ``title``, free text. A section, or a key of it, that is left out takes the default of the
    case file: its value in :func:`template`.

    Raises:
        InputError: If the case cannot be, with the key at fault.

    Examples:
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

    _name = "case"

    def __init__(self, **given: Unpack[sections.Arguments]) -> None:
        for name in ("bearing", "operation"):
            if name not in given:
                raise TypeError(f"Case() misses {name}")
        values: dict[str, Any] = {}
        parts: dict[str, Any] = {**given}
        for name, part in parts.items():
            if name not in sections.Arguments.__annotations__:
                raise TypeError(f"Case() has no argument {name!r}")
            if isinstance(part, (Section, Mapping)):
                values[name] = keys_of(part)
            elif isinstance(part, (str, int)):
                values[name] = part
            elif part is not None:
                values[name] = [keys_of(each) for each in part]
        self._file = _cageless.File.of_values(toml(values))

    @classmethod
    def from_designation(cls, designation: str, *, full_complement: bool = False) -> Self:
        """A deep groove ball bearing of ISO 15, or two angular contact ball bearings back to back, as
        ``cageless new --bearing`` writes it. Number and diameter of the balls are as NSK, from its load
        ratings, where the table has them; the rest, speed and load are assumed, and the ring is
        conventional.

        Args:
            designation: Series 60, 62, 63, 160, 68 (618) or 69 (619), or 70, 72, 73 or 719 with C, AC
                or B, bores up to 100 mm.
            full_complement: As many balls as the pitch circle holds.

        Raises:
            InputError: If the table has no such bearing.

        Examples:
            >>> import cageless
            >>> cageless.Case.from_designation("6008", full_complement=True)
            <Case '6008, full complement': 21 balls, conventional>
        """
        return cls.from_toml(_cageless.designated(designation, full_complement), name=designation)

    def with_raceways(self, *raceways: Raceway | Mapping[str, Any]) -> Case:
        """The case with these discrete raceways in place of its own; none for a conventional
        ring.

        Examples:
            >>> import cageless
            >>> case = cageless.Case.from_toml(cageless.template())
            >>> case.with_raceways()
            <Case 'Zhao 2022, structure (d)': 14 balls, conventional>
        """
        values = {key: section for key, section in self._document.items() if key != "raceway"}
        if raceways:
            values["raceway"] = [keys_of(each) for each in raceways]
        return Case._of(_cageless.File.of_values(toml(values)))

    def to_dict(self) -> dict[str, Any]:
        """The case as run: every default, the stiffnesses of Hertz and the step filled in."""
        found: dict[str, Any] = json.loads(self._file.document(True))
        return found

    @property
    def defaults(self) -> list[str]:
        """Keys that took their default."""
        return self._file.defaults()

    @property
    def raceways(self) -> tuple[Raceway, ...]:
        """Discrete raceways."""
        return tuple(Raceway(**each) for each in self._several("raceway"))

    @property
    def rows(self) -> tuple[Row, ...]:
        """Rows of balls on one inner ring; none for a single row."""
        return tuple(Row(**each) for each in self._several("row"))

    @property
    def limits(self) -> tuple[Limit, ...]:
        """Limits on results of a drop."""
        return tuple(Limit(**each) for each in self._several("limit"))

    def _several(self, name: str) -> list[dict[str, Any]]:
        """Sections of one name."""
        found = self._document.get(name, [])
        return found if isinstance(found, list) else [found]

    def __getattr__(self, name: str) -> Any:
        if name not in sections.OfCase.__annotations__:
            raise AttributeError(f"Case has no {name!r}")
        found = self._document.get(name)
        return None if found is None else getattr(sections, name.rpartition("_")[2].capitalize())(**found)

    @property
    def radial_internal_clearance_um(self) -> float:
        """Gr = 2 (Ro − Ri − 2 Rw), radial internal clearance of ISO 5753-1."""
        return self._file.derived()[0]

    @property
    def epsilon_deg(self) -> float:
        """ε of Zhao 2022, Eq. (10): angular ball pitch at contact."""
        return self._file.derived()[1]

    @property
    def uniform_gap_deg(self) -> float:
        """360°/N − ε."""
        return self._file.derived()[2]

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

"""Rotors on several touch-down bearings."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _cageless
from .arguments import Fixed, number, refused
from .case import Case
from .document import Document, Progress, dotted
from .errors import InputError
from .results import Drop
from .ross_rotor import RossRotor
from .section import table

__all__ = ["LinearRotor", "RotorCase"]

class LinearRotor(Fixed):
    """A rotor with linear lateral motion: rigid in up to two bearings, or any by its matrices.

    The speed is common to the whole rotor; x, y and z are the frame of the cases, z along the axis.

    Attributes:
        mass_kg: Mass, without housings.
        polar_inertia_kg_m2: Moment of inertia about the axis of rotation.
        mass_shares_kg: Part of the mass that each bearing carries when the rotor rests in them horizontally.
        coordinates: Number of coordinates after the reduction.
    """

    mass_kg: float
    polar_inertia_kg_m2: float
    mass_shares_kg: list[float]
    coordinates: int

    def __init__(self, rotor: Any) -> None:
        self._rotor = rotor
        names = ("mass_kg", "polar_inertia_kg_m2", "mass_shares_kg", "coordinates")
        vars(self).update(zip(names, rotor.numbers(), strict=True))

    def __repr__(self) -> str:
        shares = ", ".join(f"{share:.3g}" for share in self.mass_shares_kg)
        return f"<LinearRotor: {self.mass_kg:.4g} kg, in its bearings {shares} kg>"

    @classmethod
    def rigid(
        cls,
        *,
        mass_kg: float,
        polar_inertia_kg_m2: float,
        transverse_inertia_kg_m2: float,
        bearing_axial_mm: Sequence[float],
        unbalances: Iterable[tuple[float, float, float]] = (),
        clearances: Iterable[tuple[str, float, float]] = (),
    ) -> LinearRotor:
        """A rigid rotor in one or two bearings.

        Args:
            bearing_axial_mm: Place of each touch-down bearing along the axis, from the mass centre.
            unbalances: (axial_mm, amount_g_mm, angle_deg): place, m·ε and direction at the start of
                each unbalance.
            clearances: (name, axial_mm, radial_um): name, place and radial clearance to the stator of
                magnetic bearings, seals or impellers; a drop that displaces the rotor further fails.

        Raises:
            InputError: If a value is out of range.
        """
        # A whole number would be a node.
        places = [float(z) for z in bearing_axial_mm]
        listed = [(float(z), u, phase) for z, u, phase in unbalances]
        planes = [(name, float(z), limit) for name, z, limit in clearances]
        body = (mass_kg, polar_inertia_kg_m2, transverse_inertia_kg_m2)
        return cls(_cageless.LinearRotor(body, places, listed, planes))

    @classmethod
    def from_matrices(
        cls,
        M: npt.ArrayLike,
        K: npt.ArrayLike,
        C: npt.ArrayLike | None = None,
        G: npt.ArrayLike | None = None,
        Ksdt: npt.ArrayLike | None = None,
        Ma: npt.ArrayLike | None = None,
        *,
        polar_inertia_kg_m2: float,
        nodes: Sequence[int],
        housings: int = 0,
        kept_nodes: Sequence[int] = (),
        unbalances: Iterable[tuple[int, float, float]] = (),
        clearances: Iterable[tuple[str, int, float]] = (),
        frequency_max_hz: float | None = None,
    ) -> LinearRotor:
        """A rotor by its matrices, (M + Ma)·q̈ + (C + Ω·G)·q̇ + (K + Ω̇·Ksdt)·q = f.

        α and β are rotations about X and Y: dx/dz = β and dy/dz = −α in a rigid tilt. Ω is positive from
        X to Y, so that a disc has +Ip in row α and column β of G, and −Ip in row β and column α; with
        the opposite sign forward and backward precession are interchanged.

        Args:
            M, K, C, G, Ksdt, Ma: Matrices whose rows and columns are the coordinates [x, y, α, β] of each
                node in turn, then [x, y] of each housing, in m and rad; sparse ones of SciPy are made
                dense. C, G, Ksdt and Ma, the mass without weight of a fluid in seals, are 0 if left out.
            polar_inertia_kg_m2: Moment of inertia of the whole rotor about its axis.
            nodes: Node of each touch-down bearing, from 0.
            housings: Number of housings on which springs of K hold the rotor.
            kept_nodes: Further nodes whose displacements the reduction keeps, those of sensors.
            unbalances: (node, amount_g_mm, angle_deg): node, m·ε and direction at the start of each
                unbalance.
            clearances: (name, node, radial_um): name, node and radial clearance to the stator, as in
                :meth:`rigid`; the nodes are kept.
            frequency_max_hz: Modes with all of these nodes held are kept up to this frequency (Craig
                and Bampton); default: all of them.

        Raises:
            InputError: If the matrices cannot be those of a rotor, or a node does not exist.
        """
        mass = _matrix("M", M)
        given = (("Ma", Ma), ("C", C), ("G", G), ("K", K), ("Ksdt", Ksdt))
        others = [np.zeros_like(mass) if one is None else _matrix(name, one) for name, one in given]
        arrays = [mass, *others]
        kept = [_node(node) for node in kept_nodes]
        listed = [(_node(node), u, phase) for node, u, phase in unbalances]
        planes = [(name, _node(node), limit) for name, node, limit in clearances]
        count = _whole("housings", housings)
        body = (arrays, count, polar_inertia_kg_m2, kept, frequency_max_hz)
        return cls(_cageless.LinearRotor(body, [_node(n) for n in nodes], listed, planes))

    @classmethod
    def from_ross(
        cls,
        rotor: Any,
        nodes: Sequence[int],
        *,
        frequency_rad_s: float = 0.0,
        kept_nodes: Sequence[int] = (),
        unbalances: Iterable[tuple[int, float, float]] = (),
        clearances: Iterable[tuple[str, int, float]] = (),
        frequency_max_hz: float | None = None,
    ) -> LinearRotor:
        """A rotor of ROSS, or anything with its methods ``M()``, ``C()``, ``G()``, ``K()`` and
        ``Ksdt()`` and four or six coordinates a node (``number_dof``). ROSS 2.3 does not import with
        Plotly 7: install ``plotly<7`` next to it.

        Mass, moment of inertia about the axis and the lowest natural frequencies are compared with
        those of ROSS. Magnetic bearings, which have no power in a drop, and housings that nothing
        else connects with the shaft are left out, with a warning that names them. Other bearings
        stay, with a warning, and so do the housings on which they rest (``n_link``, ``PointMass``);
        the mass that a bearing or a seal adds has no weight. Axial motion and torsion are left out.

        Args:
            nodes: Node of each touch-down bearing, from 0.
            frequency_rad_s: Frequency at which coefficients that depend on one are taken.
            kept_nodes, unbalances, clearances, frequency_max_hz: As those of :meth:`from_matrices`.

        Raises:
            InputError: As in :meth:`from_matrices`, or if the rotor has several speeds (``MultiRotor``,
                ``CoAxialRotor``), a housing without a spring, lateral motion that depends on any
                other, no moment of inertia, or another mass, inertia or frequency than in ROSS.
        """
        found = RossRotor.of(rotor, number("frequency_rad_s", frequency_rad_s))
        made = cls.from_matrices(
            **found.matrices,
            polar_inertia_kg_m2=found.polar_inertia_kg_m2,
            nodes=nodes,
            housings=found.housings,
            kept_nodes=kept_nodes,
            unbalances=unbalances,
            clearances=clearances,
            frequency_max_hz=frequency_max_hz,
        )
        found.check_frequencies(made.frequencies_hz(), frequency_max_hz)
        return made

    def frequencies_hz(self) -> npt.NDArray[np.float64]:
        """Natural frequencies at rest without contact and damping, of rigid motions 0."""
        return np.array(self._rotor.frequencies_hz())

    def eigenvalues(self, speed_rpm: float) -> npt.NDArray[np.complex128]:
        """Eigenvalues of the lateral motion without contact at a speed, 1/s, by rising imaginary
        part: real part the growth, imaginary part the angular frequency."""
        pairs = self._rotor.eigenvalues(number("speed_rpm", speed_rpm))
        values = np.array([complex(*pair) for pair in pairs])
        return values[np.argsort(values.imag, kind="stable")]

    def save_matrices(self, path: str | os.PathLike[str]) -> Path:
        """Writes the matrices for the key ``rotor.matrices`` of a rotor file, which it returns; an
        ``InputError`` if the rotor is rigid."""
        self._rotor.save_matrices(os.fspath(path))
        return Path(path)

    def drop(
        self,
        cases: Sequence[Case],
        *,
        speed_rpm: float,
        drive_torque_n_m: float = 0.0,
        title: str = "",
        compare: bool = False,
        samples: int | None = None,
        verify: bool = False,
        drops: int | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Drop:
        """Drops the rotor into its bearings: :meth:`RotorCase.drop` of a :class:`RotorCase`, with the
        arguments of both."""
        machine = RotorCase(
            self, cases, speed_rpm=speed_rpm, drive_torque_n_m=drive_torque_n_m, title=title
        )
        return machine.drop(
            compare=compare,
            samples=samples,
            verify=verify,
            drops=drops,
            threads=threads,
            progress=progress,
        )


class RotorCase(Document):
    """A rotor on several touch-down bearings with the case of each: what a rotor file holds.

    Args:
        rotor: The rotor with the places of its bearings.
        cases: The case of each bearing. Its ``rotor`` describes the contact of journal and bore, and
            the position and velocity of the journal at the start of the drop; mass, inertia,
            unbalance, speed and drive are replaced by those of the rotor.
        speed_rpm: Speed at the start of the drop.
        drive_torque_n_m: Torque on the rotor.
        title: Free text.

    Raises:
        InputError: If the cases do not fit the rotor or each other.
    """

    _name = "rotor"

    def __init__(
        self,
        rotor: LinearRotor,
        cases: Sequence[Case],
        *,
        speed_rpm: float,
        drive_torque_n_m: float = 0.0,
        title: str = "",
    ) -> None:
        several = [_file(case) for case in ([cases] if isinstance(cases, (str, Case)) else cases)]
        speed, torque = number("speed_rpm", speed_rpm), number("drive_torque_n_m", drive_torque_n_m)
        self._file = _cageless.File.of_rotor(rotor._rotor, several, title, speed, torque)

    def __repr__(self) -> str:
        count = len(self._file.cases())
        return f"<RotorCase {self.title!r}: {self.rotor.mass_kg:.4g} kg in {count} bearings>"

    def _repr_html_(self) -> str:
        keys = dotted(self._document).items()
        rows = [(key, value) for key, value in keys if not key.startswith("rotor.matrices.")]
        return table(rows, self.title or "Rotor")

    @property
    def rotor(self) -> LinearRotor:
        """The rotor with the places of its bearings."""
        return LinearRotor(self._file.rotor())

    @property
    def cases(self) -> list[Case]:
        """The case of each bearing."""
        return [Case._of(file) for file in self._file.cases()]

    @property
    def speed_rpm(self) -> float:
        """Speed at the start of the drop."""
        return float(self._document["rotor"]["speed_rpm"])

    @property
    def drive_torque_n_m(self) -> float:
        """Torque on the rotor."""
        return float(self._document["rotor"]["drive_torque_n_m"])


def _file(case: Any) -> Any:
    """The file of the case of a bearing."""
    if not isinstance(case, Case):
        raise refused("cases", case, "a Case for each bearing, of a file Case.from_file(path)")
    return case._file


def _matrix(name: str, values: Any) -> npt.NDArray[np.float64]:
    """A matrix of numbers, also of a sparse one."""
    try:
        array = np.asarray(values.toarray() if hasattr(values, "toarray") else values, dtype=float)
    except (TypeError, ValueError):
        raise InputError(f"matrix {name} must be of numbers, in rows of one length") from None
    if array.ndim != 2:
        raise InputError(f"matrix {name} has {array.ndim} dimensions: must have 2")
    return np.ascontiguousarray(array)


def _node(node: int) -> int:
    return _whole("node", node)


def _whole(name: str, value: int) -> int:
    if isinstance(value, bool) or int(value) != value or value < 0:
        raise InputError(f"{name} = {value} is not possible: it must be a whole number, 0 or more")
    return int(value)

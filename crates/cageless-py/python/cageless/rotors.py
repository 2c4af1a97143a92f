"""Rotors on several touch-down bearings."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _cageless
from .errors import InputError
from .results import Drop, complete

if TYPE_CHECKING:
    from .case import Case

__all__ = ["LinearRotor", "RotorCase"]

Matrix = npt.NDArray[np.float64]
#: Lateral coordinates [x, y, α, β] among those of a node, by their number.
LATERAL = {4: [0, 1, 2, 3], 6: [0, 1, 3, 4]}
#: Rotation about the axis among the six coordinates of a node.
TORSION = 5


class LinearRotor:
    """A rotor with linear lateral motion: rigid in up to two bearings, or any by its matrices.

    The speed is common to the whole rotor; x, y and z are the frame of the cases, z along the axis.
    """

    def __init__(self, rotor: Any) -> None:
        self._rotor = rotor

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

        Parameters
        ----------
        bearing_axial_mm : sequence of float
            Place of each touch-down bearing along the axis, from the mass centre.
        unbalances : iterable of (axial_mm, amount_g_mm, angle_deg)
            Place, m·ε and direction at the start of each unbalance.
        clearances : iterable of (name, axial_mm, radial_um)
            Name, place and radial clearance to the stator of magnetic bearings, seals or
            impellers: a drop that displaces the rotor further fails.

        Raises
        ------
        InputError
            If a value is out of range.
        """
        listed = [(float(z), float(u), float(phase)) for z, u, phase in unbalances]
        planes = [(str(name), float(z), float(limit)) for name, z, limit in clearances]
        places = [float(z) for z in bearing_axial_mm]
        inertia = (float(polar_inertia_kg_m2), float(transverse_inertia_kg_m2))
        return cls(_cageless.LinearRotor.rigid(float(mass_kg), *inertia, places, listed, planes))

    @classmethod
    def from_matrices(
        cls,
        M: npt.ArrayLike,
        K: npt.ArrayLike,
        C: npt.ArrayLike | None = None,
        G: npt.ArrayLike | None = None,
        Ksdt: npt.ArrayLike | None = None,
        *,
        polar_inertia_kg_m2: float,
        nodes: Sequence[int],
        kept_nodes: Sequence[int] = (),
        unbalances: Iterable[tuple[int, float, float]] = (),
        clearances: Iterable[tuple[str, int, float]] = (),
        frequency_max_hz: float | None = None,
    ) -> LinearRotor:
        """A rotor by its matrices, M·q̈ + (C + Ω·G)·q̇ + (K + Ω̇·Ksdt)·q = f.

        Parameters
        ----------
        M, K, C, G, Ksdt : array_like
            Rows and columns are the coordinates [x, y, α, β] of each node in turn, in m and rad. C,
            G and Ksdt are 0 if left out.
        polar_inertia_kg_m2 : float
            Moment of inertia of the whole rotor about its axis.
        nodes : sequence of int
            Node of each touch-down bearing, from 0.
        kept_nodes : sequence of int
            Further nodes whose displacements the reduction keeps, those of sensors.
        unbalances : iterable of (node, amount_g_mm, angle_deg)
            Node, m·ε and direction at the start of each unbalance.
        clearances : iterable of (name, node, radial_um)
            Name, node and radial clearance to the stator, as in :meth:`rigid`; the nodes are kept.
        frequency_max_hz : float, optional
            Modes with all of these nodes held are kept up to this frequency (Craig and Bampton);
            default: all of them.

        Raises
        ------
        InputError
            If the matrices cannot be those of a rotor, or a node does not exist.
        """
        mass = _matrix("M", M)
        given = {"C": C, "G": G, "K": K, "Ksdt": Ksdt}
        rest = {
            name: np.zeros_like(mass) if matrix is None else _matrix(name, matrix)
            for name, matrix in given.items()
        }
        listed = [(_node(n), float(u), float(phase)) for n, u, phase in unbalances]
        planes = [(str(name), _node(n), float(limit)) for name, n, limit in clearances]
        return cls(
            _cageless.LinearRotor.from_matrices(
                mass,
                rest["C"],
                rest["G"],
                rest["K"],
                rest["Ksdt"],
                float(polar_inertia_kg_m2),
                [_node(n) for n in nodes],
                [_node(n) for n in kept_nodes],
                listed,
                planes,
                frequency_max_hz,
            )
        )

    @classmethod
    def from_ross(
        cls,
        rotor: Any,
        nodes: Sequence[int],
        *,
        kept_nodes: Sequence[int] = (),
        unbalances: Iterable[tuple[int, float, float]] = (),
        clearances: Iterable[tuple[str, int, float]] = (),
        frequency_max_hz: float | None = None,
        frequency_rad_s: float = 0.0,
    ) -> LinearRotor:
        """A rotor of ROSS, or anything with its methods ``M()``, ``C()``, ``G()``, ``K()`` and
        ``Ksdt()`` and four or six coordinates a node (``number_dof``).

        ROSS 2.3.0 does not import with Plotly 7: install ``plotly<7`` next to it.

        Its bearings should be what holds the rotor in the drop, so none or seals.
        Axial motion and torsion are left out; the moment of inertia about the axis is that of the
        torsion.

        Parameters
        ----------
        nodes : sequence of int
            Node of each touch-down bearing, from 0.
        frequency_rad_s : float
            Frequency at which coefficients that depend on one are taken.

        Raises
        ------
        InputError
            As in :meth:`from_matrices`, or without a moment of inertia: four coordinates a node and
            no attribute ``Ip``.
        """
        matrices = {
            name: np.asarray(_at(getattr(rotor, name), frequency_rad_s), dtype=float)
            for name in ("M", "C", "G", "K", "Ksdt")
        }
        size = matrices["M"].shape[0]
        own = getattr(rotor, "number_dof", None)
        per_node = 6 if own is None and size % 6 == 0 else 4 if own is None else int(own)
        if per_node not in LATERAL or size % per_node:
            raise InputError(
                f"a rotor of {size} coordinates, {per_node} a node: nodes have 4 or 6 coordinates"
            )
        starts = per_node * np.arange(size // per_node)[:, np.newaxis]
        lateral = (starts + LATERAL[per_node]).ravel()
        if per_node == 6:
            torsion = starts.ravel() + TORSION
            inertia = float(matrices["M"][np.ix_(torsion, torsion)].sum())
        elif hasattr(rotor, "Ip"):
            inertia = float(np.sum(rotor.Ip))
        else:
            raise InputError("the rotor has neither torsion nor Ip: its moment of inertia is missing")
        part = {name: matrix[np.ix_(lateral, lateral)] for name, matrix in matrices.items()}
        return cls.from_matrices(
            **part,
            polar_inertia_kg_m2=inertia,
            nodes=nodes,
            kept_nodes=kept_nodes,
            unbalances=unbalances,
            clearances=clearances,
            frequency_max_hz=frequency_max_hz,
        )

    @property
    def mass_kg(self) -> float:
        """Mass."""
        return self._rotor.mass_kg

    @property
    def polar_inertia_kg_m2(self) -> float:
        """Moment of inertia about the axis of rotation."""
        return self._rotor.polar_inertia_kg_m2

    @property
    def mass_shares_kg(self) -> list[float]:
        """Part of the mass that each bearing carries when the rotor rests in them."""
        return self._rotor.mass_shares_kg

    @property
    def coordinates(self) -> int:
        """Number of coordinates after the reduction."""
        return self._rotor.coordinates

    def eigenvalues(self, speed_rpm: float) -> npt.NDArray[np.complex128]:
        """Eigenvalues of the lateral motion without contact at a speed, 1/s, by rising imaginary
        part: real part the growth, imaginary part the angular frequency."""
        pairs = self._rotor.eigenvalues(speed_rpm * np.pi / 30.0)
        values = np.array([complex(*pair) for pair in pairs])
        return values[np.argsort(values.imag, kind="stable")]

    def save_matrices(self, path: str | os.PathLike[str]) -> Path:
        """Writes the matrices for the key ``rotor.matrices`` of a rotor file.

        Returns
        -------
        Path
            The file.

        Raises
        ------
        InputError
            If the rotor is rigid.
        """
        self._rotor.save_matrices(os.fspath(path))
        return Path(path)

    def drop(
        self,
        cases: Sequence[Case],
        *,
        speed_rpm: float,
        drive_torque_n_m: float = 0.0,
        title: str = "",
        **options: Any,
    ) -> Drop:
        """Drops the rotor into its bearings, as :meth:`RotorCase.drop` with its options."""
        case = RotorCase(
            self, cases, speed_rpm=speed_rpm, drive_torque_n_m=drive_torque_n_m, title=title
        )
        return case.drop(**options)


class RotorCase:
    """A rotor on several touch-down bearings with the case of each: what a rotor file holds.

    Parameters
    ----------
    rotor : LinearRotor
        The rotor with the places of its bearings.
    cases : sequence of Case
        The case of each bearing. Its ``rotor`` describes the contact of journal and bore, and the
        position and velocity of the journal at the start of the drop; mass, inertia, unbalance,
        speed and drive are replaced by those of the rotor.
    speed_rpm : float
        Speed at the start of the drop.
    drive_torque_n_m : float
        Torque on the rotor.
    title : str
        Free text.

    Raises
    ------
    InputError
        If the cases do not fit the rotor or each other.
    """

    def __init__(
        self,
        rotor: LinearRotor,
        cases: Sequence[Case],
        *,
        speed_rpm: float,
        drive_torque_n_m: float = 0.0,
        title: str = "",
    ) -> None:
        self._file = _cageless.RotorFile.of(
            rotor._rotor,
            [case._file for case in cases],
            title,
            float(speed_rpm),
            float(drive_torque_n_m),
        )

    @classmethod
    def _of(cls, file: Any) -> RotorCase:
        case = cls.__new__(cls)
        case._file = file
        return case

    @classmethod
    def from_file(
        cls, path: str | os.PathLike[str], changes: Mapping[str, Any] | None = None
    ) -> RotorCase:
        """Reads a rotor file.

        Parameters
        ----------
        path : path
            TOML.
        changes : mapping, optional
            Values as ``--set`` gives them to ``cageless drop``: for keys of the rotor file, for
            ``section.key`` of the cases of all bearings, for ``bearing.2.section.key`` of one.
        """
        return cls._of(_cageless.RotorFile.read(os.fspath(path), _changed(changes or {})))

    @classmethod
    def from_toml(
        cls,
        text: str,
        changes: Mapping[str, Any] | None = None,
        folder: str | os.PathLike[str] = ".",
    ) -> RotorCase:
        """Reads the text of a rotor file; paths in it are relative to `folder`."""
        changed = _changed(changes or {})
        return cls._of(_cageless.RotorFile.parse(text, "rotor", os.fspath(folder), changed))

    def to_toml(self) -> str:
        """A rotor file that needs no other: with its cases and matrices, every default filled
        in."""
        return self._file.to_toml()

    def replace(self, changes: Mapping[str, Any]) -> RotorCase:
        """The same with changes, as :meth:`from_file` takes them."""
        return RotorCase._of(self._file.changed(_changed(changes)))

    def _document(self) -> dict[str, Any]:
        found: dict[str, Any] = json.loads(self._file.document())
        return found

    def __eq__(self, other: object) -> bool:
        return isinstance(other, RotorCase) and self._file == other._file

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        return (RotorCase.from_toml, (self.to_toml(),))

    def __repr__(self) -> str:
        count = len(self._file.cases())
        return f"<RotorCase {self.title!r}: {self.rotor.mass_kg:.4g} kg in {count} bearings>"

    @property
    def rotor(self) -> LinearRotor:
        """The rotor with the places of its bearings."""
        return LinearRotor(self._file.rotor())

    @property
    def cases(self) -> list[Case]:
        """The case of each bearing."""
        from .case import Case

        return [Case._of(file) for file in self._file.cases()]

    @property
    def speed_rpm(self) -> float:
        """Speed at the start of the drop."""
        return self._file.speed_rpm

    @property
    def drive_torque_n_m(self) -> float:
        """Torque on the rotor."""
        return self._file.drive_torque_n_m

    @property
    def title(self) -> str:
        """Free text."""
        return self._file.title

    def drop(
        self,
        *,
        compare: bool = False,
        samples: int | None = None,
        verify: bool = False,
        threads: int | None = None,
        progress: Callable[[str, float], object] | None = None,
    ) -> Drop:
        """Drops the rotor into its bearings, as ``cageless drop`` does with a rotor file; the options
        are those of :meth:`Case.drop`. Scattered drops scatter friction, touch-down clearance, support damping
        and arrangement of the balls in each bearing on its own, and rotate all unbalances by one
        angle.

        Raises
        ------
        InputError
            If ``samples`` is impossible.
        UnphysicalError
            If the drop left the physical range.
        """
        return complete(Drop(self._file.drop(compare, samples, verify, threads, progress)))


def _changed(values: Mapping[str, Any]) -> list[str]:
    from .case import changes

    return changes(values)


def _matrix(name: str, values: npt.ArrayLike) -> Matrix:
    matrix = np.ascontiguousarray(np.asarray(values, dtype=float))
    if matrix.ndim != 2:
        raise InputError(f"matrix {name} has {matrix.ndim} dimensions: must have 2")
    return matrix


def _node(node: int) -> int:
    if isinstance(node, bool) or int(node) != node or node < 0:
        raise InputError(f"node = {node} is not possible: it must be a whole number, 0 or more")
    return int(node)


def _at(method: Callable[..., Any], frequency_rad_s: float) -> Any:
    """The matrix at a frequency, of a method that takes one or none."""
    try:
        return method(frequency_rad_s)
    except TypeError:
        return method()

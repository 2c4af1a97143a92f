"""Rotors above several touchdown bearings, and their drops."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _cageless, folders, pages
from .drops import Drop, Studied, scalars
from .errors import InputError, UnphysicalError

if TYPE_CHECKING:
    import pandas as pd

    from .case import Case

__all__ = ["LinearRotor", "RotorDrop"]

Matrix = npt.NDArray[np.float64]
#: Lateral coordinates [x, y, α, β] among those of a node, by their number.
LATERAL = {4: [0, 1, 2, 3], 6: [0, 1, 3, 4]}
#: Rotation about the axis among the six coordinates of a node.
TORSION = 5


class LinearRotor:
    """A rotor with linear lateral motion: rigid in up to two bearings, or any by its matrices.

    The speed is common to the whole rotor; x, y and z are the frame of the cases, z along the axis.
    """

    def __init__(self, rotor: _cageless.LinearRotor) -> None:
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
    ) -> LinearRotor:
        """A rigid rotor in one or two bearings.

        Parameters
        ----------
        bearing_axial_mm : sequence of float
            Place of each touchdown bearing along the axis, from the mass centre.
        unbalances : iterable of (axial_mm, moment_g_mm, phase_deg)
            Place, m·ε and direction at the start of each unbalance.

        Raises
        ------
        InputError
            If a value is out of range.
        """
        listed = [(float(z), float(u), float(phase)) for z, u, phase in unbalances]
        places = [float(z) for z in bearing_axial_mm]
        inertia = (float(polar_inertia_kg_m2), float(transverse_inertia_kg_m2))
        return cls(_cageless.LinearRotor.rigid(float(mass_kg), *inertia, places, listed))

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
            Node of each touchdown bearing, from 0.
        kept_nodes : sequence of int
            Further nodes whose displacements the reduction keeps, those of sensors.
        unbalances : iterable of (node, moment_g_mm, phase_deg)
            Node, m·ε and direction at the start of each unbalance.
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
        frequency_max_hz: float | None = None,
        frequency_rad_s: float = 0.0,
    ) -> LinearRotor:
        """A rotor of ross, or anything with its methods ``M()``, ``C()``, ``G()``, ``K()`` and
        ``Ksdt()`` and four or six coordinates a node (``number_dof``).

        Its bearings should be what holds the rotor after the magnets have let go, so none or seals.
        Axial motion and torsion are left out; the moment of inertia about the axis is that of the
        torsion.

        Parameters
        ----------
        nodes : sequence of int
            Node of each touchdown bearing, from 0.
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
        compare: bool = False,
        samples: int | None = None,
        verify: bool = False,
        threads: int | None = None,
        progress: Callable[[str, float], object] | None = None,
    ) -> RotorDrop:
        """Drops the rotor into its bearings, as ``cageless drop`` does with a rotor file.

        Parameters
        ----------
        cases : sequence of Case
            The case of each bearing. Its ``rotor`` describes the contact of journal and bore, and
            the position and velocity of the journal when the magnets let go; mass, inertia,
            unbalance, speed and drive are replaced by those of the rotor.
        compare : bool
            Drop it into the same bearings with conventional outer rings as well.
        samples : int, optional
            Number of further drops with friction, air gap, support damping and arrangement of the
            balls scattered in each bearing on its own, and the direction of all unbalances turned
            by one angle.
        verify : bool
            Repeat the drop from perturbed starts and at half the step; ``data_verification()``
            classifies the results as converged, statistical or step-biased.
        threads : int, optional
            Number of threads; default: number of cores.
        progress : callable, optional
            Called repeatedly with the name of the task and its completed fraction, 0 to 1.

        Raises
        ------
        InputError
            If the cases do not fit the rotor or each other, or ``samples`` is impossible.
        UnphysicalError
            If the drop left the physical range.
        """
        bearings, summary, page, stopped = self._rotor.drop(
            [case._file for case in cases],
            title,
            float(speed_rpm),
            float(drive_torque_n_m),
            compare,
            samples,
            verify,
            threads,
            progress,
        )
        if stopped is not None:
            raise UnphysicalError(stopped)
        return RotorDrop([Drop(bearing) for bearing in bearings], summary, page)


class RotorDrop(Studied):
    """The drop of a rotor into several bearings; two are equal if their bearings and all of their
    results are."""

    def __init__(self, bearings: list[Drop], summary: str, page: str) -> None:
        self.bearings = bearings
        """What each bearing went through."""
        self._summary, self._page = summary, page

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, RotorDrop):
            return False
        return self.summary == other.summary and self.bearings == other.bearings

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        states = ", ".join(bearing.end_state for bearing in self.bearings)
        return f"<RotorDrop: {states}>"

    @cached_property
    def summary(self) -> dict[str, Any]:
        """``summary.json`` of ``cageless drop`` with a rotor file; under ``conventional``,
        ``ensemble`` and ``verification`` what was asked for beside the drop."""
        found: dict[str, Any] = json.loads(self._summary)
        return found

    def data_drops(self) -> pd.DataFrame:
        """The scattered drops, a row for each drop and bearing: what was drawn, and the scalar
        results. Empty without ``samples``."""
        import pandas as pd

        rows = []
        for drop in self.summary.get("ensemble", {}).get("drops", []):
            of_rotor = {k: v for k, v in drop.items() if k != "bearings"}
            for number, bearing in enumerate(drop["bearings"], 1):
                drawn = {k: v for k, v in bearing.items() if k != "result"}
                results = scalars(bearing["result"])
                # The stop of one bearing ends the drop: the reason of the drop counts.
                results.pop("stopped")
                rows.append({"bearing": number} | of_rotor | drawn | results)
        return pd.DataFrame(rows)

    def data_verification(self) -> pd.DataFrame:
        """Judgement of each result of each bearing by a verified drop, by ``bearing`` and
        ``name``. Empty without ``verify=True``."""
        import pandas as pd

        bearings = self.summary.get("verification", {}).get("bearings", [])
        rows = [
            {"bearing": number} | judgement
            for number, bearing in enumerate(bearings, 1)
            for judgement in bearing["numbers"]
        ]
        frame = pd.DataFrame(rows)
        return frame.set_index(["bearing", "name"]) if len(frame) else frame

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Writes what ``cageless drop --out`` writes: ``summary.json``, the page, and the tables of
        each bearing in a folder of its own.

        Returns
        -------
        Path
            The folder, which is created.
        """
        path = folders.make(folder)
        for k, bearing in enumerate(self.bearings):
            bearing._save_tables(path / f"bearing-{k + 1}")
        folders.write(path, "summary.json", self._summary.encode())
        pages.write(path / "report.html", self._page)
        return path

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Writes the page of ``cageless drop --out``."""
        return pages.write(path, self._page)


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

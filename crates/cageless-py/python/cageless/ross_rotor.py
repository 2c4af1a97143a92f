"""The lateral motion of a rotor of ROSS, with ROSS's own mass, inertia and frequencies or not at all."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from .errors import InputError

__all__ = ["RossRotor"]

Matrix = npt.NDArray[np.float64]

#: Matrices of a rotor of ROSS.
MATRICES = ("M", "C", "G", "K", "Ksdt")
#: Lateral coordinates [x, y, α, β] among those of a node, by their number.
LATERAL = {4: [0, 1, 2, 3], 6: [0, 1, 3, 4]}
#: Rotation about the axis among the six coordinates of a node.
TORSION = 5
#: Kinds of rotors whose shafts turn at speeds of their own.
SEVERAL_SPEEDS = {
    "MultiRotor": "geared shafts turn at different speeds; take one of its rotors, .rotors['driving'] say",
    "CoAxialRotor": "shafts on one axis turn at different speeds; take one shaft as a Rotor",
}
#: Largest difference from a number of ROSS, relative.
DIFFERENCE = 1e-6
#: Largest difference of a natural frequency after the reduction, relative.
REDUCED = 1e-2
#: Lowest natural frequencies that are compared.
FREQUENCIES = 8


@dataclass
class RossRotor:
    """What is taken of a rotor of ROSS.

    Attributes:
        matrices: Matrices of the lateral motion, four coordinates a node.
        polar_inertia_kg_m2: Moment of inertia about the axis.
        mass_kg: Mass of the rotor by ROSS; None of another package.
    """

    matrices: dict[str, Matrix]
    polar_inertia_kg_m2: float
    mass_kg: float | None

    @classmethod
    def of(cls, rotor: Any, frequency_rad_s: float) -> RossRotor:
        """The lateral motion of a rotor; magnetic bearings, and housings that nothing connects with the
        shaft, are left out with a warning.

        Raises:
            InputError: If the rotor is none with one speed and lateral motion of its own.
        """
        for kind in (each.__name__ for each in type(rotor).__mro__):
            if kind in SEVERAL_SPEEDS:
                raise InputError(f"a {kind} is not possible: {SEVERAL_SPEEDS[kind]}")
        whole = {
            name: np.array(_at(getattr(rotor, name), frequency_rad_s), dtype=float)
            for name in MATRICES
        }
        bearings = list(getattr(rotor, "bearing_elements", []))
        magnetic = [each for each in bearings if _is(each, "MagneticBearingElement")]
        for element in magnetic:
            _take_out(whole, element, frequency_rad_s)
        held = [each for each in bearings if each not in magnetic]
        shaft, per_node = _shaft(rotor, whole["M"].shape[0])
        housings = _housings(rotor, whole, shaft, held)
        on_shaft = [each for each in held if each.n < shaft // per_node]
        for element in on_shaft:
            if np.any(_at(getattr(element, "M", np.zeros), frequency_rad_s)):
                raise InputError(
                    f"{_place(element)} adds a mass that has no weight: leave it out, or give it "
                    "mxx = 0 and so on"
                )
        springs = [each for each in on_shaft if _holds(each, frequency_rad_s)]
        for which, why in (
            (magnetic, "left out of the rotor, as a magnetic bearing has no power in a drop: {}"),
            (housings, "left out of the rotor, as nothing connects it with the shaft: {}"),
            (springs, "kept in the rotor, to hold it in the drop as well: {}; build the rotor of ROSS "
             "without what stands for a magnetic bearing"),
        ):
            if which:
                warnings.warn(why.format(_listed(map(_place, which))), UserWarning, stacklevel=5)
        part = {name: matrix[:shaft, :shaft] for name, matrix in whole.items()}
        lateral, inertia = _lateral(rotor, part, per_node)
        found = cls(lateral, inertia, _mass(rotor))
        found.check_mass()
        return found

    def check_mass(self) -> None:
        """Refuses matrices of another mass than that of ROSS."""
        across = self.matrices["M"][1::4, 1::4].sum()
        if self.mass_kg is not None:
            _same("mass", float(across), self.mass_kg, "kg")

    def frequencies_hz(self) -> Matrix:
        """Natural frequencies at rest without damping, all modes."""
        # M = L·Lᵀ: those of L⁻¹·K·L⁻ᵀ.
        inverse = np.linalg.inv(np.linalg.cholesky(self.matrices["M"]))
        stiffness = inverse @ self.matrices["K"] @ inverse.T
        squares = np.linalg.eigvalsh(0.5 * (stiffness + stiffness.T))
        return np.sqrt(squares.clip(min=0.0)) / (2.0 * np.pi)

    def check_frequencies(self, reduced_hz: Iterable[float], kept_hz: float | None) -> None:
        """Refuses a reduction to modes up to `kept_hz` without the lowest natural frequencies."""
        own, found = self.frequencies_hz(), np.sort(np.fromiter(reduced_hz, float))
        # Rigid motions have none but rounding.
        rounding = 1e-7 * own[-1]
        # Above, a reduction keeps too little to be compared.
        compared = own[own < (0.5 * kept_hz if kept_hz else np.inf)][:FREQUENCIES]
        for place, expected in enumerate(compared):
            reduced = found[place] if place < len(found) else np.nan
            if not abs(reduced - expected) <= REDUCED * expected + rounding:
                raise InputError(
                    f"natural frequency {place + 1} of the rotor is {expected:.5g} Hz in ROSS and "
                    f"{reduced:.5g} Hz after the reduction: a larger frequency_max_hz keeps more modes"
                )


def _is(element: Any, kind: str) -> bool:
    return any(each.__name__ == kind for each in type(element).__mro__)


def _place(element: Any) -> str:
    return f"{element.tag} (node {element.n})"


def _listed(texts: Iterable[str]) -> str:
    return ", ".join(texts)


def _at(method: Callable[..., Any], frequency_rad_s: float) -> Any:
    """The matrix at a frequency, of a method that takes one or none."""
    try:
        return method(frequency_rad_s)
    except TypeError:
        return method()


def _holds(element: Any, frequency_rad_s: float) -> bool:
    """Whether an element is a bearing, no seal, and has a stiffness."""
    return not _is(element, "SealElement") and bool(np.any(_at(element.K, frequency_rad_s)))


def _take_out(whole: dict[str, Matrix], element: Any, frequency_rad_s: float) -> None:
    """Subtracts the matrices of an element."""
    places = list(element.dof_global_index.values())
    for name in ("M", "C", "K"):
        own = np.asarray(_at(getattr(element, name), frequency_rad_s), dtype=float)
        whole[name][np.ix_(places, places)] -= own


def _shaft(rotor: Any, size: int) -> tuple[int, int]:
    """Number of coordinates of the nodes of the shaft, and of one node."""
    own = getattr(rotor, "number_dof", None)
    per_node = 6 if own is None and size % 6 == 0 else 4 if own is None else int(own)
    nodes = getattr(rotor, "nodes", None)
    count = size // per_node if nodes is None else len(nodes)
    shaft = per_node * count
    numbered = nodes is None or [int(node) for node in nodes] == list(range(count))
    if per_node not in LATERAL or shaft > size or (nodes is None and size % per_node) or not numbered:
        raise InputError(
            f"a rotor of {size} coordinates, {per_node} a node: nodes have 4 or 6 coordinates and the "
            "numbers from 0 on"
        )
    return shaft, per_node


def _housings(rotor: Any, whole: dict[str, Matrix], shaft: int, held: list[Any]) -> list[Any]:
    """The point masses beyond the shaft, which nothing may connect with it."""
    nodes = len(getattr(rotor, "nodes", []))
    masses = [each for each in getattr(rotor, "point_mass_elements", []) if each.n >= nodes]
    sides = [(matrix[:shaft, shaft:], matrix[shaft:, :shaft]) for matrix in whole.values()]
    if any(one.any() or other.any() for one, other in sides):
        linked = [each for each in held if getattr(each, "n_link", None) is not None]
        raise InputError(
            f"the rotor rests on housings ({_listed(map(_place, masses))}) by "
            f"{_listed(map(_place, linked))}: leave both out of the rotor of ROSS; the housing of a "
            "touch-down bearing is [support] of its case"
        )
    return masses


def _lateral(
    rotor: Any, part: dict[str, Matrix], per_node: int
) -> tuple[dict[str, Matrix], float]:
    """The matrices of the lateral motion, and the moment of inertia about the axis."""
    starts = np.arange(0, part["M"].shape[0], per_node)[:, np.newaxis]
    lateral = (starts + LATERAL[per_node]).ravel()
    taken = {name: matrix[np.ix_(lateral, lateral)] for name, matrix in part.items()}
    if per_node == 4:
        if not hasattr(rotor, "Ip"):
            raise InputError("the rotor has neither torsion nor Ip: its moment of inertia is missing")
        return taken, float(np.sum(rotor.Ip))
    others = np.setdiff1d(np.arange(part["M"].shape[0]), lateral)
    for name, matrix in part.items():
        mixed = max(
            np.abs(matrix[np.ix_(*places)]).max() for places in ((lateral, others), (others, lateral))
        )
        if mixed > 1e-9 * np.abs(matrix).max():
            raise InputError(
                f"matrix {name} of the rotor couples its lateral motion with that along or about its "
                "axis, which a drop does not have"
            )
    torsion = starts.ravel() + TORSION
    own = _inertia(rotor)
    # ROSS's own matrix of torsion takes a tapered element by its middle.
    return taken, float(part["M"][np.ix_(torsion, torsion)].sum()) if own is None else own


def _inertia(rotor: Any) -> float | None:
    """Moment of inertia about the axis by the elements: ROSS counts a coupling as a cylinder."""
    if not hasattr(rotor, "shaft_elements"):
        return float(np.sum(rotor.Ip)) if hasattr(rotor, "Ip") else None
    shafts = (each.Ip if hasattr(each, "Ip") else each.Im for each in rotor.shaft_elements)
    return float(sum(shafts) + sum(each.Ip for each in rotor.disk_elements))


def _mass(rotor: Any) -> float | None:
    """Mass of the rotor with the point masses on its shaft."""
    if not hasattr(rotor, "m"):
        return None
    nodes = len(getattr(rotor, "nodes", []))
    points = (each for each in getattr(rotor, "point_mass_elements", []) if each.n < nodes)
    return float(rotor.m + sum(each.my for each in points))


def _same(what: str, found: float, expected: float, unit: str) -> None:
    if not abs(found - expected) <= DIFFERENCE * abs(expected):
        raise InputError(
            f"the {what} of the matrices is {found:.6g} {unit}, that of ROSS {expected:.6g} {unit}: the "
            "rotor is refused"
        )

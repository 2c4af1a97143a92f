"""The lateral motion of a rotor of ROSS, with ROSS's own mass, inertia and frequencies or not at all."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from .errors import InputError
from .ross_nodes import RossNodes

__all__ = ["RossRotor"]

Matrix = npt.NDArray[np.float64]

#: Matrices of a rotor of ROSS.
MATRICES = ("M", "C", "G", "K", "Ksdt")
#: Kinds of rotors whose shafts turn at speeds of their own.
SEVERAL_SPEEDS = {
    "MultiRotor": "geared shafts turn at different speeds; take one of its rotors, .rotors['driving'] say",
    "CoAxialRotor": "shafts on one axis turn at different speeds; take one shaft as a Rotor",
}
#: Largest difference from a number of ROSS, relative.
DIFFERENCE = 1e-9
#: Largest difference of a natural frequency after the reduction, relative.
REDUCED = 1e-2
#: Lowest natural frequencies that are compared.
FREQUENCIES = 8


@dataclass
class RossRotor:
    """What is taken of a rotor of ROSS.

    Attributes:
        matrices: Matrices of the lateral motion, four coordinates a node and two a housing; "Ma" is the
            mass that bearings and seals add.
        housings: Number of housings.
        polar_inertia_kg_m2: Moment of inertia about the axis.
    """

    matrices: dict[str, Matrix]
    housings: int
    polar_inertia_kg_m2: float

    @classmethod
    def of(cls, rotor: Any, frequency_rad_s: float) -> RossRotor:
        """The lateral motion of a rotor on its housings; magnetic bearings, and housings that nothing
        else connects with the shaft, are left out with a warning.

        Raises:
            InputError: If the rotor is none with one speed and lateral motion of its own.
        """
        for kind in (each.__name__ for each in type(rotor).__mro__):
            if kind in SEVERAL_SPEEDS:
                raise InputError(f"a {kind} is not possible: {SEVERAL_SPEEDS[kind]}")
        whole = _matrices(rotor, frequency_rad_s)
        nodes = RossNodes.of(rotor, len(whole["M"]))
        bearings = list(getattr(rotor, "bearing_elements", []))
        magnetic = [each for each in bearings if _is(each, "MagneticBearingElement")]
        held = [each for each in bearings if not _is(each, "MagneticBearingElement")]
        for name in ("M", "C", "K"):
            whole[name], _ = _without(whole[name], magnetic, name, frequency_rad_s)
        whole["M"], whole["Ma"] = _without(whole["M"], held, "M", frequency_rad_s)
        for element in held:
            _check_added_mass(element, frequency_rad_s)
        kept = nodes.connected(list(whole.values()))
        masses = [each for each in getattr(rotor, "point_mass_elements", []) if each.n >= nodes.count]
        for element in masses:
            if element.n in kept:
                _check_springs(element, np.diagonal(whole["K"])[nodes.lateral([element.n])])
        apart = [each for each in masses if each.n not in kept]
        on_shaft = [each for each in held if any(end < nodes.count for end in _ends(each))]
        springs = [each for each in on_shaft if _holds(each, frequency_rad_s)]
        for which, why in (
            (magnetic, "left out of the rotor, as a magnetic bearing has no power in a drop: {}"),
            (apart, "left out of the rotor, as nothing connects it with the shaft: {}"),
            (springs, "kept in the rotor, to hold it in the drop as well: {}; build the rotor of ROSS "
             "without what stands for a magnetic bearing"),
        ):
            if which:
                warnings.warn(why.format(_listed(map(_place, which))), UserWarning, stacklevel=5)
        lateral, inertia = _lateral(rotor, whole, nodes, kept)
        found = cls(lateral, len(kept), inertia)
        found.check(rotor)
        return found

    def check(self, rotor: Any) -> None:
        """Refuses another mass or moment of inertia than those of the rotor of ROSS."""
        size = self.matrices["M"].shape[0] - 2 * self.housings
        across = self.matrices["M"][1:size:4, 1:size:4].sum()
        _same("mass of the matrices", float(across), _mass(rotor), "kg")
        # ROSS counts a coupling as a cylinder.
        plain = not any(hasattr(each, "Ip") for each in getattr(rotor, "shaft_elements", []))
        own = float(np.sum(rotor.Ip)) if plain and hasattr(rotor, "Ip") else None
        _same("moment of inertia about the axis", self.polar_inertia_kg_m2, own, "kg·m²")

    def frequencies_hz(self) -> Matrix:
        """Natural frequencies at rest without damping, all modes."""
        # M = L·Lᵀ: those of L⁻¹·K·L⁻ᵀ.
        inverse = np.linalg.inv(np.linalg.cholesky(self.matrices["M"] + self.matrices["Ma"]))
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


def _ends(element: Any) -> list[int]:
    """Nodes that an element connects; one alone with the ground."""
    ends = (element.n, getattr(element, "n_link", None))
    return [int(end) for end in ends if end is not None]


def _without(
    matrix: Matrix, elements: Iterable[Any], name: str, frequency_rad_s: float
) -> tuple[Matrix, Matrix]:
    """A matrix without the part of elements, and that part."""
    part = np.zeros_like(matrix)
    for element in elements:
        if hasattr(element, name):
            places = np.array(list(element.dof_global_index.values()), dtype=np.intp)
            part[np.ix_(places, places)] += np.asarray(_at(getattr(element, name), frequency_rad_s), dtype=float)
    return matrix - part, part


def _matrices(rotor: Any, frequency_rad_s: float) -> dict[str, Matrix]:
    """The matrices of a rotor, all of one size."""
    whole = {name: np.array(_at(getattr(rotor, name), frequency_rad_s), dtype=float) for name in MATRICES}
    size = len(np.atleast_1d(whole["M"]))
    for name, matrix in whole.items():
        if matrix.shape != (size, size):
            shape = " × ".join(map(str, matrix.shape))
            raise InputError(f"matrix {name} of the rotor is {shape}: must be {size} × {size}")
    return whole


def _check_springs(housing: Any, stiffness: Matrix) -> None:
    """Refuses a housing that moves freely along x or y."""
    if not np.all(stiffness > 0.0):
        raise InputError(
            f"no spring holds the housing {_place(housing)}: give a stiffness to a bearing that connects it "
            "with the shaft or the ground"
        )


def _check_added_mass(element: Any, frequency_rad_s: float) -> None:
    """Refuses an added mass that stores no energy of its own."""
    own = np.asarray(_at(element.M, frequency_rad_s) if hasattr(element, "M") else np.zeros((2, 2)))
    if own[0, 1] != own[1, 0]:
        raise InputError(
            f"{_place(element)} adds a mass with mxy = {own[0, 1]:g} and myx = {own[1, 0]:g} kg: they must "
            "be equal"
        )


def _lateral(
    rotor: Any, whole: dict[str, Matrix], nodes: RossNodes, kept: list[int]
) -> tuple[dict[str, Matrix], float]:
    """The matrices of the lateral motion with these housings, and the moment of inertia about the axis."""
    lateral = nodes.lateral([*range(nodes.count), *kept])
    others = np.setdiff1d(np.arange(whole["M"].shape[0]), lateral)
    for name, matrix in whole.items():
        mixed = (matrix[np.ix_(lateral, others)], matrix[np.ix_(others, lateral)])
        if max(np.abs(part).max(initial=0.0) for part in mixed) > 1e-9 * np.abs(matrix).max():
            raise InputError(
                f"matrix {name} of the rotor couples its lateral motion with that along or about its "
                "axis, which a drop does not have"
            )
    taken = {name: matrix[np.ix_(lateral, lateral)] for name, matrix in whole.items()}
    # ROSS's own matrix of torsion takes a tapered element by its middle.
    own = _inertia(rotor)
    if own is None and nodes.per_node == 4:
        raise InputError("the rotor has neither torsion nor Ip: its moment of inertia is missing")
    if own is None:
        torsion = nodes.torsion()
        own = float(whole["M"][np.ix_(torsion, torsion)].sum())
    return taken, own


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


def _same(what: str, found: float, expected: float | None, unit: str) -> None:
    if expected is not None and not abs(found - expected) <= DIFFERENCE * abs(expected):
        raise InputError(
            f"the {what} is {found:.9g} {unit}, that of ROSS {expected:.9g} {unit}: the "
            "rotor is refused"
        )

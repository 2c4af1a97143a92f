"""Coordinates of a rotor of ROSS: those of the nodes of its shaft, then those of its housings."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from .errors import InputError

__all__ = ["RossNodes"]

Places = npt.NDArray[np.intp]

#: Lateral coordinates [x, y, α, β] among those of a node, by their number.
LATERAL = {4: [0, 1, 2, 3], 6: [0, 1, 3, 4]}
#: Rotation about the axis among the six coordinates of a node.
TORSION = 5


@dataclass
class RossNodes:
    """Nodes of a rotor of ROSS.

    Attributes:
        count: Number of nodes of the shaft, whose numbers start at 0.
        per_node: Coordinates of a node of the shaft; a housing has the half of them, displacements.
        housings: Numbers of the nodes beyond the shaft.
    """

    count: int
    per_node: int
    housings: list[int]

    @classmethod
    def of(cls, rotor: Any, size: int) -> RossNodes:
        """The nodes of a rotor with `size` coordinates.

        Raises:
            InputError: If its nodes have other coordinates or numbers.
        """
        own = getattr(rotor, "number_dof", None)
        per_node = 6 if own is None and size % 6 == 0 else 4 if own is None else int(own)
        nodes = getattr(rotor, "nodes", None)
        refused = InputError(
            f"a rotor of {size} coordinates, {per_node} a node: nodes have 4 or 6 coordinates and the "
            "numbers from 0 on"
        )
        if per_node not in LATERAL or (nodes is None and size % per_node):
            raise refused
        count = size // per_node if nodes is None else len(nodes)
        if nodes is not None and [int(node) for node in nodes] != list(range(count)):
            raise refused
        masses = getattr(rotor, "point_mass_elements", [])
        found = cls(count, per_node, sorted({int(each.n) for each in masses if each.n >= count}))
        last = found.housings[-1] if found.housings else count - 1
        if not count or found._of(last).stop > size:
            raise refused
        return found

    def lateral(self, nodes: Iterable[int]) -> Places:
        """Lateral coordinates of nodes: [x, y, α, β] of the shaft, [x, y] of housings."""
        own = [(self._of(node), LATERAL[self.per_node] if node < self.count else [0, 1]) for node in nodes]
        return np.array([places[k] for places, kept in own for k in kept], dtype=np.intp)

    def torsion(self) -> Places:
        """Rotations of the shaft about its axis, where nodes have six coordinates."""
        return np.array([self._of(node)[TORSION] for node in range(self.count)], dtype=np.intp)

    def connected(self, matrices: Sequence[npt.NDArray[np.float64]]) -> list[int]:
        """Housings that a lateral element of a matrix connects with the shaft, at once or by others."""
        coupled = sum((matrix != 0.0) | (matrix.T != 0.0) for matrix in matrices)
        found = list(range(self.count))
        while True:
            inner = self.lateral(found)
            near = [
                node
                for node in self.housings
                if node not in found and np.any(coupled[np.ix_(self.lateral([node]), inner)])
            ]
            if not near:
                return sorted(found[self.count :])
            found += near

    def _of(self, node: int) -> range:
        if node < self.count:
            return range(self.per_node * node, self.per_node * (node + 1))
        half = self.per_node // 2
        start = self.per_node * self.count + half * (node - self.count)
        return range(start, start + half)

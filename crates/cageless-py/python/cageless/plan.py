"""The plan of a sweep: a case or a rotor on several bearings, what varies in it, what is computed
of each variant."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Literal

from . import _cageless
from .arguments import checked, names, whole
from .case import Case
from .document import Written
from .errors import InputError
from .rotors import RotorCase
from .section import table
from .toml import toml

__all__ = ["Plan", "span"]


@checked
def span(
    low: float, high: float, count: int | None = None, scale: Literal["linear", "log"] = "linear"
) -> dict[str, Any]:
    """A range for an axis of a plan.

    Args:
        low, high: Both ends, which belong to it.
        count: Number of values; required on a grid, forbidden in samples.
        scale: Spacing of the values.

    Examples:
        >>> span(500.0, 3000.0, 6)
        {'from': 500.0, 'to': 3000.0, 'count': 6}
    """
    found: dict[str, Any] = {"from": float(low), "to": float(high)}
    if count is not None:
        found["count"] = count
    if scale != "linear":
        found["scale"] = scale
    return found


def nested(values: Mapping[str, Any]) -> dict[str, Any]:
    """Dotted keys as dictionaries in dictionaries."""
    tree: dict[str, Any] = {}
    for dotted, value in values.items():
        *path, name = dotted.split(".")
        at = tree
        for part in path:
            at = at.setdefault(part, {})
            if not isinstance(at, dict):
                raise InputError(f"{dotted} is not possible with {part}", dotted)
        at[name] = value
    return tree


class Plan(Written):
    """Plan of a sweep; see docs/sweeps.md for the meaning of its parts.

    Args:
        case: The case that varies, or the rotor on several bearings.
        compute: ``"static"``, ``"design"``, ``"verdict"``, ``"run"``, ``"drop"``; of a rotor on
            several bearings ``"drop"`` alone.
        grid: Axes of which every combination is taken: ``section.key`` to a list of values, or
            to a :func:`span`. With a rotor also keys of the rotor, ``rotor.speed_rpm``, and of one
            bearing, ``bearing.2.contact.damping_n_s_m1_5``.
        samples: ``method``, ``count`` and further axes.
        scatter: ``repeats`` and deviations, such as ``{"normal": 0.5}``.
        keep: Columns to keep besides the inputs; all if left out.
        seed: Seed of samples and scatter.
        title: Free text.
        set: Values that replace those of the case in every variant: ``section.key`` to a value, or
            sections in sections, as ``replace`` of the case takes them.

    Examples:
        >>> import cageless
        >>> case = cageless.Case.from_toml(cageless.template())
        >>> plan = cageless.Plan(
        ...     case=case,
        ...     compute=["static"],
        ...     grid={"operation.radial_load_n": cageless.span(500.0, 3000.0, 6)},
        ... )
        >>> len(plan)
        6
        >>> plan.case(0).operation.radial_load_n
        500.0
        >>> short = cageless.Plan(case=case, compute=["static"], set={"solver.duration_s": 0.01},
        ...                       grid={"operation.radial_load_n": [500.0, 900.0]})
        >>> short.case(1).solver.duration_s
        0.01
    """

    def __init__(
        self,
        *,
        case: Case | RotorCase,
        compute: str | Sequence[str],
        grid: Mapping[str, Any] | None = None,
        samples: Mapping[str, Any] | None = None,
        scatter: Mapping[str, Any] | None = None,
        keep: str | Sequence[str] | None = None,
        seed: int = 0,
        title: str = "",
        set: Mapping[str, Any] | None = None,  # noqa: A002
    ) -> None:
        if set:
            case = case.replace(set)
        head: dict[str, Any] = {"title": title, "seed": seed, "compute": names(compute)}
        if keep is not None:
            head["keep"] = names(keep)
        parts = {"grid": grid, "samples": samples, "scatter": scatter}
        head |= {name: nested(part) for name, part in parts.items() if part is not None}
        head["case"] = case._document
        # Without a name, messages have no place.
        self._file = _cageless.Sweep.parse(toml(head), "", ".")

    @classmethod
    def from_file(cls, path: str | os.PathLike[str]) -> Plan:
        """Reads a plan; the path of its case is relative to its folder."""
        return cls._of(_cageless.Sweep.read(os.fspath(path)))

    @classmethod
    def from_toml(cls, text: str, folder: str | os.PathLike[str] = ".") -> Plan:
        """Reads the text of a plan; paths in it are relative to `folder`."""
        return cls._of(_cageless.Sweep.parse(text, "plan", os.fspath(folder)))

    def case(self, variant: int) -> Any:
        """The :class:`Case` of a variant, counted from 0, or its :class:`RotorCase`; an ``InputError``
        if that is impossible."""
        file = self._file.file(whole("variant", variant, most=len(self) - 1))
        return (RotorCase if file.rotor() else Case)._of(file)

    def cases(self) -> Iterator[Any]:
        """The cases of all variants."""
        return (self.case(variant) for variant in range(len(self)))

    def __len__(self) -> int:
        return self._file.variants()

    def __repr__(self) -> str:
        return f"<Plan of {len(self)} variants>"

    def _repr_html_(self) -> str:
        rows: list[tuple[str, object]] = [("variants", len(self))]
        lines = (line.partition(" = ") for line in self.to_toml().splitlines())
        rows += [(key, value) for key, _, value in lines if value]
        return table(rows, "Plan")


def read(plan: Plan | str | os.PathLike[str]) -> Plan:
    """A plan, or the file of one."""
    return plan if isinstance(plan, Plan) else Plan.from_file(Path(plan))


"""What a case and a rotor on several bearings have in common: files, changes, drops."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

from . import _cageless
from .arguments import Fixed, background, given, whole
from .errors import InputError
from .results import Drop, complete
from .section import Section
from .toml import inline

if TYPE_CHECKING:
    from typing_extensions import Self

__all__ = ["Document", "Progress"]

Keys = Mapping[str, Any]
Progress = Callable[[str, float], object]


def dotted(values: Keys, section: str = "") -> dict[str, Any]:
    """Sections in sections as ``section.key``."""
    found: dict[str, Any] = {}
    for key, value in values.items():
        name = f"{section}.{key}" if section else str(key)
        inner = value.values() if isinstance(value, Section) else value
        found |= dotted(inner, name) if isinstance(inner, Mapping) else {name: inner}
    return found


def changed(values: Keys | None) -> list[str]:
    """``section.key=value`` for each, as ``--set`` takes it."""
    return [f"{key}={inline(value, key)}" for key, value in dotted(values or {}).items()]


def read(cls: Any, text: str) -> Any:
    """What the text of a file describes."""
    return cls.from_toml(text)


class Written(Fixed):
    """What a file of TOML describes; equal if their texts are, and pickled as them."""

    _file: Any

    @classmethod
    def _of(cls, file: Any) -> Self:
        written = cls.__new__(cls)
        written._file = file
        return written

    def to_toml(self) -> str:
        """A file that needs no other, one key per line, every default filled in: that of a rotor with
        its cases and matrices, that of a plan with its case."""
        return self._file.to_toml()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, type(self)) and self.to_toml() == other.to_toml()

    def __hash__(self) -> int:
        return hash(self.to_toml())

    def __reduce__(self) -> tuple[Any, ...]:
        return (read, (type(self), self.to_toml()))


class Document(Written):
    """A case, or a rotor with the cases of its bearings."""

    _name: ClassVar[str]
    _instead = "replace() gives one with other values"

    @classmethod
    def from_file(cls, path: str | os.PathLike[str], changes: Keys | None = None) -> Self:
        """Reads a file.

        Args:
            path: Case file or rotor file, TOML.
            changes: Values for keys ``section.key``, as ``--set`` gives them to the command, or
                sections in sections; in a rotor file for its keys, for ``section.key`` of the cases of
                all bearings, for ``bearing.2.section.key`` of one.

        Raises:
            InputError: With file and line.
        """
        return cls._of(_cageless.File.read(cls._name == "rotor", os.fspath(path), changed(changes)))

    @classmethod
    def from_toml(
        cls,
        text: str,
        changes: Keys | None = None,
        *,
        name: str | None = None,
        folder: str | os.PathLike[str] = ".",
    ) -> Self:
        """Reads the text of a file, which messages call `name`; paths in it are relative to `folder`."""
        kind, place = cls._name == "rotor", os.fspath(folder)
        return cls._of(_cageless.File.parse(kind, text, name or cls._name, place, changed(changes)))

    def replace(self, changes: Keys | None = None, /, **keywords: Any) -> Self:
        """The same with other values.

        Args:
            changes: Values for keys ``section.key``, or ``raceway.2.key`` for the second of several;
                of a rotor as in :meth:`from_file`. A dictionary or a section is merged into that of
                its name: keys that it does not give stay as they are.
            **keywords: The same as keywords, with two underscores for the dot:
                ``section__key=value``, or ``section={"key": value}``.

        Examples:
            >>> import cageless
            >>> case = cageless.Case.from_toml(cageless.template())
            >>> case.replace({"raceway.half_angle_deg": 24.0}).raceways[0].half_angle_deg
            24.0
            >>> case.replace(raceway__half_angle_deg=24.0, title="narrow").raceways[0]
            Raceway(axial_span_mm=5.1, half_angle_deg=24.0, centre_angle_deg=0.0, shape='quartic', profile=None, blend_mm=0.0, depth_um=0.0, edge_radius_mm=None, slot_depth_mm=None, depth_error_um=0.0, contact_angle_deg=None)
            >>> other = case.replace(raceway={"half_angle_deg": 24.0}, title="narrow")
            >>> other == case.replace({"raceway": {"half_angle_deg": 24.0}, "title": "narrow"})
            True
        """
        merged = dotted(changes or {})
        for key, value in dotted({k.replace("__", "."): v for k, v in keywords.items()}).items():
            if key in merged:
                raise InputError(f"{key} is given twice", key)
            merged[key] = value
        return self._of(self._file.changed(changed(merged)))

    def drop(
        self,
        *,
        compare: bool = False,
        samples: int | None = None,
        verify: bool = False,
        drops: int | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Drop:
        """Drops the rotor into its bearings, as ``cageless drop`` does.

        Args:
            compare: Drop it onto the same bearings with conventional outer rings as well.
            samples: Number of further drops with scattered friction, touch-down clearance, support
                damping, direction of the unbalance and arrangement of the balls; of several bearings
                each on its own, and all unbalances rotated by one angle.
            verify: Repeat the drop from perturbed starts and at half the step;
                ``data_verification()`` classifies the results as converged, statistical or
                step-biased.
            drops: Number of drops one after the other, the bearing keeping their heat;
                ``data_succession()`` has a row for each.
            threads: Number of threads (default: number of cores).
            progress: Called as by the computations of a :class:`Case`.

        Raises:
            InputError: If there is no rotor, or ``samples`` or ``drops`` is impossible.
            UnphysicalError: If the drop left the physical range; its ``result`` has what was computed.
        """
        asked = (compare, given(whole, "samples", samples), verify, given(whole, "drops", drops))
        return complete(Drop(_cageless.drop(self._file, *asked, background(threads, progress))))

    @cached_property
    def _document(self) -> dict[str, Any]:
        """The document, with its defaults."""
        found: dict[str, Any] = json.loads(self._file.document(False))
        return found

    @property
    def title(self) -> str:
        """Free text."""
        return str(self._document["title"])

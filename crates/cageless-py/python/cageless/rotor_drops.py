"""Drops of rotors into several touchdown bearings."""

from __future__ import annotations

import json
import os
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import folders, pages
from .drops import Drop, Studied, scalars

if TYPE_CHECKING:
    import pandas as pd

__all__ = ["RotorDrop"]


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

    @classmethod
    def _load(cls, path: Path) -> RotorDrop:
        summary = folders.read(path / "summary.json")
        count = len(json.loads(summary)["bearings"])
        bearings = [Drop._load(path / f"bearing-{k + 1}") for k in range(count)]
        return cls(bearings, summary, folders.read(path / "report.html"))

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
        """Writes ``summary.json``, the page, and the drop of each bearing in a folder of its own.
        :func:`load` reads it.

        Returns
        -------
        Path
            The folder, which is created.
        """
        path = folders.make(folder)
        for k, bearing in enumerate(self.bearings):
            bearing.save(path / f"bearing-{k + 1}")
        folders.write(path, "summary.json", self._summary.encode())
        pages.write(path / "report.html", self._page)
        return path

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Writes the page of ``cageless drop --out``."""
        return pages.write(path, self._page)

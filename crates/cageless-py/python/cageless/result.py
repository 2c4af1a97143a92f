"""The result of any computation."""

from __future__ import annotations

import difflib
import json
import os
import zlib
from collections.abc import Callable, Iterable, Iterator
from functools import cache, cached_property, partial
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from . import _cageless, files, frames
from .arguments import Fixed, given, plain, refused, span, unitless, whole
from .errors import ColumnError, InputError
from .figures import figure
from .section import table
from .units import unit

if TYPE_CHECKING:
    import pandas as pd
    import plotly.graph_objects as go

__all__ = ["Result"]

Place = tuple[str | int, ...]

#: Parts that a result has if they were asked for.
OPTIONAL = {"conventional", "ensemble", "verification"}
#: What the figures take besides a title.
TAKES: dict[str, dict[str, tuple[str, ...]]] = {
    "run": {
        "gap_map": ("time_s",),
        "load_profile": (),
        "phase": ("ball", "time_s"),
        "loads": ("ball", "time_s"),
        "contact_angles": ("ball", "time_s"),
        "groove": ("ball", "time_s"),
        "ring_orbit": ("time_s",),
        "energy": (),
        "vibration": ("time_s",),
        "": ("balls", "time_s"),
    },
    "analysis": {"shares": (), "": ("output",)},
}
#: File of the values of each kind; only that of the last can stand beside another.
VALUES: dict[str, str] = {
    "run": "summary.json",
    "drop": "summary.json",
    "sweep": "sweep.parquet",
    "tolerance": "tolerance.json",
    "search": "design.json",
    "design": "design.json",
    "static": "static.json",
    "comparison": "compare.json",
    "analysis": "report.json",
}
PAGE = "report.html"
#: Texts that say in a line what a result is.
HEADLINES = ("headline", "statement", "findings")


@cache
def quantities(kind: str) -> dict[str, tuple[str, str, bool]]:
    """Unit and label of the scalar results of a kind by name, and whether each is a number."""
    return {row[0]: row[1:] for row in _cageless.quantities(kind)}


def array(found: Any) -> Any:
    """A list of numbers, or of lists, as an array, NaN where there is no number."""

    def leaves(items: Any) -> Iterator[Any]:
        for item in items:
            yield from leaves(item) if isinstance(item, list) else (item,)

    kinds = {type(leaf) for leaf in leaves(found)}
    if not kinds or (str in kinds and not isinstance(found[0], list)):
        return found
    try:
        return np.array(found, dtype=float if type(None) in kinds else None)
    except (TypeError, ValueError):
        return found


def part(whole: Result, place: Place) -> Any:
    """What is at a place of a result."""
    found: Any = whole
    for key in place:
        found = found[key] if isinstance(key, int) else found._at(key)
    return found


def early_stop(values: dict[str, Any]) -> str | None:
    """Reason of an early stop by the physics, from the values of a run or a drop."""
    stop: Any = values.get("stopped")
    if isinstance(stop, dict) and {"time_s", "cause", "advice"} <= stop.keys():
        at, cause, advice = (stop[key] for key in ("time_s", "cause", "advice"))
        # By the user.
        return None if cause == "interrupted" else f"at t = {at:.6f} s {cause}. To change: {advice}."
    bearings = values.get("bearings", [])
    for number, bearing in enumerate(bearings, 1):
        if reason := early_stop(bearing):
            return f"bearing {number}: {reason}" if len(bearings) > 1 else reason
    return None


class Number:
    """A number as its text."""

    def __init__(self, text: str) -> None:
        self.text = text


def written(value: Any) -> str:
    """JSON in one line, each :class:`Number` as its text."""
    if isinstance(value, dict):
        return "{" + ",".join(f"{written(k)}:{written(v)}" for k, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ",".join(map(written, value)) + "]"
    return value.text if isinstance(value, Number) else json.dumps(value, ensure_ascii=False)


def same(tables: list[dict[str, Any]], others: list[dict[str, Any]]) -> bool:
    """Whether all columns of the tables are equal."""
    if [table.keys() for table in tables] != [other.keys() for other in others]:
        return False
    pairs = ((t[k], o[k]) for t, o in zip(tables, others, strict=True) for k in t)
    return all(np.array_equal(one, two, equal_nan=True) for one, two in pairs)


class Result(Fixed):
    """The result of a computation, as the command writes it in JSON.

    Every key of ``values`` is an attribute: numbers (NaN where there is none) and texts as they
    are, lists of numbers as arrays of NumPy, sections as results of their own; so are the columns
    of the tables of a run or a drop. ``dir()`` lists them with the frames of pandas, ``data_*()``,
    and the figures of Plotly, ``plot_*()``. Two results are equal if all of their numbers are.
    """

    kind: ClassVar[str] = ""
    _instead = "it is a result; replace() of the case gives another to compute"
    _parts: ClassVar[dict[str, type[Result]]] = {}
    #: Numbers that say in a line what a result is.
    _shown: ClassVar[tuple[str, ...]] = ()

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        KINDS[cls.kind] = cls

    def __init__(self, core: Any, place: Place = ()) -> None:
        self._core = core
        self._place = place

    @cached_property
    def values(self) -> dict[str, Any]:
        """All numbers and texts, as ``--json`` of the command prints them."""
        found: dict[str, Any] = json.loads(self._core.values)
        return found

    def _at(self, name: str) -> Any:
        """A value as an attribute: a section as a result, a list of numbers as an array."""
        found, cls = self.values[name], self._parts.get(name, Result)
        if found is None and name in (known := quantities(self.kind)):
            return np.nan if known[name][2] else None

        def made(values: dict[str, Any], *place: str | int) -> Result:
            inner = cls(self._core, (*self._place, *place))
            vars(inner)["values"] = values
            return inner

        if isinstance(found, dict):
            return made(found, name)
        if not isinstance(found, list):
            return found
        if found and all(isinstance(item, dict) for item in found):
            return [made(item, name, k) for k, item in enumerate(found)]
        return array(found)

    @property
    def _only(self) -> Result | None:
        """The only bearing of a drop, whose attributes the drop has as well."""
        bearings = self.values.get("bearings")
        alone = isinstance(bearings, list) and len(bearings) == 1 and isinstance(bearings[0], dict)
        return self._at("bearings")[0] if alone else None

    @property
    def _several(self) -> list[Result]:
        """The bearings of a drop of several."""
        several = self.kind == "drop" and not self._place and len(self.values.get("bearings", [])) > 1
        return self._at("bearings") if several else []

    @property
    def _known(self) -> dict[str, Any]:
        """The values with those of an only bearing."""
        only = self._only
        return {**only.values, **self.values} if only else self.values

    @property
    def _bearing(self) -> int | None:
        """Index of the bearing, of one of those of a drop."""
        bearing = len(self._place) == 2 and self._place[0] == "bearings"
        return int(self._place[1]) if bearing else None

    @cached_property
    def _arrays(self) -> dict[str, dict[str, Any]]:
        """Arrays by table and column; none where each of several bearings has its own."""
        tables: list[dict[str, dict[str, Any]]] = self._core.tables if self._core else []
        if self._bearing is not None:
            return tables[self._bearing] if tables else {}
        return tables[0] if len(tables) == 1 and not self._place else {}

    @property
    def stopped(self) -> str | None:
        """Reason of an early stop, with advice; None if the computation is complete."""
        return early_stop(self.values)

    @property
    def _figures(self) -> dict[str, str]:
        """What each figure shows, by name."""
        drawn = not self._place or self._bearing is not None
        return dict(_cageless.figures(self.kind)) if drawn else {}

    @property
    def _frames(self) -> dict[str, Callable[[], pd.DataFrame]]:
        return frames.of(self)

    def array(self, column: str, of: str | None = None) -> Any:
        """A column of a table, as an array that cannot be written to; those of the balls are over
        times and balls.

        Args:
            column: Name of the column.
            of: Table, ``"balls"``, ``"ring"``, ``"collisions"`` or ``"rotor"``; default: the first
                that has the column.

        Raises:
            ColumnError: If there is no such column; also a ``KeyError``.
        """
        tables = self._arrays if of is None else {of: self._arrays.get(of, {})}
        for columns in tables.values():
            if column in columns:
                return columns[column]
        listed = [name for columns in tables.values() for name in columns]
        near = difflib.get_close_matches(str(column), listed, 1)
        hint = f"did you mean {near[0]}? " if near else ""
        known = f"its columns are {', '.join(dict.fromkeys(listed))}"
        message = f"{column!r} is not a column of {of or 'this result'}: {hint}{known}"
        raise ColumnError(message)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name == "values":
            raise AttributeError(name)
        if name in self.values:
            return self._at(name)
        if name in OPTIONAL and self.kind in ("run", "drop"):
            return None
        what, _, rest = name.partition("_")
        if what == "plot" and rest in self._figures:
            found = partial(self._plot, rest)
            found.__doc__ = f"Figure: {self._figures[rest]}."
            return found
        if what == "data" and rest in self._frames:
            return self._frames[rest]
        for columns in self._arrays.values():
            if name in columns:
                return columns[name]
        if (only := self._only) and hasattr(only, name):
            return getattr(only, name)
        near = difflib.get_close_matches(name, dir(self), 1)
        hint = f"; did you mean {near[0]}?" if near else ""
        if self.values.get("bearings") and name in dir(self._at("bearings")[0]):
            hint = f"; each of its bearings has: bearings[0].{name}"
        raise AttributeError(f"{type(self).__name__} has no {name!r}{hint}")

    def __dir__(self) -> list[str]:
        columns = [name for table in self._arrays.values() for name in table]
        plots = [f"plot_{name}" for name in self._figures]
        data = [f"data_{name}" for name in self._frames]
        return sorted({*super().__dir__(), *self._known, *columns, *plots, *data})

    def _plot(self, name: str, *of: str, title: str | None = None, **options: Any) -> go.Figure:
        unitless(f"plot_{name}", options)
        takes = TAKES.get(self.kind, {})
        known = takes.get(name, takes.get("", ()))
        if of:
            options |= dict(zip(known, of, strict=False))
        for option in options:
            if option not in known:
                listed = ", ".join((*known, "title"))
                raise TypeError(f"plot_{name}() has no argument {option!r}: it takes {listed}")
        if "output" in known and "output" not in options:
            raise TypeError(f"plot_{name}() needs the name of an output")
        balls = plain(options.get("balls", options.get("ball")))
        if balls is not None:
            count = next(iter(self._arrays["balls"].values())).shape[1]
            chosen = balls if isinstance(balls, Iterable) else [balls]
            balls = [whole("balls", ball, 1, count) for ball in chosen]
            if not balls:
                raise refused("balls", balls, f"whole numbers from 1 to {count}")
        if balls == [1] and "ball" in options:
            balls = None
        if self._bearing is not None and len(self._core.tables) > 1:
            name = f"{name}-bearing-{self._bearing + 1}"
        window = given(span, "time_s", options.get("time_s"))
        return figure(self._core.figure(name, balls, window, options.get("output")), title)

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Writes the page of the command, which works offline.

        Raises:
            InputError: If this is a part of a result, or the file cannot be written there.
        """
        if self._place:
            raise InputError("a part of a result has no page of its own")
        texts = self._core.files()
        if PAGE not in texts:
            raise InputError(f"the folder of this result had no {PAGE}")
        return files.write(path, texts[PAGE].encode())

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Writes the files that the command writes with ``--out`` into a folder, which is created and
        returned. :func:`load` reads them.
        """
        if self._place:
            raise InputError("a part of a result is saved with the whole")
        core = self._core
        values = json.loads(core.values, parse_float=Number)
        name, files = VALUES[self.kind], core.files()
        # The values of a search are a part of its file.
        text = files.pop(name, core.values)
        bearings = values.get("bearings", [values])
        tables = []
        for number, (arrays, bearing) in enumerate(zip(core.tables, bearings, strict=False), 1):
            place = f"bearing-{number}" if "bearings" in values else ""
            if not {"case", "isa"} <= {*bearing, *values}:
                raise InputError(f"{name} of this result has no case or no isa")
            tables.append((place, arrays, values["isa"], written(bearing["case"])))
        _cageless.write_result(os.fspath(folder), name, text, files, tables)
        return Path(folder)

    def to_csv(self, folder: str | os.PathLike[str]) -> list[Path]:
        """Writes every frame that has rows as ``NAME.csv`` into a folder, which is created, and returns
        the files. Frames of several bearings begin with their number: ``bearing_1_rotor.csv``.

        Columns have their units in their names, numbers all of their digits.

        Raises:
            InputError: If the folder cannot be used.
        """
        texts = {
            f"{name}.csv": files.spreadsheet(frame).encode()
            for name, frame in frames.filled(self).items()
        }
        _cageless.write_folder(os.fspath(folder), texts)
        return [Path(folder) / name for name in texts]

    def to_mat(self, path: str | os.PathLike[str]) -> Path:
        """Writes the frames as a file of MATLAB: a structure per frame with a field per column,
        and ``units`` with the unit of each; of several bearings ``bearing_1_rotor`` and so on. Needs SciPy.

        Raises:
            CagelessError: If SciPy is not installed.
            InputError: If the file cannot be written there.
        """
        return files.write(path, files.matlab(frames.filled(self)))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Result) or self.kind != other.kind:
            return False
        # The time that the computation took is no result of it.
        one, two = ({**each.values, "wall_s": None} for each in (self, other))
        return one == two and same(self._compared(), other._compared())

    def _compared(self) -> list[dict[str, Any]]:
        tables = self._core.tables if self._core and not self._place else [self._arrays]
        return [columns for bearing in tables for columns in bearing.values()]

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        core = self._core
        if self._place:
            return (part, (KINDS[core.kind](core), self._place))
        texts = zlib.compress(json.dumps(core.seed()).encode(), 1)
        return (restored, (core.kind, core.values, list(core.tables), texts))

    def _headline(self) -> str:
        for key in HEADLINES:
            if found := self.values.get(key):
                return str(found[0] if isinstance(found, list) else found)
        summary = frames.scalars(self._known).items()
        numbers = {k: v for k, v in summary if type(v) in (int, float)}
        shown = [name for name in self._shown if name in numbers] or list(numbers)[:3]
        return ", ".join(f"{name} {numbers[name]:.5g}" for name in shown)

    def __repr__(self) -> str:
        text = self._headline()
        return f"<{type(self).__name__}: {text if len(text) < 160 else text[:157] + '...'}>"

    def _repr_html_(self) -> str:
        known = quantities(self.kind)
        rows: list[tuple[str, object]] = []
        for name, value in frames.scalars(self._known).items():
            symbol, label, _ = known.get(name, (unit(name), name, False))
            rows.append((label.strip(), f"{value} {symbol}".strip()))
        for key in ("findings", "reasons", "warnings", "notes"):
            rows += [(key, text) for text in self.values.get(key, [])]
        recorded = {"summary", *self._arrays}
        made = (make() for name, make in self._frames.items() if name not in recorded)
        parts = "".join(frame.to_html(max_rows=10) for frame in made if 0 < len(frame) <= 40)
        return table(rows, escape(type(self).__name__)) + parts


#: Classes of results by kind.
KINDS: dict[str, type[Result]] = {}


def restored(kind: str, values: str, tables: Any, texts: bytes) -> Result:
    """A result from its pickle."""
    for column in (column for bearing in tables for t in bearing.values() for column in t.values()):
        column.flags.writeable = False
    return KINDS[kind](_cageless.Result(kind, values, tables, json.loads(zlib.decompress(texts))))

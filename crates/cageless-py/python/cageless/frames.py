"""Frames of pandas from the values and tables of results."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import cache, partial
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _cageless
from .units import unit, with_units

if TYPE_CHECKING:
    import pandas as pd

    from .result import Result

__all__ = ["filled", "frame", "of", "scalars"]

Row = dict[str, Any]
#: Rows that have rows of their own.
NESTED = {"band", "maps"}
Frames = dict[str, Callable[[], "pd.DataFrame"]]


def scalars(values: Row) -> Row:
    """The values that are neither lists nor sections."""
    return {key: value for key, value in values.items() if not isinstance(value, (list, dict))}


def flat(row: Row) -> Row:
    """A row with the parts of its values as columns: an estimate with its error, texts in one. A case,
    whose sections share names, is none."""
    found: Row = {}
    for key, value in row.items():
        if isinstance(value, dict) and "mean" in value:
            found |= {key: value["mean"], f"{key}_error": value.get("standard_error")}
        elif key == "errors":
            found |= {f"{name}_error": error for name, error in (value or {}).items()}
        elif key == "bunched":
            found |= {f"bunched_{name}": number for name, number in (value or {}).items()}
        elif isinstance(value, dict):
            found |= flat(value) if key != "case" else {}
        elif isinstance(value, list) and value and isinstance(value[0], str):
            found[key] = ", ".join(value)
        elif not (isinstance(value, list) and value and isinstance(value[0], dict)):
            found[key] = value
    return found


def ranged(rows: list[Row]) -> list[Row]:
    """Rows with both ends of their ranges as columns."""
    several = [key for row in rows for key, value in row.items() if isinstance(value, list)]
    ranges = [key for key in several if all(len(row[key] or "  ") == 2 for row in rows)]

    def ends(key: str, value: Any) -> Row:
        if key not in ranges:
            return {key: value}
        low, high = value or (np.nan, np.nan)
        return {f"{key}_min": low, f"{key}_max": high}

    return [{k: v for key, value in row.items() for k, v in ends(key, value).items()} for row in rows]


def frame(
    rows: Iterable[Row], index: str | list[str] | None = None, columns: list[str] | None = None
) -> pd.DataFrame:
    """Rows as a frame with units."""
    import pandas as pd

    found = pd.DataFrame([flat(row) for row in rows], columns=columns)
    # A number that no row has is none, too.
    known = {name for name in found if name in numbers() or unit(str(name))}
    empty = [name for name in found if name in known and found[name].isna().all()]
    found = found.astype(dict.fromkeys(empty, float))
    return with_units(found.set_index(index) if index and len(found) else found)


@cache
def numbers() -> set[str]:
    """Names of all results that are numbers."""
    from .result import KINDS, quantities

    return {name for kind in KINDS for name, row in quantities(kind).items() if row[2]}


def columns(values: Row) -> pd.DataFrame:
    """Lists of one length as columns, NaN where there is no number."""
    import pandas as pd

    return with_units(pd.DataFrame(values, dtype=float))


def generic(name: str, value: Any) -> Callable[[], pd.DataFrame] | None:
    """The frame of a value, if it is one of rows or of columns."""
    if isinstance(value, list) and value and all(isinstance(row, dict) for row in value):
        return partial(frame, value)
    if not isinstance(value, dict) or not value or name == "case":
        return None
    inner = list(value.values())
    if all(isinstance(each, dict) for each in inner):
        rows = [{"name": key} | row for key, row in value.items()]
        return partial(frame, rows, "name")
    if any(isinstance(item, dict) for each in inner if isinstance(each, list) for item in each):
        return None
    lengths = {len(each) if isinstance(each, list) else -1 for each in inner}
    return partial(columns, value) if len(lengths) == 1 and -1 not in lengths else None


def summary(result: Result) -> pd.DataFrame:
    """The scalar results by name, with units and labels."""
    import pandas as pd

    from .result import quantities

    known = quantities(result.kind)
    rows = []
    for name, value in scalars(result._known).items():
        symbol, label, numeric = known.get(name, (unit(name), "", False))
        value = np.nan if numeric and value is None else value
        rows.append({"name": name, "value": value, "unit": symbol, "label": label.strip()})
    found = pd.DataFrame(rows, columns=["name", "value", "unit", "label"], dtype=object)
    return with_units(found.set_index("name"))


def recorded(result: Result, name: str) -> pd.DataFrame:
    """A table of a run or a drop: a row per output time, for the balls per time and ball, for
    collisions per contact of two balls. Columns are views of the arrays."""
    import pandas as pd

    arrays = result._arrays[name]
    if name == "balls":
        times, balls = next(iter(arrays.values())).shape
        head = {
            "time_s": np.repeat(result._arrays["ring"]["time_s"], balls),
            "ball": np.tile(np.arange(1, balls + 1, dtype=np.int32), times),
        }
        arrays = head | {column: array.reshape(-1) for column, array in arrays.items()}
    found = pd.DataFrame(arrays, copy=False)
    return with_units(found, _cageless.table_units()[name])


def of_balls(values: Row) -> pd.DataFrame:
    """A row per ball, counted from 1."""
    import pandas as pd

    lists = {
        key: value
        for key, value in values.items()
        if isinstance(value, list) and value and isinstance(value[0], (int, float))
    }
    count = max(map(len, lists.values()))
    lists = {key: value for key, value in lists.items() if len(value) == count}
    return with_units(pd.DataFrame(lists, index=pd.RangeIndex(1, count + 1, name="ball")))


def scattered(values: Row) -> pd.DataFrame:
    """Scattered drops, a row for each, with several bearings for each drop and bearing: what was
    drawn, and the scalar results."""
    rows = []
    for drop in (values.get("ensemble") or {}).get("drops", []):
        bearings = drop["bearings"]
        for number, bearing in enumerate(bearings, 1):
            which = {"bearing": number} if len(bearings) > 1 else {}
            # The stop of one bearing ends the drop: the reason of the drop is given.
            rows.append(which | scalars(bearing) | scalars(bearing["result"]) | scalars(drop))
    return frame(rows)


def successive(values: Row) -> pd.DataFrame:
    """Drops one after the other, a row for each and, with several bearings, for each of them."""
    return frame(scalars(row["result"]) | scalars(row) for row in values.get("succession", []))


def judged(values: Row) -> pd.DataFrame:
    """Judgement of each result by a verification, by ``name``, with several bearings by
    ``bearing`` and ``name``."""
    found = values.get("verification") or {}
    rows: list[Row] = []
    bearings = found.get("bearings", [found])
    for number, bearing in enumerate(bearings, 1):
        numbers = bearing.get("numbers", [])
        if isinstance(numbers, dict):
            numbers = [{"name": name} | row for name, row in numbers.items()]
        rows += [{"bearing": number} | row for row in numbers]
    if len(bearings) > 1:
        return frame(rows, ["bearing", "name"])
    return frame([{k: v for k, v in row.items() if k != "bearing"} for row in rows], "name")


def balances(values: Row) -> pd.DataFrame:
    """Errors of the energy and momentum balances, at the step and at half the step."""
    end = "_residual_relative"
    rows = [
        {"balance": key.removesuffix(end), "residual_relative": value}
        | {"residual_relative_half_step": values.get(f"{key}_half_step")}
        for key, value in values.items()
        if key.endswith(end)
    ]
    return frame(rows, "balance")


def structures(values: Row, listed: Iterable[tuple[Row, Row]]) -> pd.DataFrame:
    """Structures of a search with a row per operating point; numbers with their errors."""
    rows = []
    for head, structure in listed:
        whole = {key: value for key, value in structure.items() if key != "points"}
        for point, numbers in zip(values["points"], structure["points"], strict=True):
            rows.append(head | whole | point | numbers)
    return frame(rows)


def lists(found: Row) -> pd.DataFrame:
    """Lists of numbers of a result, which are of equal length, with a row per element."""
    lists = {key: value for key, value in found.items() if isinstance(value, list) and value}
    columns = {key: value for key, value in lists.items() if not isinstance(value[0], str)}
    return frame(dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True))


def cells(found: Row) -> pd.DataFrame:
    """A map of a search with a row per cell."""
    grids = {k: v for k, v in found.items() if isinstance(v, list) and isinstance(v[0], list)}
    columns, rows = (k for k, v in found.items() if isinstance(v, list) and k not in grids)
    return frame(
        {columns: x, rows: y} | {key: grid[i][j] for key, grid in grids.items()}
        for i, y in enumerate(found[rows])
        for j, x in enumerate(found[columns])
    )


def compared(values: Row) -> pd.DataFrame:
    """A row per result: means over the draws of each run with standard errors, difference of the
    last from the first, draw by draw. ``better`` is None where the difference is not
    significant, has no better direction, or the cases differ in more than raceway and balls."""
    rows = []
    for result in values["results"]:
        row = {"name": result["name"], "unit": result["unit"]}
        estimates = [*result["values"], result["differences"][-1]]
        for name, estimate in zip([*values["runs"], "difference"], estimates, strict=True):
            row[name] = estimate or {"mean": None}
        rows.append(row | {"better": result["better"][-1]})
    return frame(rows, "name")


def shares(values: Row) -> pd.DataFrame:
    """Share of the variance of each output (rows) that each input explains alone."""
    import pandas as pd

    inputs = [each["name"] for each in values["inputs"]]
    rows = {each["quantity"]["name"]: each["shares"] for each in values["outputs"]}
    found = pd.DataFrame.from_dict(rows, orient="index", columns=inputs, dtype=float)
    # Fractions, whatever the inputs are measured in.
    return with_units(found.rename_axis(index="output"), dict.fromkeys(inputs, ""))


def best(values: Row) -> pd.DataFrame:
    """The best variants by each output that has a better direction."""
    rows = [
        {"by": best["quantity"]["name"], "high": best["high"]}
        | {"variant": each["variant"], "value": each["value"]}
        for best in values["best"]
        for each in best["variants"]
    ]
    return frame(rows)


def special(kind: str, values: Row) -> Frames:
    """Frames of a kind of result that are more than the value of their name."""
    if kind == "static":
        return {"balls": partial(of_balls, values)}
    if kind == "run":
        return {"verification": partial(judged, values)}
    if kind == "drop":
        found: Frames = {
            "drops": partial(scattered, values),
            "succession": partial(successive, values),
            "verification": partial(judged, values),
        }
        # Of several bearings, each has its own.
        own = {"windows": partial(frame, values["windows"])} if "windows" in values else {}
        return found | own
    if kind == "verification":
        return {"ledger": partial(balances, values)}
    if kind == "search":
        listed = {"structures": "band", "front": "front"}
        found = {}
        for name, key in listed.items():
            numbered = [({"structure": k}, each) for k, each in enumerate(values[key])]
            found[name] = partial(structures, values, numbered)
        roles = [({"role": role}, values[role]) for role in ("recommended", "own") if values[role]]
        found["rejections"] = partial(
            frame, values["rejections"], columns=["reason", "meaning", "count"]
        )
        found["placements"] = partial(frame, values["placements"])
        found["confirmation"] = partial(structures, values, roles)
        maps = {f"map_{k}": partial(cells, each) for k, each in enumerate(values["maps"])}
        return found | maps
    if kind == "tolerance":
        return {
            "influences": partial(frame, ranged(values["influences"])),
            "verdicts": partial(frame, (values["samples"] or {}).get("verdicts", [])),
        }
    if kind == "comparison":
        return {"results": partial(compared, values)}
    if kind == "analysis":
        return {"shares": partial(shares, values), "best": partial(best, values)}
    return {}


def of(result: Result) -> Frames:
    """The frames of a result by name."""
    values = result._known
    own = special(result.kind, values)
    by_name = ((name, generic(name, value)) for name, value in values.items())
    recordings = {name: partial(recorded, result, name) for name in result._arrays}
    found: Frames = {"summary": partial(summary, result)}
    found |= recordings
    known = {*found, *NESTED}
    found |= {name: made for name, made in by_name if made is not None and name not in known}
    return found | own


def filled(result: Result) -> dict[str, pd.DataFrame]:
    """The frames that have rows, those of each of several bearings with its number, as ``bearing_1_rotor``."""
    made = {name: make() for name, make in result._frames.items()}
    found = {name: frame for name, frame in made.items() if len(frame)}
    for number, bearing in enumerate(result._several, 1):
        found |= {f"bearing_{number}_{name}": frame for name, frame in filled(bearing).items()}
    return found

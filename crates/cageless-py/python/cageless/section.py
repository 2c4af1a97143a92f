"""A section of a case and its table in notebooks."""

from __future__ import annotations

from dataclasses import dataclass, fields
from html import escape
from typing import Any, get_type_hints

__all__ = ["Section", "table"]


def table(rows: list[tuple[str, object]], caption: str) -> str:
    """Rows of names and values as HTML."""
    body = "".join(
        f"<tr><th style='text-align:left'>{escape(name)}</th><td>{escape(str(value))}</td></tr>"
        for name, value in rows
    )
    return f"<table><caption>{escape(caption)}</caption>{body}</table>"


@dataclass(frozen=True, kw_only=True)
class Section:
    """A section of a case file."""

    def __init_subclass__(cls) -> None:
        keys = get_type_hints(cls, include_extras=True).items()
        listed = "".join(f"\n    {name}: {hint.__metadata__[0]}." for name, hint in keys)
        cls.__doc__ = f"{cls.__doc__}\n\nArgs:{listed}\n"

    def values(self) -> dict[str, Any]:
        """Keys that are given, with their values."""
        items = ((field.name, getattr(self, field.name)) for field in fields(self))
        return {name: value for name, value in items if value is not None}

    def _repr_html_(self) -> str:
        return table(list(self.values().items()), type(self).__name__)

"""Python values as TOML."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from typing import Any

from .arguments import plain, refused

__all__ = ["inline", "toml"]


def inline(value: Any, key: str) -> str:
    """The value of a key on one line; arrays and numbers of NumPy as lists and numbers."""
    value = plain(value)
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, int) and abs(value) >= 2**63:
        raise refused(key, value, "between -2^63 and 2^63")
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, Mapping):
        return "{" + ", ".join(lines(value)) + "}"
    if isinstance(value, Iterable):
        return "[" + ", ".join(inline(each, key) for each in value) + "]"
    left_out = "; to leave it out, make another without it: Case(**values), of to_dict()" if value is None else ""
    raise refused(key, value, f"a number, a text, a list or a dictionary{left_out}")


def lines(values: Mapping[str, Any]) -> Iterable[str]:
    """Keys with their values."""
    for key, value in values.items():
        bare = re.fullmatch(r"[\w-]+", key, re.ASCII)
        yield f"{key if bare else json.dumps(key)} = {inline(value, key)}"


def toml(values: Mapping[str, Any]) -> str:
    """A file with a section for each dictionary."""
    sections = {key: value for key, value in values.items() if isinstance(value, Mapping)}
    text = list(lines({key: value for key, value in values.items() if key not in sections}))
    for key, section in sections.items():
        text += [f"[{key}]", *lines(section)]
    return "\n".join(text)

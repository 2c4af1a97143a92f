"""Figures of the reports as figures of plotly."""

from __future__ import annotations

import json

import plotly.graph_objects as go

__all__ = ["figure"]

#: Room for a title, px.
TITLE_PX = 48


def figure(spec: str, title: str | None = None) -> go.Figure:
    """A figure from its JSON, as it is: without the template of plotly.py."""
    found = json.loads(spec)
    found["layout"].setdefault("template", go.layout.Template())
    return titled(go.Figure(found), title)


def titled(found: go.Figure, title: str | None) -> go.Figure:
    """The figure with a title above it."""
    if title is None:
        return found
    height, top = found.layout.height or 450, found.layout.margin.t or 30
    found.update_layout(
        title={"text": title, "x": 0.0, "xref": "paper", "yref": "container", "y": 0.97},
        margin={"t": top + TITLE_PX},
        height=height + TITLE_PX,
    )
    return found

"""Figures of the reports as figures of plotly."""

from __future__ import annotations

import json

import plotly.graph_objects as go

__all__ = ["figure"]


def figure(spec: str) -> go.Figure:
    """A figure from its JSON, as it is: without the template of plotly.py."""
    found = json.loads(spec)
    found["layout"].setdefault("template", go.layout.Template())
    return go.Figure(found)

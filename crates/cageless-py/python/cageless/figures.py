"""Figures of the reports as figures of plotly."""

from __future__ import annotations

import json
from collections.abc import Mapping

import numpy as np
import numpy.typing as npt
import plotly.graph_objects as go

__all__ = ["figure", "polar"]

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


def polar(
    angle_deg: npt.NDArray[np.float64],
    series: Mapping[str, npt.NDArray[np.float64]],
    unit: str,
    title: str | None = None,
) -> go.Figure:
    """A bar per ball and series over ψ: 0 at the bottom, counter-clockwise."""
    found = go.Figure(layout={"template": go.layout.Template(), "height": 520})
    colours = ["#d55e00", "#0072b2"]
    width = 0.6 * 360.0 / max(len(angle_deg), 1)
    balls = [f"ball {k + 1}" for k in range(len(angle_deg))]
    for k, (name, values) in enumerate(series.items()):
        found.add_barpolar(
            name=name,
            r=values,
            theta=angle_deg,
            width=[width / (k + 1)] * len(angle_deg),
            marker={"color": colours[k % len(colours)]},
            opacity=0.8,
            text=balls,
            hovertemplate=f"%{{text}}, ψ %{{theta:.1f}}°<br>%{{r:.4g}} {unit}",
        )
    found.update_polars(
        bargap=0.0,
        angularaxis={"rotation": -90, "direction": "counterclockwise", "dtick": 30},
        radialaxis={"ticksuffix": f" {unit}", "angle": 90, "tickangle": 90},
    )
    found.update_layout(barmode="overlay", legend={"orientation": "h", "y": -0.08})
    return titled(found, title)

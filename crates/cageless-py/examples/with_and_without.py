"""The same uneven start with and without a discrete raceway: does it spread the balls?

Writes gap_min.html.
"""

from __future__ import annotations

import numpy as np
import plotly.graph_objects as go

import cageless

figure = go.Figure()
for name, conventional in [("conventional", True), ("discrete raceway", False)]:
    case = cageless.Case.from_toml(cageless.template(conventional))
    # All balls together, but for one gap: the worst start.
    gaps = np.full(case.bearing.balls, 0.1 * case.uniform_gap_deg)
    gaps[-1] += case.uniform_gap_deg * case.bearing.balls - gaps.sum()
    run = case.replace({"start.gaps": gaps, "solver.duration_s": 0.1}).run()
    smallest = np.degrees(run.gap_rad.min(axis=1))
    figure.add_scatter(x=run.time_s * 1e3, y=smallest, name=name)
    print(f"{name}: {run.collisions} contacts between balls")

figure.update_layout(xaxis_title="Time (ms)", yaxis_title="Smallest gap (°)")
figure.write_html("gap_min.html")

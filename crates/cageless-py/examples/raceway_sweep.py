"""Which raceway suits which load? A sweep, and what matters in it.

Writes shares.html, effects.html, map.html and report.html.
"""

from __future__ import annotations

import cageless

case = cageless.Case.from_toml(cageless.template(), {"solver.duration_s": 0.01})
plan = cageless.Plan(
    title="Raceways under load",
    case=case,
    compute=["static", "design", "run"],
    grid={
        "raceway.axial_span_mm": cageless.span(5.0, 5.3, 4),
        "raceway.half_angle_deg": cageless.span(20.0, 28.0, 5),
        "operation.radial_load_n": [500.0, 1500.0, 3000.0],
    },
)
result = cageless.sweep(plan)
print(result.data_variants().describe())

report = result.report(
    high=["run_gap_min_deg"], low=["run_collisions", "run_gap_max_deg", "static_outer_pressure_max_mpa"]
)
print(report.data_best().head())
report.plot_shares().write_html("shares.html")
report.plot_effects("run_gap_min_deg").write_html("effects.html")
report.plot_map("run_gap_min_deg").write_html("map.html")
report.report("report.html")

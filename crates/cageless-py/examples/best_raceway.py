"""The best raceway for a bearing: found, verified, judged within tolerances, exported.

Kept small to be soon done: leave out the arguments of search and tolerance for real work.
Writes verdicts.html, trade_offs.html, influences.html, search.html and outer_ring.step.
"""

from __future__ import annotations

import cageless

case = cageless.Case.from_toml(cageless.template())

found = case.search(
    axial_span_mm=5.1, half_angle_deg=(24.0, 26.0), initial_states=1, runs_max=32, out="search"
)
print(found.findings[0])
print(found.data_front()[["axial_span_mm", "half_angle_deg", "margin_deg", "friction_w"]])
found.plot_verdicts().write_html("verdicts.html")
found.plot_trade_offs().write_html("trade_offs.html")
found.report("search.html")

best = found.case.replace({"solver.duration_s": 0.02})
run = best.run(verify=True)
print(run.verification)

made = best.tolerance(samples=4)
print(made, "decides:", made.decides)
made.plot_influences().write_html("influences.html")

ring = {"bearing.outer_ring_outer_radius_mm": 31.0, "bearing.outer_ring_width_mm": 16.0}
print(best.replace(ring).export("outer_ring.step").deviation_um)

"""One bearing: its load, its raceway, its motion.

Writes gaps.html, orbit_speed.html and ring_orbit.html.
"""

from __future__ import annotations

import cageless

case = cageless.Case(
    title="A bearing of my own",
    bearing=cageless.Bearing(
        balls=14,
        ball_radius_mm=4.7625,
        inner_groove_bottom_radius_mm=18.24,
        outer_groove_bottom_radius_mm=27.765,
        outer_shoulder_radius_mm=26.0,
        inner_groove_curvature_radius_mm=4.953,
        outer_groove_curvature_radius_mm=4.953,
        inner_ring_mass_kg=0.2,
        inner_ring_damping_n_s_m=2000.0,
    ),
    raceway=cageless.Raceway(axial_span_mm=5.1, half_angle_deg=25.2),
    operation=cageless.Operation(inner_speed_rpm=12000.0, radial_load_n=1500.0),
    contact=cageless.Contact(friction_coefficient=0.01),
    solver=cageless.Solver(duration_s=0.1),
)

static = case.static()
print(f"ring displaced by {static.ring_y_um:.2f} µm")
print(f"largest load of a ball {static.outer_force_n.max():.0f} N")
print(f"largest contact pressure {static.outer_pressure_max_mpa:.0f} MPa")

run = case.run()
print(run.data_summary())
run.plot_gaps().write_html("gaps.html")
run.plot_orbit_speed().write_html("orbit_speed.html")
run.plot_ring_orbit().write_html("ring_orbit.html")

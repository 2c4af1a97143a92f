"""Motion of the balls in a drop by their place on the outer ring, from the tables of `cageless drop --out DIR --csv`.

Over the last fifth of the time after the first contact, where `end_collision_rate_hz` is taken, too.
"""

import csv
import math
import statistics

SECTORS = 12
"""Sectors of 30°; the first starts at ψ = −180°, ψ = 0 is the bottom, where the rotor lies."""
REAL_M_S = {"0_1": 0.1, "0_5": 0.5, "1": 1.0}
"""Approach speeds above which contacts are counted, m/s."""


def columns(path):
    with path.open(newline="", encoding="utf-8") as file:
        rows = csv.reader(file)
        names = next(rows)
        values = [[float(v) for v in row] for row in rows]
    return dict(zip(names, zip(*values)))


def sector(angle_rad):
    return int((math.degrees(angle_rad) + 180) % 360 / (360 / SECTORS))


def results(folder, document):
    [drop] = document["bearings"]
    folder, bearing = folder / "bearing-1", drop["case"]["bearing"]
    inner, outer = bearing["inner_groove_bottom_radius_mm"], bearing["outer_groove_bottom_radius_mm"]
    ball = bearing["ball_radius_mm"]
    pitch = (inner + outer) / 2
    end, first = drop["simulated_s"], drop["first_contact_ms"] * 1e-3
    start = first + 0.8 * (end - first)
    ring = drop["ring_speed_rpm"] * 2 * math.pi / 60
    # Pure rolling on the ring at its speed at the end.
    rolling_m_s = ring * inner * 1e-3 / 2
    rolling_rad_s = ring * inner / (2 * ball)
    balls = columns(folder / "balls.csv")
    speed, spin = [[] for _ in range(SECTORS)], [[] for _ in range(SECTORS)]
    for time, x, y, vx, vy, rotation in zip(
        *(balls[n] for n in ("time_s", "x_m", "y_m", "vx_m_s", "vy_m_s", "rotation_rad_s"))
    ):
        if time >= start:
            angle = math.atan2(x, -y)
            k = sector(angle)
            speed[k].append(vx * math.cos(angle) + vy * math.sin(angle))
            spin[k].append(rotation)
    contacts = columns(folder / "collisions.csv")
    late = [k for k, time in enumerate(contacts["start_s"]) if time >= start]
    approach = [contacts["approach_speed_m_s"][k] for k in late]
    angles = [contacts["angle_rad"][k] for k in late]
    duration = end - start
    mean_orbit_hz = statistics.fmean(v for of in speed for v in of) / (2 * math.pi * pitch * 1e-3)
    passages_hz = bearing["balls"] * mean_orbit_hz

    def rates(least):
        counts = [0] * SECTORS
        for v, angle in zip(approach, angles):
            if v > least:
                counts[sector(angle)] += 1
        return [count / duration for count in counts]

    return {
        "sector_from_deg": [360 / SECTORS * k - 180 for k in range(SECTORS)],
        "rolling_speed_m_s": rolling_m_s,
        "rolling_rotation_rad_s": rolling_rad_s,
        "speed_m_s": (speeds := [statistics.fmean(of) for of in speed]),
        "rotation_rad_s": (rotations := [statistics.fmean(of) for of in spin]),
        "queue_speed_fraction": statistics.median(speeds) / rolling_m_s,
        "rotation_least_fraction": min(rotations) / rolling_rad_s,
        "passages_per_s": passages_hz,
        "contacts_per_s": len(late) / duration,
        "approach_speed_median_m_s": statistics.median(approach),
        **{f"contacts_above_{name}_m_s_per_s": rates(least) for name, least in REAL_M_S.items()},
        "contacts_in_sectors_per_s": rates(-math.inf),
    }

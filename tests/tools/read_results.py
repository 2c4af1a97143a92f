"""Results of `cageless run`, read by the tools that users have.

pyarrow, pandas, duckdb and polars read the tables of short runs; what the numbers must
be is worked out again here, in NumPy, from the equations of the physical model.

    python read_results.py path/to/cageless path/to/a/scratch/folder
"""

import json
import subprocess
import sys
import tomllib
from pathlib import Path

import duckdb
import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pyarrow.parquet as pq

from checks import check, exit_code

BALLS = {
    "time_s": "s",
    "ball": "1",
    "angle_rad": "rad",
    "x_m": "m",
    "y_m": "m",
    "vx_m_s": "m/s",
    "vy_m_s": "m/s",
    "rotation_rad_s": "rad/s",
    "orbit_speed_rad_s": "rad/s",
    "gap_rad": "rad",
    "effective_radius_m": "m",
    "inner_force_n": "N",
    "outer_force_n": "N",
    "inner_sliding_m_s": "m/s",
    "outer_sliding_m_s": "m/s",
}
RING = {
    "time_s": "s",
    "x_m": "m",
    "y_m": "m",
    "vx_m_s": "m/s",
    "vy_m_s": "m/s",
    "ax_m_s2": "m/s^2",
    "ay_m_s2": "m/s^2",
    "outer_force_x_n": "N",
    "outer_force_y_n": "N",
}
COLLISIONS = {
    "start_s": "s",
    "duration_s": "s",
    "ball": "1",
    "next_ball": "1",
    "angle_rad": "rad",
    "approach_speed_m_s": "m/s",
    "peak_force_n": "N",
    "impulse_n_s": "N s",
}
TABLES = {"balls": BALLS, "ring": RING, "collisions": COLLISIONS}
INTEGERS = {"ball", "next_ball"}

# Keys that a case file may leave out; stiffnesses follow from the geometry.
OPTIONAL = {
    "schema", "title", "bearing.assembly", "raceway.centre_angle_deg", "raceway.shape", "raceway.blend_mm",
    "raceway.depth_um", "raceway.depth_error_um", "contact.regularisation",
    "contact.outer_friction_factor", "contact.ball_friction_factor", "contact.friction_strips",
    "contact.ball_restitution", "contact.inner_stiffness_n_m1_5", "contact.outer_stiffness_n_m1_5", "contact.ball_stiffness_n_m1_5",
    "model.motion", "model.flanks", "start.state", "start.gaps", "start.lead_ball_angle_deg",
    "solver.method", "solver.step_us", "solver.tolerance", "solver.seed",
}  # fmt: skip


def close(what, found, expected, tolerance):
    """Equal to within `tolerance`, absolute."""
    worst = float(np.max(np.abs(np.asarray(found) - np.asarray(expected)), initial=0.0))
    check(what, worst <= tolerance, f"(off by {worst:.3e}, allowed {tolerance:.1e})")


def call(binary, case, folder, *sets, code=0):
    command = [binary, "run", case, "--out", folder]
    for text in sets:
        command += ["--set", text]
    ended = subprocess.run(command, capture_output=True, text=True)
    if ended.returncode != code:
        raise RuntimeError(f"exit code {ended.returncode} of {command}: {ended.stderr}")


class Run:
    """A run in its folder, with the numbers that the checks need."""

    def __init__(self, binary, scratch, name, *sets):
        self.name, self.folder = name, scratch / name
        case = scratch / "case.toml"
        case.write_bytes(subprocess.run([binary, "new"], check=True, capture_output=True).stdout)
        call(binary, case, self.folder, *sets)
        self.summary = json.loads((self.folder / "summary.json").read_text())
        self.given = tomllib.loads(case.read_text())
        self.sets = sets

        case = self.summary["case"]
        bearing, contact, operation = case["bearing"], case["contact"], case["operation"]
        self.n = bearing["balls"]
        self.rw = 1e-3 * bearing["ball_radius_mm"]
        self.ri = 1e-3 * bearing["inner_groove_bottom_radius_mm"]
        self.ro = 1e-3 * bearing["outer_groove_bottom_radius_mm"]
        self.rm = (self.ro + self.ri) / 2
        self.epsilon = 2 * np.arcsin(self.rw / self.rm)
        self.ring_mass, self.drag = bearing["inner_ring_mass_kg"], bearing["inner_ring_damping_n_s_m"]
        self.ball_mass = case["material"]["density_kg_m3"] * 4 / 3 * np.pi * self.rw**3
        self.span = 1e-3 * case["raceway"]["axial_span_mm"]
        self.theta = np.radians(case["raceway"]["half_angle_deg"])
        self.speed = operation["inner_speed_rpm"] * np.pi / 30
        self.load, self.g = operation["radial_load_n"], operation["gravity_m_s2"]
        self.mu, self.scale = contact["friction_coefficient"], contact["regularisation_speed_m_s"]
        self.restitution = contact["ball_restitution"]
        self.k_inner, self.k_outer = contact["inner_stiffness_n_m1_5"], contact["outer_stiffness_n_m1_5"]
        self.duration = case["solver"]["duration_s"]
        self.interval = 1e-6 * case["output"]["interval_us"]

        rows = {name: pq.read_table(self.path(name)) for name in TABLES}
        self.rows = {name: table.num_rows for name, table in rows.items()}
        self.collisions = {c: rows["collisions"][c].to_numpy() for c in COLLISIONS}
        self.ring = {c: rows["ring"][c].to_numpy() for c in RING}
        # One row of these arrays per time, one column per ball.
        self.balls = {c: rows["balls"][c].to_numpy().reshape(-1, self.n) for c in BALLS}

    def path(self, table):
        return self.folder / f"{table}.parquet"

    def friction(self, slip, normal):
        return self.mu * np.tanh(slip / self.scale) * normal

    def effective_radius(self, angle):
        """Zhao 2022, Eq. (4) to (6), at the ball's own angle."""
        rm = self.ro - self.rw  # Rm of Eq. (4) to (8)
        sin, cos, tan = np.sin(self.theta), np.cos(self.theta), np.tan(self.theta)
        c = -(rm + np.sqrt(self.rw**2 - self.span**2 / 4))
        a = (self.ro * sin * tan + 2 * self.ro * cos + 2 * c) / (2 * self.ro**4 * sin**4)
        b = -(4 * c + self.ro * sin * tan + 4 * self.ro * cos) / (2 * self.ro**2 * sin**2)
        psi = np.arctan2(np.sin(angle), np.cos(angle))
        inside = np.abs(psi) < self.theta
        low, high = np.zeros_like(psi), np.full_like(psi, self.ro * sin)
        for _ in range(60):
            x = (low + high) / 2
            beyond = np.arctan2(x, -(a * x**4 + b * x**2 + c)) > np.abs(psi)
            low, high = np.where(beyond, low, x), np.where(beyond, x, high)
        r = np.hypot(x, a * x**4 + b * x**2 + c) - rm
        return np.where(inside, r, self.rw)


def read_by_tools(run):
    """Columns in order, types, rows and values are the same for all four readers."""
    for name, columns in TABLES.items():
        where, path, names = f"{run.name}/{name}", run.path(name), list(columns)
        arrow = pq.read_table(path)
        check(f"{where}: pyarrow columns", arrow.column_names == names, arrow.column_names)
        types = {c: pa.int32() if c in INTEGERS else pa.float64() for c in names}
        check(f"{where}: pyarrow types", {f.name: f.type for f in arrow.schema} == types)
        check(f"{where}: no nulls", all(column.null_count == 0 for column in arrow.columns))

        frame = pd.read_parquet(path)
        check(f"{where}: pandas columns", list(frame.columns) == names)
        types = ["int32" if c in INTEGERS else "float64" for c in names]
        check(f"{where}: pandas types", [str(t) for t in frame.dtypes] == types, frame.dtypes)

        polar = pl.read_parquet(path)
        check(f"{where}: polars columns", polar.columns == names)
        types = [pl.Int32 if c in INTEGERS else pl.Float64 for c in names]
        check(f"{where}: polars types", polar.dtypes == types, polar.dtypes)

        relation = duckdb.read_parquet(str(path))
        check(f"{where}: duckdb columns", relation.columns == names)
        types = ["INTEGER" if c in INTEGERS else "DOUBLE" for c in names]
        check(f"{where}: duckdb types", [str(t) for t in relation.types] == types, relation.types)
        duck = relation.fetchnumpy()

        counts = [arrow.num_rows, len(frame), polar.height, len(duck[names[0]])]
        check(f"{where}: row counts", len(set(counts)) == 1, counts)
        for c in names:
            values = arrow[c].to_numpy()
            same = all(
                np.array_equal(values, np.asarray(other))
                for other in (frame[c], polar[c].to_numpy(), duck[c])
            )
            check(f"{where}: {c} reads the same everywhere", same)
            check(f"{where}: {c} is finite", bool(np.isfinite(values).all()))

        footer = {k.decode(): v.decode() for k, v in pq.read_metadata(path).metadata.items()}
        check(f"{where}: schema", footer["schema"] == "1", footer["schema"])
        check(f"{where}: version", footer["version"] == run.summary["version"])
        check(f"{where}: isa", footer["isa"] == run.summary["isa"] != "")
        check(f"{where}: case", json.loads(footer["case"]) == run.summary["case"])
        units = {k.removeprefix("unit:"): v for k, v in footer.items() if k.startswith("unit:")}
        check(f"{where}: units", units == columns, units)


def rows_and_order(run):
    """A row per output time and ball, from t = 0 to the end."""
    times = round(run.duration / run.interval) + 1
    expected = run.interval * np.arange(times)
    check(f"{run.name}: balls rows", run.rows["balls"] == times * run.n, run.rows)
    check(f"{run.name}: ring rows", run.rows["ring"] == times, run.rows)
    check(f"{run.name}: starts at 0", run.ring["time_s"][0] == 0.0)
    close(f"{run.name}: ring times", run.ring["time_s"], expected, 1e-12)
    close(f"{run.name}: ball times", run.balls["time_s"], run.ring["time_s"][:, None], 0.0)
    close(f"{run.name}: balls count from 1", run.balls["ball"], np.arange(1, run.n + 1)[None], 0)


def kinematics(run):
    b, name = run.balls, run.name
    x, y, vx, vy, psi = b["x_m"], b["y_m"], b["vx_m_s"], b["vy_m_s"], b["angle_rad"]
    rho = np.hypot(x, y)
    orbit = (x * vy - y * vx) / rho**2
    close(f"{name}: orbit speed", b["orbit_speed_rad_s"], orbit, 1e-8)
    turn = psi - np.arctan2(x, -y)
    close(f"{name}: angle is that of the place", turn, 2 * np.pi * np.round(turn / (2 * np.pi)), 1e-12)
    check(f"{name}: angles start in the first turn", bool((psi[0] < 2 * np.pi).all()))
    check(f"{name}: angles grow with the number", bool((np.diff(psi, axis=1) > 0).all()))
    moved = (orbit[1:] + orbit[:-1]) / 2 * run.interval
    close(f"{name}: angle is continuous", np.diff(psi, axis=0), moved, 2e-4)

    ahead = np.roll(psi, -1, axis=1)
    ahead[:, -1] += 2 * np.pi
    close(f"{name}: gap to the ball ahead", b["gap_rad"], ahead - psi - run.epsilon, 1e-12)
    close(f"{name}: gaps add up", b["gap_rad"].sum(axis=1), 2 * np.pi - run.n * run.epsilon, 1e-11)

    r = run.effective_radius(psi)
    check(f"{name}: balls were in the raceway", bool((r < 0.95 * run.rw).any()))
    close(f"{name}: effective radius", b["effective_radius_m"], r, 1e-10)

    spin, vt = b["rotation_rad_s"], rho * orbit
    close(f"{name}: outer slip", b["outer_sliding_m_s"], vt - spin * r, 1e-8)
    dx, dy = x - run.ring["x_m"][:, None], y - run.ring["y_m"][:, None]
    dvx, dvy = vx - run.ring["vx_m_s"][:, None], vy - run.ring["vy_m_s"][:, None]
    vt = (dx * dvy - dy * dvx) / np.hypot(dx, dy)
    slip = run.speed * run.ri - (vt + spin * run.rw)
    close(f"{name}: inner slip", b["inner_sliding_m_s"], slip, 1e-9)
    rolling = run.speed * run.ri / run.rm * (1 - run.rw / (r + run.rw))
    check(f"{name}: orbit near rolling", bool((np.abs(orbit / rolling - 1) < 0.2).all()))


def forces(run, undamped):
    b, ring, name = run.balls, run.ring, run.name
    x, y = b["x_m"], b["y_m"]
    rho = np.hypot(x, y)
    dx, dy = x - ring["x_m"][:, None], y - ring["y_m"][:, None]
    distance = np.hypot(dx, dy)
    inner, outer = b["inner_force_n"], b["outer_force_n"]
    delta_i = run.ri + run.rw - distance
    delta_o = rho - (run.ro - run.rw)
    check(f"{name}: no pull", bool((inner >= 0).all() and (outer >= 0).all()))
    check(f"{name}: no force without contact", bool((inner[delta_i < -1e-12] == 0).all()))
    check(f"{name}: loaded and unloaded balls", bool((inner > 100).any() and (inner == 0).any()))
    if undamped:
        hertz = run.k_inner * np.maximum(delta_i, 0) ** 1.5
        close(f"{name}: inner force is K d^1.5", inner, hertz, 1e-5)
        hertz = run.k_outer * np.maximum(delta_o, 0) ** 1.5
        close(f"{name}: outer force is K d^1.5", outer, hertz, 1e-5)

    # What the balls put on the outer ring: normal force outwards, friction along the slip.
    friction = run.friction(b["outer_sliding_m_s"], outer * run.rw / b["effective_radius_m"])
    fx = (outer * x - friction * y) / rho
    fy = (outer * y + friction * x) / rho
    close(f"{name}: outer force x", ring["outer_force_x_n"], fx.sum(axis=1), 1e-6)
    close(f"{name}: outer force y", ring["outer_force_y_n"], fy.sum(axis=1), 1e-6)

    # Zhao 2022, Eq. (14): load, weight, drag and what the balls push back with.
    friction = run.friction(b["inner_sliding_m_s"], inner)
    back_x = -((inner * dx - friction * dy) / distance).sum(axis=1)
    back_y = -((inner * dy + friction * dx) / distance).sum(axis=1)
    ax = (back_x - run.drag * ring["vx_m_s"]) / run.ring_mass
    ay = (back_y - run.drag * ring["vy_m_s"] - run.load) / run.ring_mass - run.g
    close(f"{name}: ring acceleration x", ring["ax_m_s2"], ax, 1e-4)
    close(f"{name}: ring acceleration y", ring["ay_m_s2"], ay, 1e-4)


def momentum(run):
    """Balls and ring together: only load, weights, drag and the outer ring act on them."""
    b, ring = run.balls, run.ring
    dt = run.interval

    def integral(force):
        return dt * np.sum(force[1:] + force[:-1]) / 2

    weight = (run.n * run.ball_mass + run.ring_mass) * run.g
    for axis, down in (("x", 0.0), ("y", run.load + weight)):
        velocity = f"v{axis}_m_s"
        total = run.ball_mass * b[velocity].sum(axis=1) + run.ring_mass * ring[velocity]
        force = -ring[f"outer_force_{axis}_n"] - run.drag * ring[velocity] - down
        scale = dt * np.sum(np.abs(ring["outer_force_y_n"]))
        residual = abs(total[-1] - total[0] - integral(force)) / scale
        check(f"{run.name}: momentum along {axis}", residual < 1e-3, f"residual {residual:.2e}")


def summary(run):
    s = run.summary
    check(f"{run.name}: summary schema", s["schema"] == 1)
    residual = s["energy_residual_relative"]
    check(f"{run.name}: energy balance error", abs(residual) < 1e-3, residual)
    flows = s["energy"]
    check(f"{run.name}: steps", s["steps"] > 0 and s["rhs_evaluations"] >= s["steps"])
    check(f"{run.name}: energies are numbers", all(isinstance(v, float) for v in flows.values()))

    given = {key for key in self_and_children("", run.given)}
    given |= {text.split("=")[0] for text in run.sets}
    check(f"{run.name}: defaults", set(s["defaults"]) == OPTIONAL - given, s["defaults"])
    recorded = set(self_and_children("", s["case"]))
    check(f"{run.name}: the case has every default", OPTIONAL <= recorded, OPTIONAL - recorded)

    settled = s["settled_after_s"]
    gaps = run.balls["gap_rad"][run.ring["time_s"] >= settled]
    # The summary sees every step, the table a few.
    check(f"{run.name}: smallest gap", np.degrees(gaps.min()) >= s["gap_min_deg"] - 1e-3)
    check(f"{run.name}: largest gap", np.degrees(gaps.max()) <= s["gap_max_deg"] + 1e-3)
    y = 1e6 * run.ring["y_m"][run.ring["time_s"] >= settled].mean()
    close(f"{run.name}: mean displacement of the inner ring", s["ring_y_mean_um"], y, 0.5)


def self_and_children(prefix, value):
    if isinstance(value, dict):
        for key, child in value.items():
            yield from self_and_children(f"{prefix}.{key}" if prefix else key, child)
    else:
        yield prefix


def impacts(run):
    c = run.collisions
    count = len(c["ball"])
    check(f"{run.name}: there are collisions", count > 20, count)
    close(f"{run.name}: the next ball", c["next_ball"], c["ball"] % run.n + 1, 0)
    check(f"{run.name}: balls of collisions", bool((c["ball"] >= 1).all() and (c["ball"] <= run.n).all()))
    check(f"{run.name}: collisions lie in the run", bool((c["start_s"] >= 0).all()
          and (c["start_s"] + c["duration_s"] <= run.duration + 1e-12).all()))
    check(f"{run.name}: collisions push", bool((c["impulse_n_s"] > 0).all() and (c["peak_force_n"] > 0).all()))
    check(f"{run.name}: force bounds impulse", bool(
        (c["impulse_n_s"] <= c["peak_force_n"] * c["duration_s"] * (1 + 1e-9)).all()))
    check(f"{run.name}: angles of collisions", bool((np.abs(c["angle_rad"]) <= np.pi).all()))
    ended = c["start_s"] + c["duration_s"] < run.duration
    speed = c["approach_speed_m_s"]
    check(f"{run.name}: balls approach", bool((speed > 0).all()))
    # An impact of two free spheres, and up to a quarter more: traction under load makes the
    # balls roll on, which adds some of their rotary inertia.
    fast = ended & (speed > np.median(speed))
    free = (1 + run.restitution) * run.ball_mass / 2 * speed[fast]
    ratio = np.median(c["impulse_n_s"][fast] / free)
    check(f"{run.name}: impulse of an impact", 0.95 < ratio < 1.3, ratio)
    settled = c["start_s"] >= run.summary["settled_after_s"]
    counted = run.summary["collisions"]
    check(f"{run.name}: collisions are counted", abs(int(settled.sum()) - counted) <= run.n, (settled.sum(), counted))
    for limit, name in ((0.1, "0_1"), (0.5, "0_5"), (1, "1")):
        fast, counted = int((settled & (speed > limit)).sum()), run.summary[f"collisions_above_{name}_m_s"]
        check(f"{run.name}: collisions above {limit} m/s", abs(fast - counted) <= run.n, (fast, counted))


def main():
    binary, scratch = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    scratch.mkdir(parents=True, exist_ok=True)

    damped = Run(binary, scratch, "damped", "solver.duration_s=0.02", "output.interval_us=10")
    undamped = Run(
        binary, scratch, "undamped", "contact.damping_n_s_m1_5=0", "contact.ball_restitution=1",
        "solver.step_us=0.25", "solver.duration_s=0.01", "output.interval_us=10",
    )  # fmt: skip
    dense = Run(binary, scratch, "dense", "solver.duration_s=0.004", "output.interval_us=1",
                "solver.step_us=0.5", "solver.method=abm4")
    lively = Run(
        binary, scratch, "lively", "raceway.axial_span_mm=4.95", "raceway.half_angle_deg=35",
        "solver.duration_s=0.1", "output.interval_us=50",
        "housing.mass_kg=1", "housing.stiffness_n_m=1e8", "housing.damping_n_s_m=500",
    )  # fmt: skip
    read_by_tools(lively)
    for run in (damped, undamped, dense, lively):
        rows_and_order(run)
        kinematics(run)
        forces(run, undamped=run is undamped)
        summary(run)
    momentum(dense)
    impacts(lively)

    # Leaves the physical range before there are statistics; its page is shown all the same.
    undamped_large_steps = (
        "solver.method=abm4", "solver.step_us=3", "contact.damping_n_s_m1_5=0", "contact.ball_restitution=1",
    )  # fmt: skip
    call(binary, scratch / "case.toml", scratch / "stopped", *undamped_large_steps, code=3)

    version = subprocess.run([binary, "--version"], check=True, capture_output=True, text=True)
    check("version", version.stdout.split()[1] == damped.summary["version"])
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())

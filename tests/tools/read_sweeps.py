"""The result of `cageless sweep`, read by the tools that users have.

DuckDB, pandas and polars must find the types, the units and the nulls in place.

    python read_sweeps.py path/to/cageless path/to/a/scratch/folder
"""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import duckdb
import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pyarrow.parquet as pq

from checks import check, exit_code

PLAN = """
seed = 5
case = {case}
compute = ["static", "design", "run"]
[set]
solver.duration_s = 0.002
[grid]
bearing.balls = [13, 14]
model.formulation = ["physical", "paper"]
[samples]
method = "sobol"
count = 4
raceway.half_angle_deg = {{ from = 20.0, to = 120.0 }}
[scatter]
repeats = 2
start.gaps = {{ uniform = 0.5 }}
"""
ROWS = 32

# Type and unit of some columns, of every kind.
COLUMNS = {
    "variant": (pa.int64(), None),
    "bearing_balls": (pa.int64(), None),
    "model_formulation": (pa.string(), None),
    "raceway_half_angle_deg": (pa.float64(), "deg"),
    "start_gaps_deg": (pa.list_(pa.field("element", pa.float64(), nullable=False)), "deg"),
    "reason": (pa.string(), None),
    "static_ring_y_um": (pa.float64(), "um"),
    "static_inner_force_n": (pa.list_(pa.field("element", pa.float64(), nullable=False)), "N"),
    "run_collisions": (pa.int64(), None),
    "run_sliding_max_m_s": (pa.float64(), "m/s"),
}


def statics_in_space(binary, scratch, case):
    """Rows with an axial load have the statics of space, one without that of the plane."""
    plan = scratch / "axial.toml"
    loads = "[grid]\noperation.axial_load_n = [0, 300]\n"
    plan.write_text(f'case = {json.dumps(str(case))}\ncompute = ["static"]\n{loads}')
    subprocess.run([binary, "sweep", plan, "--out", scratch / "axial"], check=True, capture_output=True)
    frame = pq.read_table(scratch / "axial" / "sweep.parquet").to_pandas()
    spatial = ["ring_z_um", "stiffness_zz_n_m"]
    for row, load in enumerate([0, 300]):
        command = [binary, "static", case, "--set", f"operation.axial_load_n={load}", "--json"]
        static = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
        for name in ["ring_y_um", "l10r_mrev"] + spatial * row:
            found = frame[f"static_{name}"]
            check(f"{name} under {load} N", found[row] == static[name], found)
    check("no displacement along the axis in the plane", frame[[f"static_{n}" for n in spatial]].isna().all(axis=1)[0])


def main():
    binary, scratch = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    # Results of another version would be refused.
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    plan, out = scratch / "plan.toml", scratch / "out"
    case = Path(__file__).resolve().parents[2] / "cases" / "zhao-d.toml"
    plan.write_text(PLAN.format(case=json.dumps(str(case))))
    path = out / "sweep.parquet"
    path.unlink(missing_ok=True)
    subprocess.run([binary, "sweep", plan, "--out", out], check=True, capture_output=True)

    statics_in_space(binary, scratch, case)
    schema = pq.read_schema(path)
    check("no columns of space in the plane", "static_ring_z_um" not in schema.names)
    metadata = {key.decode(): value.decode() for key, value in schema.metadata.items()}
    for name, (kind, unit) in COLUMNS.items():
        check(f"type of {name}", schema.field(name).type == kind, schema.field(name).type)
        check(f"unit of {name}", metadata.get(f"unit:{name}") == unit, metadata.get(f"unit:{name}"))
    check("footer", {"schema", "version", "isa", "seed", "variants", "plan"} <= metadata.keys())
    check("seed", metadata["seed"] == "5" and metadata["variants"] == str(ROWS))

    # The plan in the footer is a plan again, and gives the same rows.
    (scratch / "again.toml").write_text(metadata["plan"])
    again = scratch / "again" / "sweep.parquet"
    again.unlink(missing_ok=True)
    command = [binary, "sweep", scratch / "again.toml", "--out", again.parent]
    subprocess.run(command, check=True, capture_output=True)
    check("plan of the footer", again.read_bytes() == path.read_bytes())

    frame = pd.read_parquet(path)
    check("rows", len(frame) == ROWS and (frame["variant"] == np.arange(ROWS)).all())
    broken = frame["raceway_half_angle_deg"] >= 90
    check("some fail and some do not", 0 < broken.sum() < ROWS, broken.sum())
    check("a reason says why", frame.loc[broken, "reason"].str.contains("half_angle_deg").all())
    check("others have figures", frame.loc[frame["reason"].isna(), "static_ring_y_um"].lt(0).all())
    check("failed ones have none", frame.loc[broken, "static_ring_y_um"].isna().all())
    check("lists", all(len(g) == n for g, n in zip(frame["start_gaps_deg"], frame["bearing_balls"])
                       if g is not None))

    lazy = pl.read_parquet(path)
    check("polars: types", lazy.schema["model_formulation"] == pl.String
          and lazy.schema["run_collisions"] == pl.Int64
          and lazy.schema["static_inner_force_n"] == pl.List(pl.Float64), lazy.schema)
    check("polars: nulls", lazy["static_ring_y_um"].null_count() == int(frame["static_ring_y_um"].isna().sum()))

    rows = duckdb.sql(f"""
        select model_formulation, count(*), count(reason), avg(static_ring_y_um)
        from '{path}' group by all order by 1""").fetchall()
    means = frame.groupby("model_formulation")["static_ring_y_um"].mean()
    check("duckdb: groups", [r[0] for r in rows] == ["paper", "physical"], rows)
    check("duckdb: means", np.allclose([r[3] for r in rows], means.to_numpy(), rtol=1e-12), rows)
    kind = duckdb.sql(f"select typeof(static_inner_force_n) from '{path}' limit 1").fetchall()[0][0]
    check("duckdb: lists", kind == "DOUBLE[]", kind)

    subprocess.run([binary, "report", out], check=True, capture_output=True)
    report = json.loads((out / "report.json").read_text())
    check("report", report["variants"] == ROWS and report["failed"] == int(frame["reason"].notna().sum()))
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())

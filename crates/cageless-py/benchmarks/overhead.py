"""What Python adds to a run of 0.05 s: the time of `case.run()`, arrays made, over that of
the run in it, which records all output rows. Beside it the command without `--out`, which
records nothing.

    python crates/cageless-py/benchmarks/overhead.py target/release/cageless
"""

from __future__ import annotations

import json
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import cageless

ROUNDS = 31

command = sys.argv[1]
case = cageless.Case.from_toml(cageless.template(), {"solver.duration_s": 0.05})
with tempfile.TemporaryDirectory() as folder:
    path = Path(folder) / "case.toml"
    path.write_text(case.to_toml())
    python: list[float] = []
    inside: list[float] = []
    bare: list[float] = []
    for _ in range(ROUNDS):
        began = time.perf_counter()
        run = case.run()
        python.append(time.perf_counter() - began)
        inside.append(run.wall_s)
        printed = subprocess.run(
            [command, "run", str(path), "--json"], capture_output=True, check=True
        )
        bare.append(json.loads(printed.stdout)["wall_s"])

for name, times in [("case.run()", python), ("of it, in Rust", inside), ("command", bare)]:
    print(f"{name:15} {1e3 * statistics.median(times):8.2f} ms, least {1e3 * min(times):8.2f} ms")
added = statistics.median(p - i for p, i in zip(python, inside, strict=True))
print(f"added by Python {1e3 * added:8.2f} ms, {100.0 * added / statistics.median(inside):.2f} %")

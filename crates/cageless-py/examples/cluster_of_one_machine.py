"""A sweep on Dask, here with two workers of this machine.

With a client of dask-jobqueue or dask-kubernetes in place of this one it runs on a
cluster; see docs/cluster.md. Writes shares.html.
"""

from __future__ import annotations

from distributed import Client, LocalCluster

import cageless


def main() -> None:
    case = cageless.Case.from_toml(cageless.template(), {"solver.duration_s": 0.005})
    plan = cageless.Plan(
        case=case,
        compute=["static", "run"],
        samples={
            "method": "sobol",
            "count": 64,
            "operation.radial_load_n": cageless.span(500.0, 3000.0),
            "operation.inner_speed_rpm": cageless.span(3000.0, 12000.0, scale="log"),
        },
    )
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        Client(cluster) as client,
    ):
        result = cageless.sweep(plan, out="out", client=client, task_seconds=0.2)
    result.report().plot_shares().write_html("shares.html")


if __name__ == "__main__":
    main()

"""Sweeps: against the command, resumed, on a cluster."""

from __future__ import annotations

import os
import pickle
import signal
import threading
import time
from pathlib import Path

import cageless
import numpy as np
import pandas as pd
import pytest
from conftest import Command, numbers

distributed = pytest.importorskip("distributed")


@pytest.fixture
def local(plan: cageless.Plan, tmp_path: Path) -> bytes:
    """The result as this machine computes it."""
    return cageless.sweep(plan, out=tmp_path / "local").path.read_bytes()


def test_a_sweep_has_the_bytes_of_the_command(
    command: Command, plan: cageless.Plan, local: bytes, tmp_path: Path
) -> None:
    path = tmp_path / "plan.toml"
    path.write_text(plan.to_toml())
    command("sweep", path, "--out", tmp_path / "command")
    assert (tmp_path / "command" / "sweep.parquet").read_bytes() == local
    assert cageless.Plan.from_file(path).to_toml() == plan.to_toml()


def test_frames_hold_what_the_file_holds(plan: cageless.Plan) -> None:
    result = cageless.sweep(plan)
    frame, written = result.data_variants(), pd.read_parquet(result.path)
    assert list(frame.columns) == list(written.columns)
    assert len(frame) == len(plan) == 240
    for name in ["variant", "operation_radial_load_n", "static_ring_y_um"]:
        np.testing.assert_array_equal(frame[name], written[name])
    assert len(result.data_failed()) == 80
    assert result.units["static_ring_y_um"] == "um"
    assert result.plan.to_toml() == plan.to_toml()
    one = plan.case(3).static().ring_y_um
    assert one == frame["static_ring_y_um"][3]


def test_the_report_is_that_of_the_command(
    command: Command, plan: cageless.Plan, tmp_path: Path
) -> None:
    result = cageless.sweep(plan, out=tmp_path)
    report = cageless.report(result, high=["run_gap_min_deg"])
    page = report.report(tmp_path / "python.html").read_text()
    printed = command("report", result.path, "--high", "run_gap_min_deg", "--json").stdout
    assert report.values == numbers(printed)
    assert page == (tmp_path / "report.html").read_text()
    assert report.data_shares().shape[0] == len(report.outputs)
    assert (report.data_best()["by"] == "run_gap_min_deg").all()
    for figure in [
        report.plot_shares(),
        report.plot_effects("static_ring_y_um"),
        report.plot_map("static_ring_y_um"),
    ]:
        assert len(figure.data) > 0
    with pytest.raises(cageless.InputError, match="there are"):
        report.plot_map("no_such_column")
    assert "variants" in report._repr_html_()


def test_an_interrupted_sweep_goes_on(plan: cageless.Plan, local: bytes, tmp_path: Path) -> None:
    def give_up(done: int, total: int) -> None:
        raise RuntimeError("enough")

    out = tmp_path / "out"
    with pytest.raises(RuntimeError, match="enough"):
        cageless.sweep(plan, out=out, threads=1, progress=give_up)
    assert not (out / "sweep.parquet").exists()
    told: list[tuple[int, int]] = []
    result = cageless.sweep(plan, out=out, threads=1, progress=lambda *at: told.append(at))
    assert result.path.read_bytes() == local
    assert told[-1] == (240, 240)


def test_shards_merge(plan: cageless.Plan, local: bytes, tmp_path: Path) -> None:
    shards = [cageless.sweep(plan, out=tmp_path, shard=(k, 3)).path for k in (1, 2, 3)]
    assert cageless.merge(shards, tmp_path / "merged").path.read_bytes() == local
    with pytest.raises(cageless.InputError, match="missing"):
        cageless.merge(shards[:2], tmp_path / "incomplete")
    with pytest.raises(cageless.InputError, match="shard"):
        cageless.sweep(plan, out=tmp_path, shard=(4, 3))


def test_another_plan_is_refused(plan: cageless.Plan, tmp_path: Path) -> None:
    cageless.sweep(plan, out=tmp_path)
    other = plan.to_toml().replace("seed = 7", "seed = 8")
    with pytest.raises(cageless.InputError, match="seed"):
        cageless.sweep(cageless.Plan.from_toml(other), out=tmp_path)


def test_impossible_plans_are_refused(plan: cageless.Plan) -> None:
    case = plan.case(0)
    with pytest.raises(cageless.InputError, match="did you mean"):
        cageless.Plan(case=case, compute=["static"], grid={"raceway.half_angel_deg": [1.0]})
    for variant in (240, -1):
        with pytest.raises(cageless.InputError, match=f"variant = {variant} .* from 0 to 239"):
            plan.case(variant)
    with pytest.raises(cageless.InputError, match="half_angle_deg"):
        plan.case(200)
    assert pickle.loads(pickle.dumps(plan)).to_toml() == plan.to_toml()
    assert "variants" in plan._repr_html_()


def test_a_name_stands_for_a_list_of_one() -> None:
    case, name = cageless.Case.from_toml(cageless.template()), "static_ring_y_um"
    grid = {"operation.radial_load_n": [500.0, 900.0]}
    plan = cageless.Plan(case=case, compute="static", keep=name, grid=grid)
    assert plan == cageless.Plan(case=case, compute=["static"], keep=[name], grid=grid)
    result = cageless.sweep(plan)
    assert result.report(high=name) == result.report(high=[name])


@pytest.mark.parametrize("shared", [False, True])
def test_a_cluster_that_loses_a_worker_gives_the_same_bytes(
    plan: cageless.Plan, local: bytes, tmp_path: Path, shared: bool
) -> None:
    out = tmp_path / "cluster"
    killed: list[int] = []

    def kill(worker: int) -> None:
        parts = out / "sweep.parquet.parts"
        deadline = time.monotonic() + 20.0
        while not list(parts.glob("rows-*.parquet")) and time.monotonic() < deadline:
            time.sleep(0.002)
        os.kill(worker, signal.SIGKILL)
        # A sweep that was over by then would show nothing.
        if not (out / "sweep.parquet").exists():
            killed.append(worker)

    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        workers = list(client.run(os.getpid).values())
        assert len(set(workers)) == 2
        killer = threading.Thread(target=kill, args=(workers[0],))
        killer.start()
        result = cageless.sweep(plan, out=out, client=client, shared=shared, task_seconds=0.02)
        killer.join()
        assert killed == workers[:1]
        assert result.path.read_bytes() == local
        # What is there is not computed again.
        began = time.monotonic()
        cageless.sweep(plan, out=out, client=client, shared=shared)
        assert time.monotonic() - began < 1.0
    assert not (out / "sweep.parquet.parts").exists()


def test_a_plan_of_keywords_has_no_lines() -> None:
    case = cageless.Case.from_toml(cageless.template())
    wrong: list[tuple[dict[str, list[object]], str]] = [
        ({"operation.radial_load": [1.0]}, "operation.radial_load is not a key of [operation]"),
        ({"raceway.half_angle_deg": ["a"]}, "none of the 1 variants is a possible case. The first: "
         "raceway.half_angle_deg = \"a\" is not possible"),
    ]
    for axis, said in wrong:
        with pytest.raises(cageless.InputError) as error:
            cageless.Plan(case=case, compute=["static"], grid=axis)
        assert error.value.line is None
        assert str(error.value).startswith(said), str(error.value)


def test_a_run_is_not_a_sweep(tmp_path: Path) -> None:
    (tmp_path / "summary.json").write_text("{}")
    with pytest.raises(cageless.InputError, match="the result of `cageless run` or `drop`, not of a sweep"):
        cageless.report(tmp_path)


def test_damaged_results_are_refused_and_do_not_panic(local: bytes, tmp_path: Path) -> None:
    length = int.from_bytes(local[-8:-4], "little")
    path = tmp_path / "damaged.parquet"
    for at in range(len(local) - 8 - length, len(local), 7):
        damaged = bytearray(local)
        damaged[at] ^= 0xFF
        path.write_bytes(damaged)
        with pytest.raises(cageless.InputError, match="damaged.parquet: cannot be read"):
            cageless.report(path)


def test_a_plan_sets_values_of_its_case() -> None:
    case = cageless.Case.from_toml(cageless.template())
    grid = {"operation.radial_load_n": [500.0, 900.0]}
    changes = {"solver": {"duration_s": 0.01}, "raceway.half_angle_deg": 24.0}
    plan = cageless.Plan(case=case, compute=["static"], grid=grid, set=changes)
    assert plan == cageless.Plan(case=case.replace(changes), compute=["static"], grid=grid)
    assert plan != cageless.Plan(case=case, compute=["static"], grid=grid)
    assert plan.case(1).solver.duration_s == 0.01
    assert plan.case(1).operation.radial_load_n == 900.0
    assert pickle.loads(pickle.dumps(plan)) == plan
    with pytest.raises(cageless.InputError, match="solver.durations_s"):
        cageless.Plan(case=case, compute=["static"], grid=grid, set={"solver.durations_s": 1.0})

"""Runs: against the command, as arrays, interrupted, stopped."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import cageless
import numpy as np
import pandas as pd
import plotly.graph_objects as go
import pytest
from conftest import Command, figures, summary_of


@pytest.fixture(scope="module")
def both(
    command: Command, tmp_path_factory: pytest.TempPathFactory
) -> tuple[cageless.Run, Path]:
    """One run from Python, and the folder of the command's."""
    from conftest import lively

    folder = tmp_path_factory.mktemp("run")
    path = folder / "case.toml"
    path.write_text(lively().to_toml())
    command("run", path, "--out", folder)
    return cageless.Case.from_file(path).run(), folder


def same(frame: pd.DataFrame, path: Path) -> None:
    """The same columns with the same bits."""
    written = pd.read_parquet(path)
    assert list(frame.columns) == list(written.columns)
    assert len(frame) == len(written) > 0
    for name in frame.columns:
        one, other = frame[name].to_numpy(), written[name].to_numpy()
        assert one.dtype == other.dtype, name
        assert one.tobytes() == other.tobytes(), name


def test_tables_have_the_bits_of_the_command(both: tuple[cageless.Run, Path]) -> None:
    run, folder = both
    same(run.data_balls(), folder / "balls.parquet")
    same(run.data_ring(), folder / "ring.parquet")
    same(run.data_collisions(), folder / "collisions.parquet")


def test_the_summary_is_that_of_the_command(both: tuple[cageless.Run, Path]) -> None:
    run, folder = both
    written = summary_of(folder)
    assert written.pop("wall_s") > 0.0
    assert {k: v for k, v in run.values.items() if k != "wall_s"} == written
    assert run.collisions == written["collisions"] > 0
    summary = run.data_summary()
    assert summary.value["collisions"] == run.collisions
    assert (summary.unit["gap_min_deg"], summary.label["gap_min_deg"]) == ("deg", "smallest gap")


def test_figures_are_those_of_the_report(both: tuple[cageless.Run, Path]) -> None:
    run, folder = both
    shown = figures(folder / "report.html")
    names = {name for name in dir(run) if name.startswith("plot_")}
    in_space = {"plot_contact_angles", "plot_groove"}
    assert len(names) == 13 and in_space < names
    for name in in_space:
        with pytest.raises(cageless.InputError, match='set model.motion = "space"'):
            getattr(run, name)()
    for name in sorted(names - in_space):
        figure = getattr(run, name)()
        assert isinstance(figure, go.Figure)
        made = json.loads(run._core.figure(name.removeprefix("plot_"), None, None, None))
        assert made["layout"].pop("height") == figure.layout.height > 200
        assert made in shown, name
        assert len(figure.data) == len(made["data"])


def test_the_page_is_that_of_the_report(both: tuple[cageless.Run, Path], tmp_path: Path) -> None:
    run, folder = both
    page = run.report(tmp_path / "page.html").read_text()
    assert page == (folder / "report.html").read_text()


def test_arrays_are_not_copied_and_not_writeable(both: tuple[cageless.Run, Path]) -> None:
    run, _ = both
    assert run.gap_rad is run.array("gap_rad")
    assert run.gap_rad.shape == (len(run.time_s), 14)
    with pytest.raises(ValueError):
        run.gap_rad[0, 0] = 1.0
    frame = run.data_balls()
    assert np.shares_memory(frame["gap_rad"].to_numpy(), run.gap_rad)
    assert np.shares_memory(run.data_ring()["x_m"].to_numpy(), run.array("x_m", "ring"))
    assert len(run.array("next_ball")) == len(run.data_collisions())
    assert "collisions" in run._repr_html_()


def test_a_run_that_stops_says_why_and_keeps_what_there_is(
    command: Command, tmp_path: Path
) -> None:
    case = cageless.Case.from_toml(
        cageless.template(),
        {"start.state": "rolling", "start.ring_y_um": -450.0, "solver.duration_s": 0.05},
    )
    path = tmp_path / "case.toml"
    path.write_text(case.to_toml())
    with pytest.raises(cageless.UnphysicalError) as error:
        case.run()
    stderr = command("run", path, code=3).stderr
    assert stderr == f"error: {error.value}\n"
    run = error.value.result
    assert run is not None
    assert run.stopped == str(error.value)
    assert 0.0 <= run.time_s[-1] < 0.05
    assert run.values["stopped"]["advice"] in str(error.value)


INTERRUPTED = """
import cageless, signal
# A program started in the background of a shell ignores Ctrl-C.
signal.signal(signal.SIGINT, signal.default_int_handler)
case = cageless.Case.from_toml(cageless.template(), {"solver.duration_s": 1000.0})
print("started", flush=True)
try:
    case.WHAT
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


@pytest.mark.parametrize(
    "what",
    [
        "run()",
        "tolerance(samples=100_000)",
        "search(runs_max=100_000)",
        "from_toml(''); cageless.sweep(cageless.Plan(case=case, compute=['run'], "
        "grid={'operation.radial_load_n': [500.0, 600.0]}))",
    ],
)
def test_ctrl_c_ends_a_computation(what: str) -> None:
    code = INTERRUPTED.replace("case.WHAT", what.partition("; ")[2] or f"case.{what}")
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None
    assert process.stdout.readline() == "started\n"
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    sent = time.monotonic()
    try:
        rest, _ = process.communicate(timeout=20)
    finally:
        process.kill()
    assert rest == "interrupted\n"
    assert time.monotonic() - sent < 10.0


def test_other_threads_go_on_meanwhile() -> None:
    case = cageless.Case.from_toml(cageless.template(), {"solver.duration_s": 0.3})
    worker = threading.Thread(target=case.run)
    worker.start()
    turns = 0
    while worker.is_alive():
        time.sleep(0.001)
        turns += 1
    assert turns > 20


def test_messages_name_columns_sections_and_folders(tmp_path: Path) -> None:
    case = cageless.Case.from_toml(cageless.template(), {"solver.duration_s": 0.002})
    run = case.run()
    with pytest.raises(KeyError) as missing:
        run.array("inner_force", "balls")
    assert isinstance(missing.value, cageless.ColumnError)
    assert isinstance(missing.value, cageless.CagelessError)
    message = str(missing.value)
    assert "'inner_force' is not a column of balls: did you mean inner_force_n?" in message
    assert "its columns are angle_rad" in message
    with pytest.raises(AttributeError, match="no 'gap_min'; did you mean gap_min_deg?"):
        run.gap_min
    with pytest.raises(TypeError, match=r"plot_energy\(\) has no argument 'balls': it takes title"):
        run.plot_energy(balls=[1])
    with pytest.raises(cageless.InputError, match=r"the case has no \[housing\]"):
        run.plot_vibration()
    path = tmp_path / "none" / "page.html"
    with pytest.raises(cageless.InputError, match="the folder .*none is not there"):
        run.report(path)
    with pytest.raises(cageless.InputError, match="is a directory"):
        run.report(tmp_path)
    (tmp_path / "file").write_text("")
    with pytest.raises(cageless.InputError, match="is not there"):
        case.design().report(tmp_path / "file" / "page.html")


def test_a_sheet_has_the_files_of_the_command(command: Command, tmp_path: Path) -> None:
    ring = {"bearing": {"outer_ring_outer_radius_mm": 31.0, "outer_ring_width_mm": 16.0}}
    case = cageless.Case.from_toml(cageless.template(), ring)
    (tmp_path / "case.toml").write_text(case.to_toml())
    options = ("--without-benefit", "--axial-span-um", "35", "--centre-angle-deg", "0.5")
    command("sheet", tmp_path / "case.toml", *options, "--out", tmp_path / "command")
    page = case.sheet(tmp_path / "python", axial_span_um=35.0, centre_angle_deg=0.5, benefit=False)
    assert page == tmp_path / "python" / "report.html"
    for name in ("drawing.svg", "drawing.pdf", "sheet.json"):
        assert (tmp_path / "python" / name).read_bytes() == (tmp_path / "command" / name).read_bytes()
    with pytest.raises(cageless.InputError, match="axial_span_um = -1 is not possible"):
        case.sheet(tmp_path / "none", axial_span_um=-1.0)
    assert not (tmp_path / "none").exists()


def test_a_file_of_no_format_makes_no_folder(tmp_path: Path) -> None:
    ring = {"bearing": {"outer_ring_outer_radius_mm": 31.0, "outer_ring_width_mm": 16.0}}
    case = cageless.Case.from_toml(cageless.template(), ring)
    with pytest.raises(cageless.InputError, match=r"ends in \.step"):
        case.export(tmp_path / "ring.obj", ["stl"])
    assert not list(tmp_path.iterdir())


def test_a_run_in_space_has_the_tables_of_the_command(command: Command, tmp_path: Path) -> None:
    axial = {"operation.axial_load_n": 150.0, "solver.duration_s": 0.02}
    case = cageless.Case.from_toml(cageless.template(), axial)
    (tmp_path / "case.toml").write_text(case.to_toml())
    command("run", tmp_path / "case.toml", "--out", tmp_path / "command")
    run = cageless.Case.from_file(tmp_path / "case.toml").run()
    same(run.data_balls(), tmp_path / "command" / "balls.parquet")
    same(run.data_ring(), tmp_path / "command" / "ring.parquet")
    assert "inner_contact_angle_rad" in run.data_balls().columns
    assert run.ring_z_mean_um > 5.0
    # The most loaded ball leans towards +z; its ellipse ends between its contact angle and the shoulder.
    assert run.inner_contact_angle_mean_deg < run.inner_ellipse_edge_max_deg < 60.0
    assert len(run.plot_contact_angles().data) > 2 and len(run.plot_groove().data) > 2
    run.save(tmp_path / "python")
    back = cageless.load(tmp_path / "python")
    same(back.data_balls(), tmp_path / "command" / "balls.parquet")


def test_a_run_in_space_is_verified() -> None:
    changes = {"operation.axial_load_n": 150.0, "solver.duration_s": 0.03}
    run = cageless.Case.from_toml(cageless.template(), changes).run(verify=True, threads=2)
    verification = run.verification
    assert verification is not None
    assert verification.values["momentum_residual_relative"] < 1e-7
    assert verification.step_biased == 0

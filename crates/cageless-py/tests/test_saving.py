"""Results as files and back: folders, pickles, CSV, MATLAB; their units and their short forms."""

from __future__ import annotations

import builtins
import json
import multiprocessing
import pickle
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

import cageless
import numpy as np
import pandas as pd
import pytest
from cageless.frames import filled
from cageless.units import unit
from conftest import ROOT, Command, falling, lively


def template(**changes: Any) -> cageless.Case:
    return cageless.Case.from_toml(cageless.template()).replace(**changes)


def quick() -> cageless.Case:
    return template(solver={"method": "verlet", "step_us": "auto", "duration_s": 0.01})


FEW_ORBITS = {
    "solver__duration_s": 0.002,
    "steady__transient_orbits": 1.0,
    "steady__measured_orbits": 2.0,
}


def a_search() -> cageless.SearchResult:
    return quick().search(axial_span_mm=5.1, half_angle_deg=(24.0, 26.0), initial_states=1, runs_max=32)


def a_sweep() -> cageless.SweepResult:
    loads = cageless.span(500.0, 3000.0, 5)
    angles = [20.0, 25.0, 170.0]
    plan = cageless.Plan(
        case=template(),
        compute=["static"],
        grid={"operation.radial_load_n": loads, "raceway.half_angle_deg": angles},
    )
    return cageless.sweep(plan)


MADE: dict[str, Callable[[], Any]] = {
    "run": lambda: lively().run(),
    "verified": lambda: template(solver__duration_s=0.002).run(verify=True),
    "drop": lambda: falling().drop(compare=True, samples=2),
    "static": lambda: template().static(),
    "design": lambda: template().design(),
    "search": a_search,
    "tolerance": lambda: quick().tolerance(samples=3, groove_depth_um=3.0, threads=2),
    "comparison": lambda: template(**FEW_ORBITS).compare(draws=2),
    "sweep": a_sweep,
    "report": lambda: a_sweep().report(high=["static_ring_y_um"]),
}

_results: dict[str, Any] = {}


def result(kind: str) -> Any:
    """A result of each kind, made once."""
    if kind not in _results:
        _results[kind] = MADE[kind]()
    return _results[kind]


def plots(found: Any) -> dict[str, str]:
    """Figures of a result as text; of one that has nothing to show, why."""
    shown = {}
    for name in dir(found):
        if name.startswith("plot_"):
            given = ["static_ring_y_um"] if name in ("plot_effects", "plot_map") else []
            try:
                shown[name] = getattr(found, name)(*given, title="above").to_json()
            except cageless.InputError as error:
                shown[name] = str(error)
    return shown


def assert_same(one: Any, other: Any) -> None:
    """The same object: equal, and so are its tables and figures."""
    assert type(one) is type(other)
    assert one == other
    assert repr(one) == repr(other) or isinstance(one, cageless.SweepResult)
    tables, others = filled(one), filled(other)
    assert list(tables) == list(others)
    for name, frame in tables.items():
        if name == "summary":
            frame = frame.drop(index="wall_s", errors="ignore")
            others[name] = others[name].drop(index="wall_s", errors="ignore")
        pd.testing.assert_frame_equal(frame, others[name])
        assert frame.attrs["units"] == others[name].attrs["units"]
    assert plots(one) == plots(other)


@pytest.mark.parametrize("kind", MADE)
def test_what_is_saved_comes_back_equal(kind: str, tmp_path: Path) -> None:
    made = result(kind)
    folder = made.save(tmp_path / "deep" / kind)
    loaded = cageless.load(folder)
    assert_same(loaded, made)
    again = loaded.save(tmp_path / "again")
    there = contents(folder)
    for name, found in contents(again).items():
        assert found == there[name], name
    assert not [path for path in folder.iterdir() if path.name.startswith(".")]


@pytest.mark.parametrize("kind", MADE)
def test_every_result_survives_a_pickle(kind: str, tmp_path: Path) -> None:
    made = result(kind)
    pickled = pickle.dumps(made)
    back = pickle.loads(pickled)
    assert_same(back, made)
    assert_same(pickle.loads(pickle.dumps(back)), made)
    folders = [contents(each.save(tmp_path / name)) for name, each in [("a", made), ("b", back)]]
    assert folders[0] == folders[1]
    # The page follows from less than it holds.
    if kind in ("static", "design", "search", "tolerance", "report"):
        assert len(pickled) < len(folders[0]["report.html"]) / 4


def test_a_run_that_is_not_the_same_is_not_equal() -> None:
    run = result("run")
    assert run == lively().run()
    assert run != lively().replace(solver__duration_s=0.019).run()
    assert run != lively().replace(contact__friction_coefficient=0.02).run()
    # The same motion of another case.
    assert run != lively().replace(title="other").run()
    assert result("static") != template(operation__radial_load_n=900.0).static()
    assert run != result("static")


def test_pages_and_verification_are_those_of_the_computed_run(tmp_path: Path) -> None:
    run = result("verified")
    back = pickle.loads(pickle.dumps(run))
    pages = [made.report(tmp_path / name) for made, name in [(run, "a.html"), (back, "b.html")]]
    assert pages[0].read_text() == pages[1].read_text()
    assert back.verification == run.verification
    pd.testing.assert_frame_equal(
        back.verification.data_numbers(), run.verification.data_numbers()
    )
    assert not back.gap_rad.flags.writeable


def static_of(load: float) -> cageless.Static:
    return template(operation__radial_load_n=load).static()


def run_of(case: cageless.Case) -> cageless.Run:
    return case.run()


def test_processes_send_their_results() -> None:
    loads = [500.0, 1500.0]
    cases = [template(operation__radial_load_n=load, solver__duration_s=0.002) for load in loads]
    method = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(2, mp_context=method) as pool:
        statics = list(pool.map(static_of, loads))
        runs = list(pool.map(run_of, cases))
    assert statics == [static_of(load) for load in loads]
    assert runs == [case.run() for case in cases]
    assert runs[0] != runs[1]


def test_a_run_that_stopped_comes_back_with_its_reason(tmp_path: Path) -> None:
    case = template(start={"state": "rolling", "ring_y_um": -450.0}, solver__duration_s=0.05)
    with pytest.raises(cageless.UnphysicalError) as error:
        case.run()
    run = error.value.result
    assert run is not None
    back = pickle.loads(pickle.dumps(error.value))
    assert back.result == run
    assert back.result.stopped == str(error.value)
    run.save(tmp_path)
    loaded = cageless.load(tmp_path)
    assert isinstance(loaded, cageless.Run)
    assert loaded.stopped == run.stopped
    assert loaded == run


SEARCH = {"axial_span_mm": 5.1, "half_angle_deg": [24.0, 26.0], "initial_states": 1, "runs_max": 32}
SHORT = {"solver": {"duration_s": 0.002}}
#: Of each kind of result its case, the words of the command and the call of Python.
SAME: dict[str, tuple[Callable[[], Any], list[object], Callable[[Any], Any]]] = {
    "run": (lambda: lively(), ["run", "--verify"], lambda case: case.run(verify=True)),
    "drop": (
        lambda: falling(),
        ["drop", "--compare", "conventional", "--samples", 2],
        lambda case: case.drop(compare=True, samples=2),
    ),
    "rotor": (
        lambda: cageless.RotorCase.from_file(
            ROOT / "cases" / "rotors" / "two-bearings.toml", {"solver.duration_s": 0.0006}
        ),
        ["drop"],
        lambda case: case.drop(),
    ),
    "static": (template, ["static"], lambda case: case.static()),
    "design": (quick, ["design"], lambda case: case.design()),
    "poor": (
        lambda: quick().replace(raceway__half_angle_deg=28.0),
        ["design"],
        lambda case: case.design(),
    ),
    "search": (
        lambda: quick().replace(search=SEARCH),
        ["design", "--search"],
        lambda case: case.search(),
    ),
    "tolerance": (quick, ["tolerance", "--samples", 0], lambda case: case.tolerance(samples=0)),
    "comparison": (
        lambda: template(**FEW_ORBITS),
        ["compare", "--with-conventional", "--draws", 2],
        lambda case: case.compare(draws=2),
    ),
}


def contents(folder: Path) -> dict[str, bytes]:
    """Files of a folder and of those in it."""
    files = (path for path in folder.rglob("*") if path.is_file())
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


_left: dict[str, tuple[Path, Any]] = {}


@pytest.fixture
def left(
    command: Command, tmp_path_factory: pytest.TempPathFactory
) -> Callable[[str], tuple[Path, Any]]:
    """Gives the folder that the command leaves of a case, and what Python computes of it, each made once."""

    def of(kind: str) -> tuple[Path, Any]:
        if kind not in _left:
            make, [name, *options], compute = SAME[kind]
            case, folder = make(), tmp_path_factory.mktemp(kind)
            path = folder / "case.toml"
            path.write_text(case.to_toml())
            command(name, path, *options, "--out", folder / "command")
            _left[kind] = folder / "command", compute(type(case).from_file(path))
        return _left[kind]

    return of


@pytest.mark.parametrize("kind", ["static", "tolerance", "design", "poor", "search"])
def test_folders_of_the_command_are_read(
    kind: str, left: Callable[[str], tuple[Path, Any]]
) -> None:
    folder, made = left(kind)
    loaded = cageless.load(folder)
    assert type(loaded) is type(made)
    assert loaded == made
    if isinstance(loaded, cageless.SearchResult):
        assert loaded.case.run().stopped is None


def test_a_run_of_the_command_is_read(command: Command, tmp_path: Path) -> None:
    case, path = quick(), tmp_path / "case.toml"
    path.write_text(case.to_toml())
    command("run", path, "--out", tmp_path / "run")
    assert cageless.load(tmp_path / "run") == case.run()


@pytest.mark.parametrize("kind", SAME)
def test_save_leaves_the_folder_of_the_command(
    kind: str, left: Callable[[str], tuple[Path, Any]], tmp_path: Path
) -> None:
    folder, made = left(kind)
    saved = contents(made.save(tmp_path / "saved"))
    written = contents(folder)
    assert sorted(saved) == sorted(written)
    # The time that a run took, with its seal; the comparison has names that the command cannot give.
    own = {"run": {"summary.json", "report.json"}, "comparison": {"compare.json", "report.html"}}
    for file in saved.keys() - own.get(kind, set()):
        assert saved[file] == written[file], file


def test_an_analysis_and_a_sweep_leave_the_folders_of_the_command(
    command: Command, tmp_path: Path
) -> None:
    sweep = a_sweep()
    (tmp_path / "plan.toml").write_text(sweep.plan.to_toml())
    command("sweep", tmp_path / "plan.toml", "--out", tmp_path / "command")
    assert contents(sweep.save(tmp_path / "saved")) == contents(tmp_path / "command")
    words = ["--high", "static_ring_y_um", "--out", tmp_path / "analysis"]
    command("report", tmp_path / "command", *words)
    made = cageless.report(tmp_path / "command", high=["static_ring_y_um"])
    saved = made.save(tmp_path / "python")
    assert contents(saved) == contents(tmp_path / "analysis")


def test_folders_that_are_no_result_are_refused(tmp_path: Path) -> None:
    with pytest.raises(cageless.InputError, match="is not there"):
        cageless.load(tmp_path / "none")
    with pytest.raises(cageless.InputError, match="holds no result: one of summary.json"):
        cageless.load(tmp_path)
    run, static = result("run"), result("static")
    folder = run.save(tmp_path / "run")
    (folder / "ring.parquet").write_bytes(b"PAR1 no more PAR1")
    with pytest.raises(cageless.InputError, match="ring.parquet: cannot be read"):
        cageless.load(folder)
    run.save(folder)
    (folder / "report.json").write_text('{"title": 7}')
    with pytest.raises(cageless.InputError, match="report.json of a saved run"):
        cageless.load(folder).plot_gaps()
    static.save(folder)
    with pytest.raises(cageless.InputError, match="several results: summary.json, static.json"):
        cageless.load(folder)
    (tmp_path / "file").write_text("")
    with pytest.raises(cageless.InputError, match="file"):
        static.save(tmp_path / "file")
    broken = static.save(tmp_path / "broken")
    for text in ("{", "[]", "[" * 100_000, "\x00"):
        (broken / "static.json").write_text(text)
        with pytest.raises(cageless.InputError, match="static.json: cannot be read"):
            cageless.load(broken)
    (broken / "static.json").write_bytes(b"\xff")
    with pytest.raises(cageless.InputError, match="static.json: cannot be read"):
        cageless.load(broken)
    (broken / "static.json").rename(broken / "summary.json")
    for text, why in [
        ('{"bearings": 7, "stopped": {}}', "lacks `bearings`"),
        ('{"case": {}, "impacts": 3}', "of an earlier version must be computed again"),
        ('{"bearings": [7], "tables": {}}', "parquet"),
    ]:
        (broken / "summary.json").write_text(text)
        with pytest.raises(cageless.InputError, match=why):
            cageless.load(broken)
    text = result("drop").save(tmp_path / "other") / "summary.json"
    summary = {key: value for key, value in json.loads(text.read_text()).items() if key != "isa"}
    text.write_text(json.dumps(summary))
    with pytest.raises(cageless.InputError, match="no isa"):
        cageless.load(tmp_path / "other").save(tmp_path / "third")


@pytest.mark.parametrize("kind", ["run", "rotor"])
def test_tables_of_another_result_are_refused(
    kind: str, left: Callable[[str], tuple[Path, Any]], tmp_path: Path
) -> None:
    folder = left(kind)[1].save(tmp_path / "one")
    place = folder / "bearing-2" if kind == "rotor" else folder
    other = lively().replace(solver__duration_s=0.001).run().save(tmp_path / "other")
    (place / "ring.parquet").write_bytes((other / "ring.parquet").read_bytes())
    with pytest.raises(cageless.InputError, match=r"ring.parquet: is of another computation than .*summary.json"):
        cageless.load(folder)


def test_a_folder_has_one_writer(tmp_path: Path) -> None:
    import fcntl

    folder = result("static").save(tmp_path)
    with open(folder / ".cageless.lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        with pytest.raises(cageless.InputError, match="another process is writing a result there"):
            result("run").save(folder)
        with pytest.raises(cageless.InputError, match="another process is writing a result there"):
            result("run").to_csv(folder)
    assert {path.name for path in folder.iterdir()} >= {"static.json"}
    result("static").save(folder)


@pytest.mark.parametrize("kind", MADE)
def test_tables_as_csv_have_all_digits(kind: str, tmp_path: Path) -> None:
    made = result(kind)
    files = made.to_csv(tmp_path)
    tables = filled(made)
    assert [path.name for path in files] == [f"{name}.csv" for name in tables]
    for path, frame in zip(files, tables.values(), strict=True):
        read = pd.read_csv(path)
        assert len(read) == len(frame)
        for name in frame.select_dtypes(include=["float64"]).columns:
            assert np.array_equal(
                read[name].to_numpy(float), frame[name].to_numpy(float), equal_nan=True
            ), name


def test_texts_in_csv_are_texts() -> None:
    from cageless import files

    texts = ["=HYPERLINK(1)", "a\x1b[31m", "-1", "5 - 3", None]
    frame = pd.DataFrame({"=name": texts, "value": [-1.0, 2.0, 3.0, 4.0, np.nan]})
    shown = ["'=HYPERLINK(1)", "a\\u001b[31m", "'-1", "5 - 3", ""]
    values = ["-1.0", "2.0", "3.0", "4.0", ""]
    lines = [f"{text},{value}" for text, value in zip(shown, values, strict=True)]
    for each in (frame, frame.set_index("=name")):
        assert files.spreadsheet(each).splitlines()[1:] == lines


@pytest.mark.parametrize("kind", MADE)
def test_tables_go_to_matlab(kind: str, tmp_path: Path) -> None:
    from scipy import io

    made = result(kind)
    path = made.to_mat(tmp_path / "result.mat")
    read = io.loadmat(path, simplify_cells=True)
    for name, frame in filled(made).items():
        for column in frame.select_dtypes(include=["float64"]).columns:
            stored = np.atleast_1d(read[name][column])
            assert np.array_equal(stored, frame[column].to_numpy(), equal_nan=True), column
            symbol = read["units"][name][column]
            # An empty text comes back as an empty array.
            assert (symbol if isinstance(symbol, str) else "") == frame.attrs["units"][column]


def test_without_scipy_it_says_what_is_missing(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    genuine = builtins.__import__

    def refuse(name: str, *rest: Any, **more: Any) -> Any:
        if name.startswith("scipy"):
            raise ImportError(name)
        return genuine(name, *rest, **more)

    monkeypatch.setattr(builtins, "__import__", refuse)
    with pytest.raises(cageless.CagelessError, match="needs SciPy.* pip install scipy"):
        result("static").to_mat(tmp_path / "static.mat")
    assert not list(tmp_path.iterdir())


def test_a_matlab_file_goes_where_there_is_a_folder(tmp_path: Path) -> None:
    with pytest.raises(cageless.InputError, match="make it first"):
        result("static").to_mat(tmp_path / "none" / "static.mat")


def test_units_are_those_of_the_files(tmp_path: Path) -> None:
    import pyarrow.parquet as pq

    run = result("run")
    run.save(tmp_path)
    for name, frame in {n: run._frames[n]() for n in ("balls", "ring", "collisions")}.items():
        footer = pq.read_metadata(tmp_path / f"{name}.parquet").metadata
        units = {
            key.decode().removeprefix("unit:"): value.decode()
            for key, value in footer.items()
            if key.startswith(b"unit:")
        }
        assert frame.attrs["units"] == units
    assert result("static").data_balls().attrs["units"]["inner_force_n"] == "N"
    influences = result("tolerance").data_influences().attrs["units"]
    assert influences["critical_gap_deg_min"] == "deg"
    assert result("sweep").data_variants().attrs["units"]["static_ring_y_um"] in ("um", "µm")


def test_units_are_those_that_are_declared() -> None:
    search, drop = result("search"), result("drop")
    for frame in (search.data_structures(), search.data_front(), search.data_confirmation()):
        assert frame.attrs["units"]["impulse_mn_s"] == "mN s"
    assert search.data_confirmation().attrs["units"]["impulse_mn_s_error"] == "mN s"
    counted = drop.data_drops().attrs["units"]
    assert counted["collisions_above_0_1_m_s"] == counted["collisions"] == ""
    # Keys of the case file, as run.
    assert dict(drop.case.rotor.data_summary().unit.filter(like="contact_")) == {
        "contact_damping_s_m": "s/m",
        "contact_exponent": "",
        "contact_stiffness_n_mp": "N/m^p",
    }
    assert drop.case.bearing.data_summary().unit["inner_ring_polar_inertia_kg_m2"] == "kg m^2"
    assert drop.case.contact.data_summary().unit["damping_n_s_m1_5"] == "N s/m^1.5"
    # In no table of declared names, but ending in the unit of one.
    assert counted["support_damping_n_s_m"] == "N s/m"
    assert [unit(name) for name in ("tilt_x_mrad", "a_torque_n_m", "step_s_end")] == ["mrad", "N m", "s"]


def test_a_mean_and_its_error_are_two_columns() -> None:
    [point] = result("search").values["own"]["points"]
    frame = result("search").own.data_points()
    for name in ("impulse_mn_s", "friction_w"):
        assert frame[name][0] == point["motion"][name]
        assert frame[f"{name}_error"][0] == point["errors"][name]
        assert frame[f"bunched_{name}"][0] == point["bunched"][name]


@pytest.mark.parametrize("kind", MADE)
def test_a_result_is_not_written_to(kind: str) -> None:
    with pytest.raises(AttributeError, match=r"\.kind cannot be set: it is a result; replace\(\)"):
        result(kind).kind = "other"
    name = next(iter(result(kind).values))
    with pytest.raises(AttributeError, match=f"{name} cannot be set"):
        setattr(result(kind), name, 3)
    assert getattr(result(kind), name) != 3


@pytest.mark.parametrize("kind", MADE)
def test_the_short_form_is_one_line(kind: str) -> None:
    text = repr(result(kind))
    assert text.startswith(f"<{type(result(kind)).__name__}: ") and text.endswith(">")
    assert "\n" not in text and len(text) < 200
    if kind == "design":
        assert text.startswith("<Design: works")
    if kind == "static":
        assert text.startswith("<Static: inner_pressure_max_mpa ")
    if kind == "report":
        assert "15 variants, 5 failed" in text


def test_summaries_saved_are_json_of_the_command(tmp_path: Path) -> None:
    run = result("run")
    run.save(tmp_path)
    tables = {"balls.parquet", "ring.parquet", "collisions.parquet"}
    summary = json.loads((tmp_path / "summary.json").read_text())
    assert summary.pop("tables").keys() == tables
    assert summary == run.values
    names = {path.name for path in tmp_path.iterdir()}
    assert names == tables | {"summary.json", "report.html", "report.json"}

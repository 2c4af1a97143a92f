"""Verifications, searches, tolerances, exports: against the command, ended, refused."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import cageless
import numpy as np
import pytest
from conftest import ROOT, Command, figures, lively, made, numbers, summary_of

CASE = ROOT / "cases" / "zhao-d.toml"
QUICK = {"solver.method": "verlet", "solver.step_us": "auto"}
SMALL: dict[str, Any] = {
    "axial_span_mm": 5.1,
    "half_angle_deg": [24.0, 26.0],
    "initial_states": 1,
    "runs_max": 32,
}
RING = {"bearing.outer_ring_outer_radius_mm": 31.0, "bearing.outer_ring_width_mm": 16.0}


def sets(changes: dict[str, Any]) -> list[str]:
    return [word for k, v in changes.items() for word in ("--set", f"{k}={json.dumps(v)}")]


def small() -> cageless.Case:
    return cageless.Case.from_file(CASE, QUICK)


def test_a_verification_is_that_of_the_command(command: Command, tmp_path: Path) -> None:
    path = tmp_path / "case.toml"
    case = lively()
    path.write_text(case.to_toml())
    printed = command("run", path, "--verify", "--out", tmp_path).stdout
    written = summary_of(tmp_path)
    run = cageless.Case.from_file(path).run(verify=True, threads=2)
    verification = run.verification
    assert verification is not None
    assert verification.values == written["verification"]
    assert run.warnings == written["warnings"]
    counts = [verification.converged, verification.statistical, verification.step_biased]
    frame = verification.data_numbers()
    assert sum(counts) == len(frame) == 17
    # All are in the table that the command prints.
    assert all(f"\n{label}  " in printed for label in frame.label)
    number = verification.numbers.gap_min_deg
    assert frame.verdict["gap_min_deg"] == number.verdict
    assert frame.standard_error["gap_min_deg"] == number.standard_error
    assert verification.distance.perturbed.shape == verification.distance.time_s.shape
    assert list(verification.data_distance().columns) == ["time_s", "perturbed", "half_step"]
    ledger = verification.data_ledger()
    assert ledger["residual_relative"]["energy"] == verification.energy_residual_relative
    page = run.report(tmp_path / "python.html").read_text()
    assert page == (tmp_path / "report.html").read_text()
    assert case.run().verification is None


@pytest.fixture(scope="module")
def found() -> cageless.SearchResult:
    """A search that is soon done."""
    changes = QUICK | {f"search.{k}": v for k, v in SMALL.items()}
    return cageless.Case.from_file(CASE, changes).search()


def test_a_search_that_was_ended_is_finished_by_the_command(
    command: Command, found: cageless.SearchResult, tmp_path: Path
) -> None:
    def give_up(what: str, share: float) -> None:
        if "confirmation" in what:
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        small().search(**SMALL, out=tmp_path, threads=1, progress=give_up)
    journal = tmp_path / "search.journal"
    assert len(journal.read_text().splitlines()) > 20
    with pytest.raises(cageless.InputError, match="search.journal: was left by another request: search.runs_max was"):
        small().search(**SMALL | {"runs_max": 33}, out=tmp_path)
    asked = QUICK | {f"search.{k}": v for k, v in SMALL.items()}
    command("design", CASE, "--search", *sets(asked), "--out", tmp_path)
    assert not journal.exists()
    written = numbers((tmp_path / "design.json").read_text())
    assert found.values == written["search"]
    page = found.report(tmp_path / "python.html").read_text()
    assert page == (tmp_path / "report.html").read_text()
    for name in ["verdicts", "critical_gaps", "trade_offs"]:
        assert made(found._core.figure(name, None, None, None)) in figures(tmp_path / "report.html"), name


def test_a_raceway_that_is_not_judged_to_help_is_not_recommended() -> None:
    """Steady operation far too short: the design says so, the search recommends nothing."""
    short = {"steady.transient_orbits": 1, "steady.measured_orbits": 3}
    case = small().replace(short)
    design = case.design(benefit=True)
    assert design.benefit.benefit == "not-judged"
    assert design.benefit.answer.startswith("raceway: not judged against plain, 14 balls: ")
    runs = design.benefit.comparison.values["runs"]
    assert runs == ["plain, 14 balls", "plain, 13 balls", "raceway"]
    with pytest.raises(cageless.UnphysicalError, match="not judged against plain") as ended:
        case.search(**SMALL, benefit=True)
    found = ended.value.result
    assert isinstance(found, cageless.SearchResult)
    assert found.recommended == () and found.values["recommended"] is not None
    with pytest.raises(cageless.UnphysicalError, match="not judged against plain"):
        _ = found.case


def test_a_search_keeps_the_shape_and_the_blend() -> None:
    case = small().replace({"raceway.blend_mm": 1.0})
    found = case.search(**SMALL | {"axial_span_mm": 5.0, "half_angle_deg": [22.0, 24.0]}, shapes="all")
    [raceway] = found.recommended
    assert raceway.shape == found.values["recommended"]["shape"] != "quartic"
    assert found.case.raceways[0].blend_mm == 1.0
    assert set(found.data_structures()["shape"]) == {"quartic", "ellipse", "shuttle", "steady"}


def test_a_ring_is_measured(tmp_path: Path) -> None:
    case = cageless.Case.from_file(CASE).replace(
        {"bearing.outer_ring_outer_radius_mm": 31.0, "bearing.outer_ring_width_mm": 16.0}
    )
    points = tmp_path / "points.csv"
    case.export(points, ["csv"], blend_mm=0.0, spacing_mm=0.4)
    measured = case.measure(points)
    [raceway] = measured.raceways.to_dict("records")
    assert raceway["measured_deviation_max_um"] < 1e-3
    assert (measured.passes, measured.outlier_lines) == (True, [])
    span = measured.dimensions.iloc[0]
    assert (span["drawn"], span["verdict"], span["raceway"]) == (5.1, "within", 1)
    assert measured.frame["measured"].abs().max() < 1e-3
    assert measured.raceways.attrs["units"]["measured_deviation_um"] == "um"
    assert raceway["profile_flank_angle_deg"] == pytest.approx(math.degrees(math.asin(5.1 / 2 / 4.7625)), abs=1e-4)
    lags = [each.design().kinematic_lag_per_pass_deg for each in (case, measured.case)]
    assert lags[0] == pytest.approx(lags[1], abs=1e-3)
    with pytest.raises(cageless.InputError, match=r"has no \[raceway\]"):
        case.with_raceways().measure(points)


def test_a_search_shows_what_it_found(found: cageless.SearchResult) -> None:
    [raceway] = found.recommended
    assert found.case.raceways[0].half_angle_deg == raceway.half_angle_deg
    assert found.case.replace({"solver.duration_s": 0.001}).run().stopped is None
    structures, front = found.data_structures(), found.data_front()
    assert len(structures) == len(found.values["band"]) > len(front) > 0
    rejected = structures[structures.status == "rejected"]
    assert rejected.reason.notna().all()
    assert structures.on_front.sum() == len(front)
    confirmed = found.data_confirmation().set_index("role")
    assert confirmed.half_angle_deg["recommended"] == raceway.half_angle_deg
    assert confirmed.friction_w_error["own"] > 0.0
    [verdict] = found.recommended_verdicts
    assert found.passes is verdict.passes is (verdict.verdict == "smooth")
    assert found.data_placements().structures[0] == len(structures)
    [chart] = found.maps
    assert chart.critical_gap_deg.shape == (len(chart.half_angle_deg), len(chart.axial_span_mm))
    cells = found.data_map()
    assert set(found.data_rejections().reason) == (
        set(cells.verdict) - {"smooth"} | set(rejected.reason)
    )
    row, column = 2, len(chart.axial_span_mm) - 1
    cell = cells.iloc[row * len(chart.axial_span_mm) + column]
    assert cell.half_angle_deg == chart.half_angle_deg[row]
    np.testing.assert_equal(cell.critical_gap_deg, chart.critical_gap_deg[row, column])
    for figure in [
        found.plot_verdicts(),
        found.plot_critical_gaps(),
        found.plot_trade_offs(),
    ]:
        assert len(figure.data) > 0
    assert found.findings[0] in found._repr_html_().replace("&#x27;", "'")
    assert found.findings[0][:60] in repr(found)


def test_axial_loads_of_a_design_are_those_of_the_command(command: Command, tmp_path: Path) -> None:
    case = small()
    command("design", CASE, *sets(QUICK), "--axial", "--out", tmp_path)
    written = numbers((tmp_path / "design.json").read_text())
    design = case.design(axial=True, threads=2)
    assert design.values["axial"] == written["axial"]
    frame = design.data_axial()
    plain = frame[(frame.axial_load_n == 0.0) & (frame.tilt_x_mrad == 0.0)]
    # The lag per pass of structure (d) in space, with three strips.
    assert len(plain) == 1
    assert plain.lag_per_pass_deg.iloc[0] == pytest.approx(1.86, abs=0.02)
    borne = [design.values["axial"][f"axial_load_{share}_n"] for share in ("three_quarters", "half", "none")]
    assert 200.0 < borne[0] < borne[1] < borne[2]
    # A point of the map is a run, over other orbits.
    point = frame[(frame.axial_load_n == 300.0) & (frame.tilt_x_mrad == 1.0)]
    run = case.replace({"operation.axial_load_n": 300.0, "operation.tilt_x_mrad": 1.0, "solver.duration_s": 0.2}).run()
    assert point.lag_per_pass_deg.iloc[0] == pytest.approx(run.lag_per_pass_deg, abs=0.02)
    assert len(design.plot_axial_load().data) >= 5
    with pytest.raises(cageless.InputError, match="axial=True"):
        case.design().data_axial()


def test_nothing_to_recommend_is_an_exception_with_the_maps(command: Command) -> None:
    asked: dict[str, Any] = {"axial_span_mm": 1.0, "half_angle_deg": [10.0, 14.0], "runs_max": 32}
    case = small()
    with pytest.raises(cageless.UnphysicalError, match="too shallow") as error:
        case.search(**asked)
    changes = QUICK | {f"search.{k}": v for k, v in asked.items()}
    # Lines of progress come before it.
    stderr = command("design", CASE, "--search", *sets(changes), code=3).stderr
    assert stderr.splitlines()[-1] == f"error: {error.value}"
    search = error.value.result
    assert isinstance(search, cageless.SearchResult)
    assert search.recommended == ()
    with pytest.raises(cageless.UnphysicalError, match="no raceway meets"):
        _ = search.case
    assert set(search.maps[0].verdict.flat) == {"insufficient-separation"}
    assert not search.maps[0].passes.any()
    assert search.passes is None


def test_tolerances_are_those_of_the_command(command: Command, tmp_path: Path) -> None:
    none = ["axial_span_um", "half_angle_deg", "friction", "clearance_um", "speed_percent"]
    given: dict[str, Any] = dict.fromkeys(none, 0.0) | {"samples": 3, "load_percent": 50.0}
    flags = [word for k, v in given.items() for word in (f"--{k.replace('_', '-')}", v)]
    command("tolerance", CASE, *sets(QUICK), *flags, "--out", tmp_path)
    told: list[tuple[str, float]] = []
    result = small().tolerance(**given, threads=1, progress=lambda *at: told.append(at))
    assert result.values == numbers((tmp_path / "tolerance.json").read_text())
    page = result.report(tmp_path / "python.html").read_text()
    assert page == (tmp_path / "report.html").read_text()
    for name in ["influences", "samples"]:
        assert made(result._core.figure(name, None, None, None)) in figures(tmp_path / "report.html"), name
    assert told
    assert all(what == "tolerance" and 0.0 <= share <= 1.0 for what, share in told)
    assert result.nominal_verdict == "smooth"
    influences = result.data_influences().set_index("name")
    assert list(influences.index) == ["groove depth", "ball radii", "load"]
    assert result.nominal_passes
    assert result.decides == list(influences.index[influences.passed < influences.trials])
    gap = result.nominal_critical_gap_deg
    assert influences.critical_gap_deg_min["load"] <= gap <= influences.critical_gap_deg_max["load"]
    verdicts = result.data_verdicts().set_index("verdict")["count"]
    assert verdicts.sum() == 3
    assert result.samples.pass_probability == verdicts["smooth"] / 3
    # Three bearings are too few to pass.
    assert result.passes is None if verdicts["smooth"] == 3 else not result.passes
    assert result.headline.startswith("does not work" if result.passes is False else "not judged")
    assert result.headline[:60] in repr(result)
    [smooth] = [each for each in result.samples.verdicts if each.verdict == "smooth"]
    assert len(smooth.critical_gap_deg) == verdicts["smooth"]
    assert len(result.plot_influences().data) > 0
    assert len(result.plot_samples().data) > 0
    assert "probability" in result._repr_html_()


def test_a_tolerance_says_whether_its_raceways_help() -> None:
    case = small().replace({"steady.transient_orbits": 1, "steady.measured_orbits": 3})
    still = ["friction", "clearance_um", "speed_percent", "load_percent"]
    none: dict[str, Any] = dict.fromkeys(still, 0.0)
    found = case.tolerance(**none, samples=0, ball_grade=0, benefit=True)
    assert found.benefit.benefit == "not-judged"
    assert found.benefit.answer.startswith("Raceway as drawn not judged, weakest not judged")
    assert found.benefit.comparison.values["runs"] == ["plain", "as drawn", "weakest", "strongest", "plain, 13 balls"]


def test_the_tolerances_that_are_documented_are_those_of_the_command(command: Command) -> None:
    option = r"--([\w-]+) <[^>]+>(?:(?!\n +--).)*?\[default: (.*?)\]"
    told = re.findall(option, command("tolerance", "--help").stdout, re.S)
    documented = re.findall(r"(\w+): .*? (\S+) if left out", cageless.Case.tolerance.__doc__ or "")
    assert len(documented) == 12
    assert documented == [(name.replace("-", "_"), value) for name, value in told]


def test_exports_have_the_bytes_of_the_command(
    command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # STEP holds the time at which it was written.
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1700000000")
    case = cageless.Case.from_file(CASE, RING)
    several = case.export(tmp_path / "python", ["step", "csv"], spacing_mm=1.0)
    assert several.formats == ["step", "csv"]
    assert sorted(p.name for p in (tmp_path / "python").iterdir()) == [
        "export.json",
        "outer_ring.csv",
        "outer_ring.step",
    ]
    for name, options in {"step": [], "csv": ["--spacing-mm", 1]}.items():
        out = tmp_path / f"ring.{name}"
        args = ["--format", name, *options, "--out", out, "--json"]
        printed = numbers(command("export", CASE, *sets(RING), *args).stdout)
        file = tmp_path / "python" / f"outer_ring.{name}"
        assert file in several.files
        assert file.read_bytes() == out.read_bytes()
        [one] = [each for each in several.values if each["format"] == name]
        assert one | {"file": None} == printed | {"file": None}
        assert several.deviation_um[name] == printed["deviation_um"]
    written = numbers((tmp_path / "python" / "export.json").read_text())
    assert written == several.values
    one_file = case.export(tmp_path / "ring.stl", chord_um=20.0, blend_mm=0.0)
    assert one_file.files == [tmp_path / "ring.stl"]
    assert one_file.blend_mm == 0.0 < several.blend_mm
    assert one_file.deviation_um["stl"] > several.deviation_um["step"]
    assert several.data_files().bytes["step"] == (tmp_path / "ring.step").stat().st_size
    assert "ring.stl" in one_file._repr_html_()


Refused = tuple[Callable[[cageless.Case], object], list[str]]
REFUSED: list[Refused] = [
    (lambda c: c.export("x", "step", blend_mm=7.0), ["export", "step", "--blend-mm", "7"]),
    (lambda c: c.export("x", "csv", spacing_mm=0.0), ["export", "csv", "--spacing-mm", "0"]),
    (lambda c: c.export("x", "stl", chord_um=500.0), ["export", "stl", "--chord-um", "500"]),
    (lambda c: c.tolerance(friction=0.5), ["tolerance", "", "--friction", "0.5"]),
    (lambda c: c.tolerance(ball_grade=7), ["tolerance", "", "--ball-grade", "7"]),
    (lambda c: c.tolerance(samples=10**6), ["tolerance", "", "--samples", "1000000"]),
]


@pytest.mark.parametrize(("call", "flags"), REFUSED, ids=[r[1][2] for r in REFUSED])
def test_options_are_refused_in_the_words_of_the_command(
    command: Command, tmp_path: Path, call: Callable[[cageless.Case], object], flags: list[str]
) -> None:
    case = cageless.Case.from_file(CASE, RING)
    with pytest.raises(cageless.InputError) as error:
        call(case)
    key = error.value.key
    assert key == flags[2].removeprefix("--").replace("-", "_")
    kind = ["--format", flags[1]] if flags[1] else []
    out = ["--out", tmp_path / "x"]
    failed = command(flags[0], CASE, *sets(RING), *kind, *flags[2:], *out, code=2)
    said = str(error.value).partition(" is not possible: ")[2]
    assert said
    assert failed.stderr.endswith(f"is not possible: {said}\n")
    assert not (tmp_path / "x").exists()


def test_what_no_command_could_ask_is_refused_too(tmp_path: Path) -> None:
    case = cageless.Case.from_file(CASE, RING)
    calls: list[Callable[[], object]] = [
        lambda: case.tolerance(samples=-1),
        lambda: case.tolerance(threads=0),
        lambda: case.tolerance(threads=100_000),
        lambda: case.export(tmp_path / "x", "dxf"),
        lambda: case.export(tmp_path / "x", []),
        lambda: case.export(tmp_path / "x.stl", "step"),
        lambda: case.export(tmp_path / "x", "step", chord_um=5.0),
    ]
    for call in calls:
        with pytest.raises(cageless.InputError):
            call()
    assert list(tmp_path.iterdir()) == []
    plain = cageless.Case.from_file(CASE)
    with pytest.raises(cageless.InputError, match="outer_ring_outer_radius_mm is missing") as error:
        plain.export(tmp_path / "x")
    assert error.value.key == "bearing.outer_ring_outer_radius_mm"
    with pytest.raises(cageless.InputError, match="no \\[raceway\\]"):
        plain.with_raceways().tolerance()
    (tmp_path / "file").write_text("")
    with pytest.raises(cageless.InputError, match="file"):
        case.export(tmp_path / "file" / "x", "step")


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"samples": 2.5}, "samples = 2.5 is not possible: it must be a whole number"),
        ({"samples": True}, "samples = True is not possible"),
        ({"ball_grade": 2**33}, "ball_grade = 8589934592 is not possible"),
        ({"friction": math.nan}, "friction = nan is not possible: it must be a finite number"),
        ({"friction": math.inf}, "friction = inf is not possible"),
        ({"friction": "0.002"}, "friction = '0.002' is not possible"),
        ({"friction": [0.002]}, r"friction = \[0.002\] is not possible"),
    ],
)
def test_tolerances_that_are_no_numbers_are_refused(given: dict[str, Any], said: str) -> None:
    with pytest.raises(cageless.InputError, match=said) as error:
        small().tolerance(**given)
    assert error.value.key == next(iter(given))


def test_tolerances_may_be_numbers_of_numpy() -> None:
    asked: list[dict[str, Any]] = [
        {"samples": np.int64(0), "ball_grade": np.int32(10), "friction": np.float64(0.5)},
        {"samples": 0.0, "ball_grade": 10.0, "friction": np.float32(0.5)},
    ]
    for given in asked:
        # Everything is read; the friction of the case is below.
        with pytest.raises(cageless.InputError, match="friction = 0.5 is not possible: .* from 0 to"):
            small().tolerance(**given)


def test_threads_are_checked_where_one_is_enough() -> None:
    case = small()
    wrong: list[Any] = [0, -1, "2", True, 2.5, 100_000]
    for threads in wrong:
        for compute in (case.run, case.design):
            said = f"threads = {threads!r} is not possible: it must be a whole number from 1 to 1024"
            with pytest.raises(cageless.InputError, match=said):
                compute(threads=threads)


def test_raceways_are_replaced() -> None:
    case = small()
    one = cageless.Raceway(axial_span_mm=5.3, half_angle_deg=24.0)
    other = cageless.Raceway(axial_span_mm=5.3, half_angle_deg=24.0, centre_angle_deg=180.0)
    assert case.with_raceways().raceways == ()
    both = case.with_raceways(one, other)
    assert [r.centre_angle_deg for r in both.raceways] == [0.0, 180.0]
    assert both.with_raceways(*case.raceways) == case
    assert case.with_raceways(one.values(), {"axial_span_mm": 5.3, "half_angle_deg": 24.0, "centre_angle_deg": 180.0}) == both


def test_a_structure_passes_if_it_does_at_every_operating_point() -> None:
    def passes(*verdicts: bool) -> bool | None:
        values = {"recommended_verdicts": [{"passes": each} for each in verdicts]}
        core = cageless._cageless.Result("search", json.dumps(values), [], {})
        return cageless.SearchResult(core).passes

    assert passes(True, True) is True
    assert passes(True, False) is False
    assert passes(False, True) is False
    assert passes() is None


def test_the_volume_of_an_export_is_that_of_the_solid(tmp_path: Path) -> None:
    ring = {"bearing.outer_ring_outer_radius_mm": 31.0, "bearing.outer_ring_width_mm": 16.0}
    case = cageless.Case.from_toml(cageless.template(True), ring)
    made = case.export(tmp_path, ["stl"], chord_um=50.0)
    bearing: Any = case.bearing
    radius, shoulder = bearing.outer_groove_curvature_radius_mm, bearing.outer_shoulder_radius_mm
    centre = bearing.outer_groove_bottom_radius_mm - radius
    # Outside less bore at the shoulders less the groove, whose section is a segment of a circle turned about
    # the axis.
    half = math.sqrt(radius**2 - (shoulder - centre) ** 2)
    steps = 20000
    z = [half * (2.0 * (k + 0.5) / steps - 1.0) for k in range(steps)]
    groove = sum((centre + math.sqrt(radius**2 - at**2)) ** 2 - shoulder**2 for at in z) * 2.0 * half / steps
    expected = math.pi * (16.0 * (31.0**2 - shoulder**2) - groove)
    assert made.volume_mm3 == pytest.approx(expected, rel=1e-6)
    assert abs(made.values[0]["mesh_volume_mm3"] / expected - 1.0) > 1e-5

"""Cases: from keywords, from files, and their errors."""

from __future__ import annotations

import copy
import dataclasses
import pickle
from pathlib import Path
from typing import Any

import cageless
import numpy as np
import pytest
from cageless import sections
from conftest import ROOT, Command, figures, made, numbers

#: Where the case of the template is that of the paper and no default.
OF_THE_PAPER = {"model.flanks": "rigid", "contact.regularisation_speed_m_s": 0.02}


def test_keywords_make_the_case_that_the_file_makes() -> None:
    read = cageless.Case.from_toml(cageless.template())
    made = cageless.Case(
        title=read.title,
        bearing=read.bearing,
        material=read.material,
        raceway=read.raceways,
        operation=read.operation,
        contact=read.contact,
        model=read.model,
        start=read.start,
        solver=read.solver,
        housing=read.housing,
        fit=read.fit,
        lubrication=read.lubrication,
        output=read.output,
    )
    assert made == read
    assert made.to_toml() == read.to_toml()


def test_every_key_of_the_format_is_a_field_and_the_other_way_round() -> None:
    text = cageless.template()
    for kind in sections.Section.__subclasses__():
        name = kind.__name__.lower()
        known = {field.name for field in dataclasses.fields(kind)}
        with pytest.raises(cageless.InputError) as error:
            cageless.Case.from_toml(text, {f"{name}.qqqqqqqqqqqqqqqqqqqq": 1.0})
        listed = str(error.value).partition("its keys are ")[2].split(", ")
        assert set(listed) == known


def test_only_bearing_and_operation_are_required() -> None:
    full = cageless.Case.from_toml(cageless.template())
    made = cageless.Case(
        title=full.title, bearing=full.bearing, operation=full.operation, raceway=full.raceways
    )
    assert made.replace(OF_THE_PAPER) == full
    with pytest.raises(TypeError, match="operation"):
        cageless.Case(bearing=full.bearing)  # type: ignore[call-arg]


def test_a_designation_makes_the_case_of_the_command(command: Command, tmp_path: Path) -> None:
    path = tmp_path / "6008.toml"
    command("new", "--bearing", "6008", "--full-complement", "--out", path)
    case = cageless.Case.from_designation("6008", full_complement=True)
    assert case == cageless.Case.from_file(path)
    assert case != cageless.Case.from_designation("6008")
    with pytest.raises(cageless.InputError, match="6O08.* did you mean 6008"):
        cageless.Case.from_designation("6O08")


def test_sections_may_be_mappings_of_their_keys() -> None:
    case = cageless.Case.from_toml(cageless.template())
    [raceway] = case.raceways
    made = cageless.Case(
        bearing=case.bearing.values(),
        operation=case.operation.values(),
        raceway=raceway.values(),
        solver={"duration_s": 0.01},
        title=case.title,
    )
    expected = cageless.Case(
        bearing=case.bearing,
        operation=case.operation,
        raceway=raceway,
        solver=cageless.Solver(duration_s=0.01),
        title=case.title,
    )
    assert made == expected
    with pytest.raises(cageless.InputError, match="colour"):
        cageless.Case(bearing={"balls": 12, "colour": 1}, operation={})
    wrong: list[dict[str, Any]] = [{"solver": 5}, {"solver": "verlet"}, {"solvers": {}}]
    for keywords in wrong:
        with pytest.raises((TypeError, ValueError)):
            cageless.Case(bearing=case.bearing, operation=case.operation, **keywords)


def test_keys_have_their_meanings_in_the_help_of_their_section() -> None:
    assert "\n    balls: N, number of balls.\n" in (cageless.Bearing.__doc__ or "")
    assert "θ, half the angle" in (cageless.Raceway.__doc__ or "")


def test_the_radial_clearance_is_in_micrometres() -> None:
    """Ro - Ri - 2 Rw = 27.7715 - 18.24 - 9.525 mm."""
    case = cageless.Case.from_toml(
        cageless.template(), {"bearing.outer_groove_bottom_radius_mm": 27.7715}
    )
    assert case.radial_internal_clearance_um == pytest.approx(13.0, rel=1e-6)


def test_a_key_of_the_case_is_no_argument_of_run() -> None:
    case: Any = cageless.Case.from_toml(cageless.template())
    with pytest.raises(TypeError, match=r"Case\.run.*replace\(solver__duration_s=0\.01\)"):
        case.run(duration_s=0.01)


def test_every_value_of_a_static_equilibrium_is_an_attribute() -> None:
    static = cageless.Case.from_toml(cageless.template()).static()
    for name, value in static.values.items():
        found = getattr(static, name)
        # A result that the case does not have is no number.
        same = np.isnan(found) if value is None else np.array_equal(found, value)
        assert same, name
    # Larger outer ellipses: the groove wraps around the ball.
    k = int(static.inner_force_n.argmax())
    assert static.outer_semi_axis_along_mm[k] > static.inner_semi_axis_along_mm[k]


def test_materials_of_balls_and_rings_apart() -> None:
    case = cageless.Case.from_toml(cageless.template())
    assert case.ball_material is None and case.ring_material is None
    hybrid = cageless.Case(
        bearing=case.bearing,
        operation=case.operation,
        raceway=case.raceways,
        title=case.title,
        ball_material=cageless.Material(preset="Si3N4"),
        ring_material=cageless.Material(preset="M50"),
    )
    assert hybrid.replace(OF_THE_PAPER) == case.replace(
        ball_material__preset="Si3N4", ring_material={"preset": "M50"}
    )
    assert hybrid.ball_material is not None and hybrid.ball_material.preset == "Si3N4"
    assert hybrid.ring_material is not None and hybrid.ring_material.preset == "M50"
    assert hybrid.static().outer_pressure_max_mpa > case.static().outer_pressure_max_mpa
    assert pickle.loads(pickle.dumps(hybrid)) == hybrid


def test_replace_takes_dots_dictionaries_sections_and_keywords() -> None:
    case = cageless.Case.from_toml(cageless.template())
    dots = case.replace({"raceway.half_angle_deg": 24.0, "solver.duration_s": 0.01})
    assert dots.raceways[0].half_angle_deg == 24.0 != case.raceways[0].half_angle_deg
    assert dots == case.replace(raceway__half_angle_deg=24.0, solver__duration_s=0.01)
    assert dots == case.replace(
        {"raceway": {"half_angle_deg": 24.0}}, solver=cageless.Solver(duration_s=0.01)
    )
    both = case.with_raceways(case.raceways[0], case.raceways[0].__class__(
        axial_span_mm=5.0, half_angle_deg=20.0, centre_angle_deg=180.0
    ))
    assert both.replace(raceway__2__half_angle_deg=21.0).raceways[1].half_angle_deg == 21.0
    assert case.replace() == case
    with pytest.raises(cageless.InputError, match="raceway.half_angle_deg is given twice"):
        case.replace({"raceway.half_angle_deg": 1.0}, raceway={"half_angle_deg": 2.0})
    with pytest.raises(cageless.InputError, match="did you mean half_angle_deg"):
        case.replace(raceway__half_angel_deg=24.0)


def test_several_raceways_and_lists_per_ball() -> None:
    case = cageless.Case.from_toml(cageless.template())
    [one] = case.raceways
    both = dataclasses.replace(one, centre_angle_deg=180.0)
    made = cageless.Case(
        bearing=dataclasses.replace(case.bearing, ball_radius_deviation_um=[0.5] * 14),
        material=case.material,
        raceway=[one, both],
        operation=case.operation,
        contact=case.contact,
        model=case.model,
        solver=case.solver,
        output=case.output,
    )
    assert [r.centre_angle_deg for r in made.raceways] == [0.0, 180.0]
    assert made.replace({"raceway.2.half_angle_deg": 24.0}).raceways[1].half_angle_deg == 24.0
    assert made.bearing.ball_radius_deviation_um == [0.5] * 14


def test_a_case_survives_pickle_and_copy() -> None:
    for path in sorted((ROOT / "cases").glob("*.toml")):
        case = cageless.Case.from_file(path)
        assert pickle.loads(pickle.dumps(case)) == case
        assert copy.deepcopy(case) == case
        assert hash(copy.copy(case)) == hash(case)


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("raceway.half_angle_deg", 500.0),
        ("raceway.axial_spam_mm", 5.0),
        ("bearing.balls", 2),
        ("solver.method", "euler"),
        ("contact.friction_coefficient", -0.1),
        ("operation.inner_speed_rpm", float("nan")),
    ],
)
def test_messages_are_those_of_the_command(
    command: Command, tmp_path: Path, key: str, value: object
) -> None:
    path = tmp_path / "case.toml"
    path.write_text(cageless.template())
    with pytest.raises(cageless.InputError) as error:
        cageless.Case.from_file(path, {key: value})
    failed = command("check", path, "--set", f"{key}={value}", code=2)
    assert failed.stderr == f"error: {error.value}\n".replace(f'"{value}"', str(value), 1) or (
        failed.stderr == f"error: {error.value}\n"
    )
    assert error.value.key == key
    assert isinstance(error.value, ValueError)


def test_a_file_at_fault_is_named_with_its_line(command: Command, tmp_path: Path) -> None:
    path = tmp_path / "case.toml"
    path.write_text(cageless.template().replace("balls = 14", "balls = 2"))
    with pytest.raises(cageless.InputError) as error:
        cageless.Case.from_file(path)
    assert command("check", path, code=2).stderr == f"error: {error.value}\n"
    assert error.value.line == path.read_text().splitlines().index(
        next(line for line in path.read_text().splitlines() if line.startswith("balls"))
    ) + 1
    assert pickle.loads(pickle.dumps(error.value)).line == error.value.line


def test_values_that_no_file_can_hold_are_refused() -> None:
    case = cageless.Case.from_toml(cageless.template())
    with pytest.raises(cageless.InputError, match="title"):
        case.replace({"title": object()})
    with pytest.raises(cageless.InputError, match="seed"):
        case.replace({"solver.seed": 2**70})


def test_a_number_that_is_too_large_is_called_so() -> None:
    case = cageless.Case.from_toml(cageless.template())
    with pytest.raises(cageless.InputError, match=r"solver.seed = 9223372036854775808 .* 2\^63"):
        case.replace({"solver.seed": 2**63})


def test_a_case_is_made_anew_by_the_values_of_another() -> None:
    for name in ("zhao-d", "touchdown-d"):
        case = cageless.Case.from_file(ROOT / "cases" / f"{name}.toml")
        assert cageless.Case(**case.to_dict()).to_dict() == case.to_dict()
    searched = case.replace(search={"runs_max": 50}, seed=3)
    assert cageless.Case(**searched.to_dict()).to_dict() == searched.to_dict()


def test_a_case_is_changed_by_replace_alone() -> None:
    case = cageless.Case.from_toml(cageless.template())
    before = case.to_toml()
    for name in ("operation", "raceway", "raceways", "title", "colour"):
        with pytest.raises(AttributeError, match=rf"Case\.{name} cannot be set: replace\(\)"):
            setattr(case, name, case.operation)
    assert case.to_toml() == before
    plan = cageless.Plan(case=case, compute="static", grid={"operation.radial_load_n": [1.0]})
    with pytest.raises(AttributeError, match="Plan.seed cannot be set"):
        plan.seed = 3


def test_limits_on_results_are_sections_of_the_case() -> None:
    case = cageless.Case.from_file(ROOT / "cases" / "touchdown-d.toml")
    assert case.limits == ()
    limits = [
        cageless.Limit(result="rotor_force_max_n", value=2e4, source="maker"),
        cageless.Limit(result="impacts", value=9.0, source="specification"),
    ]
    one, both = (cageless.Case(**case.to_dict(), limit=limits[:n]) for n in (1, 2))
    assert (one.limits, both.limits) == (tuple(limits[:1]), tuple(limits))


def test_defaults_and_the_case_as_run_are_those_of_check(command: Command, tmp_path: Path) -> None:
    path = tmp_path / "case.toml"
    path.write_text(cageless.template())
    checked = numbers(command("check", path, "--json").stdout)
    case = cageless.Case.from_file(path)
    assert case.defaults == checked["defaults"]
    assert case.to_dict() == checked["case"]


def test_static_and_design_are_those_of_the_command(command: Command, tmp_path: Path) -> None:
    path = ROOT / "cases" / "zhao-d.toml"
    case = cageless.Case.from_file(path)
    assert case.static().values == numbers(command("static", path, "--json").stdout)
    design = case.design()
    printed = command("design", path, "--json", "--out", tmp_path).stdout
    assert design.values == numbers(printed)
    page = design.report(tmp_path / "python.html").read_text()
    assert page == (tmp_path / "report.html").read_text()
    for figure in [design.plot_curve(), design.plot_contact_track(), design.plot_surface()]:
        assert len(figure.data) > 0
    for name in ["curve", "contact_track", "surface"]:
        assert made(design._core.figure(name, None, None, None)) in figures(tmp_path / "report.html"), name
    assert case.static().data_balls().shape[0] == case.bearing.balls
    assert case.static().warnings == design.warnings == []
    overloaded = case.replace({"operation.radial_load_n": 3e4}).static()
    assert "4200 MPa" in overloaded.warnings[0]
    assert "Static" in case.static()._repr_html_()
    static = case.static()
    assert static.stiffness_yy_n_m > static.stiffness_xx_n_m > 0.0
    assert static.inner_semi_axis_along_mm.shape == (case.bearing.balls,)
    assert static.outer_pressure_mpa.max() == static.outer_pressure_max_mpa
    assert static.l10_mrev == (static.basic_dynamic_rating_n / 1500.0) ** 3
    assert static.bpfo_hz + static.bpfi_hz == pytest.approx(case.bearing.balls * 200.0)
    no_load = {"operation.radial_load_n": 0.0, "operation.gravity_m_s2": 0.0}
    unloaded = case.replace(no_load).static()
    assert np.isnan(unloaded.stiffness_xx_n_m)
    assert np.isnan(unloaded.l10_mrev)
    assert "verdict" in design._repr_html_()
    assert "raceway.half_angle_deg" in case._repr_html_()
    assert "ball_radius_mm" in case.bearing._repr_html_()


def test_what_is_left_out_takes_the_default_of_the_case_file() -> None:
    full = cageless.Case.from_toml(cageless.template())
    made = cageless.Case(
        title=full.title,
        bearing=full.bearing,
        raceway=full.raceways,
        operation=cageless.Operation(inner_speed_rpm=12000.0, radial_load_n=1500.0),
    )
    assert made.replace(OF_THE_PAPER) == full
    given = cageless.Contact(friction_coefficient=0.03, friction_law="coulomb")
    made = cageless.Case(bearing=full.bearing, operation=full.operation, contact=given)
    assert made.contact.regularisation_speed_m_s != full.contact.regularisation_speed_m_s
    assert made.contact.friction_coefficient == 0.03


def test_sections_are_merged_into_those_of_the_case() -> None:
    case = cageless.Case.from_toml(cageless.template())
    flat = case.replace({"raceway.half_angle_deg": 24.0, "contact.damping_n_s_m1_5": 1e5})
    nested = case.replace({"raceway": {"half_angle_deg": 24.0}, "contact": {"damping_n_s_m1_5": 1e5}})
    assert nested == flat
    assert nested.raceways[0].axial_span_mm == 5.1
    assert case.replace({"contact": cageless.Contact(damping_n_s_m1_5=1e5)}).contact == flat.contact
    two = case.with_raceways(case.raceways[0], cageless.Raceway(
        axial_span_mm=5.1, half_angle_deg=25.2, centre_angle_deg=180.0
    ))
    two = two.replace({"raceway": {"2": {"half_angle_deg": 20.0}}})
    assert [r.half_angle_deg for r in two.raceways] == [25.2, 20.0]
    read = cageless.Case.from_toml(cageless.template(), {"raceway": {"half_angle_deg": 24.0}})
    assert read.raceways[0].half_angle_deg == 24.0

"""Drops: against the command, scattered, verified, refused, in sweeps."""

from __future__ import annotations

from pathlib import Path

import cageless
import numpy as np
import pandas as pd
import pytest
from cageless.frames import successive
from conftest import ROOT, Command, falling, summary_of


@pytest.fixture(scope="module")
def both(
    command: Command, tmp_path_factory: pytest.TempPathFactory
) -> tuple[cageless.Drop, Path]:
    """One study from Python, and the folder of the command's."""
    folder = tmp_path_factory.mktemp("drop")
    path = folder / "case.toml"
    path.write_text(falling().to_toml())
    out = folder / "out"
    command("drop", path, "--compare", "conventional", "--samples", 3, "--out", out)
    case = cageless.Case.from_file(path)
    return case.drop(compare=True, samples=3), out


def test_a_drop_is_that_of_the_command(both: tuple[cageless.Drop, Path], tmp_path: Path) -> None:
    drop, folder = both
    assert drop.values == summary_of(folder)
    saved = drop.save(tmp_path / "saved")
    for name in ["rotor", "ring", "balls", "collisions"]:
        written = pd.read_parquet(folder / "bearing-1" / f"{name}.parquet")
        pd.testing.assert_frame_equal(getattr(drop, f"data_{name}")(), written, check_exact=True)
        pd.testing.assert_frame_equal(pd.read_parquet(saved / "bearing-1" / f"{name}.parquet"), written)
    for name in ["summary.json", "report.html"]:
        assert (saved / name).read_text() == (folder / name).read_text()


def test_a_drop_has_its_results(both: tuple[cageless.Drop, Path]) -> None:
    drop, folder = both
    fall_ms = 1e3 * np.sqrt(2.0 * 200e-6 / 9.81)
    assert drop.first_contact_ms == pytest.approx(fall_ms, rel=1e-3)
    assert drop.end_state in {"bouncing", "pendulum"}
    assert drop.headline.startswith({True: "PASS", False: "FAIL", None: "not"}[drop.passes])
    assert bool(drop.reasons) != bool(drop.passes)
    assert drop.headline in drop._repr_html_().replace("&#x27;", "'")
    for name in ["orbit", "displacement", "forces", "spin_up", "loads", "heat", "end_states"]:
        figure = getattr(drop, f"plot_{name}")(title=name)
        assert figure.data and figure.layout.title.text == name
    # The drop ends before the rotor is in lasting contact.
    with pytest.raises(cageless.InputError, match='nothing to show as "whirl"'):
        drop.plot_whirl()
    assert drop.conventional.impacts == drop.conventional.bearings[0].impacts >= 1
    # The drop has what its only bearing has.
    [bearing] = drop.bearings
    assert (drop.impacts, drop.case) == (bearing.impacts, bearing.case)
    assert drop.plot_orbit() == bearing.plot_orbit()
    assert (drop.time_s == bearing.time_s).all()
    assert drop.data_summary().loc["impacts", "value"] == bearing.impacts
    assert {"impacts", "windows", "plot_orbit"} <= set(dir(drop))
    assert drop.ensemble.end_states == drop.ensemble.bearings[0].end_states
    with pytest.raises(AttributeError, match="has no 'impactz'; did you mean impacts"):
        drop.impactz  # noqa: B018
    assert drop.array("y_m", "rotor").shape == drop.time_s.shape
    assert drop.data_rotor().attrs["units"]["speed_rad_s"] == "rad/s"
    drops = drop.data_drops()
    assert len(drops) == 3
    assert drops.rotor_friction.nunique() == 3
    assert drop.ensemble.backward_whirl_probability == 0.0
    assert drop == falling().drop(compare=True, samples=3, threads=1)
    assert drop != falling().drop()
    with pytest.raises(cageless.ColumnError, match="did you mean speed_rad_s"):
        drop.array("sped_rad_s", "rotor")
    # Also reads what the command wrote.
    assert cageless.load(folder) == drop


def test_a_drop_in_space_shows_the_motion_along_the_axis(tmp_path: Path) -> None:
    case = cageless.Case.from_file(ROOT / "cases" / "touchdown-vertical.toml")
    drop = case.replace({"solver.duration_s": 0.008}).drop(threads=1)
    fall_ms = 1e3 * np.sqrt(2.0 * 200e-6 / 9.81)
    assert drop.first_contact_ms == pytest.approx(fall_ms, rel=2e-3)
    assert drop.shoulder_force_max_n > 20 * 9.81
    assert [trace.name for trace in drop.plot_along_axis().data] == ["rotor", "inner ring", "shoulder"]
    rotor = drop.data_rotor()
    assert rotor.attrs["units"]["shoulder_force_n"] == "N"
    assert rotor.z_m.min() < -200e-6 and rotor.shoulder_force_n.max() > 0.0
    assert cageless.load(drop.save(tmp_path / "saved")) == drop
    planar = falling().drop(threads=1)
    assert "z_m" not in planar.data_rotor()
    assert np.isnan(planar.shoulder_force_max_n)


def test_a_drop_is_verified() -> None:
    verified = falling(**{"solver.duration_s": 0.0068}).drop(verify=True)
    assert "converged" in repr(verified.verification)
    assert verified.verification.converged == verified.verification.bearings[0].converged
    assert verified.data_verification().verdict["first_contact_ms"] == "converged"
    assert falling().drop().data_verification().empty


def test_what_cannot_drop_is_refused() -> None:
    case = cageless.Case.from_toml(cageless.template())
    with pytest.raises(cageless.InputError, match=r"no \[rotor\] to drop: give mass_kg"):
        case.drop()
    with pytest.raises(cageless.InputError, match="samples"):
        falling().drop(samples=0)
    with pytest.raises(cageless.InputError, match=r"\[rotor\] must be left out"):
        falling().design()


def test_a_sweep_has_drops_as_columns() -> None:
    plan = cageless.Plan(
        case=falling(), compute=["drop"], grid={"rotor.friction_coefficient": [0.1, 0.3]}
    )
    variants = cageless.sweep(plan).data_variants()
    alone = falling(**{"rotor.friction_coefficient": 0.3}).drop()
    for name in ["rotor_force_max_n", "collisions", "dissipated_j", "ring_speed_rpm"]:
        assert variants[f"drop_{name}"][1] == alone.bearings[0].values[name]
    assert list(variants.drop_end_state)[1] == alone.end_state


def test_drops_in_succession_have_a_row_each() -> None:
    changes = {
        "solver.duration_s": 0.05,
        "rotor.drive_torque_n_m": -4.0,
        "rotor.speed_rpm": 3000.0,
        "bearing.inner_ring_polar_inertia_kg_m2": 5e-6,
    }
    drop = falling(**changes).drop(drops=3)
    rows = drop.data_succession()
    assert list(rows["drop"]) == [1, 2, 3]
    assert rows.attrs["units"]["ball_standstill_c"] == "C"
    assert rows.rotor_force_max_n[0] == drop.rotor_force_max_n
    assert rows.inner_ring_start_c[1] == pytest.approx(rows.inner_ring_standstill_c[0])
    assert rows.inner_ring_standstill_c.is_monotonic_increasing
    assert drop.plot_temperatures().data
    with pytest.raises(cageless.InputError, match="from 1 to"):
        falling().drop(drops=0)


def test_the_verdict_of_a_row_is_not_that_of_the_drop_in_it() -> None:
    row = {"drop": 1, "bearing": 1, "verdict": "fail", "result": {"verdict": "pass", "impacts": 3}}
    frame = successive({"succession": [row]})
    assert (frame.verdict[0], frame.impacts[0], frame["drop"][0]) == ("fail", 3, 1)

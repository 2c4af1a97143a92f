"""Rotors on several bearings: against the command, from matrices, refused."""

from __future__ import annotations

import json
import pickle
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import cageless
import numpy as np
import numpy.typing as npt
import pandas as pd
import pytest
from conftest import ROOT, Command, summary_of

CASES = [ROOT / "cases" / f"touchdown-{name}.toml" for name in ("d", "conventional")]
SHORT = {"solver.duration_s": 0.008}


def cases() -> list[cageless.Case]:
    return [cageless.Case.from_file(path, SHORT) for path in CASES]


def rigid() -> cageless.LinearRotor:
    return cageless.LinearRotor.rigid(
        mass_kg=40.0,
        polar_inertia_kg_m2=0.04,
        transverse_inertia_kg_m2=0.6,
        bearing_axial_mm=[-100.0, 200.0],
        unbalances=[(30.0, 200.0, 40.0)],
    )


def stated(values: dict[str, Any]) -> dict[str, Any]:
    """Values as if files stated every key: a case that was changed or written in one file does."""
    return values | {"bearings": [b | {"defaults": []} for b in values["bearings"]]}


def rotor_file(folder: Path) -> Path:
    """The file of :func:`rigid`."""
    path = folder / "rotor.toml"
    bearings = "".join(
        f"[[bearing]]\ncase = {json.dumps(str(case))}\naxial_mm = {z}\n"
        for case, z in zip(CASES, (-100.0, 200.0), strict=True)
    )
    path.write_text(
        "[rotor]\nmass_kg = 40.0\npolar_inertia_kg_m2 = 0.04\ntransverse_inertia_kg_m2 = 0.6\n"
        "speed_rpm = 30000.0\n[[unbalance]]\naxial_mm = 30.0\namount_g_mm = 200.0\nangle_deg = 40.0\n"
        + bearings
    )
    return path


def test_a_drop_is_that_of_the_command(command: Command, tmp_path: Path) -> None:
    out = tmp_path / "out"
    command("drop", rotor_file(tmp_path), "--set", "solver.duration_s=0.008", "--out", out)
    drop = rigid().drop(cases(), speed_rpm=30000.0)
    assert drop.values == summary_of(out)
    assert list(drop.rotor.mass_shares_kg) == pytest.approx([80.0 / 3.0, 40.0 / 3.0])
    assert all(bearing.impacts >= 1 for bearing in drop.bearings)
    saved = drop.save(tmp_path / "saved")
    for folder in (saved, out):
        loaded = cageless.load(folder)
        assert isinstance(loaded, cageless.Drop)
        assert loaded == drop and loaded.passes == drop.passes
        assert loaded.bearings[1] == drop.bearings[1] != drop.bearings[0]
        figure = loaded.bearings[1].plot_orbit()
        assert figure.data and figure == drop.bearings[1].plot_orbit()
        assert figure != loaded.bearings[0].plot_orbit()
    assert pickle.loads(pickle.dumps(drop)) == drop
    assert pickle.loads(pickle.dumps(drop.bearings[1])) == drop.bearings[1]
    for name in ["summary.json", "report.html"]:
        assert (saved / name).read_text() == (out / name).read_text()
    for k, bearing in enumerate(drop.bearings):
        for name in ["rotor", "ring", "balls", "collisions"]:
            table = f"bearing-{k + 1}/{name}.parquet"
            written = pd.read_parquet(out / table)
            pd.testing.assert_frame_equal(pd.read_parquet(saved / table), written)
            frame = getattr(bearing, f"data_{name}")()
            pd.testing.assert_frame_equal(frame, written, check_exact=True)


def test_a_drop_of_a_rotor_in_one_bearing_is_loaded_as_it_was_saved(tmp_path: Path) -> None:
    one = cageless.LinearRotor.rigid(
        mass_kg=20.0,
        polar_inertia_kg_m2=0.02,
        transverse_inertia_kg_m2=0.3,
        bearing_axial_mm=[0.0],
    )
    drop = one.drop(cases()[:1], speed_rpm=30000.0)
    loaded = cageless.load(drop.save(tmp_path / "saved"))
    assert loaded == drop and len(loaded.bearings) == 1
    pd.testing.assert_frame_equal(loaded.bearings[0].data_ring(), drop.bearings[0].data_ring())


def test_scattered_compared_and_verified_drops_are_those_of_the_command(
    command: Command, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    more = ["--samples", 2, "--compare", "conventional", "--verify", "--out", out]
    command("drop", rotor_file(tmp_path), "--set", "solver.duration_s=0.0006", *more)
    short = [cageless.Case.from_file(path, {"solver.duration_s": 0.0006}) for path in CASES]
    drop = rigid().drop(short, speed_rpm=30000.0, compare=True, samples=2, verify=True)
    assert drop.values == summary_of(out)
    saved = drop.report(tmp_path / "page.html")
    assert saved.read_text() == (out / "report.html").read_text()
    assert (drop.ensemble.backward_whirl_probability, drop.warnings) == (0.0, [])
    assert tuple(drop.ensemble.backward_whirl_interval) == pytest.approx((0.0, 0.658), abs=1e-3)
    drops = drop.data_drops()
    assert list(zip(drops["drop"], drops.bearing, strict=True)) == [(1, 1), (1, 2), (2, 1), (2, 2)]
    assert drops.unbalance_turn_deg[0] == drops.unbalance_turn_deg[1] != drops.unbalance_turn_deg[2]
    assert drops.rotor_friction.nunique() == 4
    assert set(drops.end_state) == {"falling"}
    judged = drop.data_verification()
    assert judged.verdict[2, "rotor_speed_rpm"] == "converged"
    alone = rigid().drop(short, speed_rpm=30000.0)
    assert alone != drop
    assert alone.bearings == drop.bearings
    assert alone.ensemble is None
    assert alone.data_drops().empty
    assert alone.data_verification().empty


def test_a_bearing_has_its_own_results_and_columns() -> None:
    drop = rigid().drop(cases(), speed_rpm=30000.0)
    frame = drop.data_bearings()
    assert list(frame.impacts) == [bearing.impacts for bearing in drop.bearings]
    # Keys of the case are no columns: several sections have a friction coefficient.
    assert not {"friction_coefficient", "mass_kg", "balls", "solver"} & set(frame.columns)
    with pytest.raises(AttributeError, match=r"'impacts'; .*: bearings\[0\]\.impacts"):
        _ = drop.impacts
    with pytest.raises(cageless.InputError, match=r"orbit is shown of each .*\[0\]\.plot_orbit\(\)"):
        drop.plot_orbit()
    assert drop.bearings[0].plot_orbit().data
    # Columns of sweeps alone.
    for name in ("plane_margin_min_um", "rotor_energy_residual_relative"):
        assert name not in cageless.Drop.__mro__[1].__annotations__
    assert drop.rotor.energy_residual_relative == pytest.approx(0.0, abs=1e-3)


def test_every_bearing_is_in_files_for_other_programs(tmp_path: Path) -> None:
    from scipy import io

    drop = rigid().drop(cases(), speed_rpm=30000.0)
    names = {path.stem for path in drop.to_csv(tmp_path)}
    read = io.loadmat(drop.to_mat(tmp_path / "drop.mat"), simplify_cells=True)
    assert {"bearings", "bearing_1_ring", "bearing_2_balls", "bearing_2_windows"} <= names
    assert names == {name for name in read if not name.startswith("__")} - {"units"}
    for number, bearing in enumerate(drop.bearings, 1):
        for name in ("rotor", "ring", "balls", "windows"):
            frame, stored = getattr(bearing, f"data_{name}")(), read[f"bearing_{number}_{name}"]
            for column in frame.select_dtypes(include=["float64"]).columns:
                found = np.atleast_1d(stored[column])
                assert np.array_equal(found, frame[column].to_numpy(), equal_nan=True), column
    assert read["units"]["bearing_2_ring"]["ax_m_s2"] == "m/s^2"
    assert not np.array_equal(read["bearing_1_ring"]["y_m"], read["bearing_2_ring"]["y_m"])
    with pytest.raises(AttributeError, match=r"each of its bearings has: bearings\[0\]\.data_windows"):
        drop.data_windows()


@pytest.mark.parametrize("speed", [np.nan, np.inf, "9000", True])
def test_a_speed_that_is_none_is_refused(speed: Any) -> None:
    calls: list[Callable[[], object]] = [
        lambda: rigid().eigenvalues(speed),
        lambda: rigid().drop(cases(), speed_rpm=speed),
    ]
    for call in calls:
        with pytest.raises(cageless.InputError, match="speed_rpm = .* is not possible"):
            call()


def spinning(polar_inertia_kg_m2: float) -> npt.NDArray[np.float64]:
    """G of two discs with this moment of inertia about their axis, on two nodes."""
    gyroscopic = np.zeros((8, 8))
    for alpha in (2, 6):
        gyroscopic[alpha, alpha + 1] = polar_inertia_kg_m2
        gyroscopic[alpha + 1, alpha] = -polar_inertia_kg_m2
    return gyroscopic


def test_a_speed_beyond_all_numbers_has_no_eigenvalues() -> None:
    matrices = two_nodes()
    rotor = cageless.LinearRotor.from_matrices(
        matrices["M"], matrices["K"], G=spinning(1e-3), polar_inertia_kg_m2=2e-3, nodes=[0, 1]
    )
    assert np.isfinite(rotor.eigenvalues(1e9)).all()
    with pytest.raises(cageless.InputError, match="speed_rpm = 1e300 is not possible"):
        rotor.eigenvalues(1e300)


def test_a_rotor_is_not_written_to(tmp_path: Path) -> None:
    rotor = rigid()
    with pytest.raises(AttributeError, match="LinearRotor.mass_kg cannot be set"):
        rotor.mass_kg = 3.0
    case = cageless.RotorCase(rotor, cases(), speed_rpm=30000.0)
    with pytest.raises(AttributeError, match=r"RotorCase.speed_rpm cannot be set: replace\(\)"):
        case.speed_rpm = 3.0  # type: ignore[misc]
    assert (rotor.mass_kg, case.speed_rpm) == (40.0, 30000.0)
    speed: Any = np.float32(9000.0)
    assert rotor.eigenvalues(speed) == pytest.approx(rotor.eigenvalues(9000))


def test_a_rotor_case_is_shown_with_its_keys() -> None:
    case = cageless.RotorCase(rigid(), cases(), speed_rpm=30000.0)
    shown = case._repr_html_()
    for key in ("rotor.speed_rpm", "bearing.2.axial_mm", "bearing.1.case.contact.damping_n_s_m1_5"):
        assert f">{key}</th>" in shown
    matrices = two_nodes()
    rotor = cageless.LinearRotor.from_matrices(
        matrices["M"], matrices["K"], polar_inertia_kg_m2=2e-3, nodes=[0, 1]
    )
    assert "rotor.matrices" not in cageless.RotorCase(rotor, cases(), speed_rpm=9.0)._repr_html_()


def test_the_precession_of_a_rigid_rotor() -> None:
    rotor = rigid()
    assert (rotor.mass_kg, rotor.polar_inertia_kg_m2, rotor.coordinates) == (40.0, 0.04, 4)
    fastest = rotor.eigenvalues(30000.0)[-1]
    assert fastest.imag == pytest.approx(30000.0 * np.pi / 30.0 * 0.04 / 0.6, rel=1e-12)


def two_nodes() -> dict[str, npt.NDArray[np.float64]]:
    """Two nodes of 1 kg on a beam, four coordinates each."""
    stiffness, length = 1e6, 0.3
    bending = stiffness * np.array(
        [
            [12.0, 6.0 * length, -12.0, 6.0 * length],
            [6.0 * length, 4.0 * length**2, -6.0 * length, 2.0 * length**2],
            [-12.0, -6.0 * length, 12.0, -6.0 * length],
            [6.0 * length, 2.0 * length**2, -6.0 * length, 4.0 * length**2],
        ]
    )
    k = np.zeros((8, 8))
    for places, sign in (([0, 3, 4, 7], 1.0), ([1, 2, 5, 6], -1.0)):
        signs = np.array([1.0, sign, 1.0, sign])
        k[np.ix_(places, places)] += bending * np.outer(signs, signs)
    return {"M": np.diag([1.0, 1.0, 1e-3, 1e-3] * 2), "K": k}


def test_anything_with_the_methods_is_a_rotor(tmp_path: Path) -> None:
    matrices = two_nodes()
    none = np.zeros((8, 8))
    like_ross = SimpleNamespace(
        M=lambda frequency: matrices["M"],
        K=lambda frequency: matrices["K"],
        C=lambda frequency: none,
        G=lambda: none,
        Ksdt=lambda: none,
        number_dof=4,
        Ip=2e-3,
    )
    rotor = cageless.Rotor.from_ross(like_ross, nodes=[0, 1])
    direct = cageless.LinearRotor.from_matrices(
        matrices["M"], matrices["K"], polar_inertia_kg_m2=2e-3, nodes=[0, 1]
    )
    assert np.array_equal(rotor.eigenvalues(0.0), direct.eigenvalues(0.0))
    assert rotor.mass_shares_kg == pytest.approx([1.0, 1.0])
    squares = np.linalg.eigvals(np.linalg.inv(matrices["M"]) @ matrices["K"]).real
    assert rotor.eigenvalues(0.0)[-1].imag == pytest.approx(np.sqrt(squares.max()), rel=1e-9)
    saved = rotor.save_matrices(tmp_path / "rotor.json")
    assert np.array_equal(json.loads(saved.read_text())["K"], matrices["K"])


def test_sparse_matrices_are_those_that_they_hold() -> None:
    from scipy import sparse

    matrices = two_nodes() | {"G": spinning(1e-3)}
    held: dict[str, Any] = {"polar_inertia_kg_m2": 2e-3, "nodes": [0, 1]}
    whole: dict[str, Any] = {**matrices, **held}
    dense = cageless.LinearRotor.from_matrices(**whole)
    packed: dict[str, Any] = {name: sparse.csr_array(matrix) for name, matrix in matrices.items()}
    found = cageless.LinearRotor.from_matrices(**packed, **held)
    assert np.array_equal(found.eigenvalues(9000.0), dense.eigenvalues(9000.0))


def on_a_housing() -> dict[str, npt.NDArray[np.float64]]:
    """The two nodes, the second one on a housing of 2 kg, with a fluid of 0.5 kg about the first."""
    grown = {name: np.pad(matrix, (0, 2)) for name, matrix in two_nodes().items()}
    grown["Ma"] = np.zeros((10, 10))
    for axis in (0, 1):
        (node, housing) = places = (4 + axis, 8 + axis)
        grown["M"][housing, housing] = 2.0
        grown["Ma"][axis, axis] = 0.5
        grown["K"][np.ix_(places, places)] += 1e5 * np.array([[1.0, -1.0], [-1.0, 4.0]])
    return grown


def test_a_rotor_on_a_housing_is_that_of_its_file(command: Command, tmp_path: Path) -> None:
    matrices = on_a_housing()
    rotor = cageless.LinearRotor.from_matrices(
        M=matrices["M"],
        Ma=matrices["Ma"],
        K=matrices["K"],
        polar_inertia_kg_m2=2e-3,
        nodes=[0, 1],
        housings=1,
    )
    assert rotor.mass_kg == pytest.approx(2.0) and rotor.coordinates == 10
    # Held at its journal, the rotor carries a quarter of the housing.
    assert rotor.mass_shares_kg == pytest.approx([1.0, 1.5])
    squares = np.linalg.eigvals(np.linalg.inv(matrices["M"] + matrices["Ma"]) @ matrices["K"]).real
    assert rotor.frequencies_hz()[-1] == pytest.approx(np.sqrt(squares.max()) / (2.0 * np.pi), rel=1e-9)
    rotor.save_matrices(tmp_path / "rotor.json")
    bearings = "".join(
        f"[[bearing]]\ncase = {json.dumps(str(case))}\nnode = {node}\n" for node, case in enumerate(CASES)
    )
    head = '[rotor]\nmatrices = "rotor.json"\nspeed_rpm = 9000.0\n'
    (tmp_path / "rotor.toml").write_text(head + bearings)
    read = cageless.RotorCase.from_file(tmp_path / "rotor.toml", SHORT)
    for again in (read, cageless.RotorCase.from_toml(read.to_toml())):
        assert np.array_equal(again.rotor.frequencies_hz(), rotor.frequencies_hz())
        assert again.rotor.mass_shares_kg == rotor.mass_shares_kg
    checked = json.loads(command("check", tmp_path / "rotor.toml", "--json").stdout)
    assert checked["mass_shares_kg"] == pytest.approx([1.0, 1.5])


def test_matrices_of_other_shapes_and_nodes_are_refused() -> None:
    for sizes, per_node, said in [
        ({"K": 4}, 4, "matrix K of the rotor is 4 × 4: must be 8 × 8"),
        ({}, 5, "a rotor of 8 coordinates, 5 a node"),
        ({}, 0, "a rotor of 8 coordinates, 0 a node"),
        ({}, 6, "a rotor of 8 coordinates, 6 a node"),
    ]:
        parts = {
            name: lambda _=0.0, name=name, sizes=sizes: np.eye(sizes.get(name, 8))
            for name in ("M", "C", "G", "K", "Ksdt")
        }
        with pytest.raises(cageless.InputError, match=said):
            cageless.Rotor.from_ross(SimpleNamespace(**parts, number_dof=per_node, Ip=1e-3), nodes=[0, 1])


def test_impossible_rotors_are_refused() -> None:
    matrices = two_nodes()
    refused: list[tuple[dict[str, Any], str]] = [
        ({"nodes": [0, 2]}, "node 2 does not exist: the rotor has the nodes 0 to 1"),
        ({"nodes": [-1, 1]}, "node = -1 is not possible"),
        ({"nodes": [0, 1], "M": -matrices["M"]}, "matrix M must be positive definite"),
        ({"nodes": [0, 1], "G": np.eye(8)}, "matrix G must be antisymmetric"),
        ({"nodes": [0, 1], "C": np.eye(4)}, "matrix C is 4 × 4: must be 8 × 8"),
        ({"nodes": [0, 1], "K": np.zeros(8)}, "matrix K has 1 dimensions"),
        ({"nodes": [0, 1], "M": [[1.0, 2.0], [3.0]]}, "matrix M must be of numbers, in rows of one length"),
        ({"nodes": [0, 1], "K": np.zeros((8, 8))}, r"coordinates are \[x, y, α, β\] of each node in turn"),
        ({"nodes": [0, 1], "G": spinning(-1e-3)}, r"matrix G must be \+Ip in row α and column β of a disc"),
        ({"nodes": [0, 1], "G": spinning(1e-5)}, r"it has 2\.000e-5 kg·m² about the axis by G"),
        ({"nodes": [0]}, "move freely"),
        ({"nodes": [0, 1], "housings": 1}, r"four coordinates a node.* two of each of 1 housings"),
        ({"nodes": [0, 1], "housings": -1}, "housings = -1 is not possible: it must be a whole number"),
        ({"nodes": [0, 1], "Ma": np.eye(4)}, "matrix Ma is 4 × 4: must be 8 × 8"),
        ({"nodes": [0, 1], "Ma": -2.0 * np.eye(8)}, r"matrix M \+ Ma must be positive definite"),
        ({"nodes": [0, 2], "housings": 1, **on_a_housing()}, "node 2 does not exist: .* nodes 0 to 1"),
    ]
    for changes, message in refused:
        with pytest.raises(cageless.InputError, match=message):
            values: dict[str, Any] = {**matrices, "polar_inertia_kg_m2": 2e-3, **changes}
            cageless.LinearRotor.from_matrices(**values)
    for given in (CASES[:1], str(CASES[0]), [cases()[0], None]):
        files: Any = given
        with pytest.raises(cageless.InputError, match=r"^cases = .*: it must be a Case for each bearing, of a"):
            rigid().drop(files, speed_rpm=30000.0)
    with pytest.raises(cageless.InputError, match="1 cases for 2 touch-down bearings"):
        rigid().drop(cases()[:1], speed_rpm=30000.0)
    with pytest.raises(cageless.InputError, match="a rigid rotor has no matrices"):
        rigid().save_matrices("rotor.json")
    with pytest.raises(cageless.InputError, match="samples"):
        rigid().drop(cases(), speed_rpm=30000.0, samples=0)
    longer = cases()[1].replace({"solver.duration_s": 0.1})
    with pytest.raises(cageless.InputError, match="all bearings of a rotor need the same"):
        rigid().drop([cases()[0], longer], speed_rpm=30000.0)


#: Changes after which the rotor touches both bearings at once.
NEAR = {"solver.duration_s": 0.0012, "rotor.y_um": -170.0, "rotor.vy_m_s": -0.06}
GRID = {"rotor.speed_rpm": [15000.0, 30000.0], "bearing.2.rotor.radial_clearance_um": [180.0]}


def rotor_plan(tmp_path: Path) -> cageless.Plan:
    case = cageless.RotorCase.from_file(rotor_file(tmp_path))
    return cageless.Plan(case=case, compute=["drop"], set=NEAR, grid=GRID)


def test_a_rotor_case_is_its_file(tmp_path: Path) -> None:
    path = rotor_file(tmp_path)
    read = cageless.RotorCase.from_file(path, SHORT)
    made = cageless.RotorCase(rigid(), cases(), speed_rpm=30000.0)
    assert (read.speed_rpm, read.drive_torque_n_m, read.title) == (30000.0, 0.0, "")
    assert read.rotor.mass_shares_kg == made.rotor.mass_shares_kg
    assert [case.contact for case in read.cases] == [case.contact for case in made.cases]
    assert "40 kg in 2 bearings" in repr(read)
    more = {"bearing.2.contact.damping_n_s_m1_5": 4e5, "unbalance.1.amount_g_mm": 100.0}
    assert read.replace(more) == cageless.RotorCase.from_file(path, {**SHORT, **more}) != read
    short = {"solver.duration_s": 0.0006}
    assert read.replace(short).drop() == made.replace(short).drop()
    assert pickle.loads(pickle.dumps(read)) == read
    with pytest.raises(cageless.InputError, match="belongs to the rotor as a whole") as error:
        read.replace({"bearing.2.rotor.speed_rpm": 1.0})
    assert error.value.key == "bearing.2.rotor.speed_rpm"


def test_a_rotor_case_is_written_as_one_file(command: Command, tmp_path: Path) -> None:
    case = cageless.RotorCase.from_file(rotor_file(tmp_path), {"solver.duration_s": 0.0006})
    alone = tmp_path / "alone"
    alone.mkdir()
    (alone / "rotor.toml").write_text(case.to_toml())
    command("drop", alone / "rotor.toml", "--out", alone)
    found = summary_of(alone)
    assert stated(found)["bearings"] == stated(case.drop().values)["bearings"]
    assert found["rotor"] == case.drop().values["rotor"]


def test_a_sweep_of_a_rotor_is_that_of_the_command(command: Command, tmp_path: Path) -> None:
    plan = rotor_plan(tmp_path)
    assert cageless.Plan.from_toml(plan.to_toml()) == plan
    result = cageless.sweep(plan, out=tmp_path / "python")
    text = "case = 'rotor.toml'\ncompute = ['drop']\n[set]\n"
    text += "".join(f"{key} = {value}\n" for key, value in NEAR.items()) + "[grid]\n"
    text += "".join(f"{key} = {values}\n" for key, values in GRID.items())
    path = tmp_path / "plan.toml"
    path.write_text(text)
    command("sweep", path, "--out", tmp_path / "command")
    assert result.path.read_bytes() == (tmp_path / "command" / "sweep.parquet").read_bytes()
    frame = result.data_variants()
    drop = plan.case(1).drop()
    for k, bearing in enumerate(drop.bearings, 1):
        for name in ["impacts", "rotor_force_max_n", "dissipated_j"]:
            assert frame[f"drop_bearing_{k}_{name}"][1] == bearing.values[name]
    force = max(bearing.rotor_force_max_n for bearing in drop.bearings)
    assert frame["drop_rotor_force_max_n"][1] == force
    assert result.units["drop_bearing_2_dissipated_j"] == "J"
    assert "drop_dissipated_j" in result.report().outputs


def test_workers_elsewhere_give_the_same_rows(tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    plan = rotor_plan(tmp_path)
    local = cageless.sweep(plan, out=tmp_path / "local").path.read_bytes()
    with (
        distributed.LocalCluster(
            n_workers=1, threads_per_worker=1, processes=True, dashboard_address=None
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        result = cageless.sweep(plan, out=tmp_path / "cluster", client=client)
    assert result.path.read_bytes() == local


def test_a_rotor_by_matrices_is_swept() -> None:
    matrices = two_nodes()
    rotor = cageless.LinearRotor.from_matrices(
        matrices["M"], matrices["K"], polar_inertia_kg_m2=2e-3, nodes=[0, 1]
    )
    near = [case.replace(NEAR) for case in cases()]
    machine = cageless.RotorCase(rotor, near, speed_rpm=9000.0)
    grid = {"bearing.2.node": [1], "rotor.drive_torque_n_m": [0.0, -1.0]}
    plan = cageless.Plan(case=machine, compute=["drop"], grid=grid)
    row = cageless.sweep(plan).data_variants().iloc[0]
    assert row.reason is None
    drop = machine.drop()
    assert row.drop_bearing_2_dissipated_j == drop.bearings[1].dissipated_j > 0.0
    assert cageless.Plan.from_toml(plan.to_toml()) == plan


def test_wrong_plans_of_a_rotor_are_refused(tmp_path: Path) -> None:
    case = cageless.RotorCase.from_file(rotor_file(tmp_path))
    wrong: list[tuple[list[str], dict[str, Any], str]] = [
        (["run"], {}, 'compute has "run", which is for the case of one bearing'),
        (["drop"], {"rotor.sped_rpm": [1.0]}, "did you mean speed_rpm"),
        (["drop"], {"bearing.3.contact.damping_n_s_m1_5": [1e5]}, "there are 2"),
        (["drop"], {"rotor.eccentricity_um": [1.0]}, "replaced by the unbalances of the rotor"),
    ]
    for compute, grid, said in wrong:
        with pytest.raises(cageless.InputError, match=said) as error:
            cageless.Plan(case=case, compute=compute, grid=grid)
        assert error.value.line is None


def test_a_file_of_the_other_kind_is_named(tmp_path: Path) -> None:
    with pytest.raises(cageless.InputError, match=r"touchdown-d\.toml: is a case, not a rotor"):
        cageless.RotorCase.from_file(CASES[0])
    with pytest.raises(cageless.InputError, match=r"rotor\.toml: is a rotor .*, not a case"):
        cageless.Case.from_file(rotor_file(tmp_path))

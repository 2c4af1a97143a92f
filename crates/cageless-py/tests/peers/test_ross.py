"""A rotor of ROSS, the rotor dynamics package: mass, inertia, eigenvalues, and its response in time."""

from __future__ import annotations

import sys
from pathlib import Path
from unittest.mock import MagicMock

import numpy as np
import pytest

# Of gas seals and control loops alone; their own dependencies are large.
for absent in ("ccp", "control"):
    sys.modules.setdefault(absent, MagicMock())

import cageless
import ross
from scipy.linalg import eigh

CASE = Path(__file__).resolve().parents[4] / "cases" / "touchdown-d.toml"
SPEED_RPM = 12000.0
SPEED_RAD_S = SPEED_RPM * np.pi / 30.0
NODES = [1, 7]
UNBALANCE_NODE, UNBALANCE_G_MM, PHASE_DEG = 4, 30.0, 25.0


@pytest.fixture(scope="module")
def rotor() -> ross.Rotor:
    steel = ross.Material("steel", rho=7850, E=206e9, Poisson=0.3)
    shaft = [ross.ShaftElement(L=0.05, idl=0, odl=0.03, material=steel) for _ in range(8)]
    disks = [
        ross.DiskElement(n=2, m=4.0, Id=0.011, Ip=0.02),
        ross.DiskElement(n=5, m=6.0, Id=0.02, Ip=0.035),
    ]
    # What still holds it after the magnets have let go: seals with some damping.
    seals = [ross.SealElement(n=n, kxx=2e5, kyy=3e5, cxx=50.0, cyy=80.0) for n in (0, 8)]
    return ross.Rotor(shaft, disks, seals)


def test_eigenvalues_are_those_of_ross(rotor: ross.Rotor) -> None:
    found = cageless.Rotor.from_ross(rotor, NODES).eigenvalues(SPEED_RPM)
    modal = rotor.run_modal(SPEED_RAD_S, num_modes=16, sparse=False)
    expected = [e for e in modal.evalues if 100.0 < abs(e.imag) < 1e4]
    lateral = 0
    for value in expected:
        miss = np.abs(found - value).min() / abs(value)
        # Axial motion and torsion of ross are not lateral.
        if miss > 1e-3:
            continue
        lateral += 1
        assert miss < 1e-9, value
    assert lateral >= 8


def test_a_rotor_without_contact_moves_as_in_ross(rotor: ross.Rotor) -> None:
    duration = 4e-3
    time = np.arange(0.0, duration + 1e-9, 2e-6)
    force = np.zeros((len(time), rotor.ndof))
    # The weight, and the unbalance at a constant speed.
    upwards = np.zeros(rotor.ndof)
    upwards[1::6] = 1.0
    force -= 9.81 * (rotor.M(0.0) @ upwards)
    turned = SPEED_RAD_S * time + np.radians(PHASE_DEG)
    centrifugal = 1e-6 * UNBALANCE_G_MM * SPEED_RAD_S**2
    force[:, 6 * UNBALANCE_NODE] += centrifugal * np.cos(turned)
    force[:, 6 * UNBALANCE_NODE + 1] += centrifugal * np.sin(turned)
    response = rotor.run_time_response(SPEED_RAD_S, force, time)
    linear = cageless.Rotor.from_ross(
        rotor, NODES, unbalances=[(UNBALANCE_NODE, UNBALANCE_G_MM, PHASE_DEG)]
    )
    case = cageless.Case.from_file(
        CASE,
        {
            "solver.duration_s": duration,
            "solver.method": "adaptive",
            "solver.tolerance": 1e-10,
            "output.interval_us": 100.0,
        },
    )
    drop = linear.drop([case, case], speed_rpm=SPEED_RPM)
    for node, bearing in zip(NODES, drop.bearings, strict=True):
        assert np.isnan(bearing.first_contact_ms)
        for column, place in (("x_m", 6 * node), ("y_m", 6 * node + 1)):
            expected = np.interp(bearing.time_s, time, response.yout[:, place])
            scale = np.abs(expected).max()
            assert scale > 1e-6
            error = np.abs(bearing.array(column, "rotor") - expected).max() / scale
            # ross takes the force as linear over each 2 µs.
            assert error < 5e-6, (node, column, error)


STEEL = ross.Material("steel", rho=7810, E=211e9, G_s=81.2e9)


def bare(held: list[ross.BearingElement], masses: list[ross.PointMass]) -> ross.Rotor:
    """A shaft with two discs, 52 kg."""
    shaft = [ross.ShaftElement(0.1, 0.0, 0.06, material=STEEL) for _ in range(10)]
    discs = [ross.DiskElement(n=n, m=15, Id=0.1, Ip=0.15) for n in (3, 7)]
    return ross.Rotor(shaft, discs, held, masses)


def on_housings(count: int, stiffness_n_m: float) -> ross.Rotor:
    """The shaft in bearings of a stiffness, each on a housing."""
    held = []
    for k in range(count):
        held += [
            ross.BearingElement(n=1 + k, n_link=11 + k, kxx=stiffness_n_m, cxx=0),
            ross.BearingElement(n=11 + k, kxx=1e8, cxx=1e3),
        ]
    return bare(held, [ross.PointMass(11 + k, m=5.0) for k in range(count)])


def is_as_in_ross(found: cageless.LinearRotor, rotor: ross.Rotor) -> None:
    """Mass, moment of inertia and first bending frequencies are those of ROSS."""
    assert found.mass_kg == pytest.approx(rotor.m, rel=1e-9)
    assert found.polar_inertia_kg_m2 == pytest.approx(rotor.Ip, rel=1e-9)
    squares = eigh(rotor.K(0.0), rotor.M(0.0), eigvals_only=True)
    own = np.sqrt(squares.clip(min=0.0)) / (2.0 * np.pi)
    bending = found.frequencies_hz()[4:8]
    assert bending.min() > 50.0
    for frequency in bending:
        assert np.abs(own - frequency).min() < 1e-6 * frequency


@pytest.mark.parametrize("count", [1, 2, 3, 4, 6])
def test_housings_that_nothing_connects_are_left_out(count: int) -> None:
    with pytest.warns(UserWarning, match=r"left out .* connects it with the shaft: Point Mass 0 \(node 11\)"):
        found = cageless.Rotor.from_ross(on_housings(count, 0.0), nodes=[1, 9])
    is_as_in_ross(found, bare([], []))
    with pytest.raises(cageless.InputError, match=r"rests on housings \(Point Mass 0 .* by Bearing 0 \(node 1\)"):
        cageless.Rotor.from_ross(on_housings(count, 1e7), nodes=[1, 9])


def test_magnetic_bearings_have_no_power_in_a_drop() -> None:
    constants = {"g0": 1e-3, "i0": 1.0, "ag": 1e-4, "nw": 200, "kxx": 1e6, "cxx": 100.0}
    magnets = [ross.MagneticBearingElement(n, tag=f"AMB {n}", **constants) for n in (2, 8)]
    with pytest.warns(UserWarning, match=r"magnetic bearing has no power in a drop: AMB 2 \(node 2\), AMB 8"):
        found = cageless.Rotor.from_ross(bare(magnets, []), nodes=[1, 9])
    is_as_in_ross(found, bare([], []))


def test_bearings_that_stay_are_named_and_the_drop_is_warned_of() -> None:
    held = [ross.BearingElement(n, kxx=1e7, cxx=100.0) for n in (2, 8)]
    with pytest.warns(UserWarning, match=r"kept in the rotor.*: Bearing 0 \(node 2\), Bearing 1"):
        found = cageless.Rotor.from_ross(bare(held, []), nodes=[1, 9])
    case = cageless.Case.from_file(CASE, {"solver.duration_s": 1e-4})
    drop = found.drop([case, case], speed_rpm=SPEED_RPM)
    assert any("does not fall onto its touch-down bearings" in text for text in drop.warnings)


def test_rotors_with_several_speeds_are_refused() -> None:
    with pytest.raises(cageless.InputError, match="a CoAxialRotor is not possible"):
        cageless.Rotor.from_ross(ross.coaxrotor_example(), nodes=[0, 5])
    gears = []
    for n, teeth in ((2, 40), (0, 20)):
        shaft = [ross.ShaftElement(0.2, 0.0, 0.05, material=STEEL) for _ in range(2)]
        gear = ross.GearElement(
            n=n, m=5, Id=0.002, Ip=0.004, n_teeth=teeth, pitch_diameter=0.005 * teeth, pr_angle=0.35
        )
        ends = [ross.BearingElement(at, kxx=1e7, cxx=1e3) for at in (0, 2)]
        gears.append(ross.Rotor(shaft, [gear], ends))
    geared = ross.MultiRotor(*gears, coupled_nodes=(2, 0), gear_mesh_stiffness=1e8)
    with pytest.raises(cageless.InputError, match="a MultiRotor is not possible: geared shafts"):
        cageless.Rotor.from_ross(geared, nodes=[0, 2])


def test_what_has_other_numbers_than_ross_is_refused() -> None:
    seal = ross.SealElement(n=2, kxx=1e5, cxx=10.0, mxx=3.0)
    with pytest.raises(cageless.InputError, match=r"Seal 0 \(node 2\) adds a mass"):
        cageless.Rotor.from_ross(bare([seal], []), nodes=[1, 9])
    rotor = bare([], [])
    rotor.m += 1.0
    with pytest.raises(cageless.InputError, match="the mass of the matrices is 52.08.* that of ROSS 53.08"):
        cageless.Rotor.from_ross(rotor, nodes=[1, 9])

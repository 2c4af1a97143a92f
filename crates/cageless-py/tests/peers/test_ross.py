"""A rotor of ROSS, the rotor dynamics package: eigenvalues, and its response in time."""

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
    seals = [ross.BearingElement(n=n, kxx=2e5, kyy=3e5, cxx=50.0, cyy=80.0) for n in (0, 8)]
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

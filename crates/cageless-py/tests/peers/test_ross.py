"""A rotor of ROSS, the rotor dynamics package: mass, inertia, eigenvalues, and its response in time."""

from __future__ import annotations

import sys
from pathlib import Path
from unittest.mock import MagicMock

import numpy as np
import numpy.typing as npt
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
    has_eigenvalues_of_ross(rotor)


def test_eigenvalues_on_housings_are_those_of_ross() -> None:
    with pytest.warns(UserWarning, match="kept in the rotor"):
        has_eigenvalues_of_ross(on_housings(NODES, 1e7))


def has_eigenvalues_of_ross(rotor: ross.Rotor) -> None:
    found = cageless.Rotor.from_ross(rotor, NODES).eigenvalues(SPEED_RPM)
    modal = rotor.run_modal(SPEED_RAD_S, num_modes=24, sparse=False)
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
    falls_as_in_ross(rotor, NODES)


def test_a_rotor_on_housings_moves_as_in_ross() -> None:
    held = on_housings([1, 7, 9], 1e6)
    with pytest.warns(UserWarning, match=r"kept in the rotor.*: Bearing 0 \(node 1\), Bearing 2 \(node 7\)"):
        falls_as_in_ross(held, NODES)


def falls_as_in_ross(rotor: ross.Rotor, nodes: list[int]) -> None:
    """A drop without contact against the integration of ROSS, both from rest without any force."""
    duration = 4e-3
    time = np.arange(0.0, duration + 1e-9, 2e-6)
    force = np.zeros((len(time), rotor.ndof))
    # The weight, of each housing as well, and the unbalance at a constant speed.
    shaft = 6 * len(rotor.nodes)
    upwards = np.zeros(rotor.ndof)
    upwards[1:shaft:6] = upwards[shaft + 1 :: 3] = 1.0
    force -= 9.81 * (rotor.M(0.0) @ upwards)
    turned = SPEED_RAD_S * time + np.radians(PHASE_DEG)
    centrifugal = 1e-6 * UNBALANCE_G_MM * SPEED_RAD_S**2
    force[:, 6 * UNBALANCE_NODE] += centrifugal * np.cos(turned)
    force[:, 6 * UNBALANCE_NODE + 1] += centrifugal * np.sin(turned)
    response = rotor.run_time_response(SPEED_RAD_S, force, time)
    linear = cageless.Rotor.from_ross(
        rotor, nodes, unbalances=[(UNBALANCE_NODE, UNBALANCE_G_MM, PHASE_DEG)]
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
    for node, bearing in zip(nodes, drop.bearings, strict=True):
        assert np.isnan(bearing.first_contact_ms)
        for column, place in (("x_m", 6 * node), ("y_m", 6 * node + 1)):
            expected = np.interp(bearing.time_s, time, response.yout[:, place])
            scale = np.abs(expected).max()
            assert scale > 3e-7
            error = np.abs(bearing.array(column, "rotor") - expected).max() / scale
            # ross takes the force as linear over each 2 µs.
            assert error < 5e-6, (node, column, error)


STEEL = ross.Material("steel", rho=7810, E=211e9, G_s=81.2e9)


def bare(held: list[ross.BearingElement], masses: list[ross.PointMass]) -> ross.Rotor:
    """A shaft with two discs, 52 kg."""
    shaft = [ross.ShaftElement(0.1, 0.0, 0.06, material=STEEL) for _ in range(10)]
    discs = [ross.DiskElement(n=n, m=15, Id=0.1, Ip=0.15) for n in (3, 7)]
    return ross.Rotor(shaft, discs, held, masses)


#: Nodes of up to six supports.
SUPPORTS = [1, 9, 5, 0, 10, 6]


def on_housings(nodes: list[int], stiffness_n_m: float, damping_n_s_m: float = 200.0) -> ross.Rotor:
    """The shaft in bearings of a stiffness and a damping, each on a housing."""
    held = []
    for k, node in enumerate(nodes):
        held += [
            ross.BearingElement(n=node, n_link=11 + k, kxx=stiffness_n_m, cxx=damping_n_s_m),
            ross.BearingElement(n=11 + k, kxx=1e8, kyy=6e7, cxx=1e3),
        ]
    return bare(held, [ross.PointMass(11 + k, m=5.0 + k) for k in range(len(nodes))])


def frequencies_hz(rotor: ross.Rotor, kept: npt.ArrayLike | None = None) -> npt.NDArray[np.float64]:
    """Natural frequencies by the matrices of ROSS; the shift makes the lowest ones the most exact."""
    k, m = rotor.K(0.0), rotor.M(0.0)
    places = np.arange(len(m)) if kept is None else np.asarray(kept)
    k, m = k[np.ix_(places, places)], m[np.ix_(places, places)]
    shift = (2.0 * np.pi * 30.0) ** 2
    squares = 1.0 / eigh(m, k + shift * m, eigvals_only=True)[::-1] - shift
    return np.sqrt(squares.clip(min=0.0)) / (2.0 * np.pi)


def is_as_in_ross(found: cageless.LinearRotor, rotor: ross.Rotor) -> None:
    """Mass, moment of inertia and all frequencies up to 1 kHz are those of ROSS, and no others."""
    assert found.mass_kg == pytest.approx(rotor.m, rel=1e-9)
    assert found.polar_inertia_kg_m2 == pytest.approx(rotor.Ip, rel=1e-9)
    shaft = 6 * len(rotor.nodes)
    axial = [*range(2, shaft, 6), *range(5, shaft, 6), *range(shaft + 2, rotor.ndof, 3)]
    lateral = list(frequencies_hz(rotor))
    for frequency in frequencies_hz(rotor, axial):
        lateral.pop(int(np.abs(np.array(lateral) - frequency).argmin()))
    lateral = [frequency for frequency in lateral if frequency < 1000.0]
    assert len(lateral) >= 8
    moving = [frequency for frequency in lateral if frequency > 1.0]
    own = found.frequencies_hz()[: len(lateral)]
    assert np.all(own[: len(lateral) - len(moving)] < 1e-2)
    assert own[len(lateral) - len(moving) :] == pytest.approx(moving, rel=1e-9)


@pytest.mark.parametrize("count", range(1, 7))
def test_a_rotor_on_up_to_six_supports_is_as_in_ross(count: int) -> None:
    nodes = SUPPORTS[:count]
    held = [ross.BearingElement(n, kxx=1e7, kyy=2e7, cxx=1e2) for n in nodes]
    for rotor in (bare(held, []), on_housings(nodes, 1e7)):
        with pytest.warns(UserWarning, match="kept in the rotor"):
            found = cageless.Rotor.from_ross(rotor, nodes=[1, 9])
        is_as_in_ross(found, rotor)


@pytest.mark.parametrize("count", range(1, 7))
def test_housings_that_nothing_connects_are_left_out(count: int) -> None:
    apart = on_housings(SUPPORTS[:count], 0.0, 0.0)
    with pytest.warns(UserWarning, match=r"left out .* connects it with the shaft: Point Mass 0 \(node 11\)"):
        found = cageless.Rotor.from_ross(apart, nodes=[1, 9])
    is_as_in_ross(found, bare([], []))


def test_a_housing_on_another_one_stays_and_one_without_a_spring_is_refused() -> None:
    def chain(stiffness_n_m: float) -> ross.Rotor:
        held = [
            ross.BearingElement(n=5, n_link=11, kxx=1e7, cxx=1e2),
            ross.BearingElement(n=11, n_link=12, kxx=stiffness_n_m, cxx=1e2),
            ross.BearingElement(n=12, kxx=stiffness_n_m, cxx=1e2),
        ]
        return bare(held, [ross.PointMass(11, m=4.0), ross.PointMass(12, m=90.0)])

    with pytest.warns(UserWarning, match="kept in the rotor"):
        found = cageless.Rotor.from_ross(chain(3e7), nodes=[1, 9])
    is_as_in_ross(found, chain(3e7))
    with pytest.raises(cageless.InputError, match=r"no spring holds the housing Point Mass 1 \(node 12\)"):
        cageless.Rotor.from_ross(chain(0.0), nodes=[1, 9])


def test_point_masses_on_the_shaft_are_masses_of_the_rotor() -> None:
    on_shaft = [ross.PointMass(4, m=3.0), ross.PointMass(4, m=2.0)]
    # ROSS wants something at the node.
    seal = ross.SealElement(n=4, kxx=1e5, cxx=0.0)
    found = cageless.Rotor.from_ross(bare([seal], on_shaft), nodes=[1, 9])
    alike = bare([], [])
    disc = ross.DiskElement(n=4, m=5.0, Id=0.0, Ip=0.0)
    is_as_in_ross(found, ross.Rotor(alike.shaft_elements, [*alike.disk_elements, disc], [seal]))


def magnets(**options: int) -> list[ross.MagneticBearingElement]:
    constants = {"g0": 1e-3, "i0": 1.0, "ag": 1e-4, "nw": 200, "kxx": 1e6, "cxx": 100.0}
    return [ross.MagneticBearingElement(n, tag=f"AMB {n}", **constants, **options) for n in (2, 8)]


def test_magnetic_bearings_have_no_power_in_a_drop() -> None:
    with pytest.warns(UserWarning, match=r"magnetic bearing has no power in a drop: AMB 2 \(node 2\), AMB 8"):
        found = cageless.Rotor.from_ross(bare(magnets(), []), nodes=[1, 9])
    is_as_in_ross(found, bare([], []))


def test_magnetic_bearings_on_a_housing_are_taken_out_of_both_sides() -> None:
    ground = ross.BearingElement(n=11, kxx=1e8, cxx=1e3, tag="ground")
    mass = ross.PointMass(11, m=5.0)
    with pytest.warns(UserWarning) as told:
        found = cageless.Rotor.from_ross(bare([*magnets(n_link=11), ground], [mass]), nodes=[1, 9])
    magnetic, apart = (str(each.message) for each in told)
    assert "no power in a drop: AMB 2" in magnetic and "shaft: Point Mass 0 (node 11)" in apart
    is_as_in_ross(found, bare([], []))
    # With a bearing on the housing, it stays.
    bearing = ross.BearingElement(n=5, n_link=11, kxx=2e7, cxx=1e2, tag="bearing")
    held = [*magnets(n_link=11), bearing, ground]
    with pytest.warns(UserWarning) as told:
        found = cageless.Rotor.from_ross(bare(held, [mass]), nodes=[1, 9])
    assert ["no power" in str(each.message) for each in told] == [True, False]
    is_as_in_ross(found, bare([bearing, ground], [mass]))


def test_added_masses_move_with_the_rotor_and_have_no_weight() -> None:
    seals = [
        ross.SealElement(n=5, kxx=1e6, cxx=10.0, mxx=6.0),
        ross.SealElement(n=9, n_link=11, kxx=2e7, cxx=10.0, mxx=2.0, myy=3.0),
        ross.BearingElement(n=11, kxx=1e8, cxx=1e3),
    ]
    rotor = bare(seals, [ross.PointMass(11, m=5.0)])
    found = cageless.Rotor.from_ross(rotor, nodes=[1, 9])
    is_as_in_ross(found, rotor)
    seals = [ross.SealElement(n=each.n, n_link=each.n_link, kxx=each.kxx, cxx=10.0) for each in seals]
    empty = cageless.Rotor.from_ross(bare(seals, [ross.PointMass(11, m=5.0)]), nodes=[1, 9])
    assert found.mass_shares_kg == pytest.approx(empty.mass_shares_kg, rel=1e-9)
    assert found.frequencies_hz()[2] < 0.99 * empty.frequencies_hz()[2]
    crossed = bare([ross.SealElement(n=2, kxx=1e5, cxx=10.0, mxx=3.0, mxy=1.0, myx=-1.0)], [])
    with pytest.raises(cageless.InputError, match=r"Seal 0 \(node 2\) adds a mass with mxy = 1 and myx = -1"):
        cageless.Rotor.from_ross(crossed, nodes=[1, 9])


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
    rotor = bare([], [])
    rotor.m += 1.0
    with pytest.raises(cageless.InputError, match="the mass of the matrices is 52.08.* that of ROSS 53.08"):
        cageless.Rotor.from_ross(rotor, nodes=[1, 9])
    rotor = bare([], [])
    rotor.Ip *= 1.0 + 1e-8
    with pytest.raises(cageless.InputError, match="the moment of inertia about the axis is .*, that of ROSS"):
        cageless.Rotor.from_ross(rotor, nodes=[1, 9])

"""Misuse: wrong arguments, and numbers with units of their own, are answered by the method that was called."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import cageless
import numpy as np
import pytest
from cageless import arguments
from cageless.frames import frame, summary
from conftest import ROOT

#: Its types are what is misused.
misused: Any = cageless
TOUCHDOWN = ROOT / "cases" / "touchdown-d.toml"


class Quantity:
    """A number of pint, which has no place here."""

    def __init__(self, magnitude: float, units: str) -> None:
        self.magnitude = magnitude
        self._units = units

    @property
    def units(self) -> str:
        return self._units

    def __str__(self) -> str:
        return f"{self.magnitude} {self.units}"


def machine() -> Any:
    rotor = cageless.LinearRotor.rigid(
        mass_kg=40.0,
        polar_inertia_kg_m2=0.04,
        transverse_inertia_kg_m2=0.6,
        bearing_axial_mm=[-100.0, 200.0],
    )
    case = cageless.Case.from_file(TOUCHDOWN)
    return cageless.RotorCase(rotor, [case, case], speed_rpm=30000.0)


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: machine().drop(sample=2), r"^RotorCase.drop\(\) has no argument 'sample' \(did you mean samples"),
        (lambda: machine().rotor.drop([]), r"^LinearRotor.drop\(\) .*takes cases, speed_rpm, .*title, compare, samples"),
        (lambda: case().static(3), r"^Case.static\(\) has other arguments.*: it takes none"),
        (lambda: misused.Rotor.from_ross(None, [0], frequency_hz=3), r"from_ross\(\) has no .*frequency_max_hz\?"),
        (lambda: case().run(threds=2), r"^Case.run\(\) .*did you mean threads\?\): it takes verify, threads"),
        (lambda: misused.span(1.0, 2.0, cout=3), r"^cageless.span\(\) has .*count\?\): it takes low, high"),
        (lambda: misused.Plan(case=case(), compute="static", gird={}), r"^Plan\(\) has .*did you mean grid\?"),
        (lambda: misused.sweep("plan.toml", thread=2), r"^cageless.sweep\(\) has no argument 'thread'"),
        (lambda: case().static().report(), r"^Static.report\(\) has other arguments, missing .*'path'"),
    ],
)
def test_a_wrong_argument_names_the_method_and_what_it_takes(call: Callable[[], Any], said: str) -> None:
    with pytest.raises(TypeError, match=said):
        call()


def case() -> Any:
    return cageless.Case.from_toml(cageless.template())


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (
            lambda q: cageless.RotorCase(machine().rotor, machine().cases, speed_rpm=q("rpm")),
            r"^RotorCase\(\): speed_rpm = 3 rpm is not possible: it must be a number in rpm, without a unit",
        ),
        (lambda q: case().replace(operation__radial_load_n=q("N")), r"^Case.replace\(\): .*number in N,"),
        (lambda q: case().replace({"operation": {"radial_load_n": q("N")}}), r"^Case.replace\(\): radial_load_n"),
        (
            lambda q: misused.Case(bearing={"balls": 3}, operation=cageless.Operation(inner_speed_rpm=q("rpm"))),
            r"^Case\(\): inner_speed_rpm = 3 rpm",
        ),
        (
            lambda q: cageless.Plan(case=case(), compute="static", grid={"operation.radial_load_n": [q("N")]}),
            r"^Plan\(\): operation.radial_load_n = 3 N",
        ),
        (lambda q: case().tolerance(clearance_um=q("um")), r"^Case.tolerance\(\): clearance_um = .*number in um"),
    ],
)
def test_a_number_with_a_unit_names_the_method_and_the_unit(
    call: Callable[[Any], Any], said: str
) -> None:
    with pytest.raises(cageless.InputError, match=said):
        call(lambda units: Quantity(3, units))


def test_every_public_method_and_function_is_guarded() -> None:
    guarded = arguments.checked(lambda: None).__code__
    for name in cageless.__all__:
        made = getattr(cageless, name)
        if isinstance(made, type) and issubclass(made, arguments.Fixed):
            for member, value in vars(made).items():
                function = getattr(value, "__func__", value)
                if not member.startswith("_") and hasattr(function, "__code__"):
                    assert function.__code__ is guarded, f"{name}.{member}"
        elif hasattr(made, "__code__"):
            assert made.__code__ is guarded, name


def test_the_address_of_a_cluster_is_no_client() -> None:
    with pytest.raises(cageless.InputError, match=r"client = 'tcp://10.0.0.1:8786' .*distributed.Client\('tcp"):
        misused.sweep("plan.toml", client="tcp://10.0.0.1:8786")


def test_workers_without_the_package_are_named() -> None:
    plan = cageless.Plan(case=case(), compute=["static"], grid={"operation.radial_load_n": [100.0, 200.0]})
    found: dict[str, Any] = {"tcp://10.0.0.1:1": object(), "tcp://10.0.0.2:1": None}
    client: Any = SimpleNamespace(submit=None, run=lambda *_, on_error: found)
    said = r"cageless is not installed on 1 of 2 workers of Dask \(tcp://10.0.0.2:1\)"
    with pytest.raises(cageless.CagelessError, match=said):
        cageless.sweep(plan, client=client)


def test_a_number_that_no_row_has_is_nan() -> None:
    found = frame([{"spin_up_ms": None, "end_state": "falling"}, {"spin_up_ms": None, "end_state": None}])
    assert found.spin_up_ms.dtype == float and found.spin_up_ms.isna().all()
    assert found.end_state[0] == "falling"
    drop: Any = SimpleNamespace(kind="drop", _known={"spin_up_ms": None})
    value = summary(drop).value["spin_up_ms"]
    assert isinstance(value, float) and np.isnan(value)


def test_a_bearing_under_a_rotor_has_the_statics_of_its_weight() -> None:
    static = cageless.Case.from_file(TOUCHDOWN).static()
    alone = cageless.Case.from_file(TOUCHDOWN).to_dict()
    for section in ("rotor", "support", "start"):
        del alone[section]
    alone["operation"] |= {"inner_speed_rpm": 30000.0, "radial_load_n": 20.0 * 9.81}
    alone["solver"]["step_us"] = "auto"
    expected = cageless.Case(**alone).static()
    assert static.inner_pressure_max_mpa == expected.inner_pressure_max_mpa > 500.0
    assert "196.2 N across" in static.notes[0]

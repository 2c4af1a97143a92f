"""Frames from made-up values in which every number is another."""

from __future__ import annotations

from typing import Any

import pytest

from cageless import frames
from cageless.exports import Export


def rows(found: Any) -> list[dict[str, Any]]:
    """The rows of a frame with its index as columns, None where there is nothing."""
    kept = found if found.index.names == [None] else found.reset_index()
    return [{k: None if v != v else v for k, v in row.items()} for row in kept.to_dict("records")]


def test_scattered_drops_have_what_was_drawn_and_their_own_results() -> None:
    text = "at t = 0.250000 s went through. To change: halve the step."
    stop = {"time_s": 0.25, "cause": "went through", "advice": "halve the step"}

    def one(friction: float, result: dict[str, Any]) -> list[dict[str, Any]]:
        return [{"rotor_friction": friction, "gaps_deg": [1.0, 2.0], "result": result}]

    values: dict[str, Any] = {
        "ensemble": {
            "drops": [
                {"drop": 1, "unbalance_deg": 40.0, "stopped": None, "bearings": one(0.11, {"impacts": 3, "verdict": "pass", "stopped": None, "windows": []})},
                {"drop": 2, "unbalance_deg": 40.0, "stopped": text, "bearings": one(0.17, {"impacts": 5, "verdict": "fail", "stopped": stop})},
            ]
        }
    }
    head = {"unbalance_deg": 40.0}
    assert rows(frames.scattered(values)) == [
        head | {"drop": 1, "rotor_friction": 0.11, "impacts": 3, "verdict": "pass", "stopped": None},
        head | {"drop": 2, "rotor_friction": 0.17, "impacts": 5, "verdict": "fail", "stopped": text},
    ]

    def bearing(friction: float, impacts: int) -> dict[str, Any]:
        return {"rotor_friction": friction, "result": {"impacts": impacts, "stopped": None}}

    several = {"drop": 7, "unbalance_turn_deg": 9.0, "stopped": "in bearing 2", "bearings": [bearing(0.1, 4), bearing(0.2, 6)]}
    common = {"drop": 7, "unbalance_turn_deg": 9.0, "stopped": "in bearing 2"}
    assert rows(frames.scattered({"ensemble": {"drops": [several]}})) == [
        common | {"bearing": 1, "rotor_friction": 0.1, "impacts": 4},
        common | {"bearing": 2, "rotor_friction": 0.2, "impacts": 6},
    ]
    assert rows(frames.scattered({"ensemble": None})) == []


def test_judgements_are_those_of_their_bearing_and_result() -> None:
    def number(name: str, value: float) -> dict[str, Any]:
        return {"name": name, "value": value, "verdict": f"of {name}"}

    alone = {"verification": {"numbers": [number("a", 1.0), number("b", 2.0)]}}
    assert rows(frames.judged(alone)) == [number("a", 1.0), number("b", 2.0)]
    named = {"verification": {"numbers": {"a": {"value": 1.0}, "b": {"value": 2.0}}}}
    assert rows(frames.judged(named)) == [{"name": "a", "value": 1.0}, {"name": "b", "value": 2.0}]
    two = {"verification": {"bearings": [{"numbers": [number("a", 1.0)]}, {"numbers": [number("a", 3.0)]}]}}
    found = frames.judged(two)
    assert found.loc[(1, "a"), "value"] == 1.0
    assert found.loc[(2, "a"), "value"] == 3.0


def test_balances_have_both_steps() -> None:
    values = {
        "energy_residual_relative": 1e-3,
        "energy_residual_relative_half_step": 2e-4,
        "momentum_residual_relative": 3e-5,
        "momentum_residual_relative_half_step": 4e-6,
        "steps": 100,
    }
    assert rows(frames.balances(values)) == [
        {"balance": "energy", "residual_relative": 1e-3, "residual_relative_half_step": 2e-4},
        {"balance": "momentum", "residual_relative": 3e-5, "residual_relative_half_step": 4e-6},
    ]


def test_structures_have_a_row_per_operating_point_with_errors() -> None:
    def at(gap: float, collisions: float, error: float) -> dict[str, Any]:
        return {"critical_gap_deg": gap, "motion": {"collisions": collisions}, "errors": {"collisions": error}}

    values = {"points": [{"inner_speed_rpm": 3000.0}, {"inner_speed_rpm": 9000.0}]}
    structure = {"status": "accepted", "centre_angles_deg": [-30.0, 30.0], "points": [at(1.1, 2.0, 0.1), at(1.2, 3.0, 0.2)]}
    found = frames.structures(values, [({"structure": 4}, structure)])
    kept = ["structure", "inner_speed_rpm", "critical_gap_deg", "collisions", "collisions_error", "status"]
    assert rows(found[kept]) == [
        dict(zip(kept, (4, 3000.0, 1.1, 2.0, 0.1, "accepted"), strict=True)),
        dict(zip(kept, (4, 9000.0, 1.2, 3.0, 0.2, "accepted"), strict=True)),
    ]


def test_cells_of_a_map_are_at_their_place() -> None:
    found = frames.cells(
        {
            "point": {"inner_speed_rpm": 1.0},
            "axial_span_mm": [4.0, 5.0, 6.0],
            "half_angle_deg": [15.0, 25.0],
            "critical_gap_deg": [[1.0, 2.0, 3.0], [4.0, None, 6.0]],
            "verdict": [["a", "b", "c"], ["d", "e", "f"]],
        }
    )
    names = ["axial_span_mm", "half_angle_deg", "critical_gap_deg", "verdict"]
    wanted = [
        (4.0, 15.0, 1.0, "a"),
        (5.0, 15.0, 2.0, "b"),
        (6.0, 15.0, 3.0, "c"),
        (4.0, 25.0, 4.0, "d"),
        (5.0, 25.0, None, "e"),
        (6.0, 25.0, 6.0, "f"),
    ]
    assert rows(found) == [dict(zip(names, row, strict=True)) for row in wanted]


def test_compared_results_are_those_of_their_runs() -> None:
    def estimate(mean: float) -> dict[str, float]:
        return {"mean": mean, "standard_error": mean / 10, "starts": 4}

    result: dict[str, Any] = {"name": "collisions", "unit": "", "values": [estimate(10.0), estimate(4.0)]}
    result |= {"differences": [None, estimate(-6.0)], "better": [None, True]}
    lacking = {"name": "power_loss_w", "unit": "W", "values": [estimate(20.0), None], "differences": [None, None], "better": [None, None]}
    found = frames.compared({"runs": ["one", "two"], "results": [result, lacking]})
    first, second = rows(found)
    assert first == {
        "name": "collisions", "unit": "", "one": 10.0, "one_error": 1.0, "two": 4.0, "two_error": 0.4,
        "difference": -6.0, "difference_error": -0.6, "better": True,
    }  # fmt: skip
    assert (second["one"], second["two"], second["difference"], second["better"]) == (20.0, None, None, None)


def test_shares_and_best_variants_are_those_of_their_output() -> None:
    def quantity(name: str) -> dict[str, str]:
        return {"name": name}

    values: dict[str, Any] = {
        "inputs": [quantity("span"), quantity("load")],
        "outputs": [
            {"quantity": quantity("gap"), "shares": [0.7, 0.1]},
            {"quantity": quantity("loss"), "shares": [None, 0.4]},
        ],
        "best": [
            {"quantity": quantity("gap"), "high": True, "variants": [{"variant": 5, "value": 2.5}, {"variant": 3, "value": 2.4}]},
            {"quantity": quantity("loss"), "high": False, "variants": [{"variant": 8, "value": 0.5}]},
        ],
    }
    assert rows(frames.shares(values)) == [
        {"output": "gap", "span": 0.7, "load": 0.1},
        {"output": "loss", "span": None, "load": 0.4},
    ]
    assert rows(frames.best(values)) == [
        {"by": "gap", "high": True, "variant": 5, "value": 2.5},
        {"by": "gap", "high": True, "variant": 3, "value": 2.4},
        {"by": "loss", "high": False, "variant": 8, "value": 0.5},
    ]


def test_ranges_have_both_ends() -> None:
    given: list[dict[str, Any]] = [{"name": "a", "gap_deg": [1.0, 2.0]}, {"name": "b", "gap_deg": None}]
    first, second = frames.ranged(given)
    assert first == {"name": "a", "gap_deg_min": 1.0, "gap_deg_max": 2.0}
    assert second["gap_deg_min"] != second["gap_deg_min"]


def test_balls_are_counted_from_1() -> None:
    found = frames.of_balls({"inner_force_n": [5.0, 7.0, 9.0], "row": [1, 1, 2], "stiffness": [1.0, 2.0], "title": "x"})
    assert rows(found) == [
        {"ball": 1, "inner_force_n": 5.0, "row": 1},
        {"ball": 2, "inner_force_n": 7.0, "row": 1},
        {"ball": 3, "inner_force_n": 9.0, "row": 2},
    ]


def test_an_export_has_the_numbers_of_its_files() -> None:
    def made(kind: str, deviation_um: float, mesh_mm3: float) -> dict[str, Any]:
        return {
            "file": f"out/ring.{kind}", "format": kind, "deviation_um": deviation_um, "volume_mm3": 14000.0,
            "mesh_volume_mm3": mesh_mm3, "blend_mm": 0.75, "blend_deviation_um": 3.25, "blend_not_simulated": "set blend_mm",
        }  # fmt: skip

    export = Export([made("step", 0.125, 13999.0), made("stl", 8.5, 13500.0)])
    assert (export.volume_mm3, export.blend_mm, export.blend_deviation_um) == (14000.0, 0.75, 3.25)
    assert export.deviation_um == {"step": 0.125, "stl": 8.5}
    assert export.blend_not_simulated == "set blend_mm"
    assert [(path.name, kind) for path, kind in zip(export.files, export.formats, strict=True)] == [
        ("ring.step", "step"),
        ("ring.stl", "stl"),
    ]
    files = export.data_files()
    assert files.mesh_volume_mm3["stl"] == pytest.approx(13500.0)

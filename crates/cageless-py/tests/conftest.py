"""What the tests share."""

from __future__ import annotations

import json
import os
import re
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import cageless

ROOT = Path(__file__).resolve().parents[3]
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
COMMAND = Path(os.environ.get("CAGELESS", TARGET / "release" / "cageless"))

Command = Callable[..., subprocess.CompletedProcess[str]]


@pytest.fixture(scope="session")
def command() -> Command:
    """Runs the command ``cageless``."""
    assert COMMAND.exists(), f"{COMMAND} is missing: cargo build --release --bin cageless"

    def run(*args: object, code: int = 0) -> subprocess.CompletedProcess[str]:
        done = subprocess.run(
            [str(COMMAND), *map(str, args)], capture_output=True, text=True, check=False
        )
        assert done.returncode == code, done.stderr
        return done

    return run


@pytest.fixture
def case() -> cageless.Case:
    """Balls that collide: a conventional ring, uneven gaps, a short time."""
    return lively()


def lively() -> cageless.Case:
    case = cageless.Case.from_toml(cageless.template(conventional=True))
    gap = case.uniform_gap_deg
    gaps = [0.0, 2.0 * gap] * (case.bearing.balls // 2)
    return case.replace(
        {
            "start.state": "rolling",
            "start.ring_y_um": -15.0,
            "start.gaps": gaps,
            "solver.duration_s": 0.02,
            "housing.mass_kg": 1.0,
            "housing.stiffness_n_m": 1.0e8,
            "housing.damping_n_s_m": 500.0,
        }
    )


def falling(**changes: object) -> cageless.Case:
    """A drop to 1.6 ms after the first contact."""
    case = cageless.Case.from_file(ROOT / "cases" / "touchdown-d.toml")
    return case.replace({"solver.duration_s": 0.008, **changes})


@pytest.fixture
def plan() -> cageless.Plan:
    """Some hundred variants of a few milliseconds each, one of them impossible."""
    case = cageless.Case.from_toml(cageless.template(), {"solver.duration_s": 0.002})
    return cageless.Plan(
        case=case,
        compute=["static", "run"],
        grid={
            "raceway.half_angle_deg": [20.0, 25.0, 170.0],
            "operation.radial_load_n": cageless.span(500.0, 3000.0, 40),
        },
        scatter={"repeats": 2, "bearing.ball_radius_deviation_um": {"normal": 0.5}},
        seed=7,
    )


def figures(page: Path) -> list[Any]:
    """The figures of a report page, as Plotly gets them."""
    text = page.read_text()
    specs = re.findall(r'<script type="application/json" id="[^"]*-spec">(.*?)</script>', text)
    return [json.loads(spec) for spec in specs]


def made(spec: str) -> Any:
    """A figure from the extension module, as a page has it."""
    found = json.loads(spec)
    found["layout"].pop("height")
    return found


def summary_of(folder: Path) -> Any:
    """The values of a result that the command wrote, without the checksums of its tables."""
    values = numbers((folder / "summary.json").read_text())
    values.pop("tables", None)
    return values


def numbers(text: str) -> Any:
    """JSON."""
    return json.loads(text)

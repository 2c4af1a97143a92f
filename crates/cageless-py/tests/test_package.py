"""Types, documentation and examples of the package."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from importlib import resources
from importlib.metadata import entry_points
from pathlib import Path

import cageless
import pytest
from cageless.__main__ import main
from conftest import Command

HERE = Path(__file__).resolve().parent
EXAMPLES = sorted((HERE.parent / "examples").glob("*.py"))
SETTINGS = HERE.parent / "pyproject.toml"


def check(*args: object) -> None:
    done = subprocess.run(
        [sys.executable, "-m", *map(str, args)], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_types_hold_in_package_tests_and_examples() -> None:
    assert (Path(cageless.__file__).parent / "py.typed").exists()
    check("mypy", "--config-file", SETTINGS, HERE.parent / "python", HERE, *EXAMPLES)


@pytest.mark.parametrize("name", ["case-file", "rotor-file", "plan"])
def test_the_schemas_of_files_come_with_the_package(name: str) -> None:
    schema = json.loads((resources.files(cageless) / f"schemas/{name}.schema.json").read_text("utf-8"))
    assert schema["properties"]["schema"]["const"] == 1


@pytest.mark.parametrize("name", sorted(cageless.__all__))
def test_every_name_is_documented(name: str) -> None:
    thing = getattr(cageless, name)
    if isinstance(thing, str):
        return
    assert thing.__doc__, name
    if isinstance(thing, type):
        for key, member in vars(thing).items():
            if not key.startswith("_") and (callable(member) or isinstance(member, property)):
                assert member.__doc__, f"{name}.{key}"


def test_the_command_comes_with_the_package(command: Command, tmp_path: Path) -> None:
    def installed(*args: object) -> subprocess.CompletedProcess[str]:
        words = [sys.executable, "-m", "cageless", *map(str, args)]
        return subprocess.run(words, capture_output=True, text=True, check=False)

    case = tmp_path / "case.toml"
    case.write_text(command("new").stdout)
    for words in (["--version"], ["check", case], ["static", case, "--json"]):
        done = installed(*words)
        assert (done.returncode, done.stdout) == (0, command(*words).stdout), done.stderr
    done = installed("check", tmp_path / "missing.toml")
    assert done.returncode == 2 and "missing.toml" in done.stderr
    (script,) = entry_points(group="console_scripts", name="cageless")
    assert script.load() is main


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_examples_run_and_leave_their_figures(path: Path, tmp_path: Path) -> None:
    environment = os.environ | {"PYTHONWARNINGS": "error::FutureWarning"}
    done = subprocess.run(
        [sys.executable, str(path)],
        capture_output=True,
        text=True,
        check=False,
        cwd=tmp_path,
        env=environment,
    )
    assert done.returncode == 0, done.stderr
    figures = list(tmp_path.glob("*.html"))
    assert figures, "no figure"
    assert all("Plotly.newPlot" in figure.read_text() for figure in figures)

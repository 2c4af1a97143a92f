"""Notebooks of the documentation, executed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import nbformat
import pytest
from conftest import ROOT
from nbclient import NotebookClient

NOTEBOOKS = sorted((ROOT / "docs" / "notebooks").glob("*.ipynb"))
#: Code cells of a notebook at most.
COMMANDS = 8
#: What a reader waits for, and what a test need not.
SOONER = {
    "full_complement=True).replace(": 'full_complement=True).replace(\n    solver={"method": "verlet", "step_us": "auto"},',
    "case.search(initial_states=1, runs_max=32)": "case.search(\n    axial_span_mm=2.5, half_angle_deg=(7.0, 8.0), initial_states=1, runs_max=32\n)",
    "tolerance(samples=4)": "tolerance(samples=1)",
    "case.drop(samples=8)": "case.drop(samples=2)",
}
#: What each notebook shows, and the files that it leaves with a part of their text.
SHOWN = {
    "beyond-the-paper": (["plane, elastic flanks", "lag_per_pass_deg", "converged"], {}),
    "catalogue-to-drawing": (
        ["<SearchResult: Recommended: lC"],
        {"ring.step": "MANIFOLD_SOLID_BREP", "search.html": "Plotly.newPlot"},
    ),
    "drop-of-a-rotor": (
        ["<Drop: ", "rotor_force_max_over_weight", "eccentricity_phase_deg"],
        {"drop.html": "Plotly.newPlot"},
    ),
}


def outputs(notebook: Any) -> str:
    texts = [
        output.get("data", {}).get("text/plain", "")
        for cell in notebook.cells
        if cell.cell_type == "code"
        for output in cell.outputs
    ]
    return "\n".join(texts)


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs_to_its_end(path: Path, tmp_path: Path) -> None:
    notebook = nbformat.read(path, as_version=4)
    for cell in notebook.cells:
        for slow, soon in SOONER.items():
            cell.source = cell.source.replace(slow, soon)
    client = NotebookClient(
        notebook, timeout=300, resources={"metadata": {"path": str(tmp_path)}}
    )
    client.execute()
    assert len([cell for cell in notebook.cells if cell.cell_type == "code"]) <= COMMANDS
    words, files = SHOWN[path.stem]
    assert not [word for word in words if word not in outputs(notebook)]
    for name, part in files.items():
        assert part in (tmp_path / name).read_text(), name
    # In the repository it has no outputs, which would grow old.
    stored = nbformat.read(path, as_version=4)
    assert not [cell for cell in stored.cells if cell.cell_type == "code" and cell.outputs]


def test_what_is_sooner_is_in_a_notebook() -> None:
    assert [path.stem for path in NOTEBOOKS] == sorted(SHOWN)
    text = "".join(nbformat.writes(nbformat.read(path, as_version=4)) for path in NOTEBOOKS)
    assert not [slow for slow in SOONER if slow not in text]

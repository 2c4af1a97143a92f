"""Notebooks of the documentation, executed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import nbformat
import pytest
from conftest import ROOT
from nbclient import NotebookClient

NOTEBOOKS = sorted((ROOT / "docs" / "notebooks").glob("*.ipynb"))
#: Commands from nothing to the drawing at most.
COMMANDS = 8
#: What a reader waits for, and what a test need not.
SOONER = {
    "case.search(initial_states=1, runs_max=32)": "case.search(\n    axial_span_mm=2.5, half_angle_deg=(7.0, 8.0), initial_states=1, runs_max=32\n)",
    "tolerance(samples=4)": "tolerance(samples=1)",
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
    for slow, soon in SOONER.items():
        cells = [cell for cell in notebook.cells if slow in cell.source]
        assert len(cells) == 1, slow
        cells[0].source = cells[0].source.replace(slow, soon)
    client = NotebookClient(
        notebook, timeout=300, resources={"metadata": {"path": str(tmp_path)}}
    )
    client.execute()
    assert len([cell for cell in notebook.cells if cell.cell_type == "code"]) <= COMMANDS
    assert "<SearchResult: Recommended: lC" in outputs(notebook)
    step = (tmp_path / "ring.step").read_text()
    assert step.startswith("ISO-10303-21;") and "MANIFOLD_SOLID_BREP" in step
    assert "Plotly.newPlot" in (tmp_path / "search.html").read_text()
    # In the repository it has no outputs, which would grow old.
    stored = nbformat.read(path, as_version=4)
    assert not [cell for cell in stored.cells if cell.cell_type == "code" and cell.outputs]


def test_there_is_a_notebook() -> None:
    assert NOTEBOOKS

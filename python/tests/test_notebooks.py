"""The notebooks run from top to bottom, and what they print is what they hold."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

FOLDER = Path(__file__).parents[1] / "examples"


def printed(notebook: Any) -> list[str]:
    """The words of each cell's output, but not those of pictures."""
    outputs = [o for cell in notebook.cells for o in cell.get("outputs", [])]
    return [o["text"] for o in outputs if o["output_type"] == "stream" and o["name"] == "stdout"]


@pytest.mark.parametrize("name", ["compass", "motor", "variance"])
def test_a_notebook_runs_and_prints_what_it_shows(name: str, tmp_path: Path) -> None:
    nbformat = pytest.importorskip("nbformat")
    client = pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    for needed in ("matplotlib",) if name != "variance" else ("control", "scipy"):
        pytest.importorskip(needed)
    notebook = nbformat.read(FOLDER / f"{name}.ipynb", as_version=4)
    shown = printed(notebook)
    assert shown
    client.NotebookClient(
        notebook, timeout=120, kernel_name="python3", resources={"metadata": {"path": str(tmp_path)}}
    ).execute()
    if name != "variance":  # it prints the last digits of other software
        assert printed(notebook) == shown

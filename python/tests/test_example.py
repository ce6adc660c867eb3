"""The example runs, and is typed."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

SERIES = """
import pandas as pd
import polars as pl
import gyrospec

kept = gyrospec.recording({"t": pl.Series([0.0, 1.0]), "roll": pd.Series([1.0, 2.0])}, units={"t": "s"})
swept = gyrospec.roll_error_sweep(T=pl.Series([0.1, 0.2]))
fitted = gyrospec.fit("model.toml", pl.DataFrame({"t [s]": [0.0]}), time=pl.Series([0.0]))
"""
"""Uses of columns that a type checker is to accept."""
EXAMPLE = Path(__file__).parents[1] / "examples" / "notebook.py"


def test_the_example_runs() -> None:
    environment = {**os.environ, "PYTHONIOENCODING": "utf-8"}
    done = subprocess.run(
        [sys.executable, EXAMPLE], capture_output=True, text=True, encoding="utf-8", env=environment
    )
    assert done.returncode == 0, done.stderr
    assert "dry-friction" in done.stdout
    assert "100000 ok" in done.stdout


def test_the_example_and_the_package_are_typed(tmp_path: Path) -> None:
    pytest.importorskip("mypy")
    config = Path(__file__).parents[2] / "pyproject.toml"
    strict = ["mypy", "--strict", "--config-file", config, "--cache-dir", tmp_path / "cache"]
    series = tmp_path / "series.py"
    series.write_text(SERIES, "utf-8")
    # the last: the stubs say what the native half is
    for check in ([*strict, EXAMPLE], [*strict, series], [*strict, "-p", "gyrospec"], ["mypy.stubtest", "gyrospec._gyrospec"]):
        done = subprocess.run(
            [sys.executable, "-m", *check], capture_output=True, text=True, cwd=tmp_path, check=False
        )
        assert done.returncode == 0, done.stdout

"""Pictures, frames and datasets of results."""

from __future__ import annotations

import pickle
import sys
from collections.abc import Iterator
from typing import Any

import gyrospec
import numpy as np
import pandas as pd
import pytest

T = np.arange(0.0, 30.0, 0.05)
MODEL = """
name = "lag"
[inputs]
u = { unit = "V" }
[parameters]
T = { value = 1.0, unit = "s", fit = true, min = 0.01 }
[states]
x = { unit = "V", initial = 0.0, rate = "(u - x)/T" }
[outputs]
y = { unit = "V", equals = "x" }
"""


@pytest.fixture
def recorded() -> dict[str, Any]:
    u = np.where((T % 7) < 3.5, 1.0, -1.0)
    y = np.zeros_like(T)
    # exact for an input that holds
    for k in range(1, len(T)):
        y[k] = u[k - 1] + (y[k - 1] - u[k - 1]) * np.exp(-0.05 / 1.4)
    return {"t": T, "u": u, "y": y + 0.01 * np.random.default_rng(7).standard_normal(len(T))}


UNITS = {"t": "s", "u": "V", "y": "V"}


@pytest.fixture
def drawing() -> Iterator[Any]:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    yield matplotlib
    import matplotlib.pyplot as plt

    plt.close("all")


def held(recorded: dict[str, Any]) -> gyrospec.Recording:
    return gyrospec.recording(recorded, units=UNITS, hold="u")


def test_results_are_drawn(recorded: dict[str, Any], drawing: Any) -> None:
    recording = held(recorded)
    simulation, fit = gyrospec.simulate(MODEL, recording), gyrospec.fit(MODEL, recording)
    diagnosis = gyrospec.diagnose(MODEL, recording)
    assert diagnosis.verdict == "nothing-missing", diagnosis.says
    for result, lines in ((simulation, 2), (fit, 2), (diagnosis, 3)):
        signal, rest = result.plot().axes
        drawn = signal.get_lines()
        assert len(drawn) == lines and signal.get_ylabel() == "y [V]"
        measured = next(line for line in drawn if line.get_label() == "measured")
        assert np.array_equal(measured.get_ydata(), recorded["y"])
        assert rest.get_xlabel() == "time [s]"
    # what is left of the fit is the noise
    left = fit.plot().axes[1].get_lines()[0].get_ydata()
    assert np.std(left) == pytest.approx(0.01, rel=0.1)
    with pytest.raises(gyrospec.UsageError, match="pickle"):
        pickle.loads(pickle.dumps(fit)).plot()


def test_results_are_frames(recorded: dict[str, Any]) -> None:
    recording = held(recorded)
    frame = gyrospec.simulate(MODEL, recording).to_pandas()
    assert frame.index.name == "time" and np.array_equal(frame.index, T)
    assert np.array_equal(frame["y measured"], recorded["y"])
    assert np.allclose(frame["y residual"], frame["y measured"] - frame["y predicted"])
    fit = gyrospec.fit(MODEL, recording)
    assert fit.to_pandas().loc["T", "value"] == fit["T"].value
    assert list(gyrospec.diagnose(MODEL, recording).to_pandas()) == ["code", "site", "name", "value", "low", "high", "unit"]


def test_without_matplotlib_and_pandas_the_way_is_told(recorded: dict[str, Any], monkeypatch: pytest.MonkeyPatch) -> None:
    simulation = gyrospec.simulate(MODEL, held(recorded))
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(gyrospec.UsageError, match="pip install matplotlib"):
        simulation.plot()
    with pytest.raises(gyrospec.UsageError, match="pip install pandas"):
        simulation.to_pandas()


def test_xarray_keeps_its_coordinate_and_its_units(recorded: dict[str, Any]) -> None:
    xarray = pytest.importorskip("xarray")
    dataset = xarray.Dataset({n: ("t", recorded[n], {"units": "V"}) for n in ("u", "y")}, coords={"t": T})
    dataset["t"].attrs["units"] = "s"
    plain = gyrospec.recording(recorded, units=UNITS)
    dated = dataset.assign_coords(t=pd.Timestamp("2024-05-01") + pd.to_timedelta(T, unit="s"))
    for given in (gyrospec.recording(dataset), gyrospec.recording(dated), gyrospec.recording(dataset, units=UNITS)):
        for name in ("u", "y"):
            for a, b in zip(given.channel(name), plain.channel(name), strict=True):
                assert np.allclose(a, b, atol=1e-9)
    back = gyrospec.simulate(MODEL, dataset).to_xarray()
    assert back["y predicted"].dims == ("time",) and back["y predicted"].attrs["units"] == "V"
    one = gyrospec.recording(dataset["y"])
    assert one.channels == ["y"] and np.array_equal(one.channel("y")[1], recorded["y"])
    with pytest.raises(gyrospec.InputError, match="one of time is wanted"):
        gyrospec.recording(dataset.expand_dims(run=2))

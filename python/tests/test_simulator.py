"""A simulator whose equations nobody knows: fitted by whole runs, diagnosed by its output."""

from __future__ import annotations

from typing import Any

import gyrospec
import numpy as np
import pytest
from scipy import signal

T = np.arange(0.0, 80.0, 0.05)
U = np.sin(0.6 * T) + 0.7 * np.sin(1.7 * T + 1) + 0.4 * np.sin(3.1 * T)


def lagging(t: Any, u: dict[str, Any], p: dict[str, float]) -> dict[str, Any]:
    """x' = (gain u - x)/T, by SciPy."""
    _, y, _ = signal.lsim(signal.lti([p["gain"]], [p["T"], 1.0]), u["u"], t)
    return {"y": y}


def recorded(late: float, seed: int) -> gyrospec.Recording:
    fine = np.arange(0.0, 80.0, 0.005)
    _, y, _ = signal.lsim(signal.lti([2.0], [1.5, 1.0]), np.interp(fine, T, U), fine)
    y = np.interp(T - late, fine, y) + 0.01 * np.random.default_rng(seed).standard_normal(len(T))
    return gyrospec.recording({"t": T, "u": U, "y": y}, units={"t": "s", "u": "V", "y": "V"})


PARAMETERS: dict[str, Any] = {"gain": 1.0, "T": {"value": 1.0, "min": 0.01}}


def test_its_parameters_are_fitted_and_nothing_is_missing() -> None:
    with pytest.warns(gyrospec.Warning, match="fitted by .* whole runs") as told:
        found = gyrospec.diagnose(simulator=lagging, recordings=recorded(0.0, 1), inputs=["u"], outputs=["y"], parameters=PARAMETERS)
    assert found.verdict == "nothing-missing", found.says
    words = str(told[0].message)
    gain, lag = (float(part.split("= ")[1]) for part in words.split(": ")[1].split(", "))
    assert gain == pytest.approx(2.0, rel=0.01) and lag == pytest.approx(1.5, rel=0.01)


def test_an_offset_beside_it_is_named() -> None:
    recording = recorded(0.0, 2)
    t, y = recording.channel("y")
    biased = gyrospec.recording({"t": t, "u": U, "y": y + 0.3}, units={"t": "s", "u": "V", "y": "V"})
    with pytest.warns(gyrospec.Warning):
        found = gyrospec.diagnose(simulator=lagging, recordings=biased, inputs=["u"], outputs=["y"], parameters=PARAMETERS)
    assert found.verdict == "named" and found.findings[0].code == "output-offset", found.says


@pytest.mark.parametrize(
    ("call", "change", "words"),
    [
        (lambda t, u, p: {"z": t}, {}, "gives no `y`"),
        (lambda t, u, p: {"y": t[:-1]}, {}, "shape"),
        (lambda t, u, p: {"y": t * np.nan}, {}, "no number from t = 0 s"),
        (lambda t, u, p: {}["y"], {}, "fails at .*KeyError"),
        (lagging, {"inputs": ["wind"]}, "no channel `wind`"),
        (lagging, {"outputs": []}, "needs outputs"),
        (lagging, {"parameters": {"gain": "two"}}, "two"),
        (lagging, {"model": "m.toml"}, "takes the place"),
        (lagging, {"recordings": None}, "give a recording"),
    ],
)
def test_what_goes_wrong_in_it_is_told(call: Any, change: dict[str, Any], words: str) -> None:
    given = {"simulator": call, "recordings": recorded(0.0, 3), "inputs": ["u"], "outputs": ["y"], "parameters": PARAMETERS}
    with pytest.raises(gyrospec.Error, match=words):
        gyrospec.diagnose(**{**given, **change})

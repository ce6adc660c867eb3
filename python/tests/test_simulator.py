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


@pytest.mark.parametrize("seed", range(3))
def test_a_constant_that_its_parameters_bend_for_is_named_with_its_size(seed: int) -> None:
    rng = np.random.default_rng(seed)
    t = np.arange(0.0, 40.0, 0.02)
    u = np.convolve(rng.normal(0, 30, len(t)), np.ones(30) / 5, "same")
    y = lagging(t, {"u": u}, {"gain": 2.0, "T": 0.7})["y"] + 0.4 + rng.normal(0, 0.05, len(t))
    given: dict[str, Any] = {"inputs": ["u"], "outputs": ["y"], "parameters": {"gain": 1.5, "T": 1.0}}
    with pytest.warns(gyrospec.Warning):
        recording = gyrospec.recording({"t": t, "u": u, "y": y}, units={"t": "s", "u": "V", "y": "V"})
        found = gyrospec.diagnose(simulator=lagging, recordings=recording, **given)
    assert found.verdict == "named" and found.findings[0].code == "output-offset", found.says
    (b,) = found.findings[0].parameters
    assert b.low - 0.005 < 0.4 < b.high + 0.005

    # a parameter that starts at 0 is fitted too, also where the output's unit has a zero of its own
    def above(t: Any, u: dict[str, Any], p: dict[str, float]) -> dict[str, Any]:
        return {"y": lagging(t, u, p)["y"] + p["zero"]}

    given["parameters"]["zero"] = 0.0
    with pytest.warns(gyrospec.Warning, match=r"zero = 0\.(39|40)"):
        recording = gyrospec.recording({"t": t, "u": u, "y": y}, units={"t": "s", "u": "V", "y": "degC"})
        found = gyrospec.diagnose(simulator=above, recordings=recording, **given)
    assert found.verdict == "nothing-missing", found.says


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

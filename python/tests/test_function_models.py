"""Models from Python functions: traced once, against SciPy's solution of the same function."""

from __future__ import annotations

import inspect
import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import gyrospec
import numpy as np
import pandas as pd
import pytest
from scipy.integrate import solve_ivp

T = np.arange(0.0, 12.0, 0.02)


def force(t: Any) -> Any:
    return 3.0 * np.sin(1.1 * t) + 2.0 * np.sin(2.7 * t + 1.0)


def axis(t, x, u, p):  # type: ignore[no-untyped-def]
    return {"q": x.v, "v": (u.force - p.Fv * x.v - p.k * x.q) / p.M}, {"position": x.q}


AXIS: dict[str, Any] = {
    "states": {"q": "m", "v": "m/s"},
    "inputs": {"force": "N"},
    "outputs": {"position": "m"},
    "parameters": {"M": {"value": 3.0, "unit": "kg", "fit": True, "min": 0.1}, "Fv": 3.0, "k": 100.0},
}


def solved(
    rates: Callable[[float, Any, float], list[Any]], start: list[float], t: np.ndarray[Any, Any] = T
) -> np.ndarray[Any, Any]:
    """The states at the times; the input runs straight between its samples, as the program reads it."""
    samples = force(t)

    def f(at: float, x: Any) -> list[Any]:
        return rates(at, x, float(np.interp(at, t, samples)))

    found = solve_ivp(f, (t[0], t[-1]), start, t_eval=t, rtol=1e-11, atol=1e-12, max_step=0.005)
    assert found.success
    return np.asarray(found.y)


def test_the_function_of_the_manual_becomes_a_model_whose_units_are_completed() -> None:
    model = gyrospec.model(axis, **AXIS)
    assert model == gyrospec.Model.parse(model.to_toml())
    assert model.name == "axis" and model.parameters == {"M": 3.0, "Fv": 3.0, "k": 100.0}
    # N = Fv m/s and N = k m
    assert (model.units["Fv"], model.units["k"]) == ("kg/s", "N/m")
    assert "fit = true" in model.to_toml() and 'initial = "fit"' in model.to_toml()


def test_names_items_and_places_reach_the_same() -> None:
    def by_item(t, x, u, p):  # type: ignore[no-untyped-def]
        return [x["v"], (u["force"] - p["Fv"] * x["v"] - p["k"] * x["q"]) / p["M"]], [x["q"]]

    def by_place(t, x, u, p):  # type: ignore[no-untyped-def]
        (q, v), (f,), (m, d, k) = x, u, p
        return np.array([v, (f - d * v - k * q) / m]), (x[0],)

    named = gyrospec.model(axis, **AXIS, name="one")
    assert named == gyrospec.model(by_item, **AXIS, name="one") == gyrospec.model(by_place, **AXIS, name="one")


def everything(np_: Any, q: Any, v: Any, u: Any, c: Any) -> Any:
    """Every function, with values where it is smooth or at least continuous."""
    one = np_.sin(q) * np_.cos(v) + np_.tan(q / 9) - np_.exp(-(q**2)) + np_.log(4 + q) + np_.sqrt(9 + v)
    two = np_.arctan(q) + np_.arctan2(q, 3.0) + np_.arcsin(q / 9) + np_.arccos(q / 9) + np_.sinh(q / 5) + np_.cosh(q / 5)
    three = np_.tanh(v) + np_.abs(v) + np_.maximum(q, 0.1) + np_.minimum(v, 0.2) + np_.clip(q, -0.5, 0.5)
    four = np_.where(q > 0, q**2, -q) + np_.where((q > 0.1) & (v < 0.3) | ~(q < 5), q - 0.1, 0.0) * 0
    five = np_.interp(q, [-1.0, 0.0, 2.0], [2.0, 0.0, 1.0]) + np_.hypot(q, v) + np_.square(v) + np_.reciprocal(5 + q)
    six = np_.log10(5 + q) + np_.log2(5 + q) + np_.log1p(q / 9) + np_.expm1(q / 9) + np_.exp2(q / 9) + np_.cbrt(5 + q)
    seven = np_.arcsinh(q) + np_.arccosh(5 + q) + np_.arctanh(q / 9) + np_.deg2rad(q) + np_.rad2deg(q) / 99
    vector = np_.array([[0.0, 1.0], [-2.0, 0.5]]) @ np_.array([q, v])
    eight = vector[0] - vector[1] + np_.dot([q, v], [1.0, -1.0]) + np_.sum(np_.sin(np_.array([q, v])))
    return u - c * v - (-q) - 2 * q + 0.1 * (one + two + three + four + five + six + seven + eight) + +q * abs(q) / 5


def test_the_models_of_the_page_are_read_and_units_follow() -> None:
    page = (Path(__file__).parents[2] / "docs/how-to/python.md").read_text(encoding="utf-8")
    section = page.split("## A model as a function")[1].split("\n## ")[0]
    first, second = re.findall(r"```python\n(.*?)```", section, re.DOTALL)
    names: dict[str, Any] = {"gyrospec": gyrospec}
    exec(first, names)
    assert "unit" not in names["model"].to_toml()
    exec(second, names)
    # N*m = d rad/s and N*m = k
    assert (names["model"].units["d"], names["model"].units["k"]) == ("N*m*s", "N*m")


def test_numpy_means_in_the_model_what_it_means_in_python() -> None:
    def traced(t, x, u, p):  # type: ignore[no-untyped-def]
        a = everything(np, x.q, x.v, u.force, p.c)
        return [x.v, a - 4 * x.q], [x.q, a, np.heaviside(x.q, 0.5), np.where(x.v > 0, 1.0, -1.0)]

    start = {"q": {"initial": 0.1}, "v": {"initial": 0.0}}
    outputs = ["y", "a", "right", "way"]
    model = gyrospec.model(traced, states=start, inputs=["force"], outputs=outputs, parameters={"c": 1.5})
    q, v = solved(lambda t, x, u: [x[1], everything(np, x[0], x[1], u, 1.5) - 4 * x[0]], [0.1, 0.0])
    ran = gyrospec.simulate(model, {"t [s]": T, "force [1]": force(T)}, tolerance=1e-8)
    assert np.abs(ran["y"].predicted - q).max() < 1e-6
    wanted = [everything(np, *now, 1.5) for now in zip(q, v, force(T), strict=True)]
    assert np.abs(ran["a"].predicted - wanted).max() < 1e-4
    clear = np.abs(q) > 1e-4
    assert (ran["right"].predicted[clear] == (q[clear] > 0)).all()
    clear = np.abs(v) > 1e-3
    assert (ran["way"].predicted[clear] == np.sign(v[clear])).all()


def test_without_units_nothing_is_checked_and_the_report_says_so() -> None:
    def falling(t, x, u, p):  # type: ignore[no-untyped-def]
        return {"v": u.force - p.d * x.v}, {"v": x.v}

    model = gyrospec.model(falling, states=["v"], inputs=["force"], outputs=["v"], parameters={"d": 0.5})
    assert "unit" not in model.to_toml()
    (v,) = solved(lambda t, x, u: [u - 0.7 * x[0]], [0.0])
    noise = 0.01 * np.random.default_rng(3).standard_normal(len(T))
    told = gyrospec.diagnose(model, pd.DataFrame({"t": T, "force": force(T), "v": v + noise}), units={"t": "s", "force": "1", "v": "1"})
    assert told.verdict == "nothing-missing", told.says
    assert any("no units" in note for note in told.notes)
    found = next(p for p in told.parameters if p.name == "d")
    assert found.low < 0.7 < found.high


def recorded(k3: float, seed: int) -> pd.DataFrame:
    """The axis with a cubic spring that its function leaves out."""
    t = np.arange(0.0, 40.0, 0.02)
    push = 30 * force(t)
    found = solve_ivp(
        lambda at, x: [x[1], (np.interp(at, t, push) - 3.0 * x[1] - 100 * x[0] - k3 * x[0] ** 3) / 3.0],
        (0, t[-1]), [0.0, 0.0], t_eval=t, rtol=1e-8, atol=1e-10, max_step=0.02,
    )  # fmt: skip
    noise = 0.003 * np.random.default_rng(seed).standard_normal(len(t))
    return pd.DataFrame({"t": t, "force": push, "position": found.y[0] + noise})


@pytest.mark.parametrize(("k3", "wanted"), [(0.0, "nothing-missing"), (60.0, "named")])
def test_from_a_function_and_a_frame_to_what_is_missing(k3: float, wanted: str) -> None:
    units = {"t": "s", "force": "N", "position": "m"}
    told = gyrospec.diagnose(gyrospec.model(axis, **AXIS), recorded(k3, 11), units=units)
    assert told.verdict == wanted, told.says
    if k3:
        assert told.findings[0].code == "cubic-stiffness", told.says
        (size,) = told.findings[0].parameters
        assert size.low < k3 < size.high


def here(offset: int) -> int:
    frame = inspect.currentframe()
    assert frame is not None and frame.f_back is not None
    return frame.f_back.f_lineno + offset


def branch(t, x, u, p):  # type: ignore[no-untyped-def]
    if x.q > 0:
        return [1.0], [x.q]
    return [2.0], [x.q]


def of_math(t, x, u, p):  # type: ignore[no-untyped-def]
    return [math.sin(x.q)], [x.q]


def smaller(t, x, u, p):  # type: ignore[no-untyped-def]
    return [min(x.q, 1.0)], [x.q]


def looped(t, x, u, p):  # type: ignore[no-untyped-def]
    return [sum(a for a in x.q)], [x.q]


def steps(t, x, u, p):  # type: ignore[no-untyped-def]
    return [np.floor(x.q)], [x.q]


def equal(t, x, u, p):  # type: ignore[no-untyped-def]
    return [x.q * (x.q == 1.0)], [x.q]


def unknown(t, x, u, p):  # type: ignore[no-untyped-def]
    return [x.speed], [x.q]


def failing(t, x, u, p):  # type: ignore[no-untyped-def]
    return [{}["none"]], [x.q]


@pytest.mark.parametrize(
    ("function", "line", "words"),
    [
        (branch, 1, "np.where"), (of_math, 1, "np.sin"), (smaller, 1, "np.minimum"), (looped, 1, "loop"),
        (steps, 1, "np.floor"), (equal, 1, "never exactly equal"), (unknown, 1, "no state `speed`"), (failing, 1, "KeyError"),
    ],
)  # fmt: skip
def test_what_cannot_be_traced_is_refused_with_its_line(function: Callable[..., Any], line: int, words: str) -> None:
    with pytest.raises(gyrospec.InputError) as refused:
        gyrospec.model(function, states=["q"], outputs=["y"])
    first = inspect.getsourcelines(function)[1]
    assert f"test_function_models.py:{first + line}: " in str(refused.value) and words in str(refused.value)
    assert refused.value.line == first + line


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"outputs": {"a": "m", "b": "m"}}, "nothing for a, b"),
        ({"states": {"q": "m", "v": "m/s", "force": "N"}}, "`force` stands among"),
        ({"inputs": {"the force": "N"}}, "no name"),
        ({"inputs": {"force": "Nq"}}, "Nq"),
        ({"inputs": {"force": "K"}}, "K"),
        ({"parameters": {"M": 3.0, "Fv": 3.0, "k": 1.0}, "inputs": {"force": None}}, "do not tell the unit"),
        ({"parameters": {"M": {"unit": "kg"}, "Fv": 3.0, "k": 1.0}}, "`M` has no value"),
        ({"parameters": {"M": "three", "Fv": 3.0, "k": 1.0}}, "M.value must be a finite number"),
        ({"parameters": [1, 2]}, "dict"),
    ],
)
def test_wrong_calls_are_refused(change: dict[str, Any], words: str) -> None:
    with pytest.raises(gyrospec.Error, match=words):
        gyrospec.model(axis, **{**AXIS, **change})


def test_what_is_used_again_and_again_is_written_once() -> None:
    def chained(t, x, u, p):  # type: ignore[no-untyped-def]
        z = x.q
        for _ in range(40):
            z = (z + z) / 2
        return [-z], [x.q]

    model = gyrospec.model(chained, states={"q": {"initial": 1.0}}, outputs=["y"])
    assert len(model.to_toml()) < 5000
    ran = gyrospec.simulate(model, {"t [s]": T, "y [1]": T})
    assert np.abs(ran["y"].predicted - np.exp(-T)).max() < 1e-6


def test_a_file_and_a_text_are_models_too(tmp_path: Any) -> None:
    model = gyrospec.model(axis, **AXIS)
    (tmp_path / "axis.toml").write_text(model.to_toml())
    assert gyrospec.model(tmp_path / "axis.toml") == model == gyrospec.model(model.to_toml()) == gyrospec.model(model)
    with pytest.raises(gyrospec.UsageError, match="alone"):
        gyrospec.model(model, states=["q"])

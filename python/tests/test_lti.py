"""Linear systems of python-control and SciPy, against Lyapunov's equation and SciPy's own simulation."""

from __future__ import annotations

from typing import Any

import gyrospec
import numpy as np
import pytest
from scipy import linalg, signal

control = pytest.importorskip("control")

A = np.array([[0.0, 1.0], [-4.0, -0.4]])
B = np.array([[0.0], [1.0]])
C = np.array([[2.0, 1.0]])
D = np.array([[0.0]])


def systems() -> list[Any]:
    return [
        control.ss(A, B, C, D),
        control.tf([1.0, 2.0], [1.0, 0.4, 4.0]),
        signal.StateSpace(A, B, C, D),
        signal.lti([1.0, 2.0], [1.0, 0.4, 4.0]),
        signal.lti([2.0, 4.0], [2.0, 0.8, 8.0]),
        signal.lti([1.0, 2.0], [1.0, 0.4, 4.0]).to_zpk(),
    ]


def test_the_variance_at_white_noise_is_that_of_lyapunovs_equation() -> None:
    p = linalg.solve_continuous_lyapunov(A, -B @ B.T)
    for system in systems():
        assert gyrospec.integral(system).value == pytest.approx((C @ p @ C.T)[0, 0], rel=1e-12)
    order = 7
    rng = np.random.default_rng(1)
    a = rng.standard_normal((order, order)) - 4 * np.eye(order)
    b, c = rng.standard_normal((order, 1)), rng.standard_normal((1, order))
    p = linalg.solve_continuous_lyapunov(a, -b @ b.T)
    for system in (signal.StateSpace(a, b, c, D), control.ss(a, b, c, 0)):
        assert gyrospec.integral(system).value == pytest.approx((c @ p @ c.T)[0, 0], rel=1e-9)


@pytest.mark.parametrize("number", range(6))
def test_its_coefficients_are_fitted(number: int) -> None:
    system = systems()[number]
    model = gyrospec.model(system)
    assert (model.inputs, model.outputs) == (["u"], ["y"])
    t = np.arange(0.0, 60.0, 0.05)
    u = np.sin(0.9 * t) + np.sin(2.3 * t + 1) + 0.5 * np.sin(4 * t)
    # the true system is another: 0.55 in the place of 0.4, 5 in that of 4
    true = signal.lti([1.0, 2.0], [1.0, 0.55, 5.0])
    _, y, _ = signal.lsim(true, u, t)
    y = y + 1e-3 * np.random.default_rng(2).standard_normal(len(t))
    fit = gyrospec.fit(model, {"t [s]": t, "u [1]": u, "y [1]": y})
    wanted = {"a21": -5.0, "a22": -0.55, "c11": 2.0} if hasattr(system, "A") else {"a0": 5.0, "a1": 0.55, "b0": 2.0}
    for name, value in wanted.items():
        assert fit[name].value == pytest.approx(value, rel=0.01)


def test_several_inputs_outputs_and_a_direct_path() -> None:
    b, c, d = np.array([[0.0, 0.5], [1.0, 0.0]]), np.array([[2.0, 1.0], [0.0, 3.0]]), np.array([[0.0, 0.7], [0.0, 0.0]])
    model = gyrospec.model(control.ss(A, b, c, d, inputs=["force", "wind speed"], outputs=["y", "z"], states=["q", "v"]), name="two")
    assert (model.name, model.inputs, model.outputs, model.states) == ("two", ["force", "wind_speed"], ["y", "z"], ["q", "v"])
    t = np.arange(0.0, 20.0, 0.01)
    u = np.column_stack([np.sin(t), np.cos(0.7 * t) - 1])
    _, y, _ = signal.lsim(signal.StateSpace(A, b, c, d), u, t)
    text = model.to_toml().replace('"fit"', "0.0")
    ran = gyrospec.simulate(text, {"t [s]": t, "force [1]": u[:, 0], "wind_speed [1]": u[:, 1]}, tolerance=1e-8)
    for name, column in (("y", 0), ("z", 1)):
        assert np.abs(ran[name].predicted - y[:, column]).max() < 1e-5


def test_a_gain_and_a_direct_path_of_a_transfer_function() -> None:
    t = np.arange(0.0, 20.0, 0.01)
    u = np.sin(t)
    for system in (signal.lti([3.0, 1.0, 2.0], [1.0, 0.4, 4.0]), signal.lti([2.0, 1.0, 0.0], [4.0, 1.0, 3.0])):
        _, y, _ = signal.lsim(system, u, t)
        text = gyrospec.model(system).to_toml().replace('"fit"', "0.0")
        assert np.abs(gyrospec.simulate(text, {"t [s]": t, "u [1]": u})["y"].predicted - y).max() < 1e-4
    gain = gyrospec.model(signal.lti([3.0], [1.0]))
    assert np.abs(gyrospec.simulate(gain, {"t [s]": t, "u [1]": u})["y"].predicted - 3 * u).max() < 1e-12


@pytest.mark.parametrize(
    ("system", "words"),
    [
        (lambda: control.tf([1], [1, 2], 0.1), "0.1 s"),
        (lambda: signal.dlti([1], [1, 0.5], dt=0.1), "0.1 s"),
        (lambda: control.tf([1, 2, 1], [1, 2]), "numerator"),
        (lambda: control.tf([[[1], [1]]], [[[1, 1], [1, 2]]]), "2 inputs and 1 outputs"),
    ],
)
def test_what_is_no_such_system_is_refused(system: Any, words: str) -> None:
    for function in (gyrospec.model, gyrospec.integral):
        with pytest.raises(gyrospec.InputError, match=words):
            function(system())


def test_refusals_of_the_integral_stay() -> None:
    with pytest.raises(gyrospec.UnstableError):
        gyrospec.integral(control.tf([1], [1, -2]))
    with pytest.raises(gyrospec.InputError, match="infinite"):
        gyrospec.integral(signal.lti([1, 2], [1, 3]))
    with pytest.raises(gyrospec.UsageError, match="g or c"):
        gyrospec.integral([1, 2, 3])
    with pytest.raises(gyrospec.UsageError, match="coefficients"):
        gyrospec.model(control.tf([1], [1, 2]), parameters={"a": 1})

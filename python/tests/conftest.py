"""What several tests stand on: a damped mass whose dry friction a model can leave out."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

MODEL = """
name = "mass on a spring"
[inputs]
force = { unit = "N" }
[parameters]
M = { value = 2.0, unit = "kg", fit = true, min = 0.1, max = 100.0 }
k = { value = 45.0, unit = "N/m", fit = true, min = 0.1, max = 1e4 }
Fv = { value = 1.5, unit = "N*s/m", fit = true, min = 0.0, max = 100.0 }
[states]
x = { rate = "v", unit = "m", initial = 0.0 }
v = { rate = "(force - k*x - Fv*v)/M", unit = "m/s", initial = 0.0 }
[outputs]
position = { equals = "x", unit = "mm" }
"""

MASS, SPRING, VISCOUS = 2.0, 50.0, 2.0


def voyage(dry: float, seed: int, count: int = 400, step: float = 0.05) -> dict[str, np.ndarray]:
    """Steps M a = F - k x - Fv v - Fd tanh(v/v0) by classical Runge-Kutta, in small steps."""
    rng = np.random.default_rng(seed)
    time = step * np.arange(count)
    force = 12 * np.sin(1.7 * time) + 8 * np.sin(4.1 * time + 1.0) + 5 * rng.standard_normal(count)

    def rate(t: float, y: np.ndarray) -> np.ndarray:
        f = np.interp(t, time, force) - SPRING * y[0] - VISCOUS * y[1] - dry * np.tanh(y[1] / 1e-3)
        return np.array([y[1], f / MASS])

    y, x, parts = np.zeros(2), [0.0], 100
    h = step / parts
    for t in time[:-1]:
        for i in range(parts):
            s = t + i * h
            k1 = rate(s, y)
            k2 = rate(s + h / 2, y + h / 2 * k1)
            k3 = rate(s + h / 2, y + h / 2 * k2)
            k4 = rate(s + h, y + h * k3)
            y = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        x.append(float(y[0]))
    noise = 2e-4 * rng.standard_normal(count)
    return {"t": time, "force": force, "position": 1e3 * (np.array(x) + noise)}


UNITS = {"t": "s", "force": "N", "position": "mm"}


def write(path: Path, columns: dict[str, np.ndarray]) -> Path:
    """As a CSV file with units in its header."""
    head = ",".join(f"{n} [{UNITS[n]}]" for n in columns)
    np.savetxt(
        path, np.column_stack(list(columns.values())), delimiter=",", header=head, comments="", fmt="%.17g"
    )
    return path


@pytest.fixture(scope="session")
def viscous() -> dict[str, np.ndarray]:
    """The motion that the model says."""
    return voyage(0.0, 1)


@pytest.fixture(scope="session")
def dry() -> dict[str, np.ndarray]:
    """The same with dry friction of 3 N."""
    return voyage(3.0, 2)


@pytest.fixture(scope="session")
def model_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The model without dry friction."""
    file = tmp_path_factory.mktemp("model") / "mass.toml"
    file.write_text(MODEL)
    return file

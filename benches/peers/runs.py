"""A driven nonlinear oscillator, x″ + 0.2 x′ + x + x³ = sin t from rest to t = 200, at 2001 times.

Weak damping, yet not chaotic at this drive: the reference is SciPy's DOP853 at a tolerance of 10⁻¹³.
"""

import numpy as np
from timing import seconds

TIMES = np.linspace(0, 200, 2001)

MODEL = """
name = "oscillator"
[inputs]
zero = { unit = "1" }
[parameters]
second = { value = 1.0, unit = "s" }
[states]
x = { rate = "v", unit = "1", initial = 0.0 }
v = { rate = "(sin(t/second) + zero - 0.2*v*second - x - x^3)/second^2", unit = "1/s", initial = 0.0 }
[outputs]
y = { equals = "x", unit = "1" }
"""

DIFFSL = """
u_i { x = 0.0, v = 0.0 }
F_i { v, sin(t) - 0.2*v - x - x*x*x }
out_i { x }
"""


def rates(t: float, s: np.ndarray) -> list[float]:
    return [s[1], np.sin(t) - 0.2 * s[1] - s[0] - s[0] ** 3]


def by_scipy(method: str, tolerance: float):
    from scipy.integrate import solve_ivp

    return lambda: solve_ivp(rates, (0, 200), [0, 0], method, TIMES, rtol=tolerance, atol=tolerance).y[0]


def by_diffsol(tolerance: float):
    import pydiffsol as ds

    ode = ds.Ode(DIFFSL, matrix_type=ds.faer_dense, ode_solver=ds.tsit45)
    ode.rtol = ode.atol = tolerance
    empty = np.array([])

    def run() -> np.ndarray:
        solution = ode.solve_dense(empty, TIMES)
        return np.asarray(solution.ys)[0]

    return run


def by_gyrospec():
    import gyrospec

    columns = {"t": TIMES, "zero": np.zeros_like(TIMES), "y": np.zeros_like(TIMES)}
    log = gyrospec.recording(columns, units={"t": "s", "zero": "1", "y": "1"})
    return lambda: gyrospec.simulate(MODEL, log)["y"].predicted


def main(args) -> None:
    truth = by_scipy("DOP853", 1e-13)()
    print(f"A driven oscillator to t = 200; amplitudes up to {np.abs(truth).max():.2f}:\n")
    print("| | ms a run | largest error |\n|---|---|---|")
    for name, make in (
        ("SciPy, RK45 at 10⁻⁸", lambda: by_scipy("RK45", 1e-8)),
        ("SciPy, LSODA at 10⁻⁸", lambda: by_scipy("LSODA", 1e-8)),
        ("SciPy, DOP853 at 10⁻⁸", lambda: by_scipy("DOP853", 1e-8)),
        ("diffsol, Tsitouras 4(5) at 10⁻⁸", lambda: by_diffsol(1e-8)),
        ("gyrospec, as it comes", by_gyrospec),
    ):
        try:
            run = make()
            error = np.abs(np.asarray(run()) - truth).max()
            print(f"| {name} | {1e3 * seconds(run):.3g} | {error:.0e} |", flush=True)
        except ImportError as e:
            print(f"{name}: not installed ({e})")
    print()

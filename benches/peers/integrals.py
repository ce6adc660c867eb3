"""Variances behind filters: time, error, and what is said where there is no value."""

import contextlib
import io
import warnings
from fractions import Fraction

import numpy as np
from timing import seconds


def exact(h: list[float]) -> Fraction:
    """I_n for G = 1 in rationals, from the moments m_j = (1/2π)∫ ω^(2j)/|H|² dω.

    (1/2π)∫ (jω)^k H(jω)/|H|² dω = (1/2π)∫ (jω)^k/H(−jω) dω is 0 for k < n − 1, as all poles lie to the right, and half a
    residue at infinity, (−1)^(n−1)/(2 a_0), for k = n − 1: n equations for n moments, solved by elimination.
    """
    a = [Fraction(x) for x in h]
    n = len(a) - 1
    rows = []
    for k in range(n):
        row = [Fraction(0)] * n
        for i, c in enumerate(a):
            power = n - i + k
            if power % 2 == 0:
                row[power // 2] += c * (-1) ** (power // 2)
        right = Fraction((-1) ** (n - 1), 2) / a[0] if k == n - 1 else Fraction(0)
        rows.append([*row, right])
    for i in range(n):
        pivot = next(r for r in range(i, n) if rows[r][i] != 0)
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for r in range(n):
            if r != i and rows[r][i] != 0:
                by = rows[r][i] / rows[i][i]
                rows[r] = [x - by * y for x, y in zip(rows[r], rows[i], strict=True)]
    return rows[0][n] / rows[0][0]


def companion(h: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    n = len(h) - 1
    a = np.zeros((n, n))
    a[0] = -h[1:] / h[0]
    a[1:, :-1] += np.eye(n - 1)
    b, row = np.zeros((n, 1)), np.zeros((1, n))
    b[0], row[0, -1] = 1 / h[0], 1.0
    return a, b, row


def by_scipy():
    from scipy.linalg import solve_continuous_lyapunov

    def of(h: np.ndarray) -> float:
        a, b, row = companion(h)
        return float((row @ solve_continuous_lyapunov(a, -b @ b.T) @ row.T)[0, 0])

    return of


def by_control():
    import control

    return lambda h: float(control.norm(control.ss(*companion(h), 0), 2)) ** 2


def by_slicot():
    import slycot

    def of(h: np.ndarray) -> float:
        a, b, row = companion(h)
        return float(slycot.ab13bd("C", "H", len(a), 1, 1, a, b, row, np.zeros((1, 1)))) ** 2

    return of


def by_quad():
    from scipy.integrate import quad

    def of(h: np.ndarray) -> float:
        return quad(lambda w: 1 / abs(np.polyval(h, 1j * w)) ** 2, 0, np.inf, limit=500, epsabs=0)[0] / np.pi

    return of


def by_gyrospec():
    import gyrospec

    zeros = {}

    def of(h: np.ndarray) -> float:
        g = zeros.setdefault(len(h), np.eye(1, len(h) - 1, len(h) - 2)[0])
        return gyrospec.integral(h, g).value

    return of


ROUTES = {
    "SciPy, Lyapunov": by_scipy, "SciPy, quad": by_quad, "python-control, `norm`": by_control,
    "SLICOT AB13BD (slycot)": by_slicot, "gyrospec": by_gyrospec,
}


def polynomial(pairs: list[tuple[float, float]]) -> np.ndarray:
    h = np.ones(1)
    for w, z in pairs:
        h = np.convolve(h, [1, 2 * z * w, w * w])
    return h


def family(name: str, rng: np.random.Generator) -> np.ndarray:
    def well(n):
        return [(rng.uniform(0.3, 3), rng.uniform(0.2, 0.9)) for _ in range(n // 2)]

    if name.startswith("well"):
        return polynomial(well(int(name.split("n = ")[1])))
    if name.startswith("over 8"):
        return polynomial([(10 ** rng.uniform(-4, 4), rng.uniform(0.2, 0.9)) for _ in range(10)])
    return polynomial([*well(8), (rng.uniform(0.3, 3), 1e-6)])


FAMILIES = ["well damped, n = 4", "well damped, n = 10", "over 8 decades, n = 20", "one damping of 10⁻⁶, n = 10"]
# stable or not, and what is asked of each
NO_VALUE = {
    "unstable, s² − 0.2 s + 1": [1.0, -0.2, 1.0],
    "on the axis, s² + 1": [1.0, 0.0, 1.0],
    "stable, ω = 10⁻⁶, damping 0.005": [1.0, 1e-8, 1e-12],
    "stable, one pole at 10⁻⁹": [1.0, 1e-9],
}


def quietly(route, h: np.ndarray) -> str | float:
    """The answer, or in words what was raised or warned of."""
    with warnings.catch_warnings(record=True) as caught, contextlib.redirect_stdout(io.StringIO()):
        warnings.simplefilter("always")
        try:
            value = route(h)
        except Exception as e:  # noqa: BLE001: any refusal is one
            return type(e).__name__
    return f"{value:.3g}, warned" if caught else value


def main(args) -> None:
    routes = {}
    for name, make in ROUTES.items():
        try:
            routes[name] = make()
        except ImportError as e:
            print(f"{name}: not installed ({e})")
    print("Microseconds a call; median/maximum relative error of what was answered without a word, against exact rationals "
          "over 20 filters; how many of these are off by more than 1 %; how many were refused or warned of:\n")
    print("| | " + " | ".join(FAMILIES) + " |\n|---|" + "---|" * len(FAMILIES))
    cases = {f: [family(f, np.random.default_rng(k)) for k in range(20)] for f in FAMILIES}
    truth = {f: [exact(h.tolist()) for h in hs] for f, hs in cases.items()}
    for name, route in routes.items():
        cells = []
        for f in FAMILIES:
            got = [quietly(route, h) for h in cases[f]]
            answered = [(v, t) for v, t in zip(got, truth[f], strict=True) if isinstance(v, float)]
            errors = [abs(float((Fraction(v) - t) / t)) if np.isfinite(v) else np.inf for v, t in answered]
            silent, refused = sum(e > 0.01 for e in errors), len(got) - len(answered)
            spent = 1e6 * seconds(lambda: quietly(route, cases[f][0]) if refused else route(cases[f][0]))  # noqa: B023
            shown = f"{np.median(errors):.0e}/{max(errors):.0e}" if errors else "–"
            cells.append(f"{spent:.3g} µs; {shown}; {silent}; {refused}")
        print(f"| {name} | " + " | ".join(cells) + " |", flush=True)
    print("\nWhere there is no value, or an extreme one:\n")
    print("| | " + " | ".join(NO_VALUE) + " |\n|---|" + "---|" * len(NO_VALUE))
    values = []
    for h in NO_VALUE.values():
        stable = h[1] > 0
        values.append(f"{float(exact(h)):.3g}" if stable else "none")
    print("| truth | " + " | ".join(values) + " |")
    for name, route in routes.items():
        answers = [quietly(route, np.array(h)) for h in NO_VALUE.values()]
        print(f"| {name} | " + " | ".join(a if isinstance(a, str) else f"{a:.3g}" for a in answers) + " |")
    print(flush=True)

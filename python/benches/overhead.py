"""What a call costs, and how many integrals a second come out, beside SciPy and python-control.

    python python/benches/overhead.py [--rows 200000] [--order 4]

All figures come from one run on one machine. The others' routes: SciPy solves A P + P Aᵀ + B Bᵀ = 0
of the companion form; python-control does the same behind `ss` and `lyap` (or SLICOT where it is
installed). The worst difference from gyrospec's exact tier stands beside each.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from typing import Any

import gyrospec
import numpy as np
from numpy.typing import NDArray

Rows = NDArray[np.float64]


def filters(order: int, rows: int) -> tuple[Rows, Rows, Rows]:
    """Well damped filters H, numerators C, and G = C(s)C(−s) for C of one coefficient."""
    rng = np.random.default_rng(1)
    h = np.ones((rows, 1))
    for _ in range(order // 2):
        w, z = rng.uniform(0.3, 3, rows), rng.uniform(0.2, 0.9, rows)
        h = times(h, np.column_stack([np.ones(rows), 2 * z * w, w * w]))
    if order % 2:
        h = times(h, np.column_stack([np.ones(rows), rng.uniform(0.3, 3, rows)]))
    c = rng.uniform(0.5, 2, rows)
    g = np.zeros((rows, order))
    g[:, -1] = c * c
    return h, c, g


def times(a: Rows, b: Rows) -> Rows:
    """Products of polynomials, row by row."""
    out = np.zeros((len(a), a.shape[1] + b.shape[1] - 1))
    for i in range(a.shape[1]):
        for j in range(b.shape[1]):
            out[:, i + j] += a[:, i] * b[:, j]
    return out


def companion(h: Rows) -> tuple[Rows, Rows, Rows]:
    """A, B, C of 1/H."""
    n = len(h) - 1
    a = np.zeros((n, n))
    a[0] = -h[1:] / h[0]
    a[1:, :-1] += np.eye(n - 1)
    b, row = np.zeros((n, 1)), np.zeros((1, n))
    b[0], row[0, -1] = 1 / h[0], 1.0
    return a, b, row


def by_scipy(h: Rows, c: float) -> float:
    """The Lyapunov route."""
    from scipy.linalg import solve_continuous_lyapunov

    a, b, row = companion(h)
    return c * c * float((row @ solve_continuous_lyapunov(a, -b @ b.T) @ row.T)[0, 0])


def by_control(h: Rows, c: float) -> float:
    """python-control: the square of the H₂ norm, where it has one, else by its `lyap`."""
    import control

    a, b, row = companion(h)
    return c * c * float((row @ control.lyap(a, b @ b.T) @ row.T)[0, 0])


def seconds(work: Callable[[], Any], least: float = 0.3) -> float:
    """The shortest of five means."""
    number = 1
    while True:
        start = time.perf_counter()
        for _ in range(number):
            work()
        if time.perf_counter() - start > least / 5:
            break
        number *= 2
    best = float("inf")
    for _ in range(5):
        start = time.perf_counter()
        for _ in range(number):
            work()
        best = min(best, (time.perf_counter() - start) / number)
    return best


def main() -> None:
    """Prints a table."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--rows", type=int, default=200_000)
    parser.add_argument("--order", type=int, default=4)
    a = parser.parse_args()
    h, c, g = filters(a.order, a.rows)
    print(f"order {a.order}, {a.rows} filters, gyrospec {gyrospec.__version__}, NumPy {np.__version__}\n")

    first_h, first_g = h[0], g[0]
    lists = first_h.tolist(), first_g.tolist()
    print("one call                                  µs")
    print(f"  a Python function that does nothing  {1e6 * seconds(lambda: abs(-1.0)):6.2f}")
    print(
        f"  integral, from arrays                {1e6 * seconds(lambda: gyrospec.integral(first_h, first_g)):6.2f}"
    )
    print(f"  integral, from lists                 {1e6 * seconds(lambda: gyrospec.integral(*lists)):6.2f}")
    one = a.rows / seconds(lambda: gyrospec.integral_batch(h, g), 0.1)
    inside = 1e6 * seconds(lambda: gyrospec.integral_batch(h[:4000], g[:4000], fast=False)) / 4000
    print(f"  the integral itself, inside a batch  {inside:6.2f}   (both cores)\n")

    some = range(min(a.rows, 2000))
    exact = gyrospec.integral_batch(h[: len(some)], g[: len(some)], fast=False).value
    print("from NumPy arrays               integrals/s   of SciPy   worst difference from exact")
    base = 0.0
    for name, route in (("SciPy, Lyapunov", by_scipy), ("python-control, lyap", by_control)):
        try:
            values = np.array([route(h[i], c[i]) for i in some])
        except ImportError:
            print(f"  {name:28} not installed")
            continue
        rate = len(some) / seconds(lambda: [route(h[i], c[i]) for i in some], 0.5)  # noqa: B023
        base = base or rate
        told(name, rate, base, values, exact)
    for name, fast in (("integral_batch", True), ("integral_batch, fast=False", False)):
        rows = a.rows if fast else min(a.rows, 50_000)
        rate = (
            one
            if fast
            else rows / seconds(lambda: gyrospec.integral_batch(h[:rows], g[:rows], fast=False), 0.1)
        )  # noqa: B023
        values = gyrospec.integral_batch(h[: len(some)], g[: len(some)], fast=fast).value
        told(name, rate, base or rate, values, exact)


def told(name: str, rate: float, base: float, values: Rows, exact: Rows) -> None:
    """One line."""
    worst = float(np.max(np.abs(values / exact - 1)))
    print(f"  {name:28} {rate:12,.0f} {rate / base:10,.1f}   {worst:.1e}")


if __name__ == "__main__":
    main()

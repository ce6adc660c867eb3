"""The integral with letters: the quotient of I_n in its coefficients."""

import time


def by_sympy(n: int) -> float:
    import sympy as sp

    a = sp.symbols(f"a0:{n + 1}")
    b = sp.symbols(f"b0:{n}")
    hurwitz = sp.Matrix(n, n, lambda i, j: a[2 * j + 1 - i] if 0 <= 2 * j + 1 - i <= n else 0)
    upper = hurwitz.copy()
    for j in range(n):
        upper[0, j] = b[j]
    start = time.perf_counter()
    sp.factor(upper.det(method="berkowitz") / (a[0] * hurwitz.det(method="berkowitz")))
    return time.perf_counter() - start


def by_gyrospec(n: int) -> float:
    import gyrospec

    start = time.perf_counter()
    gyrospec.table(f"{n}..{n}")
    return time.perf_counter() - start


def main(args) -> None:
    orders = [3, 4, 5, 6]
    print("I_n with letters, seconds:\n\n| | " + " | ".join(f"n = {n}" for n in [*orders, 10]) + " |\n|---|" + "---|" * 5)
    for name, of, asked in (("sympy, determinants and factor", by_sympy, orders), ("gyrospec", by_gyrospec, [*orders, 10])):
        try:
            cells = [f"{of(n):.2g}" for n in asked]
        except ImportError as e:
            print(f"{name}: not installed ({e})")
            continue
        print(f"| {name} | " + " | ".join(cells + ["not tried"] * (5 - len(cells))) + " |", flush=True)
    print()

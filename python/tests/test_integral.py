"""The integral against fractions, mpmath and SciPy's Lyapunov equation."""

from __future__ import annotations

import json
import pickle
from fractions import Fraction

import gyrospec
import mpmath
import numpy as np
import pytest
from scipy.linalg import solve_continuous_lyapunov


def lyapunov(h: np.ndarray, c: np.ndarray) -> float:
    """The variance behind C/H by A P + P Aᵀ + B Bᵀ = 0 of the companion form."""
    n = len(h) - 1
    a = np.zeros((n, n))
    a[0] = -np.asarray(h[1:]) / h[0]
    a[1:, :-1] += np.eye(n - 1)
    b = np.zeros((n, 1))
    b[0] = 1.0 / h[0]
    row = np.concatenate([np.zeros(n - len(c)), c])[None, :]
    return float((row @ solve_continuous_lyapunov(a, -b @ b.T) @ row.T)[0, 0])


def stable(rng: np.random.Generator, n: int) -> np.ndarray:
    """A polynomial with roots in the left half plane."""
    pairs = [
        np.poly1d([1.0, 2 * z * w, w * w])
        for z, w in zip(rng.uniform(0.1, 0.9, n // 2), rng.uniform(0.3, 3, n // 2), strict=True)
    ]
    product = np.poly1d([1.0, rng.uniform(0.3, 3)] if n % 2 else [1.0])
    for p in pairs:
        product = product * p
    return np.asarray(product.coeffs)


def test_second_and_third_order_equal_their_formulas_in_fractions() -> None:
    a0, a1, a2, b0, b1 = (Fraction(x) for x in ("1/4", "3", "5/2", "7/8", "2"))
    exact = (-b0 + a0 * b1 / a2) / (2 * a0 * a1)
    answer = gyrospec.integral([float(a0), float(a1), float(a2)], [float(b0), float(b1)])
    assert abs(Fraction(answer.value) - exact) <= Fraction(answer.error_bound)
    assert abs(Fraction(answer.value) / exact - 1) < Fraction(1, 2**51)


@pytest.mark.parametrize("n", [1, 2, 3, 5, 8])
def test_the_value_is_the_covariance_of_the_lyapunov_equation(n: int) -> None:
    rng = np.random.default_rng(n)
    h, c = stable(rng, n), rng.uniform(-1, 1, n)
    assert gyrospec.integral(h, c=c).value == pytest.approx(lyapunov(h, c), rel=1e-9)


def test_the_value_is_the_quadrature_of_mpmath() -> None:
    h, g = [1.0, 3.0, 7.0, 5.0], [0.5, -2.0, 3.0]
    mpmath.mp.dps = 30

    def integrand(w: mpmath.mpf) -> mpmath.mpf:
        s = mpmath.mpc(0, w)
        top = sum(b * s ** (2 * (2 - k)) for k, b in enumerate(g))
        bottom = abs(sum(a * s ** (3 - k) for k, a in enumerate(h))) ** 2
        return top.real / bottom

    wanted = mpmath.quad(integrand, [0, 1, 2, 5, 20, mpmath.inf]) / mpmath.pi
    assert gyrospec.integral(h, g).value == pytest.approx(float(wanted), rel=1e-14)


@pytest.mark.parametrize(
    "kind", [list, tuple, np.array, lambda x: np.array(x, dtype=np.float32), lambda x: np.array(x, dtype=int)]
)
def test_any_row_of_numbers_is_taken(kind: object) -> None:
    assert gyrospec.integral(kind([1, 2, 3]), kind([0, 1])).value == 1 / 12  # type: ignore[operator]
    assert gyrospec.integral(np.array([1.0, 9, 2, 9, 3])[::2], [0, 1]).value == 1 / 12


def test_an_answer_has_the_fields_of_the_program() -> None:
    answer = gyrospec.integral([1, 2, 3], [0, 1])
    assert answer.to_dict() == json.loads(answer.to_json())
    assert answer.to_dict()["value"] == answer.value == float(answer)
    assert "0.0833" in repr(answer) and "0.0833" in answer._repr_html_()


def test_refusals_say_what_the_program_says() -> None:
    with pytest.raises(gyrospec.UnstableError) as unstable:
        gyrospec.integral([1, -0.2, 1], [0, 1])
    assert unstable.value.right_half_plane_roots == 2
    assert isinstance(unstable.value, ArithmeticError)
    with pytest.raises(gyrospec.ImaginaryAxisError):
        gyrospec.integral([1, 0, 1], [0, 1])
    with pytest.raises(gyrospec.OutOfRangeError) as large:
        gyrospec.integral([1e-300, 1e-300], [1e300])
    assert large.value.decimal.startswith("5")
    with pytest.raises(ValueError, match="g has 3 coefficients"):
        gyrospec.integral([1, 2, 3], [0, 1, 2])
    with pytest.raises(gyrospec.UsageError, match="g or c"):
        gyrospec.integral([1, 2, 3])
    for wrong in ("1 2 3", [1, "x"], np.array([1, 2j]), None, [[1.0]]):
        with pytest.raises(TypeError, match="h must be a row of real numbers"):
            gyrospec.integral(wrong, [0, 1])  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="h is a masked array"):
        gyrospec.integral(np.ma.array([1.0, 2.0, 3.0], mask=[False, True, False]), [0, 1])
    assert pickle.loads(pickle.dumps(unstable.value)).right_half_plane_roots == 2


@pytest.mark.parametrize("fast", [True, False])
def test_a_batch_is_the_integrals_one_by_one(fast: bool) -> None:
    rng = np.random.default_rng(5)
    h = np.array([stable(rng, 4) for _ in range(5000)])
    g = rng.uniform(-1, 1, (5000, 4))
    h[7, 1] = -1.0
    h[9] = [1, 0, 2, 0, 1]
    h[11, 2] = np.nan
    many = gyrospec.integral_batch(h, g, fast=fast)
    assert many.counts() == {"ok": 4997, "unstable": 1, "imaginary-axis": 1, "bad-input": 1}
    for i in np.flatnonzero(many.ok)[::97]:
        one = gyrospec.integral(h[i], g[i])
        assert abs(many.value[i] - one.value) <= many.error_bound[i] + one.error_bound
    assert np.isnan(many.value[7]) and not many.ok[7]
    # strided, Fortran-ordered and single-precision arrays are read as well
    for other in (np.asfortranarray(h), np.repeat(h, 2, axis=0)[::2], h.tolist()):
        assert np.array_equal(gyrospec.integral_batch(other, g, fast=fast).value, many.value, equal_nan=True)


def test_a_batch_refuses_shapes_that_do_not_fit() -> None:
    for h, g in ((np.ones((3, 3)), np.ones((3, 3))), (np.ones((3, 3)), np.ones((4, 2)))):
        with pytest.raises(ValueError, match="n \\+ 1 and of n"):
            gyrospec.integral_batch(h, g)
    with pytest.raises(TypeError, match="one problem a row"):
        gyrospec.integral_batch([1, 2, 3], [0, 1])
    assert len(gyrospec.integral_batch(np.empty((0, 3)), np.empty((0, 2)))) == 0


def test_tables_are_those_of_the_program() -> None:
    tables = json.loads(gyrospec.table("1..3", "json"))
    assert [t["n"] for t in tables["orders"]] == [1, 2, 3]
    assert (
        tables
        == json.loads(gyrospec.table((1, 3), "json"))
        == json.loads(gyrospec.table(range(1, 4), "json"))
    )
    names = {f"a{i}": v for i, v in enumerate([1.0, 2.0, 3.0])} | {"b0": 0.5, "b1": 1.5}

    def value(terms: list[dict[str, object]]) -> float:
        return sum(t["coefficient"] * np.prod([names[k] ** p for k, p in t["powers"].items()]) for t in terms)  # type: ignore

    second = tables["orders"][1]
    by_table = value(second["numerator"]) / value(second["denominator"])
    assert by_table == pytest.approx(gyrospec.integral([1, 2, 3], [0.5, 1.5]).value, rel=1e-14)
    with pytest.raises(gyrospec.UsageError, match="order 99"):
        gyrospec.table(99)
    with pytest.raises(gyrospec.UsageError, match="no form 'pdf'"):
        gyrospec.table(2, "pdf")

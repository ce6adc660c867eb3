"""Transfer functions and state spaces of python-control and SciPy, as models and as spectral integrals."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ._errors import InputError, UsageError
from ._function import of_function
from ._gyrospec import Model
from ._inputs import Floats


def is_linear(given: Any) -> bool:
    """Whether it has the matrices, the polynomials or the zeros and poles of a linear system."""
    return any(all(hasattr(given, n) for n in names) for names in (("A", "B", "C", "D"), ("num", "den"), ("zeros", "poles", "gain")))


def coefficients(given: Any) -> tuple[Floats, Floats]:
    """H and C of the variance of the output at white noise: I = 1/(2 pi) * integral of |C/H|² (highest power first).

    Of a state space they are computed with rounding that the integral's bound does not know of.
    """
    if not is_linear(given):
        raise UsageError("give g or c, one of the two, or a transfer function or state space alone")
    c, h = _polynomials(given)
    if len(c) >= len(h):
        raise InputError(
            "the numerator is not of lower order than the denominator: the variance at white noise is infinite\n"
            "help: put what limits the noise, a lag, in front of the system"
        )
    return h, c


def of_linear(
    given: Any, states: Any, inputs: Sequence[str] | None, outputs: Sequence[str] | None, title: str
) -> Model:
    """The model of a linear system; its coefficients are fitted parameters."""
    _continuous(given)
    if hasattr(given, "A"):
        return _of_matrices(given, states, inputs, outputs, title)
    c, h = _polynomials(given)
    if len(c) > len(h):
        raise InputError(f"the numerator's order {len(c) - 1} is above the denominator's, {len(h) - 1}: no states can give it")
    n, scale = len(h) - 1, h[0]
    a, b = (h / scale)[::-1], np.concatenate([(c / scale)[::-1], np.zeros(len(h) - len(c))])
    parameters = {f"a{k}": a[k] for k in range(n) if a[k] != 0} | {f"b{k}": b[k] for k in range(n + 1) if b[k] != 0}
    names = list(states or [f"x{k + 1}" for k in range(n)])

    # x(k)' = x(k+1), x(n)' = u - sum a(k) x(k+1);  y = sum b(k) x(k+1), with s^n of the numerator on x(n)'
    def canonical(t: Any, x: Any, u: Any, p: Any) -> Any:
        def times(letter: str, k: int) -> Any:
            return p[f"{letter}{k}"] * x[k]

        last = u[0]
        for k in [k for k in range(n) if a[k] != 0]:
            last = last - times("a", k)
        sums = [times("b", k) for k in range(n) if b[k] != 0]
        if b[n] != 0:
            sums.append(p[f"b{n}"] * last)
        return [*list(x)[1:], last] if n else [], [sum(sums[1:], sums[0]) if sums else 0 * u[0]]

    ends = (_names(given, "input_labels", inputs, "u", 1), _names(given, "output_labels", outputs, "y", 1))
    return of_function(canonical, names, ends[0], _fitted(parameters), ends[1], title)


def _of_matrices(given: Any, states: Any, inputs: Any, outputs: Any, title: str) -> Model:
    a, b, c, d = (np.atleast_2d(np.asarray(m, dtype=float)) for m in (given.A, given.B, given.C, given.D))
    (n, m), q = b.shape if b.size else (a.shape[0], d.shape[1]), d.shape[0]
    if a.size == 0:
        n, a, b, c = 0, np.zeros((0, 0)), np.zeros((0, m)), np.zeros((q, 0))
    parameters: dict[str, float] = {}

    def entry(matrix: Any, letter: str, i: int, j: int, p: Any, value: Any) -> Any:
        """An entry of 0 is no term, one of ±1 a fixed number, any other a parameter."""
        own = float(matrix[i, j])
        if own in (1.0, -1.0):
            return value if own > 0 else -value
        key = f"{letter}{i + 1}{j + 1}" if max(matrix.shape) < 10 else f"{letter}{i + 1}_{j + 1}"
        parameters[key] = own
        return p[key] * value

    def rows(first: Any, letter: str, second: Any, other: str, x: Any, u: Any, p: Any) -> list[Any]:
        told = []
        for i in range(first.shape[0] or second.shape[0]):
            terms = [entry(first, letter, i, j, p, x[j]) for j in range(n) if first[i, j] != 0]
            terms += [entry(second, other, i, j, p, u[j]) for j in range(m) if second[i, j] != 0]
            told.append(sum(terms[1:], terms[0]) if terms else 0.0)
        return told

    class Any_(dict[str, float]):
        def __missing__(self, key: str) -> float:
            return 1.0

    def system(t: Any, x: Any, u: Any, p: Any) -> Any:
        return rows(a, "a", b, "b", x, u, p) if n else [], rows(c, "c", d, "d", x, u, p)

    system(0.0, [1.0] * n, [1.0] * m, Any_())  # to know the parameters
    names = _names(given, "state_labels", states, "x", n)
    ends = (_names(given, "input_labels", inputs, "u", m), _names(given, "output_labels", outputs, "y", q))
    return of_function(system, names, ends[0], _fitted(parameters), ends[1], title)


def _fitted(parameters: Mapping[str, float]) -> dict[str, Any]:
    return {n: {"value": float(v), "fit": True} for n, v in parameters.items()}


def _names(given: Any, labels: str, said: Any, letter: str, count: int) -> list[str]:
    """Names that were said, those of the system, or a letter with numbers."""
    own = [letter] if count == 1 and letter != "x" else [f"{letter}{k + 1}" for k in range(count)]
    told = list(getattr(given, labels, None) or [])
    if said is None and len(told) == count and not all(re.fullmatch(rf"{letter}\[\d+\]", str(n)) for n in told):
        said = [re.sub(r"\W+", "_", str(n)).strip("_") for n in told]
    if said is not None and len(said) != count:
        raise InputError(f"{len(said)} names for {count} of the system's signals\nhelp: give as many, or none")
    return own if said is None else list(said)


def _continuous(given: Any) -> None:
    if getattr(given, "dt", None) not in (None, 0, 0.0):
        raise InputError(
            f"the system counts steps of {given.dt} s, and a model here goes on in time\n"
            "help: give the system before it was made discrete, or its rates as a function"
        )


def _polynomials(given: Any) -> tuple[Floats, Floats]:
    """Numerator and denominator of the single input's and output's transfer function, highest power first."""
    _continuous(given)
    if hasattr(given, "A"):
        a, b, c, d = (np.atleast_2d(np.asarray(m, dtype=float)) for m in (given.A, given.B, given.C, given.D))
        _single(b.shape[1] if b.size else d.shape[1], d.shape[0])
        h: Floats = np.asarray(np.poly(a), dtype=np.float64) if a.size else np.ones(1)
        # det(sI − A + BC)/det(sI − A) = 1 + C (sI − A)⁻¹ B
        c_over = np.poly(a - b @ c) - h if a.size else np.zeros(1)
        return _stripped(c_over + d[0, 0] * h), h
    if not hasattr(given, "num"):
        given = given.to_tf()
    num, den = given.num, given.den
    if isinstance(num, (list, tuple)) or getattr(num, "dtype", None) == object:
        _single(getattr(given, "ninputs", len(num[0])), getattr(given, "noutputs", len(num)))
        num, den = num[0][0], den[0][0]
    return _stripped(np.atleast_1d(np.asarray(num, dtype=float)).ravel()), _stripped(np.atleast_1d(np.asarray(den, dtype=float)).ravel())


def _single(inputs: int, outputs: int) -> None:
    if inputs != 1 or outputs != 1:
        raise InputError(
            f"the system has {inputs} inputs and {outputs} outputs, where one of each is wanted\n"
            "help: take one pair of them, or a state space for a model"
        )


def _stripped(row: Floats) -> Floats:
    first = next((k for k, x in enumerate(row) if x != 0), len(row) - 1)
    return row[first:]

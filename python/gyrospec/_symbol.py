"""A number that is not known yet: what is done with it becomes an expression of the model's language."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from ._errors import InputError

Tree = tuple[Any, ...]
"""("number", x), ("name", n), ("call", f, trees) or an operator with its trees: "neg" "+" "-" "*" "/" "^"."""

_BINDING = {"+": 1, "-": 1, "*": 2, "/": 2, "neg": 3, "^": 4}
_PLAIN = {
    "sin": "sin", "cos": "cos", "tan": "tan", "arcsin": "asin", "arccos": "acos", "arctan": "atan",
    "asin": "asin", "acos": "acos", "atan": "atan", "sinh": "sinh", "cosh": "cosh", "tanh": "tanh",
    "exp": "exp", "log": "ln", "sqrt": "sqrt", "absolute": "abs", "fabs": "abs", "sign": "sign",
    "arctan2": "atan2", "atan2": "atan2", "maximum": "max", "minimum": "min", "fmax": "max", "fmin": "min",
}  # fmt: skip


def refuse(words: str, instead: str) -> InputError:
    """What cannot be traced, and what can."""
    return InputError(f"{words}\nhelp: {instead}")


class Symbol:
    """A part of an expression. Operators and NumPy's functions make larger ones of it."""

    __slots__ = ("tree",)

    def __init__(self, tree: Tree) -> None:
        self.tree = tree

    def __add__(self, other: Any) -> Any:
        return binary("+", self, other)

    def __radd__(self, other: Any) -> Any:
        return binary("+", other, self)

    def __sub__(self, other: Any) -> Any:
        return binary("-", self, other)

    def __rsub__(self, other: Any) -> Any:
        return binary("-", other, self)

    def __mul__(self, other: Any) -> Any:
        return binary("*", self, other)

    def __rmul__(self, other: Any) -> Any:
        return binary("*", other, self)

    def __truediv__(self, other: Any) -> Any:
        return binary("/", self, other)

    def __rtruediv__(self, other: Any) -> Any:
        return binary("/", other, self)

    def __pow__(self, other: Any) -> Any:
        return binary("^", self, other)

    def __rpow__(self, other: Any) -> Any:
        return binary("^", other, self)

    def __neg__(self) -> Symbol:
        return Symbol(("neg", self.tree))

    def __pos__(self) -> Symbol:
        return self

    def __abs__(self) -> Symbol:
        return call("abs", self)

    # step(x) is 1 from x = 0 on
    def __ge__(self, other: Any) -> Any:
        return condition(binary("-", self, other), True)

    def __le__(self, other: Any) -> Any:
        return condition(binary("-", other, self), True)

    def __gt__(self, other: Any) -> Any:
        return condition(binary("-", other, self), False)

    def __lt__(self, other: Any) -> Any:
        return condition(binary("-", self, other), False)

    def __eq__(self, other: object) -> Any:
        raise refuse("two values that change are never exactly equal", "compare with < or >, or take their difference")

    __ne__ = __eq__
    __hash__ = None  # type: ignore[assignment]

    def __bool__(self) -> bool:
        raise refuse(
            "a branch on a value of the model (if, while, and, or, min, max): when it is traced it has none",
            "write np.where(condition, a, b), np.minimum or np.maximum, and & | ~ between conditions",
        )

    def __float__(self) -> float:
        raise refuse(
            "a function that needs a plain number got a value of the model (float, or one of math's)",
            "write NumPy's function instead: np.sin for math.sin",
        )

    __int__ = __index__ = __complex__ = __float__

    def __round__(self, digits: int | None = None) -> Any:
        raise refuse("round of a value of the model", "leave it out: the language has no steps but np.heaviside")

    __floor__ = __ceil__ = __trunc__ = __floordiv__ = __mod__ = __rmod__ = __rfloordiv__ = __round__

    def __iter__(self) -> Any:
        raise refuse("a loop over a single value of the model", "loop over a list of names, or over x, u or p")

    def __and__(self, other: Any) -> Any:
        return binary("*", self, other)

    def __or__(self, other: Any) -> Any:
        return self + other - self * other

    def __invert__(self) -> Any:
        return 1 - self

    __rand__, __ror__ = __and__, __or__

    def __array_ufunc__(self, ufunc: Any, method: str, *given: Any, **options: Any) -> Any:
        if method != "__call__" or options:
            raise refuse(f"np.{ufunc.__name__}.{method} with a value of the model", "call it with values alone")
        if any(isinstance(x, np.ndarray) and x.ndim > 0 for x in given):
            return each(lambda *x: apply(ufunc.__name__, x), *given)
        return apply(ufunc.__name__, given)

    def __array_function__(self, function: Any, types: Any, given: Any, options: dict[str, Any]) -> Any:
        known = _FUNCTIONS.get(function.__name__)
        if known is None:
            raise refuse(f"np.{function.__name__} of a value of the model", "write it with operators and np.where")
        return known(*given, **options)

    def __getattr__(self, name: str) -> Any:
        # NumPy calls x.sin() for the elements of an array of objects
        if name in _UFUNCS and not name.startswith("_"):
            return lambda *others: apply(name, (self, *others))
        raise AttributeError(f"a value of the model has no `{name}`")

    def __repr__(self) -> str:
        return text(self.tree)


def name(of: str) -> Symbol:
    """A value by its name."""
    return Symbol(("name", of))


def tree_of(value: Any) -> Tree:
    """The tree of a symbol or of a number."""
    if isinstance(value, Symbol):
        return value.tree
    if isinstance(value, np.ndarray) and value.ndim == 0:
        return tree_of(value.item())
    if isinstance(value, (int, float, np.number, np.bool_)) and not isinstance(value, complex):
        number = float(value)
        if not math.isfinite(number):
            raise refuse(f"the number {number} in an expression", "give finite numbers")
        return ("neg", ("number", -number)) if number < 0 else ("number", number)
    raise refuse(f"{type(value).__name__} beside a value of the model", "give numbers, symbols, or arrays of both")


def binary(operator: str, a: Any, b: Any) -> Any:
    """a + b and the like; of arrays, element by element."""
    for other in (a, b):
        if isinstance(other, (np.ndarray, list, tuple)) and np.ndim(other) > 0:
            return each(lambda x, y: binary(operator, x, y), a, b)
        if not isinstance(other, (Symbol, int, float, np.number, np.ndarray, np.bool_)):
            return NotImplemented
    return Symbol(_simplified(operator, tree_of(a), tree_of(b)))


def _simplified(operator: str, a: Tree, b: Tree) -> Tree:
    """Without noughts and ones, as a person would write it."""
    zero, one = ("number", 0.0), ("number", 1.0)
    if operator == "+" and zero in (a, b):
        return b if a == zero else a
    if operator == "-" and zero in (a, b):
        return a if b == zero else ("neg", b)
    if operator == "*" and zero in (a, b):
        return zero
    if operator == "*" and one in (a, b):
        return b if a == one else a
    if operator in "/^" and b == one:
        return a
    return (operator, a, b)


def each(function: Callable[..., Any], *given: Any) -> Any:
    """The function of the elements of arrays, which are broadcast."""
    arrays = []
    for x in given:
        array = x if isinstance(x, np.ndarray) else np.empty((), dtype=object)
        if isinstance(x, Symbol):
            array[()] = x
        arrays.append(array if isinstance(x, (Symbol, np.ndarray)) else np.asarray(x, dtype=object))
    return np.frompyfunc(function, len(arrays), 1)(*arrays)


def call(function: str, *given: Any) -> Symbol:
    return Symbol(("call", function, tuple(tree_of(x) for x in given)))


def condition(difference: Any, holds_at_zero: bool) -> Any:
    """1 where a difference is not negative; the other way round where the condition excludes equality."""
    if difference is NotImplemented:
        return NotImplemented
    return call("step", difference) if holds_at_zero else 1 - call("step", difference)


def _where(*given: Any) -> Any:
    if len(given) != 3:
        raise refuse("np.where with a condition alone", "give both values: np.where(condition, a, b)")
    if any(np.ndim(x) > 0 for x in given if not isinstance(x, Symbol)):
        return each(_where, *given)
    holds, a, b = given
    return b + holds * (a - b)


def _clip(x: Any, low: Any = None, high: Any = None, **others: Any) -> Any:
    if others:
        raise refuse(f"np.clip with {', '.join(others)}", "write np.clip(x, low, high)")
    x = x if low is None else apply("maximum", (x, low))
    return x if high is None else apply("minimum", (x, high))


def _interp(x: Any, at: Sequence[float], y: Sequence[float], left: Any = None, right: Any = None) -> Any:
    """Straight from point to point, constant beyond them: a sum of clamped pieces."""
    if left is not None or right is not None:
        raise refuse("np.interp with left or right", "leave both out: beyond the points it is constant")
    at, y = [float(v) for v in at], [float(v) for v in y]
    if len(at) != len(y) or len(at) < 2 or any(b <= a for a, b in zip(at, at[1:], strict=False)):
        raise refuse("np.interp through points whose places do not rise", "give two points at least, sorted")
    sum_: Any = y[0]
    for a, b, low, high in zip(at, at[1:], y, y[1:], strict=False):
        sum_ = sum_ + (high - low) / (b - a) * (call("clamp", x, a, b) - a)
    return sum_


_FUNCTIONS: dict[str, Callable[..., Any]] = {"where": _where, "clip": _clip, "interp": _interp}

_UFUNCS: dict[str, Callable[..., Any]] = {
    "add": lambda a, b: binary("+", a, b), "subtract": lambda a, b: binary("-", a, b),
    "multiply": lambda a, b: binary("*", a, b), "divide": lambda a, b: binary("/", a, b),
    "true_divide": lambda a, b: binary("/", a, b), "power": lambda a, b: binary("^", a, b),
    "float_power": lambda a, b: binary("^", a, b), "negative": lambda x: -x, "positive": lambda x: x,
    "square": lambda x: x**2, "reciprocal": lambda x: 1 / x, "conjugate": lambda x: x,
    "exp2": lambda x: call("exp", math.log(2) * x), "expm1": lambda x: call("exp", x) - 1,
    "log2": lambda x: call("ln", x) / math.log(2), "log10": lambda x: call("ln", x) / math.log(10),
    "log1p": lambda x: call("ln", 1 + x), "cbrt": lambda x: call("sign", x) * call("abs", x) ** (1 / 3),
    "arcsinh": lambda x: call("ln", x + call("sqrt", x**2 + 1)),
    "arccosh": lambda x: call("ln", x + call("sqrt", x**2 - 1)),
    "arctanh": lambda x: call("ln", (1 + x) / (1 - x)) / 2,
    "hypot": lambda a, b: call("sqrt", a**2 + b**2), "logaddexp": lambda a, b: call("ln", call("exp", a) + call("exp", b)),
    "deg2rad": lambda x: x * (math.pi / 180), "radians": lambda x: x * (math.pi / 180),
    "rad2deg": lambda x: x * (180 / math.pi), "degrees": lambda x: x * (180 / math.pi),
    "greater": lambda a, b: condition(b - a, False), "less": lambda a, b: condition(a - b, False),
    "greater_equal": lambda a, b: condition(a - b, True), "less_equal": lambda a, b: condition(b - a, True),
    "logical_and": lambda a, b: a * b, "logical_or": lambda a, b: a + b - a * b, "logical_not": lambda a: 1 - a,
    "bitwise_and": lambda a, b: a * b, "bitwise_or": lambda a, b: a + b - a * b, "invert": lambda a: 1 - a,
    "copysign": lambda a, b: call("abs", a) * (2 * call("step", b) - 1),
}  # fmt: skip


def _heaviside(x: Any, middle: Any) -> Any:
    if isinstance(middle, Symbol) or middle not in (0, 0.5, 1):
        raise refuse(f"np.heaviside(x, {middle})", "give 0, 0.5 or 1 as the value at 0")
    if middle == 0.5:
        return 0.5 + 0.5 * call("sign", x)
    return call("step", x) if middle == 1 else 1 - call("step", -x)


_UFUNCS["heaviside"] = _heaviside
_UFUNCS |= {own: (lambda *x, f=f: call(f, *x)) for own, f in _PLAIN.items()}


def apply(function: str, given: Sequence[Any]) -> Any:
    """One of NumPy's functions, by its name."""
    known = _UFUNCS.get(function)
    if known is None:
        raise refuse(f"np.{function} of a value of the model", "the language has no function for it: write it with others")
    return known(*(x.item() if isinstance(x, np.ndarray) else x for x in given))


def text(tree: Tree, named: dict[int, str] | None = None) -> str:
    """The tree in the model's language; parts that have a name are written by it."""
    return _text(tree, named or {})[0]


def _text(tree: Tree, named: dict[int, str]) -> tuple[str, int]:
    if id(tree) in named:
        return named[id(tree)], 5
    kind = tree[0]
    if kind == "number":
        return repr(tree[1]), 5
    if kind == "name":
        return tree[1], 5
    if kind == "call":
        return f"{tree[1]}({', '.join(_text(x, named)[0] for x in tree[2])})", 5
    own = _BINDING[kind]
    if kind == "neg":
        return f"-{_within(tree[1], 4, named)}", own
    # a - (b - c), a / (b / c), (a^b)^c
    left, right = (5, 4) if kind == "^" else (own, own + 1)
    sign = {"^": "^", "*": "*", "/": "/"}.get(kind, f" {kind} ")
    return f"{_within(tree[1], left, named)}{sign}{_within(tree[2], right, named)}", own


def _within(tree: Tree, least: int, named: dict[int, str]) -> str:
    words, binds = _text(tree, named)
    return words if binds >= least and not (words.startswith("-") and least > 1) else f"({words})"

"""Units that were left out, from the equations that their names stand in."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from ._symbol import Tree

Powers = tuple[Fraction, ...]
"""Powers of m, kg, s, A, K and mol."""

NONE: Powers = (Fraction(0),) * 6
TIME: Powers = (Fraction(0), Fraction(0), Fraction(1), Fraction(0), Fraction(0), Fraction(0))

_SAME = {"abs", "min", "max", "clamp"}
_NUMBER = {"sign", "step", "atan2"}


class Form:
    """The dimension of an expression: known powers, and shares of those of unknown names. `None` fits anything."""

    def __init__(self, powers: Powers = NONE, unknown: Mapping[str, Fraction] | None = None) -> None:
        self.powers = powers
        self.unknown = {n: s for n, s in (unknown or {}).items() if s != 0}

    def plus(self, other: Form, share: Fraction) -> Form:
        powers = tuple(a + share * b for a, b in zip(self.powers, other.powers, strict=True))
        names = {*self.unknown, *other.unknown}
        zero = Fraction(0)
        return Form(powers, {n: self.unknown.get(n, zero) + share * other.unknown.get(n, zero) for n in names})


class Equations:
    """What expressions demand of the dimensions of their names."""

    def __init__(self, known: Mapping[str, Powers]) -> None:
        self.known = known
        self.all: list[Form] = []
        self._seen: dict[int, Form | None] = {}

    def same(self, a: Form | None, b: Form | None) -> None:
        if a is not None and b is not None:
            self.all.append(a.plus(b, Fraction(-1)))

    def of_name(self, name: str) -> Form:
        return Form(self.known[name]) if name in self.known else Form(NONE, {name: Fraction(1)})

    def of(self, tree: Tree) -> Form | None:
        """The dimension of an expression; what its parts demand is noted once."""
        if id(tree) not in self._seen:
            self._seen[id(tree)] = self._of(tree)
        return self._seen[id(tree)]

    def _of(self, tree: Tree) -> Form | None:
        kind = tree[0]
        if kind == "number":
            return None if tree[1] == 0 else Form()
        if kind == "name":
            return self.of_name(tree[1])
        if kind == "neg":
            return self.of(tree[1])
        if kind == "call":
            return self._of_call(tree[1], [self.of(x) for x in tree[2]])
        a, b = self.of(tree[1]), self.of(tree[2])
        if kind in "+-":
            self.same(a, b)
            return b if a is None else a
        if kind in "*/":
            return None if a is None or b is None else a.plus(b, Fraction(1 if kind == "*" else -1))
        return self._of_power(tree[2], a, b)

    def _of_power(self, exponent: Tree, a: Form | None, b: Form | None) -> Form | None:
        sign, number = (-1, exponent[1]) if exponent[0] == "neg" else (1, exponent)
        if number[0] == "number":
            return None if a is None else Form().plus(a, sign * Fraction(number[1]).limit_denominator(12))
        self.same(a, Form())
        self.same(b, Form())
        return Form()

    def _of_call(self, function: str, given: list[Form | None]) -> Form | None:
        if function == "sqrt":
            return None if given[0] is None else Form().plus(given[0], Fraction(1, 2))
        if function in _SAME or function == "atan2":
            for other in given[1:]:
                self.same(given[0], other)
        if function in _SAME:
            return next((g for g in given if g is not None), None)
        if function not in _NUMBER:
            self.same(given[0], Form())
        return Form()

    def solved(self) -> dict[str, Powers]:
        """The names that the equations determine, each with its powers."""
        names = sorted({n for e in self.all for n in e.unknown})
        rows: list[list[Any]] = [[e.unknown.get(n, Fraction(0)) for n in names] + list(e.powers) for e in self.all]
        pivots: dict[int, list[Any]] = {}
        for c in range(len(names)):
            row = next((r for r in rows if r[c] != 0 and all(x == 0 for x in r[:c])), None)
            if row is None:
                continue
            rows.remove(row)
            row = [x / row[c] for x in row]
            rows = [[x - r[c] * y for x, y in zip(r, row, strict=True)] for r in rows]
            pivots = {k: [x - r[c] * y for x, y in zip(r, row, strict=True)] for k, r in pivots.items()}
            pivots[c] = row
        n = len(names)
        alone = {c: r for c, r in pivots.items() if all(r[k] == 0 for k in range(n) if k != c)}
        return {names[c]: tuple(-x for x in r[n:]) for c, r in alone.items()}

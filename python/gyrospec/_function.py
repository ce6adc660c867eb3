"""A model from a Python function: it is called once with symbols, and what it does with them becomes a model file."""

from __future__ import annotations

import json
import re
import traceback
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np

from . import _gyrospec as native
from ._dimensions import TIME, Equations, Form, Powers
from ._errors import Error, InputError, UnitsError, UsageError
from ._symbol import Symbol, Tree, name, text, tree_of

Named: TypeAlias = Sequence[str] | Mapping[str, Any]
"""Names in their order, or names with their unit: a text, None, or a dict of the fields of a model file."""

_LONGEST = 400
"""Parts of an expression beyond which what stands in it several times becomes a definition."""


class Names:
    """Values by name or by place: `x.v`, `x["v"]`, `x[1]`, `q, v = x`."""

    def __init__(self, what: str, names: Sequence[str]) -> None:
        self._what = what
        self._names = list(names)

    def __getattr__(self, wanted: str) -> Symbol:
        if wanted.startswith("__"):
            raise AttributeError(wanted)
        if wanted not in self._names:
            raise InputError(f"there is no {self._what} `{wanted}`\nhelp: there are {', '.join(self._names) or 'none'}")
        return name(wanted)

    def __getitem__(self, wanted: Any) -> Any:
        if isinstance(wanted, str):
            return getattr(self, wanted)
        if isinstance(wanted, slice):
            return [name(n) for n in self._names[wanted]]
        try:
            return name(self._names[wanted])
        except IndexError:
            raise InputError(f"there are {len(self._names)} values of kind {self._what}, and no number {wanted}") from None

    def __iter__(self) -> Iterator[Symbol]:
        return iter([name(n) for n in self._names])

    def __len__(self) -> int:
        return len(self._names)

    def keys(self) -> list[str]:
        return list(self._names)

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        array = np.empty(len(self._names), dtype=object)
        array[:] = [name(n) for n in self._names]
        return array


def of_function(
    function: Callable[..., Any], states: Named, inputs: Named, parameters: Mapping[str, Any], outputs: Named | None, title: str
) -> native.Model:
    """The model of a function `f(t, x, u, p)`."""
    sections = {"states": _fields(states), "inputs": _fields(inputs), "parameters": _parameters(parameters)}
    sections["outputs"] = {n: dict(f) for n, f in sections["states"].items()} if outputs is None else _fields(outputs)
    if outputs is None:
        sections["outputs"] = {n: {k: v for k, v in f.items() if k == "unit"} for n, f in sections["outputs"].items()}
    _distinct(sections)
    rates, results = _traced(function, sections, outputs is None)
    units = _units(sections, rates, results)
    return _parsed(function, _toml(title, sections, units, rates, results))


def _fields(given: Named) -> dict[str, dict[str, Any]]:
    if isinstance(given, str):
        given = [given]
    if not isinstance(given, Mapping):
        given = dict.fromkeys(given)
    return {str(n): dict(f) if isinstance(f, Mapping) else {"unit": f} for n, f in given.items()}


def _parameters(given: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
    if not isinstance(given, Mapping):
        raise UsageError("parameters are a dict: {'M': 3.0} or {'M': {'value': 3.0, 'unit': 'kg'}}")
    all_: dict[str, dict[str, Any]] = {}
    for n, p in given.items():
        fields = dict(p) if isinstance(p, Mapping) else {"value": p, "fit": True}
        if "value" not in fields:
            raise InputError(f"the parameter `{n}` has no value\nhelp: give {{'value': 1.0}}")
        all_[str(n)] = {"unit": None, **fields}
    return all_


def _distinct(sections: Mapping[str, Mapping[str, Any]]) -> None:
    """Names are words, and states, inputs and parameters have different ones."""
    seen: dict[str, str] = {}
    for section, fields in sections.items():
        for n in fields:
            if not n.isidentifier():
                raise InputError(f"`{n}` in {section} is no name\nhelp: letters, digits and _ make one")
            if section != "outputs" and seen.setdefault(n, section) != section:
                raise InputError(f"`{n}` stands among the {seen[n]} and the {section}\nhelp: rename one of them")


def _traced(
    function: Callable[..., Any], sections: Mapping[str, Mapping[str, Any]], measures_states: bool
) -> tuple[dict[str, Tree], dict[str, Tree]]:
    """Rates by state and expressions by output."""
    given = [Names(one, list(sections[all_])) for one, all_ in (("state", "states"), ("input", "inputs"))]
    try:
        told = function(name("t"), *given, Names("parameter", list(sections["parameters"])))
        states = list(sections["states"])
        is_pair = isinstance(told, (tuple, list)) and len(told) == 2
        if is_pair and not isinstance(told[0], (Symbol, int, float, np.number)):
            rates, results = told
        elif measures_states:
            rates, results = told, {n: name(n) for n in states}
        elif not states:
            rates, results = {}, told
        else:
            raise InputError("the function must return two things\nhelp: return rates, outputs: two dicts or two lists")
        return _trees("states", rates, states), _trees("outputs", results, list(sections["outputs"]))
    except Exception as e:
        raise _placed(function, e) from (None if isinstance(e, Error) else e)


def _trees(section: str, given: Any, names: list[str]) -> dict[str, Tree]:
    if isinstance(given, Mapping):
        lacking, unknown = [n for n in names if n not in given], [str(n) for n in given if n not in names]
        if lacking or unknown:
            what = f"nothing for {', '.join(lacking)}" if lacking else f"{', '.join(unknown)}, which nobody named"
            raise InputError(f"what the function returns for the {section} has {what}\nhelp: name {', '.join(names)}")
        return {n: tree_of(given[n]) for n in names}
    values = [given] if isinstance(given, Symbol) or np.ndim(given) == 0 else list(np.ravel(np.asarray(given, dtype=object)))
    if len(values) != len(names):
        raise InputError(f"the function returns {len(values)} values for the {section} {', '.join(names) or '(none)'}")
    return {n: tree_of(v) for n, v in zip(names, values, strict=True)}


def _placed(function: Callable[..., Any], e: Exception) -> Error:
    """The error with the line of the user's file that it comes from."""
    own = Path(__file__).parent
    numpy = Path(np.__file__).parent
    frames = [f for f in traceback.extract_tb(e.__traceback__) if not _is_in(f.filename, own) and not _is_in(f.filename, numpy)]
    code = getattr(function, "__code__", None)
    file, line = (frames[-1].filename, frames[-1].lineno) if frames else (getattr(code, "co_filename", "?"), getattr(code, "co_firstlineno", 0))
    words = str(e) if isinstance(e, Error) else f"the function fails when it is traced: {type(e).__name__}: {e}"
    if not isinstance(e, Error):
        words += "\nhelp: it is called once with symbols; operators, NumPy's functions and np.where work on them"
    placed = InputError(f"{file}:{line}: {words}")
    placed.file, placed.line = file, line
    placed.hint = words.partition("\nhelp: ")[2] or None
    return placed


def _is_in(file: str, folder: Path) -> bool:
    return folder in Path(file).parents


def _units(
    sections: Mapping[str, Mapping[str, Mapping[str, Any]]], rates: Mapping[str, Tree], results: Mapping[str, Tree]
) -> dict[tuple[str, str], str] | None:
    """The unit of everything, those that were left out by the equations; none where none was given."""
    given = {(s, n): f["unit"] for s, fields in sections.items() for n, f in fields.items() if f.get("unit") is not None}
    if not given:
        return None
    known = {n: _powers(unit) for (s, n), unit in given.items() if s != "outputs"}
    equations = Equations({"t": TIME, "pi": Form().powers, **known})
    for n, tree in rates.items():
        equations.same(equations.of(tree), equations.of_name(n).plus(Form(TIME), Fraction(-1)))
    ends: dict[str, Form | None] = {}
    for n, tree in results.items():
        ends[n] = equations.of(tree)
        if ("outputs", n) in given:
            equations.same(ends[n], Form(_powers(given["outputs", n])))
    found = equations.solved()
    for s, fields in sections.items():
        for n in fields:
            if (s, n) not in given:
                given[s, n] = _found(s, n, found, ends)
    return given


def _found(section: str, n: str, found: Mapping[str, Powers], ends: Mapping[str, Form | None]) -> str:
    """The unit that the equations demand."""
    form = ends.get(n) if section == "outputs" else Form(unknown={n: Fraction(1)})
    if form is not None and all(k in found for k in form.unknown):
        powers = list(form.powers)
        for k, share in form.unknown.items():
            powers = [a + share * b for a, b in zip(powers, found[k], strict=True)]
        return native.unit_of([float(x) for x in powers])
    raise UnitsError(
        f"the equations do not tell the unit of `{n}` in {section}\nhelp: give it, or leave out all units: then none is checked"
    )


def _powers(unit: str) -> Powers:
    return tuple(Fraction(x).limit_denominator(12) for x in native.powers(unit))


def _toml(
    title: str, sections: Mapping[str, Any], units: Mapping[tuple[str, str], str] | None, rates: Mapping[str, Tree],
    results: Mapping[str, Tree],
) -> str:  # fmt: skip
    named, definitions = _shared([*rates.values(), *results.values()], sections) if units is None else ({}, {})
    lines = [f"name = {_quoted(title)}"]
    for section in ("inputs", "parameters", "definitions", "states", "outputs"):
        lines += ["", f"[{section}]"]
        if section == "definitions":
            lines += [f"{n} = {{ equals = {_quoted(words)} }}" for n, words in definitions.items()]
            continue
        for n, given in sections[section].items():
            fields = {k: v for k, v in given.items() if k != "unit" and v is not None}
            if units is not None:
                fields["unit"] = units[section, n]
            if section == "states":
                fields = {"initial": "fit", **fields, "rate": text(rates[n], named)}
            if section == "outputs":
                fields["equals"] = text(results[n], named)
            lines.append(f"{_key(n)} = {{ {', '.join(f'{_key(k)} = {_value(v)}' for k, v in fields.items())} }}")
    return "\n".join(lines) + "\n"


def _shared(trees: Sequence[Tree], sections: Mapping[str, Any]) -> tuple[dict[int, str], dict[str, str]]:
    """Definitions for what stands in expressions again and again, where written out they would be long."""
    uses: dict[int, int] = {}
    sizes: dict[int, int] = {}
    order: list[Tree] = []

    def visit(tree: Tree) -> int:
        uses[id(tree)] = uses.get(id(tree), 0) + 1
        if id(tree) not in sizes:
            parts = tree[2] if tree[0] == "call" else [x for x in tree[1:] if isinstance(x, tuple)]
            sizes[id(tree)] = 1 + sum(visit(x) for x in parts)
            order.append(tree)
        return sizes[id(tree)]

    if sum(visit(tree) for tree in trees) <= _LONGEST:
        return {}, {}
    taken = {n for fields in sections.values() for n in fields}
    named: dict[int, str] = {}
    definitions: dict[str, str] = {}
    for tree in order:
        if uses[id(tree)] > 1 and sizes[id(tree)] > 3:
            words = text(tree, named)
            own = next(n for k in range(len(order) + len(taken) + 1) if (n := f"part_{len(definitions) + 1 + k}") not in taken)
            taken.add(own)
            definitions[own] = words
            named[id(tree)] = own
    return named, definitions


def _parsed(function: Callable[..., Any], toml: str) -> native.Model:
    try:
        return native.Model.parse(toml)
    except Error as e:
        code = getattr(function, "__code__", None)
        where = f"{code.co_filename}:{code.co_firstlineno}: " if code else ""
        raise type(e)(f"{where}the model of this function is refused: {e}") from None


def _quoted(words: str) -> str:
    return json.dumps(words, ensure_ascii=False)


def _key(n: str) -> str:
    return n if re.fullmatch(r"[A-Za-z0-9_-]+", n) else _quoted(n)


def _value(v: Any) -> str:
    if isinstance(v, (bool, np.bool_)):
        return "true" if v else "false"
    if isinstance(v, (int, float, np.number)):
        return repr(float(v))
    return _quoted(str(v))

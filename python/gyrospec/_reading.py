"""From JSON to objects with names: numbers that are null become NaN."""

from __future__ import annotations

import dataclasses
import functools
import math
import types
import typing
from typing import Any, TypeVar

T = TypeVar("T")


def read(wanted: type[T], data: Any) -> T:
    """An object of a dataclass from its JSON; fields that it does not know are left alone."""
    result: T = _value(wanted, data)
    return result


def _value(wanted: Any, data: Any) -> Any:
    origin, arguments = typing.get_origin(wanted), typing.get_args(wanted)
    if wanted is float:
        return math.nan if data is None else float(data)
    if origin in (typing.Union, types.UnionType):
        inner = next(a for a in arguments if a is not type(None))
        return None if data is None else _value(inner, data)
    if origin in (list, tuple):
        return origin(_value(arguments[0], item) for item in data)
    if dataclasses.is_dataclass(wanted):
        return typing.cast(Any, wanted)(**_fields(wanted, data))
    return data


def _fields(wanted: Any, data: dict[str, Any]) -> dict[str, Any]:
    types_of = _types(wanted)
    names = [f.name for f in dataclasses.fields(wanted) if f.init and not f.name.startswith("_")]
    # `from` is a word of Python: the field is `from_`
    return {n: _value(types_of[n], data[n.rstrip("_")]) for n in names if n.rstrip("_") in data}


@functools.cache
def _types(wanted: Any) -> dict[str, Any]:
    return typing.get_type_hints(wanted)

"""The mean rolling error over a grid of parameters."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from .. import _gyrospec as native
from .._api import roll_error_sweep
from .._errors import InputError
from .._inputs import Column
from ._parts import CARD, Progress, digest, do, finish, open_folder, part, read_card, write_part

Axes = dict[str, NDArray[np.float64]]

ROWS_PER_PART = 1_000_000
"""Points in a part file where nothing is said."""


def roll_error(
    grid: Mapping[str, Column],
    out: str | os.PathLike[str],
    client: Any = None,
    *,
    product: bool = True,
    rows_per_part: int | None = None,
) -> Progress:
    """The mean rolling error (rad) of every point of a grid, written into the folder `out`.

    grid: values of each parameter in SI, by the names of `gyrospec.roll_error_sweep`:
        `{"heading": np.radians(range(0, 360, 5)), "T": np.linspace(0.1, 2, 100), …}`; the last name
        runs fastest. With `product=False` the columns stand side by side: a row is a point.
    client: a dask.distributed.Client, or None for this process.
    rows_per_part: points in a part file, by default a million. A sweep that goes on keeps the size that it
        began with, and refuses another one.
    """
    if rows_per_part is not None and rows_per_part < 1:
        raise InputError(f"a part has one row at least, not {rows_per_part}")
    axes = {name: np.ascontiguousarray(values, dtype=np.float64) for name, values in grid.items()}
    count = _count(axes, product)
    # a wrong name is found here, not on a worker
    roll_error_sweep(**{name: values[:1] for name, values in axes.items()})
    hashes = {name: digest(values.tobytes().hex()) for name, values in axes.items()}
    card = {"kind": "roll-error", "version": native.VERSION, "grid": hashes, "product": product}
    if rows_per_part is None:
        begun = read_card(out) if (Path(out) / CARD).exists() else {}
        rows_per_part = int(begun.get("rows_per_part", ROWS_PER_PART))
    # parts of another size overlap those that are there
    folder = open_folder(out, {**card, "rows_per_part": rows_per_part})
    names = digest(native.VERSION, repr(hashes), repr(product))
    # sent once, not with every part
    shared = client.scatter(axes, broadcast=True) if hasattr(client, "scatter") else axes
    starts = range(0, count, rows_per_part)
    wanted = []
    for start in starts:
        stop = min(start + rows_per_part, count)
        name = digest(names, str(start), str(stop))
        if not part(folder, name).exists():
            wanted.append((name, (folder, name, shared, product, start, stop)))
    made, failures = do(client, make_part, wanted)
    finish(folder, failures)
    return Progress(folder, len(made), sum(made), count - sum(made))


def make_part(folder: Path, name: str, axes: Axes, product: bool, start: int, stop: int) -> int:
    """Computes the points start … stop and writes their part."""
    at = np.arange(start, stop)
    if product:
        shape = tuple(len(v) for v in axes.values())
        index = np.unravel_index(at, shape)
        columns = {n: v[i] for (n, v), i in zip(axes.items(), index, strict=True)}
    else:
        columns = {n: v[start:stop] for n, v in axes.items()}
    error = roll_error_sweep(**columns)
    write_part(folder, name, pa.table({"row": at, **columns, "mean_rad": error}))
    return len(at)


def _count(axes: Axes, product: bool) -> int:
    if not axes:
        raise InputError("the grid has no parameters")
    for name, values in axes.items():
        if values.ndim != 1 or not len(values):
            raise InputError(f"the values of `{name}` must be a row of numbers, one at least")
    lengths = [len(v) for v in axes.values()]
    if product:
        return math.prod(lengths)
    if len(set(lengths)) > 1:
        raise InputError(f"the columns have different lengths: {dict(zip(axes, lengths, strict=True))}")
    return lengths[0]

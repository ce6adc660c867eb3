"""A diagnosis of each of many recordings."""

from __future__ import annotations

import glob
import hashlib
import json
import os
import warnings
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, TypeAlias

import pyarrow as pa

from .. import _gyrospec as native
from .._api import diagnose as diagnose_one
from .._errors import Error, InputError
from .._gyrospec import Model
from .._inputs import ModelLike, as_model
from .._results import Diagnosis
from ._parts import Progress, chunks, digest, do, finish, open_folder, parts, read_part, write_part

Ships: TypeAlias = Mapping[str, str] | Callable[[str], str]

Member: TypeAlias = tuple[str, str, str, str]
"""A recording to be done: key, ship, file, and the file that holds the same data, if one does."""

VALUE = pa.struct(
    [
        ("code", pa.string()),
        ("site", pa.string()),
        ("share", pa.float64()),
        ("p_value", pa.float64()),
        ("parameter", pa.string()),
        ("value", pa.float64()),
        ("low", pa.float64()),
        ("high", pa.float64()),
        ("unit", pa.string()),
    ]
)
"""A parameter of a finding; a finding without parameters has one entry with nulls."""

FAULT = pa.struct([("code", pa.string()), ("channel", pa.string()), ("says", pa.string()), ("masked", pa.bool_())])
"""A fault of a recording's data."""

SCHEMA = pa.schema(
    [
        ("key", pa.string()),
        ("ship", pa.string()),
        ("file", pa.string()),
        ("status", pa.string()),
        ("verdict", pa.string()),
        ("says", pa.string()),
        ("p_value", pa.float64()),
        ("findings", pa.list_(VALUE)),
        ("faults", pa.list_(FAULT)),
        ("report", pa.string()),
    ]
)
"""Columns of a part: status is ok or error (`says` tells which), report is the whole JSON."""


def diagnose(
    files: str | os.PathLike[str] | Iterable[str | os.PathLike[str]],
    model: ModelLike,
    out: str | os.PathLike[str],
    client: Any = None,
    *,
    ships: Ships | None = None,
    seed: int = 1,
    per_part: int = 8,
) -> Progress:
    """Diagnoses each file by itself against one model, and writes the results into the folder `out`.

    files: paths of recordings, or a pattern as `voyages/*/*.toml`.
    client: a dask.distributed.Client, or None for this process.
    ships: which ship a file belongs to: a dict or a function of the path; by default its folder's name.
    per_part: recordings in a part: what is lost at most when a worker dies.

    Recordings that an earlier call has done, with the same contents, are not done again; a file that
    cannot be read or diagnosed, or holds the same data as another, has its error in its row.
    """
    read = as_model(model)
    text = read.to_toml()
    card = {"kind": "diagnosis", "version": native.VERSION, "model": text, "seed": seed}
    paths = _paths(files)
    folder = open_folder(out, card)
    known = done_keys(folder)
    named = {str(p): _ship(p, ships) for p in paths}
    keys = dict(zip(named, _keys(client, list(named)), strict=True))
    first: dict[str, str] = {}
    wanted: dict[str, Member] = {}
    for path, ship in named.items():
        twin = first.setdefault(keys[path], path)
        key = digest(ship, path, keys[path])
        if key not in known:
            wanted[key] = (key, ship, path, "" if twin == path else twin)
    groups = list(chunks(list(wanted.values()), max(1, per_part)))
    tasks = [(digest(*(row[0] for row in g)), (folder, text, seed, g)) for g in groups]
    made, failures = do(client, make_part, tasks)
    finish(folder, failures)
    return Progress(folder, len(made), sum(made), len(named) - len(wanted))


def make_part(folder: Path, model: str, seed: int, group: list[Member]) -> int:
    """Diagnoses a group of recordings and writes its part; returns the number of rows."""
    read = Model.parse(model)
    rows = [_row(read, seed, member) for member in group]
    write_part(folder, digest(*(member[0] for member in group)), pa.Table.from_pylist(rows, SCHEMA))
    return len(rows)


def done_keys(folder: Path) -> set[str]:
    """Keys of the recordings that are done."""
    columns = (read_part(p, ["key"]).column("key").to_pylist() for p in parts(folder))
    return {key for column in columns for key in column}


def _row(model: Model, seed: int, member: Member) -> dict[str, Any]:
    key, ship, path, twin = member
    row: dict[str, Any] = {"key": key, "ship": ship, "file": path, "findings": [], "faults": []}
    if twin:
        return {**row, "status": "error", "says": f"the same data as {twin}: it is not counted twice"}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            found = diagnose_one(model, path, seed=seed)
        except Error as e:
            return {**row, "status": "error", "says": str(e)}
    return {
        **row,
        "status": "ok",
        "verdict": found.verdict,
        "says": found.says,
        "p_value": found.detection.p_value,
        "findings": _findings(found),
        "faults": [
            {"code": f.code, "channel": f.site.name, "says": f.says, "masked": f.masked} for f in found.faults
        ],
        "report": json.dumps(found.to_dict(), separators=(",", ":")),
    }


def _findings(found: Diagnosis) -> list[dict[str, Any]]:
    """The physics alone: the faults have a column of their own."""
    rows = []
    data = {(f.code, f.site) for f in found.faults}
    for f in found.findings:
        if (f.code, f.site) in data:
            continue
        head = {
            "code": f.code,
            "site": f"{f.site.kind} {f.site.name}",
            "share": f.share,
            "p_value": f.p_value,
        }
        values = [
            {"parameter": v.name, "value": v.value, "low": v.low, "high": v.high, "unit": v.unit}
            for v in f.parameters
        ]
        rows += [{**head, **v} for v in values] or [head]
    return rows


def _paths(files: str | os.PathLike[str] | Iterable[str | os.PathLike[str]]) -> list[Path]:
    if isinstance(files, (str, os.PathLike)):
        found = sorted(glob.glob(os.fspath(files), recursive=True))
        if not found:
            raise InputError(f"no file matches {files}")
        return [Path(f).absolute() for f in found]
    paths = list(dict.fromkeys(Path(f).absolute() for f in files))
    if not paths:
        raise InputError("there are no files")
    return paths


def _ship(path: Path, ships: Ships | None) -> str:
    if ships is None:
        return path.parent.name
    if callable(ships):
        return str(ships(str(path)))
    for name in (str(path), path.name, path.stem):
        if name in ships:
            return str(ships[name])
    raise InputError(f"ships says nothing of {path}")


def _keys(client: Any, paths: list[str]) -> list[str]:
    """A hash of each file and of the tables that it names."""
    if client is None:
        return [contents(p) for p in paths]
    batches = client.map(_contents, list(chunks(paths, 64)), pure=False, retries=2)
    return [key for batch in client.gather(batches) for key in batch]


def _contents(paths: list[str]) -> list[str]:
    return [contents(p) for p in paths]


def contents(path: str) -> str:
    """A hash of a recording: of its file and of the tables that it names."""
    try:
        return digest(*(sha for _, sha in native.Recording.read(path).sources))
    except Error as e:
        # not to be read: its bytes, so that it is tried again when it has changed
        try:
            return digest(str(e), hashlib.sha256(Path(path).read_bytes()).hexdigest())
        except OSError:
            return digest(str(e))

"""Parts of a result: Parquet files that appear whole or not at all, and who makes them."""

from __future__ import annotations

import hashlib
import json
import os
import uuid
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

import pyarrow as pa
import pyarrow.parquet as pq

from .._errors import InputError, NotComputedError

T = TypeVar("T")

CARD = "_fleet.json"
"""What a folder holds; results of something else are refused. Readers of Parquet skip the name."""


@dataclass(frozen=True)
class Progress:
    """What a call has done."""

    out: Path
    parts_made: int
    rows_made: int
    rows_found: int
    """Rows that an earlier call had made already."""


def digest(*things: str) -> str:
    """A name for contents."""
    return hashlib.sha256("\0".join(things).encode()).hexdigest()[:24]


def open_folder(out: str | os.PathLike[str], card: dict[str, Any]) -> Path:
    """Makes the folder, or sees that it holds results of the same work."""
    folder = Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / CARD
    if file.exists():
        found = read_card(folder)
        if found != card:
            other = [k for k in card if found.get(k) != card[k]]
            raise InputError(
                f"{folder} holds results of another {' and '.join(other) or 'work'}\n"
                "help: give another folder, or remove this one"
            )
        return folder
    if any(folder.glob("*.parquet")):
        raise InputError(f"{folder} holds Parquet files of something else\nhelp: give a folder of its own")
    _replace(file, lambda temporary: temporary.write_text(json.dumps(card, indent=1), "utf-8"))
    return folder


def read_card(out: str | os.PathLike[str]) -> dict[str, Any]:
    """What the folder holds."""
    file = Path(out) / CARD
    if not file.exists():
        raise InputError(f"{out} holds no results of a fleet: there is no {CARD}")
    card: dict[str, Any] = json.loads(file.read_text("utf-8"))
    return card


def part(folder: Path, name: str) -> Path:
    """The file of a part."""
    return folder / f"part-{name}.parquet"


def parts(folder: Path) -> list[Path]:
    """The finished parts, in an order that does not depend on when they were made."""
    return sorted(folder.glob("part-*.parquet"))


def read_part(file: Path, columns: list[str] | None = None) -> pa.Table:
    """A finished part; an error that names it where it was damaged since."""
    try:
        return pq.read_table(file, columns=columns)
    except (pa.ArrowException, OSError) as e:
        raise InputError(f"{file}: this part of the results is damaged: {e}\nhelp: remove it; what it held is made anew") from e


def write_part(folder: Path, name: str, table: pa.Table) -> None:
    """Writes a part beside its place and moves it there whole."""
    _replace(part(folder, name), lambda temporary: pq.write_table(table, temporary))


def _replace(file: Path, write: Callable[[Path], Any]) -> None:
    temporary = file.with_name(f".{file.name}.{uuid.uuid4().hex}.tmp")
    try:
        write(temporary)
        with open(temporary, "rb") as written:
            os.fsync(written.fileno())
        os.replace(temporary, file)
    finally:
        temporary.unlink(missing_ok=True)


def sweep_up(folder: Path) -> None:
    """Takes away what killed workers left; for the end of a call that made all its parts."""
    for left in folder.glob(".part-*.tmp"):
        left.unlink(missing_ok=True)


def chunks(items: list[T], size: int) -> Iterator[list[T]]:
    """The items, so many at a time."""
    for start in range(0, len(items), size):
        yield items[start : start + size]


def do(
    client: Any, work: Callable[..., int], tasks: Iterable[tuple[str, tuple[Any, ...]]]
) -> tuple[list[int], list[str]]:
    """Does named tasks here, or on a Dask client; the numbers that they return, and what failed.

    Not more than some hundreds of tasks are with the scheduler at a time, so that a sweep of any
    length fits into its memory.
    """
    if client is not None and not hasattr(client, "submit"):
        raise TypeError(f"a client is a dask.distributed.Client or None, not {type(client).__name__}")
    if client is None:
        return [work(*arguments) for _, arguments in tasks], []
    from distributed import as_completed

    waiting = iter(tasks)
    flowing = as_completed()
    done: list[int] = []
    failures: list[str] = []

    def submit() -> None:
        for name, arguments in waiting:
            # a name that no other call has: a failure of before is not remembered
            key = f"gyrospec-{name}-{uuid.uuid4().hex}"
            flowing.add(client.submit(on_worker, work, *arguments, key=key, retries=2))
            return

    for _ in range(AHEAD):
        submit()
    for future in flowing:
        if future.status == "finished":
            done.append(future.result())
        else:
            failures.append(f"{future.key}: {future.exception()!r}")
        submit()
    return done, failures


def on_worker(work: Callable[..., int], *arguments: Any) -> int:
    """Does a task with as many threads as Dask gives the worker, so that workers do not crowd each other."""
    from distributed import get_worker

    # read once, when the native half first shares work between threads
    os.environ.setdefault("RAYON_NUM_THREADS", str(get_worker().state.nthreads))
    return work(*arguments)


AHEAD = 256
"""Tasks that are with the scheduler at a time."""


def finish(folder: Path, failures: list[str]) -> None:
    """Sweeps up, or says what could not be made."""
    if not failures:
        sweep_up(folder)
        return
    shown = "\n".join(failures[:5])
    raise NotComputedError(
        f"{len(failures)} parts could not be made, the others are in {folder}:\n{shown}\n"
        "help: call again to try these again"
    )

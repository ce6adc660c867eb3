"""Models and recordings from whatever a notebook has at hand."""

from __future__ import annotations

import difflib
import os
import pathlib
import warnings
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Protocol, TypeAlias, cast, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import FileError, InputError, UnitsError, UsageError, Warning
from ._gyrospec import Model, Recording

# files that pandas reads for this package; a pickle may run anything, and is not among them
PANDAS = {
    ".parquet": "read_parquet",
    ".pq": "read_parquet",
    ".feather": "read_feather",
    ".orc": "read_orc",
    ".xlsx": "read_excel",
    ".xlsm": "read_excel",
    ".xlsb": "read_excel",
    ".xls": "read_excel",
    ".ods": "read_excel",
    ".h5": "read_hdf",
    ".hdf5": "read_hdf",
    ".dta": "read_stata",
    ".sas7bdat": "read_sas",
    ".xpt": "read_sas",
    ".sav": "read_spss",
}

Floats: TypeAlias = NDArray[np.float64]


@runtime_checkable
class Frame(Protocol):
    """A table of named columns: a pandas or Polars frame."""

    @property
    def columns(self) -> Any: ...

    def __getitem__(self, name: Any, /) -> Any: ...


class Series(Protocol):
    """A named column: a pandas or Polars series or index."""

    def to_numpy(self) -> Any: ...

    def __len__(self) -> int: ...


Column: TypeAlias = ArrayLike | Series
Columns: TypeAlias = Mapping[str, Column] | Frame
ModelLike: TypeAlias = Model | str | os.PathLike[str]
RecordingLike: TypeAlias = Recording | str | os.PathLike[str] | Columns
Spans: TypeAlias = Sequence[tuple[float, float]]


def as_model(given: ModelLike) -> Model:
    """A model object as it is; a path is read; a text of several lines is a model file's."""
    if isinstance(given, Model):
        return given
    if isinstance(given, str) and "\n" in given:
        return Model.parse(given)
    if not isinstance(given, (str, os.PathLike)):
        raise TypeError(f"a model is a path, a model file's text or a Model, not {type(given).__name__}")
    if isinstance(given, str) and not os.path.exists(given) and given in Model.builtins():
        raise FileError(
            f"{given}: no such file\nhelp: the model that comes along is Model.builtin({given!r})"
        )
    return Model.read(given)


def recording(
    data: RecordingLike,
    *,
    units: Mapping[str, str] | None = None,
    time: str | Column | None = None,
    name: str | None = None,
    kind: str = "time",
    wraps: Iterable[str] = (),
    hold: Iterable[str] = (),
    fit: Spans = (),
    holdout: Spans = (),
    constants: Mapping[str, tuple[float, str]] | None = None,
) -> Recording:
    """A recording of a file, or of the columns of a dict, a pandas or a Polars frame, or an xarray dataset.

    Files that the program does not read itself (Parquet, Feather, workbooks of spreadsheets, HDF5, Stata, SAS and more)
    are read by pandas, and are frames then.

    Columns become channels if `units` names them or their name carries its unit, as `roll [deg]`;
    others are left out. Columns of doubles are read where they lie.

    units: the unit of each column, `{"t": "s", "roll": "deg"}`.
    time: the column of time, by default the first, or a pandas frame's index where that holds dates or
        has a unit; or the times themselves, in s. Times of day (datetime64, with or without a time
        zone) count in s from the first.
    kind: "trials" for a table of steady trials, which has no time.
    wraps: columns whose angle jumps by a turn.
    hold: inputs that keep their value until the next sample.
    fit, holdout: spans of time in s (rows of trials) that are fitted and held out; without them the
        last 40 % are held out.
    constants: known constants of this recording, `{"lat": (46.5, "deg")}`.
    """
    if isinstance(data, Recording):
        return data
    if isinstance(data, (str, os.PathLike)) and (frame := _by_pandas(data)) is not None:
        name, data = name or pathlib.PurePath(data).stem, frame
    if isinstance(data, (str, os.PathLike)):
        given = (units, time, name, wraps, hold, fit, holdout, constants)
        if any(x is not None and not (isinstance(x, tuple) and x == ()) for x in given) or kind != "time":
            raise UsageError(
                "a file says its units and spans itself: give the path alone, or a frame's columns"
            )
        read = Recording.read(data)
        for note in read.notes:
            warnings.warn(note, Warning, stacklevel=3)
        return read
    if kind not in ("time", "trials"):
        raise UsageError(f"kind is 'time' or 'trials', not {kind!r}")
    of = dict(units or {})
    columns = _columns(_of_xarray(data, of), of, time)
    clock, columns = (None, columns) if kind == "trials" else _clock(columns, time, of)
    if kind == "trials" and time is not None:
        raise UsageError("a table of trials has no time")
    channels = _channels(columns, of)
    wrapping, holding = _known("wraps", wraps, channels), _known("hold", hold, channels)
    return Recording.of_columns(
        name or "recording",
        clock,
        [(n, unit, values, n in wrapping, n in holding) for n, (unit, values) in channels.items()],
        {
            "fit": [(float(a), float(b)) for a, b in fit],
            "holdout": [(float(a), float(b)) for a, b in holdout],
            "constants": [_constant(n, c) for n, c in (constants or {}).items()],
        },
    )


def listed(given: RecordingLike | Sequence[RecordingLike] | None) -> list[RecordingLike]:
    """One recording, several or none."""
    if given is None:
        return []
    return list(given) if isinstance(given, (list, tuple)) else [cast(RecordingLike, given)]


def as_recordings(
    given: list[RecordingLike],
    units: Mapping[str, str] | None = None,
    time: str | Column | None = None,
) -> list[Recording]:
    """Recordings; `units` and `time` are those of frames among them."""
    said = units is not None or time is not None
    if said and all(isinstance(r, (Recording, str, os.PathLike)) and not _of_pandas(r) for r in given):
        raise UsageError("units and time are for frames: a file, and a Recording, says them itself")
    return [_one(r, units, time) for r in given]


def _one(given: RecordingLike, units: Mapping[str, str] | None, time: str | Column | None) -> Recording:
    if isinstance(given, (Recording, str, os.PathLike)) and not _of_pandas(given):
        return recording(given)
    return recording(given, units=units, time=time)


def _of_pandas(given: object) -> str | None:
    """The function of pandas that reads a file of this name; none where the program reads it itself."""
    if not isinstance(given, (str, os.PathLike)):
        return None
    return PANDAS.get(pathlib.PurePath(given).suffix.lower())


def _by_pandas(file: str | os.PathLike[str]) -> Any:
    """The frame in a file that pandas reads."""
    reader = _of_pandas(file)
    if reader is None:
        return None
    try:
        import pandas
    except ImportError as e:
        raise FileError(f"{file}: pandas reads such files, and is not installed\nhelp: pip install pandas") from e
    try:
        frame = getattr(pandas, reader)(file)
    except ImportError as e:
        raise FileError(f"{file}: pandas needs another package to read it: {e}") from e
    except Exception as e:
        raise FileError(f"{file}: pandas cannot read it: {e}") from e
    if isinstance(frame, dict):
        raise InputError(f"{file}: it holds several tables\nhelp: give one of them as a frame")
    return frame


def _columns(data: Columns, units: Mapping[str, str], time: object) -> dict[str, Any]:
    if isinstance(data, Mapping):
        return {str(n): data[n] for n in data}
    if isinstance(data, Frame):
        names = [str(n) for n in data.columns]
        for i, name in enumerate(names):
            if name in names[:i]:
                raise InputError(f"two columns have the name `{name}`\nhelp: rename or drop one of them")
        columns = {str(n): data[n] for n in data.columns}
        index = _index(data, units, time)
        return columns if index is None or index[0] in columns else {index[0]: index[1], **columns}
    raise TypeError(
        f"a recording is a path, a dict of columns or a pandas or Polars frame, not {type(data).__name__}"
    )


def _of_xarray(data: Any, units: dict[str, str]) -> Any:
    """The columns of an xarray dataset or array, its coordinate first, with the units of their attributes."""
    if not (hasattr(data, "dims") and hasattr(data, "coords")):
        return data
    if hasattr(data, "to_dataset") and not hasattr(data, "data_vars"):
        data = data.to_dataset(name=data.name or "value")
    if len(data.sizes) != 1:
        raise InputError(
            f"the dataset has the dimensions {', '.join(map(str, data.sizes)) or '(none)'}, where one of time is wanted\n"
            "help: select one row of the others: data.isel(other=0), or data.to_dataset('other')"
        )
    (clock,) = data.sizes
    columns = {str(clock): data.coords[clock]} if clock in data.coords else {}
    columns |= {str(n): v for n, v in data.data_vars.items()}
    for n, v in columns.items():
        unit = v.attrs.get("units")
        if isinstance(unit, str) and _split(n)[1] is None:
            units.setdefault(n, unit)
    return {n: v.values for n, v in columns.items()}


def _index(data: Frame, units: Mapping[str, str], time: object) -> tuple[str, Any] | None:
    """A pandas frame's index with its name, where it is the time: dates, asked for, or with a unit."""
    index = getattr(data, "index", None)
    if index is None or not hasattr(index, "dtype") or not hasattr(index, "to_numpy"):
        return None
    name = "time" if index.name is None else str(index.name)
    bare, unit = _split(name)
    said = index.name is not None and (unit is not None or name in units or bare in units)
    asked = index.name is not None and time in (name, bare)
    is_date = getattr(index.dtype, "kind", "O") in "mM"
    return (name, index) if is_date or said or asked else None


def _clock(
    columns: dict[str, Any], time: str | Column | None, units: dict[str, str]
) -> tuple[tuple[Floats, str, str], dict[str, Any]]:
    """The times with their unit, and the columns that are left."""
    if time is not None and not isinstance(time, str):
        return (_doubles("time", time)[0], "s", "time"), columns
    if not columns:
        raise InputError("the recording has no columns")
    asked = next(iter(columns)) if time is None else time
    column = _find(asked, columns)
    values, is_date = _doubles(column, columns[column])
    bare, unit = _split(column)
    unit = units.pop(column, None) or units.pop(bare, None) or unit or ("s" if is_date else None)
    if unit is None:
        raise UnitsError(
            f"the column of time, `{column}`, has no unit\n"
            f"help: give units={{{column!r}: 's', ...}}, or say which column is the time: time='...'"
        )
    return (values, unit, column), {n: v for n, v in columns.items() if n != column}


def _channels(columns: dict[str, Any], units: dict[str, str]) -> dict[str, tuple[str, Floats]]:
    channels: dict[str, tuple[str, Floats]] = {}
    for column, values in columns.items():
        bare, unit = _split(column)
        unit = units.pop(column, None) or units.pop(bare, None) or unit
        if unit is not None and bare in channels:
            raise InputError(f"two columns have the name `{bare}`")
        if unit is not None:
            channels[bare] = (unit, _doubles(column, values)[0])
    for unknown in units:
        raise InputError(
            f"units names `{unknown}`, but there is no such column\n{_nearest(unknown, columns)}"
        )
    if not channels:
        raise UnitsError(
            "no column has a unit\nhelp: give units={'roll': 'deg', ...}, or name the columns 'roll [deg]'"
        )
    return channels


def _known(option: str, names: Iterable[str], channels: Mapping[str, object]) -> set[str]:
    all_names = {names} if isinstance(names, str) else set(names)
    for unknown in all_names - set(channels):
        raise InputError(
            f"{option} names `{unknown}`, but there is no such channel\n{_nearest(unknown, channels)}"
        )
    return all_names


def _constant(name: str, given: tuple[float, str]) -> tuple[str, float, str]:
    if not (isinstance(given, (tuple, list)) and len(given) == 2 and isinstance(given[1], str)):
        raise InputError(f"the constant `{name}` is {given!r}\nhelp: give its value and unit, (46.5, 'deg')")
    return name, float(given[0]), given[1]


def _find(name: str, columns: Mapping[str, object]) -> str:
    for column in columns:
        if name in (column, _split(column)[0]):
            return column
    raise InputError(f"there is no column `{name}`\n{_nearest(name, columns)}")


def _nearest(name: str, known: Iterable[str]) -> str:
    known = list(known)
    near = difflib.get_close_matches(name, known, 1)
    meant = f"did you mean `{near[0]}`? " if near else ""
    return f"help: {meant}there are {', '.join(known)}"


def _split(column: str) -> tuple[str, str | None]:
    """`roll [deg]` is roll in deg."""
    head, bracket, tail = column.strip().rpartition("[")
    return (head.strip(), tail[:-1].strip()) if bracket and tail.endswith("]") else (column.strip(), None)


def _doubles(name: str, values: Any) -> tuple[Floats, bool]:
    """Doubles, not copied where they are such; whether they were times of day."""
    if hasattr(values, "to_numpy") and not isinstance(values, np.ndarray):
        values = _of_series(values)
    given: Any = values
    if isinstance(values, np.ma.MaskedArray) and given.dtype.kind in "biuf":
        values = given.astype(np.float64).filled(np.nan)
    array = np.asarray(values)
    if array.ndim != 1:
        raise InputError(f"the column `{name}` has the shape {array.shape}, not one row of numbers")
    if array.dtype.kind in "mM":
        since = array - array[0] if array.dtype.kind == "M" and len(array) else array
        seconds = since.astype("timedelta64[ns]").astype(np.float64) * 1e-9
        seconds[np.isnat(array)] = np.nan
        return seconds, True
    if array.dtype.kind == "c":
        raise InputError(f"the column `{name}` holds complex numbers")
    try:
        return np.asarray(array, dtype=np.float64), False
    except (TypeError, ValueError):
        row, value = next((i, x) for i, x in enumerate(array.tolist()) if not _is_number(x))
        raise InputError(
            f"the column `{name}` holds {value!r} in row {row} (from 0), which is no number\n"
            "help: a gap is NaN"
        ) from None


def _is_number(x: Any) -> bool:
    try:
        float(x)
    except (TypeError, ValueError):
        return False
    return True


def _of_series(values: Any) -> Any:
    """A pandas or Polars series as an array; gaps become NaN, and times with a zone those of UTC."""
    if getattr(getattr(values, "dtype", None), "tz", None) is not None:
        zoned = getattr(values, "dt", values)
        values = zoned.tz_convert(None)
    if type(values).__module__.startswith("pandas") and getattr(values.dtype, "kind", "O") not in "mMOc":
        return values.to_numpy(dtype=np.float64, na_value=np.nan)
    return values.to_numpy()

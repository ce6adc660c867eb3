"""The native half: numbers in, numbers and JSON out. Use the names in `gyrospec` instead."""

import os
from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "VERSION",
    "Integral",
    "Model",
    "Recording",
    "Simulated",
    "Told",
    "diagnose",
    "elastic_options",
    "fit",
    "identify",
    "integral",
    "integral_batch",
    "pendulous",
    "powers",
    "roll_error",
    "roll_error_sweep",
    "simulate",
    "strapdown",
    "table",
    "unit_of",
]

VERSION: str

_Floats: TypeAlias = NDArray[np.float64]
_Row: TypeAlias = Sequence[float] | NDArray[np.floating[Any]] | NDArray[np.integer[Any]]

@final
class Integral:
    """A value of I_n with what is known of it."""

    @property
    def value(self) -> float:
        """The integral."""
    @property
    def error_bound(self) -> float:
        """abs(value - exact) <= error_bound for the doubles given, guaranteed."""
    @property
    def condition(self) -> float:
        """Relative change of the value by relative changes of the coefficients."""
    @property
    def method(self) -> str:
        """The method that gave the value: recursion, recursion-double-double, exact."""
    def to_dict(self) -> dict[str, Any]:
        """The fields by name, as `gyrospec integral --json` has them."""
    def to_json(self) -> str:
        """The line that `gyrospec integral --json` prints."""
    def __float__(self) -> float: ...
    def __eq__(self, other: object, /) -> bool: ...
    def _repr_html_(self) -> str: ...

def integral(h: _Row | Any, g: _Row | None = None, *, c: _Row | None = None) -> Integral:
    """The spectral integral I_n, within two units in the last place of the exact value.

    I_n = 1/(2 pi) * integral of G(jw)/(H(jw) H(-jw)) over all w, the variance of noise behind a filter.

    h: a0 a1 ... an of H(s) = a0 s^n + ... + an.
    g: b0 ... b(n-1) of the even G(s) = b0 s^(2n-2) + b1 s^(2n-4) + ... + b(n-1).
    c: instead of g, C with G(s) = C(s) C(-s), highest power first.

    Raises InputError, UnstableError, ImaginaryAxisError, OutOfRangeError.

    >>> integral([1, 2, 3], [0, 1]).value   # b1/(2 a1 a2)
    0.08333333333333333
    """

def integral_batch(
    h: ArrayLike, g: ArrayLike, *, fast: bool = True
) -> tuple[_Floats, _Floats, NDArray[np.uint8]]: ...
def table(orders: str, format: str) -> str: ...
def elastic_options() -> list[tuple[str, str, str]]: ...
def roll_error(
    compass: Model | str | os.PathLike[str] | None, recording: Recording | None, options: Sequence[str]
) -> Told: ...
def roll_error_sweep(columns: Mapping[str, ArrayLike]) -> _Floats: ...
def identify(words: Sequence[str]) -> str: ...
def pendulous(options: Sequence[str]) -> str: ...
def simulate(model: Model, recording: Recording, tolerance: float) -> Simulated: ...
def strapdown(options: Sequence[str]) -> str: ...
def fit(
    model: Model, recordings: Sequence[Recording], holdout: Sequence[Recording], seed: int, time_limit: float | None
) -> Told: ...
def diagnose(
    model: Model, recordings: Sequence[Recording], holdout: Sequence[Recording], seed: int, time_limit: float | None
) -> Told: ...

@final
class Model:
    """A model: inputs, parameters, definitions, states, outputs; read once, used often."""

    @staticmethod
    def read(path: str | os.PathLike[str]) -> Model:
        """Reads a model file."""
    @staticmethod
    def parse(text: str) -> Model:
        """Reads the text of a model file."""
    @staticmethod
    def builtin(name: str) -> Model:
        """One of the models that come along; `Model.builtins()` lists them."""
    @staticmethod
    def builtins() -> list[str]:
        """Names of the models that come along."""
    @property
    def name(self) -> str:
        """Its name."""
    @property
    def inputs(self) -> list[str]:
        """Names of the measured signals that drive it."""
    @property
    def states(self) -> list[str]:
        """Names of its states."""
    @property
    def outputs(self) -> list[str]:
        """Names of the measured signals that it predicts."""
    @property
    def parameters(self) -> dict[str, float]:
        """Values of the parameters, in their units."""
    @property
    def units(self) -> dict[str, str]:
        """The unit of every input, parameter, definition, state and output."""
    def replace(self, **values: float) -> Model:
        """The same model with other values of parameters, in their units."""
    def to_toml(self) -> str:
        """The model as a file."""
    def __eq__(self, other: object, /) -> bool: ...
    def _repr_html_(self) -> str: ...

@final
class Recording:
    """Measured signals on one clock, or a table of steady trials."""

    @staticmethod
    def read(path: str | os.PathLike[str]) -> Recording:
        """Reads a CSV file, an NMEA 0183 log, or a TOML file that names its tables."""
    @staticmethod
    def of_columns(
        name: str,
        time: tuple[ArrayLike, str, str] | None,
        columns: Sequence[tuple[str, str, ArrayLike, bool, bool]],
        known: Mapping[str, Any],
    ) -> Recording:
        """Use `gyrospec.recording` instead."""
    @property
    def name(self) -> str:
        """Its name in reports."""
    @property
    def kind(self) -> str:
        """ "time" or "trials"."""
    @property
    def channels(self) -> list[str]:
        """Names of its channels."""
    @property
    def units(self) -> dict[str, str]:
        """The unit of each channel."""
    @property
    def sources(self) -> list[tuple[str, str]]:
        """Its files, each with its SHA-256; what came from memory stands in angle brackets."""
    @property
    def notes(self) -> list[str]:
        """What was noticed while it was read."""
    def channel(self, name: str) -> tuple[_Floats, _Floats]:
        """Times in s (row numbers of trials) and values of a channel in its unit; NaN is a gap."""

@final
class Simulated:
    @property
    def outputs(self) -> list[tuple[str, str]]: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def solver_error(self) -> float: ...
    @property
    def text(self) -> str: ...
    def output(self, number: int) -> tuple[_Floats, _Floats, _Floats, float, float]: ...
    def trace(self, time: Sequence[float] | _Floats) -> list[tuple[str, str, _Floats]]: ...

@final
class Told:
    @property
    def json(self) -> str: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def model(self) -> Model | None: ...
    @property
    def picture(self) -> str: ...
    def text(self) -> str: ...
    def html(self) -> str: ...

def powers(unit: str) -> list[float]:
    """Powers of m, kg, s, A and K of a unit; angles count as 1."""

def unit_of(powers: Sequence[float]) -> str:
    """The SI unit of such powers."""

"""What can go wrong: one exception a kind, with the text that the program prints."""

from __future__ import annotations

__all__ = [
    "Error",
    "FileError",
    "ImaginaryAxisError",
    "InputError",
    "NotComputedError",
    "OutOfRangeError",
    "UnitsError",
    "UnstableError",
    "UsageError",
    "Warning",
]


class Error(Exception):
    """Everything that gyrospec refuses; its text says what is wrong and what to do."""

    file: str | None = None
    """The file that the error is in."""
    line: int | None = None
    """The line, counted from 1."""
    column: int | None = None
    """The column, counted from 1."""
    hint: str | None = None
    """What to do about it."""


class InputError(Error, ValueError):
    """The input is wrong: numbers, lengths, text that cannot be read."""


class UsageError(InputError):
    """The call is wrong: an argument, a combination of arguments."""


class UnitsError(InputError):
    """A unit is unknown, or two dimensions do not agree."""


class FileError(Error, OSError):
    """A file cannot be read or written."""


class NotComputedError(Error, ArithmeticError):
    """The input is in order, but there is no answer to the promised accuracy."""


class UnstableError(NotComputedError):
    """The polynomial H has roots in the right half plane, so that the integral is infinite."""

    right_half_plane_roots: int = 0
    """How many; decided exactly."""


class ImaginaryAxisError(NotComputedError):
    """The polynomial H has a root on the imaginary axis; decided exactly."""


class OutOfRangeError(NotComputedError):
    """The value is no finite normal double."""

    decimal: str = ""
    """The value in decimal."""


class Warning(UserWarning):  # noqa: A001 - gyrospec.Warning reads as it should
    """Something that one should know though the work went on."""


for _name in __all__:
    globals()[_name].__module__ = "gyrospec"

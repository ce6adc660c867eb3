"""What all results have in common: the fields of the program's JSON reports; null is NaN."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, field
from html import escape
from typing import Any, TypeVar

import numpy as np

from .._errors import UsageError
from .._gyrospec import Model, Recording, Told, simulate
from .._inputs import Floats
from .._reading import read
from . import _plot

R = TypeVar("R", bound="Report")


@dataclass(frozen=True)
class Report:
    """A result that is also a JSON report."""

    _json: str = field(repr=False, compare=False, kw_only=True, default="")
    _told: Told | None = field(repr=False, compare=False, kw_only=True, default=None)
    _text: str = field(repr=False, compare=False, kw_only=True, default="")
    _model: Model | None = field(repr=False, compare=False, kw_only=True, default=None)
    _html: str | None = field(repr=False, compare=False, kw_only=True, default=None)
    _runs: tuple[dict[str, Model], Recording] | None = field(repr=False, compare=False, kw_only=True, default=None)

    @classmethod
    def _of(cls: type[R], told: Told) -> R:
        report = read(cls, json.loads(told.json))
        for name, value in (("_json", told.json), ("_told", told), ("_model", told.model)):
            object.__setattr__(report, name, value)
        return report

    def to_json(self) -> str:
        """The report as the program writes it."""
        return self._json

    def to_dict(self) -> dict[str, Any]:
        """The report as dicts and lists; numbers that are not finite are None."""
        data: dict[str, Any] = json.loads(self._json)
        return data

    def plot(self) -> Any:
        """A Matplotlib figure of the first recording: each output measured and predicted, and what is left."""
        if self._runs is None:
            raise UsageError("a result that came out of a pickle has no recording to plot\nhelp: plot it where it was made")
        models, recording = self._runs
        drawn: dict[str, Any] = {}
        for label, model in models.items():
            for name, unit, time, measured, predicted in _predicted(model, recording):
                drawn.setdefault(name, (name, unit, time, measured, {}))[4][label] = predicted
        return _plot.pairs(list(drawn.values()))

    def _with(self: R, models: dict[str, Model], recording: Recording) -> R:
        """The same, which knows what to plot."""
        object.__setattr__(self, "_runs", (models, recording))
        return self

    def text(self) -> str:
        """The report in words, as the program prints it."""
        return self._told.text() if self._told else self._text

    def html(self) -> str:
        """The report as one page that opens offline."""
        if self._told:
            return self._told.html()
        return self._html or f"<pre>{escape(self._text)}</pre>"

    def __str__(self) -> str:
        return self.text()

    def __getstate__(self) -> dict[str, Any]:
        # the native half stays behind; its words and its page go along
        state = dict(self.__dict__)
        state.update(_told=None, _runs=None, _text=self.text(), _html=self.html())
        return state

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)


@dataclass(frozen=True)
class Made:
    """How an answer was made."""

    program: str
    seed: int
    inputs: list[InputFile]
    ended_early: bool | str = False
    """What ended a diagnosis before it was through, `steps` or `time`; False where it was through."""


@dataclass(frozen=True)
class InputFile:
    """A file with its hash; what came from memory stands in angle brackets."""

    file: str
    sha256: str


@dataclass(frozen=True)
class Value:
    """A value with its 95 % interval."""

    name: str
    value: float
    low: float
    high: float
    unit: str


def _predicted(model: Model, recording: Recording) -> list[tuple[str, str, Floats, Floats, Floats]]:
    """Name, unit, times, measured and predicted of each output."""
    ran = simulate(model, recording, 1e-5)
    return [(name, unit, *ran.output(i)[:3]) for i, (name, unit) in enumerate(ran.outputs)]


def number(x: float) -> float | None:
    return x if np.isfinite(x) else None


def table(head: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> str:
    def row(cells: tuple[str, ...], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{escape(c)}</{tag}>" for c in cells) + "</tr>"

    return "<table>" + row(head, "th") + "".join(row(r, "td") for r in rows) + "</table>"

"""Results: the fields of the program's JSON reports under the same names; null is NaN."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, fields
from html import escape
from typing import Any, ClassVar, TypeVar

import numpy as np
from numpy.typing import NDArray

from ._gyrospec import Model, Simulated, Told
from ._inputs import Floats
from ._reading import read

R = TypeVar("R", bound="_Report")


@dataclass(frozen=True)
class _Report:
    """A result that is also a JSON report."""

    _json: str = field(repr=False, compare=False, kw_only=True, default="")
    _told: Told | None = field(repr=False, compare=False, kw_only=True, default=None)
    _text: str = field(repr=False, compare=False, kw_only=True, default="")
    _model: Model | None = field(repr=False, compare=False, kw_only=True, default=None)
    _html: str | None = field(repr=False, compare=False, kw_only=True, default=None)

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
        state.update(_told=None, _text=self.text(), _html=self.html())
        return state

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)


@dataclass(frozen=True)
class Site:
    """A place in the model."""

    kind: str
    name: str


@dataclass(frozen=True)
class Value:
    """A value with its 95 % interval."""

    name: str
    value: float
    low: float
    high: float
    unit: str


@dataclass(frozen=True)
class Visible:
    """The smallest size of a mechanism that this recording would have shown."""

    code: str
    parameter: str
    value: float
    unit: str


@dataclass(frozen=True)
class Detection:
    """Whether anything is missing."""

    p_value: float
    smallest_visible: list[Visible]


@dataclass(frozen=True)
class Stretch:
    """A span of time, s; `from` is a word of Python, hence `from_`."""

    from_: float
    to: float


@dataclass(frozen=True)
class Band:
    """A band of angular frequency, rad/s, with its share of the mismatch."""

    from_: float
    to: float
    share: float


@dataclass(frozen=True)
class Signal:
    """A signal, and the chance that the mismatch does not depend on it."""

    name: str
    p_value: float


@dataclass(frozen=True)
class Located:
    """Where the mismatch sits."""

    sites: list[Site]
    time: list[Stretch]
    bands: list[Band]
    signals: list[Signal]
    separating_measurement: str | None


@dataclass(frozen=True)
class Finding:
    """A mechanism that the model leaves out."""

    code: str
    site: Site
    term: str
    says: str
    parameters: list[Value]
    p_value: float
    share: float
    ties: list[str]


@dataclass(frozen=True)
class Unexplained:
    """What no name explains: [signal, effect, low, high] along the signal."""

    p_value: float
    signal: str
    shape: list[list[float]]


@dataclass(frozen=True)
class Proof:
    """One output before and after, in its unit."""

    output: str
    unit: str
    metric: str
    mode: str
    fit_before: float
    fit_after: float
    holdout_before: float
    holdout_after: float
    improvement_low: float
    improvement_high: float
    noise_floor: float


@dataclass(frozen=True)
class ParameterChange:
    """A parameter before and after."""

    name: str
    before: float
    after: float
    low: float
    high: float
    unit: str


@dataclass(frozen=True)
class InputFile:
    """A file with its hash; what came from memory stands in angle brackets."""

    file: str
    sha256: str


@dataclass(frozen=True)
class Made:
    """How an answer was made."""

    program: str
    seed: int
    inputs: list[InputFile]


@dataclass(frozen=True, repr=False)
class Diagnosis(_Report):
    """What a model leaves out, and the proof."""

    schema: str
    verdict: str
    says: str
    detection: Detection
    located: Located
    findings: list[Finding]
    unexplained: Unexplained | None
    proof: list[Proof]
    next_experiment: str | None
    parameters: list[ParameterChange]
    made: Made

    def __repr__(self) -> str:
        found = ", ".join(f"{f.code} at {f.site.kind} {f.site.name}" for f in self.findings)
        return f"Diagnosis({self.verdict}{': ' if found else ''}{found})"

    @property
    def model_out(self) -> Model:
        """The model with the findings in it, fitted."""
        assert self._model is not None
        return self._model

    def _repr_html_(self) -> str:
        # a frame of its own: the page's style is not to reach the notebook's
        page = escape(self.html(), quote=True)
        return f'<iframe srcdoc="{page}" style="width:100%;height:40em;border:1px solid #8888"></iframe>'


@dataclass(frozen=True)
class FittedParameter(Value):
    """A parameter after the fit, and what became of it."""

    status: str


@dataclass(frozen=True)
class FittedInitial:
    """A fitted initial state."""

    recording: str
    state: str
    value: float
    low: float
    high: float
    unit: str


@dataclass(frozen=True)
class Residual:
    """What the fit leaves of an output."""

    deviation: float
    averaged_samples: int
    autoregression: list[float]
    independent_share: float


@dataclass(frozen=True)
class FittedOutput:
    """An output after the fit, in its unit."""

    output: str
    unit: str
    rmse_fit: float
    rmse_holdout: float
    residual: Residual


@dataclass(frozen=True)
class Weight:
    """A part of a direction."""

    name: str
    weight: float


@dataclass(frozen=True)
class Direction:
    """Changes of parameters that the recording cannot tell apart."""

    direction: list[Weight]
    relative_deviation: float


@dataclass(frozen=True, repr=False)
class Fit(_Report):
    """A model fitted to recordings."""

    schema: str
    model: str
    parameters: list[FittedParameter]
    initial_states: list[FittedInitial]
    outputs: list[FittedOutput]
    not_identifiable: list[Direction]
    warnings: list[str]
    end: str
    simulations: int
    made: Made

    def __repr__(self) -> str:
        values = (f"{p.name} = {p.value:.6g} {p.unit}" for p in self.parameters)
        return f"Fit({self.model}: {', '.join(values)})"

    @property
    def model_out(self) -> Model:
        """The model with the fitted values in it."""
        assert self._model is not None
        return self._model

    def __getitem__(self, name: str) -> FittedParameter:
        for p in self.parameters:
            if p.name == name:
                return p
        raise KeyError(f"{name}: the model has {', '.join(p.name for p in self.parameters)}")

    def _repr_html_(self) -> str:
        rows = [(p.name, f"{p.value:.6g}", f"{p.low:.4g} … {p.high:.4g}", p.unit, p.status) for p in self.parameters]
        outputs = [(o.output, f"{o.rmse_fit:.4g}", f"{o.rmse_holdout:.4g}", o.unit) for o in self.outputs]
        return (
            f"<p>{escape(self.model)}</p>"
            + _table(("parameter", "value", "95 % interval", "unit", ""), rows)
            + _table(("output", "rms error, fitted", "held out", "unit"), outputs)
        )


@dataclass(frozen=True)
class RollErrorRow:
    """One row: the heading error in degrees, at a heading and at what the rows run over."""

    heading_deg: float
    mean_deg: float
    sailing_deg: float
    rectified_deg: float
    spread_deg: float
    spread_linear_deg: float
    spread_quadratic_deg: float
    latitude_deg: float | None = None
    significant_height_m: float | None = None
    measured_spectrum_mean_deg: float | None = None
    simulated: dict[str, float] | None = None


@dataclass(frozen=True, repr=False)
class RollError(_Report):
    """Mean and spread of the heading error of a gyrocompass on a rolling ship."""

    schema: str
    instrument: str
    compass: dict[str, float]
    motion: str
    roll: dict[str, Any] | None
    against: str
    rows: list[RollErrorRow]
    note: str
    svg: str = field(default="", repr=False, compare=False)
    """The polar picture of the error; empty where the rows do not run over headings."""

    @classmethod
    def _of(cls, told: Told) -> RollError:
        report = super()._of(told)
        object.__setattr__(report, "svg", told.picture)
        return report

    def column(self, name: str) -> Floats:
        """A field of all rows as an array: `mean_deg`, `spread_deg`, `heading_deg` …"""
        names = [f.name for f in fields(RollErrorRow)]
        if name not in names:
            raise KeyError(f"{name}: a row has {', '.join(names)}")
        return np.array([getattr(row, name) for row in self.rows], dtype=np.float64)

    def __repr__(self) -> str:
        worst = max(self.rows, key=lambda r: abs(r.mean_deg))
        told = f"largest mean {worst.mean_deg:.4g}° ± {worst.spread_deg:.2g}° on heading {worst.heading_deg:g}°"
        return f"RollError({self.instrument}; {self.motion}: {len(self.rows)} rows, {told})"

    def _repr_html_(self) -> str:
        name = self.against
        head = (name, "mean, °", "spread, °")
        rows = [(f"{getattr(r, name):.6g}", f"{r.mean_deg:.5f}", f"{r.spread_deg:.5f}") for r in self.rows]
        words = f"<p>{escape(self.instrument)}; {escape(self.motion)}</p>"
        return words + self.svg + _table(head, rows) + f"<p>{escape(self.note)}</p>"



@dataclass(frozen=True, repr=False)
class SimulatedOutput:
    """An output beside what measured it, in its unit; NaN where there is none."""

    name: str
    unit: str
    time: Floats
    measured: Floats
    predicted: Floats
    rms_error: float
    worst_error: float

    def __repr__(self) -> str:
        told = f"{len(self.time)} samples, rms error {self.rms_error:.6g}, worst {self.worst_error:.6g}"
        return f"SimulatedOutput({self.name} [{self.unit}]: {told})"


@dataclass(frozen=True, repr=False)
class Simulation:
    """A model run on a recording."""

    outputs: list[SimulatedOutput]
    warnings: list[str]
    solver_error: float
    _simulated: Simulated = field(repr=False, compare=False)

    _units: ClassVar[str] = "units are the model's"

    @classmethod
    def _of(cls, ran: Simulated) -> Simulation:
        outputs = [SimulatedOutput(name, unit, *ran.output(i)) for i, (name, unit) in enumerate(ran.outputs)]
        return cls(outputs, ran.warnings, ran.solver_error, ran)

    def __getitem__(self, name: str) -> SimulatedOutput:
        for output in self.outputs:
            if output.name == name:
                return output
        raise KeyError(f"{name}: there are {', '.join(o.name for o in self.outputs)}")

    def __iter__(self) -> Iterator[SimulatedOutput]:
        return iter(self.outputs)

    def trace(self, time: Floats | list[float] | None = None) -> dict[str, NDArray[np.float64]]:
        """All states and definitions at rising times in s, by default those of the first output."""
        at = self.outputs[0].time if time is None else np.asarray(time, dtype=np.float64)
        columns = {name: values for name, _, values in self._simulated.trace(at)}
        return {"time": at, **columns}

    def to_dict(self) -> dict[str, Any]:
        """Outputs as dicts of lists; numbers that are not finite are None."""
        listed = [
            {
                "output": o.name,
                "unit": o.unit,
                "rms_error": _number(o.rms_error),
                "worst_error": _number(o.worst_error),
                "time": o.time.tolist(),
                "measured": [_number(x) for x in o.measured.tolist()],
                "predicted": [_number(x) for x in o.predicted.tolist()],
            }
            for o in self.outputs
        ]
        return {"outputs": listed, "solver_error": _number(self.solver_error), "warnings": self.warnings}

    def to_json(self) -> str:
        """The same as JSON."""
        return json.dumps(self.to_dict())

    def __str__(self) -> str:
        return self._simulated.text

    def __repr__(self) -> str:
        return f"Simulation({', '.join(map(repr, self.outputs))})"

    def _repr_html_(self) -> str:
        rows = [(o.name, f"{o.rms_error:.6g}", f"{o.worst_error:.6g}", o.unit) for o in self.outputs]
        return _table(("output", "rms error", "worst error", "unit"), rows)


@dataclass(frozen=True)
class IntegralBatch:
    """Many integrals: a row each; NaN where there is no value, and `status` says why."""

    STATUS: ClassVar[tuple[str, ...]] = (
        "ok",
        "unstable",
        "imaginary-axis",
        "out-of-range",
        "bad-input",
        "not-computed",
    )

    value: Floats
    error_bound: Floats
    status: NDArray[np.uint8]
    """Numbers of `STATUS`; 0 is ok."""

    @property
    def ok(self) -> NDArray[np.bool_]:
        """Which rows have a value."""
        return np.asarray(self.status == 0)

    def counts(self) -> dict[str, int]:
        """How many rows ended how."""
        found, numbers = np.unique(self.status, return_counts=True)
        return {self.STATUS[s]: int(n) for s, n in zip(found, numbers, strict=True)}

    def __len__(self) -> int:
        return len(self.value)

    def to_dict(self) -> dict[str, list[Any]]:
        """Columns as lists; None where there is no value."""
        return {
            "status": [self.STATUS[s] for s in self.status],
            "value": [_number(x) for x in self.value.tolist()],
            "error_bound": [_number(x) for x in self.error_bound.tolist()],
        }

    def to_json(self) -> str:
        """The same as JSON."""
        return json.dumps(self.to_dict())

    def __repr__(self) -> str:
        told = ", ".join(f"{n} {name}" for name, n in self.counts().items())
        return f"IntegralBatch({len(self)} rows: {told})"

    def _repr_html_(self) -> str:
        shown = min(len(self), 10)
        rows = [(self.STATUS[self.status[i]], repr(float(self.value[i])), f"{self.error_bound[i]:.2e}") for i in range(shown)]
        return f"<p>{escape(repr(self))}</p>" + _table(("status", "value", "error at most"), rows)


def _number(x: float) -> float | None:
    return x if np.isfinite(x) else None


def _table(head: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> str:
    def row(cells: tuple[str, ...], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{escape(c)}</{tag}>" for c in cells) + "</tr>"

    return "<table>" + row(head, "th") + "".join(row(r, "td") for r in rows) + "</table>"

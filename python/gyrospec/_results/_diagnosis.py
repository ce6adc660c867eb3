"""What a diagnosis tells."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from typing import Any

from .._gyrospec import Model
from . import _plot
from ._report import Made, Report, Value


@dataclass(frozen=True)
class Site:
    """A place in the model."""

    kind: str
    name: str


@dataclass(frozen=True)
class Visible:
    """The smallest size of a mechanism that this recording would have shown."""

    code: str
    site: Site
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
    recording: str | None = None
    """Whose clock it is, where several recordings are fitted."""


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
class DataFault(Finding):
    """A fault of the data; `masked`: it was kept from the fit, its samples left out or mended."""

    masked: bool


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


@dataclass(frozen=True, repr=False)
class Diagnosis(Report):
    """What a model leaves out, and the proof.

    The verdict and the findings speak of the physics, by the data without their faults; `faults` speaks of
    the data. Only where the verdict is `data-fault` do the faults stand among the findings too.
    """

    schema: str
    verdict: str
    says: str
    detection: Detection
    located: Located
    findings: list[Finding]
    faults: list[DataFault]
    unexplained: Unexplained | None
    proof: list[Proof]
    next_experiment: str | None
    parameters: list[ParameterChange]
    notes: list[str]
    """What to know beside: what was not compared, what ended at its bound, what was left unfinished."""
    made: Made

    def __repr__(self) -> str:
        found = ", ".join(f"{f.code} at {f.site.kind} {f.site.name}" for f in self.findings)
        faults = ", ".join(f"{f.code} in {f.site.name}" for f in self.faults)
        beside = f"; faults: {faults}" if faults and self.verdict != "data-fault" else ""
        return f"Diagnosis({self.verdict}{': ' if found else ''}{found}{beside})"

    @property
    def model_out(self) -> Model:
        """The model with the findings in it, fitted."""
        assert self._model is not None
        return self._model

    def to_pandas(self) -> Any:
        """A pandas frame of the findings' parameters with their 95 % intervals; a finding without one has a row too."""
        rows: list[tuple[Finding, Value | None]] = [(f, v) for f in self.findings for v in f.parameters or (None,)]
        fields = ("name", "value", "low", "high", "unit")
        columns: dict[str, list[Any]] = {"code": [f.code for f, _ in rows], "site": [f.site.name for f, _ in rows]}
        columns |= {n: [getattr(v, n, None) for _, v in rows] for n in fields}
        return _plot.frame(columns)

    def _repr_html_(self) -> str:
        # a frame of its own: the page's style is not to reach the notebook's
        page = escape(self.html(), quote=True)
        return f'<iframe srcdoc="{page}" style="width:100%;height:40em;border:1px solid #8888"></iframe>'

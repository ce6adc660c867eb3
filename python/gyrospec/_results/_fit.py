"""What a fit tells."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from typing import Any

from .._gyrospec import Model
from . import _plot
from ._report import Made, Report, Value, table


@dataclass(frozen=True)
class FittedParameter(Value):
    """A parameter after the fit, and what became of it; its interval is from the "curvature" or a "profile"."""

    status: str
    interval: str


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


@dataclass(frozen=True)
class Combination:
    """What the recording determines of parameters that it cannot tell apart."""

    expression: str
    parameters: list[str]
    value: float
    low: float
    high: float
    unit: str


@dataclass(frozen=True, repr=False)
class Fit(Report):
    """A model fitted to recordings."""

    schema: str
    model: str
    parameters: list[FittedParameter]
    initial_states: list[FittedInitial]
    outputs: list[FittedOutput]
    not_identifiable: list[Direction]
    determined: list[Combination]
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

    def to_pandas(self) -> Any:
        """A pandas frame of the parameters, by name."""
        return _plot.frame(
            {n: [getattr(p, n) for p in self.parameters] for n in ("name", "value", "low", "high", "unit", "status")}
        ).set_index("name")

    def __getitem__(self, name: str) -> FittedParameter:
        for p in self.parameters:
            if p.name == name:
                return p
        raise KeyError(f"{name}: the model has {', '.join(p.name for p in self.parameters)}")

    def _repr_html_(self) -> str:
        rows = [
            (p.name, f"{p.value:.6g}", f"{p.low:.4g} … {p.high:.4g}", p.unit, p.status)
            for p in self.parameters
        ]
        outputs = [(o.output, f"{o.rmse_fit:.4g}", f"{o.rmse_holdout:.4g}", o.unit) for o in self.outputs]
        return (
            f"<p>{escape(self.model)}</p>"
            + table(("parameter", "value", "95 % interval", "unit", ""), rows)
            + table(("output", "rms error, fitted", "held out", "unit"), outputs)
        )

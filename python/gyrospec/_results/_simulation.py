"""What a simulation tells."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._errors import UsageError
from .._gyrospec import Simulated
from .._inputs import Floats
from . import _plot
from ._report import number, table


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
    _simulated: Simulated | None = field(repr=False, compare=False)
    _text: str = field(repr=False, compare=False, default="")

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
        if self._simulated is None:
            raise UsageError(
                "a simulation that came out of a pickle has its outputs, but no trace\n"
                "help: take the trace where it was simulated"
            )
        columns = {name: values for name, _, values in self._simulated.trace(at)}
        return {"time": at, **columns}

    def to_dict(self) -> dict[str, Any]:
        """Outputs as dicts of lists; numbers that are not finite are None."""
        listed = [
            {
                "output": o.name,
                "unit": o.unit,
                "rms_error": number(o.rms_error),
                "worst_error": number(o.worst_error),
                "time": o.time.tolist(),
                "measured": [number(x) for x in o.measured.tolist()],
                "predicted": [number(x) for x in o.predicted.tolist()],
            }
            for o in self.outputs
        ]
        return {"outputs": listed, "solver_error": number(self.solver_error), "warnings": self.warnings}

    def plot(self) -> Any:
        """A Matplotlib figure: each output measured and predicted, and what is left."""
        return _plot.pairs([(o.name, o.unit, o.time, o.measured, {"predicted": o.predicted}) for o in self.outputs])

    def to_pandas(self) -> Any:
        """A pandas frame by time in s: measured, predicted and residual of each output, NaN where there is none."""
        columns: dict[str, Any] = {}
        at = np.unique(np.concatenate([o.time for o in self.outputs]))
        for o in self.outputs:
            for name, values in (("measured", o.measured), ("predicted", o.predicted)):
                columns[f"{o.name} {name}"] = np.full(len(at), np.nan)
                columns[f"{o.name} {name}"][np.searchsorted(at, o.time)] = values
            columns[f"{o.name} residual"] = columns[f"{o.name} measured"] - columns[f"{o.name} predicted"]
        return _plot.frame({"time": at, **columns}).set_index("time")

    def to_xarray(self) -> Any:
        """An xarray dataset of the same, `time` its coordinate, units as attributes."""
        made = self.to_pandas().to_xarray()
        made["time"].attrs["units"] = "s"
        for o in self.outputs:
            for name in ("measured", "predicted", "residual"):
                made[f"{o.name} {name}"].attrs["units"] = o.unit
        return made

    def to_json(self) -> str:
        """The same as JSON."""
        return json.dumps(self.to_dict())

    def __getstate__(self) -> dict[str, Any]:
        # the native half stays behind; its words go along
        return {**self.__dict__, "_simulated": None, "_text": str(self)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)

    def __str__(self) -> str:
        return self._simulated.text if self._simulated else self._text

    def __repr__(self) -> str:
        return f"Simulation({', '.join(map(repr, self.outputs))})"

    def _repr_html_(self) -> str:
        rows = [(o.name, f"{o.rms_error:.6g}", f"{o.worst_error:.6g}", o.unit) for o in self.outputs]
        return table(("output", "rms error", "worst error", "unit"), rows)

"""A simulator of which only inputs, parameters and outputs are known: fitted by whole runs, then diagnosed by its output."""

from __future__ import annotations

import json
import re
import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ._errors import InputError, NotComputedError, UsageError
from ._gyrospec import Model, Recording
from ._inputs import Floats

_ROUNDS = 30
_STEP = 1e-4
_SETTLED = 1e-9
_SPLIT = 0.6
"""Share of a recording that is fitted where it names no spans, as in `fit`."""


class Simulator:
    """A callable `(t, u, p)` beside the recording that it is to follow."""

    def __init__(
        self, call: Callable[..., Any], recording: Recording, inputs: Sequence[str], outputs: Sequence[str] | Mapping[str, Any],
        parameters: Mapping[str, Any],
    ) -> None:  # fmt: skip
        self.call = call
        self.recording = recording
        self.outputs = list(outputs)
        if not self.outputs:
            raise UsageError("a simulator needs outputs: the names of the channels that it computes")
        for n in [*inputs, *self.outputs]:
            if n not in recording.channels:
                raise InputError(f"the recording has no channel `{n}`\nhelp: there are {', '.join(recording.channels)}")
        self.values = {n: _value(n, p) for n, p in parameters.items()}
        self.free = [n for n, p in parameters.items() if not isinstance(p, Mapping) or p.get("fit", True)]
        self.bounds = {n: _bounds(p) for n, p in parameters.items()}
        self.measured = {n: recording.channel(n) for n in self.outputs}
        self.time = np.unique(np.concatenate([recording.channel(n)[0] for n in [*inputs, *self.outputs]]))
        self.inputs = {n: np.interp(self.time, *_whole(recording.channel(n))) for n in inputs}
        end = self.time[0] + _SPLIT * (self.time[-1] - self.time[0])
        self.fitted = {n: np.isfinite(v) & (t <= end) for n, (t, v) in self.measured.items()}
        self.scale = {n: _spread(v[self.fitted[n]]) for n, (_, v) in self.measured.items()}

    def run(self, values: Mapping[str, float]) -> dict[str, Floats]:
        """Its outputs at the times."""
        try:
            told = self.call(self.time.copy(), {n: u.copy() for n, u in self.inputs.items()}, dict(values))
        except Exception as e:
            raise NotComputedError(f"the simulator fails at {dict(values)}: {type(e).__name__}: {e}") from e
        if not isinstance(told, Mapping):
            rows = [told] if len(self.outputs) == 1 else told
            told = dict(zip(self.outputs, rows, strict=False)) if len(rows) == len(self.outputs) else {}
        series = {}
        for n in self.outputs:
            if n not in told:
                raise InputError(f"the simulator gives no `{n}`\nhelp: return a dict of arrays, one for each of {self.outputs}")
            series[n] = np.asarray(told[n], dtype=np.float64)
            if series[n].shape != self.time.shape:
                raise InputError(f"`{n}` of the simulator has the shape {series[n].shape}, its times {self.time.shape}")
            if not np.isfinite(series[n]).all():
                first = int(np.argmin(np.isfinite(series[n])))
                raise NotComputedError(f"`{n}` of the simulator is no number from t = {self.time[first]:g} s on, at {dict(values)}")
        return series

    def residuals(self, values: Mapping[str, float]) -> Floats:
        """Measured less simulated over the fitted part, each output by its spread."""
        series = self.run(values)
        parts = []
        for n, (t, v) in self.measured.items():
            used = self.fitted[n]
            parts.append((v[used] - np.interp(t[used], self.time, series[n])) / self.scale[n])
        return np.concatenate(parts)

    def fit(self) -> tuple[dict[str, float], int]:
        """The parameters of least squares by Levenberg and Marquardt's method, and the runs that it took."""
        values, runs, damping = dict(self.values), 1, 1e-3
        rest = self.residuals(values)
        for _ in range(_ROUNDS if self.free else 0):
            slopes = np.empty((len(rest), len(self.free)))
            sizes = np.array([self._size(n, values[n]) for n in self.free])
            for k, n in enumerate(self.free):
                h = _STEP * sizes[k] if values[n] + _STEP * sizes[k] <= self.bounds[n][1] else -_STEP * sizes[k]
                slopes[:, k] = (self.residuals({**values, n: values[n] + h}) - rest) / (h / sizes[k])
            runs += len(self.free)
            square, moved = slopes.T @ slopes, False
            while damping < 1e9 and not moved:
                step = np.linalg.lstsq(square + damping * np.diag(np.diag(square) + 1e-300), -slopes.T @ rest, rcond=None)[0]
                new = {n: float(np.clip(values[n] + d * s, *self.bounds[n])) for n, d, s in zip(self.free, step, sizes, strict=True)}
                after = self.residuals({**values, **new})
                runs += 1
                moved = bool(after @ after < rest @ rest)
                damping = damping / 5 if moved else damping * 5
            if not moved:
                break
            gained, rest, values = 1 - (after @ after) / (rest @ rest), after, {**values, **new}
            if gained < _SETTLED:
                break
        return values, runs

    def _size(self, n: str, value: float) -> float:
        """The size of a parameter, by which it is stepped: one that starts at 0 has none of its own."""
        return max(abs(value), abs(self.values[n])) or 1.0

    def slopes(self, values: Mapping[str, float], n: str) -> dict[str, Floats]:
        """Derivatives of the outputs by a parameter, by differences of two whole runs inside its bounds."""
        h = _STEP * self._size(n, values[n])
        low, high = (float(np.clip(values[n] + d, *self.bounds[n])) for d in (-h, h))
        below, above = (self.run({**values, n: v}) for v in (low, high))
        return {o: (above[o] - below[o]) / (high - low) if high > low else np.zeros_like(above[o]) for o in self.outputs}

    def model(self, values: Mapping[str, float], title: str, folder: Path) -> Model:
        """The model file of what it computes, linear in its parameters about these values; its table lies in the folder.

        y = (y0 - sum p0 dy/dp) + sum p dy/dp: what is found is fitted beside the parameters, which it may have bent.
        """
        series, units = self.run(values), self.recording.units
        names = {n: n if _is_name(n, self.recording.channels) else f"parameter_{k + 1}" for k, n in enumerate(self.free)}
        slopes = {n: self.slopes(values, n) for n in self.free}
        columns, header = [self.time], ["t [s]"]
        for o in self.outputs:
            columns.append(series[o] - sum(values[n] * slopes[n][o] for n in self.free))
            header.append(f"{o}_rest [{units[o]}]")
            for n in self.free:
                columns.append(slopes[n][o])
                header.append(f"{o}_by_{names[n]} [{'K' if units[o] == 'degC' else units[o]}]")
        np.savetxt(folder / "simulated.csv", np.column_stack(columns), delimiter=",", header=",".join(header), comments="", fmt="%.17g")
        lines = [f"name = {json.dumps(title, ensure_ascii=False)}", 'simulated = "simulated.csv"', "[parameters]"]
        for n in self.free:
            limits = "".join(f", {k} = {b!r}" for k, b in zip(("min", "max"), self.bounds[n], strict=True) if np.isfinite(b))
            lines.append(f'{names[n]} = {{ value = {values[n]!r}, unit = "1", fit = true{limits} }}')
        lines.append("[outputs]")
        for o in self.outputs:
            equals = " + ".join([f"{o}_rest_simulated", *(f"{names[n]}*{o}_by_{names[n]}_simulated" for n in self.free)])
            lines.append(f'{o} = {{ equals = "{equals}", unit = {json.dumps(units[o])} }}')
        (folder / "model.toml").write_text("\n".join(lines) + "\n", encoding="utf-8")
        return Model.read(folder / "model.toml")


def simulated(simulator: Simulator, title: str) -> tuple[Model, str]:
    """The model of a fitted simulator, and what became of its parameters."""
    values, runs = simulator.fit()
    with tempfile.TemporaryDirectory() as folder:
        model = simulator.model(values, title, Path(folder))
    told = ", ".join(f"{n} = {values[n]:.6g}" for n in simulator.free)
    note = f"the simulator was fitted by {runs} whole runs: {told}" if told else "the simulator has no parameter that is fitted"
    return model, note


def _value(n: str, given: Any) -> float:
    value = given.get("value") if isinstance(given, Mapping) else given
    if isinstance(value, bool) or not isinstance(value, (int, float, np.number)) or not np.isfinite(value):
        raise InputError(f"the parameter `{n}` is {value!r}\nhelp: give a number, or {{'value': 1.0, 'fit': True, 'min': 0.0}}")
    return float(value)


def _bounds(given: Any) -> tuple[float, float]:
    fields = given if isinstance(given, Mapping) else {}
    return float(fields.get("min", -np.inf)), float(fields.get("max", np.inf))


def _is_name(n: str, channels: Sequence[str]) -> bool:
    """Whether a parameter may have its own name in a model file."""
    return re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", n) is not None and n not in {"t", *channels} and not n.endswith("_simulated")


def _whole(samples: tuple[Floats, Floats]) -> tuple[Floats, Floats]:
    t, v = samples
    return t[np.isfinite(v)], v[np.isfinite(v)]


def _spread(values: Floats) -> float:
    spread = float(np.std(values)) if len(values) else 0.0
    return spread if spread > 0 else 1.0

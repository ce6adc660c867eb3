"""Recordings of many fields, each with one thing that its model leaves out, or with nothing.

The equations are textbooks' (the source stands beside each field); sizes, noise and seeds are fixed here.
A case: (name, truth, accepted codes); an empty set of codes means that nothing is missing, LAW that no code of the
catalogue says it and a law without a name should stand.
"""

from __future__ import annotations

import dataclasses
import zlib
from collections.abc import Callable

import numpy as np

LAW = frozenset({"free-law"})
Rates = Callable[[np.ndarray, np.ndarray, dict], list]


@dataclasses.dataclass
class Field:
    """A plant: the model as its user would write it, and the rates of the truth with `p` for what is concealed."""

    name: str
    source: str
    step: float
    count: int
    inputs: dict[str, tuple[str, Callable[[np.ndarray, np.random.Generator], np.ndarray]]]
    start: list[float]
    rates: Rates
    outputs: dict[str, tuple[str, Callable[[np.ndarray, np.ndarray, dict], np.ndarray], float]]
    model: str
    cases: dict[str, tuple[dict, frozenset[str]]]
    channels: dict[str, tuple[str, Callable[[np.ndarray, np.random.Generator], np.ndarray]]] = dataclasses.field(
        default_factory=dict
    )


def swept(size: float, mean: float = 0.0, slow: float = 20.0, lines: int = 12):
    """A sum of sines between the slowest that fits some twenty times and a fortieth of the sampling rate."""

    def of(t: np.ndarray, r: np.random.Generator) -> np.ndarray:
        low, high = slow / t[-1], 0.05 * 2 * np.pi / (t[1] - t[0])
        w = np.geomspace(low, high, lines)
        phase = r.uniform(0, 2 * np.pi, lines)
        return mean + size * np.sqrt(2 / lines) * np.sin(np.outer(t, w) + phase).sum(1)

    return of


def steps(low: float, high: float, last: float):
    """Levels that change at uneven times, with ramps of a few samples."""

    def of(t: np.ndarray, r: np.random.Generator) -> np.ndarray:
        out, at = np.empty_like(t), 0.0
        while at < t[-1]:
            until = at + last * r.uniform(0.4, 1.6)
            out[(t >= at) & (t <= until)] = r.uniform(low, high)
            at = until
        kernel = np.ones(5) / 5
        return np.convolve(np.pad(out, 2, mode="edge"), kernel, "valid")

    return of


def simulate(f: Field, p: dict, seed: int) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Runge and Kutta's method at a tenth of a sample, inputs straight between samples."""
    r = np.random.default_rng(seed)
    t = f.step * np.arange(f.count)
    u = np.array([make(t, r) for _, make in {**f.inputs, **f.channels}.values()])
    x = np.empty((f.count, len(f.start)))
    x[0] = f.start
    parts, h = 10, f.step / 10
    for i in range(f.count - 1):
        now, slope, s = x[i].copy(), (u[:, i + 1] - u[:, i]) / f.step, u[:, i]
        for k in range(parts):
            at = s + slope * (h * k)
            a = np.array(f.rates(now, at, p))
            b = np.array(f.rates(now + h / 2 * a, at + slope * h / 2, p))
            c = np.array(f.rates(now + h / 2 * b, at + slope * h / 2, p))
            d = np.array(f.rates(now + h * c, at + slope * h, p))
            now = now + h / 6 * (a + 2 * b + 2 * c + d)
        x[i + 1] = now
    table = dict(zip({**f.inputs, **f.channels}, u, strict=True))
    noise = np.random.default_rng(seed + 1)
    for name, (_, of, size) in f.outputs.items():
        y = of(x.T, u, p)
        table[name] = y + size * np.std(y) * noise.standard_normal(f.count)
    return t, table


def write(f: Field, case: str, folder, seed: int) -> tuple:
    """The model and the recording as files."""
    p, _ = f.cases[case]
    t, table = simulate(f, p, zlib.crc32(f"{f.name} {case} {seed}".encode()))
    units = {n: u for n, (u, *_) in {**f.inputs, **f.channels, **f.outputs}.items()}
    model, log = folder / f"{f.name}.toml", folder / f"{f.name}-{case}.csv"
    model.write_text(f.model)
    head = ",".join(["t [s]"] + [f"{n} [{units[n]}]" for n in table])
    np.savetxt(log, np.column_stack([t, *table.values()]), delimiter=",", header=head, comments="", fmt="%.9g")
    return model, log


def of(p: dict, name: str, default: float = 0.0) -> float:
    return p.get(name, default)


ONE = frozenset()

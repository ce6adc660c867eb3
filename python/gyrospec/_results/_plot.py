"""Pictures with Matplotlib, where it is at hand."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from .._errors import UsageError
from .._inputs import Floats


def figure(rows: int) -> tuple[Any, Any]:
    """A figure with so many rows of axes, two an output: signal and residual."""
    try:
        import matplotlib.pyplot as plt
    except ImportError:
        raise UsageError("plot needs Matplotlib\nhelp: pip install matplotlib, or take html()") from None
    height = [3, 1] * rows
    shape = {"height_ratios": height, "hspace": 0.15}
    return plt.subplots(2 * rows, 1, sharex=True, squeeze=False, figsize=(9, 3.2 * rows), gridspec_kw=shape)


def pairs(drawn: Sequence[tuple[str, str, Floats, Floats, Mapping[str, Floats]]]) -> Any:
    """For each output what was measured and what was predicted, and below what is left."""
    all_, axes = figure(len(drawn))
    for k, (name, unit, time, measured, predicted) in enumerate(drawn):
        signal, rest = axes[2 * k, 0], axes[2 * k + 1, 0]
        for i, (label, values) in enumerate(predicted.items()):
            signal.plot(time, values, color=f"C{i + 1}", lw=1, label=label)
            rest.plot(time, measured - values, color=f"C{i + 1}", lw=0.7)
        signal.plot(time, measured, ".", color="C0", ms=2, label="measured")
        signal.set_ylabel(f"{name} [{unit}]")
        signal.legend(loc="best", fontsize="small")
        rest.axhline(0, color="0.6", lw=0.5)
        rest.set_ylabel("measured − model", fontsize="small")
    axes[-1, 0].set_xlabel("time [s]")
    return all_


def frame(columns: Mapping[str, Any]) -> Any:
    """A pandas frame."""
    try:
        import pandas as pd
    except ImportError:
        raise UsageError("to_pandas needs pandas\nhelp: pip install pandas, or take to_dict()") from None
    return pd.DataFrame(dict(columns))

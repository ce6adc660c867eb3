"""Many integrals at once."""

from __future__ import annotations

import json
from dataclasses import dataclass
from html import escape
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from .._inputs import Floats
from ._report import number, table


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
            "value": [number(x) for x in self.value.tolist()],
            "error_bound": [number(x) for x in self.error_bound.tolist()],
        }

    def to_json(self) -> str:
        """The same as JSON."""
        return json.dumps(self.to_dict())

    def __repr__(self) -> str:
        told = ", ".join(f"{n} {name}" for name, n in self.counts().items())
        return f"IntegralBatch({len(self)} rows: {told})"

    def _repr_html_(self) -> str:
        shown = min(len(self), 10)
        rows = [
            (self.STATUS[self.status[i]], repr(float(self.value[i])), f"{self.error_bound[i]:.2e}")
            for i in range(shown)
        ]
        return f"<p>{escape(repr(self))}</p>" + table(("status", "value", "error at most"), rows)

"""What is told of a rolling error."""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from html import escape
from typing import Any

import numpy as np

from .._gyrospec import Told
from .._inputs import Floats
from ._report import Report, table


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
class RollError(Report):
    """Mean and spread of the heading error of a gyrocompass on a rolling ship."""

    schema: str
    instrument: str
    compass: dict[str, float]
    motion: str
    roll: dict[str, Any] | None
    against: str
    rows: list[RollErrorRow]
    note: str
    trusted_mean: str = "mean_deg"
    """The column of the mean to trust: `mean_deg`, or `measured_spectrum_mean_deg`."""
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

    def _mean(self, row: RollErrorRow) -> float:
        return float(getattr(row, self.trusted_mean))

    def __repr__(self) -> str:
        worst = max(self.rows, key=lambda r: abs(self._mean(r)))
        told = (
            f"largest mean {self._mean(worst):.4g}° ± {worst.spread_deg:.2g}° "
            f"on heading {worst.heading_deg:g}°"
        )
        return f"RollError({self.instrument}; {self.motion}: {len(self.rows)} rows, {told})"

    def _repr_html_(self) -> str:
        name = self.against
        head = (name, "mean, °", "spread, °")
        rows = [(f"{getattr(r, name):.6g}", f"{self._mean(r):.5f}", f"{r.spread_deg:.5f}") for r in self.rows]
        words = f"<p>{escape(self.instrument)}; {escape(self.motion)}</p>"
        return words + self.svg + table(head, rows) + f"<p>{escape(self.note)}</p>"

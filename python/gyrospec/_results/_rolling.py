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
    percentiles_deg: dict[str, float] | None = None
    """The error lies below `p5`, `p50`, `p95`, `p99` so many percent of the time."""
    skewness: float | None = None
    mean_margin_deg: float | None = None
    """Half the 99 % interval of the mean, where a part that is not linear is simulated."""
    spread_margin_deg: float | None = None
    linearised_mean_deg: float | None = None
    """The mean by stochastic linearisation of such a part, whose error nothing bounds."""
    simulated: dict[str, Any] | None = None


@dataclass(frozen=True, repr=False)
class RollError(Report):
    """Mean and spread of the heading error of a gyrocompass on a rolling ship.

    The sign of an error: + is west: the compass's north lies west of true north, and the compass reads
    high; − is east: it reads low; the true heading is the reading minus the error.
    """

    schema: str
    instrument: str
    compass: dict[str, float]
    motion: str
    roll: dict[str, Any] | None
    against: str
    rows: list[RollErrorRow]
    note: str
    white_tail: dict[str, Any] | None = None
    """The mean on heading 45° by the motion's frequencies up to each, and by what share of the largest of these
    means an end of the band above it changes it; none for a motion of finite acceleration that has hardly any
    there."""
    sea: dict[str, Any] | None = None
    """What became of a sea: how far its rational spectrum is off, and the damping of her roll in it."""
    trusted_mean: str = "mean_deg"
    """The column of the mean to trust: `mean_deg`, or `measured_spectrum_mean_deg`."""
    sign: str = ""
    """Which way an error is, in words."""
    validity: list[dict[str, Any]] = field(default_factory=list)
    """What the linear theory takes for small, where the mean is largest, and whether it holds (`None` for a
    figure that is infinite)."""
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

    def _beyond(self) -> str:
        broken = [
            f"{v['says']} {v['value']:.3g} (it holds to {v['limit']:.3g})"
            for v in self.validity
            if v["holds"] is False
        ]
        return f"BEYOND THE LINEAR THEORY: {', '.join(broken)}" if broken else ""

    def __repr__(self) -> str:
        worst = max(self.rows, key=lambda r: abs(self._mean(r)))
        told = (
            f"largest mean {self._mean(worst):.4g}° ± {worst.spread_deg:.2g}° "
            f"on heading {worst.heading_deg:g}°"
        )
        beyond = f"; {self._beyond()}" if self._beyond() else ""
        return f"RollError({self.instrument}; {self.motion}: {len(self.rows)} rows, {told}{beyond})"

    def _repr_html_(self) -> str:
        name = self.against
        head = (name, "mean, °", "spread, °")
        rows = [(f"{getattr(r, name):.6g}", f"{self._mean(r):.5f}", f"{r.spread_deg:.5f}") for r in self.rows]
        words = f"<p>{escape(self.instrument)}; {escape(self.motion)}</p><p>{escape(self._beyond())}</p>"
        return words + self.svg + table(head, rows) + f"<p>{escape(self.sign)}</p><p>{escape(self.note)}</p>"

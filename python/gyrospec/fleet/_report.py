"""What a fleet's results say together."""

from __future__ import annotations

import dataclasses
import json
import os
from collections import Counter, defaultdict
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any

import numpy as np

from .._errors import InputError
from ._parts import parts, read_card, read_part


COLUMNS = ["ship", "file", "status", "verdict", "says", "findings", "faults"]
"""What is read of a part; the whole reports stay on the disk."""


@dataclass(frozen=True)
class Mechanism:
    """One parameter of a mechanism over the fleet; `parameter` is empty where it has none."""

    code: str
    site: str
    parameter: str
    unit: str
    ships: list[str]
    recordings: int
    median: float
    low: float
    """Lower quartile of the values."""
    high: float
    """Upper quartile of the values."""
    between_ships: float
    """Standard deviation of the ships' own means; NaN with one ship."""
    uncertainty: float
    """Median half-width of the recordings' own 95 % intervals."""


@dataclass(frozen=True)
class Alike:
    """Recordings with the same verdict and the same mechanisms at the same sites."""

    verdict: str
    mechanisms: list[str]
    files: list[str]
    ships: list[str]


@dataclass(frozen=True)
class Neighbour:
    """The recording that is most like another, by the sizes of what was found in both."""

    file: str
    other: str
    distance: float
    """Root mean square difference of the parameters, each over its spread in the fleet."""


@dataclass(frozen=True)
class FleetReport:
    """A population report."""

    recordings: int
    ships: int
    verdicts: dict[str, int]
    mechanisms: list[Mechanism]
    alike: list[Alike]
    neighbours: list[Neighbour]
    faults: dict[str, dict[str, list[str]]]
    """Files whose data have a fault, by its code and the channel."""
    errors: dict[str, str]
    """Files that could not be diagnosed, and why."""

    def to_dict(self) -> dict[str, Any]:
        """As dicts and lists; numbers that are not finite are None."""
        cleaned: dict[str, Any] = _finite(dataclasses.asdict(self))
        return cleaned

    def to_json(self) -> str:
        """As JSON."""
        return json.dumps(self.to_dict(), indent=1)

    def __str__(self) -> str:
        lines = [f"{_count(self.recordings, 'recording')} of {_count(self.ships, 'ship')}"]
        lines += [f"  {n:>6}  {verdict}" for verdict, n in self.verdicts.items()]
        if self.errors:
            lines.append(f"  {len(self.errors):>6}  could not be diagnosed: {_short(list(self.errors))}")
        for code, channels in self.faults.items():
            each = ", ".join(f"{c} in {_count(len(files), 'recording')}" for c, files in channels.items())
            lines.append(f"  fault of the data, {code}: {each}")
        if self.mechanisms:
            lines.append("\nWhat is missing, and on which ships (median, quartiles, between ships)")
        for m in self.mechanisms:
            lines.append(f"  {m.code} at {m.site}: {_count(m.recordings, 'recording')} of {_short(m.ships)}")
            if m.parameter:
                between = f"between ships ±{m.between_ships:.2g}, " if len(m.ships) > 1 else ""
                lines.append(
                    f"      {m.parameter} = {m.median:.4g} [{m.low:.4g} … {m.high:.4g}] {m.unit}, "
                    f"{between}in one recording ±{m.uncertainty:.2g}"
                )
        lines.append("\nAlike")
        for a in self.alike:
            names = ", ".join(a.mechanisms) or "nothing found"
            lines.append(f"  {len(a.files):>6}  {a.verdict}: {names} ({_short(a.ships)})")
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        return f"<pre>{escape(str(self))}</pre>"


def report(out: str | os.PathLike[str]) -> FleetReport:
    """The population report of a folder that `diagnose` has filled."""
    if read_card(out)["kind"] != "diagnosis":
        raise InputError(f"{out} holds a sweep of the rolling error: read it with pandas, Polars or Dask")
    rows = _rows(Path(out))
    done = [r for r in rows if r["status"] == "ok"]
    verdicts = Counter(r["verdict"] for r in done)
    return FleetReport(
        recordings=len(rows),
        ships=len({r["ship"] for r in rows}),
        verdicts=dict(sorted(verdicts.items(), key=lambda v: (-v[1], v[0]))),
        mechanisms=_mechanisms(done),
        alike=_alike(done),
        neighbours=_neighbours(done),
        faults=_faults(done),
        errors={r["file"]: r["says"] for r in rows if r["status"] != "ok"},
    )


def _rows(folder: Path) -> list[dict[str, Any]]:
    """One row a recording: of a file that has changed meanwhile, the one that was written last."""
    latest: dict[str, dict[str, Any]] = {}
    for file in sorted(parts(folder), key=lambda p: (p.stat().st_mtime_ns, p.name)):
        for row in read_part(file, COLUMNS).to_pylist():
            latest[row["file"]] = row
    return [latest[f] for f in sorted(latest)]


def _mechanisms(rows: list[dict[str, Any]]) -> list[Mechanism]:
    found: dict[tuple[str, str, str, str], list[tuple[dict[str, Any], dict[str, Any]]]] = defaultdict(list)
    for row in rows:
        for f in row["findings"]:
            found[f["code"], f["site"], f["parameter"] or "", f["unit"] or ""].append((row, f))
    mechanisms = [_mechanism(name, members) for name, members in found.items()]
    return sorted(mechanisms, key=lambda m: (-m.recordings, m.code, m.site, m.parameter))


def _mechanism(
    name: tuple[str, str, str, str], members: list[tuple[dict[str, Any], dict[str, Any]]]
) -> Mechanism:
    code, site, parameter, unit = name
    by_ship: dict[str, list[float]] = defaultdict(list)
    for row, f in members:
        by_ship[row["ship"]].append(_float(f["value"]))
    values = np.array([v for own in by_ship.values() for v in own])
    widths = [0.5 * (_float(f["high"]) - _float(f["low"])) for _, f in members]
    low, median, high = _quantiles(values, (0.25, 0.5, 0.75))
    means = [m for m in (_quantiles(np.array(own), (0.5,))[0] for own in by_ship.values()) if np.isfinite(m)]
    return Mechanism(
        code=code,
        site=site,
        parameter=parameter,
        unit=unit,
        ships=sorted(by_ship),
        recordings=len({row["file"] for row, _ in members}),
        median=median,
        low=low,
        high=high,
        between_ships=float(np.std(means, ddof=1)) if len(means) > 1 else float("nan"),
        uncertainty=_quantiles(np.array(widths), (0.5,))[0],
    )


def _faults(rows: list[dict[str, Any]]) -> dict[str, dict[str, list[str]]]:
    found: dict[str, dict[str, list[str]]] = defaultdict(lambda: defaultdict(list))
    for row in rows:
        for code, channel in sorted({(f["code"], f["channel"]) for f in row["faults"]}):
            found[code][channel].append(row["file"])
    return {code: {c: found[code][c] for c in sorted(found[code])} for code in sorted(found)}


def _alike(rows: list[dict[str, Any]]) -> list[Alike]:
    groups: dict[tuple[str, tuple[str, ...]], list[dict[str, Any]]] = defaultdict(list)
    for row in rows:
        groups[row["verdict"], _signature(row)].append(row)
    alike = [
        Alike(verdict, list(names), [r["file"] for r in members], sorted({r["ship"] for r in members}))
        for (verdict, names), members in groups.items()
    ]
    return sorted(alike, key=lambda a: (-len(a.files), a.verdict, a.mechanisms))


def _signature(row: dict[str, Any]) -> tuple[str, ...]:
    return tuple(sorted({f"{f['code']} at {f['site']}" for f in row["findings"]}))


def _neighbours(rows: list[dict[str, Any]]) -> list[Neighbour]:
    """For each recording with findings the nearest of those with the same ones."""
    groups: dict[tuple[str, ...], list[tuple[str, dict[str, float]]]] = defaultdict(list)
    for row in rows:
        values = {f"{f['code']}@{f['site']}.{f['parameter']}": _float(f["value"]) for f in row["findings"]}
        if values:
            groups[tuple(sorted(values))].append((row["file"], values))
    nearest = []
    for names, members in groups.items():
        if len(members) < 2:
            continue
        table = np.nan_to_num(np.array([[v[n] for n in names] for _, v in members]))
        spread = table.std(axis=0)
        table = table / np.where(spread > 0, spread, 1.0)
        for i, (file, _) in enumerate(members):
            distance = np.sqrt(np.mean((table - table[i]) ** 2, axis=1))
            distance[i] = np.inf
            other = int(np.argmin(distance))
            nearest.append(Neighbour(file, members[other][0], float(distance[other])))
    return sorted(nearest, key=lambda n: (n.distance, n.file))


def _quantiles(values: Any, shares: tuple[float, ...]) -> list[float]:
    finite = values[np.isfinite(values)]
    return [float(q) for q in np.quantile(finite, shares)] if len(finite) else [float("nan")] * len(shares)


def _float(x: float | None) -> float:
    return float("nan") if x is None else x


def _count(number: int, what: str) -> str:
    return f"{number} {what}" + ("" if number == 1 else "s")


def _short(names: list[str]) -> str:
    return ", ".join(names[:6]) + (f" and {len(names) - 6} more" if len(names) > 6 else "")


def _finite(x: Any) -> Any:
    if isinstance(x, dict):
        return {k: _finite(v) for k, v in x.items()}
    if isinstance(x, list):
        return [_finite(v) for v in x]
    return None if isinstance(x, float) and not np.isfinite(x) else x

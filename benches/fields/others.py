"""PySINDy and SysIdentPy on the same recordings, beside what `run.py` left in its folder.

    pip install pysindy sysidentpy
    python benches/fields/run.py --folder DIR
    python benches/fields/others.py --folder DIR [--only TEXT]

The first 60 % of a recording are fitted, the last 40 % run free, as in `gyrospec diagnose`. Each program has a grid of
settings; the one whose free run over the last third of the fitted part is best is fitted to all of it. Neither is given
the model: they find one. Errors are root mean squares over the spread of the output, the mean of all outputs.
"""

import argparse
import contextlib
import io
import json
import pathlib
import re
import sys
import warnings

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))

import pysindy  # noqa: E402
from plants import ALL  # noqa: E402
from sysidentpy.basis_function import Polynomial  # noqa: E402
from sysidentpy.model_structure_selection import FROLS  # noqa: E402
from sysidentpy.parameter_estimation import LeastSquares  # noqa: E402

FITTED, TRIED = 0.6, 0.4
FAILED = 10.0


def scaled(a: np.ndarray, of: np.ndarray) -> np.ndarray:
    return (a - of.mean(0)) / np.where(of.std(0) > 0, of.std(0), 1)


def error(y: np.ndarray, of: np.ndarray) -> float:
    """Both scaled; what falls out or runs away counts as ten spreads."""
    e = np.sqrt(np.mean((y - of) ** 2, 0)) / np.std(of, 0)
    return float(np.mean(np.where(np.isfinite(e), np.minimum(e, FAILED), FAILED)))


def exponents(names: list[str], count: int) -> np.ndarray:
    """`x0^2 x1` as powers."""
    powers = np.zeros((len(names), count))
    for i, name in enumerate(names):
        for column, power in re.findall(r"x(\d+)(?:\^(\d+))?", name):
            powers[i, int(column)] += float(power or 1)
    return powers


def sindy(y: np.ndarray, u: np.ndarray, step: float, fit: slice, run: slice, degree: int, threshold: float,
          rates: bool) -> np.ndarray:
    differ = pysindy.SmoothedFiniteDifference(smoother_kws={"window_length": 15, "polyorder": 3})
    x = np.hstack([y, scaled(differ(y, step), differ(y[fit], step))]) if rates else y
    slope = differ(x[fit], step)
    library = pysindy.PolynomialLibrary(degree=degree)
    both = np.hstack([x, u])
    features = library.fit_transform(both[fit])
    names = library.get_feature_names([f"x{i}" for i in range(both.shape[1])])
    powers = exponents(names, both.shape[1])
    size = np.std(slope, 0)
    optimizer = pysindy.STLSQ(threshold=threshold, alpha=1e-6)
    optimizer.fit(np.asarray(features), slope / size)
    coefficients = optimizer.coef_ * size[:, None]

    def rate(x: np.ndarray, u: np.ndarray) -> np.ndarray:
        return coefficients @ np.prod(np.concatenate([x, u]) ** powers, 1)

    now, out = x[run.start].copy(), []
    for i in range(run.start, run.stop):
        out.append(now[: y.shape[1]])
        next_u = u[min(i + 1, len(u) - 1)]
        half = 0.5 * (u[i] + next_u)
        a = rate(now, u[i])
        b = rate(now + step / 2 * a, half)
        c = rate(now + step / 2 * b, half)
        d = rate(now + step * c, next_u)
        now = now + step / 6 * (a + 2 * b + 2 * c + d)
        if not np.all(np.abs(now) < 1e3):
            out += [np.full(y.shape[1], np.inf)] * (run.stop - run.start - len(out))
            break
    return np.array(out)


def narmax(y: np.ndarray, u: np.ndarray, fit: slice, run: slice, degree: int, lag: int) -> np.ndarray:
    out = []
    for k in range(y.shape[1]):
        lags = [list(range(1, lag + 1))] * u.shape[1] if u.shape[1] > 1 else lag
        model = FROLS(ylag=lag, xlag=lags, order_selection=True, n_info_values=15, info_criteria="aic",
                      estimator=LeastSquares(), basis_function=Polynomial(degree=degree))
        model.fit(X=u[fit], y=y[fit, k : k + 1])
        first = run.start - model.max_lag
        got = model.predict(X=u[first : run.stop], y=y[first : run.start, k : k + 1])
        out.append(np.asarray(got)[model.max_lag :, 0])
    return np.array(out).T


def best(of, grid: list[tuple], y: np.ndarray) -> float:
    """The held-out error at the settings that are best on the last third of the fitted part."""
    n = len(y)
    tried, fitted = slice(0, int(TRIED * n)), slice(0, int(FITTED * n))
    inner, outer = slice(tried.stop, fitted.stop), slice(fitted.stop, n)

    def judged(settings: tuple, fit: slice, run: slice) -> float:
        try:
            with np.errstate(all="ignore"), contextlib.redirect_stdout(io.StringIO()):
                return error(of(fit, run, *settings), y[run])
        except Exception:  # noqa: BLE001: a setting that cannot be fitted is one that failed
            return FAILED

    settings = min(grid, key=lambda s: judged(s, tried, inner))
    return judged(settings, fitted, outer)


def case(folder: pathlib.Path, field, name: str) -> dict | None:
    log, told = folder / f"{field.name}-{name}.csv", folder / f"{field.name}-{name}.json"
    if not log.exists():
        return None
    head = [c.split(" [")[0] for c in log.read_text().split("\n", 1)[0].split(",")]
    rows = np.loadtxt(log, delimiter=",", skiprows=1)
    column = {n: rows[:, i] for i, n in enumerate(head)}
    n = int(FITTED * len(rows))
    y = np.column_stack([column[o] for o in field.outputs])
    u = np.column_stack([column[i] for i in {**field.inputs, **field.channels}])
    y, u = scaled(y, y[:n]), scaled(u, u[:n])
    grid = [(d, t, r) for d in (1, 2, 3) for t in (0.003, 0.01, 0.03, 0.1) for r in (False, True)]
    row = {
        "sindy": best(lambda fit, run, *s: sindy(y, u, field.step, fit, run, *s), grid, y),
        "sysidentpy": best(lambda fit, run, *s: narmax(y, u, fit, run, *s), [(1, 2), (2, 2), (3, 2), (1, 4), (2, 4)], y),
    }
    if told.exists():
        proof = json.loads(told.read_text())["proof"]
        spread = {o: np.std(column[o][n:]) for o in field.outputs}
        for key in ("before", "after"):
            row[key] = float(np.mean([p[f"holdout_{key}"] / spread[p["output"]] for p in proof]))
    return row


def main() -> None:
    warnings.filterwarnings("ignore")
    args = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    args.add_argument("--folder", type=pathlib.Path, required=True)
    args.add_argument("--only", default="")
    args = args.parse_args()
    keys = ["before", "after", "sindy", "sysidentpy"]
    print(f"{'field':<10} {'case':<14} {'given':>9} {'gyrospec':>9} {'PySINDy':>9} {'SysIdentPy':>10}")
    rows = []
    for field in ALL:
        for name in field.cases:
            row = case(args.folder, field, name) if args.only in f"{field.name}-{name}" else None
            if row:
                rows.append(row)
                shown = [f"{row.get(k, float('nan')):9.4f}" for k in keys]
                print(f"{field.name:<10} {name:<14} " + " ".join(shown), flush=True)
    middle = [float(np.nanmedian([r.get(k, np.nan) for r in rows])) for k in keys]
    print(f"{'median of':<10} {len(rows):<14} " + " ".join(f"{m:9.4f}" for m in middle))


if __name__ == "__main__":
    main()

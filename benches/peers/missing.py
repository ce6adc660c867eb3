"""One effect, or none, concealed in recordings of `gyrospec laboratory`; what PySINDy and gyrospec say of each.

PySINDy gets the rates of the same axis from the measured position (Savitzky-Golay, windows of 0.11 to 0.81 s) and a
library of twelve terms in which the effects of TERM stand; the window and the threshold are those that predict the
acceleration of the last third of the fitted part best. Its answer is the terms beside force, position and speed.
"""

import json
import pathlib
import subprocess
import tempfile
import warnings
from concurrent.futures import ThreadPoolExecutor

import numpy as np

TERM = {
    "dry-friction": "sign(v)", "quadratic-damping": "v|v|", "cubic-damping": "v^3", "cubic-stiffness": "q^3",
    "quadratic-stiffness": "q^2", "constant-force": "1", "input-offset": "1",
}
NAMES = ["1", "q", "v", "u", "q^2", "qv", "v^2", "q^3", "v^3", "v|v|", "sign(v)", "uv"]
BASE = {"q", "v", "u"}


def features(q: np.ndarray, v: np.ndarray, u: np.ndarray) -> np.ndarray:
    return np.column_stack([np.ones_like(q), q, v, u, q * q, q * v, v * v, q**3, v**3, v * abs(v), np.sign(v), u * v])


def sindy(log: pathlib.Path) -> set[str]:
    import pysindy
    from scipy.signal import savgol_filter

    head = log.read_text().split("\n", 1)[0].split(",")
    at = {name.split(" [")[0]: k for k, name in enumerate(head)}
    rows = np.loadtxt(log, delimiter=",", skiprows=1)
    rows = rows[: int(0.6 * len(rows))]
    step = rows[1, 0] - rows[0, 0]
    u = rows[:, at["force"]] / np.std(rows[:, at["force"]])
    best = (np.inf, set())
    for window in (11, 21, 41, 81):
        q, v, a = (savgol_filter(rows[:, at["position"]], window, 4, deriv=d, delta=step) for d in (0, 1, 2))
        x = features(q / np.std(q), v / np.std(v), u)
        y = a / np.std(a)
        size = x.std(0) + (x.std(0) == 0)
        part = int(len(y) * 2 / 3)
        for threshold in (0.01, 0.02, 0.05, 0.1, 0.2):
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                optimizer = pysindy.STLSQ(threshold=threshold, alpha=1e-6)
                optimizer.fit(x[:part] / size, y[:part, None])
            c = optimizer.coef_[0]
            error = np.mean((y[part:] - x[part:] / size @ c) ** 2) / np.mean(y[part:] ** 2)
            if error < best[0]:
                best = (error, {n for n, value in zip(NAMES, c, strict=True) if value})
    return best[1]


def judged(found: set[str], truth: set[str]) -> str:
    if found == truth:
        return "right"
    if not found:
        return "not seen"
    if not truth:
        return "invented"
    return "right and more" if truth <= found else "wrong"


def codes_of(case: dict) -> list[str]:
    return [hidden["code"] for hidden in case["hidden"]]


def gyrospec(program: str, folder: pathlib.Path, number: int, codes: list[str]) -> str:
    """Right: every finding is of the truth, or a tie holds it; `unknown` claims nothing by name."""
    call = [program, "diagnose", str(folder / f"model-{number}.toml"), str(folder / f"case-{number}.csv"), "--json", "-"]
    answer = json.loads(subprocess.run(call, capture_output=True, text=True, check=False).stdout)
    findings = [f for f in answer["findings"] if not f.get("resembles")]
    if answer["verdict"] == "unknown":
        return "unknown" if codes else "invented"
    if answer["verdict"] not in ("named", "tie"):
        return "not seen" if codes else "right"
    found = {next((c for c in codes if c in (f["code"], *f["ties"])), f["code"]) for f in findings}
    return judged(found, set(codes))


def made(program: str, folder: pathlib.Path, kind: str, cases: int, seed: int) -> list[dict]:
    """The laboratory's recordings with their truth; it is stopped when they are made."""
    call = [program, "laboratory", "--plant", "axis", "--cases", str(cases), "--seed", str(seed), "--only", kind, "--keep", str(folder)]
    with subprocess.Popen(call, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as run:
        first = run.stdout.readline()
        run.terminate()
    if "made" not in first:
        raise SystemExit(f"{' '.join(call)} made nothing: {first}")
    return json.loads((folder / "truth.json").read_text())


def main(args) -> None:
    counts: dict = {}
    with tempfile.TemporaryDirectory() as place, ThreadPoolExecutor(2) as pool:
        for kind in ("none", "one"):
            folder = pathlib.Path(place) / kind
            truth = made(args.program, folder, kind, args.cases, args.seed)
            mine = pool.map(lambda c: gyrospec(args.program, folder, c["number"], codes_of(c)), truth)  # noqa: B023
            for case, said in zip(truth, mine, strict=True):
                codes = codes_of(case)
                known = all(c in TERM for c in codes)
                group = "none" if not codes else "one, in the library" if known else "one, not in the library"
                found = sindy(folder / f"case-{case['number']}.csv") - BASE
                theirs = judged(found, {TERM.get(c, "a law outside") for c in codes})
                for who, what in (("gyrospec", said), ("PySINDy", theirs)):
                    tally = counts.setdefault(group, {}).setdefault(who, {})
                    tally[what] = tally.get(what, 0) + 1
    print(f"Recordings of `gyrospec laboratory --plant axis --cases {args.cases} --seed {args.seed}`, none or one effect concealed, as large as, "
          "3 and 10 times the noise:\n")
    print("| concealed | | gyrospec | PySINDy |\n|---|---|---|---|")
    for group, tally in counts.items():
        told = {k: ", ".join(f"{n} {w}" for w, n in sorted(v.items(), key=lambda x: -x[1])) for k, v in tally.items()}
        print(f"| {group} | {sum(tally['gyrospec'].values())} | {told['gyrospec']} | {told['PySINDy']} |")
    print()

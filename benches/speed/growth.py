"""How the cost of a diagnosis grows with samples and with states, on a chain of masses in which nothing is missing.

    python benches/speed/growth.py [--program gyrospec] [--samples 10000,30000,...] [--states 2,4,...] [--picture cost.svg]

Rows of states have 10 000 samples, rows of samples two states. The picture needs matplotlib. Each row: samples, states,
processor seconds, seconds by the clock, MiB, what was said.
"""

import argparse
import pathlib
import tempfile

import numpy as np
from speed import timed

STEP, MASS, STIFFNESS, DAMPING = 0.01, 1.0, 40.0, 0.6


def model(masses: int) -> str:
    """The chain, held at one end and pushed at the other; the position of the mass that is pushed is measured."""
    rates = []
    for i in range(masses):
        held = f"k*(x{i} - x{i + 1}) + c*(v{i} - v{i + 1})" if i + 1 < masses else f"k*x{i} + c*v{i}"
        drawn = f"- k*(x{i - 1} - x{i}) - c*(v{i - 1} - v{i})" if i else "- force"
        rates += [f'x{i} = {{ rate = "v{i}", unit = "m", initial = 0.0 }}',
                  f'v{i} = {{ rate = "-({held} {drawn})/m", unit = "m/s", initial = 0.0 }}']
    return "\n".join(
        ['name = "chain"', "[inputs]", 'force = { unit = "N" }', "[parameters]",
         f'm = {{ value = {MASS}, unit = "kg" }}',
         f'k = {{ value = {0.9 * STIFFNESS}, unit = "N/m", fit = true, min = 1.0 }}',
         f'c = {{ value = {1.1 * DAMPING}, unit = "N*s/m", fit = true, min = 0.01 }}',
         "[states]", *rates, "[outputs]", 'place = { equals = "x0", unit = "m" }', ""])


def exponential(a: np.ndarray) -> np.ndarray:
    """exp(A) by Taylor's series of A/2^s, squared s times."""
    s = max(0, int(np.ceil(np.log2(max(np.abs(a).sum(1).max(), 1e-9)))) + 4)
    term = total = np.eye(len(a))
    for j in range(1, 14):
        term = term @ a / 2.0**s / j
        total = total + term
    for _ in range(s):
        total = total @ total
    return total


def recording(masses: int, samples: int, seed: int) -> np.ndarray:
    """Rows of time, force and place; the force runs straight between its samples."""
    n = 2 * masses
    a = np.zeros((n + 2, n + 2))
    for i in range(masses):
        a[2 * i, 2 * i + 1] = 1.0
        for j in (i - 1, i + 1):
            if j >= 0:
                a[2 * i + 1, 2 * i] -= STIFFNESS / MASS
                a[2 * i + 1, 2 * i + 1] -= DAMPING / MASS
                if j < masses:
                    a[2 * i + 1, 2 * j] += STIFFNESS / MASS
                    a[2 * i + 1, 2 * j + 1] += DAMPING / MASS
    a[1, n], a[n, n + 1] = 1.0 / MASS, 1.0
    step = exponential(a * STEP)
    rng = np.random.default_rng([seed, masses, samples])
    time = STEP * np.arange(samples)
    waves = rng.uniform(0.2, 8.0, 12), rng.uniform(0.0, 6.3, 12)
    force = sum(np.sin(w * time + p) for w, p in zip(*waves))
    x, place = np.zeros(n + 2), np.empty(samples)
    slopes = np.append(np.diff(force), 0.0) / STEP
    for i in range(samples):
        place[i] = x[0]
        x[n], x[n + 1] = force[i], slopes[i]
        x = step @ x
    noise = 0.01 * place.std() * rng.standard_normal(samples)
    return np.column_stack([time, force, place + noise])


def row(program: str, folder: pathlib.Path, samples: int, states: int) -> tuple:
    (folder / "model.toml").write_text(model(states // 2), "utf-8")
    rows = recording(states // 2, samples, 1)
    np.savetxt(folder / "data.csv", rows, "%.9g", ",", header="time [s],force [N],place [m]", comments="")
    told = timed(program, [str(folder / "model.toml"), str(folder / "data.csv")], 3600.0)
    print(f"{samples:>8} {states:>3} {told['cpu']:>8.1f} {told['wall']:>8.1f} {told['MiB']:>6.0f}  {told['said']}", flush=True)
    return samples, states, told["cpu"], told["MiB"]


def draw(path: str, by_samples: list, by_states: list) -> None:
    import matplotlib

    matplotlib.use("svg")
    from matplotlib import pyplot

    figure, sides = pyplot.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    for side, rows, k, name in ((sides[0], by_samples, 0, "samples"), (sides[1], by_states, 1, "states")):
        x, cost = np.array([r[k] for r in rows], float), np.array([r[2] for r in rows])
        side.loglog(x, cost, "o-", color="#1f5fa8", label="diagnosis")
        side.loglog(x, cost[0] * x / x[0], "--", color="#d9822b", label="in proportion")
        side.set(xlabel=name, ylabel="processor seconds")
        if k:
            side.set_xticks(x, [f"{n:.0f}" for n in x])
            side.minorticks_off()
        side.grid(alpha=0.3)
        side.legend()
    figure.savefig(path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default="gyrospec")
    parser.add_argument("--samples", default="10000,30000,100000,300000,1000000")
    parser.add_argument("--states", default="2,4,8,12,20")
    parser.add_argument("--picture")
    args = parser.parse_args()
    numbers = lambda text: [int(n) for n in text.split(",") if n]  # noqa: E731
    print(" samples  states   cpu s     wall    MiB  said")
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        by_samples = [row(args.program, place, n, 2) for n in numbers(args.samples)]
        by_states = [row(args.program, place, 10_000, n) for n in numbers(args.states)]
    if args.picture:
        draw(args.picture, by_samples, by_states)


if __name__ == "__main__":
    main()

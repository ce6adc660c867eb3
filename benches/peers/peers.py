"""Other software beside gyrospec on the same work, in one run; prints what COMPARE.md holds.

    pip install . scipy control slycot sympy pysindy pydiffsol
    python benches/peers/peers.py [--only integrals,letters,runs,missing] [--program gyrospec] [--cases 20]

Integrals: time of a call, error against exact rationals, and what is answered where there is no value. Letters: the
integral with symbols. Runs: a driven nonlinear oscillator by several solvers. Missing: recordings of `gyrospec laboratory` in
which one effect or none is concealed. What is not installed is left out, and said so. One thread: set OMP_NUM_THREADS=1.
"""

import argparse
import importlib.metadata
import pathlib
import platform
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))

PARTS = ["integrals", "letters", "runs", "missing"]
PACKAGES = ["gyrospec", "numpy", "scipy", "control", "slycot", "sympy", "pysindy", "pydiffsol"]


def versions() -> str:
    told = []
    for name in PACKAGES:
        try:
            told.append(f"{name} {importlib.metadata.version(name)}")
        except importlib.metadata.PackageNotFoundError:
            told.append(f"{name} NOT INSTALLED")
    return ", ".join(told)


def machine() -> str:
    try:
        lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines()
        return next(line.split(":")[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


def main() -> None:
    args = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    args.add_argument("--only", default=",".join(PARTS))
    args.add_argument("--program", default="gyrospec")
    args.add_argument("--cases", type=int, default=20)
    args.add_argument("--seed", type=int, default=5)
    args = args.parse_args()
    print(f"{time.strftime('%Y-%m-%d')}, {machine()}, Python {platform.python_version()}: {versions()}\n")
    for part in args.only.split(","):
        importlib.import_module(part).main(args)


if __name__ == "__main__":
    main()

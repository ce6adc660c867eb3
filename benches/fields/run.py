"""Diagnoses the recordings of every field and prints a table: what was concealed, what was named, how the error fell.

    python benches/fields/run.py [--program gyrospec] [--folder DIR] [--only TEXT] [--seed N] [--jobs 2]

A case counts as right where the first finding is of an accepted code, or a tie of at most three holds one (wide where the
tie is of more); where nothing is concealed, where nothing is found; where only a law without a name is accepted, where one stands or the
program says that something is missing without a name.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

sys.path.insert(0, str(pathlib.Path(__file__).parent))

from fields import LAW, write  # noqa: E402
from plants import ALL  # noqa: E402


def judged(answer: dict, accepted: frozenset) -> tuple[str, str]:
    verdict, findings = answer["verdict"], answer["findings"]
    own = [f for f in findings if not f.get("resembles")]
    first = own[0]["code"] if own else ""
    named = {first, *own[0]["ties"]} if own and verdict in ("named", "tie") else set()
    told = "+".join(f["code"] + ("|" + "|".join(f["ties"]) if f["ties"] else "") for f in own) or "-"
    if not accepted:
        return ("right" if verdict == "nothing-missing" else "honest" if verdict == "not-identifiable" else "WRONG"), told
    if named & accepted and len(named) <= 3:
        return ("right" if all(f["code"] in accepted for f in own) else "spurious"), told
    if named & accepted:
        return "wide", told
    if verdict == "unknown":
        return ("right" if "free-law" in accepted or first in accepted else "unnamed"), told
    if verdict in ("nothing-missing", "not-identifiable", "data-fault"):
        return "missed", told
    return "WRONG", told


def fall(answer: dict) -> float:
    ratios = [p["holdout_after"] / p["holdout_before"] for p in answer["proof"] if p["holdout_before"]]
    return min(ratios, default=float("nan"))


def case(program: str, folder: pathlib.Path, field, name: str, seed: int) -> dict:
    model, log = write(field, name, folder, seed)
    begin = time.perf_counter()
    ran = subprocess.run(
        [program, "diagnose", str(model), str(log), "--json", "-"], capture_output=True, text=True, check=False
    )
    took = time.perf_counter() - begin
    try:
        answer = json.loads(ran.stdout)
    except json.JSONDecodeError:
        return {"field": field.name, "case": name, "said": "FAILED", "told": ran.stderr[-200:], "fall": 0, "s": took, "verdict": ""}
    log.with_suffix(".json").write_text(ran.stdout)
    said, told = judged(answer, field.cases[name][1])
    return {"field": field.name, "case": name, "said": said, "told": told, "fall": fall(answer), "s": took,
            "verdict": answer["verdict"], "site": [f["site"]["name"] for f in answer["findings"]][:3]}


def main() -> None:
    args = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    args.add_argument("--program", default="gyrospec")
    args.add_argument("--folder", type=pathlib.Path)
    args.add_argument("--only", default="")
    args.add_argument("--seed", type=int, default=1)
    args.add_argument("--jobs", type=int, default=2)
    args = args.parse_args()
    folder = args.folder or pathlib.Path(tempfile.mkdtemp())
    folder.mkdir(parents=True, exist_ok=True)
    asked = [(f, c) for f in ALL for c in f.cases if args.only in f"{f.name}-{c}"]
    rows = []
    with ThreadPoolExecutor(args.jobs) as pool:
        for row in pool.map(lambda a: case(args.program, folder, *a, args.seed), asked):
            rows.append(row)
            print(f"{row['field']:<10} {row['case']:<14} {row['said']:<9} {row['verdict']:<16} {row['told']:<44.44} "
                  f"{row['fall']:6.3f} {row['s']:6.1f} s  {','.join(row.get('site', []))}", flush=True)
    count = {s: sum(r["said"] == s for r in rows) for s in sorted({r["said"] for r in rows})}
    print(f"{len(rows)} recordings: " + ", ".join(f"{n} {s}" for s, n in count.items()))


if __name__ == "__main__":
    main()

"""Times `gyrospec diagnose`, by itself or beside another build, on recordings made here and on the public ones.

    python benches/speed/speed.py [--program gyrospec] [--beside OTHER] [--only TEXT] [--recordings DIR] [--folder DIR]
                                  [--longest SECONDS]

Each row is one recording, given to both programs one after the other: processor seconds, seconds by the clock, peak memory
and what was said. The public recordings are those of benches/evidence, skipped where they are absent. The recordings come
from one seed; `--folder` keeps them.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "evidence"), str(HERE.parent / "fields")]

from evidence import CLONE, SETS, placed  # noqa: E402
from fields import write  # noqa: E402
from rows import ALL  # noqa: E402

PUBLIC = ["silverbox", "emps", "roll-decay"]


def told(text: str) -> str:
    try:
        answer = json.loads(text)
    except json.JSONDecodeError:
        return "no answer"
    own = ["|".join([f["code"], *f["ties"]]) for f in answer["findings"] if not f.get("resembles")]
    return answer["verdict"] + (": " + ", ".join(own) if own and answer["verdict"] in ("named", "tie") else "")


def timed(program: str, words: list[str], longest: float) -> dict:
    """Processor and clock seconds of one diagnosis, its peak memory in MiB and its answer."""
    begin = time.perf_counter()
    with tempfile.TemporaryFile("w+") as out:
        ran = subprocess.Popen([program, "diagnose", *words, "--json", "-"], stdout=out, stderr=subprocess.DEVNULL)
        stop = threading.Timer(longest, ran.kill)
        stop.start()
        _, status, used = os.wait4(ran.pid, 0)
        ended = stop.is_alive()
        stop.cancel()
        ran.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        said = told(out.read()) if ended else f"no answer in {longest:.0f} s"
    return {"cpu": used.ru_utime + used.ru_stime, "wall": time.perf_counter() - begin, "MiB": used.ru_maxrss / 1024,
            "said": said}


def calls(args, folder: pathlib.Path):
    """Name of each row and the words of its call."""
    for field in ALL:
        for case in field.cases:
            if args.only in (name := f"{field.name}, {case}"):
                yield name, [str(file) for file in write(field, case, folder, args.seed)]
    there = pathlib.Path(args.recordings or os.environ.get("GYROSPEC_RECORDINGS") or CLONE / "recordings").resolve()
    for name in PUBLIC:
        if args.only not in name:
            continue
        if all((there / file).exists() for file in SETS[name]):
            yield name, placed(name, there, folder / name)
        else:
            print(f"{name}: SKIPPED, no recording in {there}", file=sys.stderr)


def main() -> None:
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("--program", default="gyrospec")
    ask.add_argument("--beside")
    ask.add_argument("--only", default="")
    ask.add_argument("--recordings")
    ask.add_argument("--folder")
    ask.add_argument("--longest", type=float, default=900)
    ask.add_argument("--seed", type=int, default=1978)
    args = ask.parse_args()
    programs = [p for p in (args.beside, args.program) if p]
    heads = " | ".join("CPU s | clock s | MiB | says" for _ in programs)
    print(f"| recording | {heads} |" + (" ratio of CPU |" if args.beside else ""))
    print("|---" * (1 + 4 * len(programs) + bool(args.beside)) + "|", flush=True)
    with tempfile.TemporaryDirectory() as kept:
        folder = pathlib.Path(args.folder or kept)
        folder.mkdir(parents=True, exist_ok=True)
        for name, words in calls(args, folder):
            ran = [timed(p, words, args.longest) for p in programs]
            cells = [f"{r['cpu']:.1f} | {r['wall']:.1f} | {r['MiB']:.0f} | {r['said']}" for r in ran]
            ratio = [f"{ran[0]['cpu'] / ran[1]['cpu']:.1f}"] if args.beside else []
            print("| " + " | ".join([name, *cells, *ratio]) + " |", flush=True)


if __name__ == "__main__":
    main()

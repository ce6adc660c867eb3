"""Diagnoses public recordings with naive models and prints the table of docs/evidence.md.

    python benches/evidence/evidence.py [--program gyrospec] [--recordings DIR] [--only TEXT] [--keep DIR]
                                        [--pictures DIR]

The recordings are other people's and not part of the project: docs/evidence.md says where each is to be had, and
under which names of files and columns. They are looked for in --recordings, else where GYROSPEC_RECORDINGS points,
else in `recordings/` of the clone. A set that is not there is skipped, and said so. `--keep DIR` keeps each page and
answer. `--pictures DIR` writes the pictures of the page: the errors as bars and, of recordings whose licence allows
it, the residuals.
Sets that the folder of `--keep` already holds are not run again.
"""

import argparse
import json
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
CLONE = HERE.parents[1]
# in the order of the table: folder, what is read of the recordings
SETS = {
    "emps": ["emps/emps_estimation.csv.gz", "emps/emps_validation_pulses.csv.gz"],
    "silverbox": ["silverbox/SNLS80mV.csv.gz"],
    "tanks": ["cascaded_tanks/cascaded_tanks.csv"],
    "dryer": ["daisy/dryer.csv"],
    "lamp": ["daisy/heating_system.csv"],
    "roll-decay": ["kvlcc2_roll_decay/model_test_21338.csv.gz", "kvlcc2_roll_decay/model_test_21337.csv.gz"],
    "gyro-1": ["ship_gyrocompass_skq201822s/gyro_1_heading.csv",
               "ship_gyrocompass_skq201822s/ins_seapath_position_attitude.csv"],
    "gyro-2": ["ship_gyrocompass_skq201822s/gyro_2_heading.csv",
               "ship_gyrocompass_skq201822s/ins_seapath_position_attitude.csv"],
}

# best published error of the hold-out set, in the unit of the table; the sources stand in docs/evidence.md
PUBLISHED = {"emps": 2.64, "silverbox": 0.26, "tanks": 0.18}
# of recordings under a licence that lets their course be shown
SHOWN = ["roll-decay", "gyro-1"]


def placed(name: str, recordings: pathlib.Path, folder: pathlib.Path) -> list[str]:
    """Copies the files of a set with the place of the recordings in them; the words of the call after `diagnose`."""
    folder.mkdir(parents=True, exist_ok=True)
    for file in sorted((HERE / name).glob("*.toml")):
        text = file.read_text(encoding="utf-8").replace("../../../recordings", recordings.as_posix())
        (folder / file.name).write_text(text, encoding="utf-8")
    words = [str(folder / "model.toml"), str(folder / "fit.toml")]
    if (folder / "holdout.toml").exists():
        words += ["--holdout", str(folder / "holdout.toml")]
    return words


def diagnosed(program: str, words: list[str], folder: pathlib.Path) -> dict:
    """What the program says, with the seconds it took."""
    call = [program, "diagnose", *words, "--json", "-", "--html", str(folder / "report.html"),
            "--model-out", str(folder / "found.toml")]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    ran = subprocess.run(call, capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if ran.returncode not in (0, 1):
        sys.exit(f"{' '.join(call)}\nended with {ran.returncode}:\n{ran.stderr}")
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    (folder / "answer.json").write_text(ran.stdout, encoding="utf-8")
    (folder / "seconds.txt").write_text(f"{cpu:.1f}")
    return {**json.loads(ran.stdout), "cpu": cpu}


def kept(folder: pathlib.Path) -> dict | None:
    told, seconds = folder / "answer.json", folder / "seconds.txt"
    if not (told.exists() and seconds.exists()):
        return None
    return {**json.loads(told.read_text(encoding="utf-8")), "cpu": float(seconds.read_text())}


def listed(answer: dict) -> str:
    named = [f for f in answer["findings"] if not f.get("resembles")]
    codes = ", ".join("`" + "` or `".join([f["code"], *f["ties"]]) + "`" for f in named) or "–"
    only_like = answer["verdict"] not in ("named", "tie") and named and named[0]["code"] != "free-law"
    return f"resembles {codes}" if only_like else codes


def row(name: str, answer: dict) -> str:
    (proof,) = answer["proof"]
    figures = [f"{proof[f'{part}_{when}']:.3g}" for part in ("fit", "holdout") for when in ("before", "after")]
    best = f"{PUBLISHED[name]:g}" if name in PUBLISHED else "none cited"
    cells = [name, answer["verdict"], listed(answer), proof["unit"], *figures, best, f"{answer['cpu']:.0f}"]
    return "| " + " | ".join(cells) + " |"


STYLE = """<style>text{font:13px system-ui,sans-serif;fill:#5b636d}text.words{fill:#1b1f24}
.grid{stroke:#d5d9de;stroke-width:.7}.frame,.tick{stroke:#5b636d;fill:none}
polyline{fill:none;stroke-width:1.4;stroke-linejoin:round;vector-effect:non-scaling-stroke}
polyline.before{stroke:#c44e00}polyline.after{stroke:#0067a8}rect.shade{fill:none}
rect.held{fill:#8a9099;fill-opacity:.15}</style>"""


def thinned(match: re.Match) -> str:
    """Points to whole pixels of the picture, runs of equal ones once."""
    points = [tuple(f"{float(x):.1f}" for x in p.split(",")) for p in match[1].split()]
    points = [p for k, p in enumerate(points) if k == 0 or p != points[k - 1]]
    return 'points="' + " ".join(",".join(p) for p in points) + '"'


def residual(page: str, title: str) -> str:
    """The last picture of what is left over time: of the hold-out set where that is a recording of its own."""
    figures = re.findall(r"<figcaption>[^<]*: measured less model</figcaption>(<svg.*?</svg>)<p", page, re.S)
    inner = re.sub(r"^<svg[^>]*>", "", re.sub(r'points="([^"]*)"', thinned, figures[-1]))
    legend = (f'<text class="words" x="392" y="18" text-anchor="middle">{title}: <tspan fill="#c44e00">model as given'
              '</tspan>, <tspan fill="#0067a8">with what was found</tspan></text>')
    return ('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 720 320"><rect width="720" height="320" fill="#fff"/>'
            + STYLE + legend + inner + "\n")


def bars(answers: dict) -> str:
    """Held-out errors in parts of that of the model as given."""
    left, width, step = 110, 560, 44
    height = step * len(answers) + 60
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 720 {height}"><rect width="720" height="{height}" '
             f'fill="#fff"/>{STYLE}<text class="words" x="{left}" y="18">error on the hold-out set, in parts of that of '
             'the model as given</text>']
    for k, (name, answer) in enumerate(answers.items()):
        (proof,) = answer["proof"]
        y, share = 32 + k * step, proof["holdout_after"] / proof["holdout_before"]
        parts.append(f'<text class="words" x="{left - 8}" y="{y + 17}" text-anchor="end">{name}</text>'
                     f'<rect x="{left}" y="{y}" width="{width}" height="11" fill="#c44e00" fill-opacity=".35"/>'
                     f'<rect x="{left}" y="{y + 13}" width="{max(1.0, width * share):.1f}" height="11" fill="#0067a8"/>'
                     f'<text x="{left + width * share + 6:.1f}" y="{y + 23}">{share:.3f}</text>')
        if name in PUBLISHED:
            x = left + width * PUBLISHED[name] / proof["holdout_before"]
            parts.append(f'<path d="M{x:.1f} {y - 2}v28" stroke="#1b1f24" stroke-width="2"/>')
    parts.append(f'<text x="{left}" y="{height - 12}">light: as given; blue: with what was found; mark: best published, '
                 "where one is cited</text></svg>\n")
    return "".join(parts)


def draw(folder: pathlib.Path, keep: pathlib.Path, answers: dict) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "evidence.svg").write_text(bars(answers), encoding="utf-8")
    for name in (n for n in SHOWN if n in answers):
        page = (keep / name / "report.html").read_text(encoding="utf-8")
        title = {"roll-decay": "roll decay, hold-out record", "gyro-1": "gyrocompass 1, held out where grey"}[name]
        (folder / f"evidence-{name}.svg").write_text(residual(page, title), encoding="utf-8")


def main() -> None:
    args = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    args.add_argument("--program", default="gyrospec")
    args.add_argument("--recordings", type=pathlib.Path,
                      default=pathlib.Path(os.environ.get("GYROSPEC_RECORDINGS", CLONE / "recordings")))
    args.add_argument("--only", default="")
    args.add_argument("--keep", type=pathlib.Path)
    args.add_argument("--pictures", type=pathlib.Path)
    args = args.parse_args()
    keep = args.keep or pathlib.Path(tempfile.mkdtemp())
    print("| set | verdict | found | unit | fitted before | after | held out before | after | best published | CPU, s |")
    print("|---|---|---|---|---|---|---|---|---|---|", flush=True)
    said, answers = [], {}
    for name, files in SETS.items():
        if args.only not in name:
            continue
        absent = [f for f in files if not (args.recordings / f).exists()]
        if absent:
            said.append(f"{name}: SKIPPED, {', '.join(absent)} not in {args.recordings}")
            continue
        answer = kept(keep / name)
        if answer is None:
            words = placed(name, args.recordings.resolve(), keep / name)
            answer = diagnosed(args.program, words, keep / name)
        print(row(name, answer), flush=True)
        answers[name] = answer
        said.append(f"{name}: {answer['says']}")
    print("\n" + "\n\n".join(said))
    if args.pictures and answers:
        draw(args.pictures, keep, answers)


if __name__ == "__main__":
    main()

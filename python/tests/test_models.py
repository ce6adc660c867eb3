"""Models and recordings: files, texts, frames; simulation, fit and diagnosis on them."""

from __future__ import annotations

import json
import pickle
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import gyrospec
import numpy as np
import pandas as pd
import polars as pl
import pytest
from conftest import MODEL, UNITS, write
from scipy.integrate import solve_ivp

Columns = dict[str, np.ndarray]


def test_a_model_is_a_path_a_text_or_an_object(model_file: Path, viscous: Columns) -> None:
    model = gyrospec.Model.read(model_file)
    assert model == gyrospec.Model.parse(MODEL) == gyrospec.Model.parse(model.to_toml())
    assert model == pickle.loads(pickle.dumps(model))
    assert model.parameters == {"M": 2.0, "k": 45.0, "Fv": 1.5}
    assert model.outputs == ["position"] and model.units["position"] == "mm"
    recording = gyrospec.recording(viscous, units=UNITS)
    runs = [gyrospec.simulate(m, recording) for m in (model_file, str(model_file), MODEL, model)]
    for run in runs[1:]:
        assert np.array_equal(run["position"].predicted, runs[0]["position"].predicted)


def test_frames_of_all_kinds_give_the_recording_of_the_file(tmp_path: Path, viscous: Columns) -> None:
    file = gyrospec.Recording.read(write(tmp_path / "voyage.csv", viscous))
    headed = pd.DataFrame({f"{n} [{u}]": viscous[n] for n, u in UNITS.items()})
    frames = [
        gyrospec.recording(viscous, units=UNITS),
        gyrospec.recording(pd.DataFrame(viscous), units=UNITS),
        gyrospec.recording(pl.DataFrame(viscous), units=UNITS),
        gyrospec.recording(headed),
        gyrospec.recording(
            {n: viscous[n] for n in ("force", "position")},
            units={"force": "N", "position": "mm"},
            time=viscous["t"],
        ),
    ]
    for frame in frames:
        for name in ("force", "position"):
            for a, b in zip(frame.channel(name), file.channel(name), strict=True):
                assert np.array_equal(a, b)


def test_gaps_dates_and_whole_numbers_are_read() -> None:
    frame = pd.DataFrame(
        {
            "at": pd.to_datetime([f"2020-01-01 00:00:{s}" for s in ("00.0", "01.5", "03.0")]),
            "roll": pd.array([1, None, 3], dtype="Int64"),
        }
    )
    made = gyrospec.recording(frame, units={"roll": "deg"})
    assert made.channel("roll")[0].tolist() == [0.0, 1.5, 3.0]
    assert np.array_equal(made.channel("roll")[1], [1.0, np.nan, 3.0], equal_nan=True)
    polars = gyrospec.recording(
        pl.DataFrame({"t": [0, 1, 2], "roll": [1, None, 3]}), units={"t": "min", "roll": "deg"}
    )
    assert polars.channel("roll")[0].tolist() == [0.0, 60.0, 120.0]
    assert np.array_equal(polars.channel("roll")[1], [1.0, np.nan, 3.0], equal_nan=True)
    wrapped = gyrospec.recording(
        {"t": [0.0, 1.0], "k": [359.0, 1.0]}, units={"t": "s", "k": "deg"}, wraps=["k"]
    )
    assert wrapped.channel("k")[1] == pytest.approx([359.0, 361.0])


def test_the_time_may_have_a_zone_and_may_be_the_index() -> None:
    dates = pd.to_datetime([f"2020-01-01 00:00:{s}" for s in ("00.0", "01.5", "03.0")])
    roll = {"roll": [1.0, 2.0, 3.0]}
    frames = [
        pd.DataFrame({"at": dates.tz_localize("Europe/Oslo"), **roll}),
        pd.DataFrame(roll, index=dates),
        pd.DataFrame(roll, index=dates.tz_localize("UTC")),
        pd.DataFrame(roll, index=pd.Index([0.0, 1.5, 3.0], name="t [s]")),
        pl.DataFrame({"at": pl.Series(dates).dt.replace_time_zone("Asia/Tokyo"), **roll}),
    ]
    for frame in frames:
        time, values = gyrospec.recording(frame, units={"roll": "deg"}).channel("roll")
        assert time.tolist() == [0.0, 1.5, 3.0] and values == pytest.approx([1.0, 2.0, 3.0])
    named = pd.DataFrame(roll, index=pd.Index([0, 1, 2], name="t"))
    asked = gyrospec.recording(named, units={"roll": "deg", "t": "min"}, time="t")
    assert asked.channel("roll")[0].tolist() == [0.0, 60.0, 120.0]
    with pytest.raises(gyrospec.UnitsError, match="`roll` is taken for the time, but it is in deg"):
        gyrospec.recording({"roll": [1.0, 2.0], "pitch": [0.0, 1.0]}, units={"roll": "deg", "pitch": "deg"})
    twins = pd.DataFrame([[0.0, 1.0, 2.0]], columns=["t", "roll", "roll"])
    with pytest.raises(gyrospec.InputError, match="two columns have the name `roll`"):
        gyrospec.recording(twins, units={"t": "s", "roll": "deg"})
    with pytest.raises(gyrospec.InputError, match=r"`roll` holds 'calm' in row 1 \(from 0\)"):
        gyrospec.recording({"t": [0, 1], "roll": [1.0, "calm"]}, units={"t": "s", "roll": "deg"})


def test_results_go_through_a_pickle(viscous: Columns) -> None:
    answer = gyrospec.integral([1, 2, 3], [0, 1])
    again = pickle.loads(pickle.dumps(answer))
    assert again == answer and repr(again) == repr(answer)
    ran = gyrospec.simulate(MODEL, viscous, units=UNITS)
    kept = pickle.loads(pickle.dumps(ran))
    assert str(kept) == str(ran) and kept.to_json() == ran.to_json()
    assert kept._repr_html_() == ran._repr_html_()
    with pytest.raises(gyrospec.UsageError, match="no trace"):
        kept.trace()


@pytest.mark.parametrize(
    ("change", "error", "says"),
    [
        ({"units": {"t": "s"}}, gyrospec.UnitsError, "no column has a unit"),
        ({"units": {"position": "mm"}}, gyrospec.UnitsError, "column of time, `t`, has no unit"),
        ({"units": {**UNITS, "positon": "mm"}}, gyrospec.InputError, "did you mean `position`"),
        ({"units": {**UNITS, "position": "mmm"}}, gyrospec.UnitsError, "mmm"),
        ({"units": UNITS, "time": "tt"}, gyrospec.InputError, "no column `tt`"),
        ({"units": UNITS, "wraps": ["force"]}, gyrospec.UnitsError, "no angle"),
        ({"units": UNITS, "hold": ["forse"]}, gyrospec.InputError, "did you mean `force`"),
        (
            {"units": UNITS, "fit": [(0, 10)], "holdout": [(5, 12)]},
            gyrospec.InputError,
            "both fitted and held out",
        ),
        ({"units": UNITS, "constants": {"lat": 46.5}}, gyrospec.InputError, "value and unit"),
        ({"units": UNITS, "kind": "trial"}, gyrospec.UsageError, "'time' or 'trials'"),
    ],
)
def test_what_is_wrong_with_a_frame_is_said(
    viscous: Columns, change: dict, error: type[Exception], says: str
) -> None:  # type: ignore[type-arg]
    with pytest.raises(error, match=says):
        gyrospec.recording(viscous, **change)


def test_bad_columns_are_refused(viscous: Columns) -> None:
    for column, error in (
        (["a"] * 400, gyrospec.InputError),
        (np.full(400, np.inf), gyrospec.InputError),
        (np.ones((400, 2)), gyrospec.InputError),
        (np.ones(3), gyrospec.InputError),
        (viscous["force"] + 1j, gyrospec.InputError),
    ):
        with pytest.raises(error):
            gyrospec.recording({**viscous, "force": column}, units=UNITS)
    twice = np.array(viscous["t"], dtype=float)
    twice[7] = twice[6]
    with pytest.raises(gyrospec.InputError, match=r"must be finite and rise: row 7 \(from 0\)"):
        gyrospec.recording({**viscous, "t": twice}, units=UNITS)
    # what lies behind a mask is a gap
    force = np.ma.array(viscous["force"], mask=np.arange(400) == 3)
    kept = gyrospec.recording({**viscous, "force": force}, units=UNITS).channel("force")[1]
    assert np.flatnonzero(np.isnan(kept)).tolist() == [3]
    with pytest.raises(gyrospec.InputError, match="rise"):
        gyrospec.recording({**viscous, "t": viscous["t"][::-1]}, units=UNITS)
    with pytest.raises(gyrospec.InputError, match="two columns"):
        gyrospec.recording({"t [s]": [0.0, 1.0], "a [m]": [1.0, 2.0], "a [cm]": [1.0, 2.0]})
    with pytest.raises(gyrospec.UsageError, match="seed"):
        gyrospec.fit(MODEL, viscous, units=UNITS, seed=-1)
    with pytest.raises(gyrospec.UsageError, match="says them itself"):
        gyrospec.fit(MODEL, gyrospec.recording(viscous, units=UNITS), units=UNITS)
    with pytest.raises(gyrospec.FileError, match="Model.builtin"):
        gyrospec.simulate("gyrosphere", viscous, units=UNITS)
    with pytest.raises(gyrospec.FileError, match="nowhere.csv"):
        gyrospec.recording("nowhere.csv")
    with pytest.raises(OSError):
        gyrospec.simulate("nowhere.toml", viscous, units=UNITS)
    with pytest.raises(gyrospec.InputError) as wrong:
        gyrospec.Model.parse(MODEL.replace("k*x", "kk*x"))
    assert wrong.value.line and wrong.value.column and "kk" in str(wrong.value)


def test_a_simulation_is_that_of_scipy(viscous: Columns) -> None:
    model = gyrospec.Model.parse(MODEL).replace(k=50.0, Fv=2.0)
    ran = gyrospec.simulate(model, viscous, units=UNITS)
    t, force = viscous["t"], viscous["force"]
    solved = solve_ivp(
        lambda s, y: [y[1], (np.interp(s, t, force) - 50 * y[0] - 2 * y[1]) / 2],
        (0, t[-1]), [0.0, 0.0], t_eval=t, rtol=1e-10, atol=1e-12, max_step=0.05,
    )  # fmt: skip
    out = ran["position"]
    assert out.unit == "mm"
    assert np.max(np.abs(out.predicted - 1e3 * solved.y[0])) < 1e-4 * np.ptp(out.predicted)
    assert out.rms_error == pytest.approx(np.sqrt(np.mean((out.measured - out.predicted) ** 2)))
    traced = ran.trace()
    assert np.max(np.abs(traced["v"] - solved.y[1])) < 1e-4 * np.ptp(solved.y[1])
    assert json.loads(ran.to_json()) == ran.to_dict()
    assert "position" in ran._repr_html_() and "rms" in str(ran)
    with pytest.raises(KeyError, match="position"):
        ran["positions"]


def test_a_fit_finds_the_numbers_that_made_the_recording(viscous: Columns) -> None:
    fitted = gyrospec.fit(MODEL, viscous, units=UNITS)
    for name, truth in (("M", 2.0), ("k", 50.0), ("Fv", 2.0)):
        p = fitted[name]
        assert p.status == "fitted"
        assert p.value == pytest.approx(truth, rel=0.01)
        assert p.low < p.value < p.high
    assert fitted.outputs[0].rmse_holdout == pytest.approx(0.2, rel=0.2)
    assert fitted.model_out.parameters["k"] == pytest.approx(fitted["k"].value)
    assert fitted.to_dict()["schema"] == "gyrospec.fit/1"
    assert "position" in fitted._repr_html_()
    assert fitted.html().startswith("<!doctype html>") and "<svg" in fitted.html()


def test_a_diagnosis_names_what_was_left_out(model_file: Path, dry: Columns, tmp_path: Path) -> None:
    found = gyrospec.diagnose(model_file, dry, units=UNITS)
    assert found.findings, found.text()
    first = found.findings[0]
    assert "friction" in first.code and first.site.name == "v"
    assert found.proof[0].holdout_after < 0.5 * found.proof[0].holdout_before
    assert "sign" in found.model_out.to_toml() or "friction" in first.code
    assert gyrospec.simulate(found.model_out, dry, units=UNITS)["position"].rms_error < 1.0
    page = found.html()
    assert page.startswith("<!doctype html>") and "<svg" in page
    assert found._repr_html_().startswith("<iframe srcdoc=")
    # the same inputs and seed: the same numbers as from the file
    again = gyrospec.diagnose(model_file, write(tmp_path / "voyage.csv", dry))
    assert again.findings == found.findings
    assert len(again.made.inputs) == 2
    assert again.made.inputs[1].file.endswith("voyage.csv")
    kept = pickle.loads(pickle.dumps(found))
    assert kept == found and kept.html() == page and kept.text() == found.text()
    assert kept.model_out == found.model_out


def test_a_fault_of_the_data_stands_beside_what_was_left_out(dry: Columns) -> None:
    position = dry["position"].copy()
    position[150:190] = position[150]
    found = gyrospec.diagnose(MODEL, {**dry, "position": position}, units=UNITS)
    assert found.schema == "gyrospec.diagnosis/2"
    assert found.verdict in ("named", "tie") and "friction" in found.findings[0].code, found.text()
    assert [(f.code, f.site.name, f.masked) for f in found.faults] == [("frozen-channel", "position", True)]
    assert "frozen-channel in position" in repr(found)


def test_the_same_data_are_not_fitted_and_held_out(dry: Columns) -> None:
    for use in (gyrospec.fit, gyrospec.diagnose):
        with pytest.raises(gyrospec.InputError, match="both fitted and held out"):
            use(MODEL, dry, holdout=dry, units=UNITS)
        with pytest.raises(gyrospec.InputError, match="twice"):
            use(MODEL, [dry, dry], units=UNITS)


def test_numbers_that_are_null_are_nan() -> None:
    from gyrospec._reading import read
    from gyrospec._results import Value

    value = read(Value, {"name": "a", "value": 1, "low": None, "high": 2, "unit": "m", "added": 1})
    assert np.isnan(value.low) and value.value == 1.0


def test_the_lock_is_let_go_during_work(viscous: Columns) -> None:
    beats, done = [0], threading.Event()

    def beat() -> None:
        while not done.is_set():
            beats[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=beat)
    thread.start()
    try:
        gyrospec.fit(MODEL, viscous, units=UNITS)
    finally:
        done.set()
        thread.join()
    assert beats[0] > 5


def _thirds(columns: Columns) -> list[Columns]:
    rows = np.array_split(np.arange(len(columns["t"])), 3)
    return [{name: values[at] for name, values in columns.items()} for at in rows]


@pytest.mark.skipif(sys.platform == "win32", reason="signals of Unix")
def test_an_interrupt_is_answered(model_file: Path, dry: Columns, tmp_path: Path) -> None:
    files = [str(write(tmp_path / f"voyage{i}.csv", part)) for i, part in enumerate(_thirds(dry))]
    script = (
        "import gyrospec, sys\n"
        "print('ready', flush=True)\n"
        f"gyrospec.diagnose({str(model_file)!r}, {files!r})\n"
    )
    child = subprocess.Popen(
        [sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    try:
        assert child.stdout is not None
        child.stdout.readline()
        time.sleep(0.3)
        child.send_signal(signal.SIGINT)
        _, errors = child.communicate(timeout=60)
    finally:
        child.kill()
    assert "KeyboardInterrupt" in errors

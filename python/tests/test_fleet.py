"""Fleets: resumed, killed in mid-run, nothing lost, nothing doubled."""

from __future__ import annotations

import os
import signal
import threading
import time
from collections import Counter
from pathlib import Path

import gyrospec
import numpy as np
import pyarrow.parquet as pq
import pytest
from conftest import MODEL, voyage, write
from distributed import Client, LocalCluster
from gyrospec import fleet

SHIPS = {"anna": 0.0, "berta": 3.0, "clara": 4.5}


@pytest.fixture(scope="session")
def voyages(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Two voyages of each of three ships, two of them with dry friction."""
    root = tmp_path_factory.mktemp("fleet")
    files = []
    for number, (ship, friction) in enumerate(SHIPS.items()):
        (root / ship).mkdir()
        for trip in range(2):
            columns = voyage(friction, 10 * number + trip, count=200)
            files.append(write(root / ship / f"voyage{trip}.csv", columns))
    return files


@pytest.fixture(scope="session")
def alone(voyages: list[Path], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What one process finds."""
    out = tmp_path_factory.mktemp("alone")
    fleet.diagnose(voyages, MODEL, out, per_part=1)
    return out


def rows(out: Path) -> list[dict[str, object]]:
    return [row for part in sorted(out.glob("part-*.parquet")) for row in pq.read_table(part).to_pylist()]


def test_a_worker_that_dies_loses_nothing_and_doubles_nothing(
    voyages: list[Path], alone: Path, tmp_path: Path
) -> None:
    out = tmp_path / "cluster"
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster,
        Client(cluster) as client,
    ):
        workers = client.run(os.getpid)
        killed = []

        def kill_one() -> None:
            # in mid-run: after the first part, before the last
            while not list(out.glob("part-*.parquet")):
                time.sleep(0.01)
            victim = sorted(workers.values())[0]
            os.kill(victim, signal.SIGKILL)
            killed.append(victim)

        killer = threading.Thread(target=kill_one, daemon=True)
        killer.start()
        done = fleet.diagnose(voyages, MODEL, out, client, per_part=1)
        killer.join(timeout=10)
        assert killed
        assert done.rows_made == len(voyages)
    assert Counter(r["file"] for r in rows(out)) == Counter(str(v) for v in voyages)
    assert not list(out.glob(".*tmp"))
    # and the answers are those of one process
    assert {r["file"]: r["report"] for r in rows(out)} == {r["file"]: r["report"] for r in rows(alone)}


def test_a_call_goes_on_where_another_stopped(voyages: list[Path], tmp_path: Path) -> None:
    out = tmp_path / "out"
    first = fleet.diagnose(voyages[:2], MODEL, out, per_part=1)
    assert (first.rows_made, first.rows_found) == (2, 0)
    before = {p.name: p.stat().st_mtime_ns for p in out.glob("part-*")}
    (out / ".part-left.parquet.tmp").write_bytes(b"cut off")
    both = fleet.diagnose(voyages[:3], MODEL, out, per_part=2)
    assert (both.rows_made, both.rows_found) == (1, 2)
    assert before.items() <= {p.name: p.stat().st_mtime_ns for p in out.glob("part-*")}.items()
    assert not list(out.glob(".*tmp"))
    assert fleet.diagnose(voyages[:3], MODEL, out).rows_made == 0
    with pytest.raises(gyrospec.InputError, match="another seed"):
        fleet.diagnose(voyages, MODEL, out, seed=2)
    with pytest.raises(gyrospec.InputError, match="another model"):
        fleet.diagnose(voyages, MODEL.replace("45.0", "44.0"), out)
    # a part that was damaged since is named, and made anew once it is gone
    damaged = next(iter(sorted(out.glob("part-*"))))
    damaged.write_bytes(damaged.read_bytes()[:200])
    for call in (lambda: fleet.diagnose(voyages[:3], MODEL, out), lambda: fleet.report(out)):
        with pytest.raises(gyrospec.InputError, match=f"{damaged.name}: this part of the results is damaged"):
            call()
    damaged.unlink()
    assert fleet.diagnose(voyages[:3], MODEL, out).rows_made == 1


def test_the_report_says_which_mechanism_on_which_ships(alone: Path, tmp_path: Path) -> None:
    broken = tmp_path / "dora" / "voyage0.csv"
    broken.parent.mkdir()
    broken.write_text("t [s],force [N]\n0,1\nx,2\n")
    fleet.diagnose([broken], MODEL, alone)
    told = fleet.report(alone)
    assert (told.recordings, told.ships) == (7, 4)
    assert list(told.errors) == [str(broken)] and ":3:" in told.errors[str(broken)]
    friction = [m for m in told.mechanisms if "friction" in m.code and m.site == "state v"]
    assert friction and set(friction[0].ships) <= {"berta", "clara"} and friction[0].recordings >= 3
    assert any(a.verdict == "nothing-missing" and "anna" in a.ships for a in told.alike)
    assert sum(len(a.files) for a in told.alike) == 6
    for n in told.neighbours:
        assert n.file != n.other
    assert f"could not be diagnosed: {broken}" in str(told)
    assert "friction" in str(told) and "friction" in told._repr_html_() and told.to_dict()["recordings"] == 7
    named = fleet.diagnose(
        [broken], MODEL, tmp_path / "named", ships=lambda path: "Ship of " + Path(path).parent.name
    )
    assert rows(named.out)[0]["ship"] == "Ship of dora"


def test_faults_of_the_data_are_counted_apart(tmp_path: Path) -> None:
    columns = voyage(3.0, 77, count=400)
    columns["position"][150:190] = columns["position"][150]
    file = write(tmp_path / "voyage.csv", columns)
    out = tmp_path / "out"
    fleet.diagnose([file], MODEL, out)
    (row,) = rows(out)
    assert [f["code"] for f in row["faults"]] == ["frozen-channel"]
    assert all("frozen" not in f["code"] for f in row["findings"])
    told = fleet.report(out)
    assert told.faults == {"frozen-channel": {"position": [str(file)]}}
    assert "frozen-channel: position in 1 recording" in str(told)


def test_the_same_data_are_not_counted_twice(voyages: list[Path], tmp_path: Path) -> None:
    copy = tmp_path / "copy.csv"
    copy.write_bytes(voyages[0].read_bytes())
    out = tmp_path / "out"
    fleet.diagnose([voyages[0], copy], MODEL, out)
    told = fleet.report(out)
    assert list(told.errors) == [str(copy)] and "the same data as" in told.errors[str(copy)]


def test_a_sweep_is_the_sweep_in_memory(tmp_path: Path) -> None:
    grid = {"heading": np.radians(np.arange(0, 360, 15)), "T": np.linspace(0.1, 2, 40), "mu": [0.05, 0.1]}
    out = tmp_path / "sweep"
    done = fleet.roll_error(grid, out, rows_per_part=500)
    assert done.rows_made == 24 * 40 * 2 and done.parts_made == 4
    next(out.glob("part-*")).unlink()
    with pytest.raises(gyrospec.InputError, match="another rows_per_part"):
        fleet.roll_error(grid, out, rows_per_part=300)
    again = fleet.roll_error(grid, out)
    assert (again.parts_made, again.rows_made + again.rows_found) == (1, done.rows_made)
    table = pq.read_table(out).sort_by("row")
    heading, lag, decay = np.meshgrid(*[np.asarray(v) for v in grid.values()], indexing="ij")
    wanted = gyrospec.roll_error_sweep(heading=heading, T=lag, mu=decay).ravel()
    assert np.array_equal(table["mean_rad"].to_numpy(), wanted)
    assert table["row"].to_pylist() == list(range(done.rows_made))
    assert np.array_equal(table["T"].to_numpy(), lag.ravel())
    with pytest.raises(gyrospec.InputError, match="another grid"):
        fleet.roll_error({**grid, "mu": [0.05, 0.2]}, out)
    with pytest.raises(gyrospec.InputError, match="does not depend on"):
        fleet.roll_error({"headings": [1.0]}, tmp_path / "wrong")
    side = fleet.roll_error({"mu": [0.1, 0.2], "T": [0.4, 0.5]}, tmp_path / "side", product=False)
    assert side.rows_made == 2
    with pytest.raises(gyrospec.InputError, match="sweep"):
        fleet.report(out)

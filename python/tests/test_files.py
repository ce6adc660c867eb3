"""Files of other programs as recordings."""

from __future__ import annotations

import pathlib

import gyrospec
import numpy as np
import pandas as pd
import pytest
import scipy.io


def test_files_that_pandas_reads_are_recordings(tmp_path: pathlib.Path) -> None:
    frame = pd.DataFrame({"t": [0.0, 0.5, 1.0], "force": [1.5, -2.0, np.nan]})
    file = tmp_path / "run.parquet"
    frame.to_parquet(file)
    for path in (file, str(file)):
        read = gyrospec.recording(path, units={"t": "s", "force": "N"})
        times, values = read.channel("force")
        assert read.name == "run"
        np.testing.assert_array_equal(times, frame["t"])
        np.testing.assert_array_equal(values, frame["force"])
    with pytest.raises(gyrospec.UsageError, match="a file says its units"):
        gyrospec.recording(tmp_path / "run.csv", units={"t": "s"})
    file.write_bytes(b"PAR1 damaged")
    with pytest.raises(gyrospec.FileError, match=r"run\.parquet: pandas cannot read it"):
        gyrospec.recording(file)


def test_a_model_is_fitted_to_such_a_file(tmp_path: pathlib.Path) -> None:
    t = np.linspace(0.0, 5.0, 200)
    file = tmp_path / "decay.parquet"
    pd.DataFrame({"t": t, "y": np.exp(-0.7 * t)}).to_parquet(file)
    model = gyrospec.model(
        lambda t, x, u, p: ({"x": -p.k * x.x}, {"y": x.x}), states=["x"], outputs=["y"], parameters={"k": 1.0}
    )
    fitted = gyrospec.fit(model, file, units={"t": "s", "y": "1"})
    assert abs(fitted.parameters[0].value - 0.7) < 1e-3


@pytest.mark.parametrize("packed", [False, True])
def test_a_file_of_matlab_as_scipy_writes_it(tmp_path: pathlib.Path, packed: bool) -> None:
    t = np.linspace(0.0, 1.0, 11)
    variables = {"t_s": t, "force_N": np.sin(t)[:, None], "log": {"x_m": t**2}, "name": "trial"}
    scipy.io.savemat(tmp_path / "run.mat", variables, do_compression=packed)
    with pytest.warns(gyrospec.Warning, match="a MATLAB file: 3 columns of 11 rows"):
        read = gyrospec.recording(tmp_path / "run.mat")
    np.testing.assert_array_equal(read.channel("force")[1], np.sin(t))
    np.testing.assert_array_equal(read.channel("log.x")[1], t**2)

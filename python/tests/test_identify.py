"""T and C0 from made trials, against the numbers that made them."""

from __future__ import annotations

from pathlib import Path

import gyrospec
import numpy as np
import pytest


def test_the_numbers_that_made_the_trials_come_back(tmp_path: Path) -> None:
    # (2.4) of the rolling-error paper, with the paper's P, H, U and g
    weight, momentum, rate, gravity, stiffness, lag = 85.0, 15.5, 7.3e-5, 9.81, 1.1e5, 0.5
    rows = ["heading [deg],amplitude [m],frequency [Hz],error [deg]"]
    for k in range(40):
        heading, p = np.radians(9.0 * k), 0.5 + 0.1 * (k % 9)
        error = -((weight * 0.25 / gravity) ** 2) * p**4 * np.sin(2 * heading) / (
            4 * momentum * rate * np.cos(np.radians(60)) * stiffness * (1 + (lag * p) ** 2)
        )
        rows.append(f"{9.0 * k},0.25,{p / (2 * np.pi)},{np.degrees(error)}")
    file = tmp_path / "trials.csv"
    file.write_text("\n".join(rows) + "\n")
    found = gyrospec.identify(file, latitude=60)
    assert found["schema"] == "gyrospec.identified/1"
    assert found["T_s"]["value"] == pytest.approx(lag, rel=1e-6)
    assert found["C0_N_per_m"]["value"] == pytest.approx(stiffness, rel=1e-6)


def test_what_it_cannot_read_is_refused(tmp_path: Path) -> None:
    with pytest.raises(gyrospec.Error):
        gyrospec.identify(tmp_path / "nothing.csv")

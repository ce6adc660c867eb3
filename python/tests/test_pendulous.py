"""A compass with a liquid ballistic, against its closed forms."""

from __future__ import annotations

import gyrospec
import numpy as np
import pytest

RADIUS, EARTH = 6.371e6, 7.292115e-5


def test_speed_and_damping_settle_it_beside_the_meridian() -> None:
    told = gyrospec.pendulous("60N", speed=7.0, heading=[0, 90], offset=0.03, corrector=(60, 7.0))
    north, east = told["rows"]
    level = EARTH * np.cos(np.radians(60))
    assert north["by_speed_deg"] == pytest.approx(np.degrees(7.0 / (RADIUS * level)), rel=1e-12)
    assert north["by_damping_deg"] == pytest.approx(-np.degrees(0.03 * np.sqrt(3)), rel=1e-12)
    # eastward the Earth turns faster below it by v/R about the level and v tan(lat)/R about the vertical
    there = level + 7.0 / RADIUS
    assert east["by_damping_deg"] == pytest.approx(-np.degrees(0.03 * np.sqrt(3) * (there / there)), rel=1e-12)
    assert [row["corrected_deg"] for row in (north, east)] == [0.0, 0.0]
    assert told["schema"] == "gyrospec.pendulous/1"


def test_what_is_of_no_use_is_refused() -> None:
    with pytest.raises(gyrospec.UsageError, match="--heading is of no use"):
        gyrospec.pendulous(50, heading=20)

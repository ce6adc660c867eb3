"""Coning and the heading found with it, against sines in quadrature and the Earth's rate."""

from __future__ import annotations

import gyrospec
import numpy as np
import pytest


def test_a_narrow_cone_turns_at_half_the_product_of_its_amplitudes() -> None:
    found = gyrospec.strapdown(
        resonance=("30Hz", 1e-6), angular={"x": "0.1mrad", "y": ("0.2mrad", -90)}, latitude=60, heading=90
    )
    (cone,) = found["effects"]
    # amplitudes are sqrt(2) times the standard deviations; what is read is the opposite
    assert cone["drift_rad_per_s"][2] == pytest.approx(-1e-4 * 2e-4 * 2 * np.pi * 30, rel=1e-5)
    assert cone["heading_error_deg"] == 0.0
    assert found["schema"] == "gyrospec.strapdown/1"


def test_a_random_walk_spreads_what_is_averaged() -> None:
    found = gyrospec.strapdown(walk="0.003deg/h^0.5", align="10min", latitude=50.0)
    # sigma = N/(U cos(phi) sqrt(t)), N in deg/h^0.5 over 1/6 h, U = 15.041 deg/h
    wanted = 0.003 / (np.degrees(7.292115e-5) * 3600 * np.cos(np.radians(50)) * np.sqrt(1 / 6))
    assert found["spread"]["aligned_deg"] == pytest.approx(np.degrees(wanted), rel=1e-9)


def test_what_is_of_no_use_is_refused() -> None:
    with pytest.raises(gyrospec.UsageError, match="one --angular alone"):
        gyrospec.strapdown(resonance="30Hz,0.1", angular={"x": 1e-4})
    with pytest.raises(gyrospec.UnitsError, match="turns or radians"):
        gyrospec.strapdown(resonance="30rad/s,0.1", angular={"x": 1e-4})

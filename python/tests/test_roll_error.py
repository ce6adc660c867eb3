"""The rolling error against the closed form in fractions of mpmath."""

from __future__ import annotations

import gyrospec
import mpmath
import numpy as np
import pytest

# the compass of the paper at 60°, heading 45°
P, H, C0, T, G, U = 85.0, 15.5, 1.35e5, 0.44, 9.81, 7.3e-5


def closed(heading: float, a: float, mu: float, eps: float, lever: float, lat: float) -> float:
    """−P²h²·M·sin 2K/(2 g² H U C₀ cos φ), M = A b²(2μ + b²T)/(T(T²ε² + (1 + μT)²)), b² = μ² + ε²."""
    a, mu, eps, t = (mpmath.mpf(x) for x in (a, mu, eps, T))
    b2 = mu**2 + eps**2
    moment = a * b2 * (2 * mu + b2 * t) / (t * (t**2 * eps**2 + (1 + mu * t) ** 2))
    return float(
        -((P * lever) ** 2) * moment * mpmath.sin(2 * heading) / (2 * G**2 * H * U * C0 * mpmath.cos(lat))
    )


def test_a_sweep_is_the_closed_form() -> None:
    heading, mu = np.meshgrid(np.radians(np.arange(5, 90, 20)), [0.02, 0.1, 0.4], indexing="ij")
    lat = np.radians(50.0)
    errors = gyrospec.roll_error_sweep(heading=heading, mu=mu, A=0.01, eps=0.7, h=5.0, lat=lat)
    assert errors.shape == heading.shape
    for k, m, e in zip(heading.flat, mu.flat, errors.flat, strict=True):
        assert e == pytest.approx(closed(k, 0.01, m, 0.7, 5.0, lat), rel=1e-12)
    assert np.isnan(gyrospec.roll_error_sweep(mu=[0.1, -1.0])).tolist() == [False, True]
    with pytest.raises(gyrospec.InputError, match="did you mean eps"):
        gyrospec.roll_error_sweep(epss=[0.1])


def test_one_compass_with_the_options_of_the_program() -> None:
    found = gyrospec.roll_error(
        heading=[30, "45deg"], latitude=60, lever="3m", irregular=(np.sqrt(0.03), 0.1, 0.8)
    )
    assert found.column("heading_deg").tolist() == pytest.approx([30.0, 45.0])
    for row in found.rows:
        wanted = np.degrees(closed(np.radians(row.heading_deg), 0.03, 0.1, 0.8, 3.0, np.radians(60)))
        assert row.rectified_deg == pytest.approx(wanted, rel=1e-9)
        assert row.spread_deg > 0
    whole = gyrospec.roll_error(irregular="4deg,0.06,0.65")
    assert "<svg" in whole.svg and "<svg" in whole._repr_html_()
    assert len(whole.rows) == 24
    assert whole.html().startswith("<!doctype html>")
    assert whole.to_dict()["schema"] == "gyrospec.roll-error/1"
    by_latitude = gyrospec.roll_error(
        sea="jonswap", height="3m", period=8, sea_from=60, also=["pitch", "heave"], against="latitude"
    )
    assert by_latitude.rows[1].latitude_deg == 5.0
    rubbed = gyrospec.roll_error(friction="2N", band=2.5, latitude=60, heading=45).rows[0]
    assert rubbed.mean_margin_deg is not None and rubbed.linearised_mean_deg is not None
    assert abs(rubbed.mean_deg + 0.755) < 0.02 + rubbed.mean_margin_deg
    assert rubbed.linearised_mean_deg > -0.5
    # parts go together; inertia of so stiff a suspension hardly counts beside the liquid's flow
    alone = gyrospec.roll_error(flow=("4s", 0.1), band=2.5, heading=45).rows[0]
    both = gyrospec.roll_error(inertia=True, flow=("4s", 0.1), band=2.5, heading=45)
    assert both.rows[0].mean_deg == pytest.approx(alone.mean_deg, rel=1e-2)
    assert both.to_dict()["instrument"] == "lag with inertia (2.2) and liquid flow"
    # the share of the mean above a frequency: ∫ ω⁴ S_θ(ω)/(1 + ω²T²) dω by (3.4), T = 0.44 s
    tail = whole.white_tail
    assert tail is not None
    w = np.geomspace(1e-3, 1e6, 1_000_000)
    a, b2 = 0.06**2 - 0.65**2, 0.06**2 + 0.65**2
    density = w**5 / ((w**4 + 2 * a * w**2 + b2**2) * (1 + (0.44 * w) ** 2))
    above = density[w > tail["above_rad_per_s"]].sum() / density.sum()
    assert tail["share"] == pytest.approx(above, abs=1e-3)


def test_the_sign_and_the_end_of_the_linear_theory_are_said() -> None:
    found = gyrospec.roll_error(irregular="8deg,0.06,0.65", lever="15m", heading=45)
    broken = {v["figure"] for v in found.validity if v["holds"] is False}
    assert broken == {"mean"}
    assert all("BEYOND" in said for said in (repr(found), found.text(), found.html()))
    assert "reads high" in found.sign and found.sign in found.text()
    for one in (gyrospec.roll_error, gyrospec.RollError, gyrospec.roll_error_sweep):
        assert " ".join(found.sign.split()) in " ".join((one.__doc__ or "").split())
    assert "BEYOND" not in gyrospec.roll_error(heading=45).text()
    assert np.isnan(gyrospec.roll_error_sweep(heading=[0.7, 200.0], g=9.81)).tolist() == [False, True]
    assert np.isnan(gyrospec.roll_error_sweep(h=[3.0, 100.0])).tolist() == [False, True]


def test_a_compass_is_a_model_or_a_name_and_the_roll_a_frame() -> None:
    model = gyrospec.Model.builtin("gyrosphere")
    assert gyrospec.roll_error(model, heading=45).rows == gyrospec.roll_error("gyrosphere", heading=45).rows
    rng = np.random.default_rng(1)
    t = 0.25 * np.arange(4800)
    roll = sum(
        np.sin(w * t + p) for w, p in zip(rng.normal(0.7, 0.05, 60), rng.uniform(0, 6.28, 60), strict=True)
    )
    found = gyrospec.roll_error(model, {"t": t, "roll": roll}, units={"t": "s", "roll": "deg"}, heading=45)
    assert found.roll is not None and found.roll["eps_rad_per_s"] == pytest.approx(0.7, abs=0.05)
    assert found.rows[0].measured_spectrum_mean_deg is not None


def test_refusals_say_what_to_do() -> None:
    with pytest.raises(gyrospec.UsageError, match="quantity"):
        gyrospec.roll_error(irregular="4deg,x,1")
    with pytest.raises(gyrospec.UsageError, match="possible values"):
        gyrospec.roll_error(sea="flat")
    with pytest.raises(gyrospec.UnitsError):
        gyrospec.roll_error(lever="3s")
    for wrong in ({"latitude": 1000}, {"irregular": (4, 0.06, 0.65)}, {"lever": 1e3}, {"heading": 400}):
        with pytest.raises(gyrospec.InputError, match="lies outside"):
            gyrospec.roll_error(**wrong)
    with pytest.raises(gyrospec.UsageError, match="along the ship"):
        gyrospec.roll_error(sea="pm", also="pitch")
    with pytest.raises(gyrospec.UsageError, match="there is none"):
        gyrospec.roll_error(irregular="4deg,0.06,0.65", roll="roll")
    with pytest.raises(TypeError, match="no quantity"):
        gyrospec.roll_error(irregular=object())  # type: ignore[arg-type]
    with pytest.raises(gyrospec.FileError):
        gyrospec.roll_error("nowhere.toml")
    with pytest.raises(gyrospec.UsageError):
        gyrospec.roll_error_sweep()

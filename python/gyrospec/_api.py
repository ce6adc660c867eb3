"""The functions: each hands its arguments to the native half and gives the answer its names."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from . import _gyrospec as native
from ._errors import InputError, UsageError, Warning
from ._function import Named, of_function
from ._inputs import Column, Floats, ModelLike, RecordingLike, as_model, as_recordings, listed
from ._linear import is_linear, of_linear
from ._results import Diagnosis, Fit, IntegralBatch, RollError, Simulation
from ._simulator import Simulator, simulated

Quantity: TypeAlias = float | str
"""A number in SI (latitude and heading in degrees), or a text with its unit: `"4deg"`."""

Quantities: TypeAlias = str | Sequence[Quantity]


def integral_batch(h: ArrayLike, g: ArrayLike, *, fast: bool = True) -> IntegralBatch:
    """Many integrals of one order n: `h` has n + 1 columns, `g` has n, a row is a problem.

    Arrays of doubles whose rows lie one after the other are not copied; do not write into them
    meanwhile. `fast` gives doubles with a guaranteed bound each; without it every value is within
    two units in the last place, at ten times the cost and more.
    """
    return IntegralBatch(*native.integral_batch(h, g, fast=fast))


def table(orders: int | str | range | tuple[int, int], format: str = "markdown") -> str:
    """I_n in symbols: of one order (7), a range with both ends ("1..10" or (1, 10)).

    format: json, markdown, latex, or a language of programs, as `gyrospec table --help` lists them.
    """
    if isinstance(orders, range):
        if orders.step != 1 or not orders:
            raise UsageError(f"{orders} is no range of orders one after the other")
        orders = (orders[0], orders[-1])
    if not isinstance(orders, (int, str, tuple)):
        raise TypeError(f"orders are 7, '1..10', (1, 10) or a range, not {type(orders).__name__}")
    text = "..".join(str(n) for n in orders) if isinstance(orders, tuple) else str(orders)
    return native.table(text, format)


def model(
    source: Any,
    *,
    states: Named | None = None,
    inputs: Named | None = None,
    parameters: Mapping[str, Any] | None = None,
    outputs: Named | None = None,
    name: str | None = None,
) -> native.Model:
    """A model from a Python function, a linear system, a file or a file's text.

    source: `f(t, x, u, p)`, which returns rates and outputs, as dicts or in the order named. It is called once, with
        symbols: operators, NumPy's functions, np.where and small arrays work on them, branches on values do not. x, u and
        p are reached by attribute, by item, or unpacked. Or a transfer function or state space in continuous time of
        python-control or SciPy, whose coefficients become the parameters; then `states`, `inputs`, `outputs` are names.
    states, inputs, outputs: names, or names with their units: {"q": "m"}; a state may be {"unit": "m", "initial": 0.0},
        and is fitted at its start without. Without outputs the states are measured.
    parameters: a number, which is fitted, or the fields of a model file: {"value": 3.0, "unit": "kg", "fit": True, "min": 0}.

    Units may be left out: those of some follow from the equations, and where none is given none is checked.

    >>> def axis(t, x, u, p):
    ...     return {"v": (u.force - p.d * x.v) / p.M}, {"speed": x.v}
    >>> gyrospec.model(axis, states=["v"], inputs=["force"], outputs=["speed"], parameters={"d": 1.0, "M": 3.0}).states
    ['v']
    """
    if is_linear(source):
        if parameters is not None:
            raise UsageError("the parameters of a linear system are its coefficients: leave `parameters` out")
        own = str(getattr(source, "name", None) or "")
        title = name or (own if own and not own.startswith("sys[") else type(source).__name__)
        return of_linear(source, _listed(states), _listed(inputs), _listed(outputs), title)
    if callable(source) and not isinstance(source, native.Model):
        called = str(name or getattr(source, "__name__", type(source).__name__))
        return of_function(source, states or [], inputs or [], parameters or {}, outputs, called)
    if any(x is not None for x in (states, inputs, parameters, outputs, name)):
        raise UsageError("a model file says its names itself: give it alone")
    return as_model(source)


def _listed(names: Named | None) -> list[str] | None:
    return None if names is None else list(names)


def simulate(
    model: ModelLike,
    recording: RecordingLike,
    *,
    units: Mapping[str, str] | None = None,
    time: str | Column | None = None,
    tolerance: float = 1e-5,
) -> Simulation:
    """Runs a model on a recording; `units` and `time` are for frames, see `recording`.

    tolerance: how far halving the step may move an output, as a share of its spread.
    """
    ran = native.simulate(as_model(model), _single(recording, units, time), tolerance)
    _warn(ran.warnings)
    return Simulation._of(ran)


def fit(
    model: ModelLike,
    recordings: RecordingLike | Sequence[RecordingLike],
    *,
    holdout: RecordingLike | Sequence[RecordingLike] | None = None,
    seed: int = 1,
    units: Mapping[str, str] | None = None,
    time: str | Column | None = None,
    time_limit: float | None = None,
) -> Fit:
    """Fits the free parameters and initial states of a model to recordings, by simulation.

    Without spans and without `holdout` the last 40 % of each recording are held out.
    time_limit: s of wall time after which it ends with the best so far.
    """
    fitted, held = _lists(recordings, holdout, units, time)
    told = native.fit(as_model(model), fitted, held, _seed(seed), _limit(time_limit))
    _warn(told.warnings)
    found = Fit._of(told)
    return found._with({"fitted": found.model_out}, fitted[0])


def diagnose(
    model: ModelLike | None = None,
    recordings: RecordingLike | Sequence[RecordingLike] | None = None,
    *,
    simulator: Callable[..., Any] | None = None,
    inputs: Sequence[str] = (),
    outputs: Sequence[str] = (),
    parameters: Mapping[str, Any] | None = None,
    holdout: RecordingLike | Sequence[RecordingLike] | None = None,
    seed: int = 1,
    units: Mapping[str, str] | None = None,
    time: str | Column | None = None,
    time_limit: float | None = None,
) -> Diagnosis:
    """Finds what a model leaves out of the physics of its recordings, and proves it on held-out data.

    The same inputs and seed give the same answer as `gyrospec diagnose`.
    time_limit: s of wall time after which the search ends with the best so far, which `made.ended_early` tells.
    simulator: in place of a model, a callable `(t, u, p)` whose equations cannot be had: times in s, a dict of the `inputs`
        at them and a dict of the `parameters` give a dict of the `outputs`, arrays at the same times in the units of the
        recording. Its parameters are fitted by whole runs to the first 60 % of the one recording, and once more beside what
        is found, linear about those values; what acts on outputs and clocks can then be named.
    """
    if recordings is None:
        raise UsageError("give a recording")
    fitted, held = _lists(recordings, holdout, units, time)
    if simulator is None:
        if model is None or inputs or outputs or parameters is not None:
            raise UsageError("give a model; or a simulator with its inputs, outputs and parameters, and no model")
        given = as_model(model)
    else:
        if model is not None or len(fitted) != 1 or held:
            raise UsageError("a simulator takes the place of the model, and is fitted to one recording without `holdout`")
        title = getattr(simulator, "__name__", type(simulator).__name__)
        box = Simulator(simulator, fitted[0], inputs, outputs, parameters or {})
        given, note = simulated(box, title)
        warnings.warn(note, Warning, stacklevel=2)
    told = native.diagnose(given, fitted, held, _seed(seed), _limit(time_limit))
    _warn(told.warnings)
    found = Diagnosis._of(told)
    return found._with({"as given": given, "with what was found": found.model_out}, fitted[0])


def roll_error(
    model: ModelLike | None = None,
    recording: RecordingLike | None = None,
    *,
    heading: Quantity | Sequence[Quantity] | None = None,
    latitude: Quantity | None = None,
    lever: Quantity | None = None,
    speed: Quantity | None = None,
    irregular: Quantities | None = None,
    regular: Quantities | None = None,
    sea: str | None = None,
    height: Quantity | None = None,
    period: Quantity | None = None,
    gamma: float | None = None,
    sea_from: Quantity | None = None,
    ship: Quantities | None = None,
    ship_length: Quantity | None = None,
    spread: float | None = None,
    roll_damping: Quantities | None = None,
    also: str | Sequence[str] | None = None,
    band: Quantity | None = None,
    against: str | None = None,
    simulate: int | None = None,
    seed: int | None = None,
    roll: str | None = None,
    units: Mapping[str, str] | None = None,
    time: str | Column | None = None,
    **part: Quantities | bool | None,
) -> RollError:
    """Mean and spread of the heading error that a ship's roll makes in her gyrocompass.

    The arguments are the options of `gyrospec roll-error`; quantities are numbers in SI (latitude and
    heading in degrees) or texts with their unit, as `irregular=("4deg", 0.06, 0.65)`.

    model: a file with [parameters], a built-in model's name, or a Model; without it the paper's compass.
    recording: a recorded roll, in place of irregular, regular or sea; `roll` names its channel.
    sea_from: where the sea comes from, off the bow: 0 ahead, 90 from abeam to starboard (as if absent).
    ship_length: the length of the ship's waterline; six beams if absent.
    speed: over the ground; in a sea, through the waves too, which she meets at another frequency.
    spread: n of cosⁿ about the main direction, where the waves come from many; long crests if absent.
    roll_damping: d of d·|rate|·rate, 1/rad, and c of c·rate³, s/rad²: damping of roll beyond the ratio.

    part: elastic parts of the compass beside the lag; parts go together, as `inertia=True, friction="2N"`:
{parts}

    Each quantity has a range, and what lies outside is refused; `validity` of the result says where the
    linear theory ends. The sign of an error: + is west: the compass's north lies west of true north, and
    the compass reads high; − is east: it reads low; the true heading is the reading minus the error.
    """
    texts = {
        "latitude": latitude, "lever": lever, "speed": speed, "irregular": irregular, "regular": regular,
        "sea": sea, "height": height, "period": period, "gamma": gamma, "sea-from": sea_from,
        "ship": ship, "ship-length": ship_length, "spread": spread, "roll-damping": roll_damping,
        "also": also, "band": band,
        "against": against, "simulate": simulate, "seed": seed, "roll": roll,
    }  # fmt: skip
    options = [f"--{name}={_words(value)}" for name, value in texts.items() if value is not None]
    if heading is not None:
        several = [heading] if isinstance(heading, (str, int, float, np.number)) else heading
        options += [f"--heading={_words(h)}" for h in several]
    options += _part(part)
    is_text = isinstance(model, str) and "\n" in model
    compass = native.Model.parse(str(model)) if is_text else model
    measured = None if recording is None else _single(recording, units, time)
    if compass is not None and not isinstance(compass, (native.Model, str, os.PathLike)):
        raise TypeError(f"a model is a path, a built-in model's name or a Model, not {type(model).__name__}")
    return RollError._of(native.roll_error(compass, measured, options))


_PARTS = {name: (numbers, says) for name, numbers, says in native.elastic_options()}
roll_error.__doc__ = (roll_error.__doc__ or "").replace(
    "{parts}", "\n".join(f"    {name}: {says}." for name, (_, says) in _PARTS.items())
)


def _part(said: Mapping[str, Quantities | bool | None]) -> list[str]:
    options = []
    for name, value in said.items():
        if name not in _PARTS:
            known = ", ".join(_PARTS)
            raise TypeError(f"roll_error() got an unexpected keyword argument {name!r}; parts are {known}")
        numbers, _ = _PARTS[name]
        option = f"--{name.replace('_', '-')}"
        if not numbers and value:
            options.append(option)
        elif numbers and value is not None:
            options.append(f"{option}={_words(value)}")
    return options


def roll_error_sweep(**columns: Column) -> Floats:
    """The mean rolling error in rad of very many compasses on irregular roll, by the batch path.

    Each argument is a column of numbers in SI under its name in the symbol table: P, H, C0, T, h, lat, g,
    U of the compass, A, mu, eps of the roll, heading; numbers and columns are broadcast. What is not
    given is that of Example 3.1. NaN where a row has no error: where a number lies outside its range, or
    the linear theory would give more than 45°. The sign of an error: + is west: the compass's north lies
    west of true north, and the compass reads high; − is east: it reads low; the true heading is the
    reading minus the error.
    """
    if not columns:
        raise UsageError("give a column at least, such as heading=np.radians(range(0, 360, 15))")
    names = list(columns)
    try:
        spread = np.broadcast_arrays(*(np.asarray(columns[n], dtype=np.float64) for n in names))
    except ValueError as e:
        raise InputError(f"the columns do not fit together: {e}") from None
    shape = spread[0].shape
    flat = {n: np.ravel(a) for n, a in zip(names, spread, strict=True)}
    return native.roll_error_sweep(flat).reshape(shape)


def strapdown(
    *,
    angular: Mapping[str, Quantities] | None = None,
    linear: Mapping[str, Quantities] | None = None,
    resonance: Quantities | None = None,
    coherence: float | None = None,
    anisoinertia: Quantities | None = None,
    anisoelasticity: Quantities | None = None,
    square: Quantity | None = None,
    tuned_rotor: Quantities | None = None,
    latitude: Quantity | None = None,
    heading: Quantity | None = None,
    walk: Quantity | None = None,
    loop: Quantities | None = None,
    align: Quantity | None = None,
    irregular: Quantities | None = None,
    lever: Quantity | None = None,
) -> dict[str, Any]:
    """What vibration and noise do to a strapdown system, to single gyros, and to a heading found with them.

    The arguments are the options of `gyrospec strapdown`; quantities are numbers in SI (phases, latitude
    and heading in degrees) or texts with their unit. The result has the fields of its JSON.

    angular, linear: by axis, as `angular={"x": "0.1mrad", "y": ("0.1mrad", -90)}`: standard deviation,
    phase, and frequency and damping ratio where they are not those of `resonance`.

    >>> cone = gyrospec.strapdown(resonance="30Hz,0.05", angular={"x": 1e-4, "y": (1e-4, -90)})
    >>> cone["effects"][0]["effect"]
    'coning'
    """
    texts = {
        "resonance": resonance, "coherence": coherence, "anisoinertia": anisoinertia,
        "anisoelasticity": anisoelasticity, "square": square, "tuned-rotor": tuned_rotor, "latitude": latitude,
        "heading": heading, "walk": walk, "loop": loop, "align": align, "irregular": irregular, "lever": lever,
    }  # fmt: skip
    options = [f"--{name}={_words(value)}" for name, value in texts.items() if value is not None]
    for name, axes in (("angular", angular), ("linear", linear)):
        options += [f"--{name}={axis}={_words(value)}" for axis, value in (axes or {}).items()]
    answer: dict[str, Any] = json.loads(native.strapdown(options))
    return answer


def identify(
    trials: str | os.PathLike[str],
    *,
    compass: str | os.PathLike[str] | None = None,
    latitude: Quantity | None = None,
    lever: Quantity | None = None,
) -> dict[str, Any]:
    """T and C0 of a compass from a file of errors measured on regular roll, with 95 % intervals.

    The arguments are those of `gyrospec identify`: a CSV file with units in its header or a TOML recording of kind
    "trials", the compass's parameters, the latitude (degrees) of trials without a column of it, and the height of the
    compass above the roll axis (m) for amplitudes that are angles. The result has the fields of its JSON.

    >>> found = gyrospec.identify("examples/trials.csv", latitude=46.5)
    >>> 0.40 < found["T_s"]["value"] < 0.48
    True
    """
    texts = {"compass": compass and os.fspath(compass), "latitude": latitude, "lever": lever}
    words = [f"--{name}={_words(value)}" for name, value in texts.items() if value is not None]
    answer: dict[str, Any] = json.loads(native.identify([*words, "--", os.fspath(trials)]))
    return answer


def pendulous(
    latitude: Quantity,
    *,
    speed: Quantity | None = None,
    heading: Quantity | Sequence[Quantity] | None = None,
    corrector: Quantities | None = None,
    manoeuvres: Quantities | None = None,
    momentum: Quantity | None = None,
    offset: Quantity | None = None,
    flow: Quantity | None = None,
    ballistic: Quantity | None = None,
    tuned_at: Quantity | None = None,
) -> dict[str, Any]:
    """Errors of a compass with a liquid ballistic: settled, behind its corrector, and spread by manoeuvres.

    The arguments are the options of `gyrospec pendulous`; quantities are numbers in SI (latitudes and
    headings in degrees) or texts with their unit. The result has the fields of its JSON.

    >>> there = gyrospec.pendulous(60, offset=0.03, corrector=(55, 0))
    >>> round(there["rows"][0]["settled_deg"], 3)   # -0.03 rad * tan(60 deg)
    -2.977
    """
    texts = {
        "latitude": latitude, "speed": speed, "corrector": corrector, "manoeuvres": manoeuvres,
        "momentum": momentum, "offset": offset, "flow": flow, "ballistic": ballistic, "tuned-at": tuned_at,
    }  # fmt: skip
    options = [f"--{name}={_words(value)}" for name, value in texts.items() if value is not None]
    headings = [heading] if heading is None or isinstance(heading, (str, float, int, np.number)) else heading
    options += [f"--heading={_words(value)}" for value in headings if value is not None]
    answer: dict[str, Any] = json.loads(native.pendulous(options))
    return answer


def _single(
    given: RecordingLike, units: Mapping[str, str] | None, time: str | Column | None
) -> native.Recording:
    if isinstance(given, (list, tuple)):
        raise TypeError("one recording is wanted, not several")
    return as_recordings([given], units, time)[0]


def _lists(
    recordings: RecordingLike | Sequence[RecordingLike],
    holdout: RecordingLike | Sequence[RecordingLike] | None,
    units: Mapping[str, str] | None,
    time: str | Column | None,
) -> tuple[list[native.Recording], list[native.Recording]]:
    first, held = listed(recordings), listed(holdout)
    if not first:
        raise UsageError("give one recording at least")
    read = as_recordings([*first, *held], units, time)
    return read[: len(first)], read[len(first) :]


def _seed(seed: int) -> int:
    if not 0 <= seed < 2**64:
        raise UsageError(f"the seed {seed} is no number from 0 to 2**64 - 1")
    return seed


def _limit(seconds: float | None) -> float | None:
    if seconds is not None and not 0 < seconds < 1e15:
        raise UsageError(f"the time limit {seconds} is no number of seconds above 0")
    return seconds


def _words(value: object) -> str:
    if isinstance(value, (str, int, float, np.number)):
        return str(value)
    if isinstance(value, Sequence):
        return ",".join(str(v) for v in value)
    raise TypeError(f"{value!r} is no quantity, such as 3 or '3m'")


def _warn(says: Sequence[str]) -> None:
    for text in says:
        warnings.warn(text, Warning, stacklevel=3)

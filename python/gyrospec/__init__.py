"""Exact variances from rational spectra, a gyrocompass's rolling error, and what a simulation leaves out.

>>> import gyrospec
>>> gyrospec.integral([1, 2, 3], [0, 1]).value
0.08333333333333333

`gyrospec.diagnose(model, recording)` names what the model leaves out of a recording; `fit` and
`simulate` are its parts. A model is a file, its text, or what `gyrospec.model` makes of a Python function or a transfer
function; a recording is a file, or a frame with units:
`gyrospec.recording(frame, units={"t": "s", "roll": "deg"})`. `gyrospec.fleet` does the same for
thousands of files on Dask.
"""

from ._api import (
    diagnose,
    fit,
    identify,
    integral_batch,
    model,
    pendulous,
    roll_error,
    roll_error_sweep,
    simulate,
    strapdown,
    table,
)
from ._errors import (
    Error,
    FileError,
    ImaginaryAxisError,
    InputError,
    NotComputedError,
    OutOfRangeError,
    UnitsError,
    UnstableError,
    UsageError,
    Warning,
)
from ._gyrospec import VERSION as __version__
from ._gyrospec import Integral, Model, Recording, integral
from ._inputs import recording
from ._results import DataFault, Diagnosis, Finding, Fit, IntegralBatch, RollError, Simulation

__all__ = [
    "DataFault",
    "Diagnosis",
    "Error",
    "FileError",
    "Finding",
    "Fit",
    "ImaginaryAxisError",
    "InputError",
    "Integral",
    "IntegralBatch",
    "Model",
    "NotComputedError",
    "OutOfRangeError",
    "Recording",
    "RollError",
    "Simulation",
    "UnitsError",
    "UnstableError",
    "UsageError",
    "Warning",
    "__version__",
    "diagnose",
    "fit",
    "identify",
    "integral",
    "integral_batch",
    "model",
    "pendulous",
    "recording",
    "roll_error",
    "roll_error_sweep",
    "simulate",
    "strapdown",
    "table",
]

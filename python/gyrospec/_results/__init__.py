"""Results: objects with the fields of the program's JSON reports."""

from ._batch import IntegralBatch
from ._diagnosis import (
    Band,
    DataFault,
    Detection,
    Diagnosis,
    Finding,
    Located,
    ParameterChange,
    Proof,
    Signal,
    Site,
    Stretch,
    Unexplained,
    Visible,
)
from ._fit import Direction, Fit, FittedInitial, FittedOutput, FittedParameter, Residual, Weight
from ._report import InputFile, Made, Value
from ._rolling import RollError, RollErrorRow
from ._simulation import SimulatedOutput, Simulation

__all__ = [
    "Band",
    "DataFault",
    "Detection",
    "Diagnosis",
    "Direction",
    "Finding",
    "Fit",
    "FittedInitial",
    "FittedOutput",
    "FittedParameter",
    "InputFile",
    "IntegralBatch",
    "Located",
    "Made",
    "ParameterChange",
    "Proof",
    "Residual",
    "RollError",
    "RollErrorRow",
    "Signal",
    "SimulatedOutput",
    "Simulation",
    "Site",
    "Stretch",
    "Unexplained",
    "Value",
    "Visible",
    "Weight",
]

"""Thousands of recordings, or very many compasses, on one machine or on a Dask cluster.

`diagnose` and `roll_error` write their results into a folder as Parquet parts, each of them whole or
not at all; called again they go on where they stopped. `report` reads the folder and says which
mechanism sits on which ships, how large, and which recordings are alike.

Without a client the work is done in this process; with one (`dask.distributed.Client`) by its workers,
which need this package and the same paths. A worker that dies loses nothing but its present part.
"""

from ._diagnose import diagnose
from ._parts import Progress
from ._report import Alike, FleetReport, Mechanism, Neighbour, report
from ._sweep import roll_error

__all__ = ["Alike", "FleetReport", "Mechanism", "Neighbour", "Progress", "diagnose", "report", "roll_error"]

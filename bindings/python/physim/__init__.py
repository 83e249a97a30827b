"""PhySim: projectile motion, from arcade to check-case.

    import physim
    flight = physim.fly(mass="168 gr", diameter="0.308 in", drag_table="g7",
                        drag_ballistic_coefficient="0.218 lb/in^2", speed="2700 ft/s",
                        sight_zero_range="100 m", until_ground=None, until_range=1000)
    flight.plot()

`physim.settings()` lists all keywords with units, ranges and defaults. The guide is docs/python.md.
"""

from ._adapters import from_py_ballisticcalc, from_rocketpy
from ._core import __version__, use_kernel
from ._errors import Error
from ._executors import RayExecutor
from ._flight import Event, Flight, Sample
from ._scenario import Aim, Batch, Comparison, Fit, Scenario, Shot, Solution, fly, suvat
from ._settings import Setting, Settings, settings
from ._study import Study, StudyResult, study_paths
from ._table import Columns, Record
from ._world import Projectile, Replay, Scene, Snapshot, World, replay

__all__ = [
    "Aim", "Batch", "Columns", "Comparison", "Error", "Event", "Fit", "Flight", "Projectile", "RayExecutor", "Record", "Replay",
    "Sample",
    "Scenario", "Scene", "Setting", "Settings", "Shot", "Snapshot", "Solution", "Study", "StudyResult", "World", "__version__", "fidelities",
    "fly", "from_py_ballisticcalc", "from_rocketpy", "kernels", "presets", "replay", "settings", "study_paths", "suvat", "use_kernel",
]  # fmt: skip


def fidelities() -> list[str]:
    """Names of the presets of fidelity, from cheap to true."""
    from ._core import names

    return names("fidelity")


def presets() -> list[str]:
    """Names of the projectiles to start from: `Shot(preset="golf_ball")`."""
    from ._core import names

    return names("projectile")


def kernels() -> list[str]:
    """Instruction sets that this machine can fly with, best first."""
    from ._core import names

    return names("kernel")

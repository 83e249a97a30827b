"""The repository, the command line and shots that the tests share."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

import physim

ROOT = Path(__file__).resolve().parents[3]
SCENARIOS = ROOT / "scenarios"
BULLET = {
    "name": "308-168gr",
    "mass": "168 gr",
    "diameter": "0.308 in",
    "length": "1.226 in",
    "twist": "12 in",
    "drag": {"table": "g7", "ballistic_coefficient": "0.218 lb/in^2"},
    "speed": "2700 ft/s",
    "sight": {"height": "1.5 in", "zero_range": "100 m"},
    "fidelity": "small_arms",
    "until_ground": None,
    "until_range": "1000 m",
    "until_time": "10 s",
}


def program() -> str:
    """The command line of this tree; its tests are left out where it was not built."""
    path = os.environ.get("PHYSIM_PROGRAM", str(ROOT / "build/release/bin/physim"))
    if not Path(path).exists():
        pytest.skip(f"the command line is not there: {path}; ./dev build makes it")
    return path


def run_program(*args: str) -> str:
    done = subprocess.run([program(), *args], capture_output=True, text=True, cwd=ROOT)
    assert done.returncode in (0, 1), done.stderr  # 1: an expectation of the scenario is missed
    return done.stdout


def same_bits(a, b) -> bool:
    """Equal as bytes: signs of zero and NaN count, too."""
    return np.ascontiguousarray(a).tobytes() == np.ascontiguousarray(b).tobytes()


@pytest.fixture
def bullet() -> physim.Shot:
    return physim.Shot(**BULLET)


@pytest.fixture
def level(bullet) -> physim.Shot:
    """A rifle of a known elevation, so that no zero is searched for."""
    return bullet.replace(sight_zero_range=0, elevation="3 mrad")

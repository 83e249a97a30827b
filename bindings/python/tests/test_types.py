"""Types: the package and a user's program pass `mypy --strict`; the stub knows all of the extension module."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import physim
from physim import _core

pytest.importorskip("mypy")
PACKAGE = Path(physim.__file__).parent

PROGRAM = """
import numpy as np
import physim

shot = physim.Shot(mass="168 gr", speed="2700 ft/s", drag={"table": "g7"})
flight: physim.Flight = shot.fly(until_range=600)
height: float = flight.apogee.y
batch: physim.Batch = shot.batch(speed=np.linspace(700, 800, 10))
with physim.World(step=1 / 120) as world:
    ids = world.spawn(shot, speed=[10.0, 20.0])
    world.step(3)
    place = world.positions(ids)
answer = shot.aim((100, 0, 0))
if answer.low is not None:
    print(answer.low.elevation, height, batch.size, place.shape)
"""


def test_types_are_strict(tmp_path):
    program = tmp_path / "program.py"
    program.write_text(PROGRAM)
    command = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path / "cache")]
    done = subprocess.run([*command, str(PACKAGE), str(program)], capture_output=True, text=True,
                          cwd=tmp_path, env={"MYPYPATH": str(PACKAGE.parent), "PATH": "/usr/bin:/bin"})  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_stub_names_all_that_there_is():
    text = (PACKAGE / "_core.pyi").read_text()
    for name in dir(_core):
        if not name.startswith("_") or name == "__version__":
            assert f" {name}" in text or f"{name}:" in text, name
    assert (PACKAGE / "py.typed").exists()


def test_all_that_is_public_has_a_docstring():
    for name in physim.__all__:
        each = getattr(physim, name)
        assert name == "__version__" or each.__doc__, name
        if isinstance(each, type):
            for method, value in vars(each).items():
                plain = method.startswith("_") or not (callable(value) or isinstance(value, property))
                assert plain or value.__doc__ or method in WITHOUT_WORDS, f"{name}.{method}"


WITHOUT_WORDS = {
    "alive", "as_dict", "in_reach", "label", "title", "sleep", "wake", "remove_force", "remove_joint", "closed", "path",
    "remove_emitter", "play_emitter", "stop_emitter", "remove_thing", "stop_recording",
}  # fmt: skip

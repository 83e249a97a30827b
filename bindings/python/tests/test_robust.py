"""Misuse, endings and long use: an exception or a clean end, never a crash, and no growth."""

from __future__ import annotations

import gc
import inspect
import os
import pickle
import subprocess
import sys
import textwrap
import weakref

import numpy as np
import pytest
from conftest import BULLET

import physim
from physim import _core


def resident() -> int:
    """Memory of this process [bytes]."""
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


SHORT = {"mass": 1, "speed": 20, "elevation": 0.5, "fidelity": "arcade", "until_time": 1}


def make_flights():
    shot = physim.Shot(**SHORT)
    for _ in range(3000):
        shot.fly().end  # noqa: B018


def make_shots():
    for i in range(500):
        physim.Shot(**{**SHORT, "speed": 20 + i})


def make_errors():
    for _ in range(500):
        with pytest.raises(physim.Error):
            physim.Shot(mass=-1)


def make_worlds():
    for _ in range(20):
        world = physim.World(threads=1)
        world.spawn(physim.Shot(**SHORT), speed=np.linspace(10, 20, 50))
        world.add_force(lambda time, ids, position, velocity, mass: -velocity)
        world.step(5)
        world.positions()


def make_batches():
    shot = physim.Shot(**SHORT)
    for _ in range(50):
        shot.batch(speed=np.linspace(10, 20, 500))
        with pytest.raises(physim.Error):
            shot.batch(speed=np.linspace(10, 20, 500), into={"time": np.empty(3)})


def make_snapshots():
    world = physim.World(threads=1)
    world.spawn(physim.Shot(**SHORT), speed=np.linspace(10, 20, 50))
    for _ in range(100):
        moment = world.snapshot()
        world.step()
        world.restore(moment)
        pickle.loads(pickle.dumps(world))


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="reads /proc")
@pytest.mark.parametrize(
    "make", [make_flights, make_shots, make_errors, make_worlds, make_batches, make_snapshots], ids=lambda f: f.__name__
)
def test_made_and_dropped_without_growth(make):
    for _ in range(3):
        make()
    gc.collect()
    before = resident()
    for _ in range(6):
        make()
    gc.collect()
    assert resident() - before < 3_000_000


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="reads /proc")
def test_a_million_objects_are_made_and_dropped_without_growth():
    """Shots, flights, samples, events, columns, errors: memory stays that of the first tenth."""
    shot, made, before = physim.Shot(**SHORT), 0, None
    while made < 1_000_000:
        for i in range(100):
            flight = physim.Shot(**{**SHORT, "speed": 20 + i}).fly()
            made += 3 + len([flight.at_time(0.5), flight.end])
        flights = [shot.fly() for _ in range(1000)]
        made += len(flights) + len([flight.at_time(0.3) for flight in flights])
        with pytest.raises(physim.Error):
            physim.Shot(mass=-1)
        made += shot.batch(speed=np.linspace(10, 20, 10)).size
        del flights, flight
        if before is None and made > 100_000:
            gc.collect()
            before = resident()
    gc.collect()
    assert before is not None and resident() - before < 3_000_000


def run(program: str) -> subprocess.CompletedProcess[str]:
    code = "import sys; sys.path.insert(0, {!r})\n".format(str(os.path.dirname(os.path.dirname(physim.__file__))))
    return subprocess.run([sys.executable, "-X", "dev", "-W", "ignore", "-c", code + textwrap.dedent(program)],
                          capture_output=True, text=True, timeout=120, check=False)  # fmt: skip


@pytest.mark.parametrize(
    "program",
    [
        """
        import numpy as np, physim
        shot = physim.Shot(mass=1, speed=20, elevation=0.5, wind_field=lambda t, x: np.zeros_like(x))
        flight, batch = shot.fly(), shot.batch(speed=np.full(10_000, 20.0), threads=2)
        world = physim.World(threads=2)
        ids = world.spawn(shot, speed=np.linspace(10, 20, 1000))
        world.add_force(lambda time, ids, position, velocity, mass: -velocity)
        world.step(3)
        one, moment = world[ids[0]], world.snapshot()
        cycle = [world]; cycle.append(cycle); world.mine = cycle
        """,
        """
        import physim, sys
        world = physim.World()
        world.spawn(physim.Shot(mass=1, speed=20))
        def leaves(time, ids, position, velocity, mass):
            sys.exit(0)
        world.add_force(leaves)
        world.step()
        """,
        """
        import physim
        world = physim.World()
        world.spawn(physim.Shot(mass=1, speed=20))
        class Own:
            def __init__(self, world): self.world = world
            def __call__(self, time, ids, position, velocity, mass):
                self.__dict__.pop("world", None)
                return 0 * position
        force = Own(world)
        world.add_force(force)
        del world
        force.world.step()
        """,
    ],
    ids=["live objects", "exit in a callback", "the last reference goes in a step"],
)
def test_the_interpreter_ends_cleanly(program):
    done = run(program)
    assert done.returncode == 0 and not done.stderr, done.stderr


def test_a_thread_that_flies_when_the_interpreter_ends():
    done = run(
        """
        import physim, threading, time
        shot = physim.Shot(mass=1, speed=200, elevation=0.5, fidelity="small_arms", tolerance_step=1e-4,
                           fidelity_integrator="rk4")
        def fly():
            while True:
                shot.fly()
        for _ in range(3):
            threading.Thread(target=fly, daemon=True).start()
        time.sleep(0.3)
        """
    )
    assert done.returncode == 0, (done.returncode, done.stderr)


@pytest.mark.parametrize(
    "work",
    ["shot.batch(speed=np.full(2000, 20.0), threads=2)", "shot.fly()", "world.step(1000)", "study.run()"],
)
def test_a_thread_whose_functions_are_called_when_the_interpreter_ends(work):
    """Python ends such threads wherever they wait for it: in the middle of functions of C++, which aborts."""
    program = f"""
        import numpy as np, physim, threading, time
        shot = physim.Shot(mass=0.5, diameter=0.1, speed=20, elevation="45 deg", fidelity="small_arms",
                           wind_field=lambda t, x: np.zeros_like(x))
        world = physim.World()
        world.spawn(shot, 10)
        world.add_force(lambda time, ids, position, velocity, mass: -0.01 * velocity)
        study = shot.study(inputs={{"speed": "+- 1 m/s"}}, range=20, shots=100_000)
        def go():
            while True:
                {work}
        for _ in range(3):
            threading.Thread(target=go, daemon=True).start()
        time.sleep(0.3)
        """
    for _ in range(4):
        done = run(program)
        assert done.returncode == 0, (done.returncode, done.stderr)


def test_worlds_that_hold_themselves_by_their_functions_are_collected():
    class Game:
        def __init__(self) -> None:
            self.world = physim.World(threads=1)
            self.world.on_hit(self.hit)
            self.world.add_force(self.force)
            self.world.spawn(physim.Shot(**SHORT), 3, asks=True)

        def force(self, time, ids, position, velocity, mass):
            return 0 * position

        def hit(self, questions):
            return ["stop"] * len(questions)

    games = [Game() for _ in range(20)]
    for game in games:
        game.world.step(2)
    left = [weakref.ref(game) for game in games]
    del games, game
    gc.collect()
    assert not any(each() for each in left)


def test_a_key_ends_many_steps():
    done = run(
        """
        import physim, signal
        world = physim.World()
        world.spawn(physim.Shot(mass=1, speed=20, body_gravity_scale=0), 1000)
        signal.signal(signal.SIGALRM, lambda *_: (_ for _ in ()).throw(KeyboardInterrupt))
        signal.setitimer(signal.ITIMER_REAL, 0.3)
        try:
            world.step(10**12)
        except KeyboardInterrupt:
            print("ended", world.time > 0)
        """
    )
    assert done.returncode == 0 and done.stdout == "ended True\n", done.stderr


def nonsense():
    yield from (None, True, -1, 0, 2**63, 2**64, 1.5, float("nan"), float("inf"), "", "x" * 10_000, "\0", "\ud800", b"x")
    yield from ([], [1], (), {}, {"a": 1}, {1: 2}, object(), np.zeros(3), np.zeros((2, 2)), np.array(None), lambda: 0)
    yield from (1j, range(3), physim, physim.Shot, [[[[]]]], {"mass": {}}, np.float32(1), np.datetime64("now"))


def callables():
    shot = physim.Shot(**BULLET)
    world = physim.World()
    ids = world.spawn(shot, 2)
    scene = physim.Scene(shape=[{"name": "s", "sphere": {"radius": 1}}], thing=[{"name": "t", "shape": "s"}])
    flight = shot.fly()
    left_out = {"save", "plot", "record", "close", "run", "cheapest_within", "compare", "study"}
    for each in (shot, flight, flight.samples(3), world, world[ids[0]], scene, world.snapshot(), physim.Scenario(shot={})):
        for name, method in inspect.getmembers(each):
            if not name.startswith("_") and callable(method) and name not in left_out:
                yield f"{type(each).__name__}.{name}", method
    yield from (("Shot", physim.Shot), ("Scenario", physim.Scenario), ("World", physim.World), ("fly", physim.fly))
    yield from (("from_text", physim.Scenario.from_text), ("load", physim.World.load), ("suvat", physim.suvat))


TAKES_ITS_TIME = {"step", "advance", "spawn", "samples", "max_range", "air"}  # so many steps are what was asked for


@pytest.mark.parametrize("count", [1, 2])
def test_nonsense_is_an_exception_or_an_answer(count):
    """Whatever is called with whatever: it returns or raises, and the process lives."""
    values = list(nonsense())
    allowed = (ValueError, TypeError, KeyError, AttributeError, OverflowError, IndexError, OSError, RuntimeError, MemoryError)
    called = 0
    for name, method in callables():
        for value in values:
            if isinstance(value, int) and value > 1000 and name.rpartition(".")[2] in TAKES_ITS_TIME:
                continue
            try:
                method(*[value] * count)
            except allowed:
                pass
            called += 1
    assert called > 1000


def test_nonsense_for_every_keyword():
    for row in physim.settings().values():
        if not row.keyword or row.path == "shot":
            continue
        for value in nonsense():
            try:
                physim.Shot(**{row.keyword: value})
            except (physim.Error, TypeError, UnicodeEncodeError):
                pass


def test_the_extension_module_refuses_nonsense_too():
    values = list(nonsense())
    for name in dir(_core):
        function = getattr(_core, name)
        if name.startswith("_") or not callable(function):
            continue
        for count in range(4):
            for value in values:
                try:
                    function(*[value] * count)
                except Exception:  # noqa: BLE001  # anything but a crash
                    pass


@pytest.mark.parametrize("damage", ["cut", "flip"])
def test_damaged_bytes_are_refused(damage):
    world = physim.World()
    world.spawn(physim.Shot(**SHORT), 3)
    save = world.save()
    draws = np.random.default_rng(3)
    for at in draws.integers(0, len(save), 60):
        broken = save[:at] if damage == "cut" else save[:at] + bytes([save[at] ^ 0x40]) + save[at + 1 :]
        with pytest.raises(physim.Error):
            physim.World.load(broken)


class Itself:
    def tolist(self):
        return self


def test_what_holds_itself_is_refused():
    table, row = {}, []
    table["table"] = table
    row.append(row)
    for holds_itself in ({"drag": table}, {"drag_curve": row}, {"mass": Itself()}):
        with pytest.raises(physim.Error, match="nested too deeply"):
            physim.Shot(**holds_itself)

"""Arguments of calls: texts with units everywhere, and a physim.Error for what is none; nothing is ignored."""

from __future__ import annotations

import math

import numpy as np
import pytest
from conftest import BULLET

import physim

BALL = {"mass": 0.5, "diameter": 0.1, "fidelity": "game", "speed": 20, "elevation": "45 deg"}


@pytest.fixture
def world():
    return physim.World(step=1 / 120)


@pytest.fixture
def study(level):
    return level.study(inputs={"speed": "+- 3 m/s"}, targets=["circle 1 m"], range=600, shots=4096)


@pytest.mark.parametrize("ask", ["at_time", "accelerations", "jerk", "stability", "geodetic", "at_range", "at_height"])
@pytest.mark.parametrize("bad", [math.nan, np.float64("nan"), "soon", None, [1.0]])
def test_a_place_that_is_no_number_is_an_error(bullet, ask, bad):
    with pytest.raises(physim.Error) as raised:
        getattr(bullet.fly(), ask)(bad)
    assert raised.value.place in ("time", "range", "height")


def test_times_that_are_nan_are_rows_of_nan_as_ranges_are(bullet):
    flight = bullet.fly()
    times, ranges = flight.at_times([0.5, math.nan]), flight.at_ranges([300.0, math.nan])
    assert times.x[0] == flight.at_time(0.5).x
    for column in ("time", "x", "vy", "speed", "drop", "energy"):
        assert math.isnan(times[column][1]) and math.isnan(ranges[column][1]), column


def test_quantities_are_texts_with_units_everywhere(bullet, world, study):
    throw = physim.Shot(**{**BALL, "fidelity": "simulation"})
    assert bullet.air("1 km") == bullet.air(1000)
    assert throw.max_range(slope="5 deg", ground="0 ft", time="1 min") == throw.max_range(slope=math.radians(5), time=60)
    assert [each.t for each in physim.suvat(s="0 m", u="30 m/s", a="-1 g")][1] == pytest.approx(60 / 9.80665)
    assert throw.cheapest_within("10 cm", time="1 s", step="20 ms").error <= 0.1
    assert bullet.aim("500 m, 0 m, 0 m", tolerance="1 cm").low.elevation == bullet.aim((500, 0, 0)).low.elevation
    assert bullet.aim(["0.5 km", 0, "0 ft"], velocity="0 m/s, 0 m/s, 36 km/h").low.azimuth > 0
    assert bullet.fly().at_time("500 ms").time == 0.5 and bullet.fly().danger_space("300 m", "50 cm")
    assert world.advance("20 ms") == 2 and world.step(dt="5 ms").size == 0
    one = world[world.spawn(throw, delay="0 s")[0]]
    one.position, one.velocity = "0 m, 1 km, 0 m", ("36 km/h", 0, 0)
    assert list(one.position) == [0, 1000, 0] and list(one.velocity) == [10, 0, 0]
    assert len(world.in_ball("0 m, 1 km, 0 m", "1 ft")) == 1
    wide = bullet.replace(sight_zero_range=0).study(inputs={"speed": "+- 3 m/s"}, targets=["circle 1 m"], range="600 m",
                                                    until_width="90 %", shots=8192)  # fmt: skip
    assert wide._until_width == 0.9 and study.run(seconds="5 min").shots


def test_quantities_of_pint_are_arguments(bullet):
    unit = pytest.importorskip("pint").UnitRegistry()
    assert bullet.air(1 * unit.kilometer) == bullet.air(1000)
    with pytest.raises(physim.Error, match="convert"):
        bullet.air(1 * unit.second)
    with pytest.raises(physim.Error, match="convert"):
        bullet.batch(speed=np.array([1.0]) * unit.kilogram)


def refused():
    yield "fly", lambda s: physim.fly("168 gr")
    yield "Shot", lambda s: physim.Shot("x")
    yield "Study", lambda s: physim.Study(5)
    yield "air", lambda s: s["bullet"].air("1000 s")
    yield "aim", lambda s: s["bullet"].aim("500 m, 0 m")
    yield "aim at", lambda s: s["bullet"].aim(5)
    yield "aim at words", lambda s: s["bullet"].aim("here, there, up")
    yield "cheapest", lambda s: s["bullet"].cheapest_within("1 kg")
    yield "suvat", lambda s: physim.suvat(u="30 kg", t=1, a=2)
    yield "suvat of", lambda s: physim.suvat(u=[1], t=1, a=2)
    yield "samples", lambda s: s["bullet"].fly().samples(-3)
    yield "half samples", lambda s: s["bullet"].fly().samples(1.5)
    yield "threads", lambda s: s["bullet"].batch(speed=[800.0], threads=-1)
    yield "study samples", lambda s: s["study"].samples(-1)
    yield "shards", lambda s: s["study"].fly_shards(-1, 1)
    yield "study threads", lambda s: s["study"].run(threads=-1)
    yield "spawn", lambda s: s["world"].spawn(5)
    yield "spawn half", lambda s: s["world"].spawn(physim.Shot(**BALL), 1.5)
    yield "spawn nothing", lambda s: s["world"].spawn(physim.Shot(**BALL), delay="1 m")
    yield "emitter", lambda s: s["world"].add_emitter("x")
    yield "restore", lambda s: s["world"].restore(b"abc")
    yield "load", lambda s: physim.World.load("abc")
    yield "set_scene", lambda s: s["world"].set_scene(5)
    yield "step half", lambda s: s["world"].step(1.5)
    yield "step nan", lambda s: s["world"].step(dt=math.nan)
    yield "advance nan", lambda s: s["world"].advance(math.nan)
    yield "advance back", lambda s: s["world"].advance(-5)
    yield "advance by", lambda s: s["world"].advance("0.1 m")
    yield "id", lambda s: s["world"]["x"]
    yield "force", lambda s: s["world"].remove_force(-1)
    yield "thing", lambda s: s["world"].remove_thing("wall")
    yield "layers", lambda s: s["world"].in_ball((0, 0, 0), 1, layers=-1)
    yield "table nan", lambda s: s["bullet"].table([math.nan])
    yield "table behind", lambda s: s["bullet"].table([-100])
    yield "table of", lambda s: s["bullet"].table(["100 kg"])
    yield "winds", lambda s: s["bullet"].table([100], winds=["10 m"])


@pytest.mark.parametrize(("what", "call"), list(refused()), ids=[what for what, _ in refused()])
def test_bad_arguments_are_errors_of_the_library(bullet, world, study, what, call):
    with pytest.raises(physim.Error) as raised:
        call({"bullet": bullet, "world": world, "study": study})
    assert "_core" not in str(raised.value) and "incompatible" not in str(raised.value)


def test_what_no_object_has_cannot_be_assigned(bullet, world, study):
    one = world[world.spawn(physim.Shot(**BALL))[0]]
    with pytest.raises(AttributeError):
        one.velocty = (0, 50, 0)
    for each in (bullet, physim.Scenario(shot={}), bullet.fly(), study, world.snapshot(), physim.Scene()):
        with pytest.raises(AttributeError):
            each.speed = 3
    for name in ("threads", "ground_mode", "time"):
        with pytest.raises(AttributeError):
            setattr(world, name, 2)
    world.mine = 3
    assert world.mine == 3


def test_ranges_of_a_table_are_those_of_files(bullet):
    by_text = bullet.table("100 yd .. 300 yd step 100 yd", units="customary")
    assert list(by_text["range [yd]"]) == pytest.approx([100, 200, 300])
    with pytest.raises(physim.Error) as raised:
        bullet.table("100 yd .. 300 yd stop 100 yd")
    assert raised.value.place == "ranges" and "until" not in str(raised.value)


def test_columns_that_the_fidelity_does_not_read_are_warnings(level):
    with pytest.warns(UserWarning, match="density has no effect.*isa"):
        level.batch(density=[1.0, 1.1])
    with pytest.warns(UserWarning, match="wind_x has no effect"):
        level.replace(fidelity="arcade").batch(wind_x=[1.0, 2.0])


def test_the_elevation_of_a_velocity_is_its_own():
    assert physim.fly(velocity=(30, 30, 0)).elevation == pytest.approx(math.pi / 4, rel=1e-15)


def test_a_note_of_an_effect_that_stays_names_it_once():
    notes = physim.fly(**{**BULLET, "environment_atmosphere_density": 1.0}).notes
    assert not any("isa instead of isa" in note for note in notes)

"""Batches: columns in and out, with the bits of single flights. Whatever cannot be read or written as it is, is an
error: nothing is converted behind the caller's back."""

from __future__ import annotations

import math
import pickle
import threading

import numpy as np
import pytest
from conftest import same_bits

import physim

N = 301  # no multiple of any pack of lanes


@pytest.fixture
def speeds():
    return np.random.default_rng(7).normal(800, 5, N)


@pytest.fixture
def elevations():
    return np.random.default_rng(8).normal(3e-3, 1e-4, N)


def test_a_batch_has_the_bits_of_single_flights(level, speeds, elevations):
    into = ("time", "x", "y", "z", "vx", "vy", "vz", "speed", "drop", "windage")
    batch = level.batch(speed=speeds, elevation=elevations, into=into)
    assert list(batch) == list(into) and batch.size == N and batch.refused == 0
    for i in range(0, N, 25):
        flight = level.fly(speed=float(speeds[i]), elevation=float(elevations[i]))
        end = flight.end
        assert batch.outcome[i] == flight.outcome
        for name in ("time", "speed", "drop", "windage", "x", "y", "z"):
            assert same_bits(batch[name][i], np.float64(getattr(end, name))), name
        assert same_bits([batch.vx[i], batch.vy[i], batch.vz[i]], end.velocity)


def test_zero_range_and_weather_per_shot(bullet):
    winds = np.linspace(-5, 5, 9)
    batch = bullet.batch(wind_z=winds, into=("windage", "drop"))
    for i in (0, 4, 8):
        end = bullet.fly(environment_wind_velocity=(0, 0, float(winds[i]))).end
        assert same_bits(batch.windage[i], np.float64(end.windage)) and same_bits(batch.drop[i], np.float64(end.drop))
    cold = bullet.batch(temperature=["-20 degC", "30 degC"][0], into=("drop",))
    assert same_bits(cold.drop[0], np.float64(bullet.fly(environment_atmosphere_temperature="-20 degC").end.drop))


@pytest.mark.parametrize("threads", [0, 1, 2, 3])
def test_threads_change_no_bit(level, speeds, threads):
    one = level.batch(speed=np.tile(speeds, 20), threads=1)
    many = level.batch(speed=np.tile(speeds, 20), threads=threads)
    for name in one:
        assert same_bits(one[name], many[name])


def test_many_threads_of_python_fly_batches_at_once(level, speeds):
    expected = level.batch(speed=speeds).time.tobytes()
    results = []
    threads = [
        threading.Thread(target=lambda: results.extend(level.batch(speed=speeds).time.tobytes() for _ in range(10)))
        for _ in range(4)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(results) == 40 and set(results) == {expected}


# ------------------------------------------------------------------------------------------------------------- inputs
def strided(values):
    wide = np.full((len(values), 3), 1e9)
    wide[:, 1] = values
    return wide[:, 1]


def backwards(values):
    return values[::-1].copy()[::-1]


def read_only(values):
    copy = values.copy()
    copy.flags.writeable = False
    return copy


def unaligned(values):
    raw = np.zeros(values.nbytes + 1, dtype=np.uint8)
    raw[1:] = np.frombuffer(values.tobytes(), dtype=np.uint8)
    return raw[1:].view(np.float64)


@pytest.mark.parametrize(
    "kind", [strided, backwards, read_only, unaligned, list, lambda v: v.astype(">f8")],
    ids=["strided", "backwards", "read-only", "unaligned", "list", "big-endian"],
)  # fmt: skip
def test_inputs_of_any_layout_are_read(level, speeds, kind):
    assert same_bits(level.batch(speed=kind(speeds)).time, level.batch(speed=speeds).time)


def test_inputs_of_other_numbers_are_read(level):
    whole = level.batch(speed=np.arange(800, 810))
    assert same_bits(whole.time, level.batch(speed=np.arange(800.0, 810.0)).time)
    single = np.linspace(800, 810, 11).astype(np.float32)
    assert same_bits(level.batch(speed=single).time, level.batch(speed=single.astype(np.float64)).time)
    alone = level.batch(speed=[800.0, 805.0], elevation="3 mrad")
    assert same_bits(alone.time, level.batch(speed=[800.0, 805.0]).time)
    pandas = pytest.importorskip("pandas")
    assert level.batch(speed=pandas.Series([800.0, 805.0])).size == 2


def test_a_quantity_of_pint_is_a_column(level):
    unit = pytest.importorskip("pint").UnitRegistry()
    batch = level.batch(speed=np.array([2600.0, 2700.0]) * unit.foot / unit.second)
    assert batch.time[1] == pytest.approx(level.batch(speed=[822.96]).time[0], rel=1e-12)
    with pytest.raises(Exception, match="convert"):
        level.batch(speed=np.array([1.0]) * unit.kilogram)


@pytest.mark.parametrize(
    ("columns", "words"),
    [
        ({"speed": np.array([1j])}, "complex128"),
        ({"speed": np.array([True])}, "bool"),
        ({"speed": np.array(["fast"])}, "type <U4"),
        ({"speed": np.array([object()])}, "object"),
        ({"speed": np.ones((2, 2))}, "shape"),
        ({"speed": np.array([800.0], dtype=np.longdouble)}, "float128"),
        ({"speed": [800.0, 801.0], "elevation": [0.0, 0.1, 0.2]}, "different lengths"),
        ({"sped": [800.0]}, "unknown column"),
        ({"speed": "800 kg"}, "is a mass"),
        ({"speed": [800.0], "wind_x": [1.0, 2.0]}, "different lengths"),
    ],
)
def test_bad_inputs_are_errors(level, columns, words):
    with pytest.raises(physim.Error) as raised:
        level.batch(**columns)
    assert words in str(raised.value)


def test_impossible_numbers_are_an_error_or_nan_as_wished(level):
    speeds = np.array([800.0, np.nan, 805.0, -1.0, np.inf])
    with pytest.raises(physim.Error) as raised:
        level.batch(speed=speeds)
    assert "speed" in str(raised.value)
    batch = level.batch(speed=speeds, errors="nan")
    assert batch.refused >= 2 and batch.error is not None
    assert list(np.isnan(batch.time)) == [outcome == "refused" for outcome in batch.outcome]
    assert not math.isnan(batch.time[0]) and not math.isnan(batch.time[2]) and math.isnan(batch.time[1])
    with pytest.raises(physim.Error, match="errors"):
        level.batch(speed=[800.0], errors="ignore")


def test_no_columns_are_no_shots(level):
    assert level.batch().size == 0
    assert level.batch(speed=[]).size == 0


# ------------------------------------------------------------------------------------------------------------ outputs
def outputs(kind):
    """An array of N numbers of some kind, and the memory that it is a part of."""
    if kind == "plain":
        whole = np.full(N, -7.0)
        return whole, whole
    if kind == "strided":
        whole = np.full((N, 3), -7.0)
        return whole[:, 1], whole
    if kind == "backwards":
        whole = np.full(N, -7.0)
        return whole[::-1], whole
    if kind == "float32":
        whole = np.full(N, -7.0, dtype=np.float32)
        return whole, whole
    if kind == "float32 strided":
        whole = np.full((2, N), -7.0, dtype=np.float32).T
        return whole[:, 1], whole
    whole = np.zeros(N, dtype=[("tag", "i8"), ("time", "f8")])  # a field of records
    return whole["time"], whole


@pytest.mark.parametrize("kind", ["plain", "strided", "backwards", "float32", "float32 strided", "record"])
def test_outputs_are_the_callers_own_memory(level, speeds, kind):
    array, whole = outputs(kind)
    expected = level.batch(speed=speeds).time
    batch = level.batch(speed=speeds, into={"time": array})
    assert np.shares_memory(batch.time, whole)
    assert same_bits(array, expected.astype(array.dtype))
    if kind == "strided":
        assert (whole[:, 0] == -7).all() and (whole[:, 2] == -7).all()
    if kind == "float32 strided":
        assert (whole[:, 0] == -7).all()


def refused_outputs():
    frozen = np.empty(N)
    frozen.flags.writeable = False
    yield "read-only", frozen
    yield "broadcast", np.broadcast_to(np.empty(1), N)
    yield "int64", np.empty(N, dtype=np.int64)
    yield "float16", np.empty(N, dtype=np.float16)
    yield "longdouble", np.empty(N, dtype=np.longdouble)
    yield "complex", np.empty(N, dtype=np.complex128)
    yield "object", np.empty(N, dtype=object)
    yield "bool", np.empty(N, dtype=bool)
    yield "big-endian", np.empty(N, dtype=">f8")
    yield "list", [0.0] * N
    yield "none", None
    yield "short", np.empty(N - 1)
    yield "long", np.empty(N + 1)
    yield "rows", np.empty((N, 1))
    yield "flat", np.empty(())
    yield "on each other", np.lib.stride_tricks.as_strided(np.zeros(1), (N,), (0,))


@pytest.mark.parametrize(("what", "array"), list(refused_outputs()), ids=[what for what, _ in refused_outputs()])
def test_outputs_that_cannot_be_written_are_errors(level, speeds, what, array):
    before = array.copy() if isinstance(array, np.ndarray) and array.dtype != object else None
    with pytest.raises(physim.Error) as raised:
        level.batch(speed=speeds, into={"time": array})
    assert raised.value.place == "time" and raised.value.message
    if before is not None:
        assert before.tobytes() == array.tobytes()


def test_outputs_lie_apart(level, speeds):
    both = np.empty(N)
    with pytest.raises(physim.Error, match="shares memory"):
        level.batch(speed=speeds, into={"time": both, "x": both})
    with pytest.raises(physim.Error, match="shares memory"):
        level.batch(speed=speeds, into={"time": speeds})
    table = np.empty((N, 2))
    batch = level.batch(speed=speeds, into={"time": table[:, 0], "x": table[:, 1]})
    assert same_bits(table[:, 0], batch.time)
    with pytest.raises(physim.Error, match="unknown column"):
        level.batch(speed=speeds, into=("height",))


def test_large_columns_are_neither_copied_nor_kept(level):
    import sys

    speeds, out = np.full(2000, 800.0), np.empty(2000)
    counts = sys.getrefcount(speeds), sys.getrefcount(out)
    for _ in range(20):
        level.batch(speed=speeds, into={"time": out})
    assert (sys.getrefcount(speeds), sys.getrefcount(out)) == counts


def test_batches_are_columns(level, speeds):
    batch = level.batch(speed=speeds)
    assert batch[batch.time > np.median(batch.time)].size == N // 2
    copy = pickle.loads(pickle.dumps(batch))
    assert same_bits(copy.time, batch.time) and copy.outcome[0] == batch.outcome[0]
    assert "<table>" in batch._repr_html_() and "time [s]" in repr(batch) and batch.kernel in physim.kernels()


def test_kernels_change_no_bit(level, speeds):
    try:
        times = {}
        for kernel in physim.kernels():
            assert physim.use_kernel(kernel)
            times[kernel] = level.batch(speed=speeds).time.tobytes()
        assert len(set(times.values())) == 1
        assert not physim.use_kernel("abacus")
    finally:
        physim.use_kernel("")


def test_functions_of_place_are_called_by_batches(level):
    seen = []

    def wind(time, position):
        seen.append(len(time))
        return np.tile([0.0, 0.0, 3.0], (len(time), 1))

    windy = level.replace(wind_field=wind, fidelity_rotation="none")
    batch = windy.batch(speed=np.full(50, 800.0), into=("windage",), threads=2)
    assert same_bits(batch.windage[0], np.float64(windy.fly(speed=800).end.windage))
    assert max(seen) > 1  # all lanes of a pack at once

    def broken(time, position):
        raise RuntimeError("a hole in the air")

    with pytest.raises(RuntimeError, match="hole"):
        level.replace(wind_field=broken).batch(speed=np.full(50, 800.0), threads=2)


def test_masked_numbers_are_not_flown(level):
    assert len(level.batch(speed=np.ma.array([800.0, 810.0])).speed) == 2
    with pytest.raises(physim.Error, match="masked"):
        level.batch(speed=np.ma.array([800.0, 810.0], mask=[False, True]))


def test_a_wind_field_that_raises_is_called_no_more(level):
    calls = []

    def wind(time, position):
        calls.append(len(time))
        raise LookupError("no wind here")

    shot = level.replace(wind_field=wind)
    for expected in (1, 2):  # and again in the next call
        with pytest.raises(LookupError, match="no wind here"):
            shot.batch(speed=np.full(1000, 800.0), threads=1)
        assert len(calls) == expected

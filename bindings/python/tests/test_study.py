"""Studies: with the bits of the command line, on threads and on executors of processes."""

from __future__ import annotations

import json
import multiprocessing
import os
import pickle
import signal
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool

import numpy as np
import pytest
from conftest import SCENARIOS, run_program, same_bits

import physim
from physim import _core

SHOTS = 30_000


@pytest.fixture
def study(level):
    drop = level.fly(until_range=600).end.drop
    return level.study(
        inputs={"speed": "+- 3 m/s", "elevation": "+- 0.14 mrad", "environment_wind_velocity.z": "0 m/s +- 1 m/s"},
        targets={"plate": f"rectangle 45 cm x 75 cm at 0 m, {drop} m", "disc": f"circle 15 cm at 0 m, {drop} m"},
        range=600,
        shots=SHOTS,
    )


def figures(result):
    return result.figures["value"].tobytes() + result.figures["error"].tobytes()


def test_a_study_has_the_bits_of_the_command_line(tmp_path):
    part = tmp_path / "part"
    run_program("study", "scenarios/study_308.toml", "--shots", str(SHOTS), "--resume", str(part), "--csv", str(tmp_path / "a.csv"))
    study = physim.Scenario.from_file(SCENARIOS / "study_308.toml").study(shots=SHOTS)
    result = study.run()
    rows = [line.split(",") for line in (tmp_path / "a.csv").read_text().splitlines()[1:]]
    values = {row[0]: row[1] for row in rows if len(row) > 1}
    ours = dict(zip(result.figures["figure"].tolist(), result.figures["value"].tolist()))
    shared = [name for name in ours if values.get(name)]
    assert len(shared) > 30
    for name in shared:
        assert float(values[name]) == ours[name], name


def test_results(study):
    result = study.run()
    assert result.shots >= SHOTS and study.shards * 4096 == result.shots
    assert 0 < result.hits["disc"].probability[0] < result.hits["plate"].probability[0] < 1
    plate = result.hits["plate"]
    assert plate.low < plate.probability[0] < plate.high
    assert result.from_aim.r50 < result.from_aim.r95 and result.ellipse.long_axis > result.ellipse.short_axis
    assert set(result.quantities) == {"right", "up", "time", "speed"}
    assert result.quantities["speed"].deviation > 0 and len(result.quantities["up"].histogram) > 10
    assert result.covariance.shape == (4, 4) and len(result.stages) > 1 and result.spreads[0]["size"] == 3
    assert "plate" in repr(result) and "<table>" in result._repr_html_()
    samples = study.samples(0)
    assert samples.size == 4096 and samples["hits plate"].dtype == bool
    assert samples["right"].std() == pytest.approx(result.quantities["right"].deviation, rel=0.05)
    assert len(study.linear().rows) == 3


def test_distributions_in_the_place_of_numbers(level):
    in_place = level.replace(speed="822.96 m/s +- 3 m/s").study(range=600, shots=8000)
    apart = level.study(inputs=["shot.speed = 822.96 m/s +- 3 m/s"], range=600, shots=8000)
    assert in_place.inputs == apart.inputs
    assert figures(in_place.run()) == figures(apart.run())
    both = level.replace(speed="822.96 m/s +- 3 m/s").study(inputs={"azimuth": "+- 1 mrad"}, range=600, shots=8000)
    assert len(both.inputs) == 2


def test_threads_and_executors_give_equal_bits(study):
    expected = figures(study.run(threads=1))
    assert figures(fresh(study).run(threads=3)) == expected
    with ThreadPoolExecutor(3) as executor:
        assert figures(fresh(study).run(executor)) == expected
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as executor:
        assert figures(fresh(study).run(executor, shards_per_task=2)) == expected
    parts = [study.fly_shards(i) for i in reversed(range(study.shards))]
    assert figures(fresh(study).merge(parts)) == expected


def fresh(study):
    copy = pickle.loads(pickle.dumps(study))
    copy.so_far = b""
    return copy


def test_dask_gives_equal_bits(study):
    """Each task has the numbers of its shards, so that none of them is taken for another."""
    distributed = pytest.importorskip("distributed")
    expected = figures(study.run(threads=1))
    study.so_far = b""
    options = {"n_workers": 2, "threads_per_worker": 1, "host": "127.0.0.1", "dashboard_address": None}
    with distributed.LocalCluster(**options) as cluster, distributed.Client(cluster) as client:
        assert figures(study.run(client.get_executor(pure=False), shards_per_task=1)) == expected


def test_ray_gives_equal_bits_though_a_worker_is_killed(study):
    ray = pytest.importorskip("ray")
    expected = figures(study.run(threads=1))
    study.so_far = b""
    killed = []

    def kill_one(done, total):
        workers = [] if killed else ray_workers()
        for worker in workers[:1]:
            killed.append(worker)
            os.kill(worker, signal.SIGKILL)

    options = {"include_dashboard": False, "object_store_memory": 100 << 20, "_node_ip_address": "127.0.0.1"}
    ray.init(num_cpus=2, log_to_driver=False, configure_logging=False, **options)
    try:
        with physim.RayExecutor() as executor:
            assert executor.submit(divmod, 7, 2).result() == (3, 1)
            assert isinstance(executor.submit(divmod, 7, 0).exception(), ZeroDivisionError)
            assert figures(study.run(executor, progress=kill_one, shards_per_task=1)) == expected
        with pytest.raises(RuntimeError):
            executor.submit(divmod, 7, 2)
    finally:
        ray.shutdown()
    assert killed


def ray_workers():
    """Processes of Ray that this one started and that have a task."""
    found = []
    for pid in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{pid}/cmdline", "rb") as file:
                line = file.read()
            if line.startswith(b"ray::_called") and os.getpid() in ancestors(int(pid)):
                found.append(int(pid))
        except OSError:  # it is gone
            continue
    return found


def ancestors(pid):
    while pid > 1:
        with open(f"/proc/{pid}/stat", encoding="ascii", errors="replace") as file:
            pid = int(file.read().rpartition(")")[2].split()[1])
        yield pid


def test_a_child_of_fork_flies(study, level):
    """Threads of the parent are not there in a child that fork() made."""
    expected = level.batch(speed=np.full(5000, 800.0), threads=2).time[0]
    assert study.run(threads=2).shots
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("fork")) as executor:
        assert executor.submit(fly_in_child, level).result(timeout=60) == expected


def fly_in_child(shot):
    return shot.batch(speed=np.full(5000, 800.0), threads=2).time[0]


def end_worker():
    os.kill(os.getpid(), signal.SIGKILL)


class WithAKiller(ProcessPoolExecutor):
    """One of its workers is killed while it works, not while it sends a result: the pool would wait for the rest of it."""

    tasks = 0

    def submit(self, fn, /, *args, **kwargs):
        self.tasks += 1
        return super().submit(end_worker) if self.tasks == 6 else super().submit(fn, *args, **kwargs)


def test_a_killed_worker_loses_only_its_own_shards(study):
    expected = figures(study.run())
    study.so_far = b""
    with WithAKiller(2, mp_context=multiprocessing.get_context("spawn")) as executor, pytest.raises(BrokenProcessPool):
        study.run(executor)
    kept = _core.shards_in(study.so_far)
    assert 0 < kept < study.shards
    assert figures(study.run()) == expected


def test_progress_stops_and_goes_on(study):
    seen = []
    study.run(threads=1, progress=lambda done, total: seen.append((done, total)) or done < 3)
    assert seen[-1] == (3, study.shards)
    partial = study.run(threads=1, progress=lambda done, total: False)
    assert partial.shots == 4 * 4096
    assert figures(study.run()) == figures(fresh(study).run())

    def broken(done, total):
        raise KeyError("no more")

    with pytest.raises(KeyError):
        fresh(study).run(progress=broken)


def test_until_a_time(study):
    result = study.run(threads=1, seconds=1e-9)
    assert result.time_was_up and 0 < result.shots < study.shards * 4096
    assert figures(study.run(threads=1)) == figures(fresh(study).run(threads=1))
    for bad in (0, -1, float("nan")):
        with pytest.raises(physim.Error):
            study.run(seconds=bad)


def test_until_width(level):
    study = level.study(inputs={"speed": "+- 3 m/s", "elevation": "+- 0.2 mrad"}, targets=["rectangle 45 cm x 75 cm at 0 m, -1 m"],
                        range=600, shots=400_000, until_width=0.03)  # fmt: skip
    result = study.run()
    assert result.width_reached and result.shots < 400_000
    with ThreadPoolExecutor(1) as executor, pytest.raises(physim.Error, match="width"):
        study.run(executor)


def test_places_on_the_way(level):
    result = level.study(inputs={"speed": "+- 3 m/s"}, range=600, at=["300 m", "apex"], shots=8000).run()
    assert len(result.at) == 2 and result.at[0].quantities["up"].deviation < result.quantities["up"].deviation


def test_bad_studies_are_errors(level, study):
    for options in (
        {"inputs": {"speeed": "+- 3 m/s"}},
        {"inputs": {"speed": "+- 3 kg"}},
        {"inputs": ["shot.name = 1 .. 2"]},
        {"targets": {"plate": "hexagon 3 m"}},
        {"shots": -1},
        {"sampling": "halton"},
        {"shotz": 3},
    ):
        with pytest.raises(physim.Error):
            level.study(**{"range": 600, "inputs": {"speed": "+- 3 m/s"}, **options})
    for part in (b"x", study.fly_shards(0)[:-3], b"\0" * 500):
        with pytest.raises(physim.Error):
            study.merge([part])
    other = level.study(inputs={"speed": "+- 4 m/s"}, range=600, shots=SHOTS)
    with pytest.raises(physim.Error):
        other.merge([other.fly_shards(0), study.fly_shards(1)])


def test_every_uncertain_number_is_listed():
    paths = physim.study_paths()
    assert "shot.speed" in paths.path and paths.size > 50


def test_study_frame(study):
    pytest.importorskip("pandas")
    frame = study.run().to_frame()
    assert frame.loc["shots", "value"] >= SHOTS


def test_aim_fit_and_other_questions(level):
    answer = level.replace(sight_height=0).aim((400, 5, 2))
    assert answer and answer.low.miss <= 0.01 and "hit" in answer.explanation
    flight = answer.low.fly()
    closest = flight.at_time(answer.low.time).position - [400, 5, 2]
    assert np.linalg.norm(closest) < 0.02
    assert not level.aim((400_000, 0, 0)) and level.aim((400_000, 0, 0)).nearest.miss > 1000
    moving = level.aim((300, 0, 0), velocity=(0, 0, 20), arc="low")
    assert moving.low.azimuth > 0 and moving.high is None
    with pytest.raises(physim.Error):
        level.aim((1, 2))
    with pytest.raises(physim.Error, match="arc"):
        level.aim((1, 2, 3), arc="flat")

    truth = level.replace(drag_ballistic_coefficient="0.2 lb/in^2")
    ranges = np.array([200.0, 400.0, 600.0])
    measured = truth.fly().at_ranges(ranges)
    fit = level.fit(ranges, speed=measured.speed)
    assert fit.scale == pytest.approx(0.218 / 0.2, rel=1e-4)
    assert fit.shot.fly().at_range(600).speed == pytest.approx(measured.speed[2], abs=0.05)
    assert fit.residuals.size == 3
    with pytest.raises(physim.Error):
        level.fit(ranges)
    with pytest.raises(physim.Error, match="expected 3"):
        level.fit(ranges, speed=[1.0])

    mortar = physim.Shot(mass=4, diameter=0.081, speed=100, fidelity="small_arms", drag_coefficient=0.2)
    far = mortar.max_range()
    assert 0.7 < far.elevation < 0.8 and far.range > 500
    assert level.time_to_range(600) == pytest.approx(level.fly().at_range(600).time)
    assert level.zero_elevation("100 m") > 0 and level.stability_factor() > 1
    cheap = mortar.replace(elevation=0.7).cheapest_within(0.5)
    assert cheap.error <= 0.5 and "cheap" in cheap.explanation


def test_compare(level):
    found = level.compare(["arcade", "small_arms"])
    assert list(found.flights) == ["arcade", "small_arms"] and found.table.end_distance[1] < found.table.end_distance[0]
    assert json.loads(json.dumps(found.table.rows().__next__(), default=str))["fidelity"] == "arcade"
    with pytest.raises(physim.Error, match="unknown fidelity"):
        level.compare(["exact"])
    assert same_bits(found.reference.end.position, level.compare([]).reference.end.position)

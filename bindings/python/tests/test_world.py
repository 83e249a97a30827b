"""Worlds: with the bits of the command line, changed and read in bulk, and an error for every misuse."""

from __future__ import annotations

import gc
import pickle
import threading
import time
import weakref

import numpy as np
import pytest
from conftest import SCENARIOS, run_program, same_bits
from numpy.lib.stride_tricks import as_strided

import physim

BALL = {"mass": 0.5, "diameter": 0.1, "fidelity": "game", "speed": 20, "elevation": "45 deg"}


@pytest.fixture
def ball():
    return physim.Shot(**BALL)


@pytest.fixture
def world():
    return physim.World(step=1 / 120, ground_mode="bounce")


@pytest.mark.parametrize("name", ["emit_machine_gun", "house_of_wood", "joint_pendulums", "world_force_field"])
def test_a_run_has_the_bits_of_the_command_line(tmp_path, name):
    """A scene, emitters with sub-emitters, joints and forces: what the run saves is equal byte for byte."""
    saved = tmp_path / "run.save"
    run_program("run", f"scenarios/{name}.toml", "--steps", "150", "--save", str(saved))
    world = physim.Scenario.from_file(SCENARIOS / f"{name}.toml").world()
    world.step(150)
    again = physim.Scenario.from_file(SCENARIOS / f"{name}.toml", []).world()
    for _ in range(150):
        again.step()
    assert world.hash() == again.hash()
    assert world_of(world.save()) == world_of(saved.read_bytes())
    loaded = physim.World.load(world.save(), physim.Scenario.from_file(SCENARIOS / f"{name}.toml"))
    loaded.step(20), again.step(20)
    assert loaded.hash() == again.hash()


def world_of(save: bytes) -> bytes:
    """The save of the world inside that of a run: the run's own part hashes the paths of files."""
    return save[save.index(b"PHYSIMS\n") :]


def test_spawn_step_and_reads(world, ball):
    ids = world.spawn(ball, speed=np.linspace(10, 30, 50), z=np.arange(50.0))
    assert ids.dtype == np.uint64 and len(world) == 50 and len(set(ids.tolist())) == 50
    assert set(world.call_events.kind) == {"spawned"}
    events = world.step(30)
    assert world.time == pytest.approx(0.25) and events.size == 0
    positions, velocities = world.positions(), world.velocities()
    assert positions.shape == velocities.shape == (50, 3)
    for i in (0, 17, 49):
        one = world[ids[i]]
        assert same_bits(one.position, positions[i]) and same_bits(one.velocity, velocities[i])
        assert one.alive and one.status == "in_flight" and one.age == pytest.approx(0.25)
    assert same_bits(world.positions(ids[[3, 1]]), positions[[3, 1]])
    state = world.state()
    assert same_bits(state.id, world.ids) and same_bits(state.position, positions)
    while not (events := world.step()).size:
        pass
    assert events.kind[0] == "bounced" and events.position.shape == (events.size, 3)
    assert world.despawn(ids[:10]) == 10 and len(world) == 40
    assert not world[ids[0]].alive and world.despawn() == 40


def test_one_by_one_and_in_bulk_are_the_same(ball):
    bulk, single = physim.World(), physim.World()
    bulk.spawn(ball, speed=[10.0, 20.0, 30.0])
    for speed in (10.0, 20.0, 30.0):
        single.spawn(ball.replace(speed=speed))
    bulk.step(100), single.step(100)
    assert same_bits(bulk.positions(), single.positions())


def test_a_world_has_the_bits_of_predict_and_of_threads(ball):
    worlds = [physim.World(threads=threads, rows_per_thread=16) for threads in (1, 2, 4)]
    for world in worlds:
        world.spawn(ball, speed=np.linspace(10, 40, 500))
    flight = worlds[0][worlds[0].ids[7]].predict(1.0)
    for world in worlds:
        world.step(60)
    assert len({world.hash() for world in worlds}) == 1
    assert same_bits(flight.at_time(1.0).position, worlds[0].positions()[7])


# ------------------------------------------------------------------------------------------------------------ outputs
@pytest.mark.parametrize("kind", ["plain", "float32", "strided", "transposed", "backwards", "more rows"])
def test_reads_into_the_callers_memory(world, ball, kind):
    world.spawn(ball, speed=np.linspace(10, 30, 20))
    world.step(10)
    expected = world.positions()
    whole = {
        "plain": np.full((20, 3), -1.0), "float32": np.full((20, 3), -1.0, dtype=np.float32),
        "strided": np.full((20, 8), -1.0)[:, 1:7:2], "transposed": np.full((3, 20), -1.0).T,
        "backwards": np.full((20, 3), -1.0)[::-1], "more rows": np.full((25, 3), -1.0),
    }[kind]  # fmt: skip
    assert world.positions(out=whole) is whole
    assert same_bits(whole[:20], expected.astype(whole.dtype)) and (whole[20:] == -1).all()


@pytest.mark.parametrize(
    "out", [np.empty((5, 3), dtype=np.int64), np.empty((5, 3), dtype=">f8"), np.empty((5, 2)), np.empty(15),
            np.empty((4, 3)), [[0.0] * 3] * 5, np.broadcast_to(np.empty(3), (5, 3)), np.empty((5, 3), dtype=complex),
            *(as_strided(np.zeros(20), (5, 3), strides) for strides in ((0, 8), (8, 8), (16, 8), (24, 0)))],
    ids=["int", "big-endian", "columns", "flat", "short", "list", "read-only", "complex", "one row", "rows on each other",
         "ends on beginnings", "one number"],
)  # fmt: skip
def test_reads_into_what_cannot_be_written_are_errors(world, ball, out):
    world.spawn(ball, 5)
    with pytest.raises(physim.Error) as raised:
        world.positions(out=out)
    assert raised.value.place == "out"


@pytest.mark.parametrize("what", ["complex", "masked"])
def test_forces_are_real_numbers(world, ball, what):
    zero = np.zeros((5, 3), dtype=complex) if what == "complex" else np.ma.array(np.zeros((5, 3)), mask=np.eye(5, 3))
    world.spawn(ball, 5)
    world.add_force(lambda time, ids, position, velocity, mass: zero)
    with pytest.raises(ValueError, match=what):
        world.step()


def test_bad_input_is_an_error(world, ball):
    for ids in ([-1], [1.5], [[1, 2]], ["a"]):
        with pytest.raises(physim.Error):
            world.positions(ids)
    assert (world.positions([2**40 + 99, 0]) == 0).all()  # ids of nothing: the library says zero
    for columns in ({"speed": [np.nan]}, {"speed": [1j]}, {"vx": [1.0]}, {"speed": [1.0, 2.0], "x": [1.0]}):
        with pytest.raises(physim.Error):
            world.spawn(ball, **columns)
    assert len(world) == 0
    with pytest.raises(physim.Error):
        world.spawn(ball, -1)
    with pytest.raises(physim.Error):
        world.step(-1)
    for dt in (-1.0, float("nan"), 0.0, 1e9):
        with pytest.raises(physim.Error):
            world.step(dt=dt)
    with pytest.raises(physim.Error, match="ground"):
        physim.World(ground_mode="lava")
    with pytest.raises(physim.Error, match="did you mean"):
        physim.World(ground_mod="bounce")
    assert list(world.spawn(ball, speed=[20.0, np.nan], errors="null") != 0) == [True, False]
    gone = world.spawn(ball)[0]
    world.despawn([gone])
    with pytest.raises(physim.Error):
        world[gone].velocity = (1, 2, 3)
    with pytest.raises(physim.Error):
        world[gone].set(mass=1)
    other = physim.World()
    with pytest.raises(physim.Error):
        other.restore(world.snapshot())
    for save in (b"", b"nonsense" * 100, world.save()[:-9], world.save()[:40] + b"x" + world.save()[41:]):
        with pytest.raises(physim.Error):
            physim.World.load(save)


def test_one_projectile_is_changed_in_flight(world, ball):
    id = world.spawn(ball)[0]
    one = world[id]
    one.position, one.velocity = (1, 50, 3), (0, 0, 7)
    one.push((0.5, 0, 0))
    assert list(one.position) == [1, 50, 3] and list(one.velocity) == [1, 0, 7]
    before = one.acceleration
    assert list(one.force) == list(before * one.as_dict()["mass"])
    jerk = one.jerk  # of a drag that changes with the velocity, within a step
    assert jerk.shape == (3,) and np.all(np.isfinite(jerk))
    one.label, one.user_data = "red", 42
    assert one.label == "red" and one.user_data == 42
    one.set(mass="2 kg", body_can_sleep=False, body_gravity_scale=0)
    assert one.as_dict()["mass"] == 2
    world.step(60)
    assert one.position[1] == pytest.approx(50, abs=1e-3)  # no gravity
    one.set(fidelity="small_arms")
    with pytest.raises(physim.Error):
        one.set(mass=-1)
    with pytest.raises(physim.Error):
        one.set(length=2)  # not live
    with pytest.raises(physim.Error, match="no setting of a projectile"):
        one.set(environment_altitude=100)
    one.despawn()
    assert not one.alive and "retired" in repr(one)


# ------------------------------------------------------------------------------------------- forces, joints, functions
def test_forces_by_law_and_by_function_agree(ball):
    by_law, by_function = physim.World(), physim.World()
    for world in (by_law, by_function):
        world.spawn(ball.replace(fidelity_drag="off"), speed=[10.0, 12.0, 14.0])
    lift = by_law.add_force(constant_force={"force": (0, 2, 1)})
    calls = []

    def function(time, ids, position, velocity, mass):
        calls.append(len(ids))
        assert position.shape == velocity.shape == (len(ids), 3) and mass.shape == (len(ids),)
        return np.tile([0.0, 2.0, 1.0], (len(ids), 1))

    by_function.add_force(function)
    by_law.step(30), by_function.step(30)
    assert same_bits(by_law.positions(), by_function.positions())
    assert set(calls) == {3} and len(calls) <= 30 * 4
    assert by_law.felt_by(lift) == 3
    by_law.remove_force(lift)
    assert by_law.felt_by(lift) == 0
    with pytest.raises(physim.Error):
        by_law.remove_force(lift)
    with pytest.raises(physim.Error):
        by_law.add_force()
    with pytest.raises(physim.Error, match="did you mean"):
        by_law.add_force(constant_forc={"force": (0, 1, 0)})


@pytest.mark.parametrize("error", [KeyError("gone"), ZeroDivisionError(), physim.Error("own", "place", "hint")])
def test_what_a_function_raises_comes_out_of_step(ball, error):
    world = physim.World()
    world.spawn(ball, 3)
    steps = []

    def broken(time, ids, position, velocity, mass):
        steps.append(time)
        if len(steps) > 3:
            raise error
        return np.zeros_like(position)

    force = world.add_force(broken)
    with pytest.raises(type(error)) as raised:
        world.step(100)
    assert raised.value is error and world.time < 0.1
    world.remove_force(force)
    world.step(10)


def test_functions_of_a_wrong_shape_are_errors(ball):
    for answer in (np.zeros(3), np.zeros((2, 3)), np.zeros((1, 2)), None, "wind", [[0, 0, 1j]]):
        world = physim.World()
        world.spawn(ball)
        world.add_force(lambda *_, answer=answer: answer)
        with pytest.raises((ValueError, TypeError)):
            world.step()


def test_a_world_cannot_be_changed_inside_its_step(ball):
    world = physim.World()
    world.spawn(ball, 2)
    seen = []

    def meddler(time, ids, position, velocity, mass):
        seen.append((len(world), world.time, world.positions().shape))
        for change in (lambda: world.spawn(ball), world.step, world.close, lambda: world.advance(1.0)):
            with pytest.raises(physim.Error):
                change()
        return np.zeros_like(position)

    world.add_force(meddler)
    world.step()
    assert seen and seen[0] == (2, 0.0, (2, 3)) and len(world) == 2


def test_another_thread_is_told_that_the_world_steps(ball):
    world = physim.World()
    world.spawn(ball)
    inside, go_on = threading.Event(), threading.Event()

    def waits(time, ids, position, velocity, mass):
        inside.set()
        go_on.wait(10)
        return np.zeros_like(position)

    world.add_force(waits)
    thread = threading.Thread(target=world.step)
    thread.start()
    assert inside.wait(10)
    for use in (world.step, world.positions, world.close, world.hash, lambda: world.spawn(ball), world.save):
        with pytest.raises(physim.Error, match="another thread"):
            use()
    go_on.set()
    thread.join()
    assert len(world.positions()) == 1


def test_other_threads_run_while_it_steps():
    world = physim.World(threads=1)
    world.spawn(physim.Shot(**{**BALL, "fidelity": "small_arms"}), speed=np.linspace(10, 40, 20_000))
    counted, done = 0, threading.Event()

    def count():
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(0)

    thread = threading.Thread(target=count)
    thread.start()
    before = counted
    world.step(30)
    after = counted
    done.set()
    thread.join()
    assert after - before > 5


def test_wind_as_a_function(ball):
    def wind(time, position):
        return np.tile([0.0, 0.0, 6.0], (len(time), 1))

    shot = ball.replace(fidelity="small_arms")
    blown, calm, steady = physim.World(wind_field=wind), physim.World(), physim.World(environment_wind_velocity=(0, 0, 6))
    for world in (blown, calm, steady):
        world.spawn(shot)
        world.step(60)
    assert blown.positions()[0, 2] > calm.positions()[0, 2]
    assert np.allclose(blown.positions(), steady.positions(), rtol=0, atol=1e-6)


def test_joints(ball):
    world = physim.World()
    a, b = world.spawn(ball.replace(speed=0, position=(0, 10, 0))), world.spawn(ball.replace(speed=0, position=(1, 10, 0)))
    rod = world.add_joint(a[0], kind="rod", point=(0, 12, 0))
    world.add_joint(a[0], b[0], kind="cable", length="1.5 m")
    world.step(60)
    length, tension, taut = world.joint_state(rod)
    assert length == pytest.approx(2, abs=1e-3) and tension > 0 and taut
    assert np.linalg.norm(np.diff(world.positions(), axis=0)) < 1.5 + 1e-3
    world.remove_joint(rod)
    with pytest.raises(physim.Error):
        world.remove_joint(rod)
    with pytest.raises(physim.Error):
        world.move_joint(rod, (0, 0, 0))
    hinge = world.add_joint(a[0], kind="hinge", point=(0, 12, 0), axis=(0, 0, 1), high_angle="90 deg", break_force="1 kN")
    before, _, _ = world.joint_motion(hinge)
    world.move_joint(hinge, (0, 12, 0), (1, 0, 0))
    world.step(6)
    angle, way, force = world.joint_motion(hinge)
    assert before == pytest.approx(0, abs=1e-9) and angle != 0 and way == 0 and 0 < force < 1000
    with pytest.raises(physim.Error, match="thing"):
        world.add_joint(b[0], thing=77)
    with pytest.raises(physim.Error):
        world.add_joint(a[0], a[0])
    with pytest.raises(physim.Error, match="kind"):
        world.add_joint(a[0], b[0], kind="rubber")


# ------------------------------------------------------------------------------------------------- scenes and emitters
WALL = {
    "shape": [{"name": "slab", "box": {"half": [0.2, 3, 5]}}],
    "thing": [{"name": "wall", "shape": "slab", "position": [30, 2, 0]}],
}


def test_things_are_hit(ball):
    world = physim.World(**WALL)
    world.spawn(ball.replace(elevation=0, position=(0, 2, 0), speed=60, body_collision_on_hit="stop"), z=[0.0, 50.0])
    events = world.step(60)
    hits = events[events.kind == "hit"]
    assert hits.size == 1 and hits.instance[0] == world.things["wall"]
    assert hits.position[0, 0] == pytest.approx(29.8, abs=1e-6)
    world.move_thing("wall", (30, 2, 50))
    with pytest.raises(physim.Error):
        physim.World(shape=WALL["shape"], thing=[{"name": "wall", "shape": "slap"}])
    world.set_scene()
    with pytest.raises(physim.Error):
        world.move_thing(12345, (0, 0, 0))


def test_queries_see_projectiles(ball):
    world = physim.World(**WALL)
    shot = ball.replace(elevation=0, speed=0, body_collision_radius=0.5)
    ids = world.spawn(shot, x=[0.0, 3.0, 9.0], y=[2.0, 2.0, 2.0])
    assert list(world.in_ball((0, 2, 0), 2.6)) == [ids[0], ids[1]]
    assert list(world.in_ball((0, 2, 0), 2.6, layers=2)) == []
    assert list(world.in_box((9, 2, 0), (0.1, 0.1, 0.1))) == [ids[2]]
    hits = world.cast((-5, 2, 0), (5, 2, 0))
    assert list(hits.id) == [ids[0], ids[1]]
    assert hits.part[0] == pytest.approx(0.45) and hits.normal[0] == pytest.approx([-1, 0, 0])
    with pytest.raises(physim.Error, match="radius"):
        world.in_ball((0, 0, 0), -1)


def test_a_belt_carries(ball):
    slab = {"name": "slab", "box": {"half": [50, 0.5, 5]}}
    belt = {"name": "belt", "shape": "slab", "position": [0, -0.5, 0]}
    world = physim.World(ground_mode="none", shape=[slab], thing=[belt])  # or it would rest on the ground, not on the belt
    parcel = ball.replace(elevation=0, speed=0, position=(0, 0, 0), body_collision_on_hit="bounce")
    (id,) = world.spawn(parcel.replace(body_restitution=0, body_rolling_resistance=0))
    world.set_conveyor("belt", (2, 0, 0))
    world.step(180)
    assert world[id].velocity[0] == pytest.approx(2, abs=1e-3)
    with pytest.raises(physim.Error, match="1e6"):
        world.set_conveyor("belt", (2e6, 0, 0))


def test_a_function_decides_hits(ball):
    world = physim.World(**WALL)
    asked = []

    def decide(hits):
        asked.append(hits)
        return ["bounce" if z < 1 else "pass" for z in hits.position[:, 2]]

    world.on_hit(decide)
    shot = ball.replace(elevation=0, position=(0, 2, 0), speed=60)
    ids = world.spawn(shot, z=[0.0, 2.0], asks=True)
    events = world.step(35)
    assert sum(each.size for each in asked) == 2 and asked[0].energy[0] > 0
    assert {"bounced", "penetrated"} <= set(events.kind)
    assert world[ids[0]].velocity[0] < 0 < world[ids[1]].velocity[0]

    for answer in (lambda hits: "explode", lambda hits: ["stop"], lambda hits: None):
        bad = physim.World(**WALL)
        bad.on_hit(answer)
        bad.spawn(shot, z=[0.0, 2.0], asks=True)
        with pytest.raises((ValueError, TypeError)):
            bad.step(60)
    with pytest.raises(physim.Error):
        world.on_hit(3)
    with pytest.raises(physim.Error):
        physim.World(**WALL).spawn(shot, asks=True)  # without a function that answers


def test_emitters_and_what_they_fire(ball):
    world = physim.World(**WALL)
    spark = physim.Shot(mass=1e-5, diameter=1e-3, fidelity="game")
    sparks = world.add_emitter(spark, name="sparks", cycle__plays=False, start__lifetime=[0.2, 0.5], start__speed=[5, 20],
                               **{"from__shape": "sphere", "from__radius": 0})  # fmt: skip
    bullet = ball.replace(body_collision_on_hit="stop")
    gun = world.add_emitter(
        bullet, name="gun", position=(0, 2, 0), per_second=0,
        gun={"rounds_per_minute": 600}, start={"speed": 300, "lifetime": 5},
        sub=[{"on": "hit", "emitter": "sparks", "count": 5}],
    )  # fmt: skip
    world.step(120)
    counts = world.emitter_counts(gun)
    assert counts["born"] == pytest.approx(20, abs=1) and world.emitter_counts(sparks)["born"] == 5 * counts["landed"]
    particles = world.particles(sparks, eye=(0, 2, 0))
    assert particles.size == world.emitter_counts(sparks)["alive"] > 0 and particles.position.shape[1] == 3
    distances = np.linalg.norm(particles.position - [0, 2, 0], axis=1)
    assert (np.diff(distances) <= 1e-12).all()
    assert world.emitter("gun") == gun and world.emit(gun, 3) == 3
    world.stop_emitter(gun), world.move_emitter(gun, (1, 2, 3)), world.remove_emitter(gun)
    with pytest.raises(physim.Error):
        world.emit(gun, 1)
    for bad in ({"name": "sparks"}, {"gun": {"rounds": 1}}, {"sub": [{"on": "hit", "emitter": "none"}]}):
        with pytest.raises(physim.Error):
            world.add_emitter(spark, **bad)


def test_trails_of_particles(ball):
    world = physim.World(step=0.01)
    fountain = world.add_emitter(ball, name="fountain", position=(0, 50, 0), per_second=50, trail={"points": 6}, start={"lifetime": 2})
    world.step(40)
    trails = world.trails(fountain)
    assert len(trails.id) == world.emitter_counts(fountain)["alive"] > 5
    assert trails.count.max() == 6 and trails.count.sum() == len(trails.position) == len(trails.time)
    for i, id in enumerate(trails.id):
        way = trails.position[trails.first[i] : trails.first[i] + trails.count[i]]
        assert list(way[-1]) == list(world[id].position)
        assert (np.diff(trails.time[trails.first[i] : trails.first[i] + trails.count[i]]) > 0).all()
    with pytest.raises(physim.Error):
        world.trails(fountain + 1)


def wall_at_20(segments, layers):
    x, end = segments.start[:, 0], segments.end[:, 0]
    part = np.where((x < 20) & (end >= 20), (20 - x) / np.where(end > x, end - x, 1), np.nan)
    return part, np.tile([-1.0, 0, 0], (segments.size, 1)), np.full(segments.size, 7)


def test_an_engine_answers_beside_a_scene(ball):
    scene = physim.Scene(**WALL)
    starts = np.array([[0.0, 2, 0], [25, 2, 0]])
    scene.set_engine(wall_at_20)
    hits = scene.first_hits(starts, starts + [100, 0, 0])
    assert hits.instance[0] & 0xFFFFFFFF == 7 and hits.position[0, 0] == pytest.approx(20, abs=2e-3)
    assert hits.position[1, 0] == pytest.approx(29.8)  # behind the engine's wall stands that of the scene
    scene.set_engine(lambda segments, layers: None)
    assert scene.first_hits(starts, starts + [100, 0, 0]).position[0, 0] == pytest.approx(29.8)
    for bad in (lambda s, _: 1 / 0, lambda s, _: (np.zeros(1),), lambda s, _: (np.zeros(9), np.zeros((9, 3)))):
        scene.set_engine(bad)
        with pytest.raises((physim.Error, ZeroDivisionError, ValueError)):
            scene.first_hits(starts, starts + [100, 0, 0])
    with pytest.raises(physim.Error):
        scene.set_engine(wall_at_20, skin=2)
    with pytest.raises(physim.Error):
        scene.set_engine("none")

    world = physim.World(step=0.01)
    world.set_scene(engine=wall_at_20)
    world.spawn(ball.replace(body_collision_on_hit="stop"))
    save = world.save()
    hits = world.step(400)
    assert hits[hits.kind == "hit"].position[:, 0] == pytest.approx([20], abs=2e-3)
    with pytest.raises(physim.Error, match="engine"):
        physim.World.load(save)
    copy, pickled = physim.World.load(save, engine=wall_at_20), pickle.loads(pickle.dumps(world))
    copy.step(400)
    assert copy.hash() == world.hash() == pickled.hash()


def test_scenes_are_asked():
    scene = physim.Scene(**WALL)
    starts = np.array([[0.0, 2, 0], [0, 2, 50]])
    hits = scene.first_hits(starts, starts + [100, 0, 0])
    assert hits.instance[0] > 0 and hits.instance[1] == 0
    assert hits.position[0, 0] == pytest.approx(29.8) and list(hits.normal[0]) == [-1, 0, 0]
    through = scene.all_hits((0, 2, 0), (100, 2, 0))
    assert list(through.entering) == [True, False]
    assert scene.nearest((25, 2, 0)).distance == pytest.approx(4.8)
    assert list(scene.overlaps((29, 2, 0), 1.0)) == [hits.instance[0]] and len(scene) == 1
    with pytest.raises(physim.Error):
        scene.first_hits(starts, starts[:1])
    with pytest.raises(physim.Error):
        scene.first_hits(starts[:, :2], starts)


# ------------------------------------------------------------------------------------------------------------ moments
def test_snapshots_saves_and_pickles_go_on_with_the_same_bits(ball):
    world = physim.World(**WALL, ground_mode="bounce")
    world.spawn(ball, speed=np.linspace(10, 30, 40))
    world.step(20)
    moment, save, pickled = world.snapshot(), world.save(), pickle.dumps(world)
    world.step(40)
    later = world.hash()
    world.restore(moment)
    assert moment.time == world.time != 0
    world.step(40)
    assert world.hash() == later
    for copy in (physim.World.load(save, world), physim.World.load(save), pickle.loads(pickled)):
        copy.step(40)
        assert copy.hash() == later and same_bits(copy.positions(), world.positions())


def test_functions_are_given_again_to_a_loaded_world(ball):
    def lift(time, ids, position, velocity, mass):
        return np.tile([0.0, 1.0, 0.0], (len(ids), 1))

    world = physim.World()
    world.spawn(ball)
    world.add_force(lift)
    save = world.save()
    with pytest.raises(physim.Error, match="force"):
        physim.World.load(save)
    copy = physim.World.load(save, forces=[lift])
    copy.step(10), world.step(10)
    assert copy.hash() == world.hash()


def test_recordings_are_played_again(tmp_path, ball):
    world = physim.World()
    world.record(tmp_path / "world.rec")
    world.spawn(ball, speed=[10.0, 20.0])
    world.step(30)
    world.stop_recording()
    report = physim.replay(tmp_path / "world.rec")
    assert report.complete and report.difference is None and report.steps == 30 and report.hashes >= 30
    (tmp_path / "bad.rec").write_bytes(b"none")
    with pytest.raises(physim.Error):
        physim.replay(tmp_path / "bad.rec")


def test_a_recording_is_played_frame_by_frame(tmp_path, ball):
    world, places = physim.World(), []
    world.record(tmp_path / "world.rec")
    world.spawn(ball, speed=[10.0, 20.0])
    for _ in range(12):
        world.step()
        places.append(world.positions())
    world.stop_recording()
    played = physim.Replay(tmp_path / "world.rec")
    assert len(played) == 0
    for i, frame in enumerate(played):
        assert same_bits(frame.positions(), places[i]) and frame.time == pytest.approx((i + 1) / 60)
        assert frame.report().steps == i + 1
    assert i == 11 and played.hash() == world.hash()
    for step in (3, 11, 1, 12):
        assert played.seek(step) and same_bits(played.positions(), places[step - 1]) and played.report().steps == step
    assert not played.seek(13) and played.hash() == world.hash()
    report = played.report()
    assert report.complete and report.difference is None and not played.next()
    for change in (lambda: played.step(), lambda: played.spawn(ball), lambda: played.set_scene(), lambda: played.restore(None)):
        with pytest.raises((physim.Error, TypeError, AttributeError)):
            change()
    copy = physim.World.load(played.save())
    copy.step()
    assert copy.time > played.time
    with pytest.raises(TypeError):
        pickle.dumps(played)
    with pytest.raises(physim.Error):
        world._core.next()
    with pytest.raises(physim.Error):
        world._core.seek(1)


def test_the_end_of_a_world(ball):
    with physim.World() as world:
        world.spawn(ball)
        world.step()
    assert world.closed and "closed" in repr(world)
    for use in (world.step, world.positions, world.snapshot, world.save, lambda: world.spawn(ball), lambda: len(world)):
        with pytest.raises(physim.Error, match="closed"):
            use()
    world.close()
    kept = physim.World()
    one = kept[kept.spawn(ball)[0]]
    kept_ref = weakref.ref(kept)
    del kept
    gc.collect()
    assert kept_ref() is not None and one.alive  # a projectile keeps its world


def test_groups_hits_and_tables_of_a_scenario():
    world = physim.Scenario.from_file(SCENARIOS / "emit_machine_gun.toml").world()
    hits = 0
    for _ in range(60):
        world.step(2)
        hits += world.hits.size
    assert world.steps > 0 and hits > 0 and all(group.name == name for name, group in world.groups.items())
    assert "<table>" in world._repr_html_() and "projectiles" in repr(world)
    with pytest.raises(physim.Error):
        world.step(dt=0.1)


def test_a_shot_brings_its_own_place(ball):
    world = physim.World()
    here = ball.replace(fidelity="small_arms")
    high = here.replace(environment_altitude="4000 m")
    world.spawn(here), world.spawn(high), world.spawn(high)
    world.step(60)
    near, far, same = world.positions()
    assert far[0] > near[0] and same_bits(far, same)


def test_advance_and_render(ball):
    world = physim.World(step=0.01)
    world.spawn(ball)
    assert world.advance(0.035) == 3
    before, after = world.positions(), world.render_positions()
    assert not same_bits(before, after)
    assert world.counters["steps"] == 3 and world.memory > 0

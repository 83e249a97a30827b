"""Worlds: many projectiles in real time, with things, emitters, forces, joints, snapshots and saves."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._errors import Error
from ._flight import Flight, events_of, numbers
from ._scenario import Scenario, Shot, _column
from ._settings import by_path
from ._table import Columns, Record
from ._values import Quantity, Vector, bits, expect, handle, not_negative, quantity, vector, whole

Ids = NDArray[np.uint64]
Engine = Callable[[Columns, int], tuple[ArrayLike, ...] | None]
_UNITS = {"time": "s", "position": "m", "velocity": "m/s", "age": "s", "size": "m", "energy": "J", "depth": "m"}
_LISTS = ("material", "shape", "thing")


def _world_paths(settings: Mapping[str, Any]) -> dict[str, Any]:
    """Settings of a world and of its place: `step` is world.step, `environment_altitude` has its table in front."""
    known = _world_keywords()
    return by_path({known.get(keyword, keyword): value for keyword, value in settings.items()})


def _world_keywords() -> dict[str, str]:
    from ._settings import _by_keyword  # noqa: PLC0415

    return {word.removeprefix("world_"): path for word, path in _by_keyword().items() if word.startswith("world_")}


def _one(table: str, settings: Mapping[str, Any], **others: Any) -> _core.Setup:
    """One element of a list of tables, read as in a scenario that has nothing else."""
    tree: dict[str, Any] = {"physim": 1, "world": {}, "shot": [{"name": "shot"}], table: [nested(settings)], **others}
    return _core.Setup.from_tree(tree)


def nested(settings: Mapping[str, Any]) -> dict[str, Any]:
    """`gun__rounds_per_minute=900` as {"gun": {"rounds_per_minute": 900}}."""
    tree: dict[str, Any] = {}
    for keyword, value in settings.items():
        table = tree
        *heads, last = keyword.split("__")
        for head in heads:
            table = table.setdefault(head, {})
        table[last] = value
    return tree


class Snapshot:
    """A frozen moment of a world; cheap to keep."""

    __slots__ = ("__weakref__", "_snapshot")

    def __init__(self, snapshot: _core.Snapshot) -> None:
        self._snapshot = snapshot

    @property
    def time(self) -> float:
        """Of the world [s]."""
        return self._snapshot.time

    def __repr__(self) -> str:
        return f"<physim.Snapshot at {self.time:.6g} s>"


class Projectile:
    """A projectile of a world: `world[id]`. It is read and changed where it flies."""

    __slots__ = ("__weakref__", "_world", "id")

    def __init__(self, world: World, id: int) -> None:
        self._world, self.id = world, handle(id, "id")

    def _value(self, what: str) -> Any:
        return self._world._core.value(self.id, what)

    @property
    def alive(self) -> bool:
        return bool(self._value("alive"))

    @property
    def status(self) -> str:
        """"in_flight", "landed", "expired", "retired", "pending" or "unknown"."""
        return str(self._value("status"))

    @property
    def position(self) -> NDArray[np.float64]:
        """[m]; assign to it: a jump, which meets nothing on its way."""
        return np.asarray(self._value("position"))

    @position.setter
    def position(self, to: Vector) -> None:
        self._world._core.change(self.id, "position", vector(to, "position", "m"))

    @property
    def velocity(self) -> NDArray[np.float64]:
        """[m/s]; assign to it."""
        return np.asarray(self._value("velocity"))

    @velocity.setter
    def velocity(self, to: Vector) -> None:
        self._world._core.change(self.id, "velocity", vector(to, "velocity", "m/s"))

    @property
    def age(self) -> float:
        """Since launch [s]."""
        return float(self._value("age"))

    @property
    def force(self) -> NDArray[np.float64]:
        """Mass times acceleration now [N]."""
        return np.asarray(self._value("force"))

    @property
    def acceleration(self) -> NDArray[np.float64]:
        """By all that acts on it now [m/s^2]."""
        return np.asarray(self._value("acceleration"))

    @property
    def jerk(self) -> NDArray[np.float64]:
        """The change of acceleration along its path now [m/s^3]."""
        return np.asarray(self._value("jerk"))

    @property
    def label(self) -> str:
        return str(self._value("label"))

    @label.setter
    def label(self, text: str) -> None:
        self._world._core.change(self.id, "label", expect(text, str, "label", "give a text"))

    @property
    def user_data(self) -> int:
        """A number of yours that it carries."""
        return int(self._value("user_data"))

    @user_data.setter
    def user_data(self, number: int) -> None:
        self._world._core.change(self.id, "user_data", handle(number, "user_data"))

    def push(self, impulse: Sequence[float]) -> None:
        """Adds an impulse [N s]."""
        self._world._core.change(self.id, "impulse", vector(impulse, "impulse", "N s"))

    def set(self, **settings: Any) -> None:
        """Changes settings in flight: those that `physim.settings()` marks as live, and its fidelity."""
        self._world._core.set_projectile(self.id, by_path(settings))

    def sleep(self) -> None:
        self._world._core.change(self.id, "sleep", None)

    def wake(self) -> None:
        self._world._core.change(self.id, "wake", None)

    def despawn(self) -> None:
        """Takes it out of the world."""
        self._world._core.change(self.id, "despawn", None)

    def predict(self, time: Quantity | None = None, *, step: Quantity = 0.0) -> Flight:
        """Its flight from now on, until the ground or for a time [s], by the steps of the world or by `step` [s]."""
        until = None if time is None else quantity(time, "time", "s")
        flight = self._world._core.predict(self.id, until, None, quantity(step, "step", "s"))
        return Flight(flight, Shot(name=self.label or f"projectile-{self.id & 0xFFFFFFFF}"))

    def as_dict(self) -> dict[str, Any]:
        return self._world._core.projectile(self.id)

    def __repr__(self) -> str:
        if not self.alive:
            return f"<physim.Projectile {self.id & 0xFFFFFFFF}: {self.status}>"
        place = ", ".join(f"{each:.4g}" for each in self.position)
        return f"<physim.Projectile {self.id & 0xFFFFFFFF}: {self.status} at ({place}) m>"

    def _repr_html_(self) -> str:
        return Record(self.as_dict())._repr_html_()


class Scene:
    """Things that stand and move, to be asked for hits: `scenario.scene()`, or `physim.Scene(shape=..., thing=...)`."""

    __slots__ = ("__weakref__", "_scene")

    def __init__(self, scene: _core.Scene | None = None, **tables: Any) -> None:
        if scene is None:
            scene = _core.Scene(_core.Setup.from_tree({"physim": 1, "shot": [{}], **_as_lists(tables)}))
        self._scene = scene

    def first_hits(
        self,
        starts: ArrayLike,
        ends: ArrayLike,
        *,
        radius: Quantity = 0.0,
        time: Quantity = 0.0,
        duration: Quantity = 0.0,
        layers: int = 0xFFFFFFFF,
        sensors: bool = True,
        threads: int = 0,
    ) -> Columns:
        """The first hit of each of many segments between rows of places [m]: part, position, normal, time, velocity of
        the surface, instance (0: nothing was met), primitive, material, entering, inside."""
        ball, moment, lasts = (quantity(radius, "radius", "m"), *_times(time, duration))
        given = (ball, moment, lasts, bits(layers, "layers"), sensors, bits(threads, "threads"))
        return Columns(self._scene.first_hits(_rows(starts, "starts"), _rows(ends, "ends"), *given), _UNITS)

    def all_hits(self, start: Vector, end: Vector, *, time: Quantity = 0.0, duration: Quantity = 0.0) -> Columns:
        """All that a segment meets: entries and exits."""
        ends = vector(start, "start", "m"), vector(end, "end", "m")
        return Columns(self._scene.all_hits(*ends, *_times(time, duration)), _UNITS)

    def nearest(self, point: Vector, *, within: Quantity = float("inf"), time: Quantity = 0.0) -> Record:
        """The surface nearest to a point: distance [m], position, instance, away."""
        given = vector(point, "point", "m"), quantity(within, "within", "m"), quantity(time, "time", "s")
        return Record(self._scene.nearest(*given))

    def overlaps(self, middle: Vector, radius: Quantity, *, time: Quantity = 0.0) -> Ids:
        """Ids of the things that a sphere touches."""
        given = vector(middle, "middle", "m"), quantity(radius, "radius", "m"), quantity(time, "time", "s")
        return np.asarray(self._scene.overlaps(*given))

    def set_engine(self, engine: Engine | None, *, skin: Quantity = 1e-3) -> None:
        """Lets things of an engine's own answer beside these. `engine` is asked with columns start, end, radius, time and
        duration of segments, and with the layers that count; it returns for each segment the part of it (0 to 1; NaN:
        nothing is met) at which it meets something, rows of normals, and numbers of the things (above 0, else 1); or
        None: nothing is met at all. skin: things are met this far outside of their surfaces [m]."""
        self._scene.set_engine(None if engine is None else _EngineFunction(engine), quantity(skin, "skin", "m"))

    def __len__(self) -> int:
        return self._scene.size


class World:
    """Many projectiles, stepped by frame; equal bits on every machine, with any number of threads.

        with physim.World(step=1 / 120, ground_mode="bounce") as world:
            ids = world.spawn(shot, speed=np.linspace(20, 30, 1000))
            for _ in range(240):
                world.step()
            world.positions()

    Settings are those of [world] ("step", "ground_mode", "threads", ...), of the place ("environment_altitude") and
    lists of what is hit: material=[...], shape=[...], thing=[...]. `Scenario.world()` is the other kind: it fires the
    scenario's shots, volleys and emitters when they are due.
    """

    def __init__(
        self,
        *,
        wind_field: Callable[..., ArrayLike] | None = None,
        force_field: Callable[..., ArrayLike] | None = None,
        **settings: Any,
    ) -> None:
        lists = _as_lists({name: settings.pop(name) for name in _LISTS if name in settings})
        paths = {"world": {}, **_world_paths(settings), **lists}
        self._begin(_core.Setup.from_settings(paths, wind_field, force_field), None)

    def _begin(self, setup: _core.Setup, core: _core.World | None) -> None:
        self._setup = setup
        self._core = core if core is not None else _core.World.make(setup)
        self._emitters: dict[str, tuple[dict[str, Any], int]] = {}
        self._functions: list[Any] = []
        self._engine: Engine | None = None
        self._on_hit: Any = None
        self._trace: list[tuple[NDArray[np.float64], Ids, NDArray[np.float64]]] | None = None
        self._wall: list[NDArray[np.float64]] = []

    @classmethod
    def _of(cls, setup: _core.Setup, core: _core.World) -> World:
        world = cls.__new__(cls)
        world._begin(setup, core)
        return world

    @classmethod
    def _of_scenario(cls, scenario: Scenario, recording: str | os.PathLike[str] = "") -> World:
        return cls._of(scenario._setup, _core.World.run(scenario._setup, os.fspath(recording)))

    # ---------------------------------------------------------------------------------------------------------- time
    def step(self, count: int = 1, *, dt: Quantity | None = None) -> Columns:
        """Takes steps of `dt` [s], by default of the world's own; returns their events.

        What a function of yours raises comes out of here; the step that it was in is taken without its answer.
        """
        count, length = whole(count, "count"), None if dt is None else quantity(dt, "dt", "s")
        if self._trace is None:
            self._core.step(count, length)
            return self.events
        parts = []
        for _ in range(count):
            self._core.step(1, length)
            self._note()
            parts.append(self.events)
        return _joined(parts) if parts else self.events

    def run(self) -> World:
        """Takes all steps of the scenario's duration that are left."""
        taken = self.counters["steps"]
        self.step(max(0, self._core.steps - taken))
        return self

    def advance(self, real_dt: Quantity) -> int:
        """Real time has passed [s]: takes as many fixed steps as fit; returns how many."""
        return self._core.advance(not_negative(real_dt, "real_dt", "s"))

    @property
    def time(self) -> float:
        """Of the simulation [s]."""
        return self._core.time

    @property
    def steps(self) -> int:
        """Within the duration of its scenario; 0 of a world of its own."""
        return self._core.steps

    # --------------------------------------------------------------------------------------------- coming and going
    def spawn(
        self,
        shot: Shot | Scenario,
        count: int | None = None,
        *,
        delay: Quantity = 0.0,
        asks: bool = False,
        errors: str = "raise",
        **columns: Any,
    ) -> Ids:
        """Launches a shot once, or many times with columns: x, y, z [m], speed [m/s], elevation, azimuth [rad].

        Returns their ids. asks: the function of `on_hit()` decides their hits on things. errors="null": one that is refused has the id 0. Its place is that of the world, unless the
        shot has an environment of its own.
        """
        if errors not in ("raise", "null"):
            raise Error(f'unknown value "{errors}"', "errors", 'known are "raise", "null"')
        setup = expect(shot, (Shot, Scenario), "shot", "give a Shot or a Scenario")._setup
        given = {name: _column(value, name) for name, value in columns.items()}
        lengths = {len(column) for column in given.values() if column.ndim == 1}
        if count is not None:
            lengths.add(whole(count, "count"))
        if len(lengths) > 1:
            raise Error(f"columns of different lengths: {sorted(lengths)}", "columns", "give one length")
        n = lengths.pop() if lengths else 1
        inputs = {name: np.full(n, column) if column.ndim == 0 else column for name, column in given.items()}
        return np.asarray(self._core.spawn(setup, "", inputs, n, quantity(delay, "delay", "s"), errors == "raise", asks))

    def despawn(self, ids: ArrayLike | None = None) -> int:
        """Takes projectiles out, all without ids; returns how many were there."""
        return self._core.despawn(_ids(ids))

    @property
    def ids(self) -> Ids:
        """Of all that are alive, by index."""
        return np.asarray(self._core.ids())

    def __len__(self) -> int:
        return self._core.size

    def __bool__(self) -> bool:
        return True

    def __setattr__(self, name: str, value: Any) -> None:
        if not name.startswith("_") and (hasattr(type(self), name) or name in _world_keywords()):
            raise AttributeError(f"{name} of a world cannot be assigned: give settings when it is made")
        super().__setattr__(name, value)

    def __getitem__(self, id: int) -> Projectile:
        return Projectile(self, id)

    def __iter__(self) -> Iterator[Projectile]:
        return (Projectile(self, int(id)) for id in self.ids)

    # --------------------------------------------------------------------------------------------------------- reads
    def positions(self, ids: ArrayLike | None = None, *, out: NDArray[Any] | None = None) -> NDArray[Any]:
        """Rows of x, y, z [m], of all alive in the order of `ids`, or of some. With `out` they are written into the
        first rows of that array, of float64 or float32, with any strides; what cannot be written is an error."""
        return np.asarray(self._core.positions(_ids(ids), out))

    def velocities(self, ids: ArrayLike | None = None, *, out: NDArray[Any] | None = None) -> NDArray[Any]:
        """Rows of vx, vy, vz [m/s], as `positions()`."""
        return np.asarray(self._core.velocities(_ids(ids), out))

    def render_positions(self, ids: ArrayLike | None = None, *, out: NDArray[Any] | None = None) -> NDArray[Any]:
        """Places to draw them at, between steps of `advance()`, as `positions()`."""
        return np.asarray(self._core.render_positions(_ids(ids), out))

    def state(self) -> Columns:
        """Ids, positions and velocities of all alive."""
        return Columns(self._core.state(), _UNITS)

    @property
    def events(self) -> Columns:
        """Of the last `step()`: kind, time, id, position, velocity, value, energy, other and more."""
        return events_of(self._core.events())

    @property
    def call_events(self) -> Columns:
        """Of the last step and of calls since: spawned, retired."""
        return events_of(self._core.call_events())

    @property
    def hits(self) -> Columns:
        """On things, of the last `step()` of a scenario's world: thing, outcome, depth, energy and more."""
        return Columns(self._core.hits(), _UNITS)

    @property
    def wall_hits(self) -> Columns:
        """On the wall (world.wall), of the last `step()` of a scenario's world: time, id, position, velocity."""
        return Columns(self._core.wall_hits(), _UNITS)

    @property
    def groups(self) -> dict[str, Record]:
        """Of a scenario's world: what was counted of each shot, volley and emitter, by name; none of others."""
        if not self._core.is_run:
            return {}
        return {row["name"]: Record(row) for row in self._core.groups()}

    @property
    def counters(self) -> dict[str, Any]:
        """Steps, refused and retired projectiles, dropped time and events, since it was made."""
        return self._core.counters()

    @property
    def memory(self) -> int:
        """Of what grows with use [bytes]."""
        return self._core.memory

    def hash(self) -> int:
        """Of all that decides what happens next: the same on every machine."""
        return self._core.hash()

    # -------------------------------------------------------------------------------------------------------- forces
    def add_force(
        self,
        force: Callable[..., ArrayLike] | None = None,
        *,
        ids: ArrayLike | None = None,
        layers: int = 0xFFFFFFFF,
        other: int = 0,
        delay: Quantity = 0.0,
        duration: Quantity = float("inf"),
        **law: Any,
    ) -> int:
        """A force on all projectiles, on some, or on layers: a law of the list of settings, or a function of yours.

            world.add_force(point_attractor={"strength": 3e4, "centre": (0, 10, 0)})
            world.add_force(lambda time, ids, position, velocity, mass: -0.1 * velocity)

        The function is called once a stage of a step with all rows, and returns rows of forces [N]. It may read the
        world, not change it. `other`: the id at the other end of a spring or bungee. Returns the id of the force.
        """
        if (force is None) == (not law):
            raise Error("give a function or a law, one of them", "force")
        if force is not None:
            lasts = quantity(delay, "delay", "s"), quantity(duration, "duration", "s")
            made = self._core.add_function(force, _ids(ids), bits(layers, "layers"), *lasts)
            self._functions.append(force)
            return made
        settings: dict[str, Any] = {"delay": delay, "duration": duration, **law}
        others: dict[str, Any] = {}
        for name, inner in law.items():
            if name in ("spring", "bungee") and other:
                settings[name] = {**inner, "other": "shot"}
        return self._core.add_law(_one("force", settings, **others), _ids(ids), bits(layers, "layers"), handle(other, "other"))

    def remove_force(self, force: int) -> None:
        self._core.remove_force(handle(force, "force"))

    def felt_by(self, force: int) -> int:
        """Number of projectiles that feel a force."""
        return self._core.felt_by(handle(force, "force"))

    def add_joint(self, a: int, b: int = 0, *, thing: int = 0, **joint: Any) -> int:
        """A rod, cable, spring, hinge or slider between two projectiles, or one and a point: kind="rod", length,
        point=(x, y, z), break_force. `thing`: one of the scene that takes the point along."""
        shots = [{"name": "a"}, {"name": "b"}]
        settings = {"a": "a", **joint} if not b else {"a": "a", "b": "b", **joint}
        return self._core.add_joint(_one("joint", settings, shot=shots), handle(a, "a"), handle(b, "b"), handle(thing, "thing"))

    def move_joint(self, joint: int, position: Vector, velocity: Vector = (0, 0, 0)) -> None:
        """Puts its point at a place now; from there it goes on at a velocity."""
        to = vector(position, "position", "m"), vector(velocity, "velocity", "m/s")
        self._core.move_joint(handle(joint, "joint"), *to)

    def remove_joint(self, joint: int) -> None:
        self._core.remove_joint(handle(joint, "joint"))

    def joint_state(self, joint: int) -> tuple[float, float, bool]:
        """Length [m], tension [N] and whether it is taut."""
        return self._core.joint_state(handle(joint, "joint"))

    def joint_motion(self, joint: int) -> tuple[float, float, float]:
        """Angle of a hinge [rad], way of a slider [m] and the force on its ends [N]."""
        return self._core.joint_motion(handle(joint, "joint"))

    # ------------------------------------------------------------------------------------------------------ emitters
    def add_emitter(self, shot: Shot, *, follows: int = 0, **emitter: Any) -> int:
        """An emitter of a shot: a gun, a spray, a firework. Settings are those of [[emitter]], tables as dicts or with
        two underscores: gun__rounds_per_minute=900. Its sub-emitters are named: sub=[{"on": "hit", "emitter": "sparks"}]
        is an emitter that was added with name="sparks". Returns its id."""
        name = str(emitter.setdefault("name", f"emitter-{len(self._emitters) + 1}"))
        if name in self._emitters:
            raise Error(f'an emitter is named "{name}" already', "emitter.name")
        table = {**nested(emitter), "shot": "shot"}
        known = [before for before, _ in self._emitters.values()]
        setup = _core.Setup.from_tree(
            {"physim": 1, "world": {}, "shot": [{"name": "shot"}], "emitter": [*known, table]}
        )
        ids = {before: id for before, (_, id) in self._emitters.items()}
        of = expect(shot, (Shot, Scenario), "shot", "give a Shot")._setup
        made = self._core.add_emitter(setup, of, ids, handle(follows, "follows"))
        self._emitters[name] = (table, made)
        return made

    def emitter(self, name: str) -> int:
        """The id of an emitter by its name."""
        if name in self._emitters:
            return self._emitters[name][1]
        if self._core.is_run and name in self.groups and self.groups[name].emitter:
            return int(self.groups[name].emitter)
        raise Error(f'no emitter is named "{name}"', "emitter")

    def remove_emitter(self, emitter: int) -> None:
        self._core.remove_emitter(handle(emitter, "emitter"))

    def play_emitter(self, emitter: int) -> None:
        self._core.play_emitter(handle(emitter, "emitter"))

    def stop_emitter(self, emitter: int) -> None:
        self._core.stop_emitter(handle(emitter, "emitter"))

    def move_emitter(self, emitter: int, position: Vector, rotation: Vector = (1, 0, 0, 0)) -> None:
        """In the course of the next step it goes there; rotation: a quaternion w, x, y, z."""
        self._core.move_emitter(handle(emitter, "emitter"), vector(position, "position", "m"), _turn(rotation))

    def emit(self, emitter: int, count: int) -> int:
        """It fires so many now, besides what it fires on its own; returns how many were emitted."""
        return self._core.emit(handle(emitter, "emitter"), whole(count, "count"))

    def emitter_counts(self, emitter: int) -> dict[str, int]:
        """born, refused, aged, landed, expired, replaced, taken, cut, alive."""
        return self._core.emitter_counts(handle(emitter, "emitter"))

    def particles(self, emitter: int, *, eye: Vector | None = None) -> Columns:
        """Its particles, for a renderer: id, position, previous, velocity, size, rotation, colour, age, number; from far
        to near of `eye`."""
        seen_from = None if eye is None else vector(eye, "eye", "m")
        return Columns(self._core.particles(handle(emitter, "emitter"), seen_from), _UNITS)

    def trails(self, emitter: int) -> Record:
        """Past places of its particles (trail={"points": 20}): id, first and count of each particle, position and time
        of each place; particle i was at position[first[i] : first[i] + count[i]], the oldest place first."""
        return Record(self._core.trails(handle(emitter, "emitter")))

    # --------------------------------------------------------------------------------------------------------- scene
    def set_scene(
        self,
        scene: Scenario | None = None,
        *,
        engine: Engine | None = None,
        skin: Quantity = 1e-3,
        **tables: Any,
    ) -> None:
        """Sets the things that projectiles meet from now on, as their body_collision_on_hit says: material=[...], shape=[...],
        thing=[...]; or the things of a scenario; nothing without any. `engine` answers beside them, as in
        `Scene.set_engine()`."""
        if scene is None:
            tree = {"physim": 1, "world": {}, "shot": [{}], **_as_lists(tables)}
            scene = Scenario._of(_core.Setup.from_tree(tree))
        setup = expect(scene, Scenario, "scene", "give a Scenario, or tables: shape=[...], thing=[...]")._setup
        asked = None if engine is None else _EngineFunction(engine)
        self._core.set_scene(setup, asked, quantity(skin, "skin", "m"))
        self._engine = engine
        self._setup_of_things = setup

    @property
    def things(self) -> dict[str, int]:
        """Ids of the things by name: Event.instance has them."""
        return _core.things(getattr(self, "_setup_of_things", self._setup))

    def move_thing(
        self, thing: int | str, position: Vector, rotation: Vector = (1, 0, 0, 0), scale: float = 1.0
    ) -> None:
        """Moves a thing to another place, by its id or name; rotation: a quaternion w, x, y, z."""
        to = vector(position, "position", "m"), _turn(rotation), quantity(scale, "scale", "")
        self._core.move_thing(self._thing(thing), *to)

    def _thing(self, thing: int | str) -> int:
        """The id of a thing by its name, or the id itself."""
        if not isinstance(thing, str):
            return handle(thing, "thing")
        known = self.things
        if thing not in known:
            raise Error(f'no thing is named "{thing}"', "thing", "things are " + ", ".join(known) if known else "there is none")
        return known[thing]

    def in_ball(self, middle: Vector, radius: Quantity, *, layers: int = 0xFFFFFFFF) -> Ids:
        """Ids of the projectiles that a ball touches, each as a ball of its body_collision_radius."""
        ball = vector(middle, "middle", "m"), quantity(radius, "radius", "m")
        return np.asarray(self._core.in_ball(*ball, bits(layers, "layers")))

    def in_box(
        self,
        middle: Vector,
        half: Vector,
        *,
        rotation: Vector = (1, 0, 0, 0),
        layers: int = 0xFFFFFFFF,
    ) -> Ids:
        """Ids of the projectiles that a box touches; half: half of its edges [m]; rotation: a quaternion w, x, y, z."""
        box = vector(middle, "middle", "m"), vector(half, "half", "m"), _turn(rotation)
        return np.asarray(self._core.in_box(*box, bits(layers, "layers")))

    def cast(
        self, start: Vector, end: Vector, *, radius: Quantity = 0.0, layers: int = 0xFFFFFFFF
    ) -> Columns:
        """The projectiles that a ray, or a ball on a straight way, touches, in order: id, part of the way (0 to 1),
        position of what is cast, normal. Points (body_collision_radius of 0) are touched by a ball only."""
        way = vector(start, "start", "m"), vector(end, "end", "m"), quantity(radius, "radius", "m")
        return Columns(self._core.cast(*way, bits(layers, "layers")), _UNITS)

    def set_conveyor(self, thing: int | str, velocity: Vector) -> None:
        """Lets the surface of a thing run as a conveyor's, in the thing's own frame [m/s]; zeros: it stands."""
        self._core.set_conveyor(self._thing(thing), vector(velocity, "velocity", "m/s"))

    def remove_thing(self, thing: int | str) -> None:
        self._core.remove_thing(self._thing(thing))

    def on_hit(self, function: Callable[[Columns], Any]) -> None:
        """The function that decides hits of what was spawned with asks=True, called with columns of all hits of
        a step. It returns "pass", "stop", "stick", "bounce" or "impact" for all or for each, or a pair of that and rows
        of velocities after the hit [m/s]."""
        if not callable(function):
            raise Error("is no function", "on_hit")
        self._core.set_hit_function(_HitFunction(function))
        self._on_hit = function

    # ------------------------------------------------------------------------------------------------------- moments
    def snapshot(self) -> Snapshot:
        """A frozen moment, to go back to."""
        return Snapshot(self._core.snapshot())

    def restore(self, snapshot: Snapshot) -> None:
        """Back to a moment of this world, bit for bit."""
        self._core.restore(expect(snapshot, Snapshot, "snapshot", "give what snapshot() returned")._snapshot)

    def save(self) -> bytes:
        """All of it as bytes; `World.load()` makes a world of them that continues with the same hash and ids."""
        return self._core.save()

    @classmethod
    def load(
        cls,
        save: bytes,
        of: World | Scenario | None = None,
        *,
        forces: Sequence[Callable[..., ArrayLike]] = (),
        on_hit: Callable[[Columns], Any] | None = None,
        engine: Engine | None = None,
    ) -> World:
        """The world of a save. `of`: for the world of a scenario that scenario; for others a world with the same
        functions of place. Functions are no data: custom forces are given again, in their order."""
        save = expect(save, bytes, "save", "give the bytes that save() returned")
        if of is None:
            setup = _core.Setup.from_tree({"physim": 1, "world": {}, "shot": [{}]})
        else:
            expect(of, (World, Scenario), "of", "give a World or a Scenario")
            setup = of._setup
        is_run = isinstance(of, Scenario) or (isinstance(of, World) and of._core.is_run)
        answer = _HitFunction(on_hit) if on_hit is not None else None
        asked = _EngineFunction(engine) if engine is not None else None
        world = cls._of(setup, _core.World.load(setup, save, is_run, list(forces), [], [], answer, asked))
        world._functions, world._on_hit, world._engine = list(forces), on_hit, engine
        return world

    def __reduce__(self) -> Any:
        scenario = Scenario._of(self._setup)
        return (_unpickled_world, (self.save(), scenario, self._core.is_run, self._functions, self._on_hit, self._engine))

    def record(self, file: str | os.PathLike[str]) -> None:
        """Records every call that changes it into a file, for `physim.replay()`; for a world to which nothing was
        done yet."""
        self._core.record(os.fspath(file))

    def stop_recording(self) -> None:
        self._core.stop_recording()

    # ------------------------------------------------------------------------------------------------------ pictures
    def trace(self, on: bool = True) -> None:
        """Keeps the places of all after each step from now on, for `plot()`."""
        self._trace, self._wall = [] if on else None, []
        self._note()

    def _note(self) -> None:
        if self._trace is None:
            return
        state, events, wall = self._core.state(), self._core.events(), self._core.wall_hits()
        seen = events["kind"] != _core.names("event").index("retired")  # they are taken out where nothing is seen
        self._trace.append((events["time"][seen], events["id"][seen], events["position"][seen]))
        self._trace.append((wall["time"], wall["id"], wall["position"]))  # corners between steps
        self._trace.append((np.full(len(state["id"]), self.time), state["id"], state["position"]))
        self._wall.append(wall["position"])

    def plot(self, figure: Any = None) -> Any:
        """A Matplotlib figure: the world from the side and from above, with the paths that `trace()` kept."""
        from ._plot import plot_world  # noqa: PLC0415

        return plot_world(self, figure)

    # ----------------------------------------------------------------------------------------------------------- end
    def close(self) -> None:
        """Lets go of it; every later call is an error."""
        if not self._core.closed:
            self._core.close()

    @property
    def closed(self) -> bool:
        return self._core.closed

    def __enter__(self) -> World:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        if self.closed:
            return "<physim.World: closed>"
        return f"<physim.World: {len(self)} projectiles at {self.time:.6g} s>"

    def _repr_html_(self) -> str:
        return f"<p>{self.__repr__()[1:-1]}</p>" + ("" if self.closed else self.state()._repr_html_())


def _unpickled_world(save: bytes, scenario: Scenario, is_run: bool, forces: Any, on_hit: Any, engine: Any) -> World:
    if is_run:
        return World.load(save, scenario)
    of = World._of(scenario._setup, _core.World.make(scenario._setup))
    return World.load(save, of, forces=forces, on_hit=on_hit, engine=engine)


class _EngineFunction:
    """Answers of a user's engine as the library wants them: parts, normals and numbers of things of each segment."""

    def __init__(self, function: Engine) -> None:
        if not callable(function):
            raise Error("is no function", "engine")
        self.function = function

    def __call__(self, segments: dict[str, Any], layers: int) -> tuple[Any, Any, Any]:
        columns = Columns(segments, _UNITS)
        answer = self.function(columns, layers)
        if answer is None:
            return np.full(columns.size, np.nan), np.zeros((columns.size, 3)), np.zeros(columns.size, dtype=np.uint64)
        part, normal, *others = answer
        things = others[0] if others else np.ones(columns.size, dtype=np.uint64)
        return numbers(part, "engine: part"), _rows(normal, "engine: normal"), _ids(things)


class _HitFunction:
    """Answers of a user's function as the library wants them: a name, and a velocity or None, for each hit."""

    def __init__(self, function: Callable[[Columns], Any]) -> None:
        self.function = function

    def __call__(self, questions: dict[str, Any]) -> list[tuple[str, list[float] | None]]:
        columns = Columns(questions, _UNITS)
        answer = self.function(columns)
        velocities: Any = None
        if isinstance(answer, tuple):
            answer, velocities = answer
        names = [answer] * columns.size if isinstance(answer, str) else [str(each) for each in answer]
        if len(names) != columns.size:
            raise ValueError(f"on_hit must answer each of {columns.size} hits, and gave {len(names)} answers")
        if velocities is None:
            return [(name, None) for name in names]
        rows = _rows(velocities, "velocity")
        if len(rows) != len(names):
            raise ValueError(f"on_hit must give {len(names)} velocities, and gave {len(rows)}")
        return [(name, list(map(float, row))) for name, row in zip(names, rows)]


class Replay(World):
    """A recording played frame by frame: a world that is read as any other, and moved by the recording alone.

        for world in physim.Replay("session.rec"):
            world.positions()

    `report()` says what was done so far: complete, calls, steps, hashes, difference (None: it agrees)."""

    def __init__(self, file: str | os.PathLike[str]) -> None:
        self._begin(_core.Setup.from_settings({}), _core.World.replay(os.fspath(file)))

    def next(self) -> bool:
        """Makes the calls up to and with the next one that took steps; False at the end and at a difference."""
        more: bool = self._core.next()
        return more

    def seek(self, steps: int) -> bool:
        """Goes behind the call that took this step of the recording, back or forwards; 0: to the beginning. False if the
        recording ends or differs before."""
        there: bool = self._core.seek(whole(steps, "steps"))
        return there

    def __iter__(self) -> Iterator[Replay]:  # type: ignore[override]
        while self.next():
            yield self

    def report(self) -> Record:
        """What was done so far."""
        return Record(self._core.report())

    def __reduce__(self) -> Any:
        raise TypeError("a replay cannot be pickled; its save() can")


def replay(file: str | os.PathLike[str]) -> Record:
    """Plays a recording again and compares hashes: complete, calls, steps, hashes, difference (None: it agrees)."""
    return Record(_core.replay(os.fspath(file)))


def _as_lists(tables: Mapping[str, Any]) -> dict[str, Any]:
    unknown = [name for name in tables if name not in _LISTS]
    if unknown:
        raise Error(f'unknown table "{unknown[0]}"', unknown[0], "known are material, shape, thing")
    return {name: [dict(table)] if isinstance(table, Mapping) else list(table) for name, table in tables.items()}


def _turn(rotation: Any) -> list[float]:
    return vector(rotation, "rotation", "", 4)


def _times(time: Any, duration: Any) -> tuple[float, float]:
    return quantity(time, "time", "s"), quantity(duration, "duration", "s")


def _rows(rows: Any, name: str) -> NDArray[np.float64]:
    array = np.asarray(rows)
    if array.dtype.kind not in "fiu" or array.ndim != 2 or array.shape[1] != 3:
        raise Error(f"has the shape {array.shape} and numbers of type {array.dtype}", name, "give rows of x, y, z")
    return np.ascontiguousarray(array, dtype=np.float64)


def _ids(ids: Any) -> Ids | None:
    if ids is None:
        return None
    array = np.atleast_1d(np.asarray(ids))
    if array.size == 0:
        return np.empty(0, dtype=np.uint64)
    if array.dtype.kind not in "iu" or array.ndim != 1 or (array.dtype.kind == "i" and bool((array < 0).any())):
        raise Error(f"found an array of {array.dtype} of the shape {array.shape}", "ids", "give ids, as spawn() does")
    return np.ascontiguousarray(array, dtype=np.uint64)


def _joined(parts: Sequence[Columns]) -> Columns:
    return Columns({name: np.concatenate([part[name] for part in parts]) for name in parts[0]}, parts[0].units)


__all__ = ["Projectile", "Replay", "Scene", "Snapshot", "World", "replay"]

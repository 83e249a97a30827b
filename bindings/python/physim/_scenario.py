"""Shots and scenarios: what is flown, and every question that is asked about it."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._errors import Error
from ._flight import UNITS, Event, Flight, numbers
from ._settings import keyword_docs, path_of
from ._table import Columns, Record, html_table
from ._values import Quantity, Vector, bits, expect, in_si, quantity, vector

if TYPE_CHECKING:
    from ._study import Study
    from ._world import Scene, World

Function = Callable[..., ArrayLike]
_Self = TypeVar("_Self", bound="_Settled")

#: Settings that columns of a batch stand for: they say which units a text or a quantity may have.
_COLUMN_PATHS = {
    "x": "shot.position", "y": "shot.position", "z": "shot.position", "speed": "shot.speed",
    "elevation": "shot.elevation", "azimuth": "shot.azimuth",
    "ballistic_coefficient": "shot.drag.ballistic_coefficient", "form_factor": "shot.drag.form_factor",
    "wind_x": "environment.wind.velocity", "wind_y": "environment.wind.velocity",
    "wind_z": "environment.wind.velocity", "temperature": "environment.atmosphere.temperature",
    "pressure": "environment.atmosphere.pressure", "humidity": "environment.atmosphere.humidity",
    "density": "environment.atmosphere.density",
}  # fmt: skip


class _Settled:
    """Base of shots and scenarios: settings are read by path, and a copy with others is made by keywords."""

    __slots__ = ("__weakref__", "_setup")
    _setup: _core.Setup

    def __init__(self, setup: _core.Setup) -> None:
        self._setup = setup

    @classmethod
    def _of(cls: type[_Self], setup: _core.Setup) -> _Self:
        made = cls.__new__(cls)
        made._setup = setup
        return made

    def get(self, path: str) -> str:
        """The value of a setting as text in SI: get("shot.mass") == "0.0109 kg"."""
        all_settings: dict[str, str] = self._setup.settings()
        if path in all_settings:
            return all_settings[path]
        path = path_of(path)
        names = [path] + [f"shot.{name}{path[4:]}" for name in self._setup.shots if path.startswith("shot.")]
        for name in names:
            if name in all_settings:
                return all_settings[name]
        raise Error("the setting has no value of its own here", path, "physim.settings() lists all")

    def __getitem__(self, path: str) -> str:
        return self.get(path)

    def text(self) -> str:
        """The settings that differ from their defaults, as the text of a scenario file."""
        return self._setup.text()

    def save(self, file: str | os.PathLike[str]) -> None:
        """Writes `text()` into a file."""
        with open(file, "w", encoding="utf-8") as into:
            into.write(self.text())

    def settings(self) -> dict[str, str]:
        """Every setting with its value in SI, by path."""
        return self._setup.settings()

    @property
    def title(self) -> str:
        """Of the scenario."""
        return self._setup.title

    @property
    def notes(self) -> list[str]:
        """Remarks: settings without effect, and numbers far from what is usual."""
        return self._setup.notes

    def __reduce__(self) -> Any:
        setup = self._setup
        return (_unpickled, (type(self), setup.text(), setup.file, setup.wind_field, setup.force_field))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, _Settled):
            return NotImplemented
        functions = ("wind_field", "force_field")
        return self._setup.text() == other._setup.text() and all(
            getattr(self._setup, each) == getattr(other._setup, each) for each in functions
        )

    def __hash__(self) -> int:
        return hash(self._setup.text())

    def _given(self) -> list[tuple[str, str]]:
        return [(path, text) for path, text in self._setup.given() if path != "physim"]

    def _repr_html_(self) -> str:
        return html_table([type(self).__name__, ""], self._given())


def _unpickled(cls: type[_Settled], text: str, file: str, wind_field: Any, force_field: Any) -> _Settled:
    return cls._of(_core.Setup.from_text(text, file, [], wind_field, force_field))


class Batch(Columns):
    """The ends of many flights, in the columns that were asked for."""

    def __init__(self, columns: Mapping[str, Any], codes: NDArray[np.uint8], answer: Mapping[str, Any]) -> None:
        super().__init__(columns, UNITS)
        self._codes = codes
        self.refused: int = answer["refused"]
        """Shots with impossible numbers: their columns are NaN."""
        self.error: Error | None = Error(*answer["error"]) if answer["error"] else None
        """Of the first shot that was refused."""
        self.kernel: str = answer["kernel"]
        """The instruction set that flew it."""

    @property
    def outcome(self) -> NDArray[np.str_]:
        """The end of each: "landed", "reached_range", ..., "refused"."""
        return np.array(_core.names("outcome"))[self._codes]

    def __getitem__(self, key: Any) -> Any:
        taken = super().__getitem__(key) if isinstance(key, (str, int, np.integer)) else None
        return Columns({name: column[key] for name, column in self._columns.items()}, self.units) if taken is None else taken

    def __getstate__(self) -> dict[str, Any]:
        return self.__dict__

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)


class Solution(Record):
    """A direction that was flown: elevation and azimuth [rad], miss [m], time [s], position, velocity, speed and
    descent [rad] at the target."""

    elevation: float
    azimuth: float
    miss: float
    time: float
    position: NDArray[np.float64]
    velocity: NDArray[np.float64]
    speed: float
    descent: float

    def __init__(self, values: Mapping[str, Any], shot: Shot) -> None:
        super().__init__(values)
        self._shot = shot

    def shot(self) -> Shot:
        """The shot in this direction."""
        return Shot._of(_core.aimed(self._shot._setup, "", self.elevation, self.azimuth))

    def fly(self) -> Flight:
        """The flight in this direction."""
        return self.shot().fly()


class Aim:
    """The answer of `Shot.aim()`: `low` and `high` are solutions, or None out of reach; `nearest` always is one."""

    def __init__(self, answer: Mapping[str, Any], shot: Shot) -> None:
        self.low = Solution(answer["low"], shot) if answer["low"] else None
        self.high = Solution(answer["high"], shot) if answer["high"] else None
        self.nearest = Solution(answer["nearest"], shot)
        self.behind_ground: bool = answer["behind_ground"]
        self.blocked = [(Solution(way, shot), Event(hit)) for way, hit in answer["blocked"]]
        self.sight_ends = Event(answer["sight_ends"]) if answer["sight_ends"] else None
        self.flights: int = answer["flights"]
        self.explanation: str = answer["explanation"]

    @property
    def in_reach(self) -> bool:
        return self.low is not None or self.high is not None

    def __bool__(self) -> bool:
        return self.in_reach

    def __repr__(self) -> str:
        return f"<physim.Aim: {self.explanation}>"


class Fit(Record):
    """The answer of `Shot.fit()`: `shot` is the fitted one; scale, scale_error, speed [m/s], speed_error, rms, flights
    and residuals (columns measurement, quantity, measured, computed)."""

    shot: Shot
    scale: float
    scale_error: float
    speed: float
    speed_error: float
    rms: float
    flights: int
    residuals: Columns


class Comparison:
    """The answer of `Shot.compare()`: flights by fidelity beside the reference, and how far they come from it."""

    def __init__(self, names: Sequence[str], answer: Mapping[str, Any], shot: Shot) -> None:
        rows = answer["flights"]
        self.shot = shot
        self.reference = Flight(answer["reference"], shot)
        self.flights = {name: Flight(row["flight"], shot) for name, row in zip(names, rows) if not row["problem"]}
        self.problems = {name: row["problem"] for name, row in zip(names, rows) if row["problem"]}
        figures = ("end_distance", "largest_distance", "end_delay", "steps", "evaluations")
        table: dict[str, Any] = {"fidelity": list(names)}
        table |= {figure: [row[figure] for row in rows] for figure in figures}
        self.table = Columns(table, {"end_distance": "m", "largest_distance": "m", "end_delay": "s"})

    def to_frame(self) -> Any:
        """A pandas DataFrame with a row for each fidelity."""
        return self.table.to_frame()

    def plot(self, figure: Any = None) -> Any:
        """A Matplotlib figure of all flights over each other."""
        from ._plot import plot_flights  # noqa: PLC0415

        flights = {**self.flights, "reference": self.reference}
        return plot_flights(list(flights.values()), list(flights), self.shot.title or self.shot.name, figure)

    def __repr__(self) -> str:
        return repr(self.table)

    def _repr_html_(self) -> str:
        return self.table._repr_html_()


class Shot(_Settled):
    """A projectile with its launch and its place, checked and prepared: fly it as often as you like.

    Every setting of a shot is a keyword, with underscores for the dots of its path: `drag_table="g7"`; those of the
    place and the end have their table in front: `environment_altitude="1200 m"`, `until_range=1000`. A table may be a
    dict: `drag={"table": "g7"}`. Values are numbers in SI, texts with a unit ("168 gr"), or quantities of pint. None
    stands for what is absent: `until_ground=None`. A distribution stands for a number in studies: "800 m/s +- 3 m/s".

        wind_field: a function (time, position) -> velocity of the air [m/s] over arrays of places
        force_field: a function (time, position, velocity, mass) -> force [N] over arrays of projectiles
    """

    __slots__ = ()

    def __init__(
        self,
        base: _Settled | None = None,
        /,
        *,
        wind_field: Function | None = None,
        force_field: Function | None = None,
        **settings: Any,
    ) -> None:
        self._setup = _setup_of(base, settings, wind_field, force_field)

    @property
    def name(self) -> str:
        """In tables and pictures."""
        return self._setup.shots[0]

    def replace(self, **settings: Any) -> Shot:
        """A copy with other settings."""
        return Shot(self, **settings)

    # ------------------------------------------------------------------------------------------------------- flights
    def fly(self, **settings: Any) -> Flight:
        """Flies it; with settings a copy that has them."""
        shot = self.replace(**settings) if settings else self
        return Flight(_core.fly(shot._setup), shot)

    def batch(
        self,
        *,
        into: Iterable[str] | Mapping[str, NDArray[Any]] = ("time", "x", "y", "z", "speed"),
        moves_profile: bool = False,
        threads: int = 0,
        errors: str = "raise",
        **columns: Any,
    ) -> Batch:
        """Flies it many times, out of columns into columns; with the numbers of `fly()`, bit for bit.

        Columns say what differs from shot to shot: x, y, z [m], speed [m/s], elevation, azimuth [rad],
        ballistic_coefficient [kg/m^2], form_factor, wind_x, wind_y, wind_z [m/s], temperature [K], pressure [Pa],
        humidity, density [kg/m^3]. Columns of float64 side by side are read where they lie; others are copied. A single
        value counts for all shots.

            into: names of the columns that are wanted: time, x, y, z, vx, vy, vz, speed, drop, windage; or a dict of
                arrays that are written, of float64 or float32, with any stride. What cannot be written is an error.
            moves_profile: the wind is added to the profile of the environment instead of replacing it
            threads: 0: all that the machine has; results do not depend on it
            errors: "raise": a shot with impossible numbers is an error; "nan": its columns are NaN
        """
        if errors not in ("raise", "nan"):
            raise Error(f'unknown value "{errors}"', "errors", 'known are "raise", "nan"')
        inputs = {name: _column(value, name) for name, value in columns.items()}
        lengths = {len(column) for column in inputs.values() if column.ndim == 1}
        if len(lengths) > 1:
            found = ", ".join(f"{name}: {len(c)}" for name, c in inputs.items() if c.ndim == 1)
            raise Error(f"columns of different lengths: {found}", "columns", "give one length, or single values")
        count = lengths.pop() if lengths else (1 if inputs else 0)
        inputs = {name: np.full(count, column) if column.ndim == 0 else column for name, column in inputs.items()}
        outputs = dict(into) if isinstance(into, Mapping) else {name: np.empty(count) for name in into}
        _check_apart(inputs, outputs)
        codes = np.empty(count, dtype=np.uint8)
        answer = _core.fly_columns(self._setup, "", inputs, outputs, codes, moves_profile, bits(threads, "threads"))
        batch = Batch(outputs, codes, answer)
        if batch.error is not None and (errors == "raise" or batch.refused == 0):
            raise batch.error
        if batch.size > batch.refused:
            _warn_of_unread(self._setup, inputs, answer)
        return batch

    # ----------------------------------------------------------------------------------------------------- questions
    def table(
        self,
        ranges: ArrayLike | str | None = None,
        *,
        winds: Iterable[Quantity] = (),
        units: str = "metric",
        angle: str | None = None,
    ) -> Columns:
        """A range card: drop, windage, angles, time, speed, energy at ranges [m], as `physim table` has it. Ranges may
        be a text: "100 yd .. 300 yd step 100 yd".

        winds: cross winds from the right, a column each; units: "metric" or "customary" (yd, in, ft/s); angle: "mil"
        (milliradians) or "moa", of which None takes that of the units: mil beside metres, MOA beside yards.
        """
        if units not in ("metric", "customary"):
            raise Error(f'unknown units "{units}"', "units", 'known are "metric", "customary"')
        if angle not in (None, "mil", "moa"):
            raise Error(f'unknown angle "{angle}"', "angle", 'known are "mil", "moa"')
        wanted = [] if ranges is None else self._ranges(ranges)
        if ranges is None and not self._setup.ranges:
            raise Error("the shot has no range to show", "ranges", "give ranges=[100, 200, 300]")
        blown = [winds] if isinstance(winds, str) else list(winds)
        labels = [wind if isinstance(wind, str) else f"{wind} m/s" for wind in blown]
        speeds = [quantity(wind, "winds", "m/s") for wind in blown]
        customary = units == "customary"
        in_moa = customary if angle is None else angle == "moa"
        return Columns(_core.range_card(self._setup, "", wanted, labels, speeds, customary, in_moa))

    def _ranges(self, ranges: Any) -> list[float]:
        """Ranges as those of a scenario's card are read."""
        if not isinstance(ranges, str) and not hasattr(ranges, "magnitude"):
            ranges = list(ranges) if isinstance(ranges, Iterable) else [ranges]
            ranges = [quantity(each, "ranges", "m") for each in ranges]
        try:
            return self._setup.with_settings({"output.ranges": ranges}).ranges
        except Error as error:
            raise Error(error.message.removeprefix("output.ranges: "), "ranges", error.hint) from None

    def aim(
        self,
        position: Vector,
        *,
        velocity: Vector = (0, 0, 0),
        acceleration: Vector = (0, 0, 0),
        arc: str = "both",
        tolerance: Quantity = 0.01,
        ground: Quantity | None = None,
        time: Quantity = 600.0,
    ) -> Aim:
        """Finds the elevations and azimuths with which it hits a target: a point [m], standing or moving.

        arc: "low", "high" or "both"; tolerance: a path that passes so near hits it [m]; ground: height of ground that
        stops the shot [m]; time: longest time of flight [s].
        """
        target, moving = vector(position, "position", "m"), vector(velocity, "velocity", "m/s")
        turning = vector(acceleration, "acceleration", "m/s^2")
        within, longest = quantity(tolerance, "tolerance", "m"), quantity(time, "time", "s")
        height = _or_none(ground, "ground", "m")
        return Aim(_core.aim(self._setup, "", target, moving, turning, arc, within, height, longest), self)

    def max_range(self, *, ground: Quantity = 0.0, slope: Quantity = 0.0, time: Quantity = 3600.0) -> Record:
        """The bore elevation that carries farthest: elevation [rad], range [m], time [s], position, velocity. The ground
        is at a height [m], and rises by a slope [rad]; time: longest time of flight [s]."""
        given = quantity(ground, "ground", "m"), quantity(slope, "slope", "rad"), quantity(time, "time", "s")
        return Record(_core.max_range(self._setup, "", *given))

    def fit(
        self,
        ranges: ArrayLike,
        *,
        speed: ArrayLike | None = None,
        drop: ArrayLike | None = None,
        time: ArrayLike | None = None,
        muzzle_speed: bool = False,
        speed_error: Quantity = 1.0,
        drop_error: Quantity = 0.01,
        time_error: Quantity = 1e-3,
    ) -> Fit:
        """Fits its drag, and its muzzle speed too where asked, to what was measured at ranges [m]: speed [m/s], drop
        (above the line of sight, below it negative) [m], time of flight [s]. NaN: not measured there."""
        at = numbers(ranges, "ranges")
        given = {"speed": speed, "drop": drop, "time": time}
        figures = {name: None if column is None else numbers(column, name) for name, column in given.items()}
        for name, column in figures.items():
            if column is not None and len(column) != len(at):
                raise Error(f"found {len(column)} numbers", name, f"expected {len(at)}, one for each range")
        answer, setup = _core.fit(
            self._setup, "", at, figures["speed"], figures["drop"], figures["time"],
            muzzle_speed, quantity(speed_error, "speed_error", "m/s"), quantity(drop_error, "drop_error", "m"),
            quantity(time_error, "time_error", "s"),
        )  # fmt: skip
        names = ("measurement", "quantity", "measured", "computed")
        rows = answer.pop("residuals")
        residuals = Columns({name: np.array([row[i] for row in rows]) for i, name in enumerate(names)})
        return Fit({"shot": Shot._of(setup), **answer, "residuals": residuals})

    def compare(self, fidelities: Sequence[str] | None = None) -> Comparison:
        """Flies it at presets of fidelity and measures how far each comes from the reference."""
        names = list(_core.names("fidelity") if fidelities is None else fidelities)
        return Comparison(names, _core.compare(self._setup, "", names), self)

    def cheapest_within(
        self, error: Quantity = 0.01, *, time: Quantity = 2.0, step: Quantity = 1.0 / 60, ground: Quantity | None = None
    ) -> Record:
        """The cheapest fidelity that stays within an error [m] of the truth over a time of flight [s]."""
        given = quantity(error, "error", "m"), quantity(time, "time", "s"), quantity(step, "step", "s")
        return Record(_core.cheapest_within(self._setup, "", *given, _or_none(ground, "ground", "m")))

    def time_to_range(self, range: Quantity) -> float:
        """Time of flight to a range along the line of sight [s]."""
        return _core.time_to_range(self._setup, "", quantity(range, "range", "m"))

    def zero_elevation(self, range: Quantity) -> float:
        """The bore elevation that hits the line of sight at a range [rad]."""
        return _core.zero_elevation(self._setup, "", quantity(range, "range", "m"))

    def stability_factor(self) -> float | None:
        """Miller's gyroscopic stability factor at the muzzle; None without a twist, a length or air."""
        return _core.stability_factor(self._setup, "")

    def air(self, altitude: Quantity) -> Record:
        """The air of its environment at an altitude above sea level [m]: temperature, pressure, density,
        sound_speed, viscosity."""
        return Record(_core.air_at(self._setup, quantity(altitude, "altitude", "m")))

    def study(self, **options: Any) -> Study:
        """A study of it: uncertain numbers in, probabilities out. See `physim.Study`."""
        from ._study import Study  # noqa: PLC0415

        return Study(self, **options)

    def __repr__(self) -> str:
        said = [(path, text) for path, text in self._given() if path not in ("source", "expect", "output.ranges")]
        given = [f"{path.removeprefix('shot.').replace('.', '_')}={text!r}" for path, text in said]
        return f"Shot({', '.join(given)})"


Shot.__doc__ = (Shot.__doc__ or "") + "\n    Settings:\n\n" + keyword_docs() + "\n" + keyword_docs(shots=False)


class Scenario(_Settled):
    """A whole scenario: shots, an environment, a world, things, emitters, a study. As a file has it."""

    __slots__ = ()

    def __init__(self, *, wind_field: Function | None = None, force_field: Function | None = None, **tables: Any) -> None:
        """Tables by name, as in a file: Scenario(shot=[{...}], world={...}, emitter=[{...}])."""
        tree: dict[str, Any] = {"physim": 1, **tables}
        for name in ("shot", "volley", "force", "emitter", "joint", "material", "shape", "thing", "expect"):
            if isinstance(tree.get(name), Mapping):
                tree[name] = [tree[name]]
        tree.setdefault("shot", [{}])
        super().__init__(_core.Setup.from_tree(tree, "", wind_field, force_field))

    @classmethod
    def from_text(cls, text: str, file: str = "text", overrides: Sequence[str] = ()) -> Scenario:
        """Reads the text of a scenario file. Overrides are "path=value". Other files are looked for beside `file`."""
        return cls._of(_core.Setup.from_text(text, os.fspath(file), list(overrides)))

    @classmethod
    def from_file(cls, file: str | os.PathLike[str], overrides: Sequence[str] = ()) -> Scenario:
        """Reads a scenario file. Overrides are "path=value", as `--set` has them."""
        return cls._of(_core.Setup.from_file(os.fspath(file), list(overrides)))

    def set(self, path: str, value: Any) -> None:
        """Changes a setting: of all shots ("shot.mass") or of one ("shot.NAME.mass"). After an error all is as it was."""
        self._setup = self._setup.with_settings({path: value})

    def __setitem__(self, path: str, value: Any) -> None:
        self.set(path, value)

    def replace(self, changes: Mapping[str, Any]) -> Scenario:
        """A copy with other settings, by path."""
        return Scenario._of(self._setup.with_settings(dict(changes)))

    @property
    def shots(self) -> list[str]:
        """Names of its shots."""
        return self._setup.shots

    def shot(self, name: str = "") -> Shot:
        """One of its shots, the first or the named one, to be flown alone."""
        return Shot._of(self._setup.only_shot(name))

    def fly(self, shot: str = "") -> Flight:
        """Flies a shot of it: the first, or the named one."""
        flight = _core.fly(self._setup, shot)
        return Flight(flight, self.shot(shot))

    def world(self) -> World:
        """Its world, before the first step: it fires shots, volleys and emitters when they are due."""
        from ._world import World  # noqa: PLC0415

        return World._of_scenario(self)

    def scene(self) -> Scene:
        """The things that it has, to be asked for hits."""
        from ._world import Scene  # noqa: PLC0415

        return Scene(_core.Scene(self._setup))

    def study(self, **options: Any) -> Study:
        """Its study. See `physim.Study`."""
        from ._study import Study  # noqa: PLC0415

        return Study(self, **options)

    def __repr__(self) -> str:
        named = self.title or self._setup.file or "untitled"
        return f"<physim.Scenario {named!r}: shots {', '.join(self.shots)}>"


def fly(base: _Settled | None = None, /, **settings: Any) -> Flight:
    """Computes one flight of a shot with these settings: `fly(mass="168 gr", ..., speed="2700 ft/s")`.

    With a `Shot` in front, of that shot with these settings changed. The keywords are those of `Shot`.
    """
    if isinstance(base, Shot) and not settings:
        return base.fly()
    # As Shot(base, **settings).fly(), which would unpack the keywords and pack them again.
    setup = _setup_of(base, settings, settings.pop("wind_field", None), settings.pop("force_field", None))
    return Flight(_core.fly(setup), Shot._of(setup))


def _setup_of(base: _Settled | None, settings: dict[str, Any], wind_field: Any, force_field: Any) -> _core.Setup:
    """Settings and functions of one shot: those of a base with what is given changed."""
    if base is None:
        return _core.Setup.from_settings(settings, wind_field, force_field)
    expect(base, _Settled, "base", 'give settings by keyword, as mass="168 gr", behind a Shot or a Scenario')
    setup = base._setup if isinstance(base, Shot) else base._setup.only_shot("")
    if settings:
        setup = setup.with_settings(settings, True)
    if wind_field is not None or force_field is not None:
        setup = setup.with_functions(wind_field or setup.wind_field, force_field or setup.force_field)
    return setup


def suvat(
    *,
    s: Quantity | None = None,
    u: Quantity | None = None,
    v: Quantity | None = None,
    a: Quantity | None = None,
    t: Quantity | None = None,
) -> list[Record]:
    """Motions in a straight line under constant acceleration that have three of five quantities: displacement s,
    velocities u and v, acceleration a, time t."""
    units = {"s": "m", "u": "m/s", "v": "m/s", "a": "m/s^2", "t": "s"}
    given = [_or_none(each, name, unit) for each, (name, unit) in zip((s, u, v, a, t), units.items())]
    return [Record(each) for each in _core.suvat(*given)]


def _or_none(value: Any, name: str, unit: str) -> float | None:
    return None if value is None else quantity(value, name, unit)


def _column(value: Any, name: str) -> NDArray[np.float64]:
    """A column of a batch, or a single number for all of its shots."""
    if name not in _COLUMN_PATHS:
        raise Error(f'unknown column "{name}"', name, "known are " + ", ".join(_core.batch_inputs()))
    if isinstance(value, str):
        return np.asarray(_core.parse_quantity(value, _COLUMN_PATHS[name]))
    if hasattr(value, "to") and hasattr(value, "magnitude"):
        value = in_si(value, name, _core.units_of(_COLUMN_PATHS[name])[0])
    array = np.asarray(value)
    return numbers(array.reshape(1), name)[0:1].reshape(()) if array.ndim == 0 else numbers(value, name)


def _check_apart(inputs: Mapping[str, Any], outputs: Mapping[str, Any]) -> None:
    """A column that is written must be no column that is read, and no other that is written."""
    seen = [(name, each) for name, each in inputs.items()]
    for name, column in outputs.items():
        if not isinstance(column, np.ndarray):
            continue  # refused where it is written
        for other, each in seen:
            if np.may_share_memory(column, each) and np.shares_memory(column, each):
                raise Error(f"shares memory with {other}", name, "give an array of its own")
        seen.append((name, column))


def _warn_of_unread(setup: _core.Setup, columns: Iterable[str], answer: Mapping[str, Any]) -> None:
    """Says which columns the fidelity that was flown does not read."""
    air, wind = answer["air"], answer["wind"]
    for name in columns:
        if name.startswith("wind_") and wind == "off":
            why = "the flights have no wind; ask for a fidelity with one"
        elif name == "density" and air == "isa":
            why = "density is for constant and exponential air, and this is isa; give temperature, pressure and humidity"
        elif name in ("temperature", "pressure", "humidity", "density") and air == "vacuum":
            why = "the flights have no air"
        else:
            continue
        warnings.warn(f"{name} has no effect: {why}", stacklevel=3)


def _warn(notes: Iterable[str]) -> None:
    for note in notes:
        warnings.warn(note, stacklevel=3)

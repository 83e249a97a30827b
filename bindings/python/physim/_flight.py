"""Flights: one trajectory, asked at any time or range without flying again."""

from __future__ import annotations

from operator import attrgetter
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._errors import Error
from ._table import Columns, Record, _text
from ._values import Quantity, quantity, whole

if TYPE_CHECKING:
    from ._scenario import Shot

UNITS = {
    "time": "s", "x": "m", "y": "m", "z": "m", "vx": "m/s", "vy": "m/s", "vz": "m/s", "ax": "m/s^2", "ay": "m/s^2",
    "az": "m/s^2", "speed": "m/s", "energy": "J", "mass": "kg", "thrust": "N", "range": "m", "drop": "m",
    "windage": "m", "angular_velocity": "rad/s", "angle_of_attack": "rad", "position": "m", "velocity": "m/s",
    "acceleration": "m/s^2",
}  # fmt: skip
_EVENTS = {"time": "s", "position": "m", "velocity": "m/s", "energy": "J"}
_NAMES = {"kind": "event", "direction": "crossing", "reason": "reason"}


class Sample(Record):
    """The state at one moment, in SI: time, position, velocity, acceleration (NumPy arrays of x, y, z), speed, mach,
    energy, mass, thrust, range, drop, windage (along, above and right of the line of sight), orientation (w, x, y, z),
    angular_velocity and angle_of_attack."""

    time: float
    position: NDArray[np.float64]
    velocity: NDArray[np.float64]
    acceleration: NDArray[np.float64]
    speed: float
    mach: float
    energy: float
    mass: float
    thrust: float
    range: float
    drop: float
    windage: float
    orientation: NDArray[np.float64]
    angular_velocity: NDArray[np.float64]
    angle_of_attack: float

    x: float
    y: float
    z: float

    def __init__(self, sample: _core.Sample) -> None:
        self._sample = sample

    def as_dict(self) -> dict[str, Any]:
        return self._sample.table()

    def __reduce__(self) -> Any:
        return (_pickled_sample, (self.as_dict(),))


for _name in [*Sample.__annotations__]:  # read where it is asked for: few ask for all
    setattr(Sample, _name, property(attrgetter("_sample." + _name)))


class _PickledSample:
    """Numbers of a sample that was pickled."""

    def __init__(self, values: dict[str, Any]) -> None:
        self.__dict__.update(values)
        self.x, self.y, self.z = values["position"]

    def table(self) -> dict[str, Any]:
        return {name: value for name, value in self.__dict__.items() if name not in ("x", "y", "z")}


def _pickled_sample(values: dict[str, Any]) -> Sample:
    return Sample(_PickledSample(values))  # type: ignore[arg-type]


class Event(Record):
    """Something that happened: kind ("ground", "apex", "hit", ...), time, position, velocity, value and more."""

    kind: str
    direction: str
    reason: str
    id: int
    value: float
    time: float
    position: NDArray[np.float64]
    velocity: NDArray[np.float64]
    normal: NDArray[np.float64]
    instance: int
    primitive: int
    material: int
    energy: float
    other: int

    def __repr__(self) -> str:
        return f"Event({self.kind}, time={self.time:.6g} s, position={_text(self.position)} m)"


def events_of(columns: dict[str, Any]) -> Columns:
    """Events as columns, with names in the place of numbers."""
    named = {name: np.array(_core.names(of))[columns[name]] for name, of in _NAMES.items()}
    return Columns({**columns, **named}, _EVENTS)


class Flight:
    """A computed trajectory. Every question is answered from it, without flying again."""

    __slots__ = ("__weakref__", "_flight", "_shot")

    def __init__(self, flight: _core.Flight, shot: Shot) -> None:
        self._flight = flight
        self._shot = shot

    def __reduce__(self) -> Any:
        return (_flown_again, (self._shot,))

    @property
    def shot(self) -> Shot:
        """That was flown."""
        return self._shot

    @property
    def outcome(self) -> str:
        """Its end: "landed", "reached_range", "time_limit", "hit", "event", ..."""
        return self._flight.outcome

    @property
    def duration(self) -> float:
        """Time of flight [s]."""
        return self._flight.duration

    @property
    def elevation(self) -> float:
        """Of the bore above the horizon before cant, as given or found for the zero range, or of the velocity [rad]."""
        return self._flight.elevation

    @property
    def start(self) -> Sample:
        """The state at launch."""
        return self.at_time(0)

    @property
    def end(self) -> Sample:
        """The state at the end."""
        return self.at_time(self.duration)

    @property
    def apogee(self) -> Sample:
        """The state at the highest point of the path."""
        tops = [event.time for event in self.events if event.kind == "apex"]
        return max((self.at_time(time) for time in (0.0, *tops, self.duration)), key=lambda sample: sample.y)

    apex = apogee

    @property
    def range(self) -> float:
        """Horizontal distance from the muzzle to the end [m]."""
        way = self.end.position - self.start.position
        return float(np.hypot(way[0], way[2]))

    def at_time(self, time: Quantity) -> Sample:
        """The state at a time since launch [s]; outside of the flight that of the nearer end."""
        return Sample(self._flight.at(quantity(time, "time", "s")))

    def at_range(self, range: Quantity) -> Sample:
        """The state where it first crosses a range along the line of sight [m]."""
        return Sample(self._flight.at_range(quantity(range, "range", "m")))

    def at_height(self, height: Quantity, direction: str = "any") -> Sample:
        """The state where it first goes through a height [m]; direction: "any", "rising" or "falling"."""
        return Sample(self._flight.at_height(quantity(height, "height", "m"), direction))

    def at_times(self, times: ArrayLike) -> Columns:
        """Columns of the states at times [s]; NaN at a time that is NaN."""
        return Columns(self._flight.at_times(numbers(times, "times")), UNITS)

    def at_ranges(self, ranges: ArrayLike) -> Columns:
        """Columns of the states at ranges along the line of sight [m]; NaN where it does not get."""
        return Columns(self._flight.at_ranges(numbers(ranges, "ranges")), UNITS)

    def samples(self, n: int = 200) -> Columns:
        """Columns of `n` states at equal times from launch to end: time, x, y, z, vx, ..., mach, energy, drop."""
        return self.at_times(np.linspace(0.0, self.duration, whole(n, "n")))

    @property
    def events(self) -> list[Event]:
        """All that happened, in order of time."""
        return [Event(each) for each in self._flight.events()]

    @property
    def notes(self) -> list[str]:
        """Differences of the fidelity granted from what was asked for, with reasons."""
        return [_note(each) for each in self._flight.notes()]

    @property
    def cost(self) -> dict[str, int]:
        """Work done: steps, rejected steps, evaluations of the acceleration."""
        return self._flight.cost()

    @property
    def step_times(self) -> NDArray[np.float64]:
        """Times of the steps taken [s]."""
        return np.asarray(self._flight.step_times())

    def accelerations(self, time: Quantity) -> dict[str, NDArray[np.float64]]:
        """Acceleration by effect at a time [m/s^2]."""
        return self._flight.accelerations(quantity(time, "time", "s"))

    def jerk(self, time: Quantity) -> NDArray[np.float64]:
        """Jerk: the change of acceleration along the path at a time [m/s^3]."""
        return np.asarray(self._flight.jerk(quantity(time, "time", "s")))

    def stability(self, time: Quantity = 0.0) -> tuple[float, float] | None:
        """Gyroscopic and dynamic stability of a rigid body at a time; None where rotation is not flown."""
        both: tuple[float, float] | None = self._flight.stability(quantity(time, "time", "s"))
        return both

    def geodetic(self, time: Quantity) -> tuple[float, float, float]:
        """Latitude [rad], longitude [rad] and height [m] at a time."""
        return self._flight.geodetic(quantity(time, "time", "s"))

    def danger_space(self, range: Quantity, height: Quantity) -> tuple[float, float]:
        """Ranges [m] between which a target of a height, aimed at in its middle, is hit as it is at `range`."""
        return self._flight.danger_space(quantity(range, "range", "m"), quantity(height, "height", "m"))

    def plot(self, figure: Any = None) -> Any:
        """A Matplotlib figure: height over distance, and speed, place, velocity and acceleration over time."""
        from ._plot import plot_flights  # noqa: PLC0415  # Matplotlib is optional

        return plot_flights([self], [self._shot.name], self._shot.title, figure)

    def _drawn(self, count: int) -> Columns:
        return Columns(self._flight.drawn(count), UNITS)

    def __repr__(self) -> str:
        end = self.end
        return (f"<physim.Flight {self._shot.name!r}: {self.outcome} after {self.duration:.6g} s, "
                f"{self.range:.6g} m, at {end.speed:.6g} m/s>")  # fmt: skip

    def _repr_html_(self) -> str:
        from ._table import html_table  # noqa: PLC0415

        top, end = self.apogee, self.end
        rows = [("outcome", self.outcome), ("time of flight [s]", self.duration), ("range [m]", self.range),
                ("apogee [m]", top.y), ("speed at the end [m/s]", end.speed), ("Mach number at the end", end.mach),
                ("elevation of the bore [mrad]", 1e3 * self.elevation)]  # fmt: skip
        return html_table(["flight", self._shot.name], rows)


def _flown_again(shot: Shot) -> Flight:
    return shot.fly()


def _note(note: dict[str, str]) -> str:
    instead = "" if note["granted"] == note["asked"] else f" instead of {note['asked']}"
    return f"{note['effect']}: {note['granted']}{instead}: {note['reason']}"


def numbers(values: ArrayLike, name: str) -> NDArray[np.float64]:
    """A column of float64 side by side: the array itself where it is one already, else a copy. Refuses what is no
    column of real numbers."""
    if np.ma.is_masked(values):
        raise Error("has masked numbers", name, "leave those rows out, or fill them")
    array = np.asarray(values)
    if array.dtype.kind not in "fiu":
        raise Error(f"has numbers of type {array.dtype}", name, "give floats or whole numbers")
    if array.dtype.kind == "f" and array.dtype.itemsize > 8:
        raise Error(f"has numbers of type {array.dtype}", name, "give float64: longer ones would lose digits")
    if array.ndim != 1:
        raise Error(f"has the shape {array.shape}", name, "give one column")
    return np.ascontiguousarray(array, dtype=np.float64)

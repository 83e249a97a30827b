"""Shots out of the objects of other packages, which are not needed to import this one."""

from __future__ import annotations

import importlib
import math
import warnings
from collections.abc import Iterable
from typing import Any

import numpy as np

from ._errors import Error
from ._scenario import Shot

_SAMPLES_OF_A_CURVE = 200


def from_py_ballisticcalc(shot: Any, *, range: float | str | None = None, **settings: Any) -> Shot:
    """The shot of py-ballisticcalc as one of PhySim: drag curve with its ballistic coefficient, weapon, sight, atmosphere,
    winds, and the Earth's rotation where it has a latitude.

        range: where the flight ends [m]
        settings: that differ from those

    Its numbers agree with those of py-ballisticcalc but for three causes: the air (here CIPM-2007 and the standard
    profile from the station on, there a fit of its own; some parts in 10 000 of the density), the drag curve between
    its points, and the spin drift, which is Litz's formula in both and is part of windage here. A latitude without an
    azimuth is a shot to the north here, and a formula for flat shots of any azimuth there (2 cm of 44 at 1000 m). A
    warning names what is missing.
    """
    package = importlib.import_module("py_ballisticcalc")
    unit = package.Unit

    def si(value: Any, name: str) -> float:
        return float(value >> getattr(unit, name))

    weapon, atmo, model = shot.weapon, shot.atmo, shot.ammo.dm
    pound, inch = 0.45359237, 0.0254
    given: dict[str, Any] = {
        "name": "shot",
        "drag": {
            "table": "custom",
            "curve": [[float(point.Mach), float(point.CD)] for point in model.drag_table],
            "ballistic_coefficient": model.BC * pound / inch**2,
        },
        "speed": si(shot.ammo.get_velocity_for_temp(atmo.powder_temp), "MPS"),
        "elevation": si(shot.look_angle, "Radian") + si(weapon.zero_elevation, "Radian") + si(shot.relative_angle, "Radian"),
        "sight": {
            # It is measured upright there, and across the line of sight here.
            "height": si(weapon.sight_height, "Meter") * math.cos(si(shot.look_angle, "Radian")),
            "look_angle": si(shot.look_angle, "Radian"),
            "cant": si(shot.cant_angle, "Radian"),
        },
        "environment_altitude": si(atmo.altitude, "Meter"),
        "environment_atmosphere": {
            "temperature": si(atmo.temperature, "Celsius") + 273.15,
            "pressure": 100 * si(atmo.pressure, "hPa"),
            "humidity": float(atmo.humidity) if atmo.humidity <= 1 else float(atmo.humidity) / 100,
        },
        "fidelity": {"preset": "small_arms"},
        "until_ground": None,
        "until_time": "60 s",
    }
    for name, value, of in (("mass", model.weight, "Kilogram"), ("diameter", model.diameter, "Meter"),
                            ("length", model.length, "Meter"), ("twist", weapon.twist, "Meter")):  # fmt: skip
        if value and si(value, of) != 0:
            given[name] = si(value, of)
    if "mass" not in given | settings:
        warnings.warn("the shot has no weight: its energies are those of 1 kg; give mass=", stacklevel=2)
    if range is not None:
        given["until_range"] = range
    given |= _winds_of(shot.winds, si)
    if shot.latitude is not None:
        given["environment_earth"] = {
            "latitude": math.radians(shot.latitude), "azimuth": math.radians(shot.azimuth or 0.0),
        }  # fmt: skip
        given["fidelity"]["earth"] = "flat_coriolis"
    return Shot(Shot(**given), **settings)


def _winds_of(winds: Iterable[Any], si: Any) -> dict[str, Any]:
    """Steps along the range; behind the last one there is no wind."""
    profile: list[dict[str, Any]] = []
    begin = 0.0
    for wind in winds:
        speed, angle = si(wind.velocity, "MPS"), si(wind.direction_from, "Radian")
        profile.append({"at": begin, "velocity": [speed * math.cos(angle), 0.0, speed * math.sin(angle)]})
        begin = si(wind.until_distance, "Meter")
    if not any(any(point["velocity"]) for point in profile):
        return {}
    if begin < 1e6:
        profile.append({"at": begin, "velocity": [0.0, 0.0, 0.0]})
    if len(profile) == 1:
        return {"environment_wind_velocity": profile[0]["velocity"]}
    return {"environment_wind": {"profile": profile, "by": "range", "interpolation": "step"}}


def from_rocketpy(
    rocket: Any,
    environment: Any | None = None,
    *,
    rail_length: float | str,
    inclination: float = 90.0,
    heading: float = 0.0,
    rigid: bool = True,
    **settings: Any,
) -> Shot:
    """A rocket of RocketPy, with its motor, as a shot of PhySim: thrust, propellant and drag while the motor burns and
    after it, masses, moments of inertia, surfaces, rail, place, air at the rail, and the wind over height.

        rail_length: of the launch rail [m]
        inclination: of the rail above the horizon [degrees], as of rocketpy.Flight
        heading: of the rail, clockwise from north [degrees]
        rigid: it turns as a rigid body with its nose, tails and fins; False: a point whose axis lies along the air
        settings: that differ from those, such as until_time

    Lift, restoring and damping moments are those of RocketPy's surfaces, slope by slope; inertia and centre of mass are
    those after burnout all the way. Beside RocketPy's own rigid body heights, times and speeds up to the apogee agree
    within 0.5 %, and the drift in a wind within 4 %. A point turns into the wind at once when it leaves the rail: in
    calm air it agrees within 1 %, in wind its drift does not. A warning names what is left out: parachutes, air brakes,
    what makes fins roll.
    """
    motor = rocket.motor
    burn = float(motor.burn_out_time)
    start = float(motor.burn_start_time)
    times = _times_of(motor.thrust, start, burn)
    thrust = [[float(t - start), max(0.0, float(motor.thrust.get_value_opt(t)))] for t in times]
    propellant = float(motor.propellant_initial_mass)
    left = _rising_list(
        [[float(t - start), float(motor.propellant_mass.get_value_opt(t))] for t in times], propellant
    )
    given: dict[str, Any] = {
        "name": "rocket",
        "mass": float(rocket.total_mass.get_value_opt(start)),
        "diameter": 2 * float(rocket.radius),
        "drag": {"table": "custom", "curve": _curve_of(rocket.power_off_drag)},
        "motor": {
            "thrust": thrust, "propellant_mass": propellant, "propellant": left,
            "drag_curve": _curve_of(rocket.power_on_drag), "ignition_delay": start,
        },
        "speed": 0.0,
        "elevation": math.radians(inclination),
        "rail_length": rail_length,
        "fidelity": {"preset": "simulation", "rotation": "none"},
        "environment_earth": {"azimuth": math.radians(heading)},
        "until_time": "600 s",
    }  # fmt: skip
    if environment is not None:
        given |= _place_of(environment, math.radians(heading), given)
    surfaces = [surface for surface, _ in rocket.aerodynamic_surfaces]
    as_point = not (rigid and surfaces)
    if not as_point:
        given |= _body_of(rocket, surfaces, start + burn)
        given["fidelity"] = {"preset": "simulation", "rotation": "rigid_body"}
    left_out = [f"{len(rocket.parachutes)} parachutes"] if rocket.parachutes else []
    left_out += ["aerodynamic surfaces"] if as_point and surfaces else []
    left_out += ["air brakes"] if getattr(rocket, "air_brakes", None) else []
    left_out += ["the roll of canted fins"] if any(getattr(each, "cant_angle", 0) for each in surfaces) else []
    if left_out:
        end = "; it flies as a point" if as_point else ""
        warnings.warn(f"left out of the rocket: {', '.join(left_out)}{end}", stacklevel=2)
    return Shot(Shot(**given), **settings)


def _body_of(rocket: Any, surfaces: list[Any], time: float) -> dict[str, Any]:
    """Inertia and coefficients of a rigid body, with the centre of mass of a time. Moments of surfaces are their normal
    forces times their arms, and what a turn adds to the angle of attack of each damps it."""
    diameter, area = 2 * float(rocket.radius), math.pi * float(rocket.radius) ** 2
    shift = float(rocket.com_to_cdm_function.get_value_opt(time))
    aero: dict[str, list[list[float]]] = {"lift": [], "pitching": [], "pitch_damping": []}
    for mach in np.linspace(0.0, 3.0, 61):
        normal = moment = damping = 0.0
        for surface in surfaces:
            slope = float(surface.clalpha.get_value_opt(mach)) * float(surface.reference_area) / area
            arm = (float(rocket.surfaces_cp_to_cdm[surface][2]) + shift) / diameter
            normal, moment, damping = normal + slope, moment + slope * arm, damping - slope * arm**2
        aero["lift"].append([float(mach), normal - float(rocket.power_off_drag.get_value_opt(mach))])
        aero["pitching"].append([float(mach), moment])
        aero["pitch_damping"].append([float(mach), damping])
    across = float(rocket.I_11.get_value_opt(time))
    return {"aero": aero, "inertia_moments": [float(rocket.I_33.get_value_opt(time)), across, across]}


def _times_of(function: Any, start: float, end: float) -> Any:
    """Times of a curve's points; evenly spaced ones of a formula."""
    source = getattr(function, "source", None)
    if isinstance(source, np.ndarray) and source.ndim == 2:
        inside = source[(source[:, 0] > start) & (source[:, 0] < end), 0]
        return np.unique(np.concatenate([[start], inside, [end]]))
    return np.linspace(start, end, _SAMPLES_OF_A_CURVE)


def _rising_list(points: list[list[float]], first: float) -> list[list[float]]:
    """Propellant falls from all to nothing: roundings of the other package are taken out."""
    mass = first
    out = []
    for time, value in points:
        mass = min(mass, max(0.0, value))
        out.append([time, mass])
    out[0][1], out[-1][1] = first, 0.0
    return out


def _curve_of(function: Any) -> list[list[float]]:
    """Drag coefficients over Mach numbers."""
    source = getattr(function, "source", None)
    if isinstance(source, np.ndarray) and source.ndim == 2:
        machs = np.unique(source[:, 0])
    else:
        machs = np.linspace(0.0, 3.0, 61)
    return [[float(mach), float(function.get_value_opt(float(mach)))] for mach in machs if mach >= 0]


def _place_of(environment: Any, heading: float, given: dict[str, Any]) -> dict[str, Any]:
    """Altitude, latitude, gravity's place, air at the rail, and wind over height: RocketPy's x is east, its y north."""
    altitude = float(environment.elevation)
    place: dict[str, Any] = {
        "environment_altitude": altitude,
        "environment_atmosphere": {
            "temperature": float(environment.temperature.get_value_opt(altitude)),
            "pressure": float(environment.pressure.get_value_opt(altitude)),
        },
        "environment_earth": {
            **given["environment_earth"],
            "latitude": math.radians(float(environment.latitude)),
            "longitude": math.radians(float(environment.longitude)),
        },
    }
    profile: list[dict[str, Any]] = []
    for height in np.concatenate([np.arange(0.0, 1000.0, 100.0), np.arange(1000.0, 12_000.0, 500.0)])[:32]:
        east = float(environment.wind_velocity_x.get_value_opt(altitude + height))
        north = float(environment.wind_velocity_y.get_value_opt(altitude + height))
        along, right = _turned(east, north, heading)
        profile.append({"at": float(height), "velocity": [along, 0.0, right]})
    if any(any(point["velocity"]) for point in profile):
        place["environment_wind"] = {"profile": profile, "by": "height"}
    if not math.isfinite(place["environment_atmosphere"]["pressure"]):
        raise Error("has no pressure at its elevation", "environment")
    return place


def _turned(east: float, north: float, heading: float) -> tuple[float, float]:
    """Along a heading, and to its right."""
    return (
        north * math.cos(heading) + east * math.sin(heading),
        east * math.cos(heading) - north * math.sin(heading),
    )

"""The Python package beside those that people use: one shot of a .308 to 1000 m, a rocket, a batch.

    python bench/python/peers.py [--quick] [--markdown]

Prints medians of many runs in CPU time, one package after the other in turns, with the error that each reaches beside its time: the
distance of the drop at 1000 m from what the same package's models give at its finest steps. Versions that the figures of
docs/benchmarks.md are of are pinned below; others are reported. Packages that are missing are left out.
"""

from __future__ import annotations

import argparse
import importlib
import importlib.metadata
import logging
import math
import statistics
import sys
import time
import warnings
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

import physim

PINNED = {"py_ballisticcalc": "3.1.1", "py_ballisticcalc.exts": "3.1.1", "rocketpy": "1.13.0", "scipy": "1.18.1", "numba": "0.68.1"}
RANGE = 1000.0  # [m]

BULLET = {
    "mass": "168 gr", "diameter": "0.308 in", "length": "1.282 in", "twist": "11.24 in", "drag_table": "g7",
    "drag_ballistic_coefficient": "0.223 lb/in^2", "speed": "2750 ft/s", "sight_height": "2 in",
    "elevation": "1.247 mrad", "fidelity": "small_arms", "until_ground": None, "until_range": "1000 m",
}  # fmt: skip


@dataclass
class Row:
    name: str
    work: Callable[[], float]  # one answer; returns the drop at 1000 m [m]
    truth: float = math.nan  # [m]
    shots: int = 1  # flights of one call
    times: list[float] = field(default_factory=list)  # of a flight [s]

    @property
    def median(self) -> float:
        return statistics.median(self.times)


def measure(rows: list[Row], seconds: float, rounds: int) -> None:
    """In turns, so that what else the machine does meets all alike."""
    counts = {}
    for row in rows:
        row.work()
        start = time.process_time()
        row.work()
        counts[row.name] = max(1, int(seconds / rounds / max(1e-7, time.process_time() - start)))
    for _ in range(rounds):
        for row in rows:
            start = time.process_time()
            for _ in range(counts[row.name]):
                row.work()
            row.times.append((time.process_time() - start) / counts[row.name] / row.shots)


# -------------------------------------------------------------------------------------------------------- the packages
def rows_of_physim() -> list[Row]:
    shot = physim.Shot(**BULLET)
    truth = shot.fly(tolerance_relative=1e-14, tolerance_absolute=1e-12, fidelity_integrator="dop853").at_range(RANGE).drop
    loose = {**BULLET, "tolerance_relative": 1e-5}
    prepared, rough = shot, physim.Shot(**loose)
    speeds = np.linspace(800, 850, 20_000)
    drops = np.empty(len(speeds))

    def batch() -> float:
        shot.batch(speed=speeds, into={"drop": drops}, threads=1)
        return float("nan")

    return [
        Row("physim, prepared shot", lambda: prepared.fly().at_range(RANGE).drop, truth),
        Row("physim, keywords and units as text", lambda: physim.fly(**BULLET).at_range(RANGE).drop, truth),
        Row("physim, prepared shot, tolerance 1e-5", lambda: rough.fly().at_range(RANGE).drop, truth),
        Row("physim, keywords as text, tolerance 1e-5", lambda: physim.fly(**loose).at_range(RANGE).drop, truth),
        Row("physim, batch of 20 000 on one thread", batch, math.nan, len(speeds)),
    ]


def rows_of_py_ballisticcalc() -> list[Row]:
    ballistics = importlib.import_module("py_ballisticcalc")
    unit = ballistics.Unit
    model = ballistics.DragModel(0.223, ballistics.TableG7, unit.Grain(168), unit.Inch(0.308), unit.Inch(1.282))
    weapon = ballistics.Weapon(unit.Inch(2), unit.Inch(11.24), zero_elevation=unit.MRad(1.247))
    shot = ballistics.Shot(weapon=weapon, ammo=ballistics.Ammo(model, unit.FPS(2750)))
    end = unit.Meter(RANGE)

    def drop(calculator: object) -> float:
        fired = calculator.fire(shot, trajectory_range=end, trajectory_step=end)  # type: ignore[attr-defined]
        rows = getattr(fired, "records", None) or fired.trajectory
        return float(rows[-1].height >> unit.Meter)

    finest = {"relative_tolerance": 1e-13, "absolute_tolerance": 1e-13, "integration_method": "DOP853"}
    truth = drop(ballistics.Calculator(engine="scipy_engine", config=finest))
    rows = []
    for entry in sorted(importlib.metadata.entry_points(group="py_ballisticcalc"), key=lambda e: e.name):
        calculator = ballistics.Calculator(engine=entry.name)
        rows.append(Row(f"py-ballisticcalc, {entry.name}", lambda c=calculator: drop(c), truth))
    return rows


def curve_of_g7() -> tuple[np.ndarray, np.ndarray]:
    ballistics = importlib.import_module("py_ballisticcalc")
    return (np.array([p["Mach"] for p in ballistics.TableG7]), np.array([p["CD"] for p in ballistics.TableG7]))


def rows_of_scipy() -> list[Row]:
    """The same point mass in air that does not change, as most write it themselves."""
    integrate, interpolate = importlib.import_module("scipy.integrate"), importlib.import_module("scipy.interpolate")
    cd = interpolate.PchipInterpolator(*curve_of_g7())
    coefficient, speed = 0.223 * 0.45359237 / 0.0254**2, 2750 * 0.3048
    factor, sound, angle = math.pi / 8 * 1.225 / coefficient, 340.294, 1.247e-3

    def rate(_: float, y: np.ndarray) -> list[float]:
        v = math.hypot(y[2], y[3])
        k = factor * v * float(cd(v / sound))
        return [y[2], y[3], -k * y[2], -9.80665 - k * y[3]]

    def at_range(_: float, y: np.ndarray) -> float:
        return y[0] - RANGE

    at_range.terminal = True  # type: ignore[attr-defined]
    start = [0.0, -0.0508, speed * math.cos(angle), speed * math.sin(angle)]

    def drop(method: str, tolerance: float) -> float:
        flown = integrate.solve_ivp(rate, (0, 5), start, method=method, rtol=tolerance, atol=tolerance, events=at_range)
        return float(flown.y_events[0][0][1])

    truth = drop("DOP853", 1e-13)
    return [Row(f"scipy solve_ivp, {m} {t:g}", lambda m=m, t=t: drop(m, t), truth)
            for m, t in (("RK45", 1e-6), ("RK45", 1e-8), ("DOP853", 1e-8), ("LSODA", 1e-8))]  # fmt: skip


def rows_of_numba() -> list[Row]:
    """A bare loop of RK4 over a table, compiled: nothing but the sum."""
    numba = importlib.import_module("numba")
    machs, cds = curve_of_g7()
    coefficient, speed = 0.223 * 0.45359237 / 0.0254**2, 2750 * 0.3048
    factor, sound, angle = math.pi / 8 * 1.225 / coefficient, 340.294, 1.247e-3

    @numba.njit
    def drag(v: float) -> float:
        mach = v / sound
        low, high = 0, len(machs) - 1
        while high - low > 1:
            middle = (low + high) // 2
            if machs[middle] <= mach:
                low = middle
            else:
                high = middle
        part = (mach - machs[low]) / (machs[high] - machs[low])
        return factor * v * (cds[low] + part * (cds[high] - cds[low]))

    @numba.njit
    def fly(h: float) -> float:
        x, y, u, w = 0.0, -0.0508, speed * math.cos(angle), speed * math.sin(angle)
        while True:
            x0, y0 = x, y
            k = drag(math.sqrt(u * u + w * w))
            au, aw = -k * u, -9.80665 - k * w
            ub, wb = u + 0.5 * h * au, w + 0.5 * h * aw
            k = drag(math.sqrt(ub * ub + wb * wb))
            bu, bw = -k * ub, -9.80665 - k * wb
            uc, wc = u + 0.5 * h * bu, w + 0.5 * h * bw
            k = drag(math.sqrt(uc * uc + wc * wc))
            cu, cw = -k * uc, -9.80665 - k * wc
            ud, wd = u + h * cu, w + h * cw
            k = drag(math.sqrt(ud * ud + wd * wd))
            du, dw = -k * ud, -9.80665 - k * wd
            x, y = x + h / 6 * (u + 2 * ub + 2 * uc + ud), y + h / 6 * (w + 2 * wb + 2 * wc + wd)
            u, w = u + h / 6 * (au + 2 * bu + 2 * cu + du), w + h / 6 * (aw + 2 * bw + 2 * cw + dw)
            if x >= RANGE:
                return y0 + (RANGE - x0) / (x - x0) * (y - y0)

    truth = float(fly(1e-5))
    return [Row(f"numba, bare RK4, {1e3 * h:g} ms", lambda h=h: float(fly(h)), truth) for h in (0.05, 0.01)]


def rows_of_rockets() -> list[Row]:
    """A rocket to its apogee: a rigid body of RocketPy's and of PhySim's, and a point."""
    rocketpy = importlib.import_module("rocketpy")
    place = rocketpy.Environment(latitude=32.99, longitude=-106.97, elevation=1400)
    place.set_atmospheric_model(type="standard_atmosphere")
    motor = rocketpy.SolidMotor(
        thrust_source=[(0, 0), (0.05, 2000), (0.5, 2300), (1.5, 2100), (3.0, 1500), (3.7, 300), (3.9, 0)],
        dry_mass=1.815, dry_inertia=(0.125, 0.125, 0.002), nozzle_radius=0.033, grain_number=5, grain_density=1815,
        grain_outer_radius=0.033, grain_initial_inner_radius=0.015, grain_initial_height=0.12, grain_separation=0.005,
        grains_center_of_mass_position=0.397, center_of_dry_mass_position=0.317, nozzle_position=0, burn_time=3.9,
        throat_radius=0.011, coordinate_system_orientation="nozzle_to_combustion_chamber",
    )  # fmt: skip
    drag = [(0, 0.42), (0.5, 0.41), (0.8, 0.44), (0.95, 0.55), (1.05, 0.62), (1.2, 0.6), (2, 0.5)]
    rocket = rocketpy.Rocket(radius=0.0635, mass=14.426, inertia=(6.321, 6.321, 0.034), power_off_drag=drag,
                             power_on_drag=drag, center_of_mass_without_motor=0,
                             coordinate_system_orientation="tail_to_nose")  # fmt: skip
    rocket.add_motor(motor, position=-1.255)
    rocket.add_nose(length=0.55829, kind="von karman", position=1.278)
    rocket.add_trapezoidal_fins(n=4, root_chord=0.12, tip_chord=0.06, span=0.11, position=-1.04956)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        shots = [physim.from_rocketpy(rocket, place, rail_length=5.2, inclination=85, rigid=rigid,
                                      until_events=[{"kind": "apex", "terminal": True}]) for rigid in (True, False)]  # fmt: skip

    def theirs() -> float:
        flown = rocketpy.Flight(rocket=rocket, environment=place, rail_length=5.2, inclination=85, heading=0, terminate_on_apogee=True)
        return float(flown.apogee) - 1400

    return [Row("RocketPy, rigid body to its apogee", theirs),
            *(Row(f"physim, the same as a {name}", lambda s=shot: s.fly().end.y)
              for name, shot in zip(("rigid body", "point"), shots))]  # fmt: skip


# --------------------------------------------------------------------------------------------------------------- output
def versions() -> None:
    print(f"physim {physim.__version__} ({physim.kernels()[0]}), Python {sys.version.split()[0]}, NumPy {np.__version__}")
    for name, wanted in PINNED.items():
        try:
            found = importlib.metadata.version(name)
        except importlib.metadata.PackageNotFoundError:
            print(f"{name} is not installed: left out")
            continue
        print(f"{name} {found}" + ("" if found == wanted else f"; figures in the docs are of {wanted}"))


def table(rows: list[Row], markdown: bool, quantity: str) -> None:
    print()
    if markdown:
        print(f"| what | us a flight | {quantity} |\n|---|---:|---:|")
    for row in rows:
        answer = row.work()
        if math.isnan(row.truth):
            distance = "" if math.isnan(answer) else f"{answer:.1f} m"
        else:
            distance = f"{1e3 * abs(answer - row.truth):.3g} mm"
        line = (row.name, f"{1e6 * row.median:.4g}", distance)
        print("| " + " | ".join(line) + " |" if markdown else f"{line[0]:44} {line[1]:>10} us  {line[2]}")


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="a look, not figures")
    parser.add_argument("--markdown", action="store_true")
    asked = parser.parse_args()
    seconds, rounds = (0.2, 3) if asked.quick else (2.0, 15)
    warnings.simplefilter("ignore")
    logging.disable(logging.INFO)
    versions()
    shots: list[Row] = []
    for make in (rows_of_physim, rows_of_py_ballisticcalc, rows_of_scipy, rows_of_numba):
        try:
            shots += make()
        except ImportError as error:
            print(f"left out: {error}")
    measure(shots, seconds, rounds)
    table(shots, asked.markdown, "error")
    try:
        rockets = rows_of_rockets()
    except ImportError as error:
        print(f"left out: {error}")
        return
    measure(rockets, seconds, rounds)
    table(rockets, asked.markdown, "apogee")


if __name__ == "__main__":
    main()

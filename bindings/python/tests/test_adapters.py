"""Shots of other packages beside the packages themselves, where they are installed."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import physim


def calculated(options, with_drag=None):
    """A .308 of py-ballisticcalc, zeroed at 100 m, and its flight to 1000 m."""
    ballistics = pytest.importorskip("py_ballisticcalc")
    unit = ballistics.Unit
    model = with_drag or ballistics.DragModel(
        0.223, ballistics.TableG7, unit.Grain(168), unit.Inch(0.308), unit.Inch(1.282)
    )
    weapon = ballistics.Weapon(unit.Inch(2), unit.Inch(11.24))
    shot = ballistics.Shot(weapon=weapon, ammo=ballistics.Ammo(model, unit.FPS(2750)), **options(ballistics, unit))
    calculator = ballistics.Calculator()
    calculator.set_weapon_zero(shot, unit.Meter(100))
    fired = calculator.fire(shot, trajectory_range=unit.Meter(1000), trajectory_step=unit.Meter(100))
    rows = getattr(fired, "records", None) or fired.trajectory
    return shot, [(row.slant_distance >> unit.Meter, row.time, row.velocity >> unit.MPS,
                   row.slant_height >> unit.Meter, row.windage >> unit.Meter) for row in rows]  # fmt: skip


# Distances allowed at 1000 m [m]: in the standard atmosphere the air is the same; elsewhere it differs by some parts in
# 10 000, as the doc of from_py_ballisticcalc() says.
CASES = {
    "calm": (lambda b, u: {}, 0.01),
    "crosswind": (lambda b, u: {"winds": [b.Wind(u.MPH(10), u.Degree(90))]}, 0.01),
    "two winds": (lambda b, u: {"winds": [b.Wind(u.MPS(4), u.Degree(90), u.Meter(300)),
                                           b.Wind(u.MPS(3), u.Degree(270), u.Meter(700))]}, 0.01),
    "uphill": (lambda b, u: {"look_angle": u.Degree(15)}, 0.01),
    "canted": (lambda b, u: {"cant_angle": u.Degree(10)}, 0.01),
    "high and warm": (lambda b, u: {"atmo": b.Atmo(u.Meter(1500), u.hPa(850), u.Celsius(25), 0.5)}, 0.03),
    "turning Earth": (lambda b, u: {"latitude": 45.0, "azimuth": 90.0}, 0.01),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_shots_of_py_ballisticcalc(case):
    options, allowed = CASES[case]
    shot, rows = calculated(options)
    flight = physim.from_py_ballisticcalc(shot, range=1200).fly()
    for distance, time, speed, drop, windage in rows[1:]:
        at = flight.at_range(distance)
        part = (distance / 1000) ** 2
        assert at.drop == pytest.approx(drop, abs=allowed * part + 5e-4)
        assert at.windage == pytest.approx(windage, abs=allowed * part + 5e-4)
        assert at.time == pytest.approx(time, abs=2e-3 * part + 1e-5)
        assert at.speed == pytest.approx(speed, abs=0.8)


def test_the_first_example_of_py_ballisticcalc_has_the_same_card():
    """No weight, no diameter, yards and milliradians: its README's shot, by its formatted rows."""
    ballistics = pytest.importorskip("py_ballisticcalc")
    unit = ballistics.Unit
    model = ballistics.DragModel(0.22, ballistics.TableG7)
    shot = ballistics.Shot(weapon=ballistics.Weapon(unit.Inch(2)), ammo=ballistics.Ammo(model, unit.FPS(2600)))
    calculator = ballistics.Calculator()
    calculator.set_weapon_zero(shot, unit.Yard(100))
    fired = calculator.fire(shot, trajectory_range=unit.Yard(500), trajectory_step=unit.Yard(100))
    rows = list(getattr(fired, "records", None) or fired.trajectory)[1:]
    with pytest.warns(UserWarning, match="no weight"):
        ours = physim.from_py_ballisticcalc(shot)
    card = ours.table([f"{100 * i} yd" for i in range(1, 6)], units="customary", angle="mil")
    assert card["drop [in]"] == pytest.approx([row.height >> unit.Inch for row in rows], abs=0.05)
    assert card["drop [mil]"] == pytest.approx([row.drop_angle >> unit.MRad for row in rows], abs=0.003)
    assert card["speed [ft/s]"] == pytest.approx([row.velocity >> unit.FPS for row in rows], abs=0.5)
    assert card["time [s]"] == pytest.approx([row.time for row in rows], abs=1e-4)


def test_a_card_of_py_ballisticcalc_is_one_of_physim():
    shot, _ = calculated(CASES["calm"][0])
    card = physim.from_py_ballisticcalc(shot).table(range(100, 1001, 100))
    assert card["drop [cm]"][0] == pytest.approx(0, abs=0.1) and card.size == 10


def rocket():
    rocketpy = pytest.importorskip("rocketpy")
    place = rocketpy.Environment(latitude=32.990254, longitude=-106.974998, elevation=1400)
    place.set_atmospheric_model(type="standard_atmosphere")
    motor = rocketpy.SolidMotor(
        thrust_source=[(0, 0), (0.05, 2000), (0.5, 2300), (1.5, 2100), (3.0, 1500), (3.7, 300), (3.9, 0)],
        dry_mass=1.815, dry_inertia=(0.125, 0.125, 0.002), nozzle_radius=0.033, grain_number=5, grain_density=1815,
        grain_outer_radius=0.033, grain_initial_inner_radius=0.015, grain_initial_height=0.12, grain_separation=0.005,
        grains_center_of_mass_position=0.397, center_of_dry_mass_position=0.317, nozzle_position=0, burn_time=3.9,
        throat_radius=0.011, coordinate_system_orientation="nozzle_to_combustion_chamber",
    )  # fmt: skip
    drag = [(0, 0.42), (0.5, 0.41), (0.8, 0.44), (0.95, 0.55), (1.05, 0.62), (1.2, 0.6), (2, 0.5)]
    made = rocketpy.Rocket(
        radius=0.0635, mass=14.426, inertia=(6.321, 6.321, 0.034), power_off_drag=drag,
        power_on_drag=[(mach, 0.95 * cd) for mach, cd in drag], center_of_mass_without_motor=0,
        coordinate_system_orientation="tail_to_nose",
    )  # fmt: skip
    made.add_motor(motor, position=-1.255)
    made.add_nose(length=0.55829, kind="von karman", position=1.278)
    made.add_trapezoidal_fins(n=4, root_chord=0.12, tip_chord=0.06, span=0.11, position=-1.04956)
    return rocketpy, made, place


@pytest.mark.parametrize("rigid", [True, False])
@pytest.mark.parametrize("heading", [0, 60])
def test_rockets_of_rocketpy(heading, rigid):
    """In calm air a rigid rocket with fins flies much as a point: its height and speeds agree within 1 %."""
    rocketpy, made, place = rocket()
    theirs = rocketpy.Flight(rocket=made, environment=place, rail_length=5.2, inclination=85, heading=heading,
                             terminate_on_apogee=True)  # fmt: skip
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        shot = physim.from_rocketpy(made, place, rail_length=5.2, inclination=85, heading=heading, rigid=rigid)
    assert any("aerodynamic surfaces" in str(each.message) for each in told) != rigid
    assert shot["fidelity_rotation"] == ("rigid_body" if rigid else "none")
    ours = shot.fly()
    assert ours.apogee.y == pytest.approx(theirs.apogee - 1400, rel=0.01)
    assert ours.apogee.time == pytest.approx(theirs.apogee_time, rel=0.01)
    assert ours.samples(2000).speed.max() == pytest.approx(theirs.max_speed, rel=0.01)
    exit = next(event for event in ours.events if event.kind == "rail_exit")
    assert np.linalg.norm(exit.velocity) == pytest.approx(theirs.out_of_rail_velocity, rel=0.005)
    far = np.hypot(theirs.apogee_x, theirs.apogee_y)
    assert ours.apogee.x == pytest.approx(far, rel=0.05)
    assert shot.replace(until_time="1 s").fly().duration == 1


@pytest.mark.parametrize("heading", [0, 90])
def test_in_the_wind_a_rigid_rocket_drifts_as_that_of_rocketpy(heading):
    rocketpy, made, place = rocket()

    def ends(wind):
        place.set_atmospheric_model(type="custom_atmosphere", wind_u=wind, wind_v=0)  # from the west
        theirs = rocketpy.Flight(rocket=made, environment=place, rail_length=5.2, inclination=85, heading=heading,
                                 terminate_on_apogee=True)  # fmt: skip
        ours = physim.from_rocketpy(made, place, rail_length=5.2, inclination=85, heading=heading).fly().apogee
        assert ours.y == pytest.approx(theirs.apogee - 1400, rel=0.005)
        return (ours.z if heading == 0 else ours.x), theirs.apogee_x

    (our_calm, their_calm), (ours, theirs) = ends(0), ends(5)
    assert theirs - their_calm < -400
    assert ours - our_calm == pytest.approx(theirs - their_calm, rel=0.04)


def test_in_the_wind_of_rocketpy_a_point_turns_more():
    """Height agrees within some per cent; into the wind it goes, and farther than a rocket that resists the turn."""
    rocketpy, made, place = rocket()
    place.set_atmospheric_model(type="custom_atmosphere", wind_u=5, wind_v=0)  # from the west
    for heading in (0, 90):
        theirs = rocketpy.Flight(rocket=made, environment=place, rail_length=5.2, inclination=85, heading=heading,
                                 terminate_on_apogee=True)  # fmt: skip
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            shot = physim.from_rocketpy(made, place, rail_length=5.2, inclination=85, heading=heading, rigid=False)
            ours = shot.fly()
        assert ours.apogee.y == pytest.approx(theirs.apogee - 1400, rel=0.04)
        calm = 0 if heading == 0 else 626  # where it goes without wind, towards the east [m]
        east = ours.apogee.z if heading == 0 else ours.apogee.x
        assert 1 < (east - calm) / (theirs.apogee_x - calm) < 3

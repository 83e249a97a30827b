#!/usr/bin/env bash
# RocketPy 1.13.0: the default atmosphere of an Environment has negative pressure and density above 83.6 km. Its
# pressure is a spline through the standard atmosphere up to 80 km of geopotential height, and goes on as that spline
# does. Drag turns into thrust, more with every kilometre: at 120 km the density is that of 34 km with the sign changed.
# max_expected_height=200000 is accepted, and changes nothing of it. A flight that stays below is right; one of a
# sounding rocket is not. set_atmospheric_model(type="custom_atmosphere") with a function of height that takes
# pressure_ISA below 80 km and falls by a scale height above avoids it: 0.038 Pa at 100 km.
# Seen: pressure 1.05 Pa at 80 km, -0.87 at 85, -66.8 at 100, -520 at 120 km, density there -0.0092 kg/m3; a rocket that
# reaches 86.7 km has -0.0013 N of drag at 85.8 km; with a scale height of 6 km above 80 km, 0.038 Pa at 100 km.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q rocketpy==1.13.0
cat >"$folder/seen.py" <<'PYTHON'
import math
import sys
from importlib.metadata import version

from rocketpy import Environment, Flight, GenericMotor, Rocket

air = Environment(latitude=0, longitude=0, max_expected_height=200000)
heights = (70000, 80000, 85000, 100000, 120000)
pressure = {height: float(air.pressure(height)) for height in heights}
density = {height: float(air.density(height)) for height in heights}
isa, warmth, top = air.pressure_ISA, air.temperature_ISA, 80000.0
mended = Environment(max_expected_height=200000)
mended.set_atmospheric_model(
    type="custom_atmosphere", wind_u=0, wind_v=0, temperature=lambda height: float(warmth(min(height, top))),
    pressure=lambda height: float(isa(min(height, top))) * math.exp(min(0, top - height) / 6000))
mended_pressure = float(mended.pressure(100000))
motor = GenericMotor(
    thrust_source=6000, burn_time=12, propellant_initial_mass=20, dry_mass=2, dry_inertia=(0.1, 0.1, 0.01),
    chamber_radius=0.05, chamber_height=1, chamber_position=0, nozzle_radius=0.05, center_of_dry_mass_position=0)
rocket = Rocket(
    radius=0.06, mass=12, inertia=(6, 6, 0.05), power_off_drag=0.5, power_on_drag=0.5, center_of_mass_without_motor=1.5)
rocket.add_motor(motor, position=0)
rocket.add_nose(length=0.4, kind="vonkarman", position=3)
rocket.add_trapezoidal_fins(4, root_chord=0.3, tip_chord=0.1, span=0.15, position=0.3)
flight = Flight(rocket=rocket, environment=air, rail_length=10, inclination=90, heading=0, terminate_on_apogee=True)
late = 0.9 * flight.apogee_time
drag = float(flight.aerodynamic_drag(late))
print("RocketPy", version("rocketpy"), "pressure, Pa:", {height: round(p, 3) for height, p in pressure.items()})
print("density, kg/m3:", {height: f"{d:.2e}" for height, d in density.items()})
print(f"apogee {flight.apogee:.0f} m; drag at {flight.z(late):.0f} m: {drag:.5f} N")
print(f"custom atmosphere, pressure at 100 km: {mended_pressure:.3f} Pa")
as_said = pressure[70000] > 0 and pressure[80000] > 0 and all(pressure[h] < 0 > density[h] for h in heights[2:])
sys.exit(not (as_said and pressure[120000] < -500 and drag < 0 and 0.03 < mended_pressure < 0.05))
PYTHON
"$folder/env/bin/python" -W ignore "$folder/seen.py"

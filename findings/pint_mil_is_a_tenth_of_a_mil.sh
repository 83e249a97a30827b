#!/usr/bin/env bash
# Pint 0.25.3 knows an angle `mil`, and its value is pi/32000 rad: 64 000 of them make a turn. NATO's mil is pi/3200 rad
# (6400 in a turn), and the mil of rifle scopes is 1/1000 rad. A correction of sights, an elevation of a mortar or a
# dispersion that is read as `mil` is a tenth of what was meant: at 1000 m one mil becomes 98 mm instead of 982 mm.
# Nothing warns, since the dimension is right. The line stands in Pint's own list of units, default_en.txt.
# `mrad` is right. `ureg.define("nato_mil = pi / 3200 * radian")` adds the other one; its name must not be `mil`, or old
# files change their meaning.
# Seen: 64000 mil to a turn; 1600 mil, which are a right angle, are 9 degrees; 1 mrad at 1000 m is 1 m.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q pint==0.25.3
cat >"$folder/seen.py" <<'PYTHON'
import sys

import pint

ureg = pint.UnitRegistry()
ureg.define("nato_mil = pi / 3200 * radian")
in_turn = {unit: ureg("1 turn").to(unit).magnitude for unit in ("mil", "mils", "nato_mil", "mrad")}
right_angle = ureg("1600 mil").to("degree").magnitude
off = {unit: (ureg(f"1 {unit}").to("radian").magnitude * ureg("1000 m")).to("mm").magnitude for unit in in_turn}
print("pint", pint.__version__)
print("units in a turn:", {unit: round(count, 3) for unit, count in in_turn.items()})
print("1600 mil in degrees:", round(right_angle, 9), " at 1000 m, mm:", {u: round(d, 2) for u, d in off.items()})
near = lambda a, b: abs(a - b) < 1e-6 * b
seen = near(in_turn["mil"], 64000) and near(in_turn["mils"], 64000) and near(right_angle, 9)
right = near(in_turn["nato_mil"], 6400) and near(off["mrad"], 1000)
sys.exit(not (seen and right))
PYTHON
"$folder/env/bin/python" "$folder/seen.py"

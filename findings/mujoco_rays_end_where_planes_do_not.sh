#!/usr/bin/env bash
# MuJoCo 4.0.0: a plane is infinite for contacts and finite for rays. The size of a plane geom is said to be for
# rendering, and a body lands on it however far away. mj_ray() and the rangefinder sensor answer -1, nothing hit, beyond
# that size. A line of sight, an altimeter or a bullet by rays goes through the ground that carries the vehicle.
# Size "0 0 x", which also draws an infinite plane, makes the rays agree.
# Seen, a plane of size 10: a ball rests on it at x = 50; rays down from 3 m: 3, 3, -1, -1 at x = 5, 9.9, 10.1, 50;
# rangefinder 99.8 over x = 5 and -1 over x = 50. Size 0: 3 everywhere, and 99.8.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q numpy==2.4.6 mujoco==4.0.0
cat >"$folder/seen.py" <<'PYTHON'
import sys

import mujoco
import numpy as np

XML = """<mujoco><worldbody><geom type="plane" size="{size}"/>
<body pos="{x} 0 {z}"><freejoint/><geom type="sphere" size=".1" mass="1"/>
<site name="down" pos="0 0 -.2" euler="180 0 0"/></body></worldbody>
<sensor><rangefinder site="down"/></sensor></mujoco>"""


def scene(size, x, z, seconds=0):
    model = mujoco.MjModel.from_xml_string(XML.format(size=size, x=x, z=z))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    while data.time < seconds:
        mujoco.mj_step(model, data)
    return model, data


def seen(size):
    model, data = scene(size, 50, 1, seconds=6)
    hit = np.zeros(1, np.int32)
    down = np.array([0, 0, -1.0])
    ray = lambda x: mujoco.mj_ray(model, data, np.array([x, 5.0, 3.0]), down, None, 1, -1, hit)
    ranges = [round(float(scene(size, x, 100)[1].sensordata[0]), 3) for x in (5, 50)]
    return round(float(data.qpos[2]), 2), [ray(x) for x in (5.0, 9.9, 10.1, 50.0)], ranges


drawn, endless = seen("10 10 .1"), seen("0 0 .1")
print("MuJoCo", mujoco.__version__, "height of a ball at rest at x = 50; rays at x = 5, 9.9, 10.1, 50; rangefinders")
print("size 10:", drawn, "\nsize 0: ", endless)
sys.exit(not (drawn == (0.1, [3, 3, -1, -1], [99.8, -1]) and endless == (0.1, [3, 3, 3, 3], [99.8, 99.8])))
PYTHON
"$folder/env/bin/python" "$folder/seen.py"

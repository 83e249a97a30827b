#!/usr/bin/env bash
# PyBullet 3.2.7: `linearDamping` of a body is not linear. Every body of createMultiBody() or loadURDF() has 0.04 of it
# by default, and it slows by 0.04 (1 + v) v, v in m/s: at 1 m/s as 0.04 says, at 99 m/s a hundred times as much, 396
# m/s2. `angularDamping` does the same to spin. A thrown ball looks right in a test at walking pace, and a shot stops
# short. getDynamicsInfo() does not tell the damping, so the default stays unseen. The bodies of Bullet's C++ classes
# (btRigidBody) have linear damping, and 0 by default; so has the same call with useMaximalCoordinates=1, which takes
# another class. changeDynamics(body, -1, linearDamping=0, angularDamping=0) ends it.
# Beside it, each component of velocity is cut at 100 m/s, without a word; maxJointVelocity of changeDynamics() is the
# limit of free bodies, too.
# Seen, speed after 1 s without gravity, m/s: 1 -> 0.925, 10 -> 6.90, 99 -> 19.4 (linear 0.04: 95.1); with damping 0,
# 99 -> 99; maximal coordinates: 99 -> 99; spin of 90 rad/s -> 19.0; damping 0 and 800 m/s -> 100.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q numpy==2.4.6 pybullet==3.2.7
cat >"$folder/seen.py" <<'PYTHON'
import math
import sys

import pybullet as p

p.connect(p.DIRECT)


def after_a_second(speed, spin=0.0, maximal=0, **dynamics):
    p.resetSimulation()
    p.setGravity(0, 0, 0)
    ball = p.createMultiBody(1, p.createCollisionShape(p.GEOM_SPHERE, radius=0.1), useMaximalCoordinates=maximal)
    if dynamics:
        p.changeDynamics(ball, -1, **dynamics)
    p.resetBaseVelocity(ball, [speed, 0, 0], [0, 0, spin])
    for _ in range(240):
        p.stepSimulation()
    velocity, turning = p.getBaseVelocity(ball)
    return turning[2] if spin else velocity[0]


def of_quadratic(v, c=0.04):  # dv/dt = -c v (1 + v), after 1 s
    k = v / (1 + v) * math.exp(-c)
    return k / (1 - k)


seen = {v: after_a_second(v) for v in (1, 10, 99)}
spun = after_a_second(0, 90)
free = after_a_second(99, linearDamping=0, angularDamping=0), after_a_second(99, maximal=1)
cut = after_a_second(800, linearDamping=0), after_a_second(800, linearDamping=0, maxJointVelocity=1e4)
print("PyBullet API", p.getAPIVersion(), "speed after 1 s:", {v: round(s, 3) for v, s in seen.items()})
print("by 0.04 (1 + v) v:", {v: round(of_quadratic(v), 3) for v in seen}, " spin 90 rad/s ->", round(spun, 3))
print("99 m/s with damping 0, with maximal coordinates:", free, " 800 m/s, limit 100 and 10 000:", cut)
near = lambda a, b, part=0.02: abs(a - b) <= part * b
as_said = all(near(s, of_quadratic(v)) for v, s in seen.items()) and near(spun, 19.0)
sys.exit(not (as_said and all(near(s, 99, 1e-6) for s in free) and near(cut[0], 100, 1e-6) and near(cut[1], 800, 1e-6)))
PYTHON
"$folder/env/bin/python" "$folder/seen.py"

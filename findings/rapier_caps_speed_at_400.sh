#!/usr/bin/env bash
# Rapier (npm @dimforge/rapier3d-compat) cuts every velocity since 0.20.0, with no warning and no setting of that name
# among its integration parameters: speed at 400 lengthUnit per second, and spin at a quarter of pi per step, which is
# 47.1 rad/s at 60 Hz, eight turns a second. The cut comes with the first step: linvel() tells what was set until then.
# Kinematic bodies are cut, too. Up to 0.19.3 nothing was. A rifle shot (800 m/s), and a golf ball, a drive shaft or a
# propeller that spins, are slower after an upgrade. world.lengthUnit = 10 lifts the speed to 4000 m/s, and changes the
# tolerances of contacts with it; shorter steps lift the limit of spin, 471 rad/s at 600 Hz.
# Seen, of 800 m/s and 300 rad/s at 60 Hz: 0.19.3: 800 and 300; 0.20.0 and 0.21.0: 400 and 47.12; lengthUnit 10: 800.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cat >"$folder/seen.mjs" <<'JS'
import R from '@dimforge/rapier3d-compat';
await R.init();
function stepped(lengthUnit, hz, kinematic) {
  const world = new R.World({x: 0, y: 0, z: 0});
  world.lengthUnit = lengthUnit;
  world.timestep = 1 / hz;
  const kind = kinematic ? R.RigidBodyDesc.kinematicVelocityBased() : R.RigidBodyDesc.dynamic();
  const body = world.createRigidBody(kind.setLinvel(800, 0, 0).setAngvel({x: 0, y: 0, z: 300}));
  world.createCollider(R.ColliderDesc.ball(0.1), body);
  world.step();
  const moved = body.translation().x * hz;
  return [body.linvel().x, moved, body.angvel().z].map(v => Math.round(v * 100) / 100).join(' ');
}
const seen = [stepped(1, 60), stepped(1, 60, true), stepped(10, 60), stepped(1, 600)].join(' | ');
console.log(`${R.version()}: ${seen}`);
JS
for version in 0.19.3 0.20.0 0.21.0; do
  npm install --silent --no-audit --no-fund --prefix "$folder" "@dimforge/rapier3d-compat@$version" >/dev/null
  node "$folder/seen.mjs" 2>/dev/null | tee -a "$folder/seen"
done
echo "(version: speed, distance moved / step, spin | of a kinematic body | with lengthUnit 10 | at 600 Hz)"
diff "$folder/seen" - <<'SEEN'
0.19.3: 800 800 300 | 800 800 300 | 800 800 300 | 800 800 300
0.20.0: 400 400 47.12 | 400 400 47.12 | 800 800 47.12 | 400 400 300
0.21.0: 400 400 47.12 | 400 400 47.12 | 800 800 47.12 | 400 400 300
SEEN

// Scenarios that pairs of settings are put into, and values for those settings whose type says too little.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace physim::test {

struct BaseScenario {
  const char* name;
  const char* text;
};

inline constexpr const char* kBullet = R"(physim = 1
[environment]
atmosphere = { model = "isa", temperature = 290 }
wind = { velocity = [0, 0, 4] }
[[shot]]
name = "a"
mass = 0.0109
diameter = 0.00782
length = 0.031
twist = 0.305
drag = { table = "g7", ballistic_coefficient = 153 }
speed = 790
sight = { height = 0.05, zero_range = 100 }
fidelity = { preset = "small_arms", rotation = "spin_drift" }
[until]
range = 400
[output]
ranges = [100, 300]
)";
inline constexpr BaseScenario kBases[] = {
    {"bullet", kBullet},
    {"stone", R"(physim = 1
[environment]
wind = { profile = [{ at = 0, velocity = [2, 0, 1] }, { at = 20, velocity = [5, 0, 3] }] }
[[shot]]
name = "a"
mass = 0.4
diameter = 0.07
position = [0, 2, 0]
speed = 60
elevation = 0.6
fidelity = "artillery"
)"},
    {"game", R"(physim = 1
[[shot]]
name = "a"
position = [0, 2, 0]
speed = 60
elevation = 0.6
drag = { damping = 0.9 }
fidelity = "game"
[[shot]]
name = "b"
speed = 50
elevation = 0.5
fidelity = "arcade"
)"},
    {"ball", R"(physim = 1
[environment]
wind = { velocity = [3, 0, 1] }
[[shot]]
name = "a"
preset = "golf_ball"
speed = 70
elevation = 0.2
spin = { backspin = 280, sidespin = 20 }
fidelity = { preset = "constant_air", integrator = "tsit5", rotation = "magnus" }
)"},
    {"rocket", R"(physim = 1
[environment]
wind = { velocity = [3, 0, 1] }
[[shot]]
name = "a"
mass = 0.057
diameter = 0.0248
drag = { coefficient = 0.75 }
motor = { thrust = [[0, 5], [0.2, 14], [0.4, 5], [1.8, 5], [1.85, 0]], propellant_mass = 0.0108 }
elevation = 1.5
rail_length = 0.9
fidelity = { preset = "artillery", integrator = "tsit5" }
)"},
    {"shell", R"(physim = 1
[[shot]]
name = "a"
mass = 14.97
diameter = 0.1048
length = 0.4947
twist = 1.8864
speed = 493
elevation = 1.2
inertia = { moments = [0.02326, 0.23118, 0.23118] }
attitude = { rates = [0, 0, 3.64], yaw = 0.01 }
fidelity = { preset = "simulation", earth = "flat", rotation = "rigid_body", integrator = "rk4" }
drag = { table = "custom", curve = [[0, 0.124], [0.9, 0.15], [1.1, 0.41], [2.5, 0.27]] }
aero.lift = [[0, 1.6], [2, 2.2]]
aero.pitching = [[0, 3.5], [2, 3.8]]
aero.pitch_damping = [[0, -3], [2, -9]]
aero.roll_damping = [[0, -0.017], [2, -0.009]]
aero.magnus_moment = [[0, 0, 0.1], [2, 0, 0.4]]
[tolerance]
step = 0.002
[until]
time = 1.5
)"},
    {"globe", R"(physim = 1
[environment]
earth = { latitude = 0.8, longitude = 0.3, azimuth = 0.5 }
[[shot]]
name = "a"
mass = 40
diameter = 0.15
speed = 700
elevation = 0.7
fidelity = { preset = "simulation", earth = "ellipsoid", gravity = "wgs84" }
)"},
    {"scene", R"(physim = 1
[[shot]]
name = "a"
mass = 0.01
diameter = 0.008
speed = 300
position = [0, 1, 0]
elevation = 0.02
body = { collision = { on_hit = "impact" } }
fidelity = "artillery"
[[material]]
name = "wood"
density = 600
poncelet = { strength = 20e6, inertia = 1 }
[[shape]]
name = "slab"
box = [0.02, 3, 3]
[[shape]]
name = "round"
sphere = 0.5
[[thing]]
name = "wall"
shape = "slab"
material = "wood"
position = [20, 1, 0]
[[thing]]
name = "moving"
shape = "round"
position = [40, 1.2, -0.1]
velocity = [0, 0, 1]
)"},
    {"study", R"(physim = 1
[[shot]]
name = "a"
mass = 0.4
diameter = 0.07
speed = 60
elevation = 0.05
fidelity = "artillery"
[until]
range = 30
ground = "off"
[study]
inputs = ["shot.speed = +- 3 m/s", "environment.wind.velocity.z = 0 m/s +- 1 m/s"]
targets = ["plate: rectangle 30 cm x 50 cm"]
shots = 256
)"},
    {"aim", R"(physim = 1
[[shot]]
name = "a"
mass = 0.4
diameter = 0.07
position = [0, 1.5, 0]
speed = 60
elevation = 0.1
fidelity = { preset = "constant_air" }
[target]
position = [120, 10, 5]
velocity = [1, 0, 2]
)"},
    {"world", R"(physim = 1
[world]
duration = 1.5
ground = { mode = "bounce" }
[environment]
wind = { velocity = [3, 0, 1] }
[[shot]]
name = "a"
mass = 0.4
diameter = 0.07
position = [0, 1, 0]
speed = 12
elevation = 0.3
fidelity = "artillery"
[[shot]]
name = "b"
mass = 0.6
diameter = 0.1
position = [0, 0.5, 1]
speed = 2
fidelity = "game"
[[volley]]
name = "many"
shot = "a"
count = 6
interval = 0.05
spread = { horizontal = 0.02, vertical = 0.03, speed = 1 }
)"},
    {"forces", R"(physim = 1
[world]
duration = 1
[[shot]]
name = "a"
mass = 0.4
position = [0, 5, 0]
speed = 5
elevation = 0.1
fidelity = "artillery"
[[shot]]
name = "b"
mass = 0.6
position = [1, 5, 0]
fidelity = "game"
[[shot]]
name = "c"
mass = 0.6
position = [2, 5, 0]
fidelity = "game"
[[joint]]
a = "b"
b = "c"
kind = "spring"
stiffness = 30
length = 0.8
[[joint]]
a = "c"
point = [2, 8, 0]
kind = "cable"
[[force]]
wind_zone = { velocity = [3, 0, 0], low = [-100, -100, -100], high = [100, 100, 100] }
[[force]]
shots = ["a"]
anchored_spring = { anchor = [0, 7, 0], stiffness = 4, rest_length = 1 }
)"},
    {"things", R"(physim = 1
[world]
duration = 1.2
[[shot]]
name = "a"
mass = 0.01
diameter = 0.008
speed = 200
position = [0, 1, 0]
elevation = 0.02
body = { collision = { on_hit = "impact" } }
fidelity = "artillery"
[[volley]]
shot = "a"
count = 4
interval = 0.02
spread = { horizontal = 0.2, vertical = 0.05 }
[[material]]
name = "wood"
density = 600
[[shape]]
name = "slab"
box = [0.02, 3, 3]
[[shape]]
name = "round"
sphere = 0.5
[[thing]]
name = "wall"
shape = "slab"
material = "wood"
position = [20, 1, 0]
[[thing]]
name = "moving"
shape = "round"
position = [8, 1.2, -0.1]
velocity = [0, 0, 1]
)"},
    {"rolling", R"(physim = 1
[world]
duration = 1.5
[[shot]]
name = "a"
mass = 0.4
diameter = 0.1
position = [0, 0.1, 0]
speed = 3
fidelity = "game"
body = { collision = { on_hit = "bounce", radius = 0.05, others = 1 } }
[[shot]]
name = "b"
mass = 0.4
diameter = 0.1
position = [1, 0.06, 0.01]
fidelity = "game"
body = { collision = { on_hit = "bounce", radius = 0.05, others = 1 } }
[[material]]
name = "floor"
friction = 0.9
[[shape]]
name = "slab"
box = [30, 0.1, 30]
[[thing]]
name = "ground"
shape = "slab"
material = "floor"
position = [0, -0.1, 0]
)"},
    {"spray", R"(physim = 1
[world]
duration = 0.8
[environment]
wind = { velocity = [3, 0, 1] }
[[shot]]
name = "drop"
mass = 0.001
diameter = 0.01
fidelity = { preset = "artillery", integrator = "rk4" }
body = { colour = 0x3366FFFF }
[[emitter]]
name = "fountain"
shot = "drop"
position = [0, 2, 0]
per_second = 60
cycle = { duration = 0.5 }
from = { shape = "cone", angle = 0.3, radius = 0.2 }
start = { speed = 6, lifetime = 0.4, colour = "#80a0ff", size = 0.3 }
life = { size = { value = 1, curve = [[0, 1], [1, 0.5]] } }
trail = { points = 4 }
maximum = 20
sub = [{ on = "death", emitter = "puff", count = 2 }]
[[emitter]]
name = "puff"
shot = "drop"
per_second = 0
start = { speed = 1, lifetime = 0.2 }
)"},
    {"gun", R"(physim = 1
[world]
duration = 1
[[shot]]
name = "round"
mass = 0.01
diameter = 0.008
fidelity = "game"
[[shot]]
name = "tracer"
mass = 0.01
diameter = 0.008
fidelity = "game"
[[emitter]]
name = "gun"
shot = "round"
position = [0, 2, 0]
start = { speed = 100 }
cycle = { duration = 0.4 }
[emitter.gun]
rounds_per_minute = 900
burst_rounds = 4
burst_pause = 0.1
magazine = 8
reload = 0.1
dispersion = 0.001
tracer_every = 3
tracer = "tracer"
recoil_up = [[0, 0], [1, 1]]
recoil = 0.02
[[emitter]]
name = "rain"
shot = "tracer"
position = [0, 5, 0]
per_second = 0
rain = { density = 0.02, size = [10, 5, 10], drift = [1, 0, 0] }
start = { speed = 3 }
)"},
};

/// Values of settings whose type, unit and choices do not say enough; the end of a path is enough.
inline const std::vector<std::pair<std::string_view, std::vector<std::string>>>& hinted_values() {
  static const std::vector<std::pair<std::string_view, std::vector<std::string>>> all = {
      {"environment.altitude", {"1200", "300"}},
      {"environment.atmosphere.temperature", {"270", "300"}},
      {"environment.atmosphere.pressure", {"80000", "95000"}},
      {"environment.atmosphere.station_altitude", {"500", "1500"}},
      {"environment.atmosphere.sound_speed", {"300", "360"}},
      {"environment.atmosphere.scale_height", {"7000", "9000"}},
      {"environment.gravity.acceleration", {"8.5", "3.7"}},
      {"environment.gravity.radius", {"6000000", "500000"}},
      {"environment.earth.rotation_rate", {"0.0002", "0.001"}},
      {"wind.profile", {"[{ at = 0, velocity = [1, 0, 2] }, { at = 30, velocity = [6, 1, 3] }]"}},
      {"shot.mass", {"0.013", "0.3", "2"}},
      {"shot.diameter", {"0.009", "0.05", "0.2"}},
      {"shot.drag.curve", {"[[0, 0.2], [1, 0.6], [3, 0.4]]", "[[0, 0.5], [0.1, 0.3], [3, 0.2]]"}},
      {"shot.drag.bands",
       {"[{ above = 0, ballistic_coefficient = 120 }, { above = 500, ballistic_coefficient = 160 }]"}},
      {"shot.drag.ballistic_coefficient", {"140", "60"}},
      {"drag.k1", {"0.02", "0.001"}},
      {"drag.k2", {"0.002", "0.0001"}},
      {"shot.magnus.table",
       {"[{ speed = 10, spin = 10, drag = 0.3, lift = 0.1 }, { speed = 10, spin = 400, drag = 0.4, lift = 0.3 }, { "
        "speed = "
        "90, spin = 10, drag = 0.25, lift = 0.05 }, { speed = 90, spin = 400, drag = 0.3, lift = 0.2 }]"}},
      {"shot.motor.thrust", {"[[0, 9], [1, 7], [1.2, 0]]"}},
      {"shot.motor.propellant_mass", {"0.005", "0.02"}},
      {"shot.motor.propellant", {"[[0, 0.0108], [0.5, 0.004], [1.85, 0]]"}},
      {"shot.motor.drag_curve", {"[[0, 0.9], [1, 1.2]]"}},
      {"shot.motor.ignition_delay", {"0.2", "0.05"}},
      {"shot.inertia.moments", {"[0.03, 0.3, 0.3]", "[0.0001, 0.001, 0.001]", "[0.03, 0.3, 0.31]"}},
      {"shot.inertia.products", {"[0.001, 0.0005, 0]"}},
      {"shot.aero.magnus_force", {"[[0, 0, -0.3], [2, 0, -0.5]]"}},
      {"shot.aero.magnus_moment", {"[[0, 0, 0.2], [2, 0, 0.5]]"}},
      {"shot.aero.yaw_damping", {"[[0, -4], [2, -6]]"}},
      {"shot.aero.area", {"0.01", "0.002"}},
      {"shot.aero", {"[[0, 0.7], [2, 1.1]]", "[[0, -2], [2, -5]]"}},
      {"shot.sight.zero_range", {"60", "25"}},
      {"shot.body.despawn.below", {"1.5", "0.8"}},
      {"shot.body.despawn.farther", {"3", "8"}},
      {"shot.body.despawn.older", {"0.3", "0.1"}},
      {"shot.body.despawn.slower", {"30", "11", "4"}},
      {"shot.body.despawn.box_high", {"[4, 9, 9]", "[1, 2, 3]"}},
      {"shot.body.despawn.box_low", {"[-4, -9, -9]", "[-1, 0.5, -3]"}},
      {"shot.body.sleep_speed", {"1", "4"}},
      {"shot.body.sleep_time", {"0.02", "0.1"}},
      {"shot.body.label", {"\"lead\""}},
      {"shot.body.pool", {"\"few\""}},
      {"shot.body.colour", {"305419896"}},
      {"shot.body.layers", {"2", "3"}},
      {"collision.layers", {"0", "2"}},
      {"world.duration", {"0.5", "0.8"}},
      {"world.step", {"0.01", "0.02"}},
      {"world.ground.height", {"0.3", "-0.5"}},
      {"world.wall", {"5", "2"}},
      {"world.pools", {"[{ name = \"few\", maximum = 2, when_full = \"replace_oldest\" }]"}},
      {"world.detail.rungs", {"[{ fidelity = \"point_mass\", within = 3 }, { fidelity = \"game\" }]"}},
      {"world.max_projectiles", {"2", "1"}},
      {"volley", {"[{ shot = \"a\", count = 3, interval = 0.1 }]"}},
      {"volley.rate", {"10", "30"}},
      {"volley.count", {"2", "4"}},
      {"volley.shot", {"\"b\""}},
      {"force", {"[{ constant_force = { force = [1, 2, 0] } }]"}},
      {"force.shots", {"[\"b\"]"}},
      {"force.layers", {"2"}},
      {"force.thrust.curve", {"[{ time = 0, force = 1 }, { time = 1, force = 3 }]"}},
      {"force.spring.other", {"\"b\""}},
      {"force.bungee.other", {"\"b\""}},
      {"force.buoyancy.volume", {"0.001", "0.0001"}},
      {"force.buoyancy.surface", {"6", "4"}},
      {"force.buoyancy.depth", {"1", "0.3"}},
      {"force.wind_zone.low", {"[-5, -5, -5]"}},
      {"force.wind_zone.high", {"[0.5, 50, 5]"}},
      {"material", {"[{ name = \"wood\", density = 800 }]"}},
      {"material.concrete", {"30e6"}},
      {"material.density", {"800", "2000"}},
      {"material.poncelet.strength", {"5e6", "1e8"}},
      {"material.poncelet.crater", {"2"}},
      {"material.young.s_number", {"1", "5"}},
      {"material.lambert.coefficient", {"1000", "3000"}},
      {"material.ballistic_limit.speed", {"40", "200"}},
      {"shape.box.half", {"[0.1, 2, 2]", "[0.01, 4, 4]"}},
      {"shape.hull.points", {"[[0, -2, -2], [0, -2, 2], [0, 3, 0], [0.3, 0, 0]]"}},
      {"shape.compound", {"[{ shape = \"round\", position = [0, 1, 0] }]"}},
      {"thing", {"[{ name = \"wall\", shape = \"slab\", position = [5, 1, 0] }]"}},
      {"thing.shape", {"\"round\""}},
      {"thing.material", {"\"wood\"", "\"steel\""}},
      {"thing.position", {"[15, 1, 0]", "[6, 1, 0.2]"}},
      {"thing.layers", {"2"}},
      {"thing.keys",
       {"[{ time = 0, position = [10, 1, 0] }, { time = 0.4, position = [12, 1, 0] }, { time = 1, position = [9, 1, 0] "
        "}]"}},
      {"thing.velocity", {"[2, 0, 0]", "[0, 0, 1]"}},
      {"emitter.shot", {"\"drop\"", "\"tracer\""}},
      {"emitter.position", {"[1, 3, 0]"}},
      {"emitter.motion.keys",
       {"[{ time = 0, position = [0, 2, 0] }, { time = 0.4, position = [2, 3, 0] }, { time = 1, position = [0, 2, 1] "
        "}]"}},
      {"emitter.seed", {"7", "9"}},
      {"emitter.bursts", {"[{ time = 0.1, count = 3 }]"}},
      {"emitter.gun.rounds_per_minute", {"600", "1200"}},
      {"emitter.gun.barrels", {"[{ position = [0, 0, -0.5] }, { position = [0, 0, 0.5] }]"}},
      {"emitter.gun.recoil_up", {"[[0, 0.2], [1, 0.7]]"}},
      {"emitter.gun.recoil_right", {"[[0, 0], [1, 0.7]]"}},
      {"emitter.gun.tracer", {"\"tracer\""}},
      {"emitter.rain.density", {"0.01", "0.05"}},
      {"emitter.rain.size", {"[8, 4, 8]"}},
      {"emitter.start.lifetime", {"0.2", "0.6"}},
      {"emitter.start.colour", {"\"#336699\""}},
      {"emitter.life.colour", {"{ colour = \"#ffffff\", gradient = [[0, \"#ffffff\"], [1, \"#ff000000\"]] }"}},
      {"emitter.life.fast", {"8", "20"}},
      {"emitter.life.size_by_speed", {"[[0, 0.5], [1, 2]]"}},
      {"emitter.life.colour_by_speed", {"[[0, \"#000000\"], [1, \"#ffffff\"]]"}},
      {"emitter.flight.fast", {"8", "20"}},
      {"emitter.flight.drag_by_speed", {"[[0, 0.5], [1, 2]]"}},
      {"emitter.flight.limit", {"3", "1"}},
      {"emitter.flight.noise", {"20"}},
      {"emitter.flight.force", {"0.01"}},
      {"emitter.maximum", {"3", "8"}},
      {"emitter.trail.points", {"2", "9"}},
      {"emitter.trail.time", {"0.05"}},
      {"emitter.sub", {"[{ emitter = \"puff\", on = \"birth\", count = 1 }]"}},
      {"emitter.sub.emitter", {"\"puff\""}},
      {"emitter.sub.age", {"0.1"}},
      {"emitter.sub.inherit_velocity", {"0.5"}},
      {"joint", {"[{ a = \"b\", b = \"a\", length = 1 }]"}},
      {"joint.length", {"0.7", "1.2"}},
      {"study.inputs", {"[\"shot.speed = +- 2 m/s\"]", "[\"shot.elevation = +- 1 mrad\", \"shot.mass = +- 0.01 kg\"]"}},
      {"study.correlated", {"[\"shot.speed with environment.wind.velocity.z = 0.5\"]"}},
      {"study.targets", {"[\"disc: circle 20 cm at 0 m, 0.1 m\"]"}},
      {"study.quantities", {"[\"right\", \"up\", \"speed\"]"}},
      {"study.at", {"[\"20 m\"]"}},
      {"study.aim", {"\"0.1 m, 0.2 m\""}},
      {"study.shots", {"5000", "9000"}},
      {"study.rounds", {"4", "8"}},
      {"study.seed", {"3"}},
      {"tolerance.relative", {"1e-13", "1e-5"}},
      {"tolerance.absolute", {"1e-1", "1e-14"}},
      {"tolerance.step", {"0.01", "0.003"}},
      {"tolerance.position_error", {"0.1", "1e-5"}},
      {"tolerance.max_step", {"0.01", "0.003"}},
      {"tolerance.max_steps", {"5", "9"}},
      {"fidelity.tolerance", {"1e-13", "1e-5"}},
      {"fidelity.cheapest_within", {"0.1", "0.01"}},
      {"until.time", {"0.2", "0.4"}},
      {"until.range", {"12", "6"}},
      {"until.events", {"[{ kind = \"range\", value = 5, terminal = true }]"}},
      {"output.ranges", {"[5, 10, 200]"}},
      {"target.position", {"[100, 5, 2]"}},
      {"target.tolerance", {"0.05"}},
  };
  return all;
}

}  // namespace physim::test

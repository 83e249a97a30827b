// A scenario with a part of every kind that the C interface has handles of.
#pragma once

namespace physim::test {

inline constexpr const char* kOfAll = R"(physim = 1
[[shot]]
name = "ball"
mass = "1 kg"
diameter = "10 cm"
speed = "20 m/s +- 1 m/s"
elevation = "45 deg"
fidelity = "game"
[world]
step = "10 ms"
threads = 1
[[shape]]
name = "box"
box = { half = [1, 1, 1] }
[[thing]]
name = "box"
shape = "box"
position = [5, 0, 0]
[[emitter]]
name = "fountain"
shot = "ball"
[[force]]
name = "lift"
constant_force = { force = [0, 1, 0] }
)";

}  // namespace physim::test

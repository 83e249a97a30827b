// A ball that falls on a slope, as scenarios have it.
#pragma once

#include <string>

namespace physim {

inline const std::string kVacuum = "physim = 1\n[environment]\ngravity = \"constant\"\natmosphere = \"vacuum\"\n";

/// From 5 m above a plane of ice, turned by an angle about z; half of its speed is left by a bounce.
inline std::string ball_over_slope(const std::string& angle) {
  return R"([[material]]
name = "ice"
restitution = 1
friction = 0
[[shape]]
name = "plane"
kind = "plane"
[[thing]]
name = "slope"
shape = "plane"
material = "ice"
rotation = { axis = [0, 0, 1], angle = ")" +
         angle + R"(" }
[[shot]]
name = "ball"
position = [0, "5 m", 0]
speed = 0
fidelity = { preset = "game", integrator = "rk4", precision = "float64", drag = "off" }
body = { restitution = 0.5, friction = 0, collision = { on_hit = "bounce" } }
)";
}

}  // namespace physim

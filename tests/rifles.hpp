// Two rifles as scenarios that tests of studies, cards and ranges share.
#pragma once

#include <string>

namespace physim::test {

/// .308 Winchester, a 168 gr bullet by G7 0.218 lb/in^2 at 2600 ft/s, zeroed at 100 yd. `more`: lines of the shot.
inline std::string rifle308(const std::string& range = "1000 yd", const std::string& more = "") {
  return R"([[shot]]
name = "308"
mass = "168 gr"
diameter = "0.308 in"
)" + more +
         R"(drag = { table = "g7", ballistic_coefficient = "0.218 lb/in^2" }
speed = "2600 ft/s"
sight = { height = "1.5 in", zero_range = "100 yd" }
fidelity = "small_arms"
[until]
ground = "off"
range = ")" +
         range + "\"\n";
}

/// 6.5 Creedmoor, a 140 gr bullet by G7 0.315 lb/in^2 at 2710 ft/s, zeroed at 100 yd. `sight`: more of the sight.
inline std::string creedmoor(const std::string& sight = "") {
  return R"([[shot]]
mass = "140 gr"
diameter = "0.264 in"
length = "1.35 in"
twist = "8 in"
drag = { table = "g7", ballistic_coefficient = "0.315 lb/in^2" }
speed = "2710 ft/s"
sight = { height = "1.5 in", zero_range = "100 yd")" +
         sight + R"( }
fidelity = "small_arms"
[until]
ground = "off"
)";
}

}  // namespace physim::test

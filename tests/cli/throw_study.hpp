// The study that tests of `physim study` fly.
#pragma once

#include <string>

namespace physim::testing_cli {

/// A throw in a vacuum whose speed is uncertain: mean and deviation of where it lands are known.
inline std::string throw_study(int shots, const std::string& more_inputs = "") {
  return R"(physim = 1
title = "A throw"
[environment]
atmosphere = "vacuum"
gravity = { model = "constant", acceleration = "10 m/s^2" }
[[shot]]
name = "ball"
speed = "30 m/s"
elevation = "45 deg"
position = ["0 m", "1e-9 m", "0 m"]
fidelity = { preset = "simulation", earth = "flat" }
[study]
inputs = ["shot.speed = +- 0.3 m/s")" +
         more_inputs + R"(]
targets = ["near: rectangle 1 m x 3.6 m at 0 m, 90 m"]
aim = "0 m, 90 m"
shots = )" +
         std::to_string(shots) + "\n";
}

}  // namespace physim::testing_cli

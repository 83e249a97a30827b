// Files of each kind that a scenario can name, for tests of what is read and what may be written.
#pragma once

#include "cli/program.hpp"
#include "physim/scenario.hpp"

namespace physim::test {

/// Lines of a [[shot]] that flies with motor.eng.
inline constexpr const char* kRocketLines = R"(mass = "57.1 g"
diameter = "24.8 mm"
motor = { file = "motor.eng" }
speed = "10 m/s"
)";

/// Writes motor.eng, and speeds.csv with these lines under "speed [m/s]"; hills.pgm and a mesh with its materials if
/// this build reads such files. Returns the [[shape]] tables that name them.
inline std::string write_named_files(const testing_cli::Folder& folder, const std::string& speeds = "10\n11\n") {
  folder.write("motor.eng", "T 24 70 0 0.0108 0.0231 X\n 1 5\n 2 0\n");
  folder.write("speeds.csv", "speed [m/s]\n" + speeds);
  std::string shapes;
  if (reads_height_maps()) {
    folder.write("hills.pgm", "P5\n2 2\n255\n1234");
    shapes = R"([[shape]]
name = "hills"
height_field = { file = "hills.pgm", spacing_x = "1 m", spacing_z = "1 m" }
)";
  }
  if (!reads_mesh_files()) return shapes;
  folder.write("tent.mtl", "newmtl red\nKd 1 0 0\n");
  folder.write("tent.obj", "mtllib tent.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
  return shapes + "[[shape]]\nname = \"tent\"\nmesh = { file = \"tent.obj\" }\n";
}

}  // namespace physim::test

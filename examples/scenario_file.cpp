// Reads a scenario, changes settings by their paths, flies its shots and runs its world.
#include <physim/scenario.hpp>

#include <cstdio>

#include "physim/physim.hpp"

using namespace physim;

int main() {
  const char* const text = R"(physim = 1
[[shot]]
name = "stone"
mass = "0.5 kg"
diameter = "8 cm"
speed = "20 m/s"
elevation = "40 deg"
drag = { coefficient = 0.47 }
[world]
duration = "4 s"
[[volley]]
shot = "stone"
count = 50
interval = "20 ms"
spread = { horizontal = "2 deg", vertical = "2 deg" }
)";
  auto file = ScenarioFile::parse(text, "stones.toml");  // ScenarioFile::load("stones.toml") reads a file
  if (!file) return std::puts(file.error().text().c_str()), 1;
  for (const char* const speed : {"20 m/s", "60 km/h", "-1 m/s"}) {
    if (const Status set = file->set("shot.speed", speed); !set) {
      std::printf("refused: %s\n", set.error().text().c_str());
      continue;
    }
    const auto flight = file->fly("stone");
    if (!flight || flight->error()) return 1;
    std::printf("%-7s = %s: %.2f m\n", speed, file->get("shot.stone.speed")->c_str(), flight->end().position.x);
  }
  auto run = file->run();
  if (!run) return std::puts(run.error().text().c_str()), 1;
  std::size_t landed = 0;
  for (std::uint64_t i = 0; i < run->steps(); ++i) {
    run->step();
    for (const Event& event : run->world().events()) landed += event.kind == EventKind::landed;
  }
  std::printf("%zu of 50 landed\n", landed);
  return landed == 50 ? 0 : 1;
}

// A million shots on all cores, each in its own wind, as columns of numbers: where do they cross the range line?
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>
#include <vector>

using namespace physim;
using namespace physim::units;

int main() {
  const ProjectileDef bullet{
      .mass = 168_gr, .diameter = 0.308_in, .drag = {.table = DragTable::g7, .ballistic_coefficient = 0.218_lb_in2}};
  constexpr std::size_t kShots = 1'000'000;
  std::vector<double> speed(kShots), crosswind(kShots), drop(kShots), windage(kShots);
  for (std::size_t i = 0; i < kShots;
       ++i) {  // a thousand speeds, evenly over 2700 ft/s +- 20 ft/s, in a thousand winds
    speed[i] = 2680_fps + double(i % 1000) / 1000 * 40_fps;
    crosswind[i] = (double(i / 1000) / 1000 - 0.5) * 4;
  }
  const LaunchColumns launches{.common = {.elevation = 0.3_deg}, .speed = speed};
  const auto threads = make_thread_pool();  // of all cores; an engine lends its own
  const ColumnsResult result =
      fly_columns(bullet, launches, {}, Fidelity::simulation(), {}, {.ground = std::nullopt, .range = 800},
                  {.drop = drop, .windage = windage}, threads.get(), {.wind_z = crosswind});
  if (result.error) return std::puts(result.error->text().c_str()), 1;

  const auto tell = [](const char* what, const std::vector<double>& column) {
    double mean = 0, square = 0;
    for (const double y : column) mean += y / double(kShots);
    for (const double y : column) square += (y - mean) * (y - mean) / double(kShots);
    std::printf("%s at 800 m is %.3f m +- %.3f m\n", what, mean, std::sqrt(square));
  };
  std::printf("%zu shots, %zu refused\n", kShots, result.refused);
  tell("drop", drop);
  tell("windage", windage);
  return result.refused == 0 ? 0 : 1;
}

// A million shots on all cores, as columns of numbers: where do they cross the range line?
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
  std::vector<double> speed(kShots), azimuth(kShots), drop(kShots), windage(kShots);
  for (std::size_t i = 0; i < kShots;
       ++i) {  // a thousand speeds, evenly over 2700 ft/s +- 20 ft/s, in a thousand directions
    speed[i] = 2680_fps + double(i % 1000) / 1000 * 40_fps;
    azimuth[i] = (double(i / 1000) / 1000 - 0.5) * 1e-3;
  }
  const LaunchColumns launches{.common = {.elevation = 0.3_deg}, .speed = speed, .azimuth = azimuth};
  const auto threads = make_thread_pool();  // of all cores; an engine lends its own
  const ColumnsResult result =
      fly_columns(bullet, launches, {}, Fidelity::simulation(), {}, {.ground = std::nullopt, .range = 800},
                  {.drop = drop, .windage = windage}, threads.get());
  if (result.error) return std::puts(result.error->text().c_str()), 1;

  double mean = 0, square = 0;
  for (const double y : drop) mean += y / double(kShots);
  for (const double y : drop) square += (y - mean) * (y - mean) / double(kShots);
  std::printf("%zu shots, %zu refused: drop at 800 m is %.3f m +- %.3f m\n", kShots, result.refused, mean,
              std::sqrt(square));
  return result.refused == 0 ? 0 : 1;
}

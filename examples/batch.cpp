// Ten thousand shots at once: how a spread in muzzle speed becomes a spread on the target.
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>
#include <vector>

using namespace physim;
using namespace physim::units;

int main() {
  const ProjectileDef bullet{
      .mass = 168_gr, .diameter = 0.308_in, .drag = {.table = DragTable::g7, .ballistic_coefficient = 0.218_lb_in2}};
  constexpr int kShots = 10'000;
  std::vector<Launch> launches;
  for (int i = 0; i < kShots; ++i) {
    const double part = (i + 0.5) / kShots;  // speeds spread evenly over 2700 ft/s +- 20 ft/s
    launches.push_back({.speed = 2680_fps + part * 40_fps, .elevation = 0.3_deg});
  }
  const Until until{.ground = std::nullopt, .range = 800};

  const BatchResult batch = fly_batch(bullet, launches, {}, Fidelity::simulation(), {}, until);
  if (batch.error) return std::puts(batch.error->text().c_str()), 1;
  double mean = 0, square = 0;
  for (const ShotResult& shot : batch.shots) mean += shot.position.y / kShots;
  for (const ShotResult& shot : batch.shots) square += (shot.position.y - mean) * (shot.position.y - mean) / kShots;
  std::printf("%d shots flown by the %s kernel: height at 800 m is %.3f m +- %.3f m\n", kShots, batch.kernel.c_str(),
              mean, std::sqrt(square));

  // One by one gives the same numbers, bit for bit.
  int different = 0;
  for (int i = 0; i < kShots; i += 1000) {
    const Flight single = fly(bullet, launches[static_cast<std::size_t>(i)], {}, Fidelity::simulation(), {}, until);
    if (single.end().position != batch.shots[static_cast<std::size_t>(i)].position) ++different;
  }
  std::printf("%d of 10 single flights differ\n", different);
  return different == 0 ? 0 : 1;
}

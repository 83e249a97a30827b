// Zero a rifle in calm air, then let a crosswind blow: how far to hold off at 600 m.
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  const ProjectileDef bullet{
      .mass = 168_gr, .diameter = 0.308_in, .drag = {.table = DragTable::g7, .ballistic_coefficient = 0.218_lb_in2}};
  const Launch launch{.speed = 2700_fps, .sight = {.height = 1.5_in, .zero_range = 200_m, .zero_in_calm_air = true}};
  const Until until{.ground = std::nullopt, .range = 600};

  Environment windy;
  windy.wind.velocity = {0, 0, -4};  // velocity of the air [m/s]: from the right
  const Flight flight = fly(bullet, launch, windy, Fidelity::small_arms(), {}, until);
  if (flight.error()) return std::puts(flight.error()->text().c_str()), 1;

  const Sample end = flight.end();
  std::printf("at %.0f m: %.3f m low, %.3f m to the left; hold %.2f mrad right\n", end.range, -end.drop, -end.windage,
              -1000 * end.windage / end.range);

  // Didion's lag rule: a steady crosswind drifts a bullet by w (t - x / v0).
  const double lag_rule = -4 * (end.time - 600 / 2700_fps);
  std::printf("Didion's lag rule says %.3f m\n", -lag_rule);
  return std::abs(end.windage - lag_rule) < 2_cm ? 0 : 1;
}

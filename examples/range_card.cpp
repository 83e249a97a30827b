// A range card: drop, time and speed of a rifle zeroed at 100 m, to 1000 m.
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  const ProjectileDef bullet{.mass = 168_gr,
                             .diameter = 0.308_in,
                             .length = 1.226_in,
                             .twist = 12_in,
                             .drag = {.table = DragTable::g7, .ballistic_coefficient = 0.218_lb_in2}};
  const Launch launch{.speed = 2700_fps, .sight = {.height = 1.5_in, .zero_range = 100_m}};
  const Until until{.ground = std::nullopt, .range = 1010};

  const Flight flight = fly(bullet, launch, {}, Fidelity::small_arms(), {}, until);
  if (flight.error()) return std::puts(flight.error()->text().c_str()), 1;
  std::printf("bore elevation %.3f mrad\n", flight.elevation() * 1000);
  std::puts("range [m]  drop [m]  drift [m]  time [s]  speed [m/s]  mach [-]  energy [J]");
  for (double range = 100; range <= 1000; range += 100) {
    const auto s = flight.at_range(range);
    if (!s) return std::puts(s.error().text().c_str()), 1;  // it came down before
    std::printf("%9.0f %9.2f %10.2f %9.3f %12.1f %9.3f %11.0f\n", range, s->drop, s->windage, s->time, s->speed,
                s->mach, s->energy);
  }
  const auto zero = flight.at_range(100);
  return zero && std::abs(zero->drop) < 0.1_mm ? 0 : 1;  // the zero is a zero
}

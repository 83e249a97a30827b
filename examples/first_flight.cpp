// First flight: say what flies, how it starts, where, and how accurately; then ask the flight anything.
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  const ProjectileDef bullet{
      .mass = 175_gr, .diameter = 7.82_mm, .drag = {.table = DragTable::g7, .ballistic_coefficient = 0.243_lb_in2}};
  const Launch launch{.speed = 800_mps, .elevation = 2_deg};
  const Environment environment;  // standard atmosphere at sea level, no wind

  const Flight flight = fly(bullet, launch, environment, Fidelity::simulation());
  if (flight.error()) return std::puts(flight.error()->text().c_str()), 1;

  if (const auto at = flight.at_range(600))  // any range or time, without flying again; false if it lands before
    std::printf("at 600 m: %.2f m high, %.1f m/s, Mach %.2f\n", at->position.y, at->speed, at->mach);
  const Sample end = flight.end();
  std::printf("it lands after %.2f s, %.1f m downrange\n", flight.duration(), end.range);

  // Raising the fidelity changes nothing but this one argument.
  const Flight exact = fly(bullet, launch, environment, Fidelity::reference());
  const double error = length(end.position - exact.end().position);
  std::printf("that is %.2g mm from the reference\n", error * 1000);
  return error < 1_mm ? 0 : 1;
}

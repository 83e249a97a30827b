// The smallest program with a flight: what it holds of the library is held to a size.
#include <physim/flight.hpp>

#include <cstdio>

int main() {
  using namespace physim;
  const ProjectileDef bullet{
      .mass = 0.0113, .diameter = 0.00782, .drag = {.table = DragTable::g7, .ballistic_coefficient = 170}};
  const Flight flight = fly(bullet, {.speed = 800, .elevation = 0.03}, {}, Fidelity::simulation());
  std::printf("%s\n", flight.outcome() == Outcome::landed ? "landed" : "not landed");
}

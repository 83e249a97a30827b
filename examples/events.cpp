// Events: exact times at which something happens, found on the dense output; one of them ends the flight.
#include <cmath>
#include <cstdio>
#include <physim/names.hpp>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  const ProjectileDef shell{.mass = 43_kg, .diameter = 155_mm, .drag = {.table = DragTable::g7}};
  const Launch launch{.speed = 600_mps, .elevation = 50_deg};
  Until until;
  until.events = {
      {.kind = EventKind::mach, .value = 1},  // in any direction
      {.kind = EventKind::height, .value = 5000, .direction = Crossing::rising},
      {.kind = EventKind::height, .value = 1000, .direction = Crossing::falling, .terminal = true},
  };

  const Flight flight = fly(shell, launch, {}, Fidelity::artillery(), {}, until);
  if (flight.error()) return std::puts(flight.error()->text().c_str()), 1;
  for (const Event& event : flight.events())
    std::printf("%8.4f s  %-6s %6g  %-7s  x %8.1f m  y %7.1f m  vy %7.2f m/s\n", event.time, name(event.kind).data(),
                event.value, name(event.direction).data(), event.position.x, event.position.y, event.velocity.y);
  std::printf("outcome: %s\n", name(flight.outcome()).data());
  const bool ended_there = std::abs(flight.end().position.y - 1000) < 1e-6;
  return flight.outcome() == Outcome::event && ended_there ? 0 : 1;
}

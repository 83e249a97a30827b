// Flies a shot of the core and one of a scenario; every installed header compiles.
#include <physim/physim.hpp>
#include <physim/scenario.hpp>

#include <cstdio>

int main() {
  using namespace physim;
  const Flight flight = fly({.mass = 1, .diameter = 0.1}, {.speed = 100, .elevation = 0.5}, {}, Fidelity::game());
  const auto scenario = ScenarioFile::parse("physim = 1\n[[shot]]\nmass = \"1 kg\"\nspeed = \"100 m/s\"\n", "text");
  if (flight.error() || !scenario) return 1;
  const Flight shot = *scenario->fly();
  std::printf("%s %s\n", flight.outcome() == Outcome::landed ? "landed" : "not landed",
              shot.error() ? "refused" : "flown");
  return 0;
}

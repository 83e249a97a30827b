// A model rocket: a motor's thrust by time, a launch rail, and what happens on the way up.
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  ProjectileDef rocket{
      .mass = 57.1_g, .diameter = 24.8_mm, .drag = {.coefficient = 0.75}};  // the motor's 23.1 g included
  rocket.motor = {.name = "C", .propellant_mass = 10.8_g};
  rocket.motor.thrust = {{0, 0}, {0.19, 14.1}, {0.25, 6.2}, {0.5, 4.4}, {1.82, 4.4}, {1.86, 0}};  // time [s], force [N]
  std::printf("motor: %.2f N s in %.2f s, specific impulse %.1f s\n", total_impulse(rocket.motor),
              burn_time(rocket.motor), specific_impulse(rocket.motor));

  const Launch launch{.elevation = 85_deg, .rail_length = 0.9_m};
  Environment breeze;
  breeze.wind.velocity = {0, 0, 3};  // from the left; the rocket flies with its nose into the air that it meets
  const Flight flight = fly(rocket, launch, breeze, Fidelity::constant_air());

  for (const Event& e : flight.events()) {
    const Sample s = flight.at(e.time);
    const std::string kind(name(e.kind));
    std::printf("%-10s %6.2f s  height %6.1f m  %6.2f m/s  %5.1f g\n", kind.c_str(), e.time, s.position.y, s.speed,
                1000 * s.mass);
  }
  std::printf("drift: %.1f m to the right\n", flight.end().position.z);
}

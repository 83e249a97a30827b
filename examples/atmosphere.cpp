// The air: standard, a weather station's reading, and what both do to a bullet.
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

double height_at_800_m(const Environment& environment) {
  const ProjectileDef bullet{
      .mass = 168_gr, .diameter = 0.308_in, .drag = {.table = DragTable::g7, .ballistic_coefficient = 0.218_lb_in2}};
  const Launch launch{.speed = 2700_fps, .elevation = 0.4_deg};
  return fly(bullet, launch, environment, Fidelity::simulation(), {}, {.ground = std::nullopt, .range = 800})
      .end()
      .position.y;
}

int main() {
  const Environment standard;
  std::puts("US Standard Atmosphere 1976");
  for (const double altitude : {0.0, 5000.0, 11000.0, 20000.0}) {
    const auto air = air_at(standard, altitude);
    if (!air) return std::puts(air.error().text().c_str()), 1;  // there is none at this altitude
    std::printf("  %5.0f m: %6.2f K, %9.1f Pa, %.5f kg/m^3, sound %.2f m/s\n", altitude, air->temperature,
                air->pressure, air->density, air->sound_speed);
  }

  Environment mountain;
  mountain.altitude = 1500;
  mountain.atmosphere.temperature = 30_degC;  // what the station shows, not reduced to sea level
  mountain.atmosphere.pressure = 850_hPa;
  mountain.atmosphere.humidity = 0.4;
  const auto air = air_at(mountain, 1500);
  if (!air) return std::puts(air.error().text().c_str()), 1;
  std::printf("a hot day in the mountains: %.4f kg/m^3, sound %.2f m/s\n", air->density, air->sound_speed);

  const double rise = height_at_800_m(mountain) - height_at_800_m(standard);
  std::printf("the bullet arrives %.2f m higher at 800 m\n", rise);
  const auto at_sea = air_at(standard, 0);
  const bool standard_is_standard = at_sea && std::abs(at_sea->density - 1.2250) < 5e-5;
  return standard_is_standard && rise > 0 ? 0 : 1;
}

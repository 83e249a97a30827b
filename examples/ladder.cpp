// The ladder of fidelity: the same shot at every preset, and how far each lands from the reference.
#include <cstdio>
#include <physim/names.hpp>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  const ProjectileDef bullet{.mass = 168_gr,
                             .diameter = 0.308_in,
                             .length = 1.226_in,
                             .twist = 12_in,
                             .drag = {.table = DragTable::g7, .ballistic_coefficient = 0.218_lb_in2}};
  const Launch launch{.speed = 2700_fps, .elevation = 0.2_deg};
  Environment environment;
  environment.wind.velocity = {0, 0, -2};
  environment.earth = {.latitude = 45_deg, .azimuth = 90_deg};
  const Until until{.ground = std::nullopt, .range = 600};

  const Flight truth = fly(bullet, launch, environment, Fidelity::reference(), {}, until);
  double errors[2] = {};
  for (const char* preset : {"arcade", "game", "constant_air", "small_arms", "artillery", "simulation", "reference"}) {
    const Flight flight = fly(bullet, launch, environment, *fidelity_preset(preset), {}, until);
    const double error = length(flight.end().position - truth.end().position);
    std::printf("%-10s %8.2g m off, %5lld evaluations\n", preset, error,
                static_cast<long long>(flight.cost().evaluations));
    errors[0] = errors[1], errors[1] = error;

    // What was asked for may be more than there is to model: the answer says what was granted, and why.
    for (const FidelityNote& note : flight.fidelity_in_use().notes)
      std::printf("             %s: %s (%s)\n", note.effect.c_str(), note.granted.c_str(), note.reason.c_str());
  }
  const double simulation = errors[0], reference = errors[1];
  return reference == 0 && simulation < 1e-5 ? 0 : 1;
}

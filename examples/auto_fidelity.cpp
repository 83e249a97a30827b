// Auto fidelity: says how far off a flight may be, and gets the cheapest models that keep to it.
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

  const auto chosen = cheapest_within(bullet, launch, environment, {.error = 1_cm, .time = 1});
  if (!chosen) return std::puts(chosen.error().text().c_str()), 1;
  std::puts(chosen->explanation().c_str());

  // Every flight that was measured on the way: what each effect is worth, lowered alone.
  for (const FidelityTrial& trial : chosen->trials)
    if (!trial.lowered.empty() && trial.lowered != "integrator")
      std::printf("%-8s drag %-16s air %-11s %9.2g m off\n", trial.lowered.c_str(), name(trial.fidelity.drag).data(),
                  name(trial.fidelity.air).data(), trial.error);

  // The same question for many: one computation for each kind of projectile and class of launch.
  AutoFidelityCache cache;
  for (int i = 0; i < 1000; ++i) {
    const Launch burst{.speed = 800 + 0.02 * i, .elevation = 0.2_deg};
    const auto answer = cache.cheapest_within(bullet, burst, environment, {.error = 10_cm, .time = 1});
    if (!answer) return std::puts(answer.error().text().c_str()), 1;
  }
  std::printf("1000 shots, %d computed\n", static_cast<int>(cache.computed()));

  // Flown as it was measured, beside the reference; the flight tells how its fidelity was chosen.
  const Until until{.ground = std::nullopt, .time = 1};
  const Flight flight = fly_chosen(bullet, launch, environment, *chosen, until);
  const Flight truth = fly(bullet, launch, environment, Fidelity::reference(), {}, until);
  const double error = length(flight.end().position - truth.end().position);
  const FidelityNote& note = flight.fidelity_in_use().notes.back();
  std::printf("%s (%s), in the end %.2g m off\n", note.granted.c_str(), note.asked.c_str(), error);
  return error <= 1_cm && cache.computed() == 1 ? 0 : 1;
}

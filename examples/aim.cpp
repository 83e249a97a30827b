// Hit a target: the low and the high way to a moving boat, the farthest shot, and a coefficient from a chronograph.
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  const ProjectileDef shell{.mass = 15_kg, .diameter = 105_mm, .drag = {.table = DragTable::g1, .form_factor = 0.95}};
  Environment environment;
  environment.wind.velocity = {3, 0, -5};  // velocity of the air [m/s]

  const Target boat{.position = {4200, -20, 300}, .velocity = {-4, 0, 9}};
  const auto answer = aim(shell, {.speed = 350}, environment, Fidelity::simulation(), boat);
  if (!answer) return std::puts(answer.error().text().c_str()), 1;
  std::puts(answer->explanation().c_str());
  if (!answer->low) return 1;

  const AimSolution& s = *answer->low;  // flown already: its miss is measured, not promised
  std::printf("low: %.4f deg up, %.4f deg right, %.2f s, hits at %.0f m/s, %.1f mm off, after %d trajectories\n",
              s.launch.elevation / 1_deg, s.launch.azimuth / 1_deg, s.time, s.speed, 1000 * s.miss,
              static_cast<int>(s.flights));
  const Flight flight = fly(shell, s.launch, environment, Fidelity::simulation(), {}, {.ground = {}, .time = s.time});
  const double miss = length(flight.end().position - boat.at(s.time));

  const auto far = max_range(shell, {.speed = 350}, environment, Fidelity::simulation());
  if (!far) return std::puts(far.error().text().c_str()), 1;
  std::printf("farthest: %.0f m at %.1f deg\n", far->range, far->elevation / 1_deg);

  const Measurement chronograph[] = {
      {.range = 200_m, .speed = 338.9}, {.range = 500_m, .speed = 323.5}, {.range = 800_m, .speed = 312.2}};
  const auto fit = fit_drag(shell, {.speed = 350, .elevation = 1_deg}, {}, Fidelity::simulation(), chronograph);
  if (!fit) return std::puts(fit.error().text().c_str()), 1;
  std::printf("form factor: %.3f +- %.3f\n", fit->projectile.drag.form_factor,
              fit->projectile.drag.form_factor * fit->scale_error / fit->scale);
  return miss < 2_cm ? 0 : 1;
}

// Wind and a force of your own, by place and time: a seed in a thermal that comes in gusts, held by a thread.
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  Environment meadow;
  // A column of rising air, 5 m wide, that swells every 8 s. [m/s]
  meadow.wind.field = [](const WindBatch& batch) {
    for (std::size_t i = 0; i < batch.time.size(); ++i) {
      const Vec3d& x = batch.position[i];
      const double out = (x.x * x.x + x.z * x.z) / (5.0 * 5.0);
      const double swell = 1 + 0.5 * std::sin(batch.time[i] * 2 * 3.1416 / 8);
      batch.velocity[i] = {0.2, 1.2 * swell * std::exp(-out), 0};
    }
  };
  // A thread of 3 m from the origin: nothing while it is slack, then a spring. [N]
  meadow.force = [](const FieldForceBatch& batch) {
    for (std::size_t i = 0; i < batch.time.size(); ++i) {
      const double away = length(batch.position[i]);
      if (away > 3) batch.force[i] = batch.position[i] * (-1e-4 * (away - 3) / away);
    }
  };

  // It falls with 0.3 m/s in still air: k1 = m g / 0.3 m/s.
  ProjectileDef seed{.mass = 0.6e-6_kg, .drag = {.k1 = 0.6e-6 * 9.80665 / 0.3}};
  seed.fidelity = {
      .integrator = Integrator::rk4, .gravity = GravityModel::constant, .drag = DragModel::linear_quadratic};
  const Launch launch{.position = {0, 0.5, 0}};
  const Flight flight =
      fly(seed, launch, meadow, seed.fidelity, {.step = 1.0 / 240}, {.ground = std::nullopt, .time = 20});

  // In a world the functions are asked for its time; everybody meets a gust at the same moment.
  World world = World::create({.environment = meadow, .ground = {.mode = GroundMode::none}}).value();
  const ProjectileId id = *world.spawn(seed, launch);
  for (int i = 0; i < 20 * 240; ++i) world.step(1.0 / 240);

  const Vec3d end = flight.end().position;
  std::printf("after 20 s it hangs at (%.3f, %.3f, %.3f) m, %.3f m from its peg\n", end.x, end.y, end.z, length(end));
  return end == world[id].position() && length(end) > 3 && length(end) < 3.5 ? 0 : 1;
}

// A force of your own: one function for a whole batch of projectiles, evaluated in every stage of the integrator.
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  WorldDef def;
  def.environment.gravity.model = GravityModel::off;
  def.environment.atmosphere.model = AirModel::vacuum;
  def.ground.mode = GroundMode::none;
  World world = World::create(def).value();

  ProjectileDef particle{.mass = 2_kg};
  particle.fidelity = Fidelity::constant_air();  // RK4
  const double speed = 3, turns_per_second = 0.25, omega = 2 * 3.14159265358979 * turns_per_second;
  const ProjectileId id = *world.spawn(particle, {.velocity = Vec3d{speed, 0, 0}});

  // A magnetic field along y: F = m omega v x y, which bends every path into a circle.
  const auto bend = [omega](const ForceBatch& batch) {
    for (std::size_t i = 0; i < batch.id.size(); ++i)
      batch.force[i] += cross(batch.velocity[i], Vec3d{0, 1, 0}) * (omega * batch.mass[i]);
  };
  const auto field = world.add_force({.law = CustomForce{bend}, .target = ForceTarget::everything()});
  if (!field) return std::puts(field.error().text().c_str()), 1;

  const int steps = 240;  // of 1/60 s: one turn
  double widest = 0;
  for (int i = 0; i < steps; ++i) {
    world.single_step();
    widest = std::fmax(widest, length(world[id].position()));
  }
  const double error = length(world[id].position());
  std::printf("a circle of diameter %.4f m (exact: %.4f), closed to %.2g mm\n", widest, 2 * speed / omega,
              error * 1000);
  return error < 1_mm ? 0 : 1;
}

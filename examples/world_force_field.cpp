// Force fields: generators that act on all, on a layer or on one projectile, until they are removed or over.
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

  constexpr std::uint32_t kMetal = 2;
  ProjectileDef ball{.mass = 1_kg, .diameter = 10_cm};
  ball.fidelity = Fidelity::constant_air();  // forces need motion `force`: closed forms do not feel them
  const BodyDef metal{.layers = kMetal};
  const double r = 10, v = 2;
  const ProjectileId moon = *world.spawn(ball, {.position = {r, 0, 0}, .velocity = Vec3d{0, v, 0}}, metal);
  const ProjectileId wood = *world.spawn(ball, {.position = {-r, 0, 0}});

  const ForceId magnet = *world.add_force({.law = PointAttractor{.centre = {}, .strength = r * v * v},
                                           .target = {.ids = {}, .kind = {}, .layers = kMetal}});
  world.add_force({.law = Explosion{.centre = {-r, -1, 0}, .force = 500, .radius = 5},
                   .target = ForceTarget::everything(),
                   .delay = 1,
                   .duration = 0.1});

  const double turn = 2 * 3.14159265358979 * r / v;  // of the orbit that the magnet keeps up [s]
  while (world.time() < turn - 1e-9) world.step(turn / 2000);
  const double error = length(world[moon].position() - Vec3d{r, 0, 0});
  std::printf("the moon is back to %.2g mm after a turn of %.2f s\n", error * 1000, turn);
  std::printf("the explosion left wood flying at %.2f m/s\n", world[wood].velocity().y);

  world.remove_force(magnet);
  const Vec3d free = world[moon].velocity();
  world.step(0.1);
  const bool is_free = world[moon].velocity() == free;
  std::printf("without the magnet the moon flies straight on: %s\n", is_free ? "yes" : "no");
  return error < 1_mm && world[wood].velocity().y > 1 && is_free ? 0 : 1;
}

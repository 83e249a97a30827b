// A space game with invented physics: a planet that pulls, a drag that limits ships where no air is, missiles that turn
// no faster than the rules allow, and a map whose edges meet.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>
#include <vector>

using namespace physim;

namespace {

constexpr double kPi = 3.14159265358979;
constexpr double kWidth = 100, kHeight = 60;      // of the map, whose middle is the origin [m]
constexpr std::uint32_t kMissile = 2, kMoon = 4;  // layers
constexpr double kTurnRate = 3;                   // of missiles [rad/s]

/// The shortest of all ways that are equal to `way` on a map whose edges meet.
Vec3d shortest(const Vec3d& way) {
  return {way.x - kWidth * std::round(way.x / kWidth), way.y - kHeight * std::round(way.y / kHeight), way.z};
}

/// What left the map at one edge is at the other one.
void wrap(World& world, std::vector<ProjectileId>& ids) {
  world.ids(ids);
  for (const ProjectileId id : ids) {
    const Vec3d at = world[id].position(), inside = shortest(at);
    if (inside != at) world[id].set_position(inside);
  }
}

/// Turns what it acts on towards a target that flies straight within a step, at a steady speed: the force is across the
/// velocity, m v times a turn rate that is largest from ten degrees off the target on.
CustomForce homing(const World& world, ProjectileId target) {
  return {[&world, target](const ForceBatch& batch) {
    const BodyState seen = world[target].state();  // as the step began; a stage of it may be later
    if (!world[target].is_alive()) return;
    const Vec3d aim = seen.position + seen.velocity * (batch.time - world.time());
    for (std::size_t i = 0; i < batch.id.size(); ++i) {
      const Vec3d way = shortest(aim - batch.position[i]), v = batch.velocity[i];
      const Vec3d across = way - v * (dot(way, v) / dot(v, v));
      const double off = length(across);
      if (off == 0) continue;
      const double angle = std::atan2(off, dot(way, v) / length(v));
      const double rate = kTurnRate * std::min(1.0, angle / (10 * kPi / 180));
      batch.force[i] += across * (batch.mass[i] * length(v) * rate / off);
    }
  }};
}

/// No gravity and no air: what acts is invented.
World space() {
  WorldDef def;
  def.environment.gravity.model = GravityModel::off;
  def.environment.atmosphere.model = AirModel::vacuum;
  def.ground.mode = GroundMode::none;
  return std::move(World::create(def).value());
}

/// Rungs of games, by Runge and Kutta's method.
Fidelity steered() {
  Fidelity f = Fidelity::game();
  f.motion = Motion::force;
  f.integrator = Integrator::rk4;
  f.precision = Precision::float64;
  f.drag = DragModel::linear_quadratic;  // the invented one: F = -(k1 + k2 |v|) v
  return f;
}

/// A ship under full thrust: its speed is v tanh(F t / (m v)) with the top speed v = sqrt(F / k2).
bool ship_has_a_top_speed() {
  World world = space();
  ProjectileDef ship{.mass = 1000, .fidelity = steered()};
  ship.drag.k2 = 20;
  const ProjectileId id = world.spawn(ship, {.speed = 0}, {.frozen = Axes::z}).value();
  const ForceId engine = world[id].add_force(ConstantForce{{8000, 0, 0}}).value();
  double off = 0;
  for (int step = 1; step <= 600; ++step) {
    world.single_step();
    off = std::max(off, std::abs(world[id].velocity().x - 20 * std::tanh(8.0 / 20 * step / 60)));
  }
  const double top = world[id].velocity().x;
  world[id].remove_force(engine);
  for (int step = 0; step < 60; ++step) world.single_step();
  const double coasting = world[id].velocity().x, expected = top / (1 + 0.02 * top * 1);
  std::printf("ship: top speed %.2f m/s, within %.0e of the formula; a second later %.2f m/s\n", top, off, coasting);
  return off < 1e-6 && std::abs(coasting - expected) < 1e-6;
}

/// A moon on a circle about the planet; nothing else feels the planet.
bool planet_pulls_its_moon() {
  World world = space();
  const double r = 12, v = 6, turn = 2 * kPi * r / v;
  const ForceDef planet{.law = PointAttractor{.strength = r * v * v},
                        .target = {.ids = {}, .kind = {}, .layers = kMoon}};
  if (!world.add_force(planet)) return false;
  const ProjectileDef rock{.mass = 50, .fidelity = steered()};
  const ProjectileId moon =
      world.spawn(rock, {.position = {r, 0, 0}, .velocity = Vec3d{0, v, 0}}, {.layers = kMoon}).value();
  const ProjectileId dust = world.spawn(rock, {.position = {-r, 0, 0}, .velocity = Vec3d{0, v, 0}}).value();
  for (int step = 0; step < 1000; ++step) world.step(turn / 1000);
  const double moon_off = length(world[moon].position() - Vec3d{r, 0, 0});
  const double dust_off = length(world[dust].position() - Vec3d{-r, v * turn, 0});
  std::printf("planet: its moon is back within %.0e m after a turn, dust flew straight on within %.0e m\n", moon_off,
              dust_off);
  return moon_off < 1e-3 && dust_off < 1e-9;
}

/// A missile whose target is behind it flies a circle of radius v / rate.
bool missile_turns_on_a_circle() {
  World world = space();
  const double v = 30, r = v / kTurnRate;
  const ProjectileId target = world.spawn({.mass = 1}, {.position = {-40, 20, 0}}, {.kinematic = true}).value();
  const ProjectileId missile = world.spawn({.mass = 20, .fidelity = steered()}, {.velocity = Vec3d{v, 0, 0}}).value();
  if (!world[missile].add_force(homing(world, target))) return false;
  double off = 0;
  for (int step = 1; step <= 30; ++step) {
    world.single_step();
    const double turned = kTurnRate * step / 60;
    off = std::max(off, length(world[missile].position() - Vec3d{r * std::sin(turned), r - r * std::cos(turned), 0}));
  }
  std::printf("missile: on its circle of %.0f m within %.0e m\n", r, off);
  return off < 1e-3;
}

/// Ship and missile near opposite edges: the short way is through them.
bool missile_takes_the_short_way() {
  World world = space();
  const BodyDef met{.collision = {.radius = 1, .others = kMissile}};
  const BodyDef fired{.collision = {.radius = 0.2, .others = 1}, .layers = kMissile};
  const ProjectileId ship =
      world.spawn({.mass = 1000, .fidelity = steered()}, {.position = {-40, 5, 0}, .velocity = Vec3d{0, 8, 0}}, met)
          .value();
  const ProjectileId missile =
      world.spawn({.mass = 20, .fidelity = steered()}, {.position = {40, 0, 0}, .velocity = Vec3d{0, -30, 0}}, fired)
          .value();
  if (!world[missile].add_force(homing(world, ship))) return false;
  std::vector<ProjectileId> ids;
  double slowest = 30, fastest = 30, hit = 0;
  while (world.time() < 3 && hit == 0) {
    world.single_step();
    for (const Event& event : world.events())
      if (event.kind == EventKind::hit && event.id == missile && event.other == ship) hit = event.time;
    if (const double speed = length(world[missile].velocity()); hit == 0)
      slowest = std::min(slowest, speed), fastest = std::max(fastest, speed);
    wrap(world, ids);
  }
  std::printf("missile: hit through the edge after %.2f s; its speed stayed within %.0e m/s\n", hit, fastest - slowest);
  return hit > 0.5 && hit < 2 && fastest - slowest < 0.01;  // across the map it is 80 m: 2.6 s
}

/// A bolt that crosses edges: where it is follows from its launch, and what is drawn between steps never jumps back.
bool bolt_wraps() {
  World world = space();
  const Vec3d v{35, 17, 0};
  Fidelity straight = Fidelity::arcade();
  straight.precision = Precision::float64;
  const ProjectileId bolt = world.spawn({.mass = 1, .fidelity = straight}, {.velocity = v}).value();
  std::vector<ProjectileId> ids;
  double off = 0, drawn_off = 0;
  int crossings = 0;
  for (int frame = 1; frame <= 1440; ++frame) {  // 144 frames a second, 60 steps
    if (world.advance(1.0 / 144) > 0) {
      const Vec3d before = world[bolt].position();
      wrap(world, ids);
      if (world[bolt].position() != before) ++crossings;
    }
    off = std::max(off, length(shortest(world[bolt].position() - v * world.time())));
    const double drawn_at = std::max(0.0, world.time() - (1 - world.fraction()) / 60);  // one step late
    drawn_off = std::max(drawn_off, length(shortest(world[bolt].render_position() - v * drawn_at)));
  }
  std::printf("bolt: %d times over an edge, within %.0e m of its way, drawn within %.0e m\n", crossings, off,
              drawn_off);
  return crossings == 6 && off < 1e-9 && drawn_off < 1e-9;
}

}  // namespace

int main() {
  const bool all[] = {ship_has_a_top_speed(), planet_pulls_its_moon(), missile_turns_on_a_circle(),
                      missile_takes_the_short_way(), bolt_wraps()};
  return std::all_of(std::begin(all), std::end(all), [](bool is_right) { return is_right; }) ? 0 : 1;
}

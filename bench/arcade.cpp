// Invented physics: what the laws of docs/arcade.md cost in a world.
#include <cmath>

#include "world_bench.hpp"

namespace physim::bench {
namespace {

constexpr double kMap = 1000;  // edge of a square map about the origin [m]

WorldDef space() {
  WorldDef def = free_flight();
  def.environment.gravity.model = GravityModel::off;
  def.environment.atmosphere.model = AirModel::vacuum;
  return def;
}

Fidelity steered(Precision precision, Integrator integrator) {
  Fidelity f = Fidelity::game();
  f.drag = DragModel::linear_quadratic;
  f.integrator = integrator;
  f.precision = precision;
  return f;
}

SteppedWorld ships(std::string name, const Fidelity& fidelity, const std::vector<ForceLaw>& laws = {}) {
  World world = std::move(World::create(space()).value());
  ProjectileDef ship{.mass = 1000, .fidelity = fidelity};
  ship.drag.k2 = 20;
  ship.drag.damping = 0.5;
  const KindId kind = *world.add_kind(ship, {.can_sleep = false});
  world.reserve(kind, kStepped);
  for (std::size_t i = 0; i < kStepped; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(kStepped);
    world.spawn(kind,
                {.position = {kMap * (part - 0.5), 400, 0}, .velocity = Vec3d{20 * part - 10, 15 - 30 * part, 0}});
  }
  for (const ForceLaw& law : laws) (void)world.add_force({.law = law, .target = ForceTarget::everything()}).value();
  return {std::move(name), std::move(world)};
}

/// As a PointAttractor in the middle of the map, but of the environment: no generator pushes.
Environment planet_of_environment(double strength) {
  Environment place = space().environment;
  place.force = [strength](const FieldForceBatch& batch) {
    for (std::size_t i = 0; i < batch.mass.size(); ++i) {
      const double r = length(batch.position[i]);
      if (r > 0) batch.force[i] = batch.position[i] * (-strength * batch.mass[i] / (r * r * r));
    }
  };
  return place;
}

/// Towards the middle of the map, across the velocity.
CustomForce homing() {
  return {[](const ForceBatch& batch) {
    for (std::size_t i = 0; i < batch.id.size(); ++i) {
      const Vec3d v = batch.velocity[i], way = batch.position[i] * -1.0;
      const Vec3d across = way - v * (dot(way, v) / dot(v, v));
      const double off = length(across);
      if (off > 0) batch.force[i] += across * (batch.mass[i] * length(v) / off);
    }
  }};
}

/// Who left the map comes in at the other edge: all are looked at in each step, few jump.
SteppedWorld wrapped(std::string name, const Fidelity& fidelity) {
  SteppedWorld w = ships(std::move(name), fidelity);
  w.step = [ids = std::vector<ProjectileId>()](World& world) mutable {
    world.step(kFrame);
    world.ids(ids);
    for (const ProjectileId id : ids) {
      const Vec3d at = world[id].position();
      const Vec3d inside{at.x - kMap * std::round(at.x / kMap), at.y - kMap * std::round(at.y / kMap), at.z};
      if (inside != at) world[id].set_position(inside);
    }
  };
  return w;
}

}  // namespace

Section arcade_section(const Options& options) {
  Fidelity debris = Fidelity::arcade();
  debris.drag = DragModel::damping;
  const Fidelity rough = steered(Precision::float32, Integrator::semi_implicit_euler);
  const Fidelity fine = steered(Precision::float64, Integrator::rk4);
  const ConstantForce engine{{8000, 0, 0}};
  const PointAttractor planet{.strength = 500};
  std::vector<SteppedWorld> worlds;
  worlds.push_back(ships("space drag, semi-implicit Euler, float32", rough));
  worlds.push_back(ships("bolts: closed form, nobody looks", Fidelity::arcade()));
  worlds.push_back(ships("debris: closed form with damping, nobody looks", debris));
  worlds.push_back(ships("space drag, RK4, double", fine));
  worlds.push_back(ships("... and an engine, Euler", rough, {engine}));
  worlds.push_back(ships("... and an engine, RK4", fine, {engine}));
  worlds.push_back(ships("... an engine and a planet, RK4", fine, {engine, planet}));
  for (const auto& [name, fidelity] : {std::pair{"... a planet by Environment::force, Euler", rough},
                                       std::pair{"... a planet by Environment::force, RK4", fine}}) {
    worlds.push_back(ships(name, fidelity));
    (void)worlds.back().world.set_environment(0, planet_of_environment(500));
  }
  worlds.push_back(ships("... homing by a function, Euler", rough, {homing()}));
  worlds.push_back(ships("... homing by a function, RK4", fine, {homing()}));
  worlds.push_back(wrapped("space drag, Euler, and a map whose edges meet", rough));
  Section s = steps_section(std::move(worlds), "drag", "law", options);
  s.title = "Worlds: invented physics";
  s.notes = {"Generators act on all of them. A map whose edges meet: each is read by its id after the step."};
  return s;
}

}  // namespace physim::bench

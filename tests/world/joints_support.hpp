// Bodies that joints hold, for tests.
#pragma once

#include "world/pairs_support.hpp"

namespace physim::test_joints {

using test_pairs::put;
using test_pairs::space;

inline constexpr double kGravity = 9.80665;
inline constexpr double kPi = 3.14159265358979323846;

/// Constant gravity, no air.
inline WorldDef falling() {
  WorldDef def = space();
  def.environment.gravity.model = GravityModel::constant;
  return def;
}

/// Without drag, flown to order 2 and above.
inline ProjectileDef mass_of(double mass, Precision precision = Precision::float64) {
  ProjectileDef p;
  p.mass = mass;
  p.fidelity = test::vacuum(Integrator::heun);
  p.fidelity.precision = precision;
  return p;
}

inline BodyDef bob() { return {.can_sleep = false}; }
inline BodyDef weightless() {
  BodyDef body = bob();
  body.gravity_scale = 0;
  return body;
}

inline JointId join(World& world, const Joint& joint) { return must(world.add_joint(joint)); }

/// Kinetic energy, and potential energy in constant gravity [J].
inline double energy(const World& world, std::span<const ProjectileId> ids, double gravity = kGravity) {
  double sum = 0;
  for (const ProjectileId id : ids) {
    const auto one = world[id];
    sum += one.mass() * (length_squared(one.velocity()) / 2 + gravity * one.position().y);
  }
  return sum;
}
inline Vec3d momentum(const World& world, std::span<const ProjectileId> ids) {
  Vec3d sum{};
  for (const ProjectileId id : ids) sum += world[id].velocity() * world[id].mass();
  return sum;
}
inline Vec3d angular_momentum(const World& world, std::span<const ProjectileId> ids) {
  Vec3d sum{};
  for (const ProjectileId id : ids) sum += cross(world[id].position(), world[id].velocity()) * world[id].mass();
  return sum;
}

/// Times at which a coordinate that a step changes passes zero upwards, by straight lines between steps.
template <class Read>
std::vector<double> upward_passes(World& world, double dt, double until, const Read& read) {
  std::vector<double> times;
  double before = read();
  while (world.time() < until) {
    const double since = world.time();
    world.step(dt);
    const double now = read();
    if (before < 0 && now >= 0) times.push_back(since + dt * before / (before - now));
    before = now;
  }
  return times;
}

/// The arithmetic-geometric mean.
inline double agm(double a, double b) {
  for (int i = 0; i < 40; ++i) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return a;
}
/// Of a pendulum, whatever its amplitude [s].
inline double pendulum_period(double length, double amplitude) {
  return 2 * kPi * std::sqrt(length / kGravity) / agm(1, std::cos(amplitude / 2));
}

}  // namespace physim::test_joints

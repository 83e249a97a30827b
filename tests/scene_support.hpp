// Scenes, rungs and questions that tests of flights and of worlds in scenes share.
#pragma once

#include "world/world_support.hpp"

namespace physim::test_scene {

inline constexpr double kG = 9.80665;
using test::of_kind;

inline Environment vacuum_of(double g) {
  return {.gravity = {.model = g == 0 ? GravityModel::off : GravityModel::constant, .acceleration = g},
          .atmosphere = {.model = AirModel::vacuum}};
}

/// Neither air nor ground.
inline WorldDef space(double g = kG) { return {.environment = vacuum_of(g), .ground = {.mode = GroundMode::none}}; }
/// No air, and things alone; by several threads.
inline WorldDef in_the_open(unsigned threads = 1) {
  return {.environment = {.atmosphere = {.model = AirModel::vacuum}},
          .ground = {.mode = GroundMode::none},
          .threading = {.threads = threads, .rows_per_thread = 64}};
}

/// A path between two walls at -half and half, unfolded: where it is, and which way it goes.
struct Unfolded {
  double x, sign;
};
inline Unfolded unfolded(double x, double half) {
  const double period = 4 * half;
  double at = std::fmod(x + half, period);
  if (at < 0) at += period;
  return at < 2 * half ? Unfolded{at - half, 1} : Unfolded{3 * half - at, -1};
}

inline Until meeting(const Scene& scene, OnHit on_hit = OnHit::stop, double radius = 0) {
  return {.ground = std::nullopt,
          .time = 60,
          .scene = &scene,
          .contact = {.collision = {.on_hit = on_hit, .radius = radius}}};
}

inline Fidelity rung(Integrator integrator, Precision precision = Precision::float64) {
  Fidelity fidelity = test::vacuum(integrator);
  fidelity.precision = precision;
  return fidelity;
}
/// 1 kg, 0.2 m wide, without drag, by steps of rk4.
inline ProjectileDef puck(Precision precision = Precision::float64) {
  return {.mass = 1, .diameter = 0.2, .fidelity = rung(Integrator::rk4, precision)};
}
inline Fidelity closed() {
  Fidelity fidelity = test::vacuum();
  fidelity.motion = Motion::closed_form;
  return fidelity;
}

inline InstanceId put(Scene& scene, const ShapeDef& shape, const Vec3d& position, MaterialId material = {}) {
  return must(scene.add({.shape = *scene.add_shape(shape), .transform = {.position = position}, .material = material}));
}

/// A ball, or a point, that bounces and rolls without resistance, and does not sleep.
inline BodyDef bouncing(double radius, double restitution = 1, double friction = 1) {
  return {.can_sleep = false,
          .restitution = restitution,
          .friction = friction,
          .rolling_resistance = 0,
          .collision = {.on_hit = OnHit::bounce, .radius = radius}};
}

/// A hollow box of six walls a metre thick about a room.
inline Scene room(const Vec3d& half, const Material& material) {
  Scene scene;
  const MaterialId made_of = *scene.add_material(material);
  for (const double side : {-1.0, 1.0}) {
    put(scene, BoxShape{{0.5, half.y + 1, half.z + 1}}, {side * (half.x + 0.5), 0, 0}, made_of);
    put(scene, BoxShape{{half.x + 1, 0.5, half.z + 1}}, {0, side * (half.y + 0.5), 0}, made_of);
    put(scene, BoxShape{{half.x + 1, half.y + 1, 0.5}}, {0, 0, side * (half.z + 0.5)}, made_of);
  }
  return scene;
}

}  // namespace physim::test_scene

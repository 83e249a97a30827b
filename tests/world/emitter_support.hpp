// Emitters that tests of worlds share.
#pragma once

#include <map>
#include <tuple>

#include "world/world_support.hpp"

namespace physim {

/// A spark without drag, flown by its closed form.
inline ProjectileDef spark(Motion motion = Motion::closed_form,
                           Integrator integrator = Integrator::semi_implicit_euler) {
  ProjectileDef p = stone();
  p.mass = 0.001;
  p.fidelity.motion = motion;
  p.fidelity.integrator = integrator;
  return p;
}

inline KindId kind_of(World& world, const ProjectileDef& projectile, const BodyDef& body = {}) {
  return must(world.add_kind(projectile, body));
}

inline EmitterId added(World& world, const EmitterDef& def) { return must(world.add_emitter(def)); }

/// A spray upwards of so many a second that live for so long.
inline EmitterDef spray(KindId kind, double per_second, double lifetime) {
  EmitterDef def{.kind = kind, .seed = 7};
  def.rotation = {0.7071067811865476, 0, 0, 0.7071067811865476};  // forwards is up
  def.per_second = {per_second};
  def.maximum = 1u << 30;
  def.start.lifetime = {lifetime};
  def.start.speed = {8, 12};
  def.from = {.shape = EmitShape::cone, .radius = 0.2};
  return def;
}

/// Steps of a frame rate, or of irregular lengths for 0, until a time that all of them reach.
inline void step_to(World& world, double end, int rate, std::vector<Event>* events = nullptr) {
  unsigned random = 12345;
  while (world.time() < end) {
    random = random * 1664525u + 1013904223u;
    double dt = rate > 0 ? 1.0 / rate : 0.001 + 0.06 * (random >> 8) / 16777216.0;
    if (rate == 0) dt = std::min(dt, std::max(end - world.time(), 1e-9));
    ASSERT_TRUE(world.step(dt));
    if (events) events->insert(events->end(), world.events().begin(), world.events().end());
    if (rate > 0 && world.time() > end - 0.25 / rate) break;
  }
}

inline constexpr int kFrameRates[] = {10, 24, 60, 144, 1000, 0};

/// The events of a kind up to a time, in order of time, and of place and velocity where several fall on one moment.
inline std::vector<Event> told(const std::vector<Event>& events, EventKind kind, double end) {
  std::vector<Event> found;
  for (const Event& e : events)
    if (e.kind == kind && e.time <= end) found.push_back(e);
  std::ranges::stable_sort(found, [](const Event& a, const Event& b) {
    const auto key = [](const Event& e) { return std::tuple(e.time, e.position.x, e.position.y, e.velocity.x); };
    return key(a) < key(b);
  });
  return found;
}

/// Who is alive, by number.
inline std::map<std::uint64_t, BodyState> alive(const World& world, EmitterId emitter) {
  const std::size_t count = world.particles(emitter, {});
  std::vector<std::uint64_t> number(count);
  std::vector<Vec3d> position(count), velocity(count);
  world.particles(emitter, {.position = position, .velocity = velocity, .number = number});
  std::map<std::uint64_t, BodyState> all;
  for (std::size_t i = 0; i < count; ++i) all[number[i]] = {position[i], velocity[i]};
  return all;
}

}  // namespace physim

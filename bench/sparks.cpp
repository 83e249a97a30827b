#include "sparks.hpp"

#include <cmath>

#include "world_bench.hpp"

namespace physim::bench {

EmitterDef spray(KindId kind, double per_second, const DrawnNumber& lifetime) {
  EmitterDef def;
  def.kind = kind;
  def.seed = 7;
  def.rotation = {std::sqrt(0.5), 0, 0, std::sqrt(0.5)};
  def.per_second = {per_second};
  def.maximum = 4 * SteadySparks::kCount;
  def.start.lifetime = lifetime;
  def.start.speed = {5, 10};
  def.from = {.shape = EmitShape::cone, .radius = 0.1};
  return def;
}

World empty_world() { return std::move(World::create(free_flight()).value()); }

SteadySparks::SteadySparks() {
  EmitterDef def = spray(*world.add_kind(world_bullet(Fidelity::game())), kPerSecond, {kShortest, kLongest});
  def.start.size = {0.5, 1.5};
  def.life.size = {1, {}, {{0, 1}, {1, 0}}};
  def.life.colour.gradient = {{0, 0xfff0a0ff}, {1, 0xff280000}};
  emitter = *world.add_emitter(def);
  def.kind = *driven.add_kind(world_bullet(Fidelity::game()));
  def.flight.drag = {1, {}, {{0, 1}, {1, 0}}};
  static_cast<void>(driven.add_emitter(def).value());
  for (int i = 0; i < kFramesBefore; ++i) step(), step_driven();
}

}  // namespace physim::bench

#include "world/couple/emitter_rain.hpp"

#include <algorithm>
#include <cmath>

#include "world/couple/world_impl.hpp"

namespace physim {
namespace {

/// Whether a box has jumped: more than what rounding does.
bool are_apart(const Vec3d& a, const Vec3d& b) { return length(a - b) > 1e-9 + 1e-12 * length(b); }

}  // namespace

std::uint32_t RainStep::begin(std::uint32_t index, const Pose& from, const Pose& to, double from_time, double to_time) {
  const Emitter& e = w_.state.emitters[index];
  const Rain& rain = e.emission->rain();
  PHYSIM_ASSERT(rain.falls() && from_time <= to_time);
  const double span = to_time - from_time;
  const Vec3d velocity = span > 0 ? (to.position - from.position) * (1 / span) : Vec3d{};
  Way& way = ways_[index];
  way = {.from = from_time,
         .to = to_time,
         .begin = from.position,
         .inflow = rain.inflow(velocity, from.rotation, to.rotation)};
  if (e.rain.about && !are_apart(*e.rain.about, from.position)) return 0;
  if (e.rain.about) way.before = *e.rain.about - from.position;
  return rain.filling();
}

std::optional<double> RainStep::next(std::uint32_t index) const {
  const Way& way = ways_.at(index);
  const double come = way.inflow.rate * (way.to - way.from) + w_.state.emitters[index].rain.due;
  const double wanted = static_cast<double>(way.taken) + 1;
  if (!(come >= wanted - kRainRounding)) return std::nullopt;
  return std::min(way.from + (wanted - w_.state.emitters[index].rain.due) / way.inflow.rate, way.to);
}

std::optional<BodyState> RainStep::candidate(std::uint32_t index, const Birth& birth, bool fills, double time,
                                             const Quatd& rotation) const {
  const Emitter& e = w_.state.emitters[index];
  const Rain& rain = e.emission->rain();
  const Way& way = ways_.at(index);
  PHYSIM_ASSERT(time >= way.from && time <= way.to);
  const Newborn newborn = e.emission->newborn(birth);
  const Vec3d velocity = rotate(rotation, newborn.direction) * newborn.speed + rain.def().drift;
  const auto place = fills ? rain.filled(birth.number, way.before) : rain.entry(way.inflow, birth.number, velocity);
  if (!place) return std::nullopt;
  const BodyState at{way.begin + way.inflow.velocity * (time - way.from) + *place, velocity};
  return is_under_cover(index, at, time) ? std::nullopt : std::optional(at);
}

/// Below the ground, or behind something that it would have met on its way here.
bool RainStep::is_under_cover(std::uint32_t index, const BodyState& at, double time) const {
  if (w_.def.ground.mode != GroundMode::none && at.position.y < w_.def.ground.height) return true;
  const EmitterDef& def = w_.state.emitters[index].def();
  const double speed = length(at.velocity);
  if (!(def.rain.shelter > 0 && speed > 0) || !w_.state.scene) return false;
  const CollisionDef& collision = w_.registry.kind(w_.registry.kinds.find(def.kind)).body.collision;
  const Vec3d from = at.position - at.velocity * (def.rain.shelter / speed);
  return w_.state.scene->any_hit({.from = from, .to = at.position, .radius = collision.radius, .time = time},
                                 {.layers = collision.layers, .sensors = false});
}

void RainStep::end(std::uint32_t index, const Vec3d& about) {
  Emitter& e = w_.state.emitters[index];
  if (!e.emission->rain().falls()) return;
  if (!e.plays) return void(e.rain = {});
  const auto way = ways_.find(index);
  if (way == ways_.end()) return;  // its delay is not over
  const double come = way->second.inflow.rate * (way->second.to - way->second.from) + e.rain.due;
  e.rain.due = std::clamp(come - static_cast<double>(way->second.taken), -kRainRounding, 1.0);
  e.rain.about = about;
  std::vector<std::uint32_t> outside;
  w_.state.emitters.each_particle_of(index, [&](std::uint32_t slot, const Particle&) {
    const Slot& of = w_.state.slots[slot];
    if (!e.emission->rain().holds(w_.state.rows_of(of).position(of.row) - about)) outside.push_back(slot);
  });
  for (const std::uint32_t slot : outside) {
    w_.tell(EventKind::expired, slot, Reason::outside_box);
    w_.state.emitters.leave(slot, &EmitterCounts::expired);
    w_.remove(slot, LifeStatus::expired);
  }
}

}  // namespace physim

// Moments of a world: snapshots and the hash of its state.
#include <cstring>

#include "world/world_impl.hpp"

namespace physim {
namespace {

/// FNV-1a over whole words, mixed so that every bit counts.
class Hash {
 public:
  void add(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x9e3779b97f4a7c15u;
    value_ ^= value_ >> 29;
  }
  void add(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    add(bits);
  }
  void add(const Vec3d& v) { add(v.x), add(v.y), add(v.z); }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

void add_ids(Hash& h, const std::vector<ProjectileId>& ids) {
  for (const ProjectileId id : ids) h.add((std::uint64_t{id.generation} << 32) | id.index);
}

/// The numbers of a law; of a user's function there are none to see.
struct AddLaw {
  Hash& h;

  template <class Law>
  void operator()(const Law& law) const {
    static_assert(std::is_trivially_copyable_v<Law> && sizeof(Law) % sizeof(std::uint64_t) == 0);
    std::uint64_t words[sizeof(Law) / sizeof(std::uint64_t)];
    std::memcpy(words, &law, sizeof words);
    for (const std::uint64_t word : words) h.add(word);
  }
  void operator()(const Thrust& law) const {
    for (const Thrust::Point& point : law.curve) h.add(point.time), h.add(point.force);
    h.add(law.direction);
  }
  void operator()(const CustomForce&) const {}
};

void add_generator(Hash& h, std::uint32_t index, const Generator& g) {
  h.add((std::uint64_t{g.generation} << 32) | index);
  h.add((std::uint64_t{g.def.law.index()} << 1) | std::uint64_t{g.begun});
  std::visit(AddLaw{h}, g.def.law);
  h.add(g.start);
  h.add(g.end);
  add_ids(h, g.def.target.ids);
  add_ids(h, g.except);
  h.add((std::uint64_t{g.def.target.layers} << 32) | g.def.target.kind.index);
}

}  // namespace

double Snapshot::time() const { return state_ ? state_->clock.time() : 0; }

Snapshot World::snapshot() const {
  auto copy = std::make_shared<WorldState>(impl_->state);
  copy->environments = impl_->registry.environments();
  return Snapshot(std::move(copy));
}

bool World::restore(const Snapshot& snapshot) {
  Impl& w = *impl_;
  if (!snapshot) return w.refuse({"the snapshot is empty", "snapshot", "World::snapshot() makes one"});
  const WorldState& then = *snapshot.state_;
  if (then.owner != w.state.owner) return w.refuse({"the snapshot is of another world", "snapshot", ""});
  w.state = then;
  for (std::uint32_t i = 0; i < then.environments.size(); ++i)
    if (!(then.environments[i] == w.registry.environments()[i])) w.registry.set_environment(i, then.environments[i]);
  return true;
}

std::uint64_t World::hash() const {
  const WorldState& s = impl_->state;
  Hash h;
  h.add(s.clock.time());
  h.add(s.clock.left_over);
  h.add(s.clock.time_scale);
  h.add(std::uint64_t{s.clock.paused});
  for (std::uint32_t i = 1; i < s.slots.size(); ++i) {
    const Slot& slot = s.slots[i];
    h.add((std::uint64_t{slot.generation} << 32) | slot.flags);
    if (!slot.is(kAlive)) continue;
    const BodyState now = impl_->state_of(slot);
    h.add((std::uint64_t{slot.kind} << 32) | slot.rung);
    h.add(now.position);
    h.add(now.velocity);
    h.add(s.birth[i]);
    h.add(impl_->clock_of(slot));
    h.add(static_cast<double>(s.rest[i].time));
    const Rows& rows = impl_->rows_of(slot);
    rows.visit([&](const auto& c) {
      if (rows.layout().carried) h.add(Rows::at(c.carried, slot.row));
      for (const std::uint8_t field : rows.layout().fields) h.add(static_cast<double>(c.field[field][slot.row]));
    });
  }
  for (const auto& [slot, turning] : s.turning) {
    h.add(turning.angular_velocity);
    h.add(turning.orientation.w);
    h.add(Vec3d{turning.orientation.x, turning.orientation.y, turning.orientation.z});
  }
  for (const std::uint32_t index : s.force_order) add_generator(h, index, s.generators[index]);
  return h.value();
}

}  // namespace physim

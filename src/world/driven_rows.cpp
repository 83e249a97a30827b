#include "world/driven_rows.hpp"

#include <algorithm>

#include "model/gravity.hpp"
#include "world/force_field.hpp"

namespace physim {
namespace {

using Column = FlightPack<DrivenBlock::kMost>::Column;

Column gathered(const Column& column, std::span<const std::uint8_t, DrivenBlock::kMost> lanes) {
  Column to;
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = column[lanes[i]];
  return to;
}

}  // namespace

bool DrivenRows::in_packs(const WorldState& state) {
  return std::ranges::none_of(state.emitters.all(),
                              [](const Emitter& e) { return e.drives && e.emission->flight().adds_velocity(); });
}

void DrivenRows::look_up(const WorldState& state, Row& row, std::uint32_t slot) const {
  row = {.slot = slot};
  if (!state.emitters.law_of(slot)) return;
  const Particle& particle = *state.emitters.particle(slot);
  row.emitter = particle.emitter;
  row.particle = in_flight(particle, state.slots.birth(slot));
}

void DrivenRows::find(const Registry& registry, WorldState& state) {
  cohorts_.resize(state.rows.size());
  for (std::uint16_t c = 0; c < state.rows.size(); ++c) {
    const Rows& rows = state.rows[c];
    if (!registry.cohort(c).key.forced) continue;
    std::vector<Row>& known = cohorts_[c];
    known.resize(rows.size());  // who comes back later into a row that was taken away is looked up again
    if (known.empty()) continue;
    const std::uint32_t* const slots = rows.slots();
    for (std::uint32_t row = 0; row < rows.size(); ++row)
      if (known[row].slot != slots[row]) look_up(state, known[row], slots[row]);
  }
  for (const std::uint32_t index : state.emitters.take_changed()) {
    const Slot& slot = state.slots[index];
    if (!slot.is(kAlive) || !registry.cohort(slot.cohort).key.forced) continue;
    look_up(state, cohorts_[slot.cohort][slot.row], index);
  }
}

void DrivenRows::push(const Registry& registry, const WorldState& state, double time, DrivenBlock& block) const {
  constexpr std::size_t kMost = DrivenBlock::kMost;
  PHYSIM_ASSERT(block.count > 0 && block.count <= kMost && block.cohort < cohorts_.size());
  PHYSIM_ASSERT(block.first + block.count <= cohorts_[block.cohort].size());
  const Row* const rows = cohorts_[block.cohort].data() + block.first;
  std::array<std::uint8_t, kMost> lanes;
  std::array<bool, kMost> done{};
  for (std::uint32_t at = 0; at < block.count; ++at) {
    if (done[at] || rows[at].emitter == 0) continue;
    std::size_t count = 0;  // of one emitter: they share a law
    for (std::uint32_t i = at; i < block.count; ++i)
      if (rows[i].emitter == rows[at].emitter) lanes[count++] = static_cast<std::uint8_t>(i), done[i] = true;
    std::fill(lanes.begin() + static_cast<std::ptrdiff_t>(count), lanes.end(), lanes[0]);
    PHYSIM_ASSERT(state.emitters[rows[at].emitter].drives && count > 0);
    const FlightLaw& law = state.emitters[rows[at].emitter].emission->flight();
    FlightPack<kMost> pack;
    for (std::size_t i = 0; i < kMost; ++i) {
      const InFlight& particle = rows[lanes[i]].particle;
      pack.number[i] = particle.number, pack.birth[i] = particle.birth, pack.span[i] = particle.span;
    }
    const bool all = count == kMost;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      pack.x[axis] = all ? block.x[axis] : gathered(block.x[axis], lanes);
      pack.v[axis] = all ? block.v[axis] : gathered(block.v[axis], lanes);
    }
    put_felt(registry, state, law, block, lanes, pack);
    FlightPack<kMost>::Vectors a;
    law.accelerations(pack, time, a);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < kMost && all; ++i) block.a[axis][i] += a[axis][i];
      for (std::size_t i = 0; i < count && !all; ++i) block.a[axis][lanes[i]] += a[axis][i];
    }
  }
}

/// Gravity and masses, where the law asks for them.
void DrivenRows::put_felt(const Registry& registry, const WorldState& state, const FlightLaw& law,
                          const DrivenBlock& block, std::span<const std::uint8_t> lanes,
                          FlightPack<FlightLaw::kPack>& pack) const {
  if (!law.scales_gravity() && !law.has_force()) return;
  const Conditions<double>& conditions = registry.cohort(block.cohort).conditions;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const std::uint32_t slot = cohorts_[block.cohort][block.first + lanes[i]].slot;
    if (law.has_force()) pack.mass[i] = mass_of(registry, state, state.slots[slot]);
    if (!law.scales_gravity()) continue;
    const double scale = conditions.has_gravity_scale ? state.extras.own_of(slot).gravity_scale : 1;
    const Vec3d felt = gravity(conditions, Vec3d{pack.x[0][i], pack.x[1][i], pack.x[2][i]}) * scale;
    pack.gravity[0][i] = felt.x, pack.gravity[1][i] = felt.y, pack.gravity[2][i] = felt.z;
  }
}

}  // namespace physim

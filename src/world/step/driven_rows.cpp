#include "world/step/driven_rows.hpp"

#include <algorithm>

#include "model/gravity.hpp"
#include "world/step/force_field.hpp"

namespace physim {
namespace {

using BlockColumn = FlightPack<DrivenBlock::kMost>::Column;

constexpr std::size_t kAhead = 16;  // slots that are fetched before they are read

BlockColumn gathered(const BlockColumn& column, std::span<const std::uint8_t, DrivenBlock::kMost> lanes) {
  BlockColumn to;
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = column[lanes[i]];
  return to;
}

}  // namespace

void DrivenRows::Columns::resize(std::size_t rows) {
  const std::size_t size = (rows + kRowsPerWord - 1) / kRowsPerWord * kRowsPerWord;
  slot.resize(size), emitter.resize(size), number.resize(size), birth.resize(size), span.resize(size, 1);
  for (std::size_t row = rows; row < size; ++row) slot[row] = emitter[row] = 0;
}

bool DrivenRows::Columns::is_of(const WorldState& state, const Rows& rows, std::uint64_t of) const {
  const auto row = static_cast<std::uint32_t>(of);
  const std::uint32_t driver = state.emitters.law_of(rows.slot(row)) ? state.emitters.emitter_of(rows.slot(row)) : 0;
  return slot[row] == rows.slot(row) && emitter[row] == driver &&
         (driver == 0 || number[row] == state.emitters.span(slot[row]).number);
}

void DrivenRows::Columns::look_up(const WorldState& state, std::uint32_t row, std::uint32_t index) {
  PHYSIM_ASSERT(row < slot.size());
  slot[row] = index;
  emitter[row] = 0;
  if (!state.emitters.law_of(index)) return;
  const InFlight particle = in_flight(state.emitters.span(index), state.slots.birth(index));
  emitter[row] = state.emitters.emitter_of(index);
  number[row] = particle.number, birth[row] = particle.birth, span[row] = particle.span;
}

void DrivenRows::find(const Registry& registry, WorldState& state, double time, double dt) {
  const auto all_drive = [&](const auto& does) {
    return std::ranges::all_of(state.emitters.all(),
                               [&](const Emitter& e) { return !e.drives || does(e.emission->flight()); });
  };
  time_ = time, dt_ = dt;
  in_packs_ = all_drive([](const FlightLaw& law) { return !law.adds_velocity(); });
  drag_by_age_ = all_drive([](const FlightLaw& law) { return law.is_drag_by_age(); });
  cohorts_.resize(state.rows.size());
  for (std::uint16_t c = 0; c < state.rows.size(); ++c) {
    Rows& rows = state.rows[c];
    if (!registry.cohort(c).key.forced) continue;
    Columns& known = cohorts_[c];
    known.resize(rows.size());
    if (!known.is_known) rows.begin_changes();
    // What is kept of slots lies all over the memory: it is fetched for some rows, then read.
    std::array<std::uint32_t, kAhead> stale;
    std::size_t found = 0;
    const auto look_up = [&] {
      for (std::size_t i = 0; i < found; ++i) known.look_up(state, stale[i], rows.slot(stale[i]));
      found = 0;
    };
    const auto note = [&](std::uint32_t row) {
      state.emitters.prefetch_span(rows.slot(row)), state.slots.prefetch_birth(rows.slot(row));
      stale[found++] = row;
      if (found == kAhead) look_up();
    };
    for (std::uint32_t row = 0; row < rows.size() && !known.is_known; ++row) note(row);
    rows.take_changes(note);
    look_up();
    known.is_known = true;
    // One row, another one in each step.
    PHYSIM_ASSERT(rows.size() == 0 || known.is_of(state, rows, state.clock.steps % rows.size()));
  }
}

template <class F>
void DrivenRows::each_law(const WorldState& state, const Columns& rows, std::uint32_t first, std::uint32_t count,
                          const F& f) const {
  const std::uint32_t* const emitter = rows.emitter.data() + first;
  Lanes lanes;
  std::array<bool, DrivenBlock::kMost> done{};
  for (std::uint32_t at = 0; at < count; ++at) {
    if (done[at] || emitter[at] == 0) continue;
    std::size_t found = 0;
    for (std::uint32_t i = at; i < count; ++i)
      if (emitter[i] == emitter[at]) lanes[found++] = static_cast<std::uint8_t>(i), done[i] = true;
    std::fill(lanes.begin() + static_cast<std::ptrdiff_t>(found), lanes.end(), lanes[0]);
    PHYSIM_ASSERT(state.emitters[emitter[at]].drives && found > 0);
    f(state.emitters[emitter[at]].emission->flight(), lanes, found);
  }
}

void DrivenRows::rates(const ParticleKernel& kernel, const WorldState& state, std::uint16_t cohort, std::uint32_t first,
                       double* rate) const {
  constexpr std::size_t kMost = DrivenBlock::kMost;
  const Columns& rows = cohorts_[cohort];
  PHYSIM_ASSERT(first % kMost == 0 && first + kMost <= rows.slot.size());
  const std::uint32_t* const emitter = rows.emitter.data() + first;
  std::uint32_t others = 0;
  for (std::size_t i = 0; i < kMost; ++i) others |= emitter[i] ^ emitter[0];
  if (others == 0 && emitter[0] != 0)
    return state.emitters[emitter[0]].emission->flight().drag_rates(kernel, &rows.number[first], &rows.birth[first],
                                                                    &rows.span[first], time_, rate);
  std::fill_n(rate, kMost, 0);
  each_law(state, rows, first, kMost, [&](const FlightLaw& law, const Lanes& lanes, std::size_t count) {
    std::array<std::uint64_t, kMost> number;
    BlockColumn birth, span, theirs;
    for (std::size_t i = 0; i < kMost; ++i) {
      const std::size_t row = first + lanes[i];
      number[i] = rows.number[row], birth[i] = rows.birth[row], span[i] = rows.span[row];
    }
    law.drag_rates(kernel, number.data(), birth.data(), span.data(), time_, theirs.data());
    for (std::size_t i = 0; i < count; ++i) rate[lanes[i]] = theirs[i];
  });
}

/// For laws that add velocities, which need the whole step: one row at a time.
void DrivenRows::push_alone(const Registry& registry, const WorldState& state, Integrator integrator, double time,
                            DrivenBlock& block) const {
  for (std::uint32_t i = 0; i < block.count; ++i) {
    Drive drive(registry, state, cohorts_[block.cohort].slot[block.first + i]);
    if (!drive) continue;
    drive.begin_step(integrator, time_, dt_);
    const auto at = [i](const DrivenBlock::Vectors& of) { return Vec3d{of[0][i], of[1][i], of[2][i]}; };
    const auto [a, drag_rate] = drive.at(time, {at(block.x), at(block.v)});
    block.a[0][i] += a.x, block.a[1][i] += a.y, block.a[2][i] += a.z;
    block.drag_rate[i] += drag_rate;
  }
}

template <class S>
RowPush<S> DrivenRows::pushes(const Registry& registry, const WorldState& state, std::uint16_t cohort,
                              std::uint32_t first, std::uint32_t last, PushMemory& memory) const {
  constexpr std::uint32_t kMost = DrivenBlock::kMost;
  const std::size_t size = (last - first + kMost - 1) / kMost * kMost;
  if (drag_by_age_) {
    if (memory.doubles.size() < size) memory.doubles.resize(size);
    for (std::uint32_t row = first; row < last; row += kMost)
      rates(particle_kernel(), state, cohort, row, &memory.doubles[row - first]);
    return {{}, nullptr, memory.doubles.data()};
  }
  std::vector<S>& columns = [&]() -> std::vector<S>& {
    if constexpr (sizeof(S) == 4) return memory.floats;
    if constexpr (sizeof(S) == 8) return memory.doubles;
  }();
  if (columns.size() < 4 * size) columns.resize(4 * size);
  S* const to[4] = {columns.data(), columns.data() + size, columns.data() + 2 * size, columns.data() + 3 * size};
  const RowColumns<S>& c = state.rows[cohort].columns<S>();
  const S* const states[6] = {c.position[0], c.position[1], c.position[2], c.velocity[0], c.velocity[1], c.velocity[2]};
  const Integrator integrator = registry.cohort(cohort).key.fidelity.integrator;
  DrivenBlock block{.cohort = cohort};
  for (std::uint32_t row = first; row < last; row += kMost) {
    block.first = row, block.count = std::min(kMost, last - row);
    block.put(states, row);
    for (auto& axis : block.a) axis.fill(0);
    block.drag_rate.fill(0);
    push(registry, state, integrator, time_, block);
    for (std::uint32_t i = 0; i < kMost; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) to[axis][row - first + i] = static_cast<S>(block.a[axis][i]);
      to[3][row - first + i] = static_cast<S>(block.drag_rate[i]);
    }
  }
  return {{to[0], to[1], to[2]}, to[3], nullptr};
}
template RowPush<float> DrivenRows::pushes(const Registry& registry, const WorldState& state, std::uint16_t cohort,
                                           std::uint32_t first, std::uint32_t last, PushMemory& memory) const;
template RowPush<double> DrivenRows::pushes(const Registry& registry, const WorldState& state, std::uint16_t cohort,
                                            std::uint32_t first, std::uint32_t last, PushMemory& memory) const;

void DrivenRows::push(const Registry& registry, const WorldState& state, Integrator integrator, double time,
                      DrivenBlock& block) const {
  constexpr std::size_t kMost = DrivenBlock::kMost;
  PHYSIM_ASSERT(block.count > 0 && block.count <= kMost && block.cohort < cohorts_.size());
  if (!in_packs_) return push_alone(registry, state, integrator, time, block);
  const Columns& rows = cohorts_[block.cohort];
  PHYSIM_ASSERT(block.first + block.count <= rows.slot.size());
  each_law(state, rows, block.first, block.count, [&](const FlightLaw& law, const Lanes& lanes, std::size_t count) {
    FlightPack<kMost> pack;
    for (std::size_t i = 0; i < kMost; ++i) {
      const std::size_t row = block.first + lanes[i];
      pack.number[i] = rows.number[row], pack.birth[i] = rows.birth[row], pack.span[i] = rows.span[row];
    }
    pack.time.fill(time);
    const bool all = count == kMost;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      pack.x[axis] = all ? block.x[axis] : gathered(block.x[axis], lanes);
      pack.v[axis] = all ? block.v[axis] : gathered(block.v[axis], lanes);
    }
    put_felt(registry, state, law, block, lanes, pack);
    FlightPack<kMost>::Vectors a;
    BlockColumn rate;
    law.accelerations(pack, a, rate);
    for (std::size_t i = 0; i < count; ++i) block.drag_rate[lanes[i]] += rate[i];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < kMost && all; ++i) block.a[axis][i] += a[axis][i];
      for (std::size_t i = 0; i < count && !all; ++i) block.a[axis][lanes[i]] += a[axis][i];
    }
  });
}

/// Gravity and masses, if the law needs them.
void DrivenRows::put_felt(const Registry& registry, const WorldState& state, const FlightLaw& law,
                          const DrivenBlock& block, std::span<const std::uint8_t> lanes,
                          FlightPack<FlightLaw::kPack>& pack) const {
  if (!law.scales_gravity() && !law.has_force()) return;
  const Conditions<double>& conditions = registry.cohort(block.cohort).conditions;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const std::uint32_t slot = cohorts_[block.cohort].slot[block.first + lanes[i]];
    if (law.has_force()) pack.mass[i] = mass_of(registry, state, state.slots[slot]);
    if (!law.scales_gravity()) continue;
    const double scale = conditions.has_gravity_scale ? gravity_scale_of(registry, state, slot) : 1;
    const Vec3d felt = gravity(conditions, Vec3d{pack.x[0][i], pack.x[1][i], pack.x[2][i]}) * scale;
    pack.gravity[0][i] = felt.x, pack.gravity[1][i] = felt.y, pack.gravity[2][i] = felt.z;
  }
}

}  // namespace physim

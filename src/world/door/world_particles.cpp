// Reading the particles of an emitter into columns.
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "base/ieee_mode.hpp"
#include "emit/looks.hpp"
#include "math/vec3.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {
namespace {

/// Reads the wanted values of the particles of one emitter, pack by pack and column by column. While one pack is
/// worked on, slots and columns of the next ones are fetched; rows, which lie in another order, the processor fetches.
class ParticleReader {
 public:
  ParticleReader(const WorldState& state, std::uint32_t emitter, const ParticleColumns& into)
      : state_(state),
        emitter_(state.emitters[emitter]),
        index_(emitter),
        into_(into),
        wanted_{!into.size.empty(), !into.rotation.empty(), !into.colour.empty()},
        looks_(wanted_.size || wanted_.rotation || wanted_.colour),
        speeds_(looks_ && emitter_.def().life.fast > 0),
        births_(looks_ || !into.age.empty()),
        show_(*emitter_.emission),
        phases_(looks_ && show_.read_phase()) {
    look_.time = state.clock.time();
  }

  std::size_t read() {
    if (into_.eye)
      for (const Seen& each : from_far_to_near(*into_.eye)) note(each.slot);
    else
      state_.emitters.each_particle_of(index_, [this](std::uint32_t slot, const Particle&) { note(slot); });
    turn_over();
    turn_over();
    return count_;
  }

 private:
  static constexpr std::size_t kPack = Looks::kPack;
  /// Particles, and where they lie.
  struct Noted {
    std::size_t count = 0;
    std::array<std::uint32_t, kPack> slot, row;
    std::array<std::uint16_t, kPack> cohort;
  };

  /// A particle as an eye has it.
  struct Seen {
    double away;  // the square of the distance [m^2]
    std::uint32_t slot;
  };
  [[nodiscard]] std::vector<Seen> from_far_to_near(const Vec3d& eye) const {
    std::vector<Seen> seen;
    state_.emitters.each_particle_of(index_, [&](std::uint32_t slot, const Particle&) {
      const Vec3d way = state_.state_of(state_.slots[slot]).position - eye;
      seen.push_back({dot(way, way), slot});
    });
    // A NaN is farther than all: comparing it with others would be no order.
    for (Seen& each : seen)
      if (std::isnan(each.away)) each.away = kInfinity;
    std::ranges::stable_sort(seen, std::ranges::greater{}, &Seen::away);
    return seen;
  }
  void note(std::uint32_t slot) {
    PHYSIM_ASSERT(next_->count < kPack && slot > 0);
    next_->slot[next_->count] = slot;
    if (++next_->count == kPack) turn_over();
  }

  /// Puts what f says of each in the pack into a column, as far as it goes.
  template <class T, class F>
  void each_in(const Column<T>& column, std::size_t first, std::size_t last, const F& f) const {
    const std::size_t end = std::min(last, column.size() - std::min(count_, column.size()));
    if (first >= end) return;
    if (column.stride() != sizeof(T)) {
      for (std::size_t i = first; i < end; ++i) column[count_ + i] = f(i);
      return;
    }
    T* const to = &column[count_];  // side by side: several are written at once
    for (std::size_t i = first; i < end; ++i) to[i] = f(i);
  }
  template <class T, class F>
  void each_in(const Column<T>& column, const F& f) const {
    each_in(column, 0, now_->count, f);
  }
  /// Calls f with the rows of each cohort, and the first and the last of the particles there, of those from first to
  /// last.
  template <class F>
  void each_run(const Noted& noted, std::size_t first, std::size_t last, const F& f) const {
    while (first < last) {
      std::size_t end = first + 1;
      while (end < last && noted.cohort[end] == noted.cohort[first]) ++end;
      f(state_.rows[noted.cohort[first]], first, end);
      first = end;
    }
  }

  /// Puts the pack at hand; the next one follows it.
  void turn_over() {
    for (std::size_t i = 0; i < next_->count; ++i) {
      const Slot& slot = state_.slots[next_->slot[i]];
      next_->cohort[i] = slot.cohort, next_->row[i] = slot.row;
    }
    if (next_->count == kPack) fetch_slots(next_->slot.back() + 1 + kPack);
    if (now_->count > 0) put();
    std::swap(now_, next_);
    next_->count = 0;
  }
  /// What is kept of slots: most often those that follow each other are of one emitter.
  void fetch_slots(std::uint32_t first) const {
    for (std::uint32_t i = 0; i < kPack; i += 3) state_.slots.prefetch(first + i);
    for (std::uint32_t i = 0; i < kPack && births_; i += 8) state_.slots.prefetch_birth(first + i);
    for (std::uint32_t i = 0; i < kPack && looks_; i += 4) state_.emitters.prefetch_span(first + i);
  }
  /// Where a pack soon to come is written.
  template <class T>
  void fetch_column(const Column<T>& column) const {
    const std::size_t first = count_ + 2 * kPack;
    if (column.size() < first + kPack) return;
    for (std::size_t i = 0; i < kPack * column.stride(); i += 64) prefetch_to_write(&column[first], i);
  }

  void put() {
    PHYSIM_ASSERT(now_->count > 0 && now_->count <= kPack);
    each_run(*now_, 0, now_->count, [this](const Rows& rows, auto first, auto last) { put_rows(rows, first, last); });
    fetch_column(into_.position), fetch_column(into_.size), fetch_column(into_.colour);
    for (std::size_t i = 0; i < now_->count && births_; ++i) look_.birth[i] = state_.slots.birth(now_->slot[i]);
    each_in(into_.id, [this](std::size_t i) { return state_.slots.id_of(now_->slot[i]); });
    each_in(into_.age, [this](std::size_t i) { return std::max(look_.time - look_.birth[i], 0.0); });
    each_in(into_.number, [this](std::size_t i) { return state_.emitters.span(now_->slot[i]).number; });
    if (looks_) put_looks();
    count_ += now_->count;
  }
  /// Puts the states of particles with rows in one cohort.
  void put_rows(const Rows& rows, std::size_t first, std::size_t last) {
    PHYSIM_ASSERT(first < last && last <= now_->count);
    rows.visit([&](const auto& c) {
      const auto put = [&](const Column<Vec3d>& column, const auto& of) {
        each_in(column, first, last, [&](std::size_t i) { return Rows::at(of, now_->row[i]); });
      };
      put(into_.position, c.position), put(into_.previous, c.previous), put(into_.velocity, c.velocity);
      for (std::size_t i = first; i < last && speeds_; ++i) look_.speed[i] = length(Rows::at(c.velocity, now_->row[i]));
    });
  }
  void put_looks() {
    for (std::size_t i = 0; i < kPack; ++i) {  // lanes behind the last one repeat it
      const std::size_t lane = std::min(i, now_->count - 1);
      const ParticleSpan& span = state_.emitters.span(now_->slot[lane]);
      look_.number[i] = span.number;
      look_.birth[i] = look_.birth[lane];
      look_.lifetime[i] = span.dies - look_.birth[lane];
      look_.speed[i] = look_.speed[lane];
    }
    for (std::size_t i = 0; i < kPack && phases_; ++i) look_.phase[i] = particle(std::min(i, now_->count - 1)).phase;
    show_.put(look_, wanted_);
    for (std::size_t i = 0; i < now_->count && emitter_.bequeaths; ++i) {
      const Particle& inherits = particle(i);
      for (auto& side : look_.size) side[i] = side[i] * inherits.size;
      look_.colour[i] = times(look_.colour[i], inherits.colour);
    }
    const auto vector = [](const auto& of, std::size_t i) { return Vec3d{of[0][i], of[1][i], of[2][i]}; };
    each_in(into_.size, [&](std::size_t i) { return vector(look_.size, i); });
    each_in(into_.rotation, [&](std::size_t i) { return vector(look_.rotation, i); });
    each_in(into_.colour, [&](std::size_t i) { return look_.colour[i]; });
  }
  [[nodiscard]] const Particle& particle(std::size_t i) const { return *state_.emitters.particle(now_->slot[i]); }

  const WorldState& state_;
  const Emitter& emitter_;
  std::uint32_t index_;
  const ParticleColumns& into_;
  LookParts wanted_;
  bool looks_;   // some are wanted
  bool speeds_;  // looks go by speeds
  bool births_;  // ages are wanted, or needed by looks
  Looks show_;
  bool phases_;            // looks go by phases of the cycle
  std::size_t count_ = 0;  // number of particles read
  std::array<Noted, 2> packs_;
  Noted *now_ = &packs_[0], *next_ = &packs_[1];
  LookPack<kPack> look_{};
};

}  // namespace

std::size_t World::particles(EmitterId id, const ParticleColumns& into) const {
  const IeeeMode mode;
  const WorldState& state = impl().state;
  if (!state.emitters.find(id)) return 0;
  return ParticleReader(state, id.index, into).read();
}

}  // namespace physim

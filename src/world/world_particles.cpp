// Reading the particles of an emitter into columns.
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "base/ieee_mode.hpp"
#include "emit/looks.hpp"
#include "math/vec3.hpp"
#include "world/world_impl.hpp"

namespace physim {
namespace {

/// What somebody asks for of the particles of one emitter, read pack by pack and column by column.
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
        ages_(looks_ || !into.age.empty()),
        show_(*emitter_.emission),
        phases_(looks_ && show_.read_phase()) {}

  std::size_t read() {
    if (into_.eye)
      for (const Seen& each : from_far_to_near(*into_.eye)) note(each.slot);
    else
      state_.emitters.each_particle_of(index_, [this](std::uint32_t slot, const Particle&) { note(slot); });
    if (noted_ > 0) put();
    return count_;
  }

 private:
  static constexpr std::size_t kPack = Looks::kPack;

  /// Somebody as an eye has it.
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
    // What is no number is farther than all: comparing it with others would be no order.
    for (Seen& each : seen)
      if (std::isnan(each.away)) each.away = kInfinity;
    std::ranges::stable_sort(seen, std::ranges::greater{}, &Seen::away);
    return seen;
  }
  void note(std::uint32_t slot) {
    PHYSIM_ASSERT(noted_ < kPack && slot > 0);
    slot_[noted_] = slot;
    if (++noted_ == kPack) put();
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
    each_in(column, 0, noted_, f);
  }

  /// Those that were noted.
  void put() {
    PHYSIM_ASSERT(noted_ > 0 && noted_ <= kPack);
    for (std::size_t i = 0; i < noted_; ++i) {
      const Slot& slot = state_.slots[slot_[i]];
      cohort_[i] = slot.cohort, row_[i] = slot.row;
    }
    for (std::size_t i = 0; i < noted_ && ages_; ++i) {
      birth_[i] = state_.slots.birth(slot_[i]);
      pack_.age[i] = std::max(state_.clock.time() - birth_[i], 0.0);
    }
    for (std::size_t first = 0; first < noted_;) {
      std::size_t last = first + 1;
      while (last < noted_ && cohort_[last] == cohort_[first]) ++last;
      put_rows(first, last);
      first = last;
    }
    each_in(into_.id, [this](std::size_t i) { return state_.slots.id_of(slot_[i]); });
    each_in(into_.age, [this](std::size_t i) { return pack_.age[i]; });
    each_in(into_.number, [this](std::size_t i) { return state_.emitters.span(slot_[i]).number; });
    if (looks_) put_looks();
    count_ += noted_;
    noted_ = 0;
  }
  /// Puts the states of noted rows that are of one cohort.
  void put_rows(std::size_t first, std::size_t last) {
    PHYSIM_ASSERT(first < last && last <= noted_ && cohort_[first] == cohort_[last - 1]);
    const Rows& rows = state_.rows[cohort_[first]];
    for (std::size_t i = first; i < last && rows.may_wait(); ++i) rows.bring_up(row_[i]);
    rows.read_fixed([&](const auto& c) {
      const auto put = [&](const Column<Vec3d>& column, const auto& of) {
        each_in(column, first, last, [&](std::size_t i) { return Rows::at(of, row_[i]); });
      };
      put(into_.position, c.position), put(into_.previous, c.previous), put(into_.velocity, c.velocity);
      for (std::size_t i = first; i < last && speeds_; ++i) pack_.speed[i] = length(Rows::at(c.velocity, row_[i]));
    });
  }
  void put_looks() {
    for (std::size_t i = 0; i < kPack; ++i) {  // lanes behind the last one repeat it
      const std::size_t lane = std::min(i, noted_ - 1);
      const ParticleSpan& span = state_.emitters.span(slot_[lane]);
      pack_.number[i] = span.number;
      pack_.lifetime[i] = span.dies - birth_[lane];
      pack_.age[i] = pack_.age[lane];
      pack_.speed[i] = pack_.speed[lane];
    }
    for (std::size_t i = 0; i < kPack && phases_; ++i) pack_.phase[i] = particle(std::min(i, noted_ - 1)).phase;
    show_.put(pack_, wanted_);
    for (std::size_t i = 0; i < noted_ && emitter_.bequeaths; ++i) {
      const Particle& inherits = particle(i);
      for (auto& side : pack_.size) side[i] = side[i] * inherits.size;
      pack_.colour[i] = times(pack_.colour[i], inherits.colour);
    }
    const auto vector = [](const auto& of, std::size_t i) { return Vec3d{of[0][i], of[1][i], of[2][i]}; };
    each_in(into_.size, [&](std::size_t i) { return vector(pack_.size, i); });
    each_in(into_.rotation, [&](std::size_t i) { return vector(pack_.rotation, i); });
    each_in(into_.colour, [&](std::size_t i) { return pack_.colour[i]; });
  }
  [[nodiscard]] const Particle& particle(std::size_t i) const { return *state_.emitters.particle(slot_[i]); }

  const WorldState& state_;
  const Emitter& emitter_;
  std::uint32_t index_;
  const ParticleColumns& into_;
  LookParts wanted_;
  bool looks_;   // some are wanted
  bool speeds_;  // they ask for them
  bool ages_;
  Looks show_;
  bool phases_;            // they ask for them
  std::size_t count_ = 0;  // read so far
  std::size_t noted_ = 0;  // in the pack
  std::array<std::uint32_t, kPack> slot_{}, row_{};
  std::array<std::uint16_t, kPack> cohort_{};
  std::array<double, kPack> birth_{};
  LookPack<kPack> pack_{};
};

}  // namespace

std::size_t World::particles(EmitterId id, const ParticleColumns& into) const {
  const IeeeMode mode;
  const WorldState& state = impl().state;
  if (!state.emitters.find(id)) return 0;
  return ParticleReader(state, id.index, into).read();
}

}  // namespace physim

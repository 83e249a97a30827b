// Reading the particles of an emitter into columns.
#include <algorithm>

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
    state_.emitters.each_particle_of(index_, [this](std::uint32_t slot, const Particle&) {
      slot_[noted_] = slot;
      if (++noted_ == kPack) put();
    });
    if (noted_ > 0) put();
    return count_;
  }

 private:
  static constexpr std::size_t kPack = Looks::kPack;

  /// Calls f with each one's place in a column and in the pack, as far as the column goes.
  template <class T, class F>
  void each_in(std::span<T> column, std::size_t first, std::size_t last, const F& f) const {
    const std::size_t end = std::min(count_ + last, column.size());
    for (std::size_t to = count_ + first; to < end; ++to) column[to] = f(to - count_);
  }
  template <class T, class F>
  void each_in(std::span<T> column, const F& f) const {
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
      const auto put = [&](std::span<Vec3d> column, const auto& of) {
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

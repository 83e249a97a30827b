// Reading the particles of an emitter into columns.
#include <algorithm>

#include "base/ieee_mode.hpp"
#include "emit/looks.hpp"
#include "math/vec3.hpp"
#include "world/world_impl.hpp"

namespace physim {
namespace {

/// What somebody asks for of the particles of one emitter, read pack by pack.
class ParticleReader {
 public:
  ParticleReader(const WorldState& state, std::uint32_t emitter, const ParticleColumns& into)
      : state_(state),
        emitter_(state.emitters[emitter]),
        index_(emitter),
        into_(into),
        wanted_{!into.size.empty(), !into.rotation.empty(), !into.colour.empty()} {}

  std::size_t read() {
    state_.emitters.each_particle_of(index_, [this](std::uint32_t slot, const Particle& particle) {
      prefetch(slot + kAhead);
      put_row(slot, particle);
      ++count_;
      if (wanted_.size || wanted_.rotation || wanted_.colour) note_look(slot, particle);
    });
    put_looks();
    return count_;
  }

 private:
  static constexpr std::size_t kPack = Looks::kPack;

  template <class T>
  static void put(std::span<T> column, std::size_t i, const T& value) {
    if (i < column.size()) column[i] = value;
  }

  /// Rows lie in another order than slots: those of the next particles are fetched while this one is worked on.
  static constexpr std::uint32_t kAhead = 16;
  void prefetch(std::uint32_t index) const {
    if (!state_.emitters.particle(index)) return;
    const Slot& slot = state_.slots[index];
    state_.rows_of(slot).read_fixed([&](const auto& c) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!into_.position.empty()) __builtin_prefetch(c.position[axis] + slot.row);
        if (!into_.previous.empty()) __builtin_prefetch(c.previous[axis] + slot.row);
        if (!into_.velocity.empty() || emitter_.def().life.fast > 0) __builtin_prefetch(c.velocity[axis] + slot.row);
      }
    });
  }

  void put_row(std::uint32_t index, const Particle& particle) const {
    const Slot& slot = state_.slots[index];
    const Rows& rows = state_.rows_of(slot);
    put(into_.id, count_, state_.slots.id_of(index));
    if (count_ < into_.position.size()) into_.position[count_] = rows.position(slot.row);
    if (count_ < into_.previous.size()) into_.previous[count_] = rows.previous(slot.row);
    if (count_ < into_.velocity.size()) into_.velocity[count_] = rows.velocity(slot.row);
    put(into_.age, count_, age_of(index));
    put(into_.number, count_, particle.number);
  }
  [[nodiscard]] double age_of(std::uint32_t index) const {
    return std::max(state_.clock.time() - state_.slots.birth(index), 0.0);
  }

  void note_look(std::uint32_t index, const Particle& particle) {
    const double speed = emitter_.def().life.fast > 0 ? length(velocity_of(index)) : 0;
    pack_.number[noted_] = particle.number;
    pack_.phase[noted_] = particle.phase;
    pack_.lifetime[noted_] = particle.dies - state_.slots.birth(index);
    pack_.age[noted_] = age_of(index);
    pack_.speed[noted_] = speed;
    size_[noted_] = particle.size;
    colour_[noted_] = particle.colour;
    if (++noted_ == kPack) put_looks();
  }
  [[nodiscard]] Vec3d velocity_of(std::uint32_t index) const {
    const Slot& slot = state_.slots[index];
    return state_.rows_of(slot).velocity(slot.row);
  }
  /// The looks of the last that were read, as many as were noted.
  void put_looks() {
    PHYSIM_ASSERT(noted_ <= kPack && noted_ <= count_);
    if (noted_ == 0) return;
    const auto repeat_last = [this](auto& column) {
      std::fill(column.begin() + static_cast<std::ptrdiff_t>(noted_), column.end(), column[noted_ - 1]);
    };
    repeat_last(pack_.number), repeat_last(pack_.phase), repeat_last(pack_.lifetime);
    repeat_last(pack_.age), repeat_last(pack_.speed);
    Looks(*emitter_.emission).put(pack_, wanted_);
    const std::size_t first = count_ - noted_;
    for (std::size_t i = 0; i < noted_; ++i) {
      const auto vector = [i](const auto& of) { return Vec3d{of[0][i], of[1][i], of[2][i]}; };
      put(into_.size, first + i, vector(pack_.size) * size_[i]);
      put(into_.rotation, first + i, vector(pack_.rotation));
      put(into_.colour, first + i, times(pack_.colour[i], colour_[i]));
    }
    noted_ = 0;
  }

  const WorldState& state_;
  const Emitter& emitter_;
  std::uint32_t index_;
  const ParticleColumns& into_;
  LookParts wanted_;
  std::size_t count_ = 0;  // read so far
  LookPack<kPack> pack_{};
  std::array<double, kPack> size_{};           // inherited
  std::array<std::uint32_t, kPack> colour_{};  // likewise
  std::size_t noted_ = 0;                      // in the pack
};

}  // namespace

std::size_t World::particles(EmitterId id, const ParticleColumns& into) const {
  const IeeeMode mode;
  const WorldState& state = impl().state;
  if (!state.emitters.find(id)) return 0;
  return ParticleReader(state, id.index, into).read();
}

}  // namespace physim

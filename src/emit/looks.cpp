#include "emit/looks.hpp"

#include <algorithm>

#include "emit/pack_chance.hpp"
#include "emit/parts.hpp"

namespace physim {

/// One pack on its way.
template <std::size_t N>
class Looks::Look {
 public:
  Look(const Emission::Parts& parts, const ParticleKernel& kernel, LookPack<N>& pack)
      : p_(parts), pack_(pack), chance_(parts.seed, pack.number, N == kColumn ? &kernel : nullptr) {
    const double fast = p_.def.life.fast;
    for (std::size_t i = 0; i < N; ++i) {
      PHYSIM_ASSERT(pack.lifetime[i] > 0);
      span_[i] = pack.lifetime[i] < kInfinity ? pack.lifetime[i] : 1;  // [s]
    }
    if constexpr (N == kColumn)
      kernel.part_of_life(pack.time, pack.birth.data(), span_.data(), x_.data());
    else
      for (std::size_t i = 0; i < N; ++i) x_[i] = part_of_life(pack.time, pack.birth[i], span_[i]);
    for (std::size_t i = 0; i < N && fast > 0; ++i) {
      PHYSIM_ASSERT(pack.speed[i] >= 0);
      hurry_[i] = std::min(pack.speed[i] / fast, 1.0);
    }
  }

  void put_size() {
    Column& size = pack_.size[0];
    Column factor;
    put(p_.start.size, pack_.phase, size, Draw::size);
    put(p_.life.size, x_, factor, Draw::life_size);
    for (std::size_t i = 0; i < N; ++i) size[i] = size[i] * factor[i];
    if (p_.def.life.fast > 0)
      for (std::size_t i = 0; i < N; ++i) size[i] *= p_.life.size_by_speed(hurry_[i]);
    const auto put_side = [&](const EmitNumber& of, Draw what, Column& to) {
      if (of.is(1)) return void(to = size);
      put(of, pack_.phase, factor, what);
      for (std::size_t i = 0; i < N; ++i) to[i] = size[i] * factor[i];
    };
    put_side(p_.start.size_y, Draw::size_y, pack_.size[1]);
    put_side(p_.start.size_z, Draw::size_z, pack_.size[2]);
  }
  /// A particle has turned since its birth by what the curve over its span says.
  void put_rotation() {
    auto& [about, y, z] = pack_.rotation;
    put(p_.start.rotation, pack_.phase, about, Draw::rotation);
    const EmitNumber& turn = p_.life.turn;
    Column u{};
    if (turn.is_drawn()) u = chance_(Draw::life_turn);
    for (std::size_t i = 0; i < N; ++i) {
      const double age = std::max(pack_.time - pack_.birth[i], 0.0);
      about[i] = about[i] + span_[i] * turn.integral(age / span_[i], [&u, i] { return u[i]; });
    }
    put(p_.start.rotation_y, pack_.phase, y, Draw::rotation_y);
    put(p_.start.rotation_z, pack_.phase, z, Draw::rotation_z);
    const double flipped = p_.def.start.flipped;
    if (!(flipped > 0)) return;
    const Column& flips = chance_(Draw::flipped);
    for (std::size_t i = 0; i < N; ++i)
      if (flips[i] < flipped) about[i] = -about[i], y[i] = -y[i], z[i] = -z[i];
  }
  void put_colour() {
    const EmitColour &born = p_.start.colour, &life = p_.life.colour;
    const bool by_speed = p_.def.life.fast > 0 && !p_.life.colour_by_speed.is_white();
    if (born.is_white() && life.is_white() && !by_speed) return pack_.colour.fill(0xffffffff);
    RgbaColumns<N> colour, factor;
    life.at_each(x_, colour, drawn(Draw::life_colour), chance_.kernel());
    if (!born.is_white()) {
      born.at_each(pack_.phase, factor, drawn(Draw::colour), chance_.kernel());
      multiply(colour, factor);
    }
    if (by_speed) {
      p_.life.colour_by_speed.at_each(hurry_, factor, chance_.kernel());
      multiply(colour, factor);
    }
    if constexpr (N == kColumn)
      chance_.kernel()->pack_colours(columns_of(colour), pack_.colour.data());
    else
      pack_each(colour, pack_.colour);
  }

 private:
  using Column = typename LookPack<N>::Column;
  void put(const EmitNumber& of, const Column& x, Column& y, Draw what) { draw_each(of, x, y, chance_, what); }
  /// Numbers of the particles' own, drawn only where they are asked for.
  [[nodiscard]] auto drawn(Draw what) {
    return [this, what]() -> const Column& { return chance_(what); };
  }

  const Emission::Parts& p_;
  LookPack<N>& pack_;
  PackChance<Draw, EmitStream::particle, N> chance_;
  Column span_, x_;
  Column hurry_;  // where looks follow the speed
};

bool Looks::read_phase() const {
  const EmitStart& start = parts_.start;
  const EmitNumber* const numbers[] = {&start.size,     &start.size_y,     &start.size_z,
                                       &start.rotation, &start.rotation_y, &start.rotation_z};
  return start.colour.follows() || std::ranges::any_of(numbers, [](const EmitNumber* of) { return of->follows(); });
}

template <std::size_t N>
void Looks::put(LookPack<N>& pack, const LookParts& wanted) const {
  Look<N> look(parts_, kernel_, pack);
  if (wanted.size) look.put_size();
  if (wanted.rotation) look.put_rotation();
  if (wanted.colour) look.put_colour();
}
template void Looks::put(LookPack<Looks::kPack>& pack, const LookParts& wanted) const;

Look Emission::look(std::uint64_t number, double phase, double lifetime, double age, double speed) const {
  LookPack<1> pack{age, {number}, {phase}, {0}, {lifetime}, {speed}, {}, {}, {}};
  Looks(*this).put(pack, {});
  const auto vector = [](const std::array<LookPack<1>::Column, 3>& of) { return Vec3d{of[0][0], of[1][0], of[2][0]}; };
  return {vector(pack.size), vector(pack.rotation), pack.colour[0]};
}

}  // namespace physim

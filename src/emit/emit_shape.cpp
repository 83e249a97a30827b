// Equations, symbols and Source: emit/emit_shape.hpp.
#include "emit/emit_shape.hpp"

#include <algorithm>
#include <cmath>

#include "base/emit_shape_table.hpp"
#include "emit/emit_surface.hpp"

namespace physim {
namespace {

ShapeNumbers numbers_of(const EmitFrom& from) {
  ShapeNumbers n{.from = from, .inner = 1 - from.thickness, .slope = tan(from.angle)};
  // Around the whole axis the first lies where the arc begins; parts that have ends have their particle in the middle.
  n.first = from.shape != EmitShape::line && from.arc >= 2 * kPi ? 0 : 0.5;
  n.half = from.size * 0.5;
  n.shell = from.thickness * std::min({n.half.x, n.half.y, n.half.z});
  n.within = n.half - Vec3d{n.shell, n.shell, n.shell};
  n.slab[0] = n.half.y * n.half.z;
  n.slab[1] = n.slab[0] + n.within.x * n.half.z;
  n.slab[2] = n.slab[1] + n.within.x * n.within.y;
  PHYSIM_ASSERT(n.inner >= 0 && n.inner <= 1 && n.within.x >= 0 && n.within.y >= 0 && n.within.z >= 0);
  return n;
}

}  // namespace

ShapeOutlets::ShapeOutlets(const EmitFrom& from) : shape_(numbers_of(from)), surface_(surface_outlets(from)) {}

// ------------------------------------------------------------------------------------------------- one, or a pack
namespace {

template <class R>
void put_lane(WayOut<R>& out, int lane, const Outlet& one) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    set_lane(out.place[axis], lane, one.place[axis]);
    set_lane(out.direction[axis], lane, one.direction[axis]);
  }
}

/// The numbers of a part of a pack: as many as fit into a register, so that a shape's numbers stay in registers.
class PartChance {
 public:
  using R = Pack<double, kNativeBytes / sizeof(double)>;
  using All = PackChance<Draw, EmitStream::particle, NewbornPack::kLanes>;

  PartChance(All& all, std::size_t first) : all_(all), first_(first) {}
  [[nodiscard]] R operator()(Draw what) {
    const auto& words = all_.words(what);
    R u;
    for (int lane = 0; lane < kLanes<R>; ++lane) u.set(lane, open_unit(words[first_ + static_cast<std::size_t>(lane)]));
    return u;
  }

 private:
  All& all_;
  std::size_t first_;
};

}  // namespace

Outlet ShapeOutlets::at(const Birth& birth, ParticleChance& chance) const {
  const WayOutOf<double, ParticleChance> way(shape_, birth.time, birth.of_moment, birth.moment, chance);
  Outlet out;
  if (surface_) {
    out = surface_->at(chance);
  } else {
    const WayOut<double> found = way.out();
    out = {found.place, found.direction};
  }
  if (shape_.from.randomise != 0) out.direction = way.randomised(out.direction);
  return out;
}

void ShapeOutlets::at_each(NewbornPack& pack,
                           PackChance<Draw, EmitStream::particle, NewbornPack::kLanes>& chance) const {
  if (!surface_ && shape_.from.randomise == 0) return by_kernel(pack, chance);
  using R = PartChance::R;
  for (std::size_t first = 0; first < pack.count; first += std::size_t{kLanes<R>}) {
    const auto load = [first](const auto& column) {
      R numbers;
      for (int lane = 0; lane < kLanes<R>; ++lane)
        numbers.set(lane, static_cast<double>(column[first + static_cast<std::size_t>(lane)]));
      return numbers;
    };
    PartChance part(chance, first);
    const WayOutOf<R, PartChance> way(shape_, load(pack.time), load(pack.of_moment), load(pack.moment), part);
    WayOut<R> out;
    if (surface_) {
      for (int lane = 0; lane < kLanes<R>; ++lane) {
        ParticleChance alone(chance.seed(), pack.number[first + static_cast<std::size_t>(lane)]);
        put_lane(out, lane, surface_->at(alone));
      }
    } else {
      out = way.out();
    }
    if (shape_.from.randomise != 0) out.direction = way.randomised(out.direction);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      out.place[axis].store(pack.place[axis].data() + first);
      out.direction[axis].store(pack.direction[axis].data() + first);
    }
  }
}

/// Shapes that draw from the first two blocks alone.
void ShapeOutlets::by_kernel(NewbornPack& pack,
                             PackChance<Draw, EmitStream::particle, NewbornPack::kLanes>& chance) const {
  NewbornPack::Column of_moment, moment;
  for (std::size_t i = 0; i < NewbornPack::kLanes; ++i) of_moment[i] = pack.of_moment[i], moment[i] = pack.moment[i];
  OutletJob job{.shape = &shape_,
                .count = pack.count,
                .time = pack.time.data(),
                .of_moment = of_moment.data(),
                .moment = moment.data()};
  for (const Draw first : {Draw::arc, Draw::along}) {
    if (first == Draw::along && !row_of(shape_.from.shape).draws_within) break;
    for (unsigned k = 0; k < 4; ++k) {
      const unsigned draw = static_cast<unsigned>(first) + k;
      job.words[draw] = chance.words(static_cast<Draw>(draw)).data();
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    job.place[axis] = pack.place[axis].data(), job.direction[axis] = pack.direction[axis].data();
  chance.kernel()->outlets(job);
}

}  // namespace physim

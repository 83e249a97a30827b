// Equations, symbols and Source: emit/emit_shape.hpp.
#include "emit/emit_shape.hpp"

#include <algorithm>
#include <cmath>

#include "emit/emit_surface.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"
#include "math/vec3.hpp"
#include "model/exit_spread.hpp"

namespace physim {
ShapeOutlets::ShapeOutlets(const EmitFrom& from)
    : from_(from),
      inner_(1 - from.thickness),
      slope_(tan(from.angle)),
      half_(from.size * 0.5),
      within_(half_),
      surface_(surface_outlets(from)) {
  // Around the whole axis the first lies where the arc begins; parts that have ends have their particle in the middle.
  first_ = from.shape != EmitShape::line && from.arc >= 2 * kPi ? 0 : 0.5;
  shell_ = from.thickness * std::min({half_.x, half_.y, half_.z});
  within_ = half_ - Vec3d{shell_, shell_, shell_};
  slab_[0] = half_.y * half_.z;
  slab_[1] = slab_[0] + within_.x * half_.z;
  slab_[2] = slab_[1] + within_.x * within_.y;
  PHYSIM_ASSERT(inner_ >= 0 && inner_ <= 1 && within_.x >= 0 && within_.y >= 0 && within_.z >= 0);
}

// ------------------------------------------------------------------------------------------------- one, or a pack
namespace {

/// A particle's place and direction, or those of a pack of them.
template <class R>
struct WayOut {
  Vec3<R> place{};
  Vec3<R> direction{R(1), R(0), R(0)};
};

template <class R>
void put_lane(WayOut<R>& out, int lane, const Outlet& one) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    set_lane(out.place[axis], lane, one.place[axis]);
    set_lane(out.direction[axis], lane, one.direction[axis]);
  }
}

template <class R>
R behind_point(const R& x) {
  R part;
  for (int lane = 0; lane < kLanes<R>; ++lane) set_lane(part, lane, lane_of(x, lane) - std::floor(lane_of(x, lane)));
  return part;
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

/// A particle on its way out, or a pack of them: what holds for all is decided once, what differs is selected.
template <class R, class Chance>
class ShapeOutlets::Way {
 public:
  Way(const ShapeOutlets& of, const R& time, const R& of_moment, const R& moment, Chance& chance)
      : o_(of), time_(time), of_moment_(of_moment), moment_(moment), chance_(chance) {}

  [[nodiscard]] WayOut<R> out() const {
    const EmitFrom& from = o_.from_;
    PHYSIM_ASSERT(!o_.surface_);
    switch (from.shape) {
      case EmitShape::point: return {};
      case EmitShape::cone: return cone();
      case EmitShape::sphere:
      case EmitShape::hemisphere: return ball();
      case EmitShape::box: return {in_box()};
      case EmitShape::circle: {
        const Vec3<R> away = about_axis();
        return {away * (from.radius * disc_part()), away};
      }
      case EmitShape::ring: return ring();
      case EmitShape::line: return {{R(0), R(0), from.length * (along_arc() - 0.5)}};
      case EmitShape::mesh:
      case EmitShape::mesh_edges:
      case EmitShape::mesh_vertices:
      case EmitShape::terrain: break;
    }
    PHYSIM_UNREACHABLE();
  }
  /// A direction, turned towards a random one.
  [[nodiscard]] Vec3<R> randomised(const Vec3<R>& direction) const {
    const R off = o_.from_.randomise * acos(1 - 2 * chance_(Draw::off)), about = 2 * kPi * chance_(Draw::about);
    Vec3<R> turned;
    for (int lane = 0; lane < kLanes<R>; ++lane) {
      const Vec3d one = turned_off({lane_of(direction.x, lane), lane_of(direction.y, lane), lane_of(direction.z, lane)},
                                   lane_of(off, lane), lane_of(about, lane));
      set_lane(turned.x, lane, one.x), set_lane(turned.y, lane, one.y), set_lane(turned.z, lane, one.z);
    }
    return turned;
  }

 private:
  [[nodiscard]] R along_arc() const {  // 0..1
    const double arc_speed = o_.from_.arc_speed;
    switch (o_.from_.arc_mode) {
      case ArcMode::random: return chance_(Draw::arc);
      case ArcMode::loop: return behind_point(time_ * arc_speed);
      case ArcMode::ping_pong: {
        const R there_and_back = 2 * behind_point(0.5 * time_ * arc_speed);
        return select(there_and_back <= R(1), there_and_back, 2 - there_and_back);
      }
      case ArcMode::spread: PHYSIM_ASSERT(all(of_moment_ < moment_)); return (of_moment_ + o_.first_) / moment_;
    }
    PHYSIM_UNREACHABLE();
  }
  /// Across the axis, of length one.
  [[nodiscard]] Vec3<R> about_axis() const {
    const SinCos<R> turn = sincos(o_.from_.arc * along_arc());
    return {R(0), turn.cos, turn.sin};
  }
  [[nodiscard]] R disc_part() const {
    if (o_.inner_ == 1) return R(1);
    const double least = o_.inner_ * o_.inner_;
    return sqrt(least + chance_(Draw::depth) * (1 - least));
  }
  [[nodiscard]] R ball_part() const {
    if (o_.inner_ == 1) return R(1);
    const double least = o_.inner_ * o_.inner_ * o_.inner_;
    return pow(least + chance_(Draw::depth) * (1 - least), R(1.0 / 3));
  }
  [[nodiscard]] WayOut<R> cone() const {
    const Vec3<R> away = about_axis();
    const R s = disc_part(), lean = s * o_.slope_;
    const R forwards = 1 / sqrt(1 + lean * lean);
    return {away * (o_.from_.radius * s), Vec3<R>{forwards, R(0), R(0)} + away * (lean * forwards)};
  }
  [[nodiscard]] WayOut<R> ball() const {
    const R u = chance_(Draw::along);
    const R x = o_.from_.shape == EmitShape::sphere ? 1 - 2 * u : u;
    const Vec3<R> direction = Vec3<R>{x, R(0), R(0)} + about_axis() * sqrt((1 - x) * (1 + x));
    if (o_.from_.radius == 0) return {{}, direction};
    return {direction * (o_.from_.radius * ball_part()), direction};
  }
  [[nodiscard]] WayOut<R> ring() const {
    const double radius = o_.from_.radius;
    const Vec3<R> away = about_axis();
    const R rho = o_.from_.tube * disc_part();
    const SinCos<R> p = sincos(2 * kPi * chance_(Draw::along));
    const R bent = radius > 0 ? rho / radius * p.cos : R(0);
    const R outwards = select(2 * chance_(Draw::side) < 1 - bent, -p.cos, p.cos);
    const Vec3<R> direction = Vec3<R>{p.sin, R(0), R(0)} + away * outwards;
    return {away * R(radius) + direction * rho, direction};
  }
  [[nodiscard]] Vec3<R> in_box() const {
    const Vec3d &half = o_.half_, &within = o_.within_;
    // Even in -1..1; and how deep in the shell, 0..1, on which side.
    const Vec3<R> even{2 * chance_(Draw::along) - 1, 2 * chance_(Draw::arc) - 1, 2 * chance_(Draw::depth) - 1};
    // A line or a point is all surface.
    if (o_.from_.thickness == 1 || o_.slab_[2] == 0) return {half.x * even.x, half.y * even.y, half.z * even.z};
    const auto shell = [this](const R& side, double size) {
      return select(side < R(0), -size - side * o_.shell_, size - side * o_.shell_);
    };
    const R slab = chance_(Draw::side) * o_.slab_[2];
    const MaskOf<R> in_x = slab < R(o_.slab_[0]), in_xy = slab < R(o_.slab_[1]);
    return {select(in_x, shell(even.x, half.x), even.x * within.x),
            select(in_x, even.y * half.y, select(in_xy, shell(even.y, half.y), even.y * within.y)),
            select(in_xy, even.z * half.z, shell(even.z, half.z))};
  }

  const ShapeOutlets& o_;
  const R time_, of_moment_, moment_;
  Chance& chance_;
};

Outlet ShapeOutlets::at(const Birth& birth, ParticleChance& chance) const {
  const Way<double, ParticleChance> way(*this, birth.time, birth.of_moment, birth.moment, chance);
  Outlet out;
  if (surface_) {
    out = surface_->at(chance);
  } else {
    const WayOut<double> found = way.out();
    out = {found.place, found.direction};
  }
  if (from_.randomise != 0) out.direction = way.randomised(out.direction);
  return out;
}

void ShapeOutlets::at_each(NewbornPack& pack,
                           PackChance<Draw, EmitStream::particle, NewbornPack::kLanes>& chance) const {
  using R = PartChance::R;
  for (std::size_t first = 0; first < NewbornPack::kLanes; first += std::size_t{kLanes<R>}) {
    const auto load = [first](const auto& column) {
      R numbers;
      for (int lane = 0; lane < kLanes<R>; ++lane)
        numbers.set(lane, static_cast<double>(column[first + static_cast<std::size_t>(lane)]));
      return numbers;
    };
    PartChance part(chance, first);
    const Way<R, PartChance> way(*this, load(pack.time), load(pack.of_moment), load(pack.moment), part);
    WayOut<R> out;
    if (surface_) {
      for (int lane = 0; lane < kLanes<R>; ++lane) {
        ParticleChance alone(chance.seed(), pack.number[first + static_cast<std::size_t>(lane)]);
        put_lane(out, lane, surface_->at(alone));
      }
    } else {
      out = way.out();
    }
    if (from_.randomise != 0) out.direction = way.randomised(out.direction);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      out.place[axis].store(pack.place[axis].data() + first);
      out.direction[axis].store(pack.direction[axis].data() + first);
    }
  }
}

}  // namespace physim

// Ways out of a shape, for one particle or a pack of them: a lane has the bits that it has alone.
// Equations, symbols and Source: emit/emit_shape.hpp.
#pragma once

#include <cmath>

#include "emit/chance.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"
#include "math/pack.hpp"
#include "math/vec3.hpp"
#include "model/exit_spread.hpp"
#include "physim/emitter.hpp"

namespace physim {

/// A shape, and what follows from it.
struct ShapeNumbers {
  EmitFrom from;
  double inner;        // 1 - t
  double slope;        // tan A
  double first;        // of those spread over the arc: how far into its part the first one is
  double shell = 0;    // of a box: how thick it is, from its surface inwards [m]
  double slab[3]{};    // the volume of its slabs across x, y and z, each with those before
  Vec3d half, within;  // half sizes of the box and of the part inside of the shell
};

}  // namespace physim

PHYSIM_ISA_BEGIN

/// A particle's place and direction, or those of a pack of them.
template <class R>
struct WayOut {
  Vec3<R> place{};
  Vec3<R> direction{R(1), R(0), R(0)};
};

template <class R>
PHYSIM_INLINE R behind_point(const R& x) {
  R part;
  for (int lane = 0; lane < kLanes<R>; ++lane) set_lane(part, lane, lane_of(x, lane) - std::floor(lane_of(x, lane)));
  return part;
}

/// A particle on its way out, or a pack of them: what holds for all is decided once, what differs is selected.
template <class R, class Chance>
class WayOutOf {
 public:
  PHYSIM_INLINE WayOutOf(const ShapeNumbers& of, const R& time, const R& of_moment, const R& moment, Chance& chance)
      : o_(of), time_(time), of_moment_(of_moment), moment_(moment), chance_(chance) {}

  [[nodiscard]] PHYSIM_INLINE WayOut<R> out() const {
    const EmitFrom& from = o_.from;
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
  [[nodiscard]] PHYSIM_INLINE Vec3<R> randomised(const Vec3<R>& direction) const {
    const R off = o_.from.randomise * acos(1 - 2 * chance_(Draw::off)), about = 2 * kPi * chance_(Draw::about);
    Vec3<R> turned;
    for (int lane = 0; lane < kLanes<R>; ++lane) {
      const Vec3d one = turned_off({lane_of(direction.x, lane), lane_of(direction.y, lane), lane_of(direction.z, lane)},
                                   lane_of(off, lane), lane_of(about, lane));
      set_lane(turned.x, lane, one.x), set_lane(turned.y, lane, one.y), set_lane(turned.z, lane, one.z);
    }
    return turned;
  }

 private:
  [[nodiscard]] PHYSIM_INLINE R along_arc() const {  // 0..1
    const double arc_speed = o_.from.arc_speed;
    switch (o_.from.arc_mode) {
      case ArcMode::random: return chance_(Draw::arc);
      case ArcMode::loop: return behind_point(time_ * arc_speed);
      case ArcMode::ping_pong: {
        const R there_and_back = 2 * behind_point(0.5 * time_ * arc_speed);
        return select(there_and_back <= R(1), there_and_back, 2 - there_and_back);
      }
      case ArcMode::spread: PHYSIM_ASSERT(all(of_moment_ < moment_)); return (of_moment_ + o_.first) / moment_;
    }
    PHYSIM_UNREACHABLE();
  }
  /// Across the axis, of length one.
  [[nodiscard]] PHYSIM_INLINE Vec3<R> about_axis() const {
    const SinCos<R> turn = sincos(o_.from.arc * along_arc());
    return {R(0), turn.cos, turn.sin};
  }
  [[nodiscard]] PHYSIM_INLINE R disc_part() const {
    if (o_.inner == 1) return R(1);
    const double least = o_.inner * o_.inner;
    return sqrt(least + chance_(Draw::depth) * (1 - least));
  }
  [[nodiscard]] PHYSIM_INLINE R ball_part() const {
    if (o_.inner == 1) return R(1);
    const double least = o_.inner * o_.inner * o_.inner;
    return pow(least + chance_(Draw::depth) * (1 - least), R(1.0 / 3));
  }
  [[nodiscard]] PHYSIM_INLINE WayOut<R> cone() const {
    const Vec3<R> away = about_axis();
    const R s = disc_part(), lean = s * o_.slope;
    const R forwards = 1 / sqrt(1 + lean * lean);
    return {away * (o_.from.radius * s), Vec3<R>{forwards, R(0), R(0)} + away * (lean * forwards)};
  }
  [[nodiscard]] PHYSIM_INLINE WayOut<R> ball() const {
    const R u = chance_(Draw::along);
    const R x = o_.from.shape == EmitShape::sphere ? 1 - 2 * u : u;
    const Vec3<R> direction = Vec3<R>{x, R(0), R(0)} + about_axis() * sqrt((1 - x) * (1 + x));
    if (o_.from.radius == 0) return {{}, direction};
    return {direction * (o_.from.radius * ball_part()), direction};
  }
  [[nodiscard]] PHYSIM_INLINE WayOut<R> ring() const {
    const double radius = o_.from.radius;
    const Vec3<R> away = about_axis();
    const R rho = o_.from.tube * disc_part();
    const SinCos<R> p = sincos(2 * kPi * chance_(Draw::along));
    const R bent = radius > 0 ? rho / radius * p.cos : R(0);
    const R outwards = select(2 * chance_(Draw::side) < 1 - bent, -p.cos, p.cos);
    const Vec3<R> direction = Vec3<R>{p.sin, R(0), R(0)} + away * outwards;
    return {away * R(radius) + direction * rho, direction};
  }
  [[nodiscard]] PHYSIM_INLINE Vec3<R> in_box() const {
    const Vec3d &half = o_.half, &within = o_.within;
    // Even in -1..1; and how deep in the shell, 0..1, on which side.
    const Vec3<R> even{2 * chance_(Draw::along) - 1, 2 * chance_(Draw::arc) - 1, 2 * chance_(Draw::depth) - 1};
    // A line or a point is all surface.
    if (o_.from.thickness == 1 || o_.slab[2] == 0) return {half.x * even.x, half.y * even.y, half.z * even.z};
    const auto shell = [this](const R& side, double size) PHYSIM_INLINE_LAMBDA {
      return select(side < R(0), -size - side * o_.shell, size - side * o_.shell);
    };
    const R slab = chance_(Draw::side) * o_.slab[2];
    const MaskOf<R> in_x = slab < R(o_.slab[0]), in_xy = slab < R(o_.slab[1]);
    return {select(in_x, shell(even.x, half.x), even.x * within.x),
            select(in_x, even.y * half.y, select(in_xy, shell(even.y, half.y), even.y * within.y)),
            select(in_xy, even.z * half.z, shell(even.z, half.z))};
  }

  const ShapeNumbers& o_;
  const R time_, of_moment_, moment_;
  Chance& chance_;
};

PHYSIM_ISA_END

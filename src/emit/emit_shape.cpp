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
namespace {

double behind_point(double x) { return x - std::floor(x); }

}  // namespace

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

Outlet ShapeOutlets::at(const Birth& birth, ParticleChance& chance) const {
  Outlet out = of_shape(birth, chance);
  if (from_.randomise == 0) return out;
  const double whole = acos(1 - 2 * chance(Draw::off));
  out.direction = turned_off(out.direction, from_.randomise * whole, 2 * kPi * chance(Draw::about));
  return out;
}

Outlet ShapeOutlets::of_shape(const Birth& birth, ParticleChance& chance) const {
  switch (from_.shape) {
    case EmitShape::point: return {};
    case EmitShape::cone: return cone(birth, chance);
    case EmitShape::sphere:
    case EmitShape::hemisphere: return ball(birth, chance);
    case EmitShape::box: return {in_box(chance), {1, 0, 0}};
    case EmitShape::circle: {
      const Vec3d away = about_axis(birth, chance);
      return {away * (from_.radius * disc_part(chance)), away};
    }
    case EmitShape::ring: return ring(birth, chance);
    case EmitShape::line: return {{0, 0, from_.length * (along_arc(birth, chance) - 0.5)}, {1, 0, 0}};
    case EmitShape::mesh:
    case EmitShape::mesh_edges:
    case EmitShape::mesh_vertices:
    case EmitShape::terrain: return surface_->at(chance);
  }
  PHYSIM_UNREACHABLE();
}

double ShapeOutlets::along_arc(const Birth& birth, ParticleChance& chance) const {
  switch (from_.arc_mode) {
    case ArcMode::random: return chance(Draw::arc);
    case ArcMode::loop: return behind_point(birth.time * from_.arc_speed);
    case ArcMode::ping_pong: {
      const double there_and_back = 2 * behind_point(0.5 * birth.time * from_.arc_speed);
      return there_and_back <= 1 ? there_and_back : 2 - there_and_back;
    }
    case ArcMode::spread:
      PHYSIM_ASSERT(birth.of_moment < birth.moment);
      return (birth.of_moment + first_) / birth.moment;
  }
  PHYSIM_UNREACHABLE();
}

Vec3d ShapeOutlets::about_axis(const Birth& birth, ParticleChance& chance) const {
  const SinCos<double> turn = sincos(from_.arc * along_arc(birth, chance));
  return {0, turn.cos, turn.sin};
}

double ShapeOutlets::disc_part(ParticleChance& chance) const {
  if (inner_ == 1) return 1;
  const double least = inner_ * inner_;
  return std::sqrt(least + chance(Draw::depth) * (1 - least));
}

double ShapeOutlets::ball_part(ParticleChance& chance) const {
  if (inner_ == 1) return 1;
  const double least = inner_ * inner_ * inner_;
  return pow(least + chance(Draw::depth) * (1 - least), 1.0 / 3);
}

Outlet ShapeOutlets::cone(const Birth& birth, ParticleChance& chance) const {
  const Vec3d away = about_axis(birth, chance);
  const double s = disc_part(chance), lean = s * slope_;
  const double forwards = 1 / std::sqrt(1 + lean * lean);
  return {away * (from_.radius * s), Vec3d{forwards, 0, 0} + away * (lean * forwards)};
}

Outlet ShapeOutlets::ball(const Birth& birth, ParticleChance& chance) const {
  const double u = chance(Draw::along);
  const double x = from_.shape == EmitShape::sphere ? 1 - 2 * u : u;
  const Vec3d direction = Vec3d{x, 0, 0} + about_axis(birth, chance) * std::sqrt((1 - x) * (1 + x));
  return {from_.radius == 0 ? Vec3d{} : direction * (from_.radius * ball_part(chance)), direction};
}

Outlet ShapeOutlets::ring(const Birth& birth, ParticleChance& chance) const {
  const Vec3d away = about_axis(birth, chance);
  const double rho = from_.tube * disc_part(chance);
  const SinCos<double> p = sincos(2 * kPi * chance(Draw::along));
  const double bent = from_.radius > 0 ? rho / from_.radius * p.cos : 0;
  const double outwards = 2 * chance(Draw::side) < 1 - bent ? -p.cos : p.cos;
  const Vec3d direction = Vec3d{p.sin, 0, 0} + away * outwards;
  return {away * from_.radius + direction * rho, direction};
}

Vec3d ShapeOutlets::in_box(ParticleChance& chance) const {
  // Even in -1..1; and how deep in the shell, 0..1, on which side.
  const Vec3d even{2 * chance(Draw::along) - 1, 2 * chance(Draw::arc) - 1, 2 * chance(Draw::depth) - 1};
  // A line or a point is all surface.
  if (from_.thickness == 1 || slab_[2] == 0) return component_product(half_, even);
  const auto shell = [this](double side, double half) {
    return side < 0 ? -half - side * shell_ : half - side * shell_;
  };
  const double slab = chance(Draw::side) * slab_[2];
  if (slab < slab_[0]) return {shell(even.x, half_.x), even.y * half_.y, even.z * half_.z};
  if (slab < slab_[1]) return {even.x * within_.x, shell(even.y, half_.y), even.z * half_.z};
  return {even.x * within_.x, even.y * within_.y, shell(even.z, half_.z)};
}

}  // namespace physim

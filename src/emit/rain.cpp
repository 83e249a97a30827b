// Equations, symbols and Source: emit/rain.hpp.
#include "emit/rain.hpp"

#include <algorithm>
#include <cmath>

#include "base/emit_shape_table.hpp"
#include "math/quat.hpp"
#include "math/vec3.hpp"

namespace physim {
namespace {

constexpr double kRainSlack = 1e-9;  // beside the box, of places that are rounded [m]

bool is_along_axis(const EmitFrom& from) { return row_of(from.shape).is_straight && from.randomise == 0; }
/// Rotations, but for rounding: the same at any frame rate.
bool are_alike(const Quatd& a, const Quatd& b) {
  return std::abs(a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z) > 1 - 1e-12;
}
double area_of_face(const Vec3d& half, std::size_t axis) { return 4 * half[(axis + 1) % 3] * half[(axis + 2) % 3]; }

}  // namespace

Rain::Rain(const EmitterDef& def, std::uint64_t seed)
    : rain_(def.rain),
      seed_(seed),
      half_(def.rain.size * 0.5),
      speed_(range_of(def.start.speed)),
      is_straight_(is_along_axis(def.from)) {}

Rain::Inflow Rain::inflow(const Vec3d& velocity, const Quatd& from, const Quatd& to) const {
  PHYSIM_ASSERT(falls());
  Inflow in{.velocity = velocity};
  const Vec3d axis = rotate(from, Vec3d{1, 0, 0});
  const bool is_known = is_straight_ && are_alike(from, to);
  const double fastest = std::max(std::abs(speed_.least), std::abs(speed_.most));
  for (std::size_t k = 0; k < 3; ++k) {
    const double one = is_known ? speed_.least * axis[k] : -fastest, other = is_known ? speed_.most * axis[k] : fastest;
    // A particle's velocity is rounded from the same products, so that the bound is one.
    const double least = std::min(one, other) + rain_.drift[k], most = std::max(one, other) + rain_.drift[k];
    in.bound[2 * k] = std::max(0.0, velocity[k] - least);
    in.bound[2 * k + 1] = std::max(0.0, most - velocity[k]);
    in.rate += rain_.density * area_of_face(half_, k) * (in.bound[2 * k] + in.bound[2 * k + 1]);
  }
  return in;
}

std::uint32_t Rain::filling() const { return whole_count(rain_.density * rain_.size.x * rain_.size.y * rain_.size.z); }

std::optional<Vec3d> Rain::entry(const Inflow& inflow, std::uint64_t number, const Vec3d& velocity) const {
  const PhiloxCounter words = emit_words(seed_, EmitStream::rain, 0, number, 0);
  double left = open_unit(words[0]) * inflow.rate / rain_.density;
  std::size_t face = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    if (inflow.bound[i] == 0) continue;
    face = i;
    left -= area_of_face(half_, i / 2) * inflow.bound[i];
    if (left < 0) break;
  }
  PHYSIM_ASSERT(inflow.bound[face] > 0);
  const std::size_t k = face / 2;
  const double side = face % 2 == 0 ? 1 : -1, comes = side * (inflow.velocity[k] - velocity[k]);
  if (!(open_unit(words[3]) * inflow.bound[face] < comes)) return std::nullopt;
  Vec3d place;
  place[k] = side * half_[k];
  for (std::size_t i = 1; i < 3; ++i) place[(k + i) % 3] = half_[(k + i) % 3] * (2 * open_unit(words[i]) - 1);
  return place;
}

std::optional<Vec3d> Rain::filled(std::uint64_t number, const std::optional<Vec3d>& before) const {
  const PhiloxCounter words = emit_words(seed_, EmitStream::rain, 1, number, 0);
  Vec3d place;
  for (std::size_t k = 0; k < 3; ++k) place[k] = half_[k] * (2 * open_unit(words[k]) - 1);
  if (before && holds(place - *before)) return std::nullopt;
  return place;
}

bool Rain::holds(const Vec3d& place) const {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(std::abs(place[k]) <= half_[k] + kRainSlack)) return false;
  return true;
}

}  // namespace physim

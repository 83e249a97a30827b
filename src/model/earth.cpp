// Prepares the Earth of an environment for computing. Equations and Source: model/earth.hpp, model/geodesy.hpp,
// model/gravity.hpp.
//
// Over a flat Earth `j2` and `wgs84` are one number of their own, the weight at the origin's latitude: g at sea level,
// and R such that g (R / (R + h))^2 also meets the weight at 10 km; at 100 km it is then off by 1e-5 of g.
#include "model/earth.hpp"

#include "base/assert.hpp"
#include "math/elementary.hpp"
#include "math/vec3.hpp"
#include "model/normal_gravity.hpp"

namespace physim {
namespace {

Vec3d axis_in_W(const Earth& earth) {
  const double level = cos(earth.latitude);
  return {level * cos(earth.azimuth), sin(earth.latitude), -level * sin(earth.azimuth)};
}

Vec3d rotation_in_W(const Earth& earth) {
  const double level = earth.rotation_rate * cos(earth.latitude);
  return {level * cos(earth.azimuth), earth.rotation_rate * sin(earth.latitude), -level * sin(earth.azimuth)};
}

/// N of a latitude with sine s.
double prime_vertical(double s) { return wgs84::kEquatorialRadius / sqrt(1 - wgs84::kEccentricitySquared * s * s); }

/// The origin of W, with y as its vertical, from the Earth's centre.
Vec3d origin_from_centre(const Vec3d& axis, double height) {
  const double n = prime_vertical(axis.y);
  return Vec3d{0, n + height, 0} - axis * (wgs84::kEccentricitySquared * n * axis.y);
}

void prepare_ellipsoid(const Environment& environment, bool own, Globe<double>& g) {
  const Gravity& given = environment.gravity;
  g.gm = own ? given.acceleration * given.radius * given.radius : wgs84::kGM;
  g.axis = axis_in_W(environment.earth);
  g.origin = origin_from_centre(g.axis, environment.altitude);
  g.to_axis = prime_vertical(g.axis.y) + environment.altitude;
  PHYSIM_ASSERT(!(abs(length_squared(g.axis) - 1) > 1e-9));
  g.axis_offset = axis_offset(dot(g.origin, g.origin), dot(g.origin, g.axis), kFlightRounds);
  g.squeezed_up = squeezed(g.axis, Vec3d{0, 1, 0});
  g.per_squeezed_up = 1 / length(g.squeezed_up);
}

/// Weight at a height over the origin's latitude: gravitation and centrifugal acceleration, along the vertical.
double weight(const Environment& environment, GravityModel model, double height) {
  PHYSIM_ASSERT(row(model).field == GravityField::flattened);
  const Vec3d axis = axis_in_W(environment.earth);
  const Vec3d r = origin_from_centre(axis, height);
  const Vec3d pull = flattened_gravitation(model, axis, r);
  const Vec3d omega = rotation_in_W(environment.earth);
  return -(pull + cross(omega, cross(r, omega))).y;
}

}  // namespace

bool has_own_gravity(const Environment& environment) {
  const Gravity standard;
  const Gravity& given = environment.gravity;
  return given.acceleration != standard.acceleration || given.radius != standard.radius;
}

void prepare_earth(const Environment& environment, const Fidelity& granted, Conditions<double>& c) {
  const EarthModel earth = granted.earth;
  const bool own = has_own_gravity(environment);
  c.gravity = environment.gravity.acceleration;
  c.radius = environment.gravity.radius;
  c.altitude = environment.altitude;
  Globe<double>& g = c.globe;
  if (is_turning(earth)) c.omega = rotation_in_W(environment.earth);
  if (earth == EarthModel::ellipsoid) prepare_ellipsoid(environment, own, g);
  if (earth == EarthModel::sphere_rotating && !own) {
    c.radius = wgs84::kMeanRadius;
    if (falls(granted.gravity)) c.gravity = wgs84::kGM / (c.radius * c.radius);
  }
  // Worlds prepare cohorts when their environment has just got its own gravity, before their projectiles leave them.
  if (!is_round(earth) && row(granted.gravity).field == GravityField::flattened && !own) {
    constexpr double kHigh = 10000;
    c.gravity = weight(environment, granted.gravity, 0);
    c.radius = kHigh / (sqrt(c.gravity / weight(environment, granted.gravity, kHigh)) - 1);
  }
}

Globe<float> to_float(const Globe<double>& g) {
  Globe<float> f{};
  cast_members(g, f);
  // As floats give it, so that the origin itself has height 0.
  const float z = f.origin.x * f.axis.x + f.origin.y * f.axis.y + f.origin.z * f.axis.z;
  f.axis_offset = axis_offset(dot(f.origin, f.origin), z, kFlightRounds);
  return f;
}

}  // namespace physim

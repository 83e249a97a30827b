// Coordinates of places for users. Equations, symbols and Source: model/geodesy.hpp, model/normal_gravity.hpp.
#include "model/geodesy.hpp"

#include "base/ieee_mode.hpp"
#include "math/elementary.hpp"
#include "math/vec3.hpp"
#include "model/normal_gravity.hpp"

namespace physim {
namespace {

using namespace wgs84;

/// The local axes at a latitude and longitude, in E.
LocalAxes local_axes(const Geodetic& place) {
  const auto phi = sincos(place.latitude);
  const auto lambda = sincos(place.longitude);
  return {{-lambda.sin, lambda.cos, 0},
          {-phi.sin * lambda.cos, -phi.sin * lambda.sin, phi.cos},
          {phi.cos * lambda.cos, phi.cos * lambda.sin, phi.sin}};
}

/// (cosine, sine) of an angle turn (x, y) by it.
Vec3d turned_about_z(const Vec3d& v, double cosine, double sine) {
  return {v.x * cosine - v.y * sine, v.x * sine + v.y * cosine, v.z};
}

}  // namespace

Vec3d earth_fixed_from_geodetic(const Geodetic& place) {
  const IeeeMode mode;
  const auto phi = sincos(place.latitude);
  const auto lambda = sincos(place.longitude);
  const double n = kEquatorialRadius / sqrt(1 - kEccentricitySquared * phi.sin * phi.sin);
  const double p = (n + place.height) * phi.cos;
  return {p * lambda.cos, p * lambda.sin, (n * (1 - kEccentricitySquared) + place.height) * phi.sin};
}

Geodetic geodetic_from_earth_fixed(const Vec3d& x) {
  const IeeeMode mode;
  const double p = sqrt(x.x * x.x + x.y * x.y);
  const double up = x.z + axis_offset(dot(x, x), x.z, kAllRounds);  // p : up is the direction of the normal
  const double size = sqrt(p * p + up * up);
  const double cosine = p / size, sine = up / size;
  // From the foot of the normal: its digits cancel exactly.
  const double n = kEquatorialRadius / sqrt(1 - kEccentricitySquared * sine * sine);
  const double height = (p - n * cosine) * cosine + (x.z - n * (1 - kEccentricitySquared) * sine) * sine;
  return {atan2(up, p), p == 0 ? 0 : atan2(x.y, x.x), height};
}

Vec3d inertial_from_earth_fixed(const Vec3d& v, double angle) {
  const IeeeMode mode;
  const auto turn = sincos(angle);
  return turned_about_z(v, turn.cos, turn.sin);
}

Vec3d earth_fixed_from_inertial(const Vec3d& v, double angle) {
  const IeeeMode mode;
  const auto turn = sincos(angle);
  return turned_about_z(v, turn.cos, -turn.sin);
}

Vec3d local_from_earth_fixed(const Vec3d& v, const Geodetic& place) {
  const IeeeMode mode;
  const LocalAxes l = local_axes(place);
  return {dot(v, l.east), dot(v, l.north), dot(v, l.up)};
}

Vec3d earth_fixed_from_local(const Vec3d& v, const Geodetic& place) {
  const IeeeMode mode;
  const LocalAxes l = local_axes(place);
  return l.east * v.x + l.north * v.y + l.up * v.z;
}

Vec3d normal_gravity(const Geodetic& place) {
  const IeeeMode mode;
  const Vec3d r = earth_fixed_from_geodetic(place);
  const Vec3d pull = ellipsoid_gravitation(Vec3d{0, 0, 1}, r);
  const Vec3d swing = Vec3d{r.x, r.y, 0} * (kRotationRate * kRotationRate);
  return local_from_earth_fixed(pull + swing, place);
}

}  // namespace physim

// The frames of an environment.
//
// What it models: the tangent frame W at a place of the Earth, and its rotation with it.
// Symbols: phi, lambda, A latitude, longitude and azimuth of W [rad]; r0 origin of W from the Earth's centre; M matrix
//   with the axes of W in E as its columns; theta = Omega t angle that the Earth has turned by [rad].
// Equations: x_E = M (r0 + x_W); x_I = Rz(theta) x_E, v_I = Rz(theta) (v_E + Omega x x_E).
//   Distance along the ground, Lambert's: tan b = (1 - f) tan phi; s the angle between the feet on the sphere of
//   reduced latitudes b; P = (b1 + b2) / 2, Q = (b2 - b1) / 2; X = (s - sin s) sin^2 P cos^2 Q / cos^2(s/2);
//   Y = (s + sin s) cos^2 P sin^2 Q / sin^2(s/2); distance a (s - f (X + Y) / 2).
// Source: D. A. Vallado, Fundamentals of Astrodynamics and Applications (2007), sec. 3.4 and 3.7, without precession,
//   nutation and polar motion; W. D. Lambert, "The distance between two widely separated points on the surface of the
//   Earth", J. Washington Academy of Sciences 32 (1942), 125-130; geometry.
#include "physim/environment.hpp"

#include "base/ieee_mode.hpp"
#include "math/elementary.hpp"
#include "math/quat.hpp"
#include "math/vec3.hpp"
#include "model/earth.hpp"

namespace physim {
namespace {

std::shared_ptr<const Conditions<double>> conditions_of(const Environment& environment, EarthModel earth) {
  const IeeeMode mode;
  auto c = std::make_shared<Conditions<double>>();
  c->fidelity.earth = is_round(earth) ? earth : EarthModel::ellipsoid;
  c->fidelity.gravity = GravityModel::constant;
  prepare_earth(environment, c->fidelity, *c);
  Globe<double>& g = c->globe;
  if (c->fidelity.earth == EarthModel::ellipsoid)  // for users the normal to its last digit, as in vertical_of()
    g.axis_offset = axis_offset(dot(g.origin, g.origin), dot(g.origin, g.axis), kAllRounds);
  return c;
}

Vec3d combined(const Vec3d& x, const Vec3d& y, const Vec3d& z, const Vec3d& v) { return x * v.x + y * v.y + z * v.z; }

/// East, north and up in E at a place with a vertical in E; on the Earth's axis as on the meridian of longitude 0.
LocalAxes local_axes(const Vec3d& up) {
  const double level = sqrt(up.x * up.x + up.y * up.y);
  const Vec3d east = level == 0 ? Vec3d{0, 1, 0} : Vec3d{-up.y / level, up.x / level, 0};
  return {east, cross(up, east), up};
}

/// The vertical at a place in W, and the height above the origin.
Vertical<double> vertical_of(const Conditions<double>& c, const Vec3d& x) {
  if (is_sphere(c.fidelity.earth)) return {vertical_at(c, x), height(c, x)};
  Vertical<double> vertical;
  ellipsoid_vertical(c.globe, c.altitude, x, vertical, kAllRounds);
  return vertical;
}
Vec3d vertical_of(const Geodetic& place) { return earth_fixed_from_local({0, 0, 1}, place); }

}  // namespace

EarthFrames::EarthFrames(const Environment& environment, EarthModel asked) {
  const IeeeMode mode;
  const bool is_named = static_cast<unsigned>(asked) <= static_cast<unsigned>(EarthModel::ellipsoid);
  const EarthModel earth = is_named ? asked : EarthModel::flat;
  conditions_ = conditions_of(environment, earth);
  rate_ = is_turning(earth) ? environment.earth.rotation_rate : 0;
  const Geodetic place{environment.earth.latitude, environment.earth.longitude, 0};
  const auto azimuth = sincos(environment.earth.azimuth);
  x_E_ = earth_fixed_from_local({azimuth.sin, azimuth.cos, 0}, place);
  y_E_ = vertical_of(place);
  z_E_ = earth_fixed_from_local({azimuth.cos, -azimuth.sin, 0}, place);
}

Geodetic EarthFrames::geodetic(const Vec3d& position) const {
  const IeeeMode mode;
  const Vertical<double> vertical = vertical_of(*conditions_, position);
  const Vec3d up = combined(x_E_, y_E_, z_E_, vertical.up);
  const double level = sqrt(up.x * up.x + up.y * up.y);
  return {atan2(up.z, level), level == 0 ? 0 : atan2(up.y, up.x), vertical.height + conditions_->altitude};
}

FrameState EarthFrames::earth_fixed(const Vec3d& position, const Vec3d& velocity) const {
  const IeeeMode mode;
  return {combined(x_E_, y_E_, z_E_, from_centre(*conditions_, position)), combined(x_E_, y_E_, z_E_, velocity)};
}

FrameState EarthFrames::inertial(const Vec3d& position, const Vec3d& velocity, double time) const {
  const IeeeMode mode;
  const FrameState s = earth_fixed(position, velocity);
  const double angle = rate_ * time;
  return {inertial_from_earth_fixed(s.position, angle),
          inertial_from_earth_fixed(s.velocity + cross(Vec3d{0, 0, rate_}, s.position), angle)};
}

Vec3d EarthFrames::local(const Vec3d& position, const Vec3d& vector) const {
  const IeeeMode mode;
  const LocalAxes l = local_axes(combined(x_E_, y_E_, z_E_, vertical_of(*conditions_, position).up));
  const Vec3d v = combined(x_E_, y_E_, z_E_, vector);
  return {dot(v, l.east), dot(v, l.north), dot(v, l.up)};
}

Vec3d EarthFrames::position(const Geodetic& place) const {
  const IeeeMode mode;
  const bool sphere = is_sphere(conditions_->fidelity.earth);
  const Vec3d x = sphere ? vertical_of(place) * (conditions_->radius + place.height) : earth_fixed_from_geodetic(place);
  return from_earth_fixed({x, {}}).position;
}

FrameState EarthFrames::from_earth_fixed(const FrameState& s) const {
  const IeeeMode mode;
  const auto into_W = [&](const Vec3d& v) { return Vec3d{dot(v, x_E_), dot(v, y_E_), dot(v, z_E_)}; };
  return {into_W(s.position) - from_centre(*conditions_, Vec3d{}), into_W(s.velocity)};
}

FrameState EarthFrames::from_inertial(const FrameState& s, double time) const {
  const IeeeMode mode;
  const double angle = rate_ * time;
  const Vec3d position = earth_fixed_from_inertial(s.position, angle);
  const Vec3d velocity = earth_fixed_from_inertial(s.velocity, angle);
  return from_earth_fixed({position, velocity - cross(Vec3d{0, 0, rate_}, position)});
}

YawPitchRoll EarthFrames::yaw_pitch_roll(const Vec3d& position, const Quatd& q_WB) const {
  const IeeeMode mode;
  const auto axis = [&](const Vec3d& v) { return local(position, rotate(q_WB, v)); };
  const Vec3d nose = axis({1, 0, 0}), up = axis({0, 1, 0}), right = axis({0, 0, 1});
  const double level = sqrt(nose.x * nose.x + nose.y * nose.y);
  return {level == 0 ? 0 : atan2(nose.x, nose.y), atan2(nose.z, level), atan2(-right.z, up.z)};
}

Vec3d EarthFrames::from_local(const Vec3d& position, const Vec3d& vector) const {
  const IeeeMode mode;
  const LocalAxes l = local_axes(combined(x_E_, y_E_, z_E_, vertical_of(*conditions_, position).up));
  return from_earth_fixed({{}, l.east * vector.x + l.north * vector.y + l.up * vector.z}).velocity;
}

namespace {

/// The angle seen from the centre between two places on a sphere [rad].
double central_angle(double latitude1, double latitude2, double longitudes) {
  const double north = sincos((latitude2 - latitude1) / 2).sin, east = sincos(longitudes / 2).sin;
  const double h = north * north + sincos(latitude1).cos * sincos(latitude2).cos * east * east;
  return 2 * asin(sqrt(min(h, 1.0)));
}

double square(double x) { return x * x; }

}  // namespace

double EarthFrames::ground_distance(const Vec3d& from, const Vec3d& to) const {
  const IeeeMode mode;
  const Geodetic a = geodetic(from), b = geodetic(to);
  const double longitudes = b.longitude - a.longitude;
  if (is_sphere(conditions_->fidelity.earth))
    return conditions_->radius * central_angle(a.latitude, b.latitude, longitudes);
  const auto reduced = [](double latitude) {
    const auto at = sincos(latitude);
    return atan2((1 - wgs84::kFlattening) * at.sin, at.cos);
  };
  const double b1 = reduced(a.latitude), b2 = reduced(b.latitude);
  const double s = central_angle(b1, b2, longitudes);
  if (s == 0) return 0;
  const auto p = sincos((b1 + b2) / 2), q = sincos((b2 - b1) / 2), half = sincos(s / 2);
  const double sine = sincos(s).sin;
  const double x = (s - sine) * square(p.sin * q.cos / half.cos);
  const double y = (s + sine) * square(p.cos * q.sin / half.sin);
  return wgs84::kEquatorialRadius * (s - wgs84::kFlattening / 2 * (x + y));
}

}  // namespace physim

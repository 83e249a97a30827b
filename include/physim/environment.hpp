// Environment: gravity, the Earth, air and wind, and where a place is on the Earth.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "physim/fidelity.hpp"
#include "physim/math.hpp"
#include "physim/result.hpp"

namespace physim {

// ---------------------------------------------------------------------------------------------------------------------
// Fields: functions of one's own over place and time, of an environment: its wind, and a force.

/// Input and output of a wind function: arrays with one element per place.
struct WindBatch {
  std::span<const double> time{};     ///< since launch; in worlds, of the world [s]
  std::span<const Vec3d> position{};  ///< in W [m]
  std::span<Vec3d> velocity{};        ///< of the air in W, zero as it comes: to be filled [m/s]
};

/// Input and output of a force function: arrays with one element per projectile.
struct FieldForceBatch {
  std::span<const double> time{};     ///< since launch; in worlds, of the world [s]
  std::span<const Vec3d> position{};  ///< in W [m]
  std::span<const Vec3d> velocity{};  ///< in W [m/s]
  std::span<const double> mass{};     ///< that is left [kg]
  std::span<Vec3d> force{};           ///< in W, zero as it comes: to be filled [N]
};

/// A function of one's own, from any callable that takes a `const Batch&`. Copies share it, and only they are equal.
///
/// Each answer must depend on its own place alone, with the same bits for the same numbers, and use no world. The
/// function is called from any number of threads at once, any number of times, also for rejected steps and for empty
/// lanes (with finite numbers). If it throws, it is called again for each place alone. A place that throws again, or an
/// answer that is not finite, ends the flight: as non_finite, or as stalled if adaptive steps come to a halt before it;
/// in a world its projectile is retired. No file holds the function: a caller that loads a world sets it again.
template <class Batch>
class FieldFunction {
 public:
  using Function = std::function<void(const Batch&)>;

  FieldFunction() = default;
  template <class F>
  requires std::is_invocable_v<F&, const Batch&> FieldFunction(F function) {  // NOLINT: it is one
    Function made(std::move(function));
    if (made) function_ = std::make_shared<const Function>(std::move(made));
  }

  [[nodiscard]] const Function* get() const { return function_.get(); }
  explicit operator bool() const { return function_ != nullptr; }
  bool operator==(const FieldFunction&) const = default;

 private:
  std::shared_ptr<const Function> function_;
};

using WindFunction = FieldFunction<WindBatch>;
using ForceFunction = FieldFunction<FieldForceBatch>;

// ---------------------------------------------------------------------------------------------------------------------
// Places on and above the Earth: the ellipsoid WGS-84, its coordinates and its gravity.
//
// Frames: E is Earth-fixed and right-handed, with its origin at the Earth's centre, x towards latitude 0 and longitude
// 0, z towards the north pole. I is inertial and coincides with E at time 0. L is local: x east, y north, z up along
// the normal of the ellipsoid. How the world frame W of a flight lies in them says physim/environment.hpp.

/// World Geodetic System 1984 (NIMA TR8350.2, third edition, tables 3.1 to 3.4).
namespace wgs84 {
inline constexpr double kEquatorialRadius = 6378137.0;                             ///< a [m]
inline constexpr double kFlattening = 1 / 298.257223563;                           ///< f [-]
inline constexpr double kPolarRadius = kEquatorialRadius * (1 - kFlattening);      ///< b = a (1 - f) [m]
inline constexpr double kEccentricitySquared = kFlattening * (2 - kFlattening);    ///< e^2 [-]
inline constexpr double kMeanRadius = (2 * kEquatorialRadius + kPolarRadius) / 3;  ///< R1 = (2a + b) / 3 [m]
inline constexpr double kGM = 3.986004418e14;                                      ///< with the air's mass [m^3/s^2]
inline constexpr double kRotationRate = 7.292115e-5;                               ///< [rad/s]
inline constexpr double kJ2 = 1.08262982e-3;  ///< dynamical form factor that belongs to a, f, GM and the rate [-]
}  // namespace wgs84

/// A place by its coordinates on the ellipsoid. Over a spherical Earth: on the sphere.
struct Geodetic {
  double latitude = 0;   ///< of the vertical, north positive [rad]
  double longitude = 0;  ///< east positive, -pi to pi [rad]
  double height = 0;     ///< above the ellipsoid, along its normal [m]

  bool operator==(const Geodetic&) const = default;
};

/// The place in E [m].
[[nodiscard]] Vec3d earth_fixed_from_geodetic(const Geodetic& place);
/// The coordinates of a place in E [m], to rounding, from 5 km below the ellipsoid to 1e9 m above it; poles and equator
/// are places like others. On the Earth's axis the longitude is 0.
[[nodiscard]] Geodetic geodetic_from_earth_fixed(const Vec3d& position_E);

/// A vector in I from its components in E, after the Earth has turned by an angle [rad]; and back.
[[nodiscard]] Vec3d inertial_from_earth_fixed(const Vec3d& v_E, double angle);
[[nodiscard]] Vec3d earth_fixed_from_inertial(const Vec3d& v_I, double angle);

/// A vector in L (east, north, up) at a place, from its components in E; and back.
[[nodiscard]] Vec3d local_from_earth_fixed(const Vec3d& v_E, const Geodetic& place);
[[nodiscard]] Vec3d earth_fixed_from_local(const Vec3d& v_L, const Geodetic& place);

/// Normal gravity of WGS-84 in L at a place [m/s^2]: gravitation and the centrifugal acceleration of the turning Earth,
/// in closed form at every height.
[[nodiscard]] Vec3d normal_gravity(const Geodetic& place);

// ---------------------------------------------------------------------------------------------------------------------
// Environment: where a projectile flies. It says what is there; Fidelity says how much of it is modelled,
// and the lower of the two is granted: an environment with constant gravity has no inverse-square law to offer.

/// The gravity field. acceleration and radius are those of `constant` and `inverse_square`; another planet has its own,
/// and no more than `inverse_square`. The defaults are those of the US Standard Atmosphere 1976; its g contains the
/// centrifugal acceleration. If a rotating Earth adds that acceleration separately, the defaults stand for the Earth's
/// own
/// GM = 3.986004418e14 m^3/s^2 and, under a sphere, its mean radius, 6371008.77 m.
struct Gravity {
  GravityModel model = GravityModel::wgs84;  ///< the field there is [-]
  double acceleration = 9.80665;             ///< at mean sea level, downwards [m/s^2]
  double radius = 6356766;                   ///< distance of sea level from the Earth's centre [m]

  bool operator==(const Gravity&) const = default;
};

/// A level of a sounding.
struct AirPoint {
  double altitude = 0;               ///< above sea level, geometric [m]
  double temperature = 288.15;       ///< of the air, 150 to 350 [K]
  std::optional<double> pressure{};  ///< none: in hydrostatic equilibrium with the level below; falls [Pa]
  std::optional<double> humidity{};  ///< relative, 0 to 1; none: dry [-]

  bool operator==(const AirPoint&) const = default;
};

/// The air. Where temperature, pressure or humidity is given, density at the station follows CIPM-2007 and the standard
/// profile is shifted to it; where none is given the air is exactly the US Standard Atmosphere 1976.
struct Atmosphere {
  AirModel model = AirModel::isa;            ///< the profile there is [-]
  std::optional<double> temperature{};       ///< at the station [K]
  std::optional<double> pressure{};          ///< at the station, not reduced to sea level [Pa]
  std::optional<double> humidity{};          ///< relative, 0 to 1, at the station [-]
  std::optional<double> station_altitude{};  ///< of the station above sea level; default: the origin's [m]
  std::optional<double> density{};      ///< at the origin, overrides all else for constant and exponential air [kg/m^3]
  std::optional<double> sound_speed{};  ///< at the origin, overrides all else for constant and exponential air [m/s]
  double scale_height = 8500;           ///< of exponential air [m]
  /// Levels at rising altitudes, in the place of temperature, pressure and humidity at a station: `isa` is the air
  /// between them, other air that at the origin. Beyond its ends temperature changes as the standard's does. Pressures
  /// begin at the first level; if none is given, with the standard's there. At most 100 000. [-]
  std::vector<AirPoint> profile{};

  bool operator==(const Atmosphere&) const = default;
};

/// The coordinate of a wind profile.
enum class WindAxis { height, range };
/// The interpolation between the points of a wind profile.
enum class WindInterpolation {
  linear,
  step,  ///< each point holds from its place on
};

struct WindPoint {
  double at = 0;     ///< height above the origin, or downrange distance x [m]
  Vec3d velocity{};  ///< of the air [m/s]

  bool operator==(const WindPoint&) const = default;
};

/// Wind is the velocity of the air in the world frame: (0, 0, -4) blows from the right.
struct Wind {
  Vec3d velocity{};                                             ///< without a profile, everywhere [m/s]
  std::vector<WindPoint> profile{};                             ///< at rising places; held outside; at most 100 000 [m]
  WindAxis by = WindAxis::height;                               ///< coordinate of the profile [-]
  WindInterpolation interpolation = WindInterpolation::linear;  ///< between points of the profile [-]
  /// By place and time, in the place of the profile: of fidelity `profile`; lower rungs know the others alone. It
  /// returns the wind in W: over a round Earth nothing turns it with the vertical. [m/s]
  WindFunction field{};

  bool operator==(const Wind&) const = default;
};

/// The origin of the world frame on the Earth, the direction of its x axis, and the Earth's rotation. A launch by
/// latitude, longitude, height, azimuth and elevation is one from the origin: latitude, longitude and azimuth are
/// these, height is Environment::altitude, elevation is Launch::elevation.
struct Earth {
  double latitude = 0;                 ///< of the vertical at the origin, north positive [rad]
  double longitude = 0;                ///< of the origin, east positive [rad]
  double azimuth = 0;                  ///< compass direction of the x axis, clockwise from north [rad]
  double rotation_rate = 7.292115e-5;  ///< [rad/s]

  bool operator==(const Earth&) const = default;
};

/// The environment of a projectile.
struct Environment {
  double altitude = 0;      ///< of the origin of the world frame above sea level, or above the ellipsoid [m]
  Gravity gravity{};        ///< [-]
  Atmosphere atmosphere{};  ///< [-]
  Wind wind{};              ///< [-]
  Earth earth{};            ///< [-]
  ForceFunction force{};    ///< on all projectiles here in motion `force`, reported as `applied` [N]

  bool operator==(const Environment&) const = default;
};

// ---------------------------------------------------------------------------------------------------------------------
// The air of an environment at one place, for tools and tests.

/// The state of the air at one height.
struct AirSample {
  double temperature = 0;  ///< [K]
  double pressure = 0;     ///< [Pa]
  double density = 0;      ///< [kg/m^3]
  double sound_speed = 0;  ///< [m/s]
  double viscosity = 0;    ///< dynamic [Pa s]
};

/// The air at a geometric altitude above sea level [m], from -5 km to 86 km.
[[nodiscard]] Result<AirSample> air_at(const Environment& environment, double altitude);

/// Density of moist air [kg/m^3] by CIPM-2007 at a temperature [K], pressure [Pa] and relative humidity 0..1 [-].
[[nodiscard]] double moist_air_density(double temperature, double pressure, double humidity);
/// Speed of sound in moist air [m/s].
[[nodiscard]] double moist_air_sound_speed(double temperature, double pressure, double humidity);

// ---------------------------------------------------------------------------------------------------------------------
// Frames of a flight on the Earth: from the world frame W to Earth-fixed, inertial, local and geodetic ones, and back.
//
// W is the tangent frame at the origin that Environment gives by Earth::latitude, Earth::longitude and altitude: x
// along the compass azimuth Earth::azimuth, y up along the vertical there, z to the right. The other frames are those
// of physim/environment.hpp: E Earth-fixed, I inertial, coinciding with E at time 0, L local (east, north, up).

template <class S>
struct Conditions;

/// A place and a velocity in some frame.
struct FrameState {
  Vec3d position{};  ///< [m]
  Vec3d velocity{};  ///< as seen in the same frame [m/s]
};

/// The attitude of a body: heading, clockwise from north, then pitch, nose up, then roll, right side down.
struct YawPitchRoll {
  double yaw = 0;    ///< -pi..pi [rad]
  double pitch = 0;  ///< -pi/2..pi/2 [rad]
  double roll = 0;   ///< -pi..pi [rad]
};

/// The frames of one environment. On a rotating Earth W and E turn with it, and velocities in them are those seen from
/// the ground; on one that does not rotate W, E and I stand still together. Over a spherical Earth latitudes and
/// heights are those of the sphere; a flat Earth counts as the plane that touches the ellipsoid at the origin.
///
///   const EarthFrames frames = flight.earth_frames();
///   const Geodetic place = frames.geodetic(flight.end().position);
class EarthFrames {
 public:
  EarthFrames(const Environment& environment, EarthModel earth);

  /// Latitude, longitude and height of a place in W [m]. Heights keep their digits near the origin.
  [[nodiscard]] Geodetic geodetic(const Vec3d& position_W) const;
  /// A state in E, from one in W.
  [[nodiscard]] FrameState earth_fixed(const Vec3d& position_W, const Vec3d& velocity_W) const;
  /// A state in I at a time since launch [s], from one in W.
  [[nodiscard]] FrameState inertial(const Vec3d& position_W, const Vec3d& velocity_W, double time) const;
  /// The components east, north and up, at a place in W [m], of a vector in W: a velocity, an acceleration.
  [[nodiscard]] Vec3d local(const Vec3d& position_W, const Vec3d& vector_W) const;

  /// The attitude of a body relative to local north, east and down at a place in W [m], from its q_WB.
  [[nodiscard]] YawPitchRoll yaw_pitch_roll(const Vec3d& position_W, const Quatd& q_WB) const;

  /// The place in W [m] of coordinates.
  [[nodiscard]] Vec3d position(const Geodetic& place) const;
  /// A state in W, from one in E.
  [[nodiscard]] FrameState from_earth_fixed(const FrameState& state_E) const;
  /// A state in W at a time since launch [s], from one in I.
  [[nodiscard]] FrameState from_inertial(const FrameState& state_I, double time) const;
  /// A vector in W from its components east, north and up at a place in W [m].
  [[nodiscard]] Vec3d from_local(const Vec3d& position_W, const Vec3d& vector_L) const;

  /// The ground distance, at height 0, between the feet of two places in W [m]: over the ellipsoid by
  /// Lambert's formula, within 1e-5 of the distance but near the antipode; over a sphere along the great circle.
  [[nodiscard]] double ground_distance(const Vec3d& from_W, const Vec3d& to_W) const;

  /// The rotation rate of E relative to I [rad/s]: 0 where the Earth does not rotate.
  [[nodiscard]] double rotation_rate() const { return rate_; }

 private:
  std::shared_ptr<const Conditions<double>> conditions_;  // shape and place, as the models see them
  double rate_ = 0;
  Vec3d x_E_, y_E_, z_E_;  // the axes of W
};

// ---------------------------------------------------------------------------------------------------------------------
// Weather: what of an environment differs from shot to shot of a batch.

/// The weather of each shot, as columns of one length, the number of shots. Those left empty are as Environment says.
/// Shot i flies as fly() flies it in at(i, common): its air is that of its station, and a zero range is found in its
/// own air (give an elevation where the zero is that of another day).
///
/// In float32 places within a step are looked for in double, with air and wind that are rounded to float here and not
/// in fly(): crossings of a Mach number, and the corners at which adaptive integrators end steps: knots of a linear
/// curve (Interpolation::linear), DragDef::bands, tables of AeroDef. Steps that end elsewhere make other errors, so
/// such flights differ from those of fly() by as much as their tolerance lets them; where the rounding changes no
/// number, as of a wind of 2.5 m/s, by nothing. All others, and all in float64, are equal bit for bit.
struct Weather {
  // Wind that is the same everywhere, in the place of all that Environment::wind has; or, with `moves_profile`, added
  // to its profile. See there for the signs.
  std::span<const double> wind_x{};  ///< empty, though another is given: that of Wind::velocity [m/s]
  std::span<const double> wind_y{};  ///< upwards [m/s]
  std::span<const double> wind_z{};  ///< [m/s]
  /// Each point of Wind::profile moves by the difference between the columns and Wind::velocity; a projectile that sees
  /// one wind everywhere has Wind::velocity moved, or the first point if that is zero. Without a profile it changes
  /// nothing [-]
  bool moves_profile = false;
  // As the members of Atmosphere of these names.
  std::span<const double> temperature{};  ///< at the station [K]
  std::span<const double> pressure{};     ///< at the station [Pa]
  std::span<const double> humidity{};     ///< at the station [-]
  std::span<const double> density{};      ///< at the origin, above 0; for constant and exponential air [kg/m^3]

  [[nodiscard]] bool has_wind() const { return !wind_x.empty() || !wind_y.empty() || !wind_z.empty(); }
  [[nodiscard]] bool has_station() const { return !temperature.empty() || !pressure.empty() || !humidity.empty(); }
  [[nodiscard]] bool has_air() const { return has_station() || !density.empty(); }
  [[nodiscard]] bool empty() const { return !has_wind() && !has_air(); }
  /// Length of the longest column; the others have none or as many.
  [[nodiscard]] std::size_t size() const {
    return std::max({wind_x.size(), wind_y.size(), wind_z.size(), temperature.size(), pressure.size(), humidity.size(),
                     density.size()});
  }
  /// The numbers of shot i < size() in the columns of the wind; those of `common` where a column is empty [m/s].
  [[nodiscard]] Vec3d wind(std::size_t i, const Wind& common) const {
    return {wind_x.empty() ? common.velocity.x : wind_x[i], wind_y.empty() ? common.velocity.y : wind_y[i],
            wind_z.empty() ? common.velocity.z : wind_z[i]};
  }
  /// The environment of shot i < size().
  [[nodiscard]] Environment at(std::size_t i, const Environment& common) const {
    Environment own = common;
    put(i, own);
    return own;
  }
  /// Writes the weather of shot i < size() over that of an environment.
  void put(std::size_t i, Environment& own) const {
    if (has_wind()) put_wind(i, own.wind);
    if (!temperature.empty()) own.atmosphere.temperature = temperature[i];
    if (!pressure.empty()) own.atmosphere.pressure = pressure[i];
    if (!humidity.empty()) own.atmosphere.humidity = humidity[i];
    if (!density.empty()) own.atmosphere.density = density[i];
  }

 private:
  void put_wind(std::size_t i, Wind& own) const {
    const Vec3d common = own.velocity;
    own.velocity = wind(i, own);
    own.field = {};
    if (!moves_profile) return own.profile.clear();
    const Vec3d moved = own.velocity - common;
    for (WindPoint& point : own.profile) point.velocity += moved;
    if (!own.profile.empty() && common == Vec3d{}) own.velocity = common;  // the first point stands for it
  }
};

}  // namespace physim

// Where a flight is on the Earth: the world frame W in the Earth-fixed, inertial, local and geodetic frames, and back.
//
// W is the tangent frame at the origin that Environment gives by Earth::latitude, Earth::longitude and altitude: x
// along the compass azimuth Earth::azimuth, y up along the vertical there, z to the right. The other frames are those
// of physim/geodesy.hpp: E Earth-fixed, I inertial, coinciding with E at time 0, L local (east, north, up).
#pragma once

#include <memory>

#include "physim/environment.hpp"
#include "physim/geodesy.hpp"
#include "physim/quat.hpp"

namespace physim {

template <class S>
struct Conditions;

/// A place and a velocity in some frame.
struct FrameState {
  Vec3d position{};  ///< [m]
  Vec3d velocity{};  ///< as seen in the same frame [m/s]
};

/// Where a body points: its heading, clockwise from north, then how high its nose is, then how far its right side is
/// down.
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

  /// How a body points against local north, east and down at a place in W [m], from its q_WB.
  [[nodiscard]] YawPitchRoll yaw_pitch_roll(const Vec3d& position_W, const Quatd& q_WB) const;

  /// The place in W [m] of coordinates.
  [[nodiscard]] Vec3d position(const Geodetic& place) const;
  /// A state in W, from one in E.
  [[nodiscard]] FrameState from_earth_fixed(const FrameState& state_E) const;
  /// A state in W at a time since launch [s], from one in I.
  [[nodiscard]] FrameState from_inertial(const FrameState& state_I, double time) const;
  /// A vector in W from its components east, north and up at a place in W [m].
  [[nodiscard]] Vec3d from_local(const Vec3d& position_W, const Vec3d& vector_L) const;

  /// How far it is along the ground, at height 0, between the feet of two places in W [m]: over the ellipsoid by
  /// Lambert's formula, within 1e-5 of the distance but near the antipode; over a sphere along the great circle.
  [[nodiscard]] double ground_distance(const Vec3d& from_W, const Vec3d& to_W) const;

  /// How fast E turns in I [rad/s]: 0 where the Earth does not rotate.
  [[nodiscard]] double rotation_rate() const { return rate_; }

 private:
  std::shared_ptr<const Conditions<double>> conditions_;  // shape and place, as the models see them
  double rate_ = 0;
  Vec3d x_E_, y_E_, z_E_;  // the axes of W
};

}  // namespace physim

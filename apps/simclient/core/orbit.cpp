#include "simclient/core/orbit.hpp"

#include <cmath>

#include "math/angles.hpp"
#include "model/earth.hpp"

namespace physim::client {
namespace {

/// The sum of the angles between samples of a path as seen from the middle of the Earth, among the stars [rad].
double angle_around(const std::vector<TrackSample>& path, const EarthFrames& frames) {
  double angle = 0;
  std::optional<Vec3d> last;
  for (const TrackSample& s : path) {
    const Vec3d now = frames.inertial(s.position, s.velocity, s.time).position;
    if (last) angle += std::atan2(length(cross(*last, now)), dot(*last, now));
    last = now;
  }
  return angle;
}

}  // namespace

std::optional<double> revolution_time(const Environment& environment, const Fidelity& fidelity, const Vec3d& position,
                                      const Vec3d& velocity) {
  if (!is_round(fidelity.earth) || !falls(fidelity.gravity)) return std::nullopt;
  const FrameState launch = EarthFrames(environment, fidelity.earth).inertial(position, velocity, 0);
  const double speed = length(launch.velocity);
  const double half_axis = 1 / (2 / length(launch.position) - speed * speed / wgs84::kGM);
  if (!(half_axis > 0)) return std::nullopt;
  return 2 * kPi * std::sqrt(half_axis * half_axis * half_axis / wgs84::kGM);
}

Apsides apsides_of(const std::vector<TrackSample>& path, const Environment& environment, const Fidelity& fidelity) {
  constexpr double kAround = 0.98 * 2 * kPi;
  Apsides found;
  if (!is_round(fidelity.earth) || path.size() < 3) return found;
  const EarthFrames frames(environment, fidelity.earth);
  std::size_t high = 0, low = 0;
  std::vector<double> altitudes;
  for (const TrackSample& s : path) altitudes.push_back(frames.geodetic(s.position).height);
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (altitudes[i] > altitudes[high]) high = i;
    if (altitudes[i] < altitudes[low]) low = i;
  }
  const bool goes_around = angle_around(path, frames) > kAround;
  if (goes_around || (high > 0 && high + 1 < path.size())) found.highest = {path[high].position, altitudes[high]};
  if (goes_around) found.lowest = {path[low].position, altitudes[low]};
  return found;
}

}  // namespace physim::client

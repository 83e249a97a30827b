// Over the round, turning Earth: an intercontinental lob from California, and where it comes down.
#include <cmath>
#include <cstdio>
#include <physim/physim.hpp>

using namespace physim;
using namespace physim::units;

int main() {
  Environment environment;  // the origin of W: latitude, longitude, height; x along the azimuth
  environment.altitude = 100;
  environment.earth = {.latitude = 34.6_deg, .longitude = -120.6_deg, .azimuth = 290_deg};
  Fidelity fidelity = Fidelity::reference();
  fidelity.earth = EarthModel::ellipsoid;
  fidelity.gravity = GravityModel::wgs84;
  fidelity.drag = DragModel::off;
  const Until until{.ground = -100.0};  // down to the ellipsoid

  const Flight flight = fly({}, {.speed = 6500, .elevation = 40_deg}, environment, fidelity, {}, until);

  const EarthFrames frames = flight.earth_frames();
  const Sample end = flight.end();
  const Geodetic place = frames.geodetic(end.position);                            // latitude, longitude, height
  const Vec3d velocity = frames.local(end.position, end.velocity);                 // east, north, up
  const FrameState fixed = frames.earth_fixed(end.position, end.velocity);         // E: turns with the Earth
  const FrameState space = frames.inertial(end.position, end.velocity, end.time);  // I: does not

  const double degree = 1_deg;
  std::printf("down at %.4f deg north, %.4f deg east, %.6f m after %.1f s\n", place.latitude / degree,
              place.longitude / degree, std::abs(place.height), end.time);
  std::printf("at %.1f m/s, %.1f of it downwards; in space at %.1f m/s\n", length(velocity), -velocity.z,
              length(space.velocity));

  // What must not change, as seen from space: the angular momentum about the axis of a field that is round about it.
  const FrameState start = frames.inertial({}, flight.at(0).velocity, 0);
  const Vec3d spin = cross(start.position, start.velocity), spin_end = cross(space.position, space.velocity);
  const double momentum_error = std::abs(spin_end.z / spin.z - 1);
  std::printf("angular momentum about the axis kept to %.0e\n", momentum_error);
  const bool same_place = length(fixed.position) - length(space.position) < 1e-8;
  return flight.outcome() == Outcome::landed && same_place && momentum_error < 1e-8 ? 0 : 1;
}

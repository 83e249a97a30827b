// Distances along the ground: exact arcs of equator and sphere, the quadrant of a meridian, a geodesic that was
// published to the millimetre.
#include "support.hpp"

namespace physim::test::model_frames_test {

double degrees(int whole, int minutes, double seconds) { return (whole + minutes / 60.0 + seconds / 3600) * kDegree; }

double along_ground(const Geodetic& from, const Geodetic& to, EarthModel earth) {
  const EarthFrames frames({.earth = {.latitude = 0.4, .longitude = 1.1}}, earth);
  return frames.ground_distance(frames.position(from), frames.position(to));
}

TEST(GroundDistance, over_the_ellipsoid) {
  const double a = wgs84::kEquatorialRadius;
  const Geodetic origin{};
  EXPECT_NEAR(along_ground(origin, {.longitude = kDegree * 90}, EarthModel::ellipsoid), a * kDegree * 90, 1e-2);
  // The quadrant of a meridian is 10 001 965.729 m long.
  EXPECT_NEAR(along_ground(origin, {.latitude = kDegree * 90}, EarthModel::ellipsoid), 10001965.729, 10);
  // Flinders Peak to Buninyong: 54 972.271 m on the ellipsoid GRS80, which is WGS-84's but for a tenth of a millimetre
  // (Intergovernmental Committee on Surveying and Mapping, Geocentric Datum of Australia Technical Manual, ch. 4).
  const Geodetic flinders{-degrees(37, 57, 3.72030), degrees(144, 25, 29.52440), 0};
  const Geodetic buninyong{-degrees(37, 39, 10.15610), degrees(143, 55, 35.38390), 0};
  const double allowed = 1e-5 * 54972.271;  // as the header promises; Lambert's formula errs by a tenth of it here
  EXPECT_NEAR(along_ground(flinders, buninyong, EarthModel::ellipsoid), 54972.271, allowed);
  EXPECT_NEAR(along_ground(buninyong, flinders, EarthModel::ellipsoid), 54972.271, allowed);
}

TEST(GroundDistance, over_a_sphere_is_an_arc) {
  const std::pair<EarthModel, double> spheres[] = {{EarthModel::sphere, Gravity{}.radius},
                                                   {EarthModel::sphere_rotating, wgs84::kMeanRadius}};
  for (const auto& [earth, radius] : spheres)
    for (const double angle : {1e-6, 0.1, 90.0, 179.0})
      EXPECT_TRUE(near(along_ground({}, {.longitude = kDegree * angle}, earth), radius * kDegree * angle, 1e-9, 1e-6))
          << angle;
}

TEST(GroundDistance, heights_do_not_count_and_short_ways_keep_their_digits) {
  const Geodetic low{0.7, 0.3, 0}, high{0.7, 0.3, 5e5}, near_by{0.7, 0.3 + 1e-7, 1000};
  const double e2 = wgs84::kFlattening * (2 - wgs84::kFlattening);
  const double across = wgs84::kEquatorialRadius / std::sqrt(1 - e2 * std::pow(std::sin(0.7), 2));  // prime vertical
  const std::pair<EarthModel, double> radii[] = {{EarthModel::ellipsoid, across},
                                                 {EarthModel::sphere, Gravity{}.radius}};
  for (const auto& [earth, radius] : radii) {
    EXPECT_NEAR(along_ground(low, high, earth), 0, 1e-6);
    EXPECT_TRUE(near(along_ground(low, near_by, earth), radius * std::cos(0.7) * 1e-7, 1e-5, 2e-8));
  }
}

}  // namespace physim::test::model_frames_test

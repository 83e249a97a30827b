// danger_space() over the ground of a scene: a parabola over a slope, a straight path over a plateau, and what is
// refused.
#include <cmath>

#include "must.hpp"
#include "physim/scene.hpp"
#include "physim/solve.hpp"

namespace physim::flight_danger_space_test {

constexpr double kG = 9.80665, kDegree = 3.14159265358979323846 / 180;

Fidelity simple(GravityModel gravity) {
  Fidelity fidelity = Fidelity::simulation();
  fidelity.integrator = Integrator::tsit5;
  fidelity.gravity = gravity;
  fidelity.earth = EarthModel::flat;
  return fidelity;
}
Environment airless() {
  return {.gravity = {.model = GravityModel::constant, .acceleration = kG}, .atmosphere = {.model = AirModel::vacuum}};
}

Scene slope(double tilt) {
  Scene scene;
  const ShapeId plane = scene.add_shape(PlaneShape{}).value();
  EXPECT_TRUE(scene.add({.shape = plane, .transform = {.rotation = quat_from_axis_angle({0, 0, 1}, tilt)}}));
  return scene;
}

/// y = x tan e - k x^2 over y = x tan a: they are h apart where x (tan e - tan a) - k x^2 = h.
TEST(DangerSpaceOverGround, OfAParabolaOverASlope) {
  for (const double tilt : {-10 * kDegree, 0.0, 10 * kDegree, 25 * kDegree}) {
    const Scene scene = slope(tilt);
    const double e = 30 * kDegree, v = 100, h = 1.7, k = kG / (2 * v * v * std::cos(e) * std::cos(e));
    Until until{.ground = {}, .time = 60, .scene = &scene};
    const Launch launch{.position = {0, 1e-3, 0}, .speed = v, .elevation = e};
    const Flight flight = fly({}, launch, airless(), simple(GravityModel::constant), {}, until);
    ASSERT_EQ(flight.outcome(), Outcome::hit);
    const double b = std::tan(e) - std::tan(tilt);
    const auto place = [&](double height) {  // on the falling branch; it starts a millimetre high
      return (b + std::sqrt(b * b - 4 * k * (height - 1e-3))) / (2 * k);
    };
    const auto space = must(danger_space(flight, 0.5 * (place(0) + place(h)), h, scene));
    EXPECT_NEAR(space.from, place(h), 1e-6) << tilt;
    EXPECT_NEAR(space.to, place(0), 1e-5) << tilt;
    // Near the muzzle it rises out of the target again.
    const auto first = must(danger_space(flight, 1, h, scene));
    EXPECT_EQ(first.from, 0);
    EXPECT_NEAR(first.to, (b - std::sqrt(b * b - 4 * k * (h - 1e-3))) / (2 * k), 1e-6);
  }
}

/// Up along a steep line of sight the path comes back: the space ends where it turns, or where it leaves the height,
/// and not because the flight does.
TEST(DangerSpace, EndsWhereThePathTurnsBack) {
  const double v = 100;
  for (const double look : {80 * kDegree, 90 * kDegree}) {
    const Launch launch{.speed = v, .elevation = look, .sight = {.look_angle = look}};
    const Flight flight = fly({}, launch, airless(), simple(GravityModel::constant), {}, {.ground = -1e-3, .time = 60});
    ASSERT_EQ(flight.outcome(), Outcome::landed);
    // Along the line the speed is v - g t sin a: it turns at s = v^2 / (2 g sin a).
    const double turn = v * v / (2 * kG * std::sin(look));
    const auto whole = must(danger_space(flight, 0.6 * turn, 1e4));
    EXPECT_NEAR(whole.from, 0, 1e-9);
    EXPECT_NEAR(whole.to, turn, 1e-6) << look;
    EXPECT_FALSE(whole.ends_with_flight);
  }
  const Flight over = fly({}, {.speed = v, .elevation = 82 * kDegree, .sight = {.look_angle = 80 * kDegree}}, airless(),
                          simple(GravityModel::constant), {}, {.ground = 0.0, .time = 60});
  const auto thin = must(danger_space(over, 100, 1));
  EXPECT_GT(thin.from, 70);
  EXPECT_LT(thin.to, 140);
  EXPECT_FALSE(thin.ends_with_flight) << "the path leaves the height";
  const Flight level = fly({}, {.position = {0, 1, 0}, .speed = v}, airless(), simple(GravityModel::constant), {},
                           {.ground = 0.0, .time = 60});
  const auto last = must(danger_space(level, 30, 10));
  EXPECT_TRUE(last.ends_with_flight);
  EXPECT_EQ(last.to, level.end().range);
}

/// 9 m of a plateau below a straight path at 10 m: what stands on it is hit from edge to edge, and nothing beside it.
TEST(DangerSpaceOverGround, EndsAtTheEdgesOfAPlateau) {
  Scene scene = slope(0);
  const ShapeId box = scene.add_shape(BoxShape{{50, 9, 50}}).value();
  ASSERT_TRUE(scene.add({.shape = box, .transform = {.position = {550, 0, 0}}, .layers = 2}));
  const Flight flight = fly({}, {.position = {0, 10, 0}, .speed = 200}, airless(), simple(GravityModel::off), {},
                            {.ground = {}, .time = 5});
  const auto space = must(danger_space(flight, 530, 2, scene));
  EXPECT_NEAR(space.from, 500, 1e-6);
  EXPECT_NEAR(space.to, 600, 1e-6);
  const auto beside = danger_space(flight, 400, 2, scene);
  ASSERT_FALSE(beside);
  EXPECT_EQ(beside.error().message, "the path passes 10 m above the ground there");
  EXPECT_FALSE(danger_space(flight, 530, 2, scene, 1)) << "the plateau is of another layer";
  const auto high = must(danger_space(flight, 400, 11, scene));
  EXPECT_EQ(high.from, 0);
  EXPECT_NEAR(high.to, 1000, 1e-9);
}

/// Over a sphere as large as the Earth, a straight path rises: it leaves the target where its altitude is the height.
TEST(DangerSpaceOverGround, LiesBelowAlongTheVerticalOfARoundEarth) {
  Fidelity fidelity = simple(GravityModel::off);
  fidelity.earth = EarthModel::sphere;
  const Flight flight =
      fly({}, {.position = {0, 10, 0}, .speed = 2000}, airless(), fidelity, {}, {.ground = {}, .time = 5});
  const EarthFrames frames = flight.earth_frames();
  const double radius = length(frames.earth_fixed({}, {}).position);
  Scene scene;
  const ShapeId ball = scene.add_shape(SphereShape{radius}).value();
  ASSERT_TRUE(scene.add({.shape = ball, .transform = {.position = {0, -radius, 0}}}));
  const auto space = must(danger_space(flight, 1000, 11, scene));
  EXPECT_EQ(space.from, 0);
  EXPECT_NEAR(space.to, std::sqrt((radius + 11) * (radius + 11) - (radius + 10) * (radius + 10)), 0.01);
  EXPECT_NEAR(frames.geodetic(flight.at_range(space.to)->position).height, 11, 1e-6);
}

TEST(DangerSpaceOverGround, RefusesWhatHasNone) {
  const Scene nothing;
  const Flight flight = fly({}, {.position = {0, 10, 0}, .speed = 200}, airless(), simple(GravityModel::off), {},
                            {.ground = {}, .time = 5});
  const auto space = danger_space(flight, 400, 2, nothing);
  ASSERT_FALSE(space);
  EXPECT_EQ(space.error().message, "the path passes over no ground there");
  EXPECT_EQ(space.error().place, "range");
  EXPECT_FALSE(danger_space(flight, 400, 0, nothing));
  EXPECT_FALSE(danger_space(flight, 1e6, 2, nothing));
}

}  // namespace physim::flight_danger_space_test

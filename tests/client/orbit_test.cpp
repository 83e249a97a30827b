// Flights about a round Earth: as far as they are foreseen, their highest and lowest places, and the ways over the
// ground.
#include "simclient/core/orbit.hpp"

#include <algorithm>
#include <cmath>

#include "client/support.hpp"
#include "simclient/core/scene.hpp"

namespace physim::client::client_orbit {
namespace {

/// Kepler's third law at 400 km, as the scenario has it.
TEST(Orbit, ARevolutionTakesAsLongAsKeplerSays) {
  Client client = client_of("low_orbit");
  const Prediction& ahead = client.prediction();
  const Environment& environment = client.session.scenario().environment;
  const auto time = must(revolution_time(environment, ahead.granted.fidelity, ahead.muzzle, ahead.velocity));
  EXPECT_NEAR(time, 5553.624, 0.01);
  EXPECT_FALSE(revolution_time(environment, ahead.granted.fidelity, ahead.muzzle, ahead.velocity * 1.6)) << "it leaves";
  EXPECT_FALSE(revolution_time({}, Fidelity(), {}, {0, 0, 100})) << "over a flat Earth";
}

TEST(Orbit, IsForeseenAsLongAsTheScenarioAsksFor) {
  for (const char* name : {"low_orbit", "105mm_m1_six_dof", "intercontinental_lob", "sounding_rocket"}) {
    Client client = client_of(name);
    const Flight whole = fly_shot(client.session.scenario(), client.launcher.shot());
    const Prediction& ahead = client.prediction();
    EXPECT_FALSE(ahead.grows) << name;
    EXPECT_NEAR(ahead.path.back().time, whole.duration(), 1e-9) << name;
    EXPECT_LT(length(ahead.path.back().position - whole.end().position), 1e-6) << name;
    EXPECT_FALSE(client.is_changing()) << name;
  }
}

/// A target is put up far beside: the shell flies in the world, and is foreseen bit by bit down to the ground.
TEST(Orbit, ALongFlightInAWorldIsForeseenToItsEnd) {
  Client client = client_of("105mm_m1_six_dof");
  const double whole = client.prediction().path.back().time;
  ASSERT_GT(whole, 60);
  ASSERT_TRUE(run(client, "target 50 2 400"));
  EXPECT_TRUE(client.prediction().grows);
  EXPECT_TRUE(client.is_changing()) << "frames go on";
  client.advance(0.001, 0.001);
  const double after_a_frame = client.prediction().path.back().time;
  EXPECT_LT(after_a_frame, 0.9 * whole) << "a frame is not held up";
  for (int i = 0; i < 10000 && client.prediction().grows; ++i) client.advance(0.001, 0.004);
  const Prediction& ahead = client.prediction();
  EXPECT_FALSE(ahead.grows || ahead.is_cut);
  EXPECT_NEAR(ahead.path.back().time, whole, 0.05);
  EXPECT_LT(ahead.path.size(), 20000U) << "thinned";
  EXPECT_FALSE(client.is_changing()) << "and is quiet again";
}

TEST(Orbit, ItsHighestAndLowestPlacesHavePins) {
  Client client = client_of("low_orbit");
  const Apsides& apsides = client.prediction().apsides;
  ASSERT_TRUE(apsides.highest && apsides.lowest);
  // Over the ellipsoid: lowest over the equator, highest where it is farthest north or south.
  EXPECT_NEAR(apsides.lowest->altitude, 400e3, 100);
  EXPECT_NEAR(apsides.highest->altitude, 413.16e3, 100);
  Scene scene;
  build_scene(client, 1, scene);
  for (const char* pin : {"Ap 413.2 km", "Pe 400.0 km"})
    EXPECT_TRUE(std::ranges::any_of(scene.labels, [&](const SceneLabel& l) { return l.text == pin; })) << pin;
  // The way over the ground lies on the ball, and goes all around it.
  ASSERT_TRUE(scene.globe);
  double farthest = 0;
  std::optional<Vec3d> first;
  for (const SceneLine& line : scene.lines) {
    const double high = length(line.a - scene.globe->centre) / scene.globe->radius;
    if (high > 1.01) continue;
    if (!first) first = line.a;
    farthest = std::max(farthest, length(line.a - *first));
  }
  EXPECT_GT(farthest, 1.9 * scene.globe->radius);
}

/// One that comes down has a highest place alone; a flat Earth knows neither.
TEST(Orbit, ALobHasNoLowestPlace) {
  Client lob = client_of("intercontinental_lob");
  EXPECT_TRUE(lob.prediction().apsides.highest);
  EXPECT_FALSE(lob.prediction().apsides.lowest);
  Client flat = client_of("golf_drive");
  EXPECT_FALSE(flat.prediction().apsides.highest || flat.prediction().apsides.lowest);
}

}  // namespace
}  // namespace physim::client::client_orbit
